"""Results of a run on images: numbers per frame, and their summary."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.evaluation import comparison
from slamlib.evaluation.trajectory import Trajectory
from slamlib.manifolds import Array
from slamlib.slam import Report, Slam

PARTS = ("filter", "search", "detection", "reading")
COLUMNS = (
    *("time", "searched", "matched", "inliers", "nis", "nis_dof", "landmarks", "initialized", "deleted"),
    *PARTS,
)


@dataclass(frozen=True, eq=False)
class ImageResult:
    """Per frame, arrays (n,) by the names of COLUMNS; the camera's trajectory; final size of the state.

    time [s] of the image; searched, matched, inliers: landmarks searched for, found, and accepted; nis and its degrees
    of freedom nis_dof: of all inliers; landmarks: in the map; initialized, deleted; PARTS, and perhaps more of them:
    processor time [s].
    """

    columns: dict[str, Array]
    trajectory: Trajectory
    size: int

    def __getattr__(self, name: str) -> Array:
        if name == "columns" or name not in self.columns:
            raise AttributeError(name)
        return self.columns[name]

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the columns of seconds."""
        return tuple(name for name in self.columns if name not in COLUMNS or name in PARTS)

    @property
    def frames_without_match(self) -> int:
        """Number of frames without an inlier, the first not counted."""
        return int((self.columns["inliers"][1:] == 0).sum())


def counts(slam: Slam, report: Report) -> dict[str, float]:
    """A filter's numbers of its last frame for the columns, without times."""
    predictions = slam.predictions[0]
    inliers = [prediction for prediction in predictions if prediction.inlier]
    return {
        "searched": sum(prediction.chosen for prediction in predictions),
        "matched": sum(prediction.matched for prediction in predictions),
        "inliers": len(inliers),
        "nis": float(sum(prediction.nis for prediction in inliers)),
        "nis_dof": sum(len(prediction.S) for prediction in inliers),
        "landmarks": len(slam.landmarks),
        "initialized": len(report.initialized),
        "deleted": len(report.deleted),
    }


def summary(result: ImageResult) -> dict[str, Any]:
    """Plain data: lengths in the run's unit, times in milliseconds (medians over the frames)."""
    c = result.columns
    searched, matched, inliers = (float(c[name].sum()) for name in ("searched", "matched", "inliers"))
    tracked = c["inliers"][1:] if len(c["time"]) > 1 else c["inliers"]
    return {
        "frames": len(c["time"]),
        "seconds": float(c["time"][-1] - c["time"][0]),
        "tracked_mean": float(tracked.mean()),
        "tracked_least": int(tracked.min()),
        "frames_without_match": result.frames_without_match,
        "searched": int(searched),
        "matched_share": matched / searched if searched else None,
        "inlier_share": inliers / matched if matched else None,
        "nis_per_dof": float(c["nis"].sum() / c["nis_dof"].sum()) if inliers else None,
        "landmarks": int(c["landmarks"][-1]),
        "initialized": int(c["initialized"].sum()),
        "deleted": int(c["deleted"].sum()),
        "state": result.size,
        "path_length": float(result.trajectory.distances[-1]),
        "milliseconds": {name: 1e3 * float(np.median(c[name])) for name in result.parts},
    }


def table(s: dict[str, Any]) -> list[tuple[str, str]]:
    """The rows of a summary, and of its "reference" (slamlib.evaluation.comparison), as texts (name, value)."""
    share = {name: "none" if s[name] is None else f"{s[name]:.1%}" for name in ("matched_share", "inlier_share")}
    nis = "no match" if s["nis_per_dof"] is None else f"{s['nis_per_dof']:.2f} (1 is ideal; the gate rejects some)"
    unit = "m" if s.get("metric") else "of the run's own units"
    parts = ", ".join(f"{name} {spent:.1f}" for name, spent in s["milliseconds"].items())
    rows = [
        ("frames", f"{s['frames']}, {s['seconds']:.2f} s"),
        ("tracked features", f"{s['tracked_mean']:.1f} per frame, at least {s['tracked_least']}"),
        ("frames without a match", f"{s['frames_without_match']} (predictions)"),
        ("matched", f"{share['matched_share']} of {s['searched']} searched; {share['inlier_share']} of them inliers"),
        ("NIS per degree of freedom", nis),
        ("landmarks", f"{s['landmarks']} in the map, {s['initialized']} initialized, {s['deleted']} deleted"),
        ("state", f"{s['state']} degrees of freedom"),
        ("path", f"{s['path_length']:.3f} {unit} long"),
        ("milliseconds per frame", f"{sum(s['milliseconds'].values()):.1f}: {parts} (medians)"),
    ]
    return rows + comparison.rows(s["reference"]) if s.get("reference") else rows
