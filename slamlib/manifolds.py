"""The spaces of arguments: arrays and their checks, vectors, and manifolds whose stored size and dof differ."""

import cmath
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import accumulate, pairwise
from numbers import Real
from typing import Any, Protocol, TypeAlias, TypeVar

import numpy as np
from numpy.ma import MaskedArray
from numpy.typing import ArrayLike, NDArray

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError, UnitError

Array: TypeAlias = NDArray[np.float64]
Mask: TypeAlias = NDArray[np.bool_]
Indices: TypeAlias = NDArray[np.integer[Any]]
Image: TypeAlias = NDArray[Any]  # grey values, as bytes or as floats
AnyArray = TypeVar("AnyArray", bound=NDArray[Any])


def numbers(value: ArrayLike, function: str, argument: str) -> Array:
    """Convert to an array of floats.

    Raises SlamlibError for text, complex numbers, lists of unequal lengths, and arrays in which something is masked.
    """
    if isinstance(value, MaskedArray) and (hidden := np.argwhere(np.ma.getmaskarray(value))).size:
        where = tuple(int(i) for i in hidden[0])
        raise SlamlibError(f"{function}: {argument} is masked at index {where}: leave out what is not known")
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O":
            if not all(isinstance(entry, Real) for entry in array.flat):
                raise TypeError(_no_number(array))
            array = array.astype(float)
        if array.dtype.kind in "cSUMm":
            raise TypeError(f"it holds {array.dtype}")
        return array.astype(float, copy=False)
    except (OverflowError, TypeError, ValueError) as error:
        raise SlamlibError(f"{function}: {argument} should be an array of real numbers: {error}") from None


def real(array: NDArray[Any], function: str, argument: str) -> NDArray[Any]:
    """An array of objects that are all numbers, such as a data frame's, as one of floats; others, of symbols, as it is.

    Raises SlamlibError where it holds None or text.
    """
    if array.dtype.char != "O":
        return array
    if any(isinstance(entry, str | bytes | type(None)) for entry in array.flat):
        return numbers(array, function, argument)  # which says what is wrong
    plain = all(isinstance(entry, int | float | np.number) for entry in array.flat)
    return array.astype(float) if plain else array


def _no_number(array: NDArray[Any]) -> str:
    """What of an array of objects is no real number."""
    place = next(place for place in np.ndindex(array.shape) if not isinstance(array[place], Real))
    where = f" at index {place}" if array.ndim else ""
    shown = ascii(array[place]) if isinstance(array[place], str) else array[place]
    return f"it holds {shown} ({type(array[place]).__name__}){where}"


def whole_rows(*arrays: ArrayLike) -> Mask | None:
    """Mask (n,) of the rows in which no array is masked; None where none of them is a masked array."""
    masked = [np.ma.getmaskarray(a) for a in arrays if isinstance(a, MaskedArray)]
    if not masked:
        return None
    keep: Mask = ~np.logical_or.reduce([mask.reshape(len(mask), -1).any(1) for mask in masked])
    return keep


def all_finite(array: NDArray[Any]) -> bool:
    """Whether all numbers are finite: mostly the sum of their squares tells, in half the time."""
    return cmath.isfinite(np.vdot(array, array)) or bool(np.isfinite(array).all())


def finite(value: ArrayLike, shape: tuple[int | None, ...] | None, function: str, argument: str) -> Array:
    """Convert to an array of finite floats of this shape, where None is any length, or any shape.

    Raises ShapeError, NonFiniteError.
    """
    array = numbers(value, function, argument)
    if shape is not None and array.shape != shape:
        free = len(shape) == array.ndim and all(m in (None, n) for n, m in zip(array.shape, shape, strict=True))
        if not free:
            form = str(shape).replace("None", "n")
            raise ShapeError(f"{function}: {argument} should have shape {form}, but has shape {array.shape}")
    if not all_finite(array):
        where = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise NonFiniteError(f"{function}: {argument} holds {array[where]} at index {where}; leave it out")
    return array


