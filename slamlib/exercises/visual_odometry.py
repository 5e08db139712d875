"""Checks of the chapter: visual odometry."""

from typing import Any

import numpy as np

from slamlib.exercises import exercise
from slamlib.exercises.properties import Rejected, array_of, holds, pair, rotation_matrix, same
from slamlib.geometry.pose import to_frame
from slamlib.geometry.quaternion import UnitQuaternion, rotation
from slamlib.manifolds import Array


@exercise("visual_odometry.1", "how far a pair went ahead")
def advance(candidate: Any) -> None:
    """Exact without noise; never worse than any other weighted mean; and as far off as it says."""
    rng = np.random.default_rng(211)
    for n in (1, 2, 5, 40):
        f, b, sigma, t = (float(rng.uniform(*r)) for r in ((200, 700), (0.1, 0.5), (0.1, 0.4), (-0.3, 0.3)))
        z = rng.uniform(1.5, 8, n)
        d_old, d_new = f * b / z, f * b / (z - t)
        given = f"{n} points"
        found, std = _two(candidate(d_old, d_new, f, b, sigma))
        same(found, t, "without noise it is exact, and positive where points come nearer", given=given)
        slopes = np.stack([-f * b / d_old**2, f * b / d_new**2])
        variances = sigma**2 * (slopes**2).sum(0)
        same(std, (1 / variances).sum() ** -0.5, "the standard deviation is that of the best mean", given=given)
        noise = sigma * rng.standard_normal((2, n)) * 1e-5
        moved, _ = _two(candidate(d_old + noise[0], d_new + noise[1], f, b, sigma))
        best = ((slopes * noise).sum(0) / variances).sum() / (1 / variances).sum()
        same(
            (moved - t) * 1e5, best * 1e5, "a point counts by the inverse of its variance", given=given, tolerance=1e-3
        )


def _two(value: Any) -> tuple[float, float]:
    one, other = pair(value, "t and its standard deviation")
    return float(array_of(np.squeeze(one), (), "t")), float(array_of(np.squeeze(other), (), "its standard deviation"))


@exercise("visual_odometry.2", "the cycle of four pictures")
def closes(candidate: Any) -> None:
    """Exactly the features of which both ways end at one and the same feature."""
    rng = np.random.default_rng(212)
    for n, m, k, q, missing in ((6, 5, 7, 6, 0.0), (30, 25, 28, 26, 0.3), (40, 40, 40, 40, 0.8), (3, 4, 2, 3, 1.0)):
        old, left, right, new = (
            _matched(rng, *sizes, missing) for sizes in ((n, m), (n, k), (m, q), (k, q))
        )  # old left to old right, old left to new left, old right to new right, new left to new right
        _agreeing(rng, old, left, right, new)
        given = f"{n} old left features, {missing:.0%} unmatched"
        found = np.asarray(candidate(old, left, right, new))
        if found.ndim != 1 or (found.size and found.dtype.kind not in "iu"):
            raise Rejected(f"your function should return whole numbers (c,), got {found.dtype} of shape {found.shape}")
        stops = [
            (right[old[i]] if old[i] >= 0 else -1, new[left[i]] if left[i] >= 0 else -2) for i in found.astype(int)
        ]
        holds(all(a == b and a >= 0 for a, b in stops), "each of them comes back to itself", f"not all do, for {given}")
        others = np.setdiff1d(np.arange(n), found)
        kept = [i for i in others if min(old[i], left[i]) >= 0 and right[old[i]] == new[left[i]] >= 0]
        holds(not kept, "none that closes the cycle is forgotten", f"{len(kept)} are, for {given}")
        holds((np.diff(found) > 0).all(), "each is named once, in growing order", f"not so for {given}")


def _matched(rng: np.random.Generator, n: int, m: int, missing: float) -> Array:
    """For each of n features one of m, or -1."""
    found: Array = np.where(rng.random(n) < missing, -1, rng.integers(0, m, n))
    return found


def _agreeing(rng: np.random.Generator, old: Array, left: Array, right: Array, new: Array) -> None:
    """Let half of the cycles that could close do so; and put a trap behind the last entries, which -1 would read."""
    for i in range(0, len(old), 2):
        if min(old[i], left[i]) >= 0 and right[old[i]] >= 0:
            new[left[i]] = right[old[i]]
    if (old < 0).any() and (left >= 0).any():
        right[-1] = new[-1] = 0


@exercise("visual_odometry.3", "from PnP's answer to the robot's control")
def control(candidate: Any) -> None:
    """The points of the world, seen before and after, agree with PnP's answer on any robot."""
    rng = np.random.default_rng(213)
    for number in range(6):
        turn, shift = rotation(UnitQuaternion.random(rng)), rng.uniform(-1, 1, 3)
        extrinsics = np.concatenate([rng.uniform(-1, 1, 3), UnitQuaternion.random(rng)])
        turn = np.eye(3) if number == 0 else turn
        extrinsics = np.array([0.0, 0, 0, 1, 0, 0, 0]) if number < 2 else extrinsics
        given = "a camera at the robot's origin" if number < 2 else "a camera on a mount"
        moved, R = pair(candidate(turn, shift, extrinsics), "the displacement and the rotation matrix")
        moved, R = array_of(moved, (3,), "the displacement"), rotation_matrix(R, "the rotation")
        points = rng.uniform(-5, 5, (8, 3))  # of the old robot's frame
        before, after = to_frame(extrinsics, points), to_frame(extrinsics, (points - moved) @ R)
        same(after, before @ turn.T + shift, "points are seen where PnP says that they are", given=given)
