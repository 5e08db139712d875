"""Checks of the chapter: visual odometry."""

import numpy as np

from slambook.exercises import Candidate, Rejected, Rng, exercise
from slambook.exercises.kit import array_of, cases, holds, parts, rotation_matrix, same
from slamlib.geometry.pose import ORIGIN, to_frame
from slamlib.geometry.quaternion import UnitQuaternion, rotation
from slamlib.manifolds import Array


@exercise("visual_odometry.1", "how far a pair went ahead", seed=211)
def advance(candidate: Candidate, rng: Rng) -> None:
    """Exact without noise; never worse than any other weighted mean; and with the stated standard deviation."""
    for n in cases((1, 2, 5, 40), "{} points"):
        f, b, sigma, t = (float(rng.uniform(*r)) for r in ((200, 700), (0.1, 0.5), (0.1, 0.4), (-0.3, 0.3)))
        z = rng.uniform(1.5, 8, n)
        d = f * b / np.stack([z, z - t])  # old and new

        def found(d: Array, f: float = f, b: float = b, sigma: float = sigma) -> list[Array]:
            both = parts(candidate(*d, f, b, sigma), {"t": None, "its standard deviation": None})
            return [array_of(np.squeeze(value), (), "t or its standard deviation") for value in both]

        ahead, std = found(d)
        same(ahead, t, "without noise it is exact, and positive where points come nearer")
        slopes = f * b / d**2 * [[-1], [1]]
        variances = sigma**2 * (slopes**2).sum(0)
        same(std, (1 / variances).sum() ** -0.5, "the standard deviation is that of the best mean")
        noise = sigma * rng.standard_normal((2, n)) * 1e-5
        moved = found(d + noise)[0] - t
        best = ((slopes * noise).sum(0) / variances).sum() / (1 / variances).sum()
        same(moved * 1e5, best * 1e5, "a point counts by the inverse of its variance", tolerance=1e-3)


@exercise("visual_odometry.2", "the cycle of four pictures", seed=212)
def closes(candidate: Candidate, rng: Rng) -> None:
    """Exactly the features of which both ways end at one and the same feature."""
    pictures = (6, 0.0, 5, 7, 6), (30, 0.3, 25, 28, 26), (40, 0.8, 40, 40, 40), (3, 1.0, 4, 2, 3)
    for n, missing, m, k, q in cases(pictures, "{} old left features, a share of {} unmatched"):
        # old left to old right, old left to new left, old right to new right, new left to new right
        old, left, right, new = (
            np.where(rng.random(a) < missing, -1, rng.integers(0, b, a)) for a, b in ((n, m), (n, k), (m, q), (k, q))
        )
        _agreeing(old, left, right, new)
        found = np.asarray(candidate(old, left, right, new))
        if found.ndim != 1 or (found.size and found.dtype.kind not in "iu"):
            raise Rejected(f"your function should return whole numbers (c,), got {found.dtype} of shape {found.shape}")
        # where each ends, by the old right picture and by the new left one; -1 and -2 where nothing is matched
        one, other = np.where(old < 0, -1, right[old]), np.where(left < 0, -2, new[left])
        closed = (one == other) & (one >= 0)
        holds(closed[found.astype(int)].all(), "each of them comes back to itself", "not all do")
        kept = np.setdiff1d(np.flatnonzero(closed), found)
        holds(not kept.size, "none that closes the cycle is missing", f"{kept.size} are")
        holds((np.diff(found) > 0).all(), "each is named once, in growing order")


def _agreeing(old: Array, left: Array, right: Array, new: Array) -> None:
    """Let half of the cycles that could close do so; and put a trap behind the last entries, which -1 would read."""
    right[old[np.flatnonzero((old >= 0) & (left < 0))[:1]]] = 0
    for i in range(0, len(old), 2):
        if min(old[i], left[i]) >= 0 and right[old[i]] >= 0:
            new[left[i]] = right[old[i]]
    right[-1] = new[-1] = 0


@exercise("visual_odometry.3", "from PnP's answer to the robot's control", seed=213)
def control(candidate: Candidate, rng: Rng) -> None:
    """The points of the world, seen before and after, agree with PnP's answer on any robot."""
    for number in range(6):
        turn, shift = rotation(UnitQuaternion.random(rng)), rng.uniform(-1, 1, 3)
        camera = np.concatenate([rng.uniform(-1, 1, 3), UnitQuaternion.random(rng)])
        turn = np.eye(3) if number == 0 else turn
        camera = ORIGIN if number < 2 else camera  # first a camera at the robot's origin
        moved, R = parts(candidate(turn, shift, camera), {"the displacement": (3,), "the rotation matrix": (3, 3)})
        rotation_matrix(R, "the rotation")
        points = rng.uniform(-5, 5, (8, 3))  # of the old robot's frame
        before, after = to_frame(camera, points), to_frame(camera, (points - moved) @ R)
        same(after, before @ turn.T + shift, "points are seen where PnP says that they are")
