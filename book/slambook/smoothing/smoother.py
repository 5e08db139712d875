"""Smoothing: the best estimate from the same data, of all poses and all landmarks at once. The filter's yardstick.

A filter linearizes each measurement once and never returns to it. Here all of them are kept, and nonlinear least
squares (Levenberg-Marquardt) finds the states of all frames and the landmarks that fit them best: the smoothing and
mapping of Dellaert and Kaess (IJRR 25(12), 2006), bundle adjustment with odometry. The filter's run gives the data
association and the initial values; models, Jacobians and noise are the filter's (`factors`).

* A landmark keeps the parametrization that it has in the filter at the end, but moves only in the directions that
  change the point (3) or the line (4): a redundant one has no gauge freedom here and needs no prior, and points at
  infinity remain possible. The filter's prior of inverse distance is no measurement, and is not used.
* A landmark that the filter deleted stays, begun at its last mean; initialized again, it is another one.
* Left out are measurements that the sensor could not make at the initial values, landmarks that were measured too
  seldom to be placed, and, unless they are asked for, the matches that the filter's gate refused.
* What has no noise (a wheel that cannot slip aside) is held by a tiny one. Where the steps do not converge, they are
  taken again with a wider one first (LOOSE), as penalties are.
* The estimate is the mode of all states together, not their mean. Where the steps of a robot are the only scale that
  one camera has, it is too small by the square of their relative noise: least squares with a noisy regressor.
"""

from collections import Counter, defaultdict
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from slambook.smoothing.factors import LOSSES, Group, absolute, motion, prior
from slambook.smoothing.least_squares import Factor, Minimum, Values, Variable, minimize
from slamlib.entities import Landmark
from slamlib.errors import SlamlibError, entry
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.motions import Motion
from slamlib.records.ids import Id
from slamlib.records.inputs import Frame
from slamlib.slam import Slam

LOOSE = (1e4, 1e2, 1.0)  # factors of the standard deviation of what has none


@dataclass(frozen=True, eq=False)
class Smoothed:
    """The smoothed estimate of n frames.

    states: for each robot (n + 1, size), the first before frame 1; motions: of the robots; extrinsics (s, 7);
    landmarks: parametrization and mean by the id of those in the filter's map; left_out: number of measurements;
    minimum: how it was found.
    """

    states: tuple[Array, ...]
    motions: tuple[Motion, ...]
    extrinsics: Array
    landmarks: dict[Id, tuple[Any, Array]]
    left_out: int
    minimum: Minimum = field(repr=False)
    _places: dict[Id, tuple[Variable, int]] = field(repr=False)

    @property
    def poses(self) -> Array:
        """Poses (n, r, 7) of the robots at the n frames."""
        own = zip(self.motions, self.states, strict=True)
        return np.stack([motion.pose(states[1:]) for motion, states in own], axis=1)

    @property
    def costs(self) -> tuple[float, ...]:
        """Sums of squared whitened residuals, or of their losses: at first, and after each step that was accepted."""
        return self.minimum.costs

    @property
    def dof(self) -> int:
        """Residuals minus unknown numbers: the mean of the last cost if the models hold, for it is chi-square."""
        return self.minimum.rows - self.minimum.size

    def covariance(self, frames: Any = -1, robot: int = 0) -> Array:
        """Marginal covariances (..., 6, 6) of a robot's pose at frames (...), counted like the rows of `poses`."""
        frames, count = np.asarray(frames), len(self.poses)
        if frames.dtype.kind not in "iu" or (frames < -count).any() or (frames >= count).any():
            raise SlamlibError(f"covariance: frames are whole numbers from {-count} to {count - 1}, got {frames}")
        items = frames.ravel() % count + 1
        P = self.minimum.marginals(self.minimum.variables[robot], items)
        _, P = self.motions[robot].in_space(self.states[robot][items], P)
        return P.reshape(*frames.shape, *P.shape[1:])

    def point(self, number: Id) -> tuple[Array, Array]:
        """The point (3,) [m] of an id, and its marginal covariance (3, 3). Raises SlamlibError for what is no point."""
        kind, mean = self.landmarks.get(number, (None, None))
        if mean is None or kind is None or not hasattr(kind, "to_point"):
            what = "was not smoothed; see `landmarks`" if kind is None else f"is a {kind.name}, no point"
            raise SlamlibError(f"point: landmark {number} {what}")
        position, J = kind.to_point.jac(mean)
        variable, item = self._places[number]
        by = J.landmark @ variable.basis(mean[None])[0]
        return position, by @ self.minimum.marginals(variable, np.array([item]))[0] @ by.T


