"""Axes in the house style, and small drawings in the plane."""

from typing import Any

import numpy as np

from slamlib.drawing.colors import colors
from slamlib.drawing.gaussians import draw_ellipse
from slamlib.errors import SlamlibError
from slamlib.spaces import Array

_STYLE: Any = {
    "font.size": 11,
    "axes.titlesize": 11.5,
    "axes.labelsize": 11,
    "legend.fontsize": 10,
    "xtick.labelsize": 10,
    "ytick.labelsize": 10,
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
_CYCLE = (colors.blue, colors.orange, colors.green, colors.red, colors.purple, colors.grey)


def figure(
    rows: int = 1,
    columns: int = 1,
    *,
    width: float = 5.8,
    height: float = 3.5,
    equal: bool = False,
    projection: str | None = None,
) -> Any:
    """A figure and its axes (one, or an array of them) in the house style; sizes in inches, `equal` for maps.

    Keep to 6.4 inches: on a phone a figure is shrunk to the column, and its words with it.
    """
    try:
        import matplotlib as mpl
        from cycler import cycler
        from matplotlib import pyplot
    except ModuleNotFoundError as error:
        raise SlamlibError("drawing needs matplotlib: pip install 'slamlib[draw]'") from error
    grid = colors.faint + ("40" if projection == "3d" else "")  # axes in space know no grid.alpha
    with mpl.rc_context({**_STYLE, "axes.prop_cycle": cycler(color=_CYCLE), "grid.color": grid}):
        fig, axes = pyplot.subplots(
            rows, columns, figsize=(width, height), layout="constrained", subplot_kw={"projection": projection}
        )
    for ax in np.ravel(axes):
        if equal:
            ax.set_aspect("equal")
    return fig, axes


def draw_robot(ax: Any, pose: Array, *, size: float = 0.4, color: str = colors.blue, **style: Any) -> None:
    """A triangle at the pose (x, y, heading) [m, rad] that points along the heading."""
    x, y, heading = pose
    corners = size * np.array([[1.0, 0.0], [-0.6, 0.55], [-0.6, -0.55], [1.0, 0.0]])
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    ax.plot(*(turn @ corners.T + np.array([[x], [y]])), color=color, **style)


def draw_frame(ax: Any, pose: Array, *, size: float = 1.0, label: str = "", **style: Any) -> None:
    """The axes of a frame in the plane, red x and green y, with its name; pose (x, y, heading) [m, rad], size [m]."""
    x, y, heading = pose
    axes = size * np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    for (dx, dy), color, letter in zip(axes.T, (colors.red, colors.green), "xy", strict=True):
        ax.plot([x, x + dx], [y, y + dy], color=color, **style)
        ax.text(x + 1.15 * dx, y + 1.15 * dy, letter, color=color, ha="center", va="center")
    if label:
        ax.text(*(np.array([x, y]) - 0.25 * axes.sum(-1)), label, ha="center", va="center")


def draw_map(
    ax: Any,
    landmarks: Array,
    covariances: Array | None = None,
    *,
    truth: Array | None = None,
    path: Array | None = None,
    pose: Array | None = None,
    pose_covariance: Array | None = None,
    color: str = colors.blue,
) -> None:
    """What a filter believes of the plane, with its 95 % ellipses, over what is true.

    landmarks (N, 2) and covariances (N, 2, 2); truth (M, 2): crosses; path (T, 2): where the robot went;
    pose (x, y, heading) and the covariance (2, 2) or (3, 3) of its first numbers. Metres and radians.
    """
    if truth is not None:
        ax.plot(*np.asarray(truth).T, ls="", marker="+", ms=8, color=colors.grey, label="true landmarks")
    if path is not None:
        ax.plot(*np.asarray(path)[:, :2].T, color=colors.grey, lw=1.2, label="true path")
    landmarks = np.asarray(landmarks, dtype=float).reshape(-1, 2)
    ax.plot(*landmarks.T, ls="", marker=".", color=color)
    for mean, covariance in zip(landmarks, [] if covariances is None else covariances, strict=covariances is not None):
        draw_ellipse(ax, mean, covariance, color=color, lw=1.2)
    if pose is not None:
        draw_robot(ax, pose, color=color)
        if pose_covariance is not None:
            draw_ellipse(ax, pose[:2], np.asarray(pose_covariance)[:2, :2], color=color, lw=1.2)
