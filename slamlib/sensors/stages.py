"""A back-projection in two stages: an implicit model, then an explicit one, and the chain rule between them."""

from collections import namedtuple
from typing import Any

import numpy as np

from slamlib.errors import NonFiniteError, ShapeError
from slamlib.manifolds import Array
from slamlib.model import Argument, Model
from slamlib.modeling.implicit import Implicit


class BackProjection:
    """The homogeneous point (..., 4) of a measurement: inner(pixel, ...) gives its ray, outer the point.

    The measurement's first numbers, as many as `inner` solves for, are its pixel. outer(ray, rest) takes the others as
    its second argument; where there are none, it takes what the measurement does not tell, `unmeasured`.
    """

    def __init__(self, inner: Implicit, outer: Model, *, size: int) -> None:
        self.inner, self.outer = inner, outer
        self.name = "back_project"
        self.pixel = inner.arguments[0].size
        self.measures_all = size > self.pixel
        open_ones = [] if self.measures_all else [Argument("unmeasured", outer.arguments[1].size)]
        self.arguments = [Argument("measurement", size), *open_ones, *inner.arguments[1:]]
        self.parameters = [a.name for a in self.arguments]
        self._jacobians = namedtuple("back_project_jacobians", self.parameters)  # type: ignore[misc]

    def __call__(self, measurement: Array, *others: Array, **named: Array) -> Array:
        """The point of a measurement (..., m); raises ShapeError, NonFiniteError, SingularPointError."""
        pixel, rest, parameters = self._split(measurement, others, named)
        return self.outer(self.inner(pixel, *parameters), rest)

    def jac(self, measurement: Array, *others: Array, **named: Array) -> tuple[Array, Any]:
        """The point, and its Jacobians by each argument."""
        pixel, rest, parameters = self._split(measurement, others, named)
        ray, inner = self.inner.jac(pixel, *parameters)
        point, outer = self.outer.jac(ray, rest)
        by_pixel, *by_parameters = [outer[0] @ part for part in inner]
        measured = [np.concatenate([by_pixel, outer[1]], axis=-1)] if self.measures_all else [by_pixel, outer[1]]
        return point, self._jacobians(*measured, *by_parameters)

    def _split(self, measurement: Array, others: Any, named: Any) -> tuple[Array, Array, list[Array]]:
        given = [*others, *(named[n] for n in self.parameters[1 + len(others) :])]
        size, numbers = self.arguments[0].size, np.asarray(measurement, dtype=float)
        if numbers.shape[-1:] != (size,):
            raise ShapeError.of(self.name, "measurement", (size,), numbers.shape)
        if not np.isfinite(numbers).all():
            raise NonFiniteError(f"{self.name}: argument 'measurement' holds nan or infinity; remove or mask it")
        rest, given = (numbers[..., self.pixel :], given) if self.measures_all else (given[0], given[1:])
        batch = np.broadcast_shapes(numbers.shape[:-1], *(np.shape(g)[:-1] for g in given))
        return np.broadcast_to(numbers[..., : self.pixel], (*batch, self.pixel)), rest, given
