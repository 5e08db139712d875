"""Straight edges as landmarks, on images of the rendered room: alone, and beside points.

First, how well edges are seen: of segments that a detector finds in one frame, the plane of the room that carries them
is found by ray casting, so that their lines in space are exact but for that first detection; in later frames they are
searched for at their true positions. Printed: errors [px] of the detector and of the fit, and the share not found.

Then the filter. Each case is run with several seeds. Printed: the error of the path after a similarity, relative to its
length; the largest error of the orientation [deg], which is exact at the start; per family the share found of what
was searched for, and NIS per degree of freedom of the inliers; distances of the lines from the true ones, seen from
the last camera [px], and, where the motion is exact odometry so that the scale is known, in space [cm] and by the
filter's own covariance, whose median is 1.4 if it is right; milliseconds per frame.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from slambook import rendering

from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import rotation
from slamlib.landmarks import endpoints, hmg_point, segments
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array
from slamlib.observation.family import viewpoint
from slamlib.observation.lines import distort_segments, rays_of, undistort_segments
from slamlib.records.ids import Id
from slamlib.records.inputs import Frame, Truth
from slamlib.slam import Options, Slam
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.edges import axes, edge_strip, fitted, refined, segments_of
from slamlib.vision.image_front_end import CombinedFrontEnd
from slamlib.vision.line_search import SegmentSearch, SegmentSettings

DT, STD = 1 / 30, 0.1
OPTIONS = Options(updates=12, max_new_first=12, max_new=3, min_matched_ratio=0.5, inverse_distance=(0.4, 0.4))
Film = tuple[rendering.Film, list[tuple[Frame, Truth]]]


def camera_of(truth: Truth) -> Array:
    """True pose (7,) of the camera."""
    camera: Array = compose(truth.poses[0], truth.extrinsics[0])
    return camera


def true_line(film: rendering.Film, truth: Truth, segment: Array) -> Array | None:
    """The points (2, 3) of the room that a segment (4,) of an image shows; None where no single surface carries it.

    Of two surfaces beside an edge, the nearer one ends there.
    """
    camera, calibration = camera_of(truth), film.rig.sensors[0].calibration
    end_points = segment.reshape(2, 2)
    inner = end_points[0] + np.linspace(0.1, 0.9, 9)[:, None] * (end_points[1] - end_points[0])
    right = axes(undistort_segments(calibration, segment)[0])[1]
    sides = [film.renderers[0].cast(camera, inner + side * right) for side in (1.5, -1.5)]
    if any(len(set(quad.tolist())) > 1 for _, quad in sides):
        return None
    quad = film.room.quads[int(min(sides, key=lambda s: s[0].mean())[1][0])]
    normal = np.cross(quad.edge_u, quad.edge_v)
    rays = rays_of(calibration, segment)[0].reshape(2, 3) @ rotation(camera[3:]).T
    points: Array = camera[:3] + rays * ((quad.corner - camera[:3]) @ normal / (rays @ normal))[:, None]
    return points


def filmed(path: str, frames: int, seed: int, **rig: Any) -> Film:
    """A film and its frames."""
    way = rendering.path(path)
    made = rendering.film(
        rendering.default_room("drawn"), rendering.rig_along_path(way, std=(STD,), **rig), way,
        frames=frames, dt=DT, rng=np.random.default_rng(seed),
    )  # fmt: skip
    return made, list(made)


def repeatability(film: Film, intervals: tuple[int, ...] = (0, 1, 5, 20)) -> None:
    """Print the errors of edges, a number of frames after the one in which they were found."""
    made, steps = film
    calibration = made.rig.sensors[0].calibration
    intrinsics, raw = calibration.given["intrinsics"], list[Array]()
    off: dict[int, list[Array]] = {interval: [] for interval in intervals}
    lost: dict[int, list[bool]] = {interval: [] for interval in intervals}
    for first in range(0, len(steps) - max(intervals), 15):
        frame, truth = steps[first]
        for segment in segments_of(frame.scans[0].image, 25):
            edge = refined(frame.scans[0].image, calibration, segment)
            points = None if edge is None else true_line(made, truth, edge.segment)
            if edge is None or points is None:
                continue
            raw.append(edge.offsets)
            for interval in intervals:
                h = EUC_POINT.to_frame(camera_of(steps[first + interval][1]), points)
                seen = segments.visible(h[0], h[1], intrinsics, calibration.image, minimum_length=20, margin=3)
                if seen.seen:
                    piece = edge_strip(steps[first + interval][0].scans[0].image, calibration, seen.pixels, 7)
                    found = fitted(piece, calibration, np.zeros(2), 2.0)
                    lost[interval].append(found is None or found.support < 0.5)
                    off[interval] += [found.offsets] if found is not None and not lost[interval][-1] else []
    z = np.array(raw)
    print(
        f"detector against fit: {len(z)} segments, mean {-z.mean():+.3f} px (to the bright side), std {z.std():.3f} px"
    )
    for interval in intervals:
        z = np.array(off[interval])
        correlation = np.asarray(np.corrcoef(z.T))[0, 1]
        print(
            f"after {interval:2d} frames: {len(z)} ends' pairs, mean {z.mean():+.3f}, std {z.std():.3f}, MAD "
            f"{1.4826 * np.median(np.abs(z)):.3f} px, correlation of the two endpoints {correlation:+.2f}, "
            f"lost {np.mean(lost[interval]):.0%}"
        )


class LinesAfter(CombinedFrontEnd):
    """Points in the first frames only; then they are neither searched for nor initialized."""

    points_until, seen = 30, 0

    def searchable(self, inputs: Any) -> list[Any]:
        """As ever, and only segments after some frames."""
        self.seen += 1
        return [k for k in super().searchable(inputs) if self.seen <= self.points_until or k.family.name == "segments"]

    def detect(self, inputs: Any, family: str, known: Any, usable: Any, count: int) -> Any:
        """As ever, and only segments after some frames."""
        wanted = self.seen <= self.points_until or family == "segments"
        return super().detect(inputs, family, known, usable, count) if wanted else []


@dataclass(frozen=True, eq=False)
class Outcome:
    """One run: errors of path [%] and orientation [deg]; counts by family: searched, matched, NIS, its dof."""

    relative_ate: float
    orientation: float
    counts: dict[str, Array]
    apart: list[float]
    in_space: list[tuple[float, float]]
    seconds: dict[str, float]


def run(film: Film, options: Options, front_end: Any) -> Outcome:
    """One run of the filter."""
    made, steps = film
    slam, poses = Slam(made.rig, options=options, front_ends=[front_end]), []
    counts = {name: np.zeros(4) for name in ("points", "segments")}
    truths: dict[Id, Array | None] = {}
    began = time.perf_counter()
    for frame, truth in steps:
        report = slam.step(frame)
        poses.append(slam.robots[0].pose.copy())
        for name, total in counts.items():
            own = [prediction for prediction in slam.predictions[0] if prediction.family.name == name]
            good = [prediction.nis for prediction in own if prediction.inlier]
            total += [sum(k.chosen for k in own), sum(k.matched for k in own), sum(good), 2 * len(good)]
        truths |= {
            k.id: born(made, truth, slam, k)
            for k in slam.landmarks
            if k.id in report.initialized and k.abscissas is not None
        }
    spent = time.perf_counter() - began
    times, real = DT * np.arange(len(poses), dtype=float), np.array([t.poses[0] for _, t in steps])
    found = align_trajectory(Trajectory(times, np.array(poses)), Trajectory(times, real))
    seconds = {"all": spent, **front_end.seconds}
    born_as = {k: truth for k, truth in truths.items() if truth is not None}
    known = [k for k in slam.landmarks if k.id in born_as and k.matched >= 20]
    apart = [in_image(made, steps[-1][1], slam, k, born_as[k.id]) for k in known]
    space = [in_space(slam, k, born_as[k.id]) for k in known]
    turned = np.degrees(np.linalg.norm([Pose.minus(a, b)[3:] for a, b in zip(poses, real, strict=True)], axis=1))
    return Outcome(100 * found.relative_ate, float(turned.max()), counts,
                   [a for a in apart if np.isfinite(a)], space, seconds)  # fmt: skip


def born(film: rendering.Film, truth: Truth, slam: Slam, landmark: Any) -> Array | None:
    """The true line (2, 3) of a line just initialized: where its two endpoints are seen."""
    h = endpoints.endpoints_at(landmark.kind, landmark.block.mean, landmark.abscissas)
    pixels = slam.sensors[0].calibration.project(hmg_point.to_frame(slam.sensors[0].camera, h))
    return true_line(film, truth, pixels.ravel())


def in_image(film: rendering.Film, truth: Truth, slam: Slam, landmark: Any, points: Array) -> float:
    """How far [px] the true line's image, from the true camera, is from the estimated one's, from the estimated camera.

    The larger distance of the endpoints of the true edge's visible part; nan if out of view. No gauge matters.
    """
    calibration = slam.sensors[0].calibration
    h = EUC_POINT.to_frame(camera_of(truth), points)
    seen = segments.visible(h[0], h[1], calibration.given["intrinsics"], calibration.image)
    if not seen.seen:
        return np.nan
    measured = distort_segments(calibration, seen.pixels)
    found = slam.families["segments"].innovation(viewpoint(slam.sensors[0]), landmark, measured, slam.options)
    return float(np.abs(found.z).max()) if found is not None else np.nan


def in_space(slam: Slam, landmark: Any, points: Array) -> tuple[float, float]:
    """The larger distance [cm] of the two points of a true line from an estimated one; the mean of their squares by
    the filter's own covariance across the line, which has two degrees of freedom: 2 if the filter is right.
    """
    end_points = endpoints.endpoints_at(landmark.kind, landmark.block.mean, landmark.abscissas)
    a, b = (x[:3] / x[3] for x in end_points)
    across = np.linalg.svd((b - a)[None])[2][1:]
    at = endpoints.abscissas_of(landmark.kind, landmark.block.mean, np.column_stack([points, np.ones(2)]))
    squares, far = [], []
    for abscissa, point in zip(at, points, strict=True):
        h, J = landmark.kind.point_at.jac(landmark.block.mean, abscissa)
        by = across @ (J.landmark[:3] - np.outer(h[:3] / h[3], J.landmark[3])) / h[3]
        off = across @ (point - h[:3] / h[3])
        far.append(np.linalg.norm(off))
        squares.append(off @ np.linalg.solve(by @ slam.belief.covariance(landmark.block) @ by.T, off))
    return float(100 * max(far)), float(np.mean(squares))


def points_alone(calibration: Any, seed: int, few: int) -> Any:
    """Active search for points."""
    return ActiveSearch(calibration, np.random.default_rng([seed, 1]), ActiveSearchSettings(max_in_view=few))


def both(kind: type[CombinedFrontEnd], settings: SegmentSettings) -> Callable[[Any, int, int], CombinedFrontEnd]:
    """Points and lines."""
    return lambda calibration, seed, few: kind(
        points_alone(calibration, seed, few), SegmentSearch(calibration, settings)
    )


def report(name: str, outcomes: list[Outcome], frames: int, metric: bool) -> None:
    """One line of the printed table."""
    paths, count = [o.relative_ate for o in outcomes], frames * len(outcomes)
    parts = [f"{name:32s} path {np.mean(paths):.2f} % (worst {max(paths):.2f})"]
    parts += [f"orientation {np.mean([o.orientation for o in outcomes]):.2f} deg"]
    for family in ("points", "segments"):
        searched, matched, nis, dof = np.sum([o.counts[family] for o in outcomes], axis=0)
        if searched:
            share = f"{matched / searched:.0%} found, NIS/dof {nis / max(dof, 1):.2f}"
            parts += [f"{family}: {searched / count:.1f} a frame, {share}"]
    apart = np.array([a for o in outcomes for a in o.apart])
    if len(apart):
        parts += [f"{len(apart)} lines: {np.median(apart):.2f} px (90 % {np.quantile(apart, 0.9):.2f})"]
    space = np.array([a for o in outcomes for a in o.in_space]).reshape(-1, 2)
    if len(space) and metric:
        (middle, squares), far = np.median(space, axis=0), np.quantile(space[:, 0], 0.9)
        parts += [f"{middle:.1f} cm (90 % {far:.1f}), by its covariance {squares:.1f}"]
    spent = {part: sum(o.seconds[part] for o in outcomes) / count for part in ("all", "search", "detection")}
    print("; ".join(parts + [f"{part} {1e3 * t:.0f} ms" for part, t in spent.items()]), flush=True)


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description="Straight edges as landmarks, on images.")
    parser.add_argument("--frames", type=int, default=150)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--path", default="sideways", choices=sorted(rendering.PATHS))
    given = parser.parse_args()
    repeatability(filmed(given.path, 120, 1))
    settings = SegmentSettings()
    for motion, few in (("constVel", 30), ("odometry", 30), ("constVel", 6)):
        metric = motion == "odometry"
        more = {"control_std": (0.0005,) * 3 + (0.02,) * 3} if metric else {}
        films = {s: filmed(given.path, given.frames, s, motion=motion, **more) for s in range(1, given.seeds + 1)}
        print(f"{motion}, up to {few} points in view")
        for name, options, make in (
            ("points alone", OPTIONS, points_alone),
            ("points and idpLin", replace(OPTIONS, lines="idpLin"), both(CombinedFrontEnd, settings)),
            ("points and ahmLin", replace(OPTIONS, lines="ahmLin"), both(CombinedFrontEnd, settings)),
            ("points, 25 updates", replace(OPTIONS, updates=25), points_alone),
            (
                "points and idpLin, 25 updates",
                replace(OPTIONS, lines="idpLin", updates=25),
                both(CombinedFrontEnd, settings),
            ),
            ("idpLin alone after 30 frames", replace(OPTIONS, lines="idpLin"), both(LinesAfter, settings)),
        ):
            outcomes = [run(f, options, make(f[0].rig.sensors[0].calibration, s, few)) for s, f in films.items()]
            report(f"  {name}", outcomes, given.frames, metric)


if __name__ == "__main__":
    main()
