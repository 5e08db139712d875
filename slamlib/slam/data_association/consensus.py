"""Which of the matches of one frame are believed together, before the gate judges each by itself. Chapter 19.

A consensus yields groups of looks, one after another: the filter corrects by a group before it asks for the next one,
so that a later group is chosen in the light of the earlier correction. What it does not yield is refused: no inlier, as
if the gate had refused it, with the nis by which it was.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from slamlib.belief import Belief
from slamlib.manifolds import Array, Mask
from slamlib.observation.family import viewpoint
from slamlib.slam.data_association.gates import gate, innovation_covariances, normalized
from slamlib.slam.data_association.jcbb import compatible
from slamlib.slam.data_association.joint_innovation import Together, by_kind, together, told_by_each
from slamlib.slam.entities import MountedSensor
from slamlib.slam.measurement_update import Look

if TYPE_CHECKING:
    from slamlib.slam.options import Options

Consensus = Callable[[Belief, MountedSensor, list[Look], "Options"], Iterator[list[Look]]]

# Standard deviations of the measurement's noise: a match within this of what a hypothesis expects supports it. Low on
# purpose (Civera et al. 2010): 86 % of the true matches of two numbers without other errors, and few wrong ones.
LOW_INNOVATION = 2.0
# Matches that must agree, the one that makes the hypothesis among them: two wrong ones agree by chance now and then.
SUPPORT = 3


def each(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> Iterator[list[Look]]:
    """All of them: the gate judges each alone."""
    yield looks


def joint(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> Iterator[list[Look]]:
    """The largest set that is compatible as a whole: z' Z^-1 z of all passes the gate for all degrees of freedom.

    Neira and Tardos (2001). What fails the gate by itself is out before. The nis of a refused look is what it would add
    to the square of those accepted.
    """
    if len(looks) < 2:
        yield looks
        return
    found = together(belief, sensor, looks)
    keep = _jointly(found, _alone(found) < _limits(found, options), options)
    refused = _those(looks, ~keep)
    for look, nis in zip(refused, _added(found, keep).tolist() if refused else (), strict=True):
        look.nis = nis
    yield _those(looks, keep)


def _jointly(found: Together, may: Mask, options: "Options") -> Mask:
    """Mask of the largest jointly compatible set of the innovations that may."""
    rows, keep = np.flatnonzero(may), np.zeros(len(may), dtype=bool)
    if len(rows):
        Z = found.Z[rows][:, :, rows]
        keep[rows] = compatible(found.z[rows], Z, found.dof[rows], partial(gate, options.gate))
    return keep


def one_point(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> Iterator[list[Look]]:
    """Those that agree with what one of them says of the pose and the map; then, of the rest, what passes the gate.

    Civera, Grasa, Davison and Montiel (2010): a filter has a prior, so that a single match makes a hypothesis. Each of
    the few that pass the gate is tried; they draw at random, to try fewer. The one with the largest support wins, and
    among equals the one that its supporters fit best. Where no SUPPORT of them agree, one point says too little about
    the rest of the motion, and the largest jointly compatible set is corrected first.
    """
    if len(looks) < 2:
        yield looks
        return
    found = together(belief, sensor, looks)
    squares = _alone(found)
    may = squares < _limits(found, options)
    support = _largest_support(sensor, looks, found, may)
    if support.sum() < min(SUPPORT, may.sum()):
        support = _jointly(found, may, options)
    for look, nis in zip(looks, squares.tolist(), strict=True):
        look.nis = nis  # what remains of those that go out of view
    yield _those(looks, support)
    yield from _rescued(belief, sensor, _those(looks, ~support), options)


def _largest_support(sensor: MountedSensor, looks: list[Look], found: Together, may: Mask) -> Mask:
    """Mask of the matches, of those that may, that agree with the best hypothesis."""
    off = told_by_each(sensor, looks, found)
    squares = normalized(off, np.broadcast_to(found.R, (len(looks), *found.R.shape)))
    agree = (squares < LOW_INNOVATION**2) | np.eye(len(looks), dtype=bool)  # out of view is nan, and does not agree
    agree &= may & may[:, None]
    misfit = np.where(agree, squares, 0).sum(1)
    best: Mask = agree[np.lexsort((misfit, -agree.sum(1)))[0]]
    return best


def _rescued(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> Iterator[list[Look]]:
    """Those of the looks that pass the gate where the belief is now; they are corrected by what is expected there."""
    inside: list[tuple[Look, Look]] = []
    for at in by_kind(looks):
        group = {looks[i].landmark: looks[i] for i in at}
        family = looks[at[0]].family
        expected = family.expect(viewpoint(sensor), list(group), options)
        if not expected.landmarks:
            continue
        seen = [group[landmark] for landmark in expected.landmarks]
        found = family.innovate(sensor, expected, np.array([look.measured for look in seen]))
        Z = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
        for row, nis in enumerate(normalized(found.z, Z).tolist()):
            seen[row].nis = nis
            if nis < gate(options.gate, found.z.shape[1]):
                inside.append((seen[row], replace(seen[row], expected=expected, row=row)))
    if inside:
        yield [anew for _, anew in inside]
    for look, anew in inside:  # a look goes on showing what was expected of it before any correction
        look.nis, look.inlier = anew.nis, anew.inlier


def _alone(found: Together) -> Array:
    """Square (n,) of each innovation by itself."""
    rows = np.arange(len(found.z))
    return normalized(found.z, found.Z[rows, :, rows])


def _limits(found: Together, options: "Options") -> Array:
    return np.array([gate(options.gate, size) for size in found.dof.tolist()])


def _added(found: Together, keep: Mask) -> Array:
    """What each innovation that is not kept would add to the joint square of those kept."""
    n, d = found.z.shape
    count, kept = int((~keep).sum()), np.repeat(keep, d)
    Z, z = found.Z.reshape(n * d, n * d), found.z.ravel()
    across = Z[kept][:, ~kept]
    gain = np.linalg.solve(Z[kept][:, kept], across).T
    left = (Z[~kept][:, ~kept] - gain @ across).reshape(count, d, count, d)
    rows = np.arange(count)
    return normalized((z[~kept] - gain @ z[kept]).reshape(count, d), left[rows, :, rows])


def _those(looks: list[Look], mask: Mask) -> list[Look]:
    return [look for look, is_one in zip(looks, mask.tolist(), strict=True) if is_one]


CONSENSUS: dict[str, Consensus] = {"each": each, "joint": joint, "one-point": one_point}
