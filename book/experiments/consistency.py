"""The second half of `make experiments`: every parametrization by the filters of chapter observability, and the oracle.

Two sets of seeds. The file keeps the mean of each run and the averages at each step, so that further runs are joined to
those that it has: an interrupted experiment goes on where it was, and a longer one begins with a shorter one.
Noise is in the truth: the odometry that the filter is told is what was commanded. One batch update a frame.
"""

import itertools
import json
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import joblib
import numpy as np
from slambook.filters_compared import (
    ALL_DATA,
    FILTERS,
    LATER,
    SECOND_ORDER,
    WITH_ANCHORS,
    Verdict,
    known_to,
    run,
    stacked,
)

from book.experiments.toolbox_tour import asked, digest, kept, rounded, with_options
from book.tools import layout
from slamlib.experiments.monte_carlo import seeds
from slamlib.experiments.presets import PRESETS, Preset, lines, points
from slamlib.landmarks import LINES, POINTS
from slamlib.manifolds import Array

FILE = layout.BOOK / "chapters" / "data" / "consistency.json"
RUNS, SEEDS, ROUND = 100, (17, 18), 10
CALIBRATED = "self_calibration"
LARGE = ("two_robots", "omni", "stereo", "points_and_lines", CALIBRATED)
# One truth of these is many states, and none of them belongs to the estimate.
WITHOUT_ORACLE = ("hmgPnt", "ahmLin", "hmgLin", "idpLin", "points_and_lines")
BIASED = "points_and_lines"  # in scale
START = "start known to 5 degrees"
ONE_CAMERA, BY_CONTROL = "idpPnt", "idpPnt, noise in the control"
# Plücker lines whose prior is as wide as lines are near: 1 / distance, where the toolbox's second number has 1 / m.
NARROW, PRIOR = ", narrow prior", ((0.1, 0.0), (0.25, 0.25))
# How well the second camera's pose is known at first, as shares of what the preset has; 0: exactly.
LEARNED, SHARES = "extrinsics x ", (1.0, 0.5, 0.25, 0.0)
ANCHORED = tuple(name for name, kind in {**POINTS, **LINES}.items() if kind.anchor)
FIRST_FRAMES = 12  # of the first run, kept number by number


def by_range_and_bearing(preset: Preset) -> Preset:
    """Euclidean points by a sensor that measures them whole: 10 cm in range, half a degree in each angle."""
    rig = preset.rig
    sensor = replace(
        rig.sensors[0],
        type="rangeBearing",
        std=(0.1, np.radians(0.5), np.radians(0.5)),
        image=None,
        parameters={},
        limits={"yaw": np.pi / 4, "pitch": np.pi / 4},
    )
    return with_options(replace(preset, rig=replace(rig, sensors=(sensor,))), points="eucPnt")


def unsure_start(preset: Preset) -> Preset:
    """The start's orientation is known to 5 degrees."""
    robot = replace(preset.rig.robots[0], orientation_std=(5.0,) * 3)
    return replace(preset, rig=replace(preset.rig, robots=(robot,)), frames=120)


def cases() -> dict[str, Preset]:
    """All presets by name."""
    base, house = (replace(with_options(f(), reproject=False), noise_in="truth") for f in (points, lines))
    euclidean = by_range_and_bearing(base)
    large = {n: replace(with_options(PRESETS[n](), reproject=False), noise_in="truth") for n in LARGE}
    return {
        **{
            name: with_options(base, points=name)
            for name in sorted(POINTS)
            if name != "eucPnt" and not POINTS[name].plane
        },
        "eucPnt": euclidean,
        **{name: with_options(house, lines=name) for name in sorted(LINES)},
        **{name + NARROW: with_options(house, lines=name, line_priors={name: PRIOR}) for name in ("aplLin", "plkLin")},
        START: unsure_start(euclidean),
        BY_CONTROL: replace(with_options(base, points=ONE_CAMERA), noise_in="control"),
        **large,
        **{f"{LEARNED}{share:g}": replace(known_to(large[CALIBRATED], share), frames=60) for share in SHARES},
    }


