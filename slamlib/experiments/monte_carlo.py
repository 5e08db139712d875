"""The same experiment many times, in parallel: is the filter consistent?

Every run has its own random stream, derived from the experiment's seed and its number, so that the results are the
same for any number of workers and in any order. With a folder, each finished run is a file there, and an interrupted
experiment continues. Parallel runs use joblib: to outgrow one machine, make the same call inside
`joblib.parallel_config(backend="dask")` with a Dask client.
"""

import hashlib
import json
from dataclasses import dataclass, fields, replace
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.data.files import read_archive, write_archive
from slamlib.errors import SlamlibError, optional
from slamlib.evaluation.consistency import Consistency
from slamlib.experiments.presets import Preset
from slamlib.experiments.progress import progress
from slamlib.experiments.runs import Run
from slamlib.manifolds import Array


@dataclass(frozen=True, eq=False)
class Experiment:
    """Many runs of one preset: per run and frame (k, n), and for each of r robots.

    nees (k, n, r), 6 degrees of freedom; errors, sigmas (k, n, r): position errors [m] and their standard deviations by
    the filter; nis, nis_dof (k, n). landmarks, initialized, deleted (k,); seconds (k,): processor time, median of a
    frame; map_error (k,): median distance [m] of the map's landmarks from the truth.
    """

    preset: Preset
    nees: Array
    errors: Array
    sigmas: Array
    nis: Array
    nis_dof: Array
    landmarks: Array
    initialized: Array
    deleted: Array
    seconds: Array
    map_error: Array

    def consistency(self, robot: int = 0) -> Consistency:
        """NEES of a robot's pose, averaged over the runs at each frame, with its band."""
        return Consistency.of(self.nees[:, :, robot], 6)


FORMAT = "slamlib finished run"
NAMES = [f.name for f in fields(Experiment)[1:]]


def monte_carlo(
    preset: Preset, runs: int, *, seed: int = 0, jobs: int | None = 1, folder: str | Path | None = None
) -> Experiment:
    """Run a preset `runs` times, independently.

    jobs: how many in parallel; None: as the caller configured joblib. folder: where finished runs are kept; it is
    made, and holds one file per run, named by a digest of the preset, so that experiments cannot be confused.
    """
    if runs < 1:
        raise SlamlibError(f"monte_carlo: at least one run, got {runs}")
    own = seeds(seed, runs)
    paths: list[Path | None] = [None] * runs
    if folder is not None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        plain = json.dumps(replace(preset, seed=0).to_dict(), sort_keys=True).encode()
        start = f"{preset.name}-{hashlib.sha256(plain).hexdigest()[:12]}"
        paths = [Path(folder) / f"{start}-{s}.npz" for s in own]
    found: Any = map(run_once, repeat(preset), own, paths)
    if jobs != 1:
        joblib = optional("joblib", "for several runs at once (jobs=1 does without)", "experiments")
        parallel = joblib.Parallel(n_jobs=jobs, return_as="generator")
        found = parallel(map(joblib.delayed(run_once), repeat(preset), own, paths))
    rows = list(progress(found, runs, f"{preset.name}, {runs} runs"))
    return Experiment(preset, **{name: np.array([row[name] for row in rows]) for name in NAMES})


def seeds(seed: int, runs: int) -> list[int]:
    """The seeds of so many independent runs; more runs begin with the same ones."""
    return [int(s.generate_state(1, np.uint64)[0]) >> 1 for s in np.random.SeedSequence(seed).spawn(runs)]


def run_once(preset: Preset, seed: int, path: Path | None = None) -> dict[str, Any]:
    """One run's row, each number by its name in Experiment, from its file if there is one."""
    if path and path.is_file():
        return read_archive(path, FORMAT, 1)[1]
    result = Run(preset, seed).finish()
    away = np.concatenate([*result.map_errors.values()])
    away = away[np.isfinite(away)]
    row = {name: getattr(result, name) for name in ("nees", "nis", "nis_dof", "initialized", "deleted")} | {
        "errors": np.linalg.norm(result.errors[:, :, :3], axis=-1),
        "sigmas": np.linalg.norm(result.sigmas[:, :, :3], axis=-1),
        "landmarks": result.landmarks[-1],
        "seconds": np.median(result.seconds),
        "map_error": np.median(away) if len(away) else np.nan,
    }
    if path:
        write_archive(path, FORMAT, 1, {}, row)
    return row
