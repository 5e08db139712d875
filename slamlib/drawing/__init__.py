"""Figures for chapters and experiments: light and dark, with a text for those who cannot see them, with sliders."""

from slamlib.drawing.colors import colors
from slamlib.drawing.gaussians import draw_ellipse, ellipse
from slamlib.drawing.page import Picture, Sweep, picture, sweep
from slamlib.drawing.plane import draw_robot, figure

__all__ = ["Picture", "Sweep", "colors", "draw_ellipse", "draw_robot", "ellipse", "figure", "picture", "sweep"]
