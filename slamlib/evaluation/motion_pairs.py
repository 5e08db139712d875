"""Which motions relative errors are of: pairs of poses that are a number of frames, seconds, metres or degrees apart.

The pairs are those of evo (Grupp, github.com/MichaelGrupp/evo), which has no seconds.
"""

from collections.abc import Callable

import numpy as np

from slamlib.errors import SlamlibError, entry
from slamlib.evaluation.trajectory import Trajectory, angles
from slamlib.geometry.pose import relative
from slamlib.manifolds import Array, Indices

TOLERANCE = 0.1  # of delta: of pairs that are to be that far apart
ROUNDING = 1e-6  # of delta: seconds since 1970 have no more digits


def _frames(path: Trajectory) -> Array:
    return np.arange(float(len(path)))


def _angles(path: Trajectory) -> Array:
    """Sum (n,) [rad] of the angles from each pose to the next."""
    return np.concatenate([[0.0], np.cumsum(angles(relative(path.poses[:-1], path.poses[1:])[:, 3:]))])


def _degrees(path: Trajectory) -> Array:
    return np.degrees(_angles(path))


ALONG: dict[str, Callable[[Trajectory], Array]] = {  # what grows along a path (n,), by its unit
    "frames": _frames,
    "s": lambda path: path.times - path.times[0],
    "m": lambda path: path.distances,
    "deg": _degrees,
    "rad": _angles,
}
FULL_TURN = {"deg": 360.0, "rad": 2 * np.pi}


def motion_pairs(path: Trajectory, delta: float, unit: str, all_pairs: bool = False) -> tuple[Indices, Indices]:
    """Rows (k,) of the first and the last poses of motions of a path that are delta long, in a unit of ALONG.

    One after another: each ends at the first pose that is delta further along, where the next one begins. all_pairs:
    from each pose to the one that is delta further along, or nearest to that, within a tenth of it; of angles to all
    poses that are turned by delta against it, within a tenth. Raises SlamlibError where there is none.
    """
    along = entry("unit of delta", unit, ALONG)(path)
    if not 0 < delta < np.inf or (unit == "frames" and delta != round(delta)):
        raise SlamlibError(f"delta is a number above zero, of frames a whole one, got {delta:g}")
    if unit in FULL_TURN and all_pairs:
        pairs = _turned(path, delta * 2 * np.pi / FULL_TURN[unit])
    elif all_pairs:
        pairs = _nearest(along, delta, 0.0 if unit == "frames" else TOLERANCE * delta)
    else:
        pairs = _one_after_another(along, delta)
    if not pairs:
        length = f"{along[-1] - along[0]:.4g} {unit}"
        raise SlamlibError(f"no two poses are {delta:g} {unit} apart (delta): the whole path has {length}")
    first, last = np.array(pairs).T
    return first, last


def _one_after_another(along: Array, delta: float) -> list[tuple[int, int]]:
    pairs, start = [], 0
    while (end := int(np.searchsorted(along, along[start] + (1 - ROUNDING) * delta))) < len(along):
        pairs.append((start, end))
        start = end
    return pairs


def _nearest(along: Array, delta: float, tolerance: float) -> list[tuple[int, int]]:
    found = ((i, int(np.abs(along - start - delta).argmin())) for i, start in enumerate(along))
    return [(i, j) for i, j in found if j > i and abs(along[j] - along[i] - delta) <= tolerance]


def _turned(path: Trajectory, angle: float) -> list[tuple[int, int]]:
    pairs = []
    for i in range(len(path) - 1):
        turned = angles(relative(path.poses[i], path.poses[i + 1 :])[:, 3:])
        pairs += [(i, i + 1 + int(j)) for j in np.flatnonzero(np.abs(turned - angle) <= TOLERANCE * angle)]
    return pairs
