"""A back-projection in two stages: an implicit model, then an explicit one, and the chain rule between them."""

import numpy as np
from numpy.typing import ArrayLike

from slamlib.manifolds import Array
from slamlib.models import Argument, Formula, Jacobians, Model
from slamlib.models.implicit import Implicit


class BackProjection(Formula):
    """The homogeneous point (..., 4) of a measurement: inner(pixel, ...) gives its ray, outer the point.

    The measurement's first numbers, as many as `inner` solves for, are its pixel. outer(ray, rest) takes the others as
    its second argument; where there are none, it takes the unmeasured number, `unmeasured`. Any more arguments of outer
    are parameters that inner has, too, by their names.
    """

    def __init__(self, inner: Implicit, outer: Model, *, size: int) -> None:
        self.inner, self.outer = inner, outer
        self.pixel = inner.arguments[0].size
        self.measures_all = size > self.pixel
        self.shared = [inner.parameters[1:].index(name) for name in outer.parameters[2:]]
        open_ones = [] if self.measures_all else [Argument("unmeasured", outer.arguments[1].size)]
        super().__init__("back_project", [Argument("measurement", size), *open_ones, *inner.arguments[1:]])

    def __call__(self, *args: ArrayLike, **kwargs: ArrayLike) -> Array:
        """The point of a measurement (..., m); raises ShapeError, NonFiniteError, SingularPointError."""
        pixel, rest, parameters = self._split(args, kwargs)
        return self.outer(self.inner(pixel, *parameters), rest, *[parameters[i] for i in self.shared])

    def jac(self, *args: ArrayLike, **kwargs: ArrayLike) -> tuple[Array, Jacobians]:
        """The point, and its Jacobians w.r.t. each argument."""
        pixel, rest, parameters = self._split(args, kwargs)
        ray, inner = self.inner.jac(pixel, *parameters)
        point, (by_ray, by_rest, *direct) = self.outer.jac(ray, rest, *[parameters[i] for i in self.shared])
        by_pixel, *by_parameters = [by_ray @ part for part in inner]
        for i, part in zip(self.shared, direct, strict=True):
            by_parameters[i] = by_parameters[i] + part
        measured = [np.concatenate([by_pixel, by_rest], axis=-1)] if self.measures_all else [by_pixel, by_rest]
        return point, self._jacobians(*measured, *by_parameters)

    def _split(self, args: tuple[ArrayLike, ...], kwargs: dict[str, ArrayLike]) -> tuple[Array, Array, list[Array]]:
        measurement, *given = self._bind(args, kwargs)
        self.arguments[0].check(measurement, self.name)
        numbers = measurement.astype(float, copy=False)
        rest, given = (numbers[..., self.pixel :], given) if self.measures_all else (given[0], given[1:])
        batch = np.broadcast_shapes(numbers.shape[:-1], *(g.shape[:-1] for g in given))
        return np.broadcast_to(numbers[..., : self.pixel], (*batch, self.pixel)), rest, given
