"""Which landmarks to look at, and which measurements to believe. Chapter 16.

A landmark's row of `columns` holds the rows of the joint covariance that its measurement depends on: the robot's pose,
the mount if it is estimated, the landmark.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from slamlib.data.records import Features, Scan
from slamlib.evaluation.consistency import chi2_quantile
from slamlib.kalman import linalg
from slamlib.manifolds import Array, Indices, Mask


def innovation_covariances(covariance: Array, columns: Indices, H: Array, R: Array) -> Array:
    """Z = H P H' + R (n, d, d) of n measurements, one by one; covariance (s, s), columns (n, k), H (n, d, k)."""
    half = H @ linalg.principal_blocks(covariance, columns) @ H.swapaxes(-1, -2) / 2
    Z: Array = half + half.swapaxes(-1, -2) + R
    return Z


def normalized(z: Array, Z: Array) -> Array:
    """z' Z^-1 z (n,) of innovations (n, d) with covariances (n, d, d)."""
    return linalg.quadratic_forms(z, Z)


def by_information(Z: Array, count: int) -> Indices:
    """The `count` rows whose innovation covariance (n, d, d) has the largest determinant, largest first.

    A measurement lowers the entropy of the state by log(det Z / det R) / 2: with one R for all, the most uncertain
    expectation is the one to look at. Davison (2005); the toolbox leaves R out (errata E57). Ties: the earlier row.
    """
    return np.argsort(-linalg.log_determinants(Z), kind="stable")[:count]


def by_order(Z: Array, count: int) -> Indices:
    """The first `count` rows."""
    return np.arange(len(Z))[:count]


CHOICES = {"information": by_information, "order": by_order}


@lru_cache
def gate(probability: float, dof: int) -> float:
    """The largest z' Z^-1 z that passes: a true measurement of `dof` numbers does with this probability (E59)."""
    return math.inf if probability == 1 else chi2_quantile(probability, dof)


@dataclass(frozen=True, eq=False)
class Sight:
    """What a front end gets to see: the scan, the mounted sensor as it is estimated now, and all that it expects.

    looks: one for each landmark that should be in view, with its expectation (`value`, `Z`) before any correction.
    """

    scan: Scan
    sensor: Any
    looks: list[Any]


class Identity:
    """Association by identity: simulated features, and those of labelled data, carry the id of what they show.

    What any front end must offer: check, findable, match and detect; and, for files, dump and restore of its own state,
    and pack and unpack of the signatures that it gives to landmarks. One that works on images finds its measurements
    itself.
    """

    def check(self, scan: Scan) -> None:
        """Raise SlamlibError for a scan that it cannot look at, before anything is changed: there is none."""

    def findable(self, sight: Sight) -> list[Any]:
        """The looks that it could find at all if the landmarks are there: of identified features, all."""
        return sight.looks

    def match(self, sight: Sight, family: str, looks: list[Any]) -> tuple[Array, Mask]:
        """Measurements (n, m) of what is looked for, nan where there is none, and the mask of those found."""
        features = _features(sight, family)
        row_of = {number: row for row, number in enumerate(features.ids.tolist())}
        rows = np.array([row_of.get(look.landmark.id, -1) for look in looks], dtype=int)
        size = features.values.shape[1] if len(features) or not looks else len(looks[0].value)
        measured = np.full((len(looks), size), np.nan)
        measured[rows >= 0] = features.values[rows[rows >= 0]]
        return measured, rows >= 0

    def detect(
        self, sight: Sight, family: str, known: set[int], usable: Callable[[Array], Mask], count: int
    ) -> list[tuple[int, Array, Any]]:
        """Up to `count` features to begin a landmark with, (id, value, signature): the lowest ids that are not known.

        usable(values) is the mask of the values (n, m) that a landmark may begin with.
        """
        features = _features(sight, family)
        fresh = sorted((number, row) for row, number in enumerate(features.ids.tolist()) if number not in known)
        if not fresh or not count:
            return []
        mask = usable(features.values[[row for _, row in fresh]])
        good = [pair for pair, is_usable in zip(fresh, mask.tolist(), strict=True) if is_usable][:count]
        return [(number, features.values[row], None) for number, row in good]

    def dump(self) -> Any:
        """Its state as plain data: it has none."""

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""

    def pack(self, signature: Any) -> Any:
        """A landmark's signature as plain data: there is none."""

    def unpack(self, packed: Any) -> Any:
        """The signature that `pack` packed."""


def _features(sight: Sight, family: str) -> Features:
    """The features of a family in the scan; none if it has none."""
    found: Features | None = sight.scan.features.get(family)
    return Features.none(0) if found is None else found
