"""The state that the filter estimates: all robots, sensors and landmarks, as blocks of one joint Gaussian."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from slamlib.belief import Belief
from slamlib.entities.landmark import Landmark, group_by_kind, landmark_means, state_rows
from slamlib.entities.linearization import Linearization
from slamlib.entities.rig import RigSensor, Robot
from slamlib.kalman.state import StateLayout, places
from slamlib.manifolds import Array, Euclidean, Indices, read_only
from slamlib.records.ids import Id


@dataclass(eq=False)
class KindRows:
    """All landmarks of one kind, their rows (n, dof) of the covariance, and where their means lie in the layout."""

    landmarks: list[Landmark]
    rows: Indices
    places: Indices | None
    _gathered: tuple[Array | None, Array] = field(default=(None, np.zeros(0)), repr=False)  # of which numbers, means

    @classmethod
    def of(cls, landmarks: list[Landmark]) -> "KindRows":
        """The rows of these landmarks, as they lie now."""
        are_vectors = type(landmarks[0].block.manifold) is Euclidean
        return cls(landmarks, state_rows(landmarks), places([lm.block for lm in landmarks]) if are_vectors else None)

    @property
    def kind(self) -> Any:
        """The parametrization."""
        return self.landmarks[0].kind

    @cached_property
    def together(self) -> slice | Indices:
        """Their rows (n * dof,), one after the other: a slice where they follow each other, which is quicker."""
        one = self.rows.ravel()
        whole = slice(int(one[0]), int(one[0]) + len(one))
        return whole if np.array_equal(one, np.arange(whole.start, whole.stop)) else one

    def __len__(self) -> int:
        return len(self.landmarks)

    def take(self, indices: Indices) -> "KindRows":
        """Some of them, in this order."""
        at = None if self.places is None else self.places.take(indices, axis=0)
        return KindRows([self.landmarks[i] for i in indices.tolist()], self.rows.take(indices, axis=0), at)

    def means(self) -> Array:
        """Their present means (n, size), read-only where they are vectors: gathered once between two changes."""
        layout = self.landmarks[0].block.layout
        if layout is None or self.places is None:
            return landmark_means(self.landmarks)
        if self._gathered[0] is not layout.flat:
            self._gathered = layout.flat, read_only(layout.flat.take(self.places))
        return self._gathered[1]


@dataclass(eq=False)
class State:
    """The robots, sensors and landmarks of one filter, and the belief whose blocks they are."""

    belief: Belief
    robots: list[Robot] = field(default_factory=list)
    sensors: list[RigSensor] = field(default_factory=list)
    landmarks: list[Landmark] = field(default_factory=list)
    _looked_up: tuple[tuple[StateLayout | None, int], list[KindRows], frozenset[Id]] = field(
        default=((None, 0), [], frozenset()), repr=False
    )

    @property
    def layout(self) -> tuple[StateLayout | None, int]:
        """How the landmarks lie among the rows of the covariance, and how many they are: a new one is the last of its
        layout; where one goes or changes there is another layout."""
        return self.landmarks[0].block.layout if self.landmarks else None, len(self.landmarks)

    def kinds(self) -> list[KindRows]:
        """The landmarks kind by kind."""
        return self._by_layout()[1]

    def ids(self) -> frozenset[Id]:
        """The numbers of the landmarks."""
        return self._by_layout()[2]

    def _by_layout(self) -> tuple[tuple[StateLayout | None, int], list[KindRows], frozenset[Id]]:
        """The layout of the landmarks, and what is looked up once for each."""
        layout = self.layout
        if layout[0] is None or self._looked_up[0] != layout:
            numbers = frozenset(landmark.id for landmark in self.landmarks)
            self._looked_up = layout, kinds_of(self.landmarks), numbers
        return self._looked_up

    @property
    def linearization(self) -> Linearization | None:
        """The linearization points; None: the present means."""
        return self.sensors[0].linearization

    @linearization.setter
    def linearization(self, linearization: Linearization | None) -> None:
        for sensor in self.sensors:
            sensor.linearization = linearization
        if linearization is not None:
            linearization.added(self.belief.blocks, [block.mean for block in self.belief.blocks])

    def remove(self, landmark: Landmark) -> None:
        """Delete a landmark: what remains is the marginal of the others."""
        self.belief.remove(landmark.block)
        self.landmarks.remove(landmark)


def kinds_of(landmarks: Iterable[Landmark]) -> list[KindRows]:
    """Landmarks kind by kind, with their rows as they lie now."""
    return [KindRows.of(group) for group in group_by_kind(landmarks)]
