"""Axes and frames in three dimensions."""

from typing import Any

import numpy as np

from slamlib.drawing.colors import colors
from slamlib.drawing.plane import figure
from slamlib.linalg import finite
from slamlib.spaces import Array

AXES = (("x", colors.red), ("y", colors.green), ("z", colors.blue))


def figure3d(*, width: float = 4.8, height: float = 4.2, elevation: float = 22.0, azimuth: float = -58.0) -> Any:
    """A figure and its three-dimensional axes in the house style; sizes in inches, the view's angles in degrees.

    Set the limits and `ax.set_aspect("equal")` after drawing, so that a metre is a metre on each axis.
    """
    fig, ax = figure(width=width, height=height, projection="3d")
    fig.set_layout_engine("none")  # it does not know of the words beside axes in space
    ax.set_position((0.02, 0.06, 0.86, 0.94))
    ax.view_init(elev=elevation, azim=azimuth)
    ax.locator_params(nbins=4)
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((0.5, 0.5, 0.5, 0.0))
        axis.line.set_color(colors.faint)
    return fig, ax


def draw_axes3d(ax: Any, pose: Array, *, size: float = 1.0, label: str = "", **style: Any) -> None:
    """The axes of a frame, red x, green y and blue z with their letters, and its name at the origin.

    pose (7,): position [m] and unit quaternion, x y z | w x y z, of the frame in the world. size [m].
    """
    from slamlib.geometry.quaternion import rotation

    pose = finite(pose, (7,), "draw_axes3d", "pose")
    origin = pose[:3]
    for column, (letter, color) in zip(rotation(pose[3:]).T, AXES, strict=True):
        tip = origin + size * column
        ax.plot(*np.stack([origin, tip], axis=1), color=color, **style)
        ax.text(*(origin + 1.15 * size * column), letter, color=color, ha="center", va="center")
    if label:
        ax.text(*(origin - 0.2 * size * rotation(pose[3:]).sum(-1)), label, ha="center", va="center")
