"""`make report-experiments`: run page report_experiments's longer experiments on the report's filter, and store them.

What is remembered (5.4), correlations (9.3), FastSLAM beside EKF-SLAM (3.2), and the methods of an update (6). Times
are kept apart, under "machine": they are those of the last run, and no test reads them. "light" is a small
run of each experiment, which a test makes again to see that the file belongs to the code as it is. Finished experiments
are kept in _build/report_experiments, so that an interrupted one goes on where it was.
"""

import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np
from slambook.report import correlations, memory, planar_runs, speed
from slambook.report.updates import naive, problem

from book.experiments import mrpt, stored
from book.experiments.stored import plain
from book.tools import layout
from slamlib.experiments.progress import progress

FILE = layout.BOOK / "chapters" / "data" / "report_experiments.json"
FOLDER = layout.BUILD / "report_experiments"
CODE = sorted((layout.BOOK / "slambook" / "report").glob("*.py"))
SEED = 22
LANDMARKS = 8, 15, 31, 64, 98, 165, 231, 331  # of the times: states of 30 to 999 numbers
REPEATS = 3
SEEN = {"3 landmarks": 3, "20 landmarks": 20, "all landmarks": None}
FULL: dict[str, dict[str, Any]] = {
    "memory": {"runs": 100},
    "correlations": {"runs": 4000},
    "fastslam": {"runs": 40, "particles": [0, 10, 30, 100, 300, 1000]},
    "accuracy": {"runs": 100},
    "mapping": {},
}
LIGHT: dict[str, dict[str, Any]] = {
    "memory": {"runs": 3, "steps": 8},
    "correlations": {"runs": 20, "steps": 6},
    "fastslam": {"runs": 2, "steps": 6, "particles": [0, 10]},
    "accuracy": {"runs": 3, "steps": 5},
    "mapping": {"steps": 3},
}


def rng() -> np.random.Generator:
    """Every experiment starts with the same seed."""
    return np.random.default_rng(SEED)


def remembered(**sizes: Any) -> Any:
    """Variants of memory by name: errors and their standard deviations by the filter at each step, and NEES over 6."""
    return plain({
        found.name: {
            "position": found.position,
            "claimed": found.claimed,
            "inside": round(found.consistency.inside, 3),
            "ratio": found.ratio,
        }
        for found in memory.compare(rng(), **sizes)
    })  # fmt: skip


def correlated(**sizes: Any) -> Any:
    """The table of correlations, for SLAM and for odometry alone."""
    return plain({
        name: {"nees": found.nees, "dof": len(found.claimed), "rows": list(map(asdict, correlations.table(found)))}
        for name, found in correlations.experiment(rng(), **sizes).items()
    })  # fmt: skip


def contested(**sizes: Any) -> Any:
    """FastSLAM by its number of particles, and EKF-SLAM."""
    return plain({
        found.name: {
            "position": found.position,
            "map_error": found.map_error,
            "inside": round(found.consistency.inside, 3),
            "typical": found.typical,
        }
        for found in planar_runs.compare(rng(), **sizes)
    })  # fmt: skip


def accurate(**sizes: Any) -> dict[str, Any]:
    """By how much one linearisation for each landmark lowers their error, against one a picture."""
    scenes = ("gentle", "hard")
    return {name: {"gain": plain(speed.accuracy(rng(), scene=name, **sizes).gain, 3)} for name in scenes}


def mapped(**sizes: Any) -> Any:
    """The run of the report's chapter 6 by every method."""
    return plain(list(map(asdict, speed.mapping(rng(), **sizes))))


EXPERIMENTS: dict[str, Callable[..., Any]] = {
    "memory": remembered,
    "correlations": correlated,
    "fastslam": contested,
    "accuracy": accurate,
    "mapping": mapped,
}


# Times: those of the last run, never tested.


def machine() -> dict[str, Any]:
    """Times of the methods of an update."""
    found: dict[str, Any] = {name: times(name, seen) for name, seen in SEEN.items()}
    if mrpt.available():
        found["MRPT"] = elsewhere()
    return found


def times(name: str, seen: int | None) -> dict[str, Any]:
    """Times by method over the sizes of the state, and at which size the fastest one changes.

    seen: landmarks in a scan; None: all.
    """
    rows = list(progress(speed.timings(rng(), sizes(seen), REPEATS), len(LANDMARKS), f"times, {name}"))
    return {
        "sizes": [row.size for row in rows],
        "seconds": {way: [plain(row.seconds[way], 3) for row in rows] for way in rows[0].seconds},
        "crossings": [round(n) for n in speed.crossing(rows, "number by number", "whole matrices")],
    }


def sizes(seen: int | None) -> list[tuple[int, int]]:
    """Landmarks, and how many of them are seen: at most so many, or all."""
    return [(n, min(n, seen or n)) for n in LANDMARKS]


def elsewhere() -> dict[str, Any]:
    """The same by MRPT: seconds by method, and the error of the state, relative to the update."""
    found: dict[str, Any] = {}
    with mrpt.compiled() as program:
        for name in ("3 landmarks", "20 landmarks"):
            given = [problem(rng(), *size) for size in sizes(SEEN[name])]
            runs = [mrpt.run_update(program, p, REPEATS) for p in progress(given, len(given), f"MRPT, {name}")]
            right = [naive(p)()[0] for p in given]
            found[name] = {
                method: {
                    "seconds": [plain(run[method].seconds, 3) for run in runs],
                    "off": [
                        plain(float(np.linalg.norm(run[method].state[0] - x) / np.linalg.norm(x - p.x)), 3)
                        for run, x, p in zip(runs, right, given, strict=True)
                    ],
                }
                for method in runs[0]
            }
    return found


def digest() -> str:
    """Fingerprint of the sizes of all experiments."""
    return hashlib.sha256(json.dumps([SEED, FULL, LIGHT, LANDMARKS, SEEN]).encode()).hexdigest()[:12]


def kept(name: str, run: Callable[[], Any]) -> Any:
    """A finished part from its file, if it is there and belongs to the code as it is; otherwise it is run now."""
    file = FOLDER / f"{name}-{digest()}-{layout.digest(CODE)}.json"
    if not file.is_file():
        layout.write_whole(file, json.dumps(run()).encode())
        print(f"{name}: done", flush=True)
    return json.loads(file.read_text("utf-8"))


RUNS: dict[str, Callable[[], Any]] = {
    "light": lambda: {name: run(**LIGHT[name]) for name, run in EXPERIMENTS.items()},
    **{name: partial(run, **FULL[name]) for name, run in EXPERIMENTS.items()},
    "machine": machine,
}
PARTS: dict[str, Callable[[], Any]] = {
    "digest": digest,
    "seed": lambda: SEED,
    "sizes": lambda: FULL,
    **{name: partial(kept, name, run) for name, run in RUNS.items()},
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
