"""`make monocular`: the longer runs of chapter monocular in the rendered room, stored as one small file.

Three hundred frames of 320 x 240 pixels past a wall, with five seeds (noise of the images, choice of the cells); and
once round the room, with the paths themselves. benchmarks/monocular.py prints the same runs with their times, which
belong to a machine and are not stored, and with a fifth of all matches wrong.
"""

import time
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from slambook import rendering
from slambook.smoothing import Smoother

from book.experiments import stored
from book.tools import layout
from slamlib.evaluation.alignment import AlignedTrajectory, align, align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.experiments.progress import progress
from slamlib.manifolds import Array, Mask
from slamlib.records.inputs import Frame
from slamlib.slam import Options, Slam
from slamlib.vision.active_search import ActiveSearch
from slamlib.vision.relocalization import close_loop

FILE = layout.BOOK / "chapters" / "data" / "monocular.json"
SEEDS, FRAMES = (1, 2, 3, 4, 5), 300
CLOSED = (*SEEDS, 11, 12, 13, 14, 15)  # loops by appearance: nothing was chosen on the last five
LIGHT = 15  # frames that a test runs again
ROUND, ROUND_DT, EVERY = 449, 1 / 15, 8  # frames, [s] between them, and frames between two that are stored
OLD = 200  # frames: a landmark initialized so long ago and seen now closes the loop
DT, STD = 1 / 30, 0.035  # [s] between frames; [px] of a match: what the image's noise and the warp leave
OPTIONS = Options(updates=12, max_new_first=12, max_new=3, min_matched_ratio=0.5, inverse_distance=(0.4, 0.4))


@dataclass(frozen=True, eq=False)
class Outcome:
    """One run: relative error and scale of its path, error by all data at once; per frame (n,): searched, matched, NIS
    and its dof; seconds."""

    relative_ate: float
    scale: float
    at_once: float
    searched: Array
    matched: Mask
    nis: Array
    dof: Array
    seconds: dict[str, float]


def frames_of(texture: str, path: str, frames: int, seed: int) -> tuple[Any, list[Frame], Array]:
    """The rig of a film, its frames, and the true poses (n, 7), which are the camera's but for fixed extrinsics."""
    way = rendering.path(path)
    rig = rendering.rig_along_path(way, std=(STD,))
    film = rendering.film(
        rendering.default_room(texture), rig, way, frames=frames, dt=DT, rng=np.random.default_rng(seed)
    )
    steps = list(film)
    return rig, [frame for frame, _ in steps], np.array([truth.poses[0] for _, truth in steps])


def run(
    rig: Any,
    frames: list[Frame],
    truth: Array,
    seed: int,
    options: Options,
    kind: type[ActiveSearch],
    at_once: bool = False,
) -> Outcome:
    """One run of the filter over frames that are there; and, at_once, by all its data, too."""
    front_end = kind(rig.sensors[0].calibration, np.random.default_rng([seed, 1]))
    slam, rows, poses = Slam(rig, options=options, front_ends=[front_end]), [], []
    smoother = Smoother(slam) if at_once else None
    began = time.perf_counter()
    for frame in frames:
        slam.step(frame)
        if smoother is not None:
            smoother.record(frame)
        predictions = slam.predictions[0]
        inliers = [prediction for prediction in predictions if prediction.inlier]
        counts = (
            sum(prediction.chosen for prediction in predictions),
            sum(prediction.matched for prediction in predictions),
        )
        rows.append([*counts, sum(prediction.nis for prediction in inliers), 2 * len(inliers)])
        poses.append(slam.robots[0].pose.copy())
    spent = time.perf_counter() - began
    times = DT * np.arange(len(frames), dtype=float)
    reference = Trajectory(times, truth)

    def aligned(path: Array) -> AlignedTrajectory:
        """As in the chapter, whose path is nearly straight."""
        return align_trajectory(Trajectory(times, path), reference, rotation_from="orientations")

    found, best = aligned(np.array(poses)), np.nan
    if smoother is not None:
        best = aligned(smoother.solve().poses[:, 0]).relative_ate
    searched, matched, nis, dof = np.array(rows, dtype=float).T
    seconds = {"all": spent, **front_end.seconds}
    return Outcome(found.relative_ate, found.similarity.scale, best, searched, matched, nis, dof, seconds)


def sideways(seed: int, frames: int = FRAMES) -> Outcome:
    """One run past the wall."""
    return run(*frames_of("drawn", "sideways", frames, seed), seed, OPTIONS, ActiveSearch, True)


def row(outcome: Outcome) -> dict[str, float]:
    """Figures of merit of one run, rounded."""
    return {
        "off": round(100 * float(outcome.relative_ate), 3),
        "scale": round(float(outcome.scale), 3),
        "at once": round(100 * float(outcome.at_once), 3),
        "matched": round(float(outcome.matched.sum() / outcome.searched.sum()), 3),
        "nis": round(float(outcome.nis.sum() / outcome.dof.sum()), 3),
    }


@cache
def around(seed: int, closes: bool = False) -> dict[str, Any]:
    """Once round the room, and half a second more: each eighth position, by filter and all data; closes: loops, too."""
    way = rendering.path("round")
    rig = rendering.rig_along_path(way, std=(0.1,), control_std=(0.03,) * 3 + (1.2,) * 3)
    rng = np.random.default_rng(seed)
    film = rendering.film(rendering.default_room("drawn"), rig, way, frames=ROUND, dt=ROUND_DT, rng=rng)
    search = ActiveSearch(rig.sensors[0].calibration, np.random.default_rng([seed, 1]))
    slam, poses, true, old = Slam(rig, options=OPTIONS, front_ends=[search]), [], [], []
    smoother = Smoother(slam)
    for frame, truth in film:
        slam.step(frame)
        smoother.record(frame)
        if closes:
            close_loop(slam, np.asarray(frame.scans[0].image))
        poses.append(slam.robots[0].pose.copy())
        true.append(truth.poses[0])
        old.append(sum(k.inlier and k.landmark.first_seen < frame.number - OLD for k in slam.predictions[0]))
    times = ROUND_DT * np.arange(ROUND, dtype=float)
    *paths, reference = (Trajectory(times, np.array(p)) for p in (poses, smoother.solve().poses[:, 0], true))
    off, least = (round(100 * align_trajectory(path, reference).relative_ate, 3) for path in paths)
    found, best, real = (np.round(path.positions[::EVERY], 4).tolist() for path in (*paths, reference))
    told = {"off": off, "landmarks": len(slam.landmarks), "old": old[::EVERY], "place": found, "true": real}
    return {**told, "at once": {"off": least, "place": best}}


def closed(seed: int) -> list[dict[str, float]]:
    """Once round the room, without and with loops by appearance: ATE [%], old landmarks and error [m] at the end."""
    found = []
    for run in (around(seed), around(seed, closes=True)):
        place, true = np.array(run["place"]), np.array(run["true"])
        end = float(np.linalg.norm(align(place[:20], true[:20])(place[-1]) - true[-1]))
        found.append({"off": run["off"], "at once": run["at once"]["off"], "end": end, "old": run["old"][-1]})
    return stored.plain(found)


PARTS = {
    "frames": lambda: FRAMES,
    "light": lambda: [row(sideways(seed, LIGHT)) for seed in SEEDS[:1]],
    "sideways": lambda: [row(sideways(seed)) for seed in progress(SEEDS, len(SEEDS), "past the wall")],
    "round": lambda: [around(seed) for seed in progress(SEEDS, len(SEEDS), "round the room")],
    "closed": lambda: [closed(seed) for seed in progress(CLOSED, len(CLOSED), "loops by appearance")],
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
