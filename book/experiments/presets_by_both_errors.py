"""`make presets-by-both-errors`: NEES of the linear and of the invariant error, of every case of `consistency`.

The same presets, filters and seeds as there, and the first runs of each of its sets; by the ordinary filter, and by the
one that keeps the invariant error. The linear NEES must be the one that is stored there, to the last digit, or nothing
is written. Stored: of each case the number of runs of a set, and by filter the mean NEES of each run, set by set, of
both errors. Further runs are joined to those that the file has. Chapter observability.
"""

import argparse
import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from slambook.filters_compared import FILTERS, nees_by_error

from book.experiments import consistency, stored
from book.tools import layout
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.experiments.monte_carlo import seeds
from slamlib.experiments.presets import Preset

FILE = layout.BOOK / "chapters" / "data" / "presets_by_both_errors.json"
RUNS, ROUND, DIGITS = 20, 10, 3  # of a set; runs between two writings; decimal places, as `consistency` has them
SEEDS = consistency.SEEDS
Sets = list[list[float]]


def filters(case: str) -> tuple[str, ...]:
    """The filters that are compared: those of `consistency` without a reference."""
    return tuple(name for name in consistency.filters(case) if name in FILTERS[:2])


def means(preset: Preset, seed: int, name: str) -> dict[str, float]:
    """Mean NEES of one run, over steps and robots, of each of ERRORS."""
    return {error: round(float(nees.mean()), DIGITS) for error, nees in nees_by_error(preset, seed, name).items()}


def joined(case: str, name: str, before: dict[str, Sets], runs: int) -> dict[str, Sets]:
    """The runs of a filter by set and error: those before, and as many more as are missing."""
    preset, known = consistency.cases()[case], stored.kept(consistency.FILE)["cases"][case][name]
    found: dict[str, Sets] = {error: [] for error in ERRORS}
    for i, number in enumerate(SEEDS):
        had: dict[str, Sequence[float]] = {error: before[error][i] if before else [] for error in ERRORS}
        made = [means(preset, seed, name) for seed in seeds(number, runs)[len(had["linear"]) :]]
        for error, sets in found.items():
            sets.append([*had[error], *(run[error] for run in made)])
        if found["linear"][i] != (there := known[str(number)]["own"][: len(found["linear"][i])]):
            raise ValueError(f"{case}, {name}, set {number}: {found['linear'][i]} now, {there} in {consistency.FILE}")
    return found


def extended(case: str, before: dict[str, Any], runs: int) -> dict[str, Any]:
    """What the file keeps of a case."""
    return {"runs": runs, **{name: joined(case, name, before.get(name, {}), runs) for name in filters(case)}}


def write(found: dict[str, Any]) -> None:
    """The file, a line for each case."""
    rows = ",\n".join(f"{json.dumps(name)}: {json.dumps(found[name])}" for name in consistency.cases() if name in found)
    layout.write_whole(FILE, f"{{{rows}}}\n".encode())


def main(words: Sequence[str] | None = None) -> None:
    """Make the runs that the file has not yet, ROUND of each filter and set at a time, and join them to it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=RUNS, help=f"of each set (default {RUNS})")
    parser.add_argument("--only", nargs="+", choices=list(consistency.cases()), metavar="CASE", help="of these cases")
    parser.add_argument("--fresh", action="store_true", help="make the runs of these cases anew")
    given = parser.parse_args(words)
    found, chosen = stored.kept(FILE), given.only or list(consistency.cases())
    for case in chosen if given.fresh else ():
        found.pop(case, None)
    for end in [*range(ROUND, given.runs, ROUND), given.runs]:
        for case in chosen:
            if (before := found.get(case, {"runs": 0}))["runs"] < end:
                found[case] = extended(case, before, end)
                write(found)
                said = {n: {e: np.mean(found[case][n][e]).round(2) for e in ERRORS} for n in filters(case)}
                print(case, end, said, flush=True)


if __name__ == "__main__":
    main()
