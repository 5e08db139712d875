"""Axes in the house style, and small drawings in the plane."""

from typing import Any

import numpy as np

from slamlib.drawing.colors import colors
from slamlib.errors import SlamlibError
from slamlib.spaces import Array

_STYLE: Any = {
    "font.size": 10,
    "axes.titlesize": 10.5,
    "axes.labelsize": 10,
    "legend.fontsize": 9,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": colors.faint,
    "axes.labelcolor": colors.text,
    "axes.titlecolor": colors.text,
    "text.color": colors.text,
    "xtick.color": colors.text,
    "ytick.color": colors.text,
    "legend.frameon": False,
    "legend.labelcolor": colors.text,
    "grid.color": colors.faint,
    "grid.alpha": 0.35,
    "axes.grid": True,
    "lines.linewidth": 1.8,
}


def figure(rows: int = 1, columns: int = 1, *, width: float = 6.2, height: float = 3.4, equal: bool = False) -> Any:
    """A figure and its axes (one, or an array of them) in the house style; sizes in inches, `equal` for maps."""
    try:
        import matplotlib as mpl
        from matplotlib import pyplot
    except ModuleNotFoundError as error:
        raise SlamlibError("drawing needs matplotlib: pip install 'slamlib[draw]'") from error
    with mpl.rc_context(_STYLE):
        fig, axes = pyplot.subplots(rows, columns, figsize=(width, height), layout="constrained")
        cycle = [colors.blue, colors.orange, colors.green, colors.red, colors.purple, colors.grey]
        for ax in np.ravel(axes):
            ax.set_prop_cycle(color=cycle)
            if equal:
                ax.set_aspect("equal")
    return fig, axes


def draw_robot(ax: Any, pose: Array, *, size: float = 0.4, color: str = colors.blue, **style: Any) -> None:
    """A triangle at the pose (x, y, heading) [m, rad] that points along the heading."""
    x, y, heading = pose
    corners = size * np.array([[1.0, 0.0], [-0.6, 0.55], [-0.6, -0.55], [1.0, 0.0]])
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    ax.plot(*(turn @ corners.T + np.array([[x], [y]])), color=color, **style)
