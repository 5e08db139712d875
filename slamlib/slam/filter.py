"""EKF-SLAM: robots, sensors and landmarks in one joint Gaussian, updated frame by frame. Chapter ekf_slam reads it."""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.belief import Belief, Block, UpdateResult
from slamlib.entities import Landmark, RigSensor, Robot, State
from slamlib.entities.linearization import FirstEstimates, Linearization
from slamlib.errors import ShapeError, SingularPointError, SlamlibError, entry
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks.parametrization import Parametrization
from slamlib.manifolds import Array, check_turns, finite, numbers
from slamlib.observation import FAMILIES, parametrization
from slamlib.observation.family import AnyFamily
from slamlib.plain_data.files import complete
from slamlib.records.ids import Id, ids_of
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.records.snapshots import Map, RobotView, Snapshot
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import checkpoint, transport
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS
from slamlib.slam.data_association.front_end import Detected, FrontEnd, FrontEndInput, KnownAssociation, match
from slamlib.slam.data_association.selection import select
from slamlib.slam.map_management import StepReport, is_bad, out_of_window, prune_candidate
from slamlib.slam.measurement_update import RobotUpdate, convert, update_by_robot, update_in_batch, update_sequentially
from slamlib.slam.options import Options
from slamlib.slam.prediction import Predictions, predict_measurements
from slamlib.slam.snapshot import map_views, robot_view, snapshot_of


