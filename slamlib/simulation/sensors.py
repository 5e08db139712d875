"""Simulated sensors of any type, through the same measurement models as the filter's, and their faults.

Faults occur at given rates: features are missed, replaced by outliers, or associated with another landmark. Each thing
that is drawn at random has a stream of its own.
"""

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.manifolds import Array, Indices, Manifold, Mask, read_only_copy
from slamlib.observation import FAMILIES
from slamlib.observation.family import AnyFamily
from slamlib.plain_data.fields import Share, check
from slamlib.records.inputs import Features, Scan, World
from slamlib.rigs.setup import SensorSetup
from slamlib.simulation.occlusion import hidden, longest_seen

if TYPE_CHECKING:
    from slamlib.sensors.sensor import Calibration

TRIES = 1000  # of a false measurement
DIRECTIONS = 4096  # in which the extent of all measurements is found
KINDS = ("start", "control", "extrinsics", "points", "segments", "faults")  # other families come after these
Streams = dict[str, np.random.Generator]


def streams(rng: np.random.Generator, count: int) -> list[Streams]:
    """A generator of every kind for each of `count` robots or sensors; they depend on the state of `rng` alone.

    The streams are independent: another sensor, another fault, or a filter that draws from `rng` leaves all other
    numbers as they were. Raises SlamlibError.
    """
    if not isinstance(rng, np.random.Generator):
        raise SlamlibError(f"simulate: rng is a generator, such as np.random.default_rng(1), not {rng!r}")
    seed = rng.integers(2**32, size=4).tolist()
    kinds = (*KINDS, *sorted(set(FAMILIES) - set(KINDS)))
    return [
        {kind: np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(i, k))) for k, kind in enumerate(kinds)}
        for i in range(count)
    ]


def drawn(manifold: Manifold, mean: Array, covariance: Array, rng: np.random.Generator) -> Array:
    """Draw a point (size,) from a Gaussian in the tangent space: mean (size,), covariance (dof, dof)."""
    return manifold.plus(mean, root(covariance) @ rng.standard_normal(manifold.dof))


def root(covariance: Array) -> Array:
    """The symmetric square root of a covariance, which may be singular."""
    values, vectors = np.linalg.eigh(covariance)
    return (vectors * np.sqrt(np.maximum(values, 0))) @ vectors.T


@dataclass(frozen=True)
class Faults:
    """Rates, between 0 and 1, of the features in view that suffer each fault, applied in this order.

    miss: not delivered. outlier: delivered with a measurement unrelated to the landmark, uniform in the image (of
    sensors without one, in the range of all that they can measure). swap: delivered with the id of another one.
    """

    miss: Share = 0.0
    outlier: Share = 0.0
    swap: Share = 0.0

    def __post_init__(self) -> None:
        check(self)


class Clutter:
    """False measurements: uniform in the box of all that a sensor delivers, where they can be back-projected."""

    def __init__(self, calibration: "Calibration", reach: float) -> None:
        self.calibration = calibration
        self.unmeasured = [np.array([1 / reach])] * calibration.sensor.unmeasured
        # bounds (m,) of what it measures of points in all directions, a tenth to the whole of `reach` [m] away
        rng = np.random.default_rng(0)
        rays = rng.standard_normal((DIRECTIONS, 3))
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        points = np.column_stack([rays, 1 / (reach * rng.uniform(0.1, 1, DIRECTIONS))])
        values = calibration.project(points[calibration.visible(points)])
        values = values[calibration.inside(values)]
        if not len(values):
            name = calibration.sensor.name
            raise SlamlibError(f"a {name} sees nothing within {reach:g} m, so it has no outliers either")
        self.low, self.high = values.min(0), values.max(0)
        if calibration.image is not None:
            self.low[:2], self.high[:2] = 0, calibration.image

    def draw(self, rng: np.random.Generator) -> Array:
        """Draw one measurement (m,). Raises SlamlibError if none is found."""
        for _ in range(TRIES):
            measurement = rng.uniform(self.low, self.high)
            with suppress(SingularPointError):
                if self.calibration.visible(self.calibration.back_project_jac(measurement, *self.unmeasured)[0]):
                    return measurement
        raise SlamlibError(f"of {TRIES} random measurements of a {self.calibration.sensor.name} none is a possible one")


