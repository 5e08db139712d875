"""Run a preset frame by frame, and collect what an evaluation needs; a run can be saved at any frame and resumed."""

import time
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError, UnknownNameError, entry
from slamlib.evaluation.comparison import magnitudes
from slamlib.evaluation.pose_errors import invariant_error, pose_error, pose_nees
from slamlib.experiments.presets import Preset
from slamlib.experiments.presets import preset as named
from slamlib.manifolds import Array
from slamlib.observation import FAMILIES
from slamlib.plain_data.fields import read_fields
from slamlib.plain_data.files import check_columns, complete
from slamlib.plain_data.tables import html_table
from slamlib.records.inputs import Frame, Truth, World
from slamlib.records.snapshots import Snapshot
from slamlib.slam import Options, Slam, StepReport
from slamlib.slam.snapshot import robot_view

COLUMNS = (
    "errors", "sigmas", "nees", "nees_invariant", "nees_dof", "nis", "nis_dof", "landmarks", "size", "seconds",
)  # fmt: skip
NEES = {"linear": "nees", "invariant": "nees_invariant"}  # columns by the error of a pose: `pose_errors`


@dataclass(frozen=True, eq=False)
class Result:
    """Results of a run: per frame (n,), and for each of r robots.

    errors (n, r, 6): true pose minus estimate, in the tangent space; sigmas (n, r, 6): their estimated standard
    deviations; nees (n, r), of nees_dof (n, r) degrees of freedom, the rank of the pose's covariance. nees_invariant
    (n, r): of as many, of the invariant error, whose covariance a filter with error="world" keeps.
    extrinsics (s, 2, 6): errors and deviations of the sensors' at the end; extrinsics_nees (s,) their NEES, and
    extrinsics_nees_invariant (s,) that of the invariant error, of extrinsics_dof (s,); zero where they are given.
    nis (n,), of nis_dof (n,) degrees of freedom: of all inliers. landmarks, size, seconds (n,): of the map, of the
    state, and of the processor. initialized, deleted: in the whole run. map_errors: by family, distances [m] (k,) of
    the final map's landmarks from the truth.
    """

    preset: Preset
    errors: Array
    sigmas: Array
    nees: Array
    nees_invariant: Array
    nees_dof: Array
    nis: Array
    nis_dof: Array
    landmarks: Array
    size: Array
    seconds: Array
    extrinsics: Array
    extrinsics_nees: Array
    extrinsics_nees_invariant: Array
    extrinsics_dof: Array
    initialized: int
    deleted: int
    map_errors: dict[str, Array]

    def __repr__(self) -> str:
        """How far the first robot ends from the truth, and how far it says."""
        error, sigma = (np.linalg.norm(each[-1, 0, :3]) for each in (self.errors, self.sigmas))
        return (
            f"Result of {self.preset.name}: {len(self.nees)} frames, {self.landmarks[-1]} landmarks; "
            f"{self.preset.rig.robots[0].name}: at the end {error:.3g} m from the truth (sigma {sigma:.3g} m), "
            f"mean NEES {self.mean_nees[0]:.3g} of {self.dof[0]}"
        )

    @property
    def dof(self) -> tuple[int, ...]:
        """Degrees of freedom of each robot's NEES: 6, 3 in the plane, fewer where a part of its pose stays exact."""
        most = self.nees_dof.max(0)
        return tuple(int(found) or own for found, own in zip(most, self.preset.rig.dof, strict=True))

    def judged(self, robot: int, error: str = "linear") -> Array:
        """NEES (n,) of a robot's pose; nan where more of it is known exactly than later, as at the start.

        error: "linear" or "invariant".
        """
        nees = getattr(self, entry("error", error, NEES))
        return np.where(self.nees_dof[:, robot] == self.dof[robot], nees[:, robot], np.nan)

    @property
    def mean_nees(self) -> tuple[float, ...]:
        """NEES of each robot's pose, averaged over the frames with the most degrees of freedom."""
        return self._means("linear")

    @property
    def mean_nees_invariant(self) -> tuple[float, ...]:
        """The same of the invariant error."""
        return self._means("invariant")

    def _means(self, error: str) -> tuple[float, ...]:
        every = (self.judged(robot, error) for robot in range(self.nees.shape[1]))
        known = [own[np.isfinite(own)] for own in every]
        return tuple(float(own.mean()) if own.size else float("nan") for own in known)

    def _repr_html_(self) -> str:
        """A row for each robot: where it ends, how far from the truth and how far by its own account, and its NEES.

        Of the linear and of the invariant error, with the degrees of freedom of both.
        """
        found = magnitudes(self.errors[-1], self.sigmas[-1])
        errors = ("error [m]", "sigma [m]", "error [deg]", "sigma [deg]")
        columns = ("at the end", *errors, "mean NEES, linear error", "invariant error", "of")
        names = ("position", "position_sigma", "orientation", "orientation_sigma")
        return html_table(
            columns,
            [
                (
                    robot.name,
                    *(f"{found[name][i]:.3g}" for name in names),
                    f"{self.mean_nees[i]:.3g}",
                    f"{self.mean_nees_invariant[i]:.3g}",
                    f"{self.dof[i]}",
                )
                for i, robot in enumerate(self.preset.rig.robots)
            ],
        )

    def series(self) -> dict[str, dict[str, Array]]:
        """By robot the errors of each frame (n,), with their standard deviations, NEES and its dof, for a plot.

        nees_invariant: of the invariant error.
        """
        n = len(self.nees)
        times = self.preset.dt * np.arange(1.0, n + 1)
        found = {}
        for i, setup in enumerate(self.preset.rig.robots):
            nees = {name: self.judged(i, error) for error, name in NEES.items()}
            nees["nees_dof"] = np.full(n, self.dof[i])
            found[setup.name] = {"times": times, **nees, **magnitudes(self.errors[:, i], self.sigmas[:, i])}
        return found


