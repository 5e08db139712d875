"""What a type of sensor must offer, and a sensor of that type with its calibration."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.kalman.linalg import covariance, finite, numbers, read_only_copy
from slamlib.manifolds import Array, Manifold, Mask, as_manifold
from slamlib.model import Formula, Model


@dataclass(frozen=True)
class Sensor:
    """A type of sensor: name, models, the names of its parameters in the models' order, and its rules.

    project(point, **parameters): measurement (m,) of a homogeneous point (4,) in the sensor's frame (axes right, down,
    front for cameras). back_project(measurement, unmeasured, **parameters): homogeneous point, |h| = 1 where only a ray
    is measured; `unmeasured` is what the measurement does not tell (a camera: the inverse distance), and a sensor that
    tells all has no such argument. visible(point, calibration): mask of the points that can be measured at all, by the
    sensor's own rule; whether a pixel lies in the image is asked afterwards, for all sensors alike. check(calibration)
    raises SlamlibError for parameters that make no sense. limits: the names of those that bound its view, such as
    "near" [m], and may be left out; None: it takes any. project_line(line, **parameters it has): homogeneous image
    line (3,) of a line in Pluecker coordinates (6,). pixels: the first two numbers of a measurement are a pixel, which
    an image can bound. A model may also be an object with the same calls, as Implicit is.
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

    @cached_property
    def size(self) -> int:
        """Numbers in a measurement."""
        return int(self.back_project.arguments[0].size)

    @cached_property
    def unmeasured(self) -> int:
        """Arguments of back_project that say what a measurement does not tell: one, or none."""
        return len(self.back_project.arguments) - 1 - len(self.parameters)

    @cached_property
    def manifold(self) -> Manifold:
        """Where measurements live: their difference is space.minus(measured, expected)."""
        result = getattr(self.project, "result", None)
        return result.manifold if result is not None else as_manifold(self.size)


class Calibration:
    """A sensor of a type: its parameters, its noise, and its image.

    noise: covariance (m, m) of a measurement. image: (width, height) [px], or None; for sensors with pixels only.
    limits: what the type's rule of visibility asks for, such as {"angle": 1.6} [rad]. parameters: by name; lists of
    coefficients may be shorter than the model's, since the missing ones are zero. Arrays are copied and read-only, and
    no attribute can be set: another calibration is another object. Raises SlamlibError, naming the parameter.
    """

    sensor: Sensor
    limits: dict[str, float]
    image: Any  # (width, height) of the image (2,), or None
    noise: Array
    given: dict[str, Array]
    padded: dict[str, Array]

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
        self.__dict__.update(
            sensor=sensor,
            limits=_limits(sensor, limits or {}),
            image=size,
            noise=read_only_copy(covariance(noise, sensor.size, sensor.name, "noise")),
            given=given,
            padded={n: read_only_copy(np.pad(v, (0, largest[n] - len(v)))) for n, v in given.items()},
        )
        if sensor.check is not None:
            sensor.check(self)

    def __setattr__(self, name: str, value: Any) -> None:
        raise SlamlibError(f"a calibration cannot be changed: make another one with the {name} that you want")

    @cached_property
    def _short(self) -> tuple[Model, list[Array]] | None:
        """The model for as many coefficients as are given, and these in its order; None where it is no model, or a list
        holds none."""
        project, given = self.sensor.project, self.given
        if not isinstance(project, Model) or not all(map(len, given.values())):
            return None
        short = project.shortened(*(len(given[a.name]) if a.name in given else a.size for a in project.arguments))
        return (short, [given[name] for name in short.parameters[1:]]) if short else None

    def project(self, point: Array) -> Array:
        """Measurements (..., m) of homogeneous points (..., 4) in the sensor's frame."""
        if self._short:
            model, parameters = self._short
            return model(point, *parameters)
        return self.sensor.project(point, **self.padded)

    def project_jac(self, point: Array) -> tuple[Array, Any]:
        """Measurements, and Jacobians by the point and by each parameter as it was given."""
        if self._short:
            model, parameters = self._short
            return model.jac(point, *parameters)
        return self._jac(self.sensor.project, (point,))

    def back_project_jac(self, measurement: Array, *unmeasured: Array) -> tuple[Array, Any]:
        """Homogeneous points (..., 4), and Jacobians by the measurement, what it does not tell, and each parameter."""
        return self._jac(self.sensor.back_project, (measurement, *unmeasured))

    def _jac(self, model: Formula, arguments: tuple[Array, ...]) -> tuple[Array, Any]:
        value, jacobians = model.jac(*arguments, **self.padded)
        return value, jacobians._replace(**{n: getattr(jacobians, n)[..., : len(v)] for n, v in self.given.items()})

    def visible(self, point: Array) -> Mask:
        """Mask (...) of the homogeneous points (..., 4) that the sensor can measure, before the image is looked at."""
        return self.sensor.visible(np.asarray(point), self)

    def inside(self, measurement: ArrayLike, margin: float = 0.0) -> Mask:
        """Mask of the measurements whose first two numbers lie in the image, `margin` [px] from its border."""
        if self.image is None:
            return np.ones(np.shape(measurement)[:-1], dtype=bool)
        pixel = np.asarray(measurement)[..., :2]
        if pixel.ndim == 1:  # a single one, quickly
            (u, v), (width, height) = pixel.tolist(), self.image.tolist()
            one: Any = np.bool_(margin <= u <= width - margin and margin <= v <= height - margin)
            return one
        inside: Any = ((pixel >= margin) & (pixel <= self.image - margin)).all(-1)
        return inside


def _limits(sensor: Sensor, limits: dict[str, float]) -> dict[str, float]:
    """Limits by known names, numbers from zero on; `near` is below `far`."""
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
    """A parameter's numbers as they were given, a read-only copy."""
    array = np.atleast_1d(numbers(value, sensor, name))
    if array.ndim != 1 or len(array) > largest:
        raise ShapeError(f"{sensor}: {name} has at most {largest} numbers, got shape {array.shape}")
    return read_only_copy(finite(array, array.shape, sensor, name))
