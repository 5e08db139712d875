"""Run a generated function: for one item on Python's floats, for a batch on arrays; and report singular points.

A generated function takes the stored numbers of each argument and returns a tuple of entries: those of the value, then
those of each Jacobian, row by row. Entries that are constant are Python integers.
"""

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from math import isfinite
from typing import Any

import numpy as np

from slamlib.errors import ShapeError, SingularPointError
from slamlib.manifolds import Array, all_finite, ranges
from slamlib.models.argument import Argument

Shape = tuple[int, ...]
_FLOAT = np.dtype(float)
_FEW = 10  # items up to which a loop over Python's floats is faster than arrays


class Kernel:
    """A generated function with the shapes of its arguments and of the arrays that its entries fill."""

    def __init__(
        self, function: Callable[..., tuple[Any, ...]], name: str, arguments: list[Argument], shapes: list[Shape]
    ) -> None:
        self.function, self.name, self.arguments, self.shapes = function, name, arguments, shapes
        self.pieces = ranges(map(math.prod, shapes))
        self.single_shapes = [a.shape for a in arguments]
        pairs = enumerate(arguments)
        self.points = [
            (i, a.manifold, f"{name}: argument '{a.name}'") for i, a in pairs if a.is_manifold and a.manifold
        ]
        self.written: list[int] | None = None

    def single(self, arguments: list[Array]) -> list[Array] | None:
        """Value and Jacobians of one item of finite floats; None for all else, which needs the full checks."""
        numbers = []
        for value, shape in zip(arguments, self.single_shapes, strict=True):
            if value.shape != shape or value.dtype != _FLOAT:
                return None
            row = value.ravel().tolist()
            if not isfinite(sum(row)):
                return None
            numbers.append(row)
        for i, manifold, what in self.points:
            manifold.check(arguments[i], what)
        return self._one(numbers, _FLOAT)

    def __call__(self, arguments: list[Array]) -> list[Array]:
        """Value and Jacobians of checked arrays."""
        batches = [v.shape[: v.ndim - len(a.shape)] for a, v in zip(self.arguments, arguments, strict=True)]
        dtype = np.result_type(*arguments)
        dtype = dtype if dtype.kind in "fc" else np.dtype(float)
        if not any(batches) and dtype.kind == "f":
            return self._one([a.astype(float, copy=False).ravel().tolist() for a in arguments], dtype)
        batch = common(self.name, self.arguments, batches)
        if dtype == _FLOAT and 0 < math.prod(batch) <= _FEW:
            return self._few(arguments, batches, batch)
        return self._many(arguments, batches, batch, dtype)

    def _one(self, numbers: list[list[float]], dtype: np.dtype[Any]) -> list[Array]:
        """One item: plain Python floats are several times faster than arrays of length one."""
        entries = self._entries(numbers)
        if entries is None:
            raise self._singular(f"{numbers}", numbers)
        flat = np.array(entries, dtype=dtype)
        return [flat[piece].reshape(shape) for piece, shape in zip(self.pieces, self.shapes, strict=True)]

    def _few(self, arguments: list[Array], batches: list[Shape], batch: Shape) -> list[Array]:
        """A small batch: item by item, each on Python's floats, while that is faster than arrays."""
        entries: list[float] = []
        rows = [self._items(v, a, lead, batch) for a, v, lead in zip(self.arguments, arguments, batches, strict=True)]
        for item, numbers in enumerate(zip(*rows, strict=True)):
            found = self._entries(numbers)
            if found is None:
                raise self._singular(_item(np.unravel_index(item, batch)), numbers)
            entries += found
        flat = np.array(entries, dtype=float).reshape(*batch, -1)
        return [flat[..., at].reshape(batch + shape) for at, shape in zip(self.pieces, self.shapes, strict=True)]

    def _items(self, value: Array, argument: Argument, lead: Shape, batch: Shape) -> list[list[float]]:
        """An argument's numbers, item by item."""
        count = math.prod(batch)
        if not lead:
            return [value.ravel().tolist()] * count
        whole = value if lead == batch else np.broadcast_to(value, batch + argument.shape)
        return whole.reshape(count, argument.size).tolist()

    def _entries(self, numbers: Sequence[list[float]]) -> tuple[float, ...] | None:
        """Value and Jacobians of one item as plain numbers; None if one of them is not finite."""
        try:
            entries: tuple[float, ...] = self.function(*numbers)
        except (ZeroDivisionError, ValueError, OverflowError):
            return None
        # the sum is fast, and infinite also where finite entries overflow together
        return entries if isfinite(sum(entries)) or all(map(isfinite, entries)) else None

    def _singular(self, where: str, numbers: Sequence[Iterable[Any]]) -> SingularPointError:
        what = f"{self.name} is not defined, or has no derivative, at {where}"
        largest = max((abs(n) for argument in numbers for n in argument), default=0)
        if largest > math.sqrt(sys.float_info.max):
            what += f": {largest:g} is too large: its square is beyond the range of floats"
        return SingularPointError(what)

    def _many(self, arguments: list[Array], batches: list[Shape], batch: Shape, dtype: np.dtype[Any]) -> list[Array]:
        """A batch: entries first, items last, so that each operation runs over contiguous memory."""
        rows = [
            self._rows(v, a.size, lead, dtype) for a, v, lead in zip(self.arguments, arguments, batches, strict=True)
        ]
        with np.errstate(all="ignore"):
            block = self._gather(self.function(*rows), batch, dtype)
            fine = all_finite(block)
        if not fine:
            place = tuple(np.argwhere(~np.isfinite(block))[0][1:])
            alone = [row.reshape(len(row), *(1,) * (len(batch) + 1 - row.ndim), *row.shape[1:]) for row in rows]
            numbers = [np.broadcast_to(row, (len(row), *batch))[(slice(None), *place)] for row in alone]
            raise self._singular(_item(place), numbers)
        return [block[piece].reshape(shape + batch).transpose(axes) for piece, shape, axes in self._layout(len(batch))]

    @cache  # noqa: B019 - kernels live as long as their model
    def _layout(self, batch: int) -> list[tuple[slice, Shape, Shape]]:
        """For the value and each Jacobian: its entries, its shape, and the order of axes that puts the items first."""
        return [
            (piece, shape, (*range(len(shape), len(shape) + batch), *range(len(shape))))
            for piece, shape in zip(self.pieces, self.shapes, strict=True)
        ]

    def _rows(self, value: Array, size: int, lead: Shape, dtype: np.dtype[Any]) -> Array:
        """The stored numbers of an argument, each over all items; plain scalars if the argument is not batched."""
        flat = value.reshape((*lead, size)).astype(dtype, copy=False)
        return np.ascontiguousarray(flat.transpose(len(lead), *range(len(lead)))) if lead else flat

    def _gather(self, entries: tuple[Any, ...], batch: Shape, dtype: np.dtype[Any]) -> Array:
        """All entries in one array (entries, *batch); which of them are always zero is noted in the first call."""
        if self.written is None:
            self.written = [i for i, e in enumerate(entries) if type(e) is not int or e != 0]
        block = np.zeros((len(entries), *batch), dtype=dtype)
        for i in self.written:
            block[i] = entries[i]
        return block


def _item(place: Iterable[Any]) -> str:
    return f"item {tuple(map(int, place))} of the batch"


def common(name: str, arguments: list[Argument], batches: list[Shape]) -> Shape:
    """The shape of a batch, to which the leading axes of the arguments broadcast."""
    leads = {b for b in batches if b}
    if len(leads) == 1:
        return leads.pop()
    try:
        return np.broadcast_shapes(*leads)
    except ValueError:
        given = ", ".join(f"{a.name} {b}" for a, b in zip(arguments, batches, strict=True))
        raise ShapeError(f"{name}: the leading axes do not broadcast together: {given}") from None
