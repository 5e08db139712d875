"""Image processing for active search: grid, corners, patches, elliptic search regions, predicted appearance.

Chapter active_search.

Images are grey, (h, w), of uint8 or floats in the same units; pixels are (u, v), u to the right, v down, and (0, 0) is
the centre of the upper left pixel.
"""
