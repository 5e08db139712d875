"""`make invariant-nees`: NEES of the linear and of the invariant error, for starts whose orientation is vague.

In the plane the lap of chapter slam_in_five_minutes, in space a lap among Euclidean points by range and bearing, as in
`make experiments`; the noise is in the truth. Stored: of each start, each filter and two sets of seeds the mean NEES of
each run, of both errors, from the sixth frame on; and of the first run that of some frames, by which a test sees that
the file belongs to the package as it is. Chapter observability.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from slambook.filters_compared import ALL_DATA, FILTERS, nees_by_error

from book.experiments import consistency, stored
from book.tools import layout
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.experiments.monte_carlo import seeds
from slamlib.experiments.presets import Preset, five_minutes
from slamlib.manifolds import Array

FILE = layout.BOOK / "chapters" / "data" / "invariant_nees.json"
RUNS, SEEDS, JUDGED = 40, (17, 18), slice(5, None)
FIRST_FRAMES = 12  # of the first run, kept number by number
STARTS = {"plane": (0.1, 5.0, 20.0), "space": (0.1, 5.0, 20.0)}  # standard deviation of the orientation [deg]
BY_ALL = "space, 5 degrees"  # by every filter, as in `consistency`


def known_to(preset: Preset, *degrees: float) -> Preset:
    """The preset with a start whose orientation is known to so many degrees about each axis."""
    robot = replace(preset.rig.robots[0], orientation_std=degrees)
    return replace(preset, rig=replace(preset.rig, robots=(robot,)))


def cases() -> dict[str, Preset]:
    """All presets by name."""
    space = consistency.cases()[consistency.START]
    flat = {f"plane, {std:g} degrees": known_to(five_minutes(), 0.0, 0.0, std) for std in STARTS["plane"]}
    return flat | {f"space, {std:g} degrees": known_to(space, std, std, std) for std in STARTS["space"]}


def filters(case: str) -> tuple[str, ...]:
    """The filters that are compared."""
    return (*FILTERS, ALL_DATA) if case == BY_ALL else FILTERS[:2]


def both(preset: Preset, seed: int, name: str) -> dict[str, Array]:
    """NEES (n,) of the first robot's pose in one run by this filter, of each of ERRORS."""
    return {error: nees[:, 0] for error, nees in nees_by_error(preset, seed, name).items()}


def first_frames(case: str, name: str) -> dict[str, Any]:
    """NEES of the first run, of each of ERRORS, number by number."""
    preset = replace(cases()[case], frames=FIRST_FRAMES)
    return {error: nees.tolist() for error, nees in both(preset, seeds(SEEDS[0], 1)[0], name).items()}


def row(case: str, name: str) -> dict[str, Any]:
    """Mean NEES of each run by the two sets, of each of ERRORS; and of the first run the first frames."""
    preset = cases()[case]
    found: dict[str, Any] = {error: [] for error in ERRORS}
    for number in SEEDS:
        runs = [both(preset, seed, name) for seed in seeds(number, RUNS)]
        for error, sets in found.items():
            sets.append([run[error][JUDGED].mean() for run in runs])
    print(case, name, {e: [round(np.mean(s), 2) for s in sets] for e, sets in found.items()}, flush=True)
    return stored.plain(found | {"first": first_frames(case, name)})


def rows(case: str) -> dict[str, Any]:
    """One start by its filters."""
    return {name: row(case, name) for name in filters(case)}


PARTS: dict[str, Callable[[], Any]] = {case: partial(rows, case) for case in cases()}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__, resumable=True)
