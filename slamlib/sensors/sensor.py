"""The interface of a type of sensor, and a sensor of that type with its calibration."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.kalman.linalg import covariance
from slamlib.manifolds import Array, Indices, Manifold, Mask, angles_of, as_manifold, finite, numbers, read_only_copy
from slamlib.models import Formula, Jacobians, Model
from slamlib.registry import TypeDescription


@dataclass(frozen=True)
class Sensor(TypeDescription):
    """A type of sensor: name, models, the names of its parameters in the models' order, and its rules.

    project(point, **parameters): measurement (m,) of a homogeneous point (4,) in the sensor's frame (axes right, down,
    front for cameras). back_project(measurement, unmeasured, **parameters): homogeneous point, |h| = 1 where only a ray
    is measured; `unmeasured` is what is not measured (for a camera: the inverse distance); a complete sensor
    has no such argument. visible(point, calibration): mask of the points that can be measured at all, by the
    sensor's own rule; whether a pixel lies in the image is tested afterwards, for all sensors alike. check(calibration)
    raises SlamlibError for invalid parameters. limits: the names of those that bound its view, such as
    "near" [m], and may be left out; None: any. project_line(line, **parameters it has): homogeneous image
    line (3,) of a line in Pluecker coordinates (6,). pixels: the first two numbers of a measurement are a pixel, which
    an image can bound. A model may also be an object with the same calls, as Implicit is. plane: it measures along its
    x-y plane and knows nothing of a point's height, so that it initializes points of the plane alone. initializes:
    False where no Gaussian describes what is not measured, such as a direction: then it initializes no landmarks.
    """

    name: str
    project: Formula
    back_project: Formula
    parameters: tuple[str, ...]
    visible: Callable[[Array, "Calibration"], Mask]
    check: Callable[["Calibration"], None] | None = None
    project_line: Model | None = None
    pixels: bool = False
    limits: tuple[str, ...] | None = None
    plane: bool = False
    initializes: bool = True

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.initializes and any(a.size != 1 for a in self.back_project.arguments if a.name == "unmeasured"):
            raise SlamlibError(
                f"Sensor {self.name!r}: a filter has a prior for one unmeasured number, the inverse distance; a sensor "
                "that leaves more unmeasured says initializes=False, and updates what others have initialized"
            )

    @cached_property
    def size(self) -> int:
        """Number of numbers in a measurement."""
        return int(self.back_project.arguments[0].size)

    @cached_property
    def unmeasured(self) -> int:
        """Number of arguments of back_project for what is not measured: one, or none."""
        return len(self.back_project.arguments) - 1 - len(self.parameters)

    @cached_property
    def manifold(self) -> Manifold:
        """Manifold of measurements: their difference is manifold.minus(measured, predicted)."""
        result = getattr(self.project, "result", None)
        return result.manifold if result is not None else as_manifold(self.size)

    @cached_property
    def angles(self) -> Indices:
        """Which numbers of a measurement are angles [rad]."""
        return angles_of(self.manifold)


class Calibration:
    """A sensor of a type: its parameters, its noise, and its image.

    noise: covariance (m, m) of a measurement. image: (width, height) [px], or None; for sensors with pixels only.
    limits: for the type's rule of visibility, such as {"angle": 1.6} [rad]. parameters: by name; lists of
    coefficients may be shorter than the model's, since the missing ones are zero. Arrays are copied and read-only, and
    no attribute can be set: another calibration is another object. Raises SlamlibError, naming the parameter.
    """

    sensor: Sensor
    limits: dict[str, float]
    image: Any  # (width, height) of the image (2,), or None
    noise: Array
    given: dict[str, Array]

    def __init__(
        self,
        sensor: Sensor,
        noise: ArrayLike,
        *,
        image: Any = None,
        limits: dict[str, float] | None = None,
        **parameters: ArrayLike,
    ) -> None:
        for name in parameters:
            if name not in sensor.parameters:
                raise UnknownNameError.of(f"parameter of {sensor.name}", name, sensor.parameters)
        missing = [n for n in sensor.parameters if n not in parameters]
        if missing:
            raise SlamlibError(f"{sensor.name}: the calibration lacks {', '.join(missing)}")
        if not isinstance(limits or {}, dict):
            raise SlamlibError(f'{sensor.name}: limits are given by name, such as {{"angle": 1.6}}, got {limits!r}')
        if image is not None and not sensor.pixels:
            raise SlamlibError(
                f"{sensor.name}: its measurements are no pixels, so there is no image to bound them; leave image out, "
                "and bound the view by limits (a type that measures pixels says so: Sensor(..., pixels=True))"
            )
        size = None if image is None else read_only_copy(finite(image, (2,), sensor.name, "image"))
        if size is not None and not (size > 0).all():
            raise SlamlibError(f"{sensor.name}: an image has a width and a height above zero, got {image}")
        largest = {a.name: a.size for a in sensor.project.arguments}
        given = {n: _given(sensor.name, n, parameters[n], largest[n]) for n in sensor.parameters}
        self.sensor, self.image, self.limits = sensor, size, _limits(sensor, limits or {})
        self.noise = read_only_copy(covariance(noise, sensor.size, sensor.name, "noise"))
        self.given = given  # last: nothing can be set from here on
        if sensor.check is not None:
            sensor.check(self)

    def __setattr__(self, name: str, value: object) -> None:
        if "given" in vars(self):  # it is complete
            raise SlamlibError(f"a calibration cannot be changed: make another one with the {name} that you want")
        super().__setattr__(name, value)

    @cached_property
    def _project(self) -> tuple[Formula, list[Array]]:
        """The model for the given number of coefficients, and all parameters in its order; they never change."""
        project = self.sensor.project
        given = [self.given[name] for name in project.parameters[1:]]
        if not isinstance(project, Model):
            return project, given
        return project.shortened(project.arguments[0].size, *map(len, given)), given

    def project(self, point: Array) -> Array:
        """Measurements (..., m) of homogeneous points (..., 4) in the sensor's frame."""
        model, parameters = self._project
        return model(point, *parameters)

    def project_jac(self, point: Array) -> tuple[Array, Jacobians]:
        """Measurements (..., m), and Jacobians w.r.t. the point and each parameter as it was given."""
        model, parameters = self._project
        return model.jac(point, *parameters)

    def back_project_jac(self, measurement: Array, *unmeasured: Array) -> tuple[Array, Jacobians]:
        """Homogeneous points (..., 4), and Jacobians w.r.t. measurement, unmeasured number, and each parameter."""
        return self.sensor.back_project.jac(measurement, *unmeasured, **self.given)

    def visible(self, point: Array) -> Mask:
        """Mask (...) of the homogeneous points (..., 4) that the sensor can measure, but for the image's border."""
        return self.sensor.visible(np.asarray(point), self)

    def inside(self, measurement: ArrayLike, margin: float = 0.0) -> Mask:
        """Mask of the measurements whose first two numbers lie in the image, `margin` [px] from its border."""
        if self.image is None:
            return np.ones(np.shape(measurement)[:-1], dtype=bool)
        pixel = np.asarray(measurement)[..., :2]
        if pixel.ndim == 1:  # a single one: the fast path
            (u, v), (width, height) = pixel.tolist(), self.image.tolist()
            one: Any = np.bool_(margin <= u <= width - margin and margin <= v <= height - margin)
            return one
        inside: Any = ((pixel >= margin) & (pixel <= self.image - margin)).all(-1)
        return inside


def _limits(sensor: Sensor, limits: dict[str, float]) -> dict[str, float]:
    """Check limits: known names, numbers from zero on; `near` is below `far`."""
    found = {}
    for name, value in limits.items():
        if sensor.limits is not None and name not in sensor.limits:
            raise UnknownNameError.of(f"limit of {sensor.name}", name, sensor.limits)
        number = numbers(value, sensor.name, f"the limit {name!r}")
        if number.ndim or not number >= 0:
            raise ShapeError(f"{sensor.name}: the limit {name!r} should be a number, zero or more, got {value!r}")
        found[name] = float(number)
    near, far = found.get("near", 0.0), found.get("far", np.inf)
    if near >= far:
        raise SlamlibError(f"{sensor.name}: the limit 'near' ({near}) should be less than 'far' ({far})")
    return found


def _given(sensor: str, name: str, value: ArrayLike, largest: int) -> Array:
    """A read-only copy of a parameter's numbers as given."""
    array = np.atleast_1d(numbers(value, sensor, name))
    if array.ndim != 1 or len(array) > largest:
        raise ShapeError(f"{sensor}: {name} has at most {largest} numbers, got shape {array.shape}")
    return read_only_copy(finite(array, array.shape, sensor, name))
