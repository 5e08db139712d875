"""The same experiment many times, in parallel: is the filter consistent?

Every run has its own random stream, derived from the experiment's seed and its number, so that the results are the
same for any number of workers, on one machine or many, and in any order. With a folder, each finished run is a file
there, written by the caller as it comes in, and an interrupted experiment continues.
"""

import hashlib
import json
import warnings
from collections.abc import Generator
from contextlib import closing
from dataclasses import dataclass, fields, replace
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError, entry, optional
from slamlib.evaluation.consistency import Consistency
from slamlib.experiments.cluster import on_cluster
from slamlib.experiments.presets import Preset
from slamlib.experiments.progress import progress
from slamlib.experiments.runs import NEES, Run
from slamlib.manifolds import Array
from slamlib.plain_data.files import read_archive, write_archive


@dataclass(frozen=True, eq=False)
class Experiment:
    """Many runs of one preset: per run and frame (k, n), and for each of r robots.

    nees, nees_invariant (k, n, r), of nees_dof (k, n, r) degrees of freedom: of the linear error, and of the invariant
    one, whose covariance a filter with error="world" keeps; errors, sigmas (k, n, r): position errors [m] and their
    standard deviations by the filter; nis, nis_dof (k, n). landmarks, initialized, deleted (k,); seconds (k,):
    processor time, median of a frame; map_error (k,): median distance [m] of the map's landmarks from the truth.
    """

    preset: Preset
    nees: Array
    nees_invariant: Array
    nees_dof: Array
    errors: Array
    sigmas: Array
    nis: Array
    nis_dof: Array
    landmarks: Array
    initialized: Array
    deleted: Array
    seconds: Array
    map_error: Array

    def consistency(self, robot: int = 0, error: str = "linear") -> Consistency:
        """NEES of a robot's pose, averaged over the runs at each frame, with its band; error: "linear" or "invariant".

        Frames in which more of the pose is known exactly than in others, as at the start, are left out.
        """
        found = getattr(self, entry("error", error, NEES))
        nees, ranks = found[:, :, robot], self.nees_dof[:, :, robot]
        dof = int(ranks.max())
        return Consistency.of(nees[:, (ranks == dof).all(0)], dof, name=f"NEES, {error} error")


FORMAT, VERSION, OLD = "slamlib finished run", 3, "remove it, and the run is made anew"
NAMES = [f.name for f in fields(Experiment)[1:]]
Row = dict[str, Any]  # of one run: its numbers and arrays, by these names


def monte_carlo(
    preset: Preset,
    runs: int,
    *,
    seed: int = 0,
    jobs: int = 1,
    scheduler: object = None,
    wait: float = 30.0,
    folder: str | Path | None = None,
) -> Experiment:
    """Run a preset `runs` times, independently.

    jobs: how many at once on this machine. scheduler: the address of a Dask scheduler, whose workers make the runs
    instead, or a Dask cluster; wait [s]: at most, for it and for a worker. folder: where finished runs are kept, on the
    caller's machine; it is made, and holds one file per run, named by a digest of the preset, so that experiments
    cannot be confused. The same call goes on after an interruption. Raises SlamlibError.

        monte_carlo(presets.points(), 1000, scheduler="tcp://host:8786", folder="finished").consistency()
    """
    if runs < 1:
        raise SlamlibError(f"monte_carlo: at least one run, got {runs}")
    if jobs != 1 and scheduler is not None:
        raise SlamlibError("monte_carlo: jobs are of this machine, and a scheduler has its own workers: give one")
    own, paths = seeds(seed, runs), {}
    if folder is not None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        plain = json.dumps(replace(preset, seed=0).to_dict(), sort_keys=True).encode()
        start = f"{preset.name}-{hashlib.sha256(plain).hexdigest()[:12]}"
        paths = {s: Path(folder) / f"{start}-{s}.npz" for s in own}
    rows = {s: read_archive(path, FORMAT, VERSION, OLD)[1] for s, path in paths.items() if path.is_file()}
    finished, left = list(rows.items()), [s for s in own if s not in rows]
    with closing(_made(preset, left, jobs, scheduler, wait)) as made:  # whatever happens here, no run is left behind
        for s, row in progress(chain(finished, made), runs, f"{preset.name}, {runs} runs"):
            if s not in rows and s in paths:
                write_archive(paths[s], FORMAT, VERSION, {}, row)
            rows[s] = row
    return Experiment(preset, **{name: np.array([rows[s][name] for s in own]) for name in NAMES})


def _made(
    preset: Preset, left: list[int], jobs: int, scheduler: object, wait: float
) -> Generator[tuple[int, Row], None, None]:
    """Make the runs of these seeds, here or elsewhere; yield each as soon as it is finished."""
    one = partial(run_once, preset)
    if not left:
        return
    if scheduler is not None:
        yield from on_cluster(one, left, scheduler, wait)
    elif jobs != 1:
        joblib = optional("joblib", "for several runs at once (jobs=1 does without)", "experiments")
        parallel = joblib.Parallel(n_jobs=jobs, batch_size=1, return_as="generator_unordered")
        found = parallel(map(joblib.delayed(one), left))
        try:
            for made in found:  # noqa: UP028  # `yield from` would close it out of reach of the filter below
                yield made
        finally:
            with warnings.catch_warnings():  # whoever stops it knows that runs are not finished
                warnings.filterwarnings("ignore", r"(?s).*tasks (have been|which were)", UserWarning)
                found.close()
    else:
        yield from map(one, left)


def seeds(seed: int, runs: int) -> list[int]:
    """The seeds of so many independent runs; more runs begin with the same ones."""
    return [int(s.generate_state(1, np.uint64)[0]) >> 1 for s in np.random.SeedSequence(seed).spawn(runs)]


def run_once(preset: Preset, seed: int) -> tuple[int, Row]:
    """The seed of one run, and its row: each number by its name in Experiment."""
    try:
        result = Run(preset, seed).finish()
    except SlamlibError as error:
        raise SlamlibError(f"the run of seed {seed} failed: {error}") from error
    except Exception as error:
        error.add_note(f"in the run of seed {seed}")
        raise
    away = np.concatenate([*result.map_errors.values()])
    away = away[np.isfinite(away)]
    return seed, {
        name: getattr(result, name)
        for name in ("nees", "nees_invariant", "nees_dof", "nis", "nis_dof", "initialized", "deleted")
    } | {
        "errors": np.linalg.norm(result.errors[:, :, :3], axis=-1),
        "sigmas": np.linalg.norm(result.sigmas[:, :, :3], axis=-1),
        "landmarks": result.landmarks[-1],
        "seconds": np.median(result.seconds),
        "map_error": np.median(away) if len(away) else np.nan,
    }
