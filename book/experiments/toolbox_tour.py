"""`make experiments`: the Monte Carlo experiments of chapter toolbox_tour, stored as one small file of averages.

Every case is run RUNS times with the seeds of one experiment; finished runs are kept in _build/experiments, so that an
interrupted one goes on where it was. The file holds what figures and tables of the chapter need, rounded, the digest of
each preset, and the first numbers of all, by which a test sees that the file belongs to the package as it is.
Times are not stored: they belong to a machine.

Presets and cases of theory (AT_ONCE) are smoothed, too, in two sets of seeds, each run beside the filter's; the first
set begins with the seeds of the averages. Cases that are as the file has them are kept, and further runs are joined.
"""

import argparse
import hashlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import joblib
import numpy as np
from slambook.filters_compared import beside

from book.tools import layout
from slamlib.evaluation.consistency import band, rmse, share_inside
from slamlib.experiments.monte_carlo import Experiment, monte_carlo, seeds
from slamlib.experiments.presets import OF_TOOLBOX, Preset, lines, points
from slamlib.landmarks import LINES, POINTS
from slamlib.rigs.setup import Rig, SensorSetup

FILE = layout.BOOK / "chapters" / "data" / "experiments.json"
FOLDER = layout.BUILD / "experiments"
RUNS, SEED, DOF = 100, 17, 6
FIRST_RUNS, FIRST_FRAMES = 2, 12  # of each case, kept number by number
BEGINNING, SHORT = 400, 200  # frames of the presets, and of comparisons of one change at a time
AT_ONCE, SETS, SMOOTHED, FIRST_SMOOTHED = ("preset ", "theory "), (17, 18), 20, 40  # cases; seeds; runs; first frames
EVERY = 20  # frames between two stored errors
TOOLBOX = {"inverse_distance": (0.01, 0.5)}  # mean and standard deviation [1/m] in the toolbox's userDataPnt


def with_options(preset: Preset, **changes: Any) -> Preset:
    """The preset with other options."""
    return replace(preset, options=replace(preset.options, **changes))


def quiet(motion: float, pixels: float, **start: Any) -> Preset:
    """`points` with the noise of the motion scaled, that of the camera in pixels, and an uncertain start."""
    preset = with_options(points(), reproject=False)
    robot, camera = preset.rig.robots[0], preset.rig.sensors[0]
    robot = replace(robot, control_std=tuple(motion * s for s in robot.control_std), **start)
    return replace(preset, rig=Rig((robot,), (replace(camera, std=(pixels,)),)))


def with_depth(preset: Preset) -> Preset:
    """The preset with a camera that also measures depths, to 2 mm: no prior is needed, and all errors are small."""
    camera = preset.rig.sensors[0]
    camera = replace(camera, type="pinHoleDepth", std=(*camera.std * 2, 0.002))
    return with_options(replace(preset, rig=replace(preset.rig, sensors=(camera,))), points="eucPnt")


def linear() -> Preset:
    """The robot knows its heading and measures the relative positions of points: the models are linear."""
    preset = with_options(points(), points="eucPnt", reproject=False)
    robot = replace(preset.rig.robots[0], control_std=(0.005,) * 3 + (1e-4,) * 3)  # degrees; above smoothing's EXACT
    sensor = SensorSetup(type="relativePosition", std=(0.05,), image=None, parameters={}, limits={"far": 4.0})
    return replace(preset, rig=Rig((robot,), (sensor,)))


def cases() -> dict[str, Preset]:
    """All experiments by name. One batch update a frame, unless the name states otherwise."""
    base = with_options(points(), points="idpPnt", reproject=False)
    house = with_options(lines(), reproject=False)
    return {
        **{f"points {name}": with_options(base, points=name) for name in sorted(POINTS) if not POINTS[name].plane},
        **{f"lines {name}": with_options(house, lines=name) for name in sorted(LINES)},
        **theory(),
        **switches(replace(base, frames=SHORT)),
        # the first frames, for comparing the sensors; whole loops are those of points and lines
        **{f"preset {f.__name__}": replace(with_options(f(), reproject=False), frames=BEGINNING) for f in OF_TOOLBOX},
        **{f"prior {name}": with_options(base, points=name, **TOOLBOX) for name in ("idpPnt", "hmgPnt")},
    }


def theory() -> dict[str, Preset]:
    """Cases in which the filter must be consistent by theory, and cases in which it cannot be."""
    return {
        "theory linear": linear(),
        "theory small noise": with_depth(quiet(0.1, 0.1)),
        "theory small noise, one camera": quiet(0.01, 0.05),
        "theory start known to 10 cm": replace(quiet(0.01, 0.05, position_std=(0.1,)), frames=BEGINNING),
        "theory start known to 0.1 degrees": replace(quiet(0.01, 0.05, orientation_std=(0.1,)), frames=SHORT),
    }


def switches(base: Preset) -> dict[str, Preset]:
    """One change at a time."""
    sharper = replace(base, rig=replace(base.rig, sensors=(replace(base.rig.sensors[0], std=(0.3,)),)))
    return {
        "switch none": base,
        "switch prior of the toolbox": with_options(base, **TOOLBOX),
        "switch no gate": with_options(base, gate=1 - 1e-9),
        "switch oldest first": with_options(base, selection="order"),
        "switch no conversion": with_options(base, convert=False),
        "switch one after another": with_options(base, reproject=True),
        "switch 0.3 pixels": sharper,
        "switch prior, 0.3 pixels": with_options(sharper, **TOOLBOX),
    }


