"""Cameras' pictures: active search, stereo pairs, and runs on sequences, with their start, loss and relocalization.

Chapter active_search: `active_search` is the front end, and `search` looks for a patch in its ellipse.

Images are grey, (h, w), of uint8 or floats in the same units; pixels are (u, v), u to the right, v down, and (0, 0) is
the centre of the upper left pixel.
"""
