"""An argument of a model: what it is called, its shape, and what values it may have."""

import cmath
import math

import numpy as np
from numpy.ma import MaskedArray

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.manifolds import Array, Manifold, all_finite, as_manifold


class AtMost(int):
    """The size of a list of coefficients that may be shorter: omitted ones are zero and have no Jacobian columns."""


class Argument:
    """One argument of a model, or its result: name, stored shape, and the manifold if it is a vector."""

    def __init__(self, name: str, spec: "int | tuple[int, ...] | Manifold") -> None:
        self.name, self.may_be_shorter = name, isinstance(spec, AtMost)
        self.manifold = None if isinstance(spec, tuple) else as_manifold(spec)
        self.shape = spec if isinstance(spec, tuple) else (self.manifold.size,)  # type: ignore[union-attr]
        self.tangent = self.shape if self.manifold is None else (self.manifold.dof,)
        self.size = math.prod(self.shape)
        self.is_manifold = self.manifold is not None and self.manifold.dof != self.manifold.size

    def __repr__(self) -> str:
        return f"{self.name}: {self.manifold or self.shape}"

    def fitting(self, value: Array) -> "Argument":
        """This argument, or a shortened one for a value (..., n) where the size allows it."""
        shorter = self.may_be_shorter and value.ndim > 0 and value.shape[-1] < self.size
        return Argument(self.name, value.shape[-1:]) if shorter else self

    def check(self, value: Array, owner: str) -> None:
        """Raise ShapeError, NonFiniteError or UnitError, in the name of `owner`, for an invalid value (..., shape)."""
        expected = self.fitting(value).shape if self.may_be_shorter else self.shape
        if expected != value.shape[value.ndim - len(self.shape) :] or value.ndim < len(self.shape):
            raise ShapeError.of(owner, self.name, self.shape, value.shape)
        what = f"{owner}: argument '{self.name}'"
        if isinstance(value, MaskedArray) and np.ma.getmaskarray(value).any():
            raise SlamlibError(f"{what} is masked in part: leave out what is not known")
        if value.dtype.kind not in "fiubc":
            raise ShapeError(f"{what} should hold numbers, but has dtype {value.dtype}")
        few = value.size < 10 and cmath.isfinite(sum(value.ravel().tolist()))  # for a few numbers Python is faster
        if not few and not all_finite(value):
            where = tuple(int(i) for i in np.argwhere(~np.isfinite(value))[0])
            raise NonFiniteError(f"{what} holds {value[where]} at index {where}; leave it out")
        if self.manifold is not None and self.is_manifold and value.dtype.kind != "c":
            self.manifold.check(value, what)
