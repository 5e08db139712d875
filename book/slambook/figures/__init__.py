"""What the book's figures have beyond matplotlib: colours for light and dark pages, words for those who cannot see,
sliders, handles, ellipses, robots and frames. NumPy alone is needed, where no figure of matplotlib's is shown."""

from slambook.figures.colors import colors
from slambook.figures.dragging import Dragged, drag
from slambook.figures.figure import Figure, figure
from slambook.figures.page import StaticPicture, Sweep, picture, sweep
from slambook.figures.sketches import draw_ellipse, draw_frame, draw_robot, ellipse
from slambook.figures.widget import live

__all__ = [
    "Dragged",
    "Figure",
    "StaticPicture",
    "Sweep",
    "colors",
    "drag",
    "draw_ellipse",
    "draw_frame",
    "draw_robot",
    "ellipse",
    "figure",
    "live",
    "picture",
    "sweep",
]