def swapped(ids: Indices, rate: float, rng: np.random.Generator) -> Indices:
    """Swap ids: each is exchanged with another one with probability rate / 2: a share of about `rate` is wrong."""
    ids = ids.copy()
    chosen = np.flatnonzero(rng.random(len(ids)) < rate / 2)
    for one in chosen if len(ids) > 1 else ():
        other = (one + rng.integers(1, len(ids))) % len(ids)
        ids[[one, other]] = ids[[other, one]]
    return ids


class SimulatedSensor:
    """A true sensor. If its extrinsics are estimated, the true ones are drawn around the mean given to the filter.

    Noise is drawn for all features of the world in each frame, in view or not: so it depends on the seed alone, and
    runs that differ in their faults, paths or filters have the same noise.
    """

    def __init__(self, setup: SensorSetup, world: World, faults: Faults, shortest: float, streams: Streams) -> None:
        self.robot, self.world, self.faults, self.shortest = setup.robot, world, faults, shortest
        self.calibration, self.streams = setup.calibration, streams
        self.extrinsics = read_only_copy(drawn(Pose, setup.extrinsics, setup.covariance, streams["extrinsics"]))
        self.root = root(self.calibration.noise)
        self.clutter = Clutter(self.calibration, _reach(world)) if faults.outlier else None
        for name, family in FAMILIES.items():
            if len(world.of(name)):
                family.check(setup.name, self.calibration)

    def scan(self, robot: Array) -> Scan:
        """Measure with the robot at a pose (7,)."""
        camera = compose(robot, self.extrinsics)
        return Scan({name: self._features(family, camera) for name, family in FAMILIES.items()})

    def _features(self, family: AnyFamily, camera: Array) -> Features:
        things, size = self.world.of(family.name), len(self.root)
        if not len(things) or not family.supports(self):
            return Features.none(family.size(self.calibration))
        shape = (len(things), size) if family.parts == 1 else (len(things), family.parts, size)
        noise = self.streams[family.name].standard_normal(shape) @ self.root
        rows, values = family.simulate(self, camera, things.values, noise)
        return self._faulty(things.ids[rows], values, family.parts)

    def hidden(self, points: Array, camera: Array) -> Mask:
        """Mask (n,) of the points (n, 3) that the world's faces hide from a pose (7,)."""
        return hidden(points, self.world.faces, camera[:3])

    def longest_seen(self, segments: Array, camera: Array) -> tuple[Array, Mask]:
        """The longest visible part (k, 2, 3) of each segment, and the mask (k,) of those visible at all."""
        return longest_seen(segments, self.world.faces, camera[:3])

    def _faulty(self, ids: Indices, values: Array, parts: int) -> Features:
        """Apply the faults to features; an outlier is made of `parts` false measurements (a segment's: 2)."""
        rng, faults = self.streams["faults"], self.faults
        miss, replace = rng.random((2, len(ids)))
        if self.clutter is not None:
            values = values.copy()
            for row in np.flatnonzero(replace < faults.outlier):
                values[row] = np.concatenate([self.clutter.draw(rng) for _ in range(parts)])
        found = miss >= faults.miss
        return Features(swapped(ids[found], faults.swap, rng), values[found])


def _reach(world: World) -> float:
    """The size of the world [m], from corner to corner, at least 1."""
    each = [(FAMILIES[name].parts, features.values) for name, features in world.features.items()]
    places = np.concatenate([values[:, : 3 * parts].reshape(-1, 3) for parts, values in each])
    return max(1.0, float(np.linalg.norm(np.ptp(places, axis=0)))) if len(places) else 1.0
