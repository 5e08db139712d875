"""Experiments as plain data: presets, one run of them, many runs of them."""
