"""What goes wrong with real sensors, at given rates: features are missed, replaced by nonsense, or taken for others."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from slamlib.data.plain import Range, check
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.manifolds import Array, Indices
from slamlib.sensors.sensor import Calibration

TRIES = 1000
Share = Annotated[float, Range(ge=0, le=1)]


@dataclass(frozen=True)
class Faults:
    """Shares, between 0 and 1, of the features in view that fall to each fault, in this order.

    miss: not delivered. outlier: delivered with a measurement that has nothing to do with the landmark, uniform in the
    image (of sensors without one, in all that they can measure). swap: delivered with the id of another one in view.
    """

    miss: Share = 0.0
    outlier: Share = 0.0
    swap: Share = 0.0

    def __post_init__(self) -> None:
        check(self)


class Clutter:
    """Measurements of nothing: uniform in the box of all that a sensor delivers, where they can be back-projected."""

    def __init__(self, calibration: Calibration, reach: float) -> None:
        self.calibration = calibration
        arguments = len(calibration.sensor.back_project.arguments) - 1 - len(calibration.sensor.parameters)
        self.unmeasured = [np.array([1 / reach])] * arguments
        self.low, self.high = _box(calibration, reach)

    def draw(self, rng: np.random.Generator) -> Array:
        """One measurement (m,). Raises SlamlibError if none is found."""
        for _ in range(TRIES):
            measurement = rng.uniform(self.low, self.high)
            if self._possible(measurement):
                return measurement
        raise SlamlibError(f"of {TRIES} random measurements of a {self.calibration.sensor.name} none is a possible one")

    def _possible(self, measurement: Array) -> bool:
        try:
            point, _ = self.calibration.back_project_jac(measurement, *self.unmeasured)
        except SingularPointError:
            return False
        return bool(self.calibration.visible(point))


def _box(calibration: Calibration, reach: float, count: int = 4096) -> tuple[Array, Array]:
    """Smallest and largest numbers (m,) that it delivers of points all around, a tenth to the whole of `reach` away."""
    rng = np.random.default_rng(0)
    rays = rng.standard_normal((count, 3))
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    points = np.column_stack([rays, 1 / (reach * rng.uniform(0.1, 1, count))])
    values = calibration.project(points[calibration.visible(points)])
    values = values[calibration.inside(values)]
    if not len(values):
        raise SlamlibError(f"a {calibration.sensor.name} sees nothing within {reach:g} m, so it has no outliers either")
    low, high = values.min(0), values.max(0)
    if calibration.image is not None:
        low[:2], high[:2] = 0, calibration.image
    return low, high


def swapped(ids: Indices, rate: float, rng: np.random.Generator) -> Indices:
    """The ids, of which each trades places with another with probability rate / 2: a share of about `rate` is wrong."""
    ids = ids.copy()
    chosen = np.flatnonzero(rng.random(len(ids)) < rate / 2)
    for one in chosen if len(ids) > 1 else ():
        other = (one + rng.integers(1, len(ids))) % len(ids)
        ids[[one, other]] = ids[[other, one]]
    return ids