class Recorded(NamedTuple):
    """A landmark's measurement (m,) by a sensor at an item of its robot's states."""

    item: int
    sensor: int
    landmark: Landmark
    measured: Array
    inlier: bool


class Smoother:
    """Listens to a filter from its first frame on: `record(frame)` after each `slam.step(frame)`; then `solve()`.

    `resume(slam)`, if the filter was saved and loaded meanwhile.
    """

    def __init__(self, slam: Slam) -> None:
        if slam.landmarks or slam.time:
            raise SlamlibError("Smoother: the filter has begun already; make the smoother before its first frame")
        self._slam, self._time = slam, 0.0
        self._free = [i for i, sensor in enumerate(slam.sensors) if sensor.block is not None]
        blocks = [robot.block for robot in slam.robots] + [sensor.block for sensor in slam.sensors if sensor.block]
        self._start = [(block.mean, slam.belief.covariance(block)) for block in blocks]
        self._states = [[robot.block.mean] for robot in slam.robots]
        self._controls: list[list[tuple[Array, Array, float]]] = [[] for _ in slam.robots]
        self._absolute: dict[Any, list[tuple[int, Any]]] = defaultdict(list)
        self._matches: list[Recorded] = []
        self._last: dict[Landmark, tuple[Any, Array]] = {}

    def record(self, frame: Frame) -> None:
        """Keep the frame's controls and matches, and the filter's means after it. Raises SlamlibError."""
        slam, item = self._slam, len(self._states[0])
        if slam.number != frame.number or abs(slam.time - self._time - frame.dt) > 1e-6 * abs(frame.dt):
            raise SlamlibError(f"record: frame {frame.number} is not the filter's last step; record each, once")
        self._time = slam.time
        for i, (robot, control) in enumerate(zip(slam.robots, frame.controls, strict=True)):
            none = np.zeros(robot.motion.control), robot.noise
            self._controls[i].append((*((control.value, control.covariance) if control else none), frame.dt))
            self._states[i].append(robot.block.mean)
        for measured, found in zip(frame.absolute, slam.absolute, strict=True):
            if found.inlier:
                self._absolute[measured.robot, measured.model].append((item, measured))
        for i, predictions in enumerate(slam.predictions):
            self._matches += [Recorded(item, i, p.landmark, p.measured, p.inlier) for p in predictions if p.matched]
        for landmark in slam.landmarks:
            if landmark not in self._last and landmark.first_measured is not None:
                self._matches.append(Recorded(item, landmark.sensor, landmark, landmark.first_measured, True))
            self._last[landmark] = landmark.kind, landmark.block.mean

    def resume(self, slam: Slam) -> None:
        """Go on with the filter that has been saved and loaded in the place of the one before. Raises SlamlibError."""
        if slam.rig.to_dict() != self._slam.rig.to_dict():  # motions by their names, as a file has them
            raise SlamlibError("resume: the filter that was loaded has another rig")
        if slam.time != self._time:
            raise SlamlibError(
                f"resume: the filter is at {slam.time:g} s, and the last frame was recorded at {self._time:g} s; "
                "record each frame before the filter is saved"
            )
        loaded = {(landmark.id, landmark.first_seen): landmark for landmark in slam.landmarks}
        now = {landmark: loaded.get((landmark.id, landmark.first_seen), landmark) for landmark in self._last}
        self._last = {now[landmark]: last for landmark, last in self._last.items()}
        self._matches = [match._replace(landmark=now[match.landmark]) for match in self._matches]
        self._slam = slam

    def solve(self, *, loss: str = "squares", refused: bool = False, steps: int = 50) -> Smoothed:
        """The best estimate from all frames recorded so far; at most this many steps are tried.

        If they do not converge, so many are tried with each of LOOSE.
        loss: of each measurement of a landmark: "squares", "huber" or "cauchy"; the last two are robust. refused: use
        the matches that the filter's gate refused, too. Raises SlamlibError.
        """
        entry("loss", loss, LOSSES)
        if not self._time:
            raise SlamlibError("solve: no frame has been recorded; call record(frame) after each slam.step(frame)")
        matches = self._usable([match for match in self._matches if match.inlier or refused])
        variables, values, places, groups = self._problem(matches)
        measured: list[Factor] = [partial(group.terms, loss=LOSSES[loss]) for group in groups]
        best = minimize(self._motions(variables, values) + measured, variables, values, steps)
        if not best.converged:
            with suppress(SlamlibError):  # then the first attempt is all there is
                for loose in LOOSE:
                    found = minimize(self._motions(variables, values, loose) + measured, variables, values, steps)
                    values = found.values
                best = min(best, found, key=lambda minimum: minimum.costs[-1])
        extrinsics = np.array([sensor.given_extrinsics for sensor in self._slam.sensors])
        for i, value in zip(self._free, best.values[len(self._states) :], strict=False):
            extrinsics[i] = value[0]
        present = {lm.id: places[lm] for lm in self._slam.landmarks if lm in places}
        landmarks = {number: (v.kind, best.values[v.index][row]) for number, (v, row) in present.items()}
        left_out = len(self._matches) - len(matches)
        states, motions = tuple(best.values[: len(self._states)]), tuple(r.motion for r in self._slam.robots)
        return Smoothed(states, motions, extrinsics, landmarks, left_out, best, present)

    def _motions(self, variables: list[Variable], values: Values, loose: float = 1.0) -> list[Factor]:
        """What is known of the robots without landmarks: the start, the motions, their measurements of themselves."""
        found = [prior(variable, *start) for variable, start in zip(variables, self._start, strict=False)]
        for variable, robot, controls in zip(variables, self._slam.robots, self._controls, strict=False):
            found.append(motion(variable, robot.motion.step, controls, values[variable.index], loose))
        for (i, model), rows in self._absolute.items():
            found.append(absolute(variables[i], self._slam.robots[i].motion, model, rows))
        return found

    def _usable(self, matches: list[Recorded]) -> list[Recorded]:
        """The matches that their sensor can make at the initial values, of landmarks with enough of them."""
        _, values, _, groups = self._problem(matches)
        seen = np.zeros(len(matches), dtype=bool)
        for group in groups:
            seen[group.numbers] = group.seen(values)
        matches = [match for match, is_seen in zip(matches, seen.tolist(), strict=True) if is_seen]
        count = Counter(match.landmark for match in matches)
        sensors = [sensor.calibration.sensor for sensor in self._slam.sensors]
        return [match for match in matches if count[match.landmark] > sensors[match.sensor].unmeasured]

    def _problem(self, matches: list[Recorded]) -> tuple[list[Variable], Values, dict[Landmark, Any], list[Group]]:
        """Variables, their initial values, where each landmark is among them, and the measurements in groups."""
        slam = self._slam
        kinds: dict[Any, dict[Landmark, int]] = defaultdict(dict)
        batches: dict[Any, list[int]] = defaultdict(list)
        for number, match in enumerate(matches):
            kind = self._last[match.landmark][0]
            kinds[kind].setdefault(match.landmark, len(kinds[kind]))
            batches[match.sensor, kind].append(number)
        parts = [(robot.motion.manifold, None, states) for robot, states in zip(slam.robots, self._states, strict=True)]
        parts += [(Pose, None, [slam.sensors[i].extrinsics]) for i in self._free]
        parts += [(kind.manifold, kind, [self._last[lm][1] for lm in own]) for kind, own in kinds.items()]
        variables, values, start = [], [np.array(means) for *_, means in parts], 0
        for index, (manifold, kind, means) in enumerate(parts):
            variables.append(Variable(manifold, index, start, kind))
            start += variables[-1].width * len(means)
        of_kind = dict(zip(kinds, variables[len(parts) - len(kinds) :], strict=True))
        places = {lm: (of_kind[kind], row) for kind, own in kinds.items() for lm, row in own.items()}
        groups = []
        for (i, kind), numbers in batches.items():
            sensor, own = slam.sensors[i], [matches[number] for number in numbers]
            groups.append(Group(
                sensor=sensor,
                family=next(family for family in slam.families.values() if isinstance(kind, family.kinds)),
                options=slam.options,
                robot=variables[slam.robots.index(sensor.robot)],
                extrinsics=variables[len(self._states) + self._free.index(i)] if i in self._free else None,
                landmarks=of_kind[kind],
                numbers=np.array(numbers),
                items=np.array([match.item for match in own]),
                rows=np.array([places[match.landmark][1] for match in own]),
                measured=np.array([match.measured for match in own]),
            ))  # fmt: skip
        return variables, values, places, groups