def filters(case: str) -> tuple[str, ...]:
    """The filters that are compared. The oracle needs extrinsics that are given, and one true state a landmark."""
    if case.startswith(LEARNED):
        return (FILTERS[1], *[ALL_DATA] * (case == f"{LEARNED}1"))
    if case == CALIBRATED:
        return (*FILTERS[:2], LATER, SECOND_ORDER)
    if case == BIASED:
        return (*FILTERS[:2], SECOND_ORDER)
    oracle = FILTERS[2:] if case not in WITHOUT_ORACLE else ()
    at_once = case not in LARGE and not case.endswith(NARROW)  # of the large ones chapter toolbox_tour has them
    return (*FILTERS[:2], *oracle, *[WITH_ANCHORS] * (case in ANCHORED), *[ALL_DATA] * at_once)


def joined(case: str, rows: Sequence[dict[str, Array]], before: dict[str, Any] | None) -> dict[str, Any]:
    """What the file keeps of the runs of one filter, joined to what it kept before.

    Numbers of a table; own: mean NEES of each run; position: its root mean square error [m], unless runs before it were
    made without; average: NEES at each step, by robot; first: of the first run. For START each run's heading at the
    end, error and claim [deg]; for BIASED its error away from the start, averaged over the steps, the claim [m], and
    the mean NEES of the rest.
    """
    verdict = Verdict.of(stacked(rows, "nees"))
    position = np.sqrt((stacked(rows, "position") ** 2).mean(1))
    columns = {"own": rounded(verdict.own, 3), "position": rounded(position, 5)}
    if case == START:
        error, claim = np.degrees(stacked(rows, "heading")[:, -1]).T
        columns |= {"heading": rounded(error, 4), "claim": rounded(claim, 4)}
    if case == BIASED:
        scale, rest = stacked(rows, "scale"), np.nanmean(stacked(rows, "rest"), axis=1)
        claim = np.sqrt((scale[..., 1] ** 2).mean(1))
        columns |= {"away": rounded(scale[..., 0].mean(1), 4), "claim": rounded(claim, 4), "rest": rounded(rest, 2)}
    first = rounded(rows[0]["nees"][:FIRST_FRAMES, 0], 3)
    if before:
        verdict = Verdict(np.array(before["own"]), np.array(before["average"]).T).joined(verdict)
        columns = {name: before[name] + values for name, values in columns.items() if name in before}
        first = before["first"]
    average = [rounded(robot, 2) for robot in verdict.average.T]
    said = Verdict(np.array(columns["own"]), np.array(average).T).numbers()  # of what is written, not of more digits
    numbers = {name: round(value, 3) for name, value in said.items()}
    return {"runs": len(verdict.own), **numbers, **columns, "average": average, "first": first}


def write(found: dict[str, dict[str, Any]]) -> None:
    """The file, a line for each case."""
    text = ",\n".join(f"{json.dumps(name)}: {json.dumps(case, separators=(',', ':'))}" for name, case in found.items())
    layout.write_whole(FILE, f'{{"seeds": {list(SEEDS)}, "cases": {{\n{text}\n}}}}\n'.encode())


def main() -> None:
    """Make the runs that the file has not yet, ROUND of each filter at a time, and join them to it."""
    known = cases()
    given = asked("Run the experiments of chapter observability; resumable.", known, RUNS)
    parallel, ready = joblib.Parallel(n_jobs=given.jobs), kept(known, given.fresh, FILE)
    found = {name: ready.get(name, {"digest": digest(case)}) for name, case in known.items()}
    chosen = {case: preset for case, preset in known.items() if case in (given.only or found)}
    for end in [*range(ROUND, given.runs, ROUND), given.runs]:
        for case, number in itertools.product(chosen, SEEDS):
            for name in filters(case):
                sets = found[case].setdefault(name, {})
                before = sets.get(str(number))
                missing = seeds(number, end)[before["runs"] if before else 0 :]
                if missing:
                    rows = parallel(joblib.delayed(run)(chosen[case], seed, name) for seed in missing)
                    sets[str(number)] = said = joined(case, rows, before)
                    write(found)
                    print(case, name, number, {k: said[k] for k in ("runs", "mean", "error", "inside")}, flush=True)
    print(f"{FILE.relative_to(layout.ROOT)}: {len(found)} cases")


if __name__ == "__main__":
    main()
