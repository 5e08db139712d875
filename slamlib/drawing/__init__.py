"""Figures for chapters and experiments: light and dark, with a text for those who cannot see them, with sliders."""

from slamlib.drawing.colors import colors
from slamlib.drawing.gaussians import draw_ellipse, ellipse
from slamlib.drawing.page import Picture, Sweep, picture, sweep
from slamlib.drawing.plane import draw_frame, draw_map, draw_robot, figure
from slamlib.drawing.space import draw_axes3d, figure3d

__all__ = [
    "Picture",
    "Sweep",
    "colors",
    "draw_axes3d",
    "draw_ellipse",
    "draw_frame",
    "draw_map",
    "draw_robot",
    "ellipse",
    "figure",
    "figure3d",
    "picture",
    "sweep",
]
