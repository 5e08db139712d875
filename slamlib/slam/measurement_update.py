"""One sensor looks at the map: choose, match, gate, correct. Chapter 16 reads it line by line."""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slamlib.belief import Belief
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Indices
from slamlib.observation.family import Expected, Family, viewpoint
from slamlib.slam.data_association.front_end import FrontEnd, Sight
from slamlib.slam.data_association.gates import CHOICES, gate, innovation_covariances, normalized
from slamlib.slam.entities import Landmark, MountedSensor

if TYPE_CHECKING:
    from slamlib.slam.options import Options

T = TypeVar("T")


def groups(items: Iterable[T]) -> list[list[T]]:
    """Landmarks, or looks at them, by the landmark's kind, so that each kind is computed in one batch."""
    found: dict[int, list[T]] = defaultdict(list)
    for item in items:
        landmark: Any = getattr(item, "landmark", item)
        found[id(landmark.kind)].append(item)
    return list(found.values())


@dataclass(eq=False)
class Look:
    """One expected landmark on its way through a frame.

    score, predicted, found: what a front end that looks at images leaves here for pictures: how well the best place
    agrees, the patch that it looked for, and the one that it found, both grey images.
    """

    family: Family
    landmark: Landmark
    expected: Expected
    row: int
    Z: Array
    measured: Array
    chosen: bool = False
    matched: bool = False
    inlier: bool = False
    nis: float = np.nan
    score: float = np.nan
    predicted: Array | None = None
    found: Array | None = None

    @property
    def value(self) -> Array:
        """The expected measurement (m,)."""
        return self.expected.value[self.row]

    def judged(self, nis: float, limit: float) -> None:
        """Believe the measurement if a true one would be as far off with the probability of the gate."""
        self.nis, self.inlier = nis, nis < limit
        self.landmark.inliers += self.inlier


def expect_all(
    belief: Belief,
    sensor: MountedSensor,
    families: Mapping[str, Family],
    landmarks: list[Landmark],
    options: "Options",
    robot: Array | None = None,
) -> list[Look]:
    """Everything that the sensor should see, with the covariance of each innovation.

    robot (7,): from another pose of its robot than the estimated one, with the covariance as it is.
    """
    looks = []
    kinds, view = groups(landmarks), viewpoint(sensor, robot)
    for family in families.values():
        for group in kinds if family.sees(sensor) else ():
            if not isinstance(group[0].kind, family.kinds):
                continue
            expected = family.expect(view, group, options)
            if not expected.landmarks:
                continue
            found = family.innovate(sensor, expected, expected.value)
            Z = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
            nothing = np.full(expected.value.shape[1], np.nan)
            looks += [Look(family, lm, expected, i, Z[i], nothing) for i, lm in enumerate(expected.landmarks)]
    return looks


def looks_from(slam: Any, motion: Array, sensor: int = 0) -> list[Look]:
    """What a sensor should see after its robot has moved by a pose (7,) in its frame; nothing of the filter changes."""
    mounted = slam.sensors[sensor]
    robot = compose(mounted.robot.pose, motion)
    return expect_all(slam.belief, mounted, slam.families, slam.landmarks, slam.options, robot)


def choose_and_match(sight: Sight, front_end: FrontEnd, options: "Options") -> list[Look]:
    """The looks that tell most and were matched, the one that tells most first; the landmarks' histories go on."""
    sizes: dict[int, list[Look]] = defaultdict(list)
    for look in front_end.findable(sight):
        sizes[len(look.Z)].append(look)
    # Determinants of different sizes do not compare: points and segments both count two pixels, and share the budget.
    choose = CHOICES[options.choose]
    chosen = [g[int(i)] for g in sizes.values() for i in choose(_stack(g), options.updates)]
    by_family: dict[str, list[Look]] = defaultdict(list)
    for look in chosen:
        look.chosen = True
        look.landmark.searched += 1
        by_family[look.family.name].append(look)
    for name, group in by_family.items():
        measured, found = front_end.match(sight, name, group)
        for look, y, is_found in zip(group, measured, found.tolist(), strict=True):
            look.measured, look.matched = y, is_found
            look.landmark.matched += is_found
    return [look for look in chosen if look.matched]


def correct_in_sequence(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> None:
    """One landmark after another, each expected anew at the mean of that moment."""
    with belief.series() as series:
        for look in looks:
            found = look.family.innovation(viewpoint(sensor), look.landmark, look.measured, options)
            if found is not None:
                limit = gate(options.gate, len(found.z))
                columns = look.expected.columns[look.row]
                look.judged(series.correct(columns, found.H, found.z, found.R, limit).nis, limit)


def correct_in_batch(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> None:
    """All at once, with the expectations of the predicted mean."""
    parts = []
    for group in groups(looks):
        expected = group[0].expected.take([look.row for look in group])
        measured = np.array([look.measured for look in group])
        found = group[0].family.innovate(sensor, expected, measured)
        Z = innovation_covariances(belief.matrix, expected.columns, found.H, found.R)
        for look, nis in zip(group, normalized(found.z, Z).tolist(), strict=True):
            look.judged(nis, gate(options.gate, found.z.shape[1]))
        keep = np.array([look.inlier for look in group])
        parts.append((expected.columns[keep], found.H[keep], found.z[keep], found.R[keep]))
    if any(len(z) for _, _, z, _ in parts):
        belief.correct_rows(*_stacked(parts))


def follow(belief: Belief, sensor: MountedSensor, looks: list[Look], options: "Options") -> None:
    """What each family does with the landmarks that were corrected: convert, constrain, move ends."""
    for group in groups(look for look in looks if look.inlier):
        landmarks, measured = [look.landmark for look in group], np.array([look.measured for look in group])
        group[0].family.corrected(belief, sensor, landmarks, measured, options)


def _stacked(parts: list[tuple[Indices, Array, Array, Array]]) -> tuple[Indices, Array, Array, Array]:
    """Touched rows, and one Jacobian, innovation and noise of all parts."""
    touched = np.unique(np.concatenate([columns.ravel() for columns, _, _, _ in parts]))
    z = np.concatenate([part[2].ravel() for part in parts])
    H, R = np.zeros((len(z), len(touched))), np.zeros((len(z), len(z)))
    start = 0
    for columns, J, innovation, noise in parts:
        rows = start + np.arange(innovation.size).reshape(innovation.shape)
        at = np.searchsorted(touched, columns)
        H[rows[:, :, None], at[:, None, :]] = J
        R[rows[:, :, None], rows[:, None, :]] = noise
        start += innovation.size
    return touched, H, z, R


def _stack(looks: list[Look]) -> Array:
    return np.concatenate([look.Z for look in looks]).reshape(-1, *looks[0].Z.shape)
