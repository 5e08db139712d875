"""Errors over parts of a path of given lengths: KITTI's measure (Geiger, Lenz and Urtasun, 2012), for any lengths."""

from dataclasses import dataclass

import numpy as np

from slamlib.errors import ShapeError, SlamlibError
from slamlib.evaluation.trajectory import Trajectory, angles
from slamlib.geometry.pose import compose, inverse, relative
from slamlib.manifolds import Array, Indices


@dataclass(frozen=True, eq=False)
class Relative:
    """Errors over parts of the path: lengths (k,) [m], for each the number of parts, and two means over them.

    translation (k,): error per length of the path (0.01 is 1 %); rotation (k,): [rad/m]. nan where no part is so long.
    """

    lengths: Array
    counts: Array
    translation: Array
    rotation: Array


KITTI_LENGTHS: tuple[float, ...] = (100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0)


def relative_errors(
    estimate: Trajectory, reference: Trajectory, lengths: tuple[float, ...] = KITTI_LENGTHS, step: int = 10
) -> Relative:
    """KITTI's measure: the motion over each part of a given length, against the true one.

    The two are pairs, row by row, of the same body (one camera, say), and in one unit; no alignment is needed. Parts
    begin at each step-th pose, and end at the first pose that is a length further along the reference. Raises
    SlamlibError if the path is shorter than all lengths.
    """
    if len(estimate) != len(reference):
        raise ShapeError(f"{len(estimate)} poses against {len(reference)}: pick pairs with associate first")
    along = reference.distances
    if not along[-1] > min(lengths):
        raise SlamlibError(f"the path is {along[-1]:.4g} long, shorter than all of {lengths}: give shorter lengths")
    starts = np.arange(0, len(along), step)
    found = [_parts(estimate, reference, along, starts, length) for length in lengths]
    counts, translation, turn = (np.array(column) for column in zip(*found, strict=True))
    return Relative(np.array(lengths), counts, translation, turn)


def _parts(
    estimate: Trajectory, reference: Trajectory, along: Array, starts: Indices, length: float
) -> tuple[int, float, float]:
    ends = np.searchsorted(along, along[starts] + length, side="right")
    i, j = starts[ends < len(along)], ends[ends < len(along)]
    if not len(i):
        return 0, np.nan, np.nan
    off = compose(
        inverse(relative(reference.poses[i], reference.poses[j])), relative(estimate.poses[i], estimate.poses[j])
    )
    moved, turned = np.linalg.norm(off[:, :3], axis=1), angles(off[:, 3:])
    return len(i), float(moved.mean() / length), float(turned.mean() / length)
