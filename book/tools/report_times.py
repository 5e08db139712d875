"""Times of the ways of a correction, for `make report-experiments`: those of the machine, never tested."""

from collections.abc import Callable
from typing import Any

import numpy as np
from slambook.report import mrpt, planar_runs, speed
from slambook.report.updates import naive, problem

from book.tools.audit import number
from slamlib.experiments.progress import progress

Rng = Callable[[], np.random.Generator]
LANDMARKS = 8, 15, 31, 64, 98, 165, 231, 331  # states of 30 to 999 numbers
REPEATS = 3
PARTICLES = 0, 10, 30, 100, 300, 1000
SEEN = {"3 landmarks": 3, "20 landmarks": 20, "all landmarks": None}


def machine(rng: Rng) -> dict[str, Any]:
    """Times of the ways of a correction, and of FastSLAM's steps; rng: gives a new generator with the same seed."""
    found: dict[str, Any] = {name: times(rng(), name, seen) for name, seen in SEEN.items()}
    found["run of 92 landmarks"] = {m.method: number(m.seconds, 3) for m in speed.mapping(rng())}
    racers = planar_runs.compare(rng(), runs=2, steps=40, particles=PARTICLES)
    found["FastSLAM"] = {racer.name: number(racer.seconds, 3) for racer in racers}
    if mrpt.available():
        found["MRPT"] = elsewhere(rng)
    return found


def times(rng: np.random.Generator, name: str, seen: int | None) -> dict[str, Any]:
    """Times and multiplications by way over the sizes of the state, and at which of them the quicker one changes.

    seen: landmarks in a look; None: all.
    """
    rows = list(progress(speed.timings(rng, sizes(seen), REPEATS), len(LANDMARKS), f"times, {name}"))
    return {
        "sizes": [row.size for row in rows],
        "seconds": {way: [number(row.seconds[way], 3) for row in rows] for way in rows[0].seconds},
        "multiplications": {way: [row.multiplications[way] for row in rows] for way in rows[0].multiplications},
        "crossings": [round(n) for n in speed.crossing(rows, "number by number", "whole matrices")],
    }


def sizes(seen: int | None) -> list[tuple[int, int]]:
    """Landmarks, and how many of them are seen: at most so many, or all."""
    return [(n, min(n, seen or n)) for n in LANDMARKS]


def elsewhere(rng: Rng) -> dict[str, Any]:
    """The same by MRPT: seconds by method, and by how much the state is off, relative to the correction."""
    found: dict[str, Any] = {}
    with mrpt.compiled() as program:
        for name in ("3 landmarks", "20 landmarks"):
            given = [problem(rng(), *size) for size in sizes(SEEN[name])]
            runs = [mrpt.run_update(program, p, REPEATS) for p in progress(given, len(given), f"MRPT, {name}")]
            right = [naive(p)()[0] for p in given]
            found[name] = {
                method: {
                    "seconds": [number(run[method].seconds, 3) for run in runs],
                    "off": [
                        number(float(np.linalg.norm(run[method].state[0] - x) / np.linalg.norm(x - p.x)), 3)
                        for run, x, p in zip(runs, right, given, strict=True)
                    ],
                }
                for method in runs[0]
            }
    return found
