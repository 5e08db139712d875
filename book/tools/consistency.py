"""The second half of `make experiments`: every parametrization by the filters of chapter observability, and the oracle.

Two sets of seeds; finished runs are kept in _build/consistency, so that an interrupted experiment goes on where it was.
Noise is in the truth: the odometry that the filter is told is what was commanded. One batch update a frame.
"""

import argparse
import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import joblib
import numpy as np
from slambook.filters_compared import ALL_DATA, FILTERS, Verdict, away, run, stacked

from book.tools import layout
from book.tools.experiments import digest, rounded, with_options
from slamlib.data.files import read_archive, write_archive
from slamlib.experiments.presets import PRESETS, Preset, lines, points
from slamlib.landmarks import LINES, POINTS
from slamlib.manifolds import Array

FILE = layout.BOOK / "chapters" / "data" / "consistency.json"
FOLDER = layout.BUILD / "consistency"
RUNS, SEEDS = 16, (17, 18)
FEW, LARGE = 8, ("two_robots", "omni", "stereo", "points_and_lines", "self_calibration")  # runs of the slowest presets
# One truth of these is many states, and none of them belongs to the estimate.
WITHOUT_ORACLE = ("hmgPnt", "ahmLin", "hmgLin", "idpLin", "points_and_lines")
BIASED = "points_and_lines"  # in scale
ONE_CAMERA, BY_CONTROL = "idpPnt", "idpPnt, noise in the control"  # by all data at once, too
FIRST_FRAMES = 12  # of the first run, kept number by number
EVERY = 10  # frames between two stored averages
FORMAT = "consistency of one run"


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
    return {
        **{name: with_options(base, points=name) for name in sorted(POINTS) if name != "eucPnt"},
        "eucPnt": euclidean,
        **{name: with_options(house, lines=name) for name in sorted(LINES)},
        "start known to 5 degrees": unsure_start(euclidean),
        BY_CONTROL: replace(with_options(base, points=ONE_CAMERA), noise_in="control"),
        **{n: replace(with_options(PRESETS[n](), reproject=False), noise_in="truth") for n in LARGE},
    }


def filters(case: str, preset: Preset) -> tuple[str, ...]:
    """The filters that are compared. The oracle needs extrinsics that are given, and one true state a landmark."""
    if case in WITHOUT_ORACLE or any(sensor.estimated for sensor in preset.rig.sensors):
        return FILTERS[:2]
    return (*FILTERS, ALL_DATA) if case in (ONE_CAMERA, BY_CONTROL) else FILTERS


def one(preset: Preset, seed: int, name: str, what: Callable[..., dict[str, Array]] = run) -> dict[str, Array]:
    """One run, or what is asked of it, from its file if there is one."""
    asked = [replace(preset, seed=0).to_dict(), name] + ([] if what is run else [what.__name__])
    key = hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()
    path = FOLDER / f"{key[:16]}-{seed}.npz"
    if path.is_file():
        return read_archive(path, FORMAT, 1)[1]
    row = what(preset, seed, name)
    write_archive(path, FORMAT, 1, {}, row)
    return row


def seeds(number: int, case: str) -> list[int]:
    """The seeds of one set for a case."""
    runs = FEW if case in LARGE else RUNS
    return [int(s.generate_state(1, np.uint64)[0]) >> 1 for s in np.random.SeedSequence(number).spawn(runs)]


def summary(rows: Sequence[dict[str, Array]]) -> dict[str, Any]:
    """What is kept of the runs of one filter; headings in degrees, root mean squares over the runs at the last step."""
    found = Verdict.of(stacked(rows, "nees"))
    last = np.degrees(np.sqrt((stacked(rows, "heading")[:, -1, 0] ** 2).mean(0)))
    return {
        **{name: round(getattr(found, name), 3) for name in ("mean", "error", "median", "failed", "inside")},
        "heading": rounded(last, 4),
        "average": rounded(found.average[EVERY - 1 :: EVERY], 2),
        "first": rounded(rows[0]["nees"][:FIRST_FRAMES, 0], 3),
    }


def of_scale(rows: Sequence[dict[str, Array]]) -> dict[str, Any]:
    """What is kept of `away`: mean and standard error over the runs of the error and of the others' NEES; the claim."""
    error, others = stacked(rows, "away")[..., 0].mean(1), np.nanmean(stacked(rows, "others"), axis=1)
    spread = [(v.mean(), v.std(ddof=1) / np.sqrt(len(v))) for v in (error, others)]
    claim = np.sqrt((stacked(rows, "away")[..., 1] ** 2).mean())
    return {"away": rounded(spread[0], 4), "claim": round(float(claim), 4), "others": rounded(spread[1], 2)}


def main() -> None:
    """Run everything, and write the file when all of it is done."""
    parser = argparse.ArgumentParser(description="Run the experiments of chapter observability.")
    parser.add_argument("--jobs", type=int, default=2, help="runs at once (default 2)")
    parser.add_argument("--sets", type=int, default=len(SEEDS), help=f"sets of seeds (default {len(SEEDS)})")
    given = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    parallel = joblib.Parallel(n_jobs=given.jobs)
    found: dict[str, dict[str, Any]] = {}
    for number in SEEDS[: given.sets]:
        for case, preset in cases().items():
            for name in filters(case, preset):
                rows = parallel(joblib.delayed(one)(preset, seed, name) for seed in seeds(number, case))
                kept = found.setdefault(case, {"digest": digest(preset), "frames": preset.frames})
                kept.setdefault(name, {})[str(number)] = said = summary(rows)
                said["runs"] = len(rows)
                print(case, name, number, {k: said[k] for k in ("mean", "error", "failed", "inside")}, flush=True)
        rows = parallel(joblib.delayed(one)(cases()[BIASED], s, "world", away) for s in seeds(number, BIASED))
        found[BIASED].setdefault("scale", {})[str(number)] = of_scale(rows)
    head = {"seeds": SEEDS[: given.sets], "every": EVERY}
    text = ",\n".join(f"{json.dumps(case)}: {json.dumps(kept)}" for case, kept in found.items())
    layout.write_whole(FILE, (json.dumps(head)[:-1] + ', "cases": {\n' + text + "\n}}\n").encode())
    print(f"wrote {FILE.relative_to(layout.ROOT)}: {len(found)} cases")


if __name__ == "__main__":
    main()
