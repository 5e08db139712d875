"""The covariance carried along each landmark's own symmetry, too: where its anchor stands is a convention.

A point as an anchor and a ray is the same point with the anchor elsewhere and the ray turned after it. No measurement
tells these states apart: for each landmark, further columns of N, which hold numbers that updates change. The anchor is
where a robot was, and correlated with it; information that is gained on it is information on the robot.

An experiment of chapter observability, for one batch update a frame. The filter of slamlib carries the world's motion.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from slamlib.entities import RigSensor, State
from slamlib.entities.landmark import landmark_means
from slamlib.geometry.pose import ORIGIN
from slamlib.manifolds import Array, Indices
from slamlib.slam.measurement_update import Projection, unprojected
from slamlib.slam.transport import unobservable

# How many directions the anchor has, of each type with one: a position, or a whole frame. The rest is the ray, or line.
ANCHORS = {"ahmPnt": 3, "aplLin": 3, "fhmPnt": 6, "idpPnt": 3}


def shifts(kind: Any, states: Array) -> Array:
    """N (k, dof, a) of states (k, size): the anchor moves by its own a directions, and the rest keeps the landmark."""
    anchor = ANCHORS[kind.name]
    there, J = kind.to_frame.jac(ORIGIN, states)
    by, a = J.landmark, there.shape[-1]
    # A homogeneous result may also be scaled, where the rest has too few numbers to keep it as it is.
    rest = np.concatenate([by[..., anchor:], there[..., None]], axis=-1)[..., :a]
    follows = -np.linalg.solve(rest, by[..., :anchor])[..., : by.shape[-1] - anchor, :]
    return np.concatenate([np.broadcast_to(np.eye(anchor), (len(states), anchor, anchor)), follows], axis=1)


def with_anchors(state: State, sensor: RigSensor) -> tuple[Array, Indices]:
    """N (size, 6 + r) of the world and of all anchors, and rows (6 + r,) that tell its columns apart."""
    columns, rows = [unobservable(state, sensor)], [sensor.columns]
    for rows_of_kind in state.kinds():
        group = rows_of_kind.landmarks
        if group[0].kind.name in ANCHORS:
            for landmark, N in zip(group, shifts(group[0].kind, landmark_means(group)), strict=True):
                own = np.zeros((state.belief.size, N.shape[1]))
                own[landmark.block.slice] = N
                columns.append(own)
                rows.append(landmark.block.start + np.arange(N.shape[1]))
    return np.concatenate(columns, axis=1), np.concatenate(rows)


@contextmanager
def anchors_carried(state: State, sensor: RigSensor) -> Iterator[Projection]:
    """As `slamlib.slam.transport.carried`, with the anchors' columns of N beside those of the world."""
    before, rows = with_anchors(state, sensor)
    motion = np.asarray(np.linalg.inv(before[rows]), float)
    state.belief.transport = lambda: (rows, with_anchors(state, sensor)[0] - before, motion)
    try:
        yield unprojected
    finally:
        state.belief.transport = None
