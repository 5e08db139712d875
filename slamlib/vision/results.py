"""Results of a run on images: numbers per frame, and their summary."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.evaluation import comparison
from slamlib.evaluation.trajectory import Trajectory
from slamlib.manifolds import Array
from slamlib.records.ids import Id
from slamlib.slam import Slam, StepReport

PRODUCTS = ("lasting", "lasting_now", "lasting_before")  # of the innovations of two neighbouring frames
PARTS = ("filter", "search", "detection", "reading")
COLUMNS = (
    *("time", "searched", "matched", "inliers", "nis", "nis_dof", "landmarks", "initialized", "deleted"),
    *(*PRODUCTS, "lasting_dof", "near"),
    *PARTS,
)
NEAR = 40.0  # baselines: nearer points tell how long a step was, the others where it turned (Mur-Artal, Tardos 2017)
# Of a run without warnings: what lasts of the innovations' variance, beside the variance they are predicted with, and
# the least near points. After ten measurements of a landmark the filter claims a tenth, and what lasts is as it was.
LASTING, FEW_NEAR = 0.1, 6.0
OVERCONFIDENT = 10.0  # the largest median NEES, per degree of freedom, of a run without a warning
Whitened = dict[Id, Array]  # innovations in units of the standard deviations they were predicted with; by landmark


@dataclass(frozen=True, eq=False)
class ImageResult:
    """Per frame, arrays (n,) by the names of COLUMNS; the camera's trajectory; final size of the state.

    time [s] of the image; searched, matched, inliers: landmarks searched for, found, and accepted; nis and its degrees
    of freedom nis_dof: of all inliers; landmarks: in the map; initialized, deleted; lasting: product of the whitened
    innovations of this frame and the last, of the landmarks that are inliers in both, zero on average where the errors
    of a landmark's measurements are independent; lasting_now, lasting_before: their own squares, of lasting_dof
    numbers; near: inliers nearer than NEAR, nan for a single camera; PARTS, and perhaps more of them: processor time
    [s].
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


def counts(slam: Slam, report: StepReport) -> dict[str, float]:
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


def whitened(slam: Slam) -> Whitened:
    """The innovations of the points that were inliers, before the update."""
    found = [p for p in slam.predictions[0] if p.inlier and p.family.name == "points"]
    if not found:
        return {}
    factors = np.linalg.cholesky([p.S for p in found])
    values = np.linalg.solve(factors, np.array([p.measured - p.value for p in found])[..., None])[..., 0]
    return {p.landmark.id: value for p, value in zip(found, values, strict=True)}


def lasting(now: Whitened, before: Whitened) -> dict[str, float]:
    """The four columns of the innovations of a frame and the one before."""
    pairs = [(value, before[number]) for number, value in now.items() if number in before]
    return {
        "lasting": sum(float(a @ b) for a, b in pairs),
        "lasting_now": sum(float(a @ a) for a, _ in pairs),
        "lasting_before": sum(float(b @ b) for _, b in pairs),
        "lasting_dof": sum(len(a) for a, _ in pairs),
    }


def innovation_correlation(products: Array) -> tuple[float, float] | None:
    """The correlation of innovations with those of the next frame, -1 to 1, and its standard error; None without pairs.

    products (n, 3): of each frame, as PRODUCTS names them. With N, A, B their sums, r = N / sqrt(A B), whatever
    factor the filter's covariances are off by. Innovations of one frame are correlated, by the camera's error that they
    share: so frames are the independent units, and the error is that of a ratio of their sums (the delta method).
    """
    N, A, B = products.sum(0).tolist()
    if not A * B > 0:
        return None
    size = float(np.sqrt(A * B))
    r = N / size
    return r, float(np.linalg.norm(products[:, 0] / size - r * (products[:, 1] / A + products[:, 2] / B) / 2))


