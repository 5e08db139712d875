"""`make monocular`: the longer runs of chapter monocular in the rendered room, stored as one small file.

Three hundred frames of 320 x 240 pixels past a wall, with five seeds (noise of the images, choice of the cells); and
once round the room, with the paths themselves. benchmarks/monocular.py prints the same runs with their times, which
belong to a machine and are not stored, and with a fifth of all matches wrong.
"""

from typing import Any

import numpy as np
from slambook import rendering

from benchmarks import monocular as bench
from book.tools import layout, stored
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.experiments.progress import progress
from slamlib.slam import Slam
from slamlib.vision.active_search import ActiveSearch

FILE = layout.BOOK / "chapters" / "data" / "monocular.json"
SEEDS, FRAMES = (1, 2, 3, 4, 5), 300
LIGHT = 15  # frames that a test runs again
ROUND, ROUND_DT, EVERY = 449, 1 / 15, 8  # frames, [s] between them, and frames between two that are stored
OLD = 200  # frames: a landmark initialized so long ago and seen now closes the loop


def sideways(seed: int, frames: int = FRAMES) -> bench.Outcome:
    """One run past the wall."""
    return bench.run(*bench.frames_of("drawn", "sideways", frames, seed), seed, bench.OPTIONS, ActiveSearch)


def row(outcome: bench.Outcome) -> dict[str, float]:
    """Figures of merit of one run, rounded."""
    return {
        "off": round(100 * float(outcome.relative_ate), 3),
        "scale": round(float(outcome.scale), 3),
        "matched": round(float(outcome.matched.sum() / outcome.searched.sum()), 3),
        "nis": round(float(outcome.nis.sum() / outcome.dof.sum()), 3),
    }


def around(seed: int) -> dict[str, Any]:
    """Once round the room, and half a second more: every eighth position, estimated and true, and what was seen."""
    way = rendering.path("round")
    pushed = (0.03,) * 3 + (1.2,) * 3
    rig = rendering.rig_along_path(way, std=(0.1,), control_std=pushed)
    rng = np.random.default_rng(seed)
    film = rendering.film(rendering.default_room("drawn"), rig, way, frames=ROUND, dt=ROUND_DT, rng=rng)
    search = ActiveSearch(rig.sensors[0].calibration, np.random.default_rng([seed, 1]))
    slam, poses, true, old = Slam(rig, bench.OPTIONS, front_ends=[search]), [], [], []
    for frame, truth in film:
        slam.step(frame)
        poses.append(slam.robots[0].pose.copy())
        true.append(truth.robots[0][:7])
        old.append(sum(k.inlier and k.landmark.first_seen < frame.number - OLD for k in slam.predictions[0]))
    estimate, reference = (Trajectory(ROUND_DT * np.arange(ROUND, dtype=float), np.array(p)) for p in (poses, true))
    stored = slice(0, None, EVERY)
    return {
        "off": round(100 * align_trajectory(estimate, reference).relative_ate, 3),
        "landmarks": len(slam.landmarks),
        "old": old[stored],
        "place": np.round(estimate.positions[stored], 4).tolist(),
        "true": np.round(reference.positions[stored], 4).tolist(),
    }


PARTS = {
    "frames": lambda: FRAMES,
    "light": lambda: [row(sideways(seed, LIGHT)) for seed in SEEDS[:1]],
    "sideways": lambda: [row(sideways(seed)) for seed in progress(SEEDS, len(SEEDS), "past the wall")],
    "round": lambda: [around(seed) for seed in progress(SEEDS, len(SEEDS), "round the room")],
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
