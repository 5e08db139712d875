"""Monte Carlo runs of the report's filter, side by side: is it consistent?"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slambook.report import angles, motion, observation
from slambook.report.filter import Memory
from slambook.report.scenes import Scene
from slambook.report.switches import Equations, equations
from slamlib.evaluation.consistency import band, share_inside
from slamlib.experiments.progress import progress
from slamlib.manifolds import Array

DOF = 6


@dataclass(frozen=True, eq=False)
class Outcome:
    """Of each run and step: error of the pose (runs, steps, 6) and its covariance by the filter."""

    errors: Array
    claimed: Array
    turned: Array
    last: Memory

    @property
    def nees(self) -> Array:
        """e' P^-1 e of the pose (runs, steps); infinite where P is singular, negative where it is no covariance."""
        with np.errstate(all="ignore"):
            singular = np.abs(np.linalg.det(self.claimed)) < 1e-60
            P = np.where(singular[..., None, None], np.eye(6), self.claimed)
            value = (self.errors * np.linalg.solve(P, self.errors[..., None])[..., 0]).sum(-1)
        return np.where(singular | ~np.isfinite(value), np.inf, value)

    @property
    def ratio(self) -> float:
        """NEES over its degrees of freedom, averaged over runs and the second half of the steps: 1 if consistent."""
        return float(self.late(self.nees).mean() / DOF)

    @property
    def position(self) -> float:
        """Root mean square error of the position [m], second half of the steps."""
        return float(np.sqrt((self.late(self.errors)[..., :3] ** 2).sum(-1).mean()))

    @property
    def rotation(self) -> float:
        """Root mean square error of the orientation [degrees], second half of the steps."""
        return float(np.degrees(np.sqrt((self.late(self.turned) ** 2).mean())))

    @property
    def position_error(self) -> Array:
        """Root mean square error of the position at each step (steps,) [m]."""
        return np.sqrt((self.errors[..., :3] ** 2).sum(-1).mean(0))

    @property
    def claimed_deviation(self) -> Array:
        """Root mean square of the filter's own standard deviation of the position at each step (steps,) [m]."""
        return np.sqrt(np.trace(self.claimed[..., :3, :3], axis1=-2, axis2=-1).mean(0))

    @property
    def inside(self) -> float:
        """Share of the steps whose average over the runs lies in its 95 % band."""
        average = self.nees.mean(0)
        return share_inside(np.where(np.isfinite(average), average, 1e9), band(DOF, len(self.nees)))

    def late(self, values: Array) -> Array:
        """The second half of the steps."""
        return values[:, values.shape[1] // 2 :]


def monte_carlo(
    scene: Scene,
    *errors: str,
    runs: int = 20,
    seed: int = 0,
    again: bool = False,
    make: Callable[..., Memory] = Memory,
) -> Outcome:
    """Runs of a scene with these errors turned on. The same seed gives the same noise whatever is turned on.

    again: landmarks are initialized from a second measurement, with noise of its own, not from the update's.
    make: another filter, made as a Memory is.
    """
    use, rng, truth = equations(*errors), np.random.default_rng(seed), scene.path()
    filter = make(np.tile(scene.start, (runs, 1)), np.zeros((runs, 6, 6)), use=use)
    controls = scene.controls + scene.control_std * rng.standard_normal((runs, *scene.controls.shape))
    filter.initialize(*observe(filter, scene, truth[0], rng), first=True)
    steps = len(scene.controls)
    found, claimed = np.full((runs, steps, 6), np.inf), np.full((runs, steps, 6, 6), np.inf)
    with np.errstate(all="ignore"):
        for k in progress(range(steps), steps, f"{' + '.join(errors) or 'corrected'}, {runs} runs"):
            filter.predict(motion.inverse(controls[:, use.which_control(k)]), scene.U)
            picture = observe(filter, scene, truth[k + 1], rng)
            filter.update(*part(filter, *picture, known=True))
            if not np.isfinite(filter.x).all():  # nothing can be computed from here on
                break
            found[:, k], claimed[:, k] = filter.x[:, :6], filter.P[:, :6, :6]
            filter.prune()
            picture = observe(filter, scene, truth[k + 1], rng) if again else picture
            filter.initialize(*part(filter, *picture, known=False))
        return outcome(found, truth[1:], claimed, filter)


def part(filter: Memory, seen: Array, names: list[int], R: Array, known: bool) -> tuple[Array, list[int], Array]:
    """Measurements of landmarks that are in the map, or of those that are not."""
    rows = [i for i, name in enumerate(names) if (name in filter.names) == known]
    return seen[:, rows], [names[i] for i in rows], R[:, rows]


def observe(filter: Memory, scene: Scene, truth: Array, rng: np.random.Generator) -> tuple[Array, list[int], Array]:
    """Measurements from the true pose: points (runs, m, 3), their numbers, and R as the filter assumes it."""
    relative = observation.by_vectors(truth, scene.points)
    names = np.flatnonzero(scene.sees(relative))
    R = scene.covariance(Equations(), relative)
    # noise for all points, seen or not, so that it does not depend on what is seen
    noise = (np.linalg.cholesky(R) @ rng.standard_normal((len(filter.x), *relative.shape, 1)))[..., 0]
    seen = (relative + noise)[:, names]
    return seen, list(map(int, names)), scene.covariance(filter.use, seen)


def outcome(found: Array, truth: Array, claimed: Array, last: Memory) -> Outcome:
    """Errors of poses (runs, steps, 6) against the truth (steps, 6)."""
    errors = found - truth
    errors[..., 3:] = angles.wrapped(errors[..., 3:])
    turned = angles.apart(found[..., 3:], np.broadcast_to(truth[..., 3:], found[..., 3:].shape))
    known = np.all(np.isfinite(found), axis=-1)
    return Outcome(np.where(known[..., None], errors, np.inf), claimed, np.where(known, turned, np.inf), last)


def two_pictures(*errors: str, runs: int = 1000, points: int = 12, sigma: float = 0.05, seed: int = 0) -> Outcome:
    """Section 5.2.2: control from the matches of two pictures, update by the same matches, or by others.

    The robot stands still at the origin and has no control. One step; 12 points in a box in front of it.
    """
    use, rng = equations(*errors), np.random.default_rng(seed)
    boxes = rng.uniform((2, -4, -2), (8, 4, 2), (2, points, 3))
    own, other = (box + sigma * rng.standard_normal((2, runs, points, 3)) for box in boxes)
    before, after = use.odometry(own, other)
    u, U = motion.aligned(before, after, sigma)
    names, R = list(range(points)), sigma**2 * np.eye(3)
    filter = Memory(np.zeros((runs, 6)), np.zeros((runs, 6, 6)), use=use)
    filter.initialize(own[0], names, R, first=True)
    filter.predict(motion.inverse(u), U)
    filter.update(own[1], names, R)
    return outcome(filter.x[:, None, :6].copy(), np.zeros((1, 6)), filter.P[:, None, :6, :6].copy(), filter)
