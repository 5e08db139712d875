"""`make report-experiments`: the longer experiments of chapter 22 on the report's filter, stored as one small file.

What is remembered (5.4), correlations (9.3), FastSLAM beside EKF-SLAM (3.2), and the ways of a correction (6). Times
are kept apart, under "machine": they are those of whoever ran this last, and no test looks at them. "light" is a small
run of each experiment, which a test makes again to see that the file belongs to the code as it is. Finished experiments
are kept in _build/report_experiments, so that an interrupted one goes on where it was.
"""

import argparse
import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np
from slambook.report import correlations, memory, planar_runs, speed

from book.tools import layout, report_times
from book.tools.audit import number
from slamlib.evaluation.consistency import band

FILE = layout.BOOK / "chapters" / "data" / "report_experiments.json"
FOLDER = layout.BUILD / "report_experiments"
CODE = sorted((layout.BOOK / "slambook" / "report").glob("*.py"))
SEED = 22
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
    """Every experiment begins with the same seed."""
    return np.random.default_rng(SEED)


def remembered(**sizes: Any) -> dict[str, Any]:
    """Ways to remember, by name: errors, claims and NEES over 6 at each step."""
    return {
        found.name: {
            "position": _list(found.position),
            "rotation": _list(found.rotation),
            "claimed": _list(found.claimed),
            "landmarks": found.landmarks.tolist(),
            "nees": _list(found.consistency.average / memory.DOF),
            "inside": round(found.consistency.inside, 3),
            "ratio": number(found.ratio, 4),
        }
        for found in memory.compare(rng(), **sizes)
    }


def correlated(**sizes: Any) -> dict[str, Any]:
    """The table of correlations, for SLAM and for odometry alone."""
    return {
        name: {"nees": number(found.nees, 4), "dof": len(found.claimed), "rows": [_rounded(r) for r in _rows(found)]}
        for name, found in correlations.experiment(rng(), **sizes).items()
    }


def _rows(found: correlations.Compared) -> list[dict[str, Any]]:
    return [asdict(row) for row in correlations.table(found)]


def contested(**sizes: Any) -> dict[str, Any]:
    """FastSLAM by its number of particles, and EKF-SLAM."""
    return {
        found.name: {
            "position": _list(found.position),
            "map_error": number(found.map_error, 4),
            "nees": _list(found.nees.mean(0) / planar_runs.DOF),
            "inside": round(found.consistency.inside, 3),
            "typical": number(found.typical, 4),
            "effective": _list(found.effective),
            "ancestors": _list(found.ancestors),
            "drawn": round(found.drawn, 3),
        }
        for found in planar_runs.compare(rng(), **sizes)
    }


def accurate(**sizes: Any) -> dict[str, Any]:
    """The landmarks' error with one linearisation a picture, and with one for each landmark."""
    found = {name: speed.accuracy(rng(), scene=name, **sizes) for name in ("gentle", "hard")}
    return {
        name: {
            "batch": number(float(f.batch.mean())),
            "again": number(float(f.again.mean())),
            "gain": [number(v, 3) for v in f.gain],
            "ratios": [number(f.together_ratio, 4), number(f.again_ratio, 4)],
        }
        for name, f in found.items()
    }


def mapped(**sizes: Any) -> list[dict[str, Any]]:
    """Chapter 6's run by every way, without times."""
    return [{k: v for k, v in _rounded(asdict(m)).items() if k != "seconds"} for m in speed.mapping(rng(), **sizes)]


EXPERIMENTS: dict[str, Callable[..., Any]] = {
    "memory": remembered,
    "correlations": correlated,
    "fastslam": contested,
    "accuracy": accurate,
    "mapping": mapped,
}


def _list(values: Any) -> list[float | str]:
    return [number(v, 4) for v in values]


def _rounded(row: dict[str, Any]) -> dict[str, Any]:
    return {k: number(v, 4) if isinstance(v, float) else v for k, v in row.items()}


def digest() -> str:
    """Fingerprint of the sizes of all experiments."""
    return hashlib.sha256(
        json.dumps([SEED, FULL, LIGHT, report_times.LANDMARKS, report_times.SEEN]).encode()
    ).hexdigest()[:12]


def light() -> dict[str, Any]:
    """The small run of each experiment."""
    return {name: run(**LIGHT[name]) for name, run in EXPERIMENTS.items()}


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


def main() -> None:
    """Run everything, and write the file when all of it is done."""
    argparse.ArgumentParser(description="Run the experiments of chapter 22 on the report's filter.").parse_args()
    parts: dict[str, Callable[[], Any]] = {name: partial(run, **FULL[name]) for name, run in EXPERIMENTS.items()}
    parts = {"light": light, **parts, "machine": partial(report_times.machine, rng)}
    found: dict[str, Any] = {"digest": digest(), "seed": SEED, "sizes": FULL, "bands": bands()}
    found |= {name: kept(name, run) for name, run in parts.items()}
    layout.store(FILE, found)


if __name__ == "__main__":
    main()
