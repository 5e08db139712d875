"""Figures for chapters and experiments: light and dark, with a text for those who cannot see them, with sliders."""

from slambook.figures.colors import colors
from slambook.figures.figure import Figure, figure, figure3d
from slambook.figures.page import Picture, Sweep, picture, sweep
from slambook.figures.sketches import (
    draw_axes3d,
    draw_ellipse,
    draw_ellipsoid,
    draw_frame,
    draw_map,
    draw_robot,
    ellipse,
)
from slambook.figures.widget import live

__all__ = [
    "Figure",
    "Picture",
    "Sweep",
    "colors",
    "draw_axes3d",
    "draw_ellipse",
    "draw_ellipsoid",
    "draw_frame",
    "draw_map",
    "draw_robot",
    "ellipse",
    "figure",
    "figure3d",
    "live",
    "picture",
    "sweep",
]