class Slam:
    """The EKF-SLAM filter: made from a rig and options, it processes frames one by one; `snapshot` shows its state.

    >>> import slamlib as sl
    >>> preset = sl.presets.points()
    >>> slam = sl.Slam(preset.rig, options=preset.options)
    >>> frame, truth = next(preset.simulate())
    >>> report = slam.step(frame)
    >>> slam
    Slam: robot; camera (pinHole); 10 ahmPnt; 76 degrees of freedom after frame 1
    """

    def __init__(
        self,
        *parts: Rig | RobotSetup | SensorSetup,
        options: Options | None = None,
        front_ends: Sequence[FrontEnd] | None = None,
    ) -> None:
        """parts: a rig, or robots and sensors one by one. front_ends: one for each sensor, which finds its measurements
        (default: KnownAssociation). Raises SlamlibError."""
        self.rig, self._options = Rig.of(*parts), Options()
        self.state = _state_of(self.rig)
        self.front_ends: list[FrontEnd] = list(front_ends or [KnownAssociation()] * len(self.sensors))
        if len(self.front_ends) != len(self.sensors):
            raise SlamlibError(f"Slam: {len(self.sensors)} sensors need as many front ends, got {len(self.front_ends)}")
        self.families: dict[str, AnyFamily] = dict(FAMILIES)
        self.number, self.time = 0, 0.0
        self.frame_counts = [0] * len(self.sensors)
        self.scans: list[Scan | None] = [None] * len(self.sensors)
        self.predictions: list[Predictions] = [[] for _ in self.sensors]
        self.absolute: list[RobotUpdate] = []
        self.options = options or Options()

    def __repr__(self) -> str:
        """How much is in the map."""
        kinds = Counter(landmark.kind.name for landmark in self.landmarks)
        found = ", ".join(f"{n} {name}" for name, n in kinds.most_common()) or "no landmarks yet"
        sensors = ", ".join(f"{s.name} ({s.type})" for s in self.rig.sensors)
        return (
            f"Slam: {', '.join(r.name for r in self.robots)}; {sensors}; {found}; {self.belief.size} degrees "
            f"of freedom after frame {self.number}"
        )

    @property
    def options(self) -> Options:
        """The options. Others may be assigned between two steps; raises SlamlibError if a type has no `moved`."""
        return self._options

    @options.setter
    def options(self, options: Options) -> None:
        kinds = [family.new_kind(options, s) for family in self.families.values() for s in self.sensors]
        transport.check(self.robots, [kind for kind in kinds if kind is not None], options.error)
        if options.error != self._options.error:
            self.linearization = FirstEstimates() if options.error == "first-estimates" else None
        self._options = options

    @property
    def belief(self) -> Belief:
        """The joint Gaussian of all blocks."""
        return self.state.belief

    @property
    def robots(self) -> list[Robot]:
        """The robots, in the order of the rig."""
        return self.state.robots

    @property
    def sensors(self) -> list[RigSensor]:
        """The sensors, in the order of the rig."""
        return self.state.sensors

    @property
    def landmarks(self) -> list[Landmark]:
        """The landmarks in the map, in the order in which they were initialized."""
        return self.state.landmarks

    @property
    def robot(self) -> RobotView:
        """The first robot as it is estimated now: its mean, covariance and standard deviations."""
        return robot_view(self.belief, self.robots[0])

    @property
    def map(self) -> Map:
        """The landmarks as they are estimated now, by their numbers: means and standard deviations in the world."""
        return Map(map_views(self.state, self.families))

    @property
    def linearization(self) -> Linearization | None:
        """The linearization points; None: the present means."""
        return self.state.linearization

    @linearization.setter
    def linearization(self, linearization: Linearization | None) -> None:
        self.state.linearization = linearization

    def step(
        self,
        frame: Frame | Control | ArrayLike | None,
        seen: Mapping[Id, ArrayLike] | None = None,
        *,
        dt: float = 1.0,
        update: bool = True,
        first: bool = False,
    ) -> StepReport:
        """Process one frame: all robots move; then each sensor updates the map and initializes new landmarks.

        frame: a Frame; or, for one robot with one sensor, its control (c,), with the noise of its setup, and what was
        `seen` after the time dt [s]: measurements (m,) by the numbers of their landmarks. update: False skips the
        measurement update: this frame's measurements have been used already. first: as many landmarks are initialized
        as in a sensor's first frame. Raises SlamlibError for what does not fit the rig; then nothing is changed.
        """
        frame = self._frame(frame, seen, dt)
        self._check(frame)
        report = StepReport()
        self.number = frame.number
        self.predict(frame.controls, frame.dt)
        self.absolute = []
        for measured in frame.absolute:
            robot = self.robots[measured.robot]
            with transport.TRANSPORTS[self.options.error].by_robot(self.state, robot):
                own = update_by_robot(self.belief, robot, measured, self.linearization, self.options)
            self.absolute.append(own)
        for i, scan in enumerate(frame.scans):
            self.scans[i], self.predictions[i] = scan, self.project(i)
            if update:
                self._update(i, scan)
            self._delete(self.predictions[i], report)
            is_first = first or not self.frame_counts[i]
            self._initialize(i, scan, self.options.max_new_first if is_first else self.options.max_new, report)
        return report

    def predict(self, controls: Sequence[Control | None], dt: float) -> None:
        """Move all robots by `dt` [s] without a frame: no sensor measures. Raises SlamlibError; nothing is changed."""
        self._check_time(dt, "predict")
        self.time += dt
        for robot, control in zip(self.robots, controls, strict=True):
            self._predict(robot, control, dt)

    def update(
        self, blocks: Sequence[Block], jacobians: Sequence[Array], innovation: Array, R: Array, *, robot: int = 0
    ) -> UpdateResult:
        """Update by any other measurement: robots that meet, a beacon at a known place, a prior on a landmark.

        As Belief.update; the covariance is kept in the error that the options name. robot: the index of the one that
        measures, or of any. Raises SlamlibError; then nothing is changed.
        """
        if not 0 <= robot < len(self.robots):
            raise SlamlibError(f"update: robot is the index of one of {len(self.robots)}, from 0 on, got {robot}")
        with transport.TRANSPORTS[self.options.error].by_robot(self.state, self.robots[robot]):
            return self.belief.update(blocks, jacobians, innovation, R)

    def _frame(
        self, given: Frame | Control | ArrayLike | None, seen: Mapping[Id, ArrayLike] | None, dt: float
    ) -> Frame:
        """The frame given; or, of a control and what was seen, the one after the present. Raises SlamlibError."""
        if isinstance(given, Frame):
            if seen is not None:
                raise SlamlibError("step: a Frame holds all that was seen; give a control where that is given apart")
            return given
        if (len(self.robots), len(self.sensors)) != (1, 1):
            raise SlamlibError("step: a control is for one robot with one sensor; give a Frame, with a scan of each")
        if not 0 < dt < np.inf:
            raise SlamlibError(f"step: dt is a time above zero [s], got {dt}")
        robot, sensor = self.robots[0], self.sensors[0]
        control = given
        if control is not None and not isinstance(control, Control):
            control = Control(finite(control, (robot.motion.control,), "step", "control"), robot.noise)
        return Frame(self.number + 1, dt, (control,), (self._scan(sensor, seen or {}),))

    def _scan(self, sensor: RigSensor, seen: Mapping[Id, ArrayLike]) -> Scan:
        """Measurements by the numbers of their landmarks as a scan: how many numbers each is says of which family."""
        measured_by = [family for family in self.families.values() if family.supports(sensor)]
        measured_by.sort(key=lambda family: family.new_kind(self.options, sensor) is None)
        names: dict[int, str] = {}  # of two families of so many numbers, the one of which landmarks are initialized
        for family in measured_by:
            names.setdefault(family.size(sensor.calibration), family.name)
        rows: dict[str, dict[Id, Array]] = defaultdict(dict)
        for number, measured in seen.items():
            value = np.atleast_1d(numbers(measured, "step", f"measurement of {number}"))
            if value.ndim != 1 or len(value) not in names:
                wanted = " or ".join(f"{size} numbers ({name})" for size, name in names.items())
                what = f"{sensor.name} measures {wanted} of a landmark"
                raise ShapeError(f"step: {what}, and of {number} got {value.shape}")
            rows[names[len(value)]][number] = value
        each = {name: (ids_of([*of], "step: ids"), np.array([*of.values()])) for name, of in rows.items()}
        return Scan({name: Features(*given) for name, given in each.items()})

    def project(self, sensor: int = 0, motion: Array | None = None) -> Predictions:
        """Predict the measurements of a sensor (by its index); nothing is changed.

        motion (7,): as they will be when its robot has moved by this pose, in its own frame.
        """
        own = self.sensors[sensor]
        robot = None if motion is None else compose(own.robot.pose, motion)
        return predict_measurements(self.belief, own, self.families, self.state.kinds(), self.options, robot)

    def _check_time(self, dt: float, what: str) -> None:
        """Raise SlamlibError unless dt is a time [s]: zero where two sensors measure at once, never below."""
        is_number = isinstance(dt, int | float | np.integer | np.floating) and not isinstance(dt, np.timedelta64)
        if not is_number or not 0 <= dt < np.inf:
            raise SlamlibError(
                f"{what}: dt is the time since the frame before, 0 or more [s], got {dt}; of a list of times it is "
                "their differences, and the first frame's is 0"
            )

    def _check(self, frame: Frame) -> None:
        self._check_time(frame.dt, f"frame {frame.number}")
        given, wanted = (len(frame.controls), len(frame.scans)), (len(self.robots), len(self.sensors))
        if given != wanted:
            raise SlamlibError(
                f"frame {frame.number}: {given[0]} controls and {given[1]} scans for a rig of {wanted[0]} robots "
                f"and {wanted[1]} sensors; a robot without a control has None, a sensor without features an empty scan"
            )
        for robot, control in zip(self.robots, frame.controls, strict=True):
            if control is not None and control.value.shape != (robot.motion.control,):
                raise SlamlibError(
                    f"frame {frame.number}: {robot.name} takes controls of {robot.motion.control} numbers, "
                    f"got {control.value.size}"
                )
        for sensor, scan in zip(self.sensors, frame.scans, strict=True):
            for name, features in scan.features.items():
                family = entry("family of features", name, self.families)
                size, given = family.size(sensor.calibration), features.values.shape[1]
                if given != size and len(features):
                    raise SlamlibError(
                        f"frame {frame.number}: {sensor.name} measures {size} numbers for each of {name}, got {given}"
                    )
                if given == sensor.calibration.sensor.size:
                    what = f"frame {frame.number}: {sensor.name} measures {name}, and"
                    check_turns(features.values, sensor.calibration.sensor.angles, what)
        for measurement in frame.absolute:
            if not 0 <= measurement.robot < len(self.robots):
                raise SlamlibError(f"frame {frame.number}: {measurement.name} is of robot {measurement.robot}, of none")
        for front_end, scan in zip(self.front_ends, frame.scans, strict=True):
            front_end.check(scan)

    def _predict(self, robot: Robot, control: Control | None, dt: float) -> None:
        value = np.zeros(robot.motion.control) if control is None else control.value
        noise = robot.noise if control is None else control.covariance
        state, (F, G, _) = robot.motion.step.jac(robot.block.mean, value, dt)
        if self.linearization is not None:
            F, G = self.linearization.motion(robot, state, value, dt)
        self.belief.predict_modelled(robot.block, state, F, G @ noise @ G.T)
        if self.linearization is not None:
            self.linearization.predicted(robot.block)

    def _update(self, i: int, scan: Scan) -> None:
        """Select, match, gate, update, convert: with the measurements of one sensor."""
        sensor, options = self.sensors[i], self.options
        inputs, front_end = FrontEndInput(scan, sensor, self.predictions[i]), self.front_ends[i]
        chosen = select(inputs, front_end, options.selection, options.updates)
        matched = match(inputs, front_end, chosen)
        for group in OUTLIER_REJECTIONS[options.outlier_rejection](self.belief, sensor, matched, options):
            with transport.TRANSPORTS[options.error].by_sensor(self.state, sensor) as projection:
                if options.reproject:
                    update_sequentially(self.belief, sensor, group, options, projection)
                else:
                    update_in_batch(self.belief, sensor, group, options)
        for prediction in matched:
            if prediction.inlier:
                prediction.landmark.last_seen = self.number
        convert(self.belief, sensor, matched, options)

    def _delete(self, predictions: Predictions, report: StepReport) -> None:
        """Delete landmarks seldom found where predicted or often outliers, out of the window, or beyond infinity."""
        bad = {p.landmark for p in predictions if p.chosen and is_bad(p.landmark, self.options)}
        bad.update(out_of_window(self.landmarks, self.number, self.options))
        for rows in self.state.kinds():
            for family in self.families.values():
                if isinstance(rows.landmarks[0].kind, family.kinds):
                    bad |= family.invalid(self.belief, rows.landmarks)
        for landmark in [lm for lm in self.landmarks if lm in bad] if bad else ():
            self.prune(landmark)
            report.deleted.append(landmark.id)

    def _initialize(self, i: int, scan: Scan, count: int, report: StepReport) -> None:
        """Initialize up to `count` landmarks of each family by what one sensor has measured."""
        sensor = self.sensors[i]
        inputs = FrontEndInput(scan, sensor, self.predictions[i])
        self.frame_counts[i] += 1
        for family in self.families.values():
            kind = family.new_kind(self.options, sensor)
            if kind is None or not family.supports(sensor):
                continue
            usable = partial(family.usable, sensor, options=self.options)
            for detected in self.front_ends[i].detect(inputs, family.name, self.state.ids(), usable, count):
                self._initialize_one(i, family, kind, detected, report)

    def _initialize_one(
        self, i: int, family: AnyFamily, kind: Parametrization, detected: Detected, report: StepReport
    ) -> None:
        """Initialize one landmark; at the capacity another one is pruned for it, or it is refused."""
        sensor, (number, value, signature) = self.sensors[i], detected
        try:
            x, noise, jacobians = family.initialize(sensor, kind, value, self.options)
        except SingularPointError:
            return  # this parametrization cannot hold the point; it may from the next camera position
        if self.options.capacity is not None and len(self.landmarks) >= self.options.capacity:
            given_up = prune_candidate(self.landmarks, self.number, self.options)
            if given_up is None:
                report.refused.append(number)
                return
            self.prune(given_up)
            report.deleted.append(given_up.id)
        blocks, robot = sensor.blocks, sensor.robot
        jacobians = [robot.motion.by_state(jacobians[0], robot.block.mean), *jacobians[1:]]
        pads = [np.pad(J, ((0, 0), (0, b.dof - J.shape[1]))) for b, J in zip(blocks, jacobians, strict=False)]
        block = self.belief.add(kind.manifold, x, noise, given=blocks, jacobians=pads)
        if self.linearization is not None:
            self.linearization.added([block], [x])
        own = {"abscissas": family.abscissas(kind), "sensor": i, "signature": signature, "first_measured": value}
        self.landmarks.append(Landmark(number, kind, block, self.number, **own))
        report.initialized.append(number)

    def prune(self, landmark: Landmark) -> None:
        """Delete a landmark from the map: what remains is the marginal of the others."""
        self.state.remove(landmark)

    def snapshot(self) -> Snapshot:
        """Return a copy of everything that may be shown of the filter; it never changes."""
        shown = self.state, self.families, self.scans, self.predictions
        return snapshot_of(*shown, number=self.number, time=self.time)

    def save(self, path: str | Path, **extra: Any) -> None:
        """Write the filter to one file, atomically; extra: plain data that `resume` returns."""
        own = {"rig": self.rig.to_dict(), "options": self.options.to_dict(), "number": self.number, "time": self.time}
        header, arrays = checkpoint.pack(self.state, self.front_ends)
        checkpoint.write(path, {**own, "frame_counts": self.frame_counts, **header, "extra": extra}, arrays)

    @classmethod
    def load(cls, path: str | Path, *, front_ends: Sequence[FrontEnd] | None = None) -> "Slam":
        """Load the filter of a file: it continues bit for bit like the saved one. Raises SlamlibError."""
        return cls.resume(path, front_ends=front_ends)[0]

    @classmethod
    def resume(cls, path: str | Path, *, front_ends: Sequence[FrontEnd] | None = None) -> tuple["Slam", dict[str, Any]]:
        """Load the filter of a file, together with the extra data that were saved with it. Raises SlamlibError."""
        header, arrays = checkpoint.read(path)
        with complete(path):
            options = Options.from_dict(header["options"])
            slam = cls(Rig.from_dict(header["rig"]), options=options, front_ends=front_ends)
            checkpoint.unpack(slam.state, slam.front_ends, header, arrays)
            slam.number, slam.time, slam.frame_counts = header["number"], header["time"], header["frame_counts"]
            return slam, header["extra"]


def _state_of(rig: Rig) -> State:
    """The robots at their starts, and the sensors, with a block for the extrinsics of each that are estimated."""
    belief = Belief()
    robots = [Robot(r.name, r.model, belief.add(r.model.manifold, r.state, r.covariance), r.noise) for r in rig.robots]
    sensors = []
    for setup in rig.sensors:
        if setup.landmark is not None:
            parametrization(setup.landmark)  # an unknown one is named here
        block = belief.add(Pose, setup.extrinsics, setup.covariance) if setup.estimated else None
        own = setup.name, robots[setup.robot], setup.calibration, setup.extrinsics, block
        sensors.append(RigSensor(*own, landmark=setup.landmark))
    return State(belief, robots, sensors)
