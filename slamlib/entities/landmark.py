"""Landmarks of the filter: handles to blocks of the belief, and their history; by kind, so that each is one batch."""

from collections import defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any, TypeVar

import numpy as np

from slamlib.kalman import state
from slamlib.kalman.state import Block
from slamlib.manifolds import Array, Indices
from slamlib.records.ids import Id

T = TypeVar("T")
KIND = attrgetter("kind")  # of a landmark


@dataclass(eq=False)
class Landmark:
    """A landmark in the map: its parametrization, block and history; for a line, the abscissas of its two endpoints.

    searched, matched, inliers: how often it was searched for, matched, and accepted as an inlier. sensor: index of the
    sensor that initialized it; signature: what that sensor's front end keeps of it. first_seen: the frame in
    which it was initialized; last_seen: the frame of its last inlier. first_measured: what initialized it.
    """

    id: Id
    kind: Any  # of the class that its family has: PointLandmark, LineLandmark, ...; a Parametrization
    block: Block
    first_seen: int
    searched: int = 1
    matched: int = 1
    inliers: int = 1
    abscissas: Array | None = None
    sensor: int = 0
    signature: Any = field(default=None, repr=False)  # read by that front end alone
    last_seen: int = 0
    first_measured: Array | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        self.last_seen = max(self.last_seen, self.first_seen)


def group_by_kind(items: Iterable[T], kind: Callable[[T], object] = KIND) -> list[list[T]]:
    """Group landmarks, or whatever has a kind, so that each kind is computed in one batch."""
    found = list(items)
    keys = list(map(id, map(kind, found)))
    if len(set(keys)) == 1:  # mostly the case
        return [found]
    groups: dict[int, list[T]] = defaultdict(list)
    for key, item in zip(keys, found, strict=True):
        groups[key].append(item)
    return list(groups.values())


def landmark_means(landmarks: list[Landmark]) -> Array:
    """Means (n, size) of landmarks of one kind."""
    return state.stacked_means([landmark.block for landmark in landmarks])


def state_rows(landmarks: list[Landmark]) -> Indices:
    """Rows (n, dof) of the joint covariance of landmarks of one kind."""
    starts: Indices = np.array([landmark.block.start for landmark in landmarks])
    return starts[:, None] + np.arange(landmarks[0].block.dof)