def summary(result: ImageResult) -> dict[str, Any]:
    """Plain data: lengths in the run's unit, times in milliseconds (medians over the frames)."""
    c = result.columns
    searched, matched, inliers = (float(c[name].sum()) for name in ("searched", "matched", "inliers"))
    lasts, off = innovation_correlation(np.stack([c[name] for name in PRODUCTS], axis=-1)) or (None, None)
    nis = float(c["nis"].sum() / c["nis_dof"].sum()) if inliers else None
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
        "nis_per_dof": nis,
        "innovation_correlation": lasts,
        "innovation_correlation_std": off,
        "innovation_lasting": float(c["lasting"].sum() / c["lasting_dof"].sum()) if lasts is not None else None,
        "near_mean": None if np.isnan(c["near"]).any() else float(c["near"][1:].mean()) if len(tracked) > 1 else None,
        "landmarks": int(c["landmarks"][-1]),
        "initialized": int(c["initialized"].sum()),
        "deleted": int(c["deleted"].sum()),
        "state": result.size,
        "path_length": float(result.trajectory.distances[-1]),
        "milliseconds": {name: 1e3 * float(np.median(c[name])) for name in result.parts},
    }


def summary_warnings(s: dict[str, Any]) -> list[str]:
    """Warnings that a summary gives, in sentences: by its own covariances, and by its "reference", if there is one."""
    found, lasts, near = [], s["innovation_correlation"], s["near_mean"]
    if lasts is not None and lasts > 4 * s["innovation_correlation_std"] and s["innovation_lasting"] > LASTING:
        found.append(
            f"the innovations of a frame foretell those of the next (correlation {lasts:.2f}): errors last that the "
            "filter takes for independent, and its covariances are too small"
        )
    if near is not None and near < FEW_NEAR:
        few = f"only {near:.1f} points per frame are nearer than {NEAR:g} baselines"
        found.append(f"{few}: how far each step went is hardly measured")
    reference = s.get("reference") or {"notes": [], "nees": None}
    found += reference["notes"]
    known = reference["nees"]
    if known and known["median"] > OVERCONFIDENT * known["dof"]:
        times = (known["median"] / known["dof"]) ** 0.5
        found.append(
            f"errors are about {times:.0f} times as large as the covariances claim: NEES {known['median']:.3g}"
        )
    return found


def table(s: dict[str, Any]) -> list[tuple[str, str]]:
    """The rows of a summary, and of its "reference" (slamlib.evaluation.comparison), as texts (name, value)."""
    share = {name: "none" if s[name] is None else f"{s[name]:.1%}" for name in ("matched_share", "inlier_share")}
    nis = "no match" if s["nis_per_dof"] is None else f"{s['nis_per_dof']:.2f} (without those that the gate rejects)"
    known = []
    if s["innovation_correlation"] is not None:
        by = f"{s['innovation_correlation']:.2f}, +- {s['innovation_correlation_std']:.2f} (standard error)"
        known.append(("innovations, next frame", f"correlated by {by}; 0 if errors do not last"))
    if s["near_mean"] is not None:
        known.append(("near points", f"{s['near_mean']:.1f} per frame, nearer than {NEAR:g} baselines"))
    unit = "m" if s.get("metric") else "of the run's own units"
    parts = ", ".join(f"{name} {spent:.1f}" for name, spent in s["milliseconds"].items())
    rows = [
        ("frames", f"{s['frames']}, {s['seconds']:.2f} s"),
        ("tracked features", f"{s['tracked_mean']:.1f} per frame, at least {s['tracked_least']}"),
        ("frames without a match", f"{s['frames_without_match']} (predictions)"),
        ("matched", f"{share['matched_share']} of {s['searched']} searched; {share['inlier_share']} of them inliers"),
        ("NIS per degree of freedom", nis),
        *known,
        ("landmarks", f"{s['landmarks']} in the map, {s['initialized']} initialized, {s['deleted']} deleted"),
        ("state", f"{s['state']} degrees of freedom"),
        ("path", f"{s['path_length']:.3f} {unit} long"),
        *_calibration(s.get("calibration"), unit),
        ("milliseconds per frame", f"{sum(s['milliseconds'].values()):.1f}: {parts} (medians)"),
    ]
    return rows + comparison.rows(s["reference"]) if s.get("reference") else rows


def _calibration(found: dict[str, Any] | None, unit: str) -> list[tuple[str, str]]:
    """The row of a calibration whose errors are considered, if they are."""
    if found is None:
        return []
    ends = [
        f"{found[key]['position_sigma']:.3g} {unit}, {found[key]['orientation_sigma']:.2g} degrees"
        for key in ("with", "without")
    ]
    nees = f", and NEES {found['without']['nees']:.3g} (median)" if "nees" in found["without"] else ""
    return [("calibration considered", "sigma at the end {}; without its errors {}".format(*ends) + nees)]