def read_only_copy(array: ArrayLike) -> Array:
    """Return a read-only copy, of floats."""
    return read_only(np.array(array, dtype=float))


def read_only(array: AnyArray) -> AnyArray:
    """Make an array read-only and return it: for arrays that nobody else holds."""
    array.flags.writeable = False
    return array


class Manifold(Protocol):
    """Interface of a block's space: sizes, and addition (retraction) and subtraction of a tangent vector."""

    @property
    def size(self) -> int: ...

    @property
    def dof(self) -> int: ...

    def plus(self, point: Array, step: Array) -> Array: ...

    def minus(self, point: Array, origin: Array) -> Array: ...

    def check(self, point: Array, what: str) -> None: ...

    def random(self, rng: np.random.Generator) -> Array: ...


@dataclass(frozen=True)
class Euclidean:
    """Vectors of `size` numbers: plus and minus are addition and subtraction."""

    size: int

    @property
    def dof(self) -> int:
        return self.size

    def plus(self, point: Array, step: Array) -> Array:
        """Return point + step."""
        return point + step

    def minus(self, point: Array, origin: Array) -> Array:
        """Return point - origin."""
        return point - origin

    def check(self, point: Array, what: str) -> None:
        """Accept every vector."""

    def random(self, rng: np.random.Generator) -> Array:
        """Draw a standard normal vector."""
        return rng.standard_normal(self.size)

    def __repr__(self) -> str:
        return f"Euclidean({self.size})"


@dataclass(frozen=True)
class Angle(Euclidean):
    """Angles: the difference of two is wrapped to [-pi, pi]. Chapter depth_stereo_range, eq. (dp-wrap)."""

    def minus(self, point: Array, origin: Array) -> Array:
        """Return point - origin, in [-pi, pi] [rad]."""
        difference = np.asarray(point) - np.asarray(origin)
        return np.asarray(difference - 2 * np.pi * np.rint(difference.real / (2 * np.pi)))

    def __repr__(self) -> str:
        return f"Angle({self.size})"


@dataclass(frozen=True, repr=False)
class CustomManifold:
    """Unit vectors of `size` numbers with `dof` degrees of freedom, with the models of plus and minus."""

    name: str
    size: int
    dof: int
    plus: Callable[[Array, Array], Array]
    minus: Callable[[Array, Array], Array]

    def check(self, point: Array, what: str) -> None:
        """Raise UnitError unless the points have unit length (to 1e-6, half the digits; 1e-3 in float32)."""
        tolerance = 2e-3 if point.dtype == np.float32 else 2e-6
        if point.ndim == 1 and abs(sum([x * x for x in point.tolist()]) - 1) <= tolerance:
            return  # a single one: the fast path
        with np.errstate(over="ignore"):
            squared = np.einsum("...i,...i", point, point)
        wrong = np.abs(squared - 1) > tolerance
        if wrong.any():
            worst = np.sqrt(np.max(np.where(wrong, squared, 0)))
            raise UnitError(
                f"{what} should be a {self.name}, but has length {worst:.6g}. "
                "Nothing is normalised silently: divide it by its norm, or find out why it drifted."
            )

    def random(self, rng: np.random.Generator) -> Array:
        """Draw a point uniformly."""
        point = rng.standard_normal(self.size)
        return point / np.sqrt(point @ point)

    def __repr__(self) -> str:
        return self.name