def digest(preset: Preset) -> str:
    """Fingerprint of a preset to seven digits: from the tenth on, fitted values depend on the machine."""
    said = json.loads(json.dumps(preset.to_dict()), parse_float=lambda number: f"{float(number):.7g}")
    return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()[:12]


def summary(preset: Preset, found: Experiment) -> dict[str, Any]:
    """What is kept of an experiment. Lengths in metres; lists by robot, then by frame."""
    runs, frames, robots = found.nees.shape
    average, limits = found.nees.mean(0), band(DOF, runs)
    half = frames // 2
    return {
        "digest": digest(preset),
        "frames": frames,
        "nees": [rounded(average[:, i], 2) for i in range(robots)],
        "inside": [round(share_inside(average[:, i], limits), 3) for i in range(robots)],
        "inside_first_half": [round(share_inside(average[:half, i], limits), 3) for i in range(robots)],
        "run_means": [rounded(np.quantile(found.nees[:, :, i].mean(1), (0.05, 0.5, 0.95)), 1) for i in range(robots)],
        "error": [rounded(rmse(found.errors[:, EVERY - 1 :: EVERY, i, None], 0), 5) for i in range(robots)],
        "sigma": [rounded(rmse(found.sigmas[:, EVERY - 1 :: EVERY, i, None], 0), 5) for i in range(robots)],
        "map_error": round(float(np.nanmedian(found.map_error)), 5),
        "landmarks": round(float(found.landmarks.mean()), 2),
        "deleted": round(float(found.deleted.mean()), 2),
        "first": [rounded(row, 3) for row in found.nees[:FIRST_RUNS, :FIRST_FRAMES, 0]],
    }


def rounded(values: Any, digits: int) -> list[float]:
    """Plain numbers for the file."""
    return [round(float(v), digits) for v in values]


def run(names: list[str], runs: int = RUNS, jobs: int = 1) -> dict[str, Any]:
    """The summaries of the named cases; finished runs are taken from the folder, and new ones put there."""
    known, found = cases(), {}
    for name in names:
        experiment = monte_carlo(known[name], runs, seed=SEED, jobs=jobs, folder=FOLDER)
        found[name] = summary(known[name], experiment)
        print(f"{name}: {found[name]['inside']} of the steps inside", flush=True)
    return found


def smoothed(preset: Preset, seed: int) -> list[list[float]]:
    """One run by the filter, and by all data at once: NEES, mean of steps and robots; position, rms and at last [m]."""
    judged = beside(preset, seed)
    rows = [(of["nees"].mean(), rmse(of["position"][:, None]), of["position"][-1]) for of in judged]
    return [rounded(row, 5) for row in rows]


def at_once(preset: Preset, before: dict[str, Any], number: int, runs: int, jobs: int = 1) -> dict[str, Any]:
    """The runs of one set of seeds, joined to those before, and of its first seed a run of a few frames."""
    own, rows = seeds(number, runs), before.get("runs", [])
    rows = rows + joblib.Parallel(n_jobs=jobs)(joblib.delayed(smoothed)(preset, seed) for seed in own[len(rows) :])
    return {"runs": rows, "first": smoothed(replace(preset, frames=FIRST_SMOOTHED), own[0])}


def asked(description: str, known: dict[str, Preset], runs: int) -> argparse.Namespace:
    """What the command's words ask for; runs: how many if they do not say it."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--runs", type=int, default=runs, help=f"beside each other, of each set (default {runs})")
    parser.add_argument("--jobs", type=int, default=2, help="runs at once (default 2)")
    parser.add_argument("--only", nargs="+", choices=list(known), help="of these cases", metavar="CASE")
    parser.add_argument("--fresh", action="store_true", help="forget what the file has: the filter has changed")
    return parser.parse_args()


def kept(known: dict[str, Preset], fresh: bool, file: Path = FILE) -> dict[str, Any]:
    """The cases that the file has as they are now; none if it is begun anew."""
    found = {} if fresh or not file.is_file() else json.loads(file.read_text("utf-8"))["cases"]
    return {name: found[name] for name, case in known.items() if found.get(name, {}).get("digest") == digest(case)}


def write(found: dict[str, Any]) -> None:
    """The file, a line for each case."""
    head = {"runs": RUNS, "seed": SEED, "sets": SETS, "dof": DOF, "band": rounded(band(DOF, RUNS), 4), "every": EVERY}
    rows = ",\n".join(f"{json.dumps(name)}: {json.dumps(found[name])}" for name in cases() if name in found)
    layout.write_whole(FILE, (json.dumps(head)[:-1] + ', "cases": {\n' + rows + "\n}}\n").encode())


def main() -> None:
    """Make the runs that the file has not yet."""
    known = cases()
    given = asked("Run the Monte Carlo experiments of chapter toolbox_tour; resumable.", known, SMOOTHED)
    found = kept(known, given.fresh)
    for name in given.only or known:
        if name not in found:
            found |= run([name], jobs=given.jobs)
            write(found)
        if not name.startswith(AT_ONCE):
            continue
        sets = found[name].setdefault("at once", {})
        for number in SETS:
            before = sets.get(str(number), {})
            if len(before.get("runs", [])) < given.runs:
                sets[str(number)] = at_once(known[name], before, number, given.runs, given.jobs)
                write(found)
                print(name, number, np.mean(sets[str(number)]["runs"], axis=0).round(4).tolist(), flush=True)
    print(f"{FILE.relative_to(layout.ROOT)}: {len(found)} cases of {RUNS} runs")


if __name__ == "__main__":
    main()
