"""Small drawings in the plane: a robot, a frame, a map."""

from typing import Any

import numpy as np

from slamlib.drawing.colors import colors
from slamlib.drawing.gaussians import draw_ellipse
from slamlib.spaces import Array


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