class Product:
    """A product of manifolds, side by side in one vector; plus and minus act part by part.

    Pose is one: a position and a unit quaternion, seven numbers with six degrees of freedom. Its steps are a
    displacement [m] in the world's axes and a rotation vector [rad] in the frame's own.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> ahead, turned = np.array([1, 0, 0, 1, 0, 0, 0]), np.array([2, 0, 0, np.sqrt(0.5), 0, 0, np.sqrt(0.5)])
        >>> sl.Pose.minus(turned, ahead).round(3).tolist()  # a metre along x, a quarter turn about z
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.571]
        >>> bool(np.allclose(sl.Pose.plus(ahead, sl.Pose.minus(turned, ahead)), turned))
        True
        >>> sl.Pose2.minus(np.array([1, 2, 3.1]), np.array([0, 2, -3.1])).round(3).tolist()  # in the plane
        [1.0, 0.0, -0.083]
    """

    def __init__(self, name: str, *parts: Manifold) -> None:
        self.name, self.parts = name, parts
        self._stored, self._tangent = ranges(p.size for p in parts), ranges(p.dof for p in parts)
        self.size, self.dof = self._stored[-1].stop, self._tangent[-1].stop

    def split(self, vector: Array, dof: bool = False) -> list[Array]:
        """The parts' pieces of a point (..., size); dof: of a tangent vector (..., dof)."""
        numbers = np.asarray(vector)
        return [numbers[..., at] for at in (self._tangent if dof else self._stored)]

    def plus(self, point: Array, step: Array) -> Array:
        """Move each part by its piece of `step`; shapes (..., size), (..., dof)."""
        self._size(point, self.size, "point")
        self._size(step, self.dof, "step")
        pieces = zip(self.parts, self.split(point), self.split(step, dof=True), strict=True)
        return np.concatenate([part.plus(x, d) for part, x, d in pieces], axis=-1)

    def minus(self, point: Array, origin: Array) -> Array:
        """Return the tangent vector from `origin` to `point`; shapes (..., size) each."""
        self._size(point, self.size, "point")
        self._size(origin, self.size, "origin")
        pieces = zip(self.parts, self.split(point), self.split(origin), strict=True)
        return np.concatenate([part.minus(x, y) for part, x, y in pieces], axis=-1)

    def check(self, point: Array, what: str) -> None:
        """Check each part."""
        for part, at in zip(self.parts, self._stored, strict=True):
            part.check(point[..., at], what)

    def random(self, rng: np.random.Generator) -> Array:
        """Draw each part independently."""
        return np.concatenate([part.random(rng) for part in self.parts])

    def _size(self, vector: Array, size: int, what: str) -> None:
        if np.shape(vector)[-1:] != (size,):
            raise ShapeError.of(self.name, what, (size,), np.shape(vector))

    def __repr__(self) -> str:
        return self.name


def ranges(sizes: Iterable[int]) -> list[slice]:
    """The slices of parts of these sizes, one after the other."""
    return [slice(*stops) for stops in pairwise(accumulate(sizes, initial=0))]


def as_manifold(spec: "int | Manifold") -> Manifold:
    """The manifold of `spec`: an int n means vectors of n numbers."""
    if isinstance(spec, int):
        if spec < 1:
            raise SlamlibError(f"a space needs at least one number, got {spec}")
        return Euclidean(spec)
    if not hasattr(spec, "minus"):
        raise SlamlibError(f"{spec!r} is no space: give an int, or an object with size, dof, plus and minus")
    return spec


def angles_of(manifold: Manifold) -> Indices:
    """Which numbers of a space of vectors are angles [rad]: those in which a whole turn makes no difference."""
    turn = np.full(manifold.size, 2 * np.pi)
    flat = manifold.size == manifold.dof
    return np.flatnonzero(np.abs(manifold.minus(turn, 0 * turn)) < 1) if flat else np.zeros(0, dtype=int)


def check_turns(values: Array, angles: Indices, what: str) -> None:
    """Raise UnitError where a measured angle in the rows (n, m) is beyond a turn: it will be in degrees."""
    beyond = np.abs(values[:, angles]) > 2 * np.pi
    if beyond.any():
        place = np.argwhere(beyond)[0]
        row, column = int(place[0]), int(angles[place[1]])
        raise UnitError(
            f"{what} number {column} of row {row} is the angle {values[row, column]:g}, above a turn: angles are in "
            "radians (np.radians), and a sensor counts no turns: (a + pi) % (2 pi) - pi takes them off"
        )