@dataclass(frozen=True)
class Step:
    """One frame of a run, just processed."""

    frame: Frame
    truth: Truth
    report: StepReport


def run(preset: Preset | str, /, **changes: Any) -> Result:
    """Run a preset to its end: a name of `presets.PRESETS`, or a preset of your own, with other values for its fields.

    options: an Options, or a dictionary of those that change. For a run that is watched, saved or resumed: `Run`.
    Raises SlamlibError for an unknown name or a wrong value.

        >>> import slamlib as sl
        >>> result = sl.run("points", frames=3, seed=7, options={"points": "hmgPnt"})
        >>> len(result.nees), result.preset.options
        (3, Options(points='hmgPnt'))
    """
    chosen = named(preset) if isinstance(preset, str) else preset
    known = {f.name for f in fields(Preset)}
    for name in changes:
        if name not in known:
            raise UnknownNameError.of("field of a preset", name, known)
    if isinstance(options := changes.get("options"), dict):
        changes["options"] = replace(chosen.options, **read_fields(Options, options, "options"))
    return Run(replace(chosen, **changes)).finish()


class Run:
    """A run in progress. Iterate over it; `save` at any time, and `Run.load` resumes it exactly.

    >>> import slamlib as sl
    >>> run = sl.Run(sl.presets.points(), seed=7)
    >>> step = next(iter(run))
    >>> run.done, len(run), len(step.report.initialized)
    (1, 399, 10)
    """

    def __init__(self, preset: Preset, seed: int | None = None) -> None:
        self.preset = preset if seed is None else replace(preset, seed=seed)
        self.slam = self.preset.slam()
        self._history: list[list[Any]] = []
        self._extrinsics: list[list[float]] = []  # the true ones
        self._initialized = self._deleted = 0
        self.is_intact = True  # False while a frame is being processed

    @property
    def done(self) -> int:
        """Number of frames processed."""
        return len(self._history)

    def __len__(self) -> int:
        """Number of remaining frames."""
        return self.preset.frames - len(self._history)

    def __iter__(self) -> Iterator[Step]:
        """Process the remaining frames, one at a time."""
        for frame, truth in self.preset.simulate():
            if frame.number <= len(self._history):
                continue
            began, self.is_intact = time.process_time(), False
            report = self.slam.step(frame)
            self._remember(truth, report, time.process_time() - began)
            self.is_intact = True
            yield Step(frame, truth, report)

    def finish(self) -> Result:
        """Process all remaining frames."""
        for _ in self:
            pass
        return self.result()

    def _remember(self, truth: Truth, report: StepReport, seconds: float) -> None:
        self._initialized += len(report.initialized)
        self._deleted += len(report.deleted)
        errors, sigmas, nees, invariant, ranks = [], [], [], [], []
        for robot, pose in zip(self.slam.robots, truth.poses, strict=True):
            P = robot_view(self.slam.belief, robot).pose_covariance
            error, sigma, value, rank = pose_error(pose, robot.pose, P, robot.motion.free)
            errors.append(error.tolist())
            sigmas.append(sigma.tolist())
            nees.append(value)
            invariant.append(pose_nees(invariant_error(pose, robot.pose), P, robot.motion.free)[0])
            ranks.append(rank)
        inliers = [prediction for each in self.slam.predictions for prediction in each if prediction.inlier]
        nis, dof = sum(prediction.nis for prediction in inliers), sum(len(prediction.S) for prediction in inliers)
        self._extrinsics = [extrinsics.tolist() for extrinsics in truth.extrinsics]
        map_size = len(self.slam.landmarks), self.slam.belief.size
        self._history.append([errors, sigmas, nees, invariant, ranks, nis, dof, *map_size, seconds])

    def result(self) -> Result:
        """Results so far. Raises SlamlibError before the first frame."""
        if not self._history:
            raise SlamlibError("nothing has been run yet")
        columns = zip(COLUMNS, map(np.array, zip(*self._history, strict=True)), strict=True)
        count = len(self.slam.sensors)
        extrinsics, ranks = np.zeros((count, 2, 6)), np.zeros(count, dtype=int)
        nees, invariant = np.zeros((2, count))
        for i, (sensor, values) in enumerate(zip(self.slam.sensors, self._extrinsics, strict=True)):
            if sensor.block is not None:
                P, true = self.slam.belief.covariance(sensor.block), np.array(values)
                *extrinsics[i], nees[i], ranks[i] = pose_error(true, sensor.extrinsics, P)
                invariant[i], _ = pose_nees(invariant_error(true, sensor.extrinsics), P)
        return Result(
            preset=self.preset,
            extrinsics=extrinsics,
            extrinsics_nees=nees,
            extrinsics_nees_invariant=invariant,
            extrinsics_dof=ranks,
            initialized=self._initialized,
            deleted=self._deleted,
            map_errors=map_errors(self.slam.snapshot(), self.preset.world),
            **dict(columns),
        )

    def save(self, path: str | Path) -> None:
        """Write all of it to one file, atomically. Raises SlamlibError within a frame."""
        if not self.is_intact:
            raise SlamlibError(f"frame {self.done + 1} was interrupted, and the state of the filter is incomplete")
        own = {"initialized": self._initialized, "deleted": self._deleted, "extrinsics": self._extrinsics}
        self.slam.save(path, preset=self.preset.to_dict(), history=self._history, **own)

    @classmethod
    def load(cls, path: str | Path) -> "Run":
        """Resume a saved run. Raises SlamlibError for a file that holds none."""
        slam, extra = Slam.resume(path)
        if "preset" not in extra:
            raise SlamlibError(f"{path} holds a filter, but not the experiment that it belongs to: use Slam.load")
        with complete(path):
            run = cls(Preset.from_dict(extra["preset"]))
            run.slam, run._history, run._extrinsics = slam, extra["history"], extra["extrinsics"]
            check_columns(run._history, COLUMNS)
            run._initialized, run._deleted = extra["initialized"], extra["deleted"]
        return run


def map_errors(snapshot: Snapshot, world: World) -> dict[str, Array]:
    """By family, distances [m] (k,) of the estimated landmarks from the true ones of the same ids."""
    found = {}
    for name, shown in snapshot.landmarks.items():
        things, family = world.of(name), FAMILIES[name]
        there = dict(zip(things.ids.tolist(), things.values, strict=True))
        pairs = zip(shown.ids.tolist(), shown.geometry, strict=True)
        found[name] = np.array([family.distance(geometry, there[i]) for i, geometry in pairs if i in there])
    return found
