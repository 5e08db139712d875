"""`make report-experiments`: run chapter stereo_ekf_slam's longer experiments on the report's filter, and store them.

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

from benchmarks import mrpt
from book.tools import layout, stored
from book.tools.stored import plain
from slamlib.evaluation.consistency import band
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
    """Variants of memory by name: errors, their standard deviations by the filter, and NEES over 6 at each step."""
    return plain({
        found.name: {
            "position": found.position,
            "rotation": found.rotation,
            "claimed": found.claimed,
            "landmarks": found.landmarks.tolist(),
            "nees": found.consistency.average / memory.DOF,
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
            "nees": found.nees.mean(0) / planar_runs.DOF,
            "inside": round(found.consistency.inside, 3),
            "typical": found.typical,
            "effective": found.effective,
            "ancestors": found.ancestors,
            "drawn": round(found.drawn, 3),
        }
        for found in planar_runs.compare(rng(), **sizes)
    })  # fmt: skip


def accurate(**sizes: Any) -> dict[str, Any]:
    """The landmarks' error with one linearisation a picture, and with one for each landmark."""
    found = {name: speed.accuracy(rng(), scene=name, **sizes) for name in ("gentle", "hard")}
    return {
        name: {
            "batch": plain(f.batch.mean(), 5),
            "again": plain(f.again.mean(), 5),
            "gain": plain(f.gain, 3),
            "ratios": plain([f.together_ratio, f.again_ratio]),
        }
        for name, f in found.items()
    }


def mapped(**sizes: Any) -> Any:
    """Chapter frames_and_quaternions's run by every method, without times."""
    return plain([{k: v for k, v in asdict(m).items() if k != "seconds"} for m in speed.mapping(rng(), **sizes)])


EXPERIMENTS: dict[str, Callable[..., Any]] = {
    "memory": remembered,
    "correlations": correlated,
    "fastslam": contested,
    "accuracy": accurate,
    "mapping": mapped,
}


# Times: those of the last run, never tested.


def machine() -> dict[str, Any]:
    """Times of the methods of an update, and of FastSLAM's steps."""
    found: dict[str, Any] = {name: times(name, seen) for name, seen in SEEN.items()}
    found["run of 92 landmarks"] = {m.method: plain(m.seconds, 3) for m in speed.mapping(rng())}
    racers = planar_runs.compare(rng(), runs=2, steps=40, particles=FULL["fastslam"]["particles"])
    found["FastSLAM"] = {racer.name: plain(racer.seconds, 3) for racer in racers}
    if mrpt.available():
        found["MRPT"] = elsewhere()
    return found


def times(name: str, seen: int | None) -> dict[str, Any]:
    """Times and multiplications by method over the sizes of the state, and at which size the fastest one changes.

    seen: landmarks in a scan; None: all.
    """
    rows = list(progress(speed.timings(rng(), sizes(seen), REPEATS), len(LANDMARKS), f"times, {name}"))
    return {
        "sizes": [row.size for row in rows],
        "seconds": {way: [plain(row.seconds[way], 3) for row in rows] for way in rows[0].seconds},
        "multiplications": {way: [row.multiplications[way] for row in rows] for way in rows[0].multiplications},
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


def bands() -> dict[str, list[float]]:
    """95 % bands of NEES over its degrees of freedom at a step, by experiment."""
    dofs = {"memory": memory.DOF, "fastslam": planar_runs.DOF}
    return {name: [round(v / dof, 4) for v in band(dof, FULL[name]["runs"])] for name, dof in dofs.items()}


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
    "bands": bands,
    **{name: partial(kept, name, run) for name, run in RUNS.items()},
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
