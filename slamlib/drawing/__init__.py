"""Figures for chapters and experiments: light and dark, with a text for those who cannot see them, with sliders."""

from slamlib.drawing.colors import colors
from slamlib.drawing.figure import Figure, figure, figure3d
from slamlib.drawing.page import Picture, Sweep, picture, sweep
from slamlib.drawing.sketches import (
    draw_axes3d,
    draw_ellipse,
    draw_ellipsoid,
    draw_frame,
    draw_map,
    draw_robot,
    ellipse,
)
from slamlib.drawing.widget import live

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
