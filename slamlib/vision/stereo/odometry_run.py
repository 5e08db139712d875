"""Visual odometry alone on a sequence of pairs, to compare the filter with; and how a saved run of either is opened."""

import os
from collections.abc import Callable
from typing import Any, ClassVar

from slamlib.datasets.sources import Source
from slamlib.slam import Options, Report
from slamlib.vision.stereo.motion_source import Halves
from slamlib.vision.stereo.run import StereoRun
from slamlib.vision.stereo.settings import StereoSettings


class Alone(Halves):
    """Plain odometry of all features, for a filter without landmarks."""

    odometry_half = None


class OdometryRun(StereoRun):
    """Visual odometry alone: the filter has no landmarks, and adds up motions and their covariances.

    In its history, searched are the features matched from left to right, matched those that were matched round the
    cycle, believed those that agree with the motion; nis is the sum of their squares.
    """

    kind = "stereo-odometry"
    has_map = False
    ways: ClassVar[dict[str, Callable[..., Any]]] = {"odometry": Alone}
    moving: Alone

    def __init__(
        self,
        source: Source,
        camera: dict[str, Any],
        *,
        settings: StereoSettings | None = None,
        patience: int = 30,
    ) -> None:
        """As StereoRun."""
        super().__init__(source, camera, Options(points=None), moving="odometry", settings=settings, patience=patience)

    def _has_begun(self) -> bool:
        return bool(self.history)

    def _counts(self, report: Report) -> dict[str, float]:
        found, odometry = self.moving.found, self.moving.odometry
        believed = 0 if found is None else int(found.inliers.sum())
        dof = max(3 * believed - 6, 0)
        return {
            **super()._counts(report),
            "searched": 0 if odometry.old is None else len(odometry.old),
            "matched": len(odometry.pairs),
            "believed": believed,
            "nis": 0.0 if found is None else found.fit * dof,
            "nis_dof": dof,
        }

    def _follow(self, number: int) -> None:
        lost = self.moving.found is None and number > 1
        self.gap.first = (self.gap.first or number) if lost else None
        self.gap.last = number


def load(path: str | os.PathLike[str], *, frames: int | None = None) -> StereoRun:
    """Go on with a saved run on stereo pairs, of either kind."""
    kind = OdometryRun if OdometryRun.holds(path) else StereoRun
    return kind.load(path, frames=frames)
