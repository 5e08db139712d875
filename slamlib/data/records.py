"""What passes between the world and the filter: frozen, arrays only.

A filter gets frames. Whether a simulator, a file or a camera made them cannot be told from a frame. The truth, where
there is one, travels beside it, to the evaluation alone.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.kalman.linalg import covariance, finite, numbers
from slamlib.manifolds import Array, Indices


@dataclass(frozen=True, eq=False)
class Features:
    """Identified things: ids (n,), integers that do not repeat, and one row of numbers for each, values (n, m)."""

    ids: Indices
    values: Array

    def __post_init__(self) -> None:
        ids, values = np.asarray(self.ids), numbers(self.values, "Features", "values")
        if ids.size == 0:
            ids = ids.astype(np.int64)
        if ids.ndim != 1 or not np.issubdtype(ids.dtype, np.integer):
            raise SlamlibError(f"Features: ids are a list of integers, not {ids.dtype} of shape {ids.shape}")
        if values.ndim != 2 or len(values) != len(ids):
            raise ShapeError(f"Features: {len(ids)} ids need values of shape ({len(ids)}, m), got {values.shape}")
        if not np.isfinite(values).all():
            raise NonFiniteError("Features: values hold nan or infinity; leave such rows out")
        if len(np.unique(ids)) != len(ids):
            raise SlamlibError("Features: an id appears twice; what is seen twice in one image has two ids")
        object.__setattr__(self, "ids", _read_only(ids.astype(np.int64)))
        object.__setattr__(self, "values", _read_only(values))

    def __len__(self) -> int:
        return len(self.ids)

    @classmethod
    def none(cls, size: int) -> "Features":
        """No feature, of `size` numbers each."""
        return cls(np.zeros(0, np.int64), np.zeros((0, size)))


@dataclass(frozen=True, eq=False)
class Control:
    """What a robot was told to do, or felt itself do, in one step: value (c,), and the noise (c, c) in it."""

    value: Array
    covariance: Array

    def __post_init__(self) -> None:
        value = numbers(self.value, "Control", "value")
        value = finite(value, (value.size,), "Control", "value")
        object.__setattr__(self, "value", _read_only(value))
        object.__setattr__(self, "covariance", _read_only(covariance(self.covariance, value.size, "Control", "noise")))


@dataclass(frozen=True, eq=False)
class Scan:
    """What one sensor delivered in one frame: points (n, m), segments (k, 4) [px], and an image if it has one."""

    points: Features
    segments: Features = field(default_factory=lambda: Features.none(4))
    image: Any = None


@dataclass(frozen=True, eq=False)
class Frame:
    """One instant: its number, the time dt [s] since the one before, a control per robot, and a scan per sensor.

    A robot without a control (None) is predicted with a control of zeros and the noise of its setup.
    """

    number: int
    dt: float
    controls: tuple[Control | None, ...]
    scans: tuple[Scan, ...]


@dataclass(frozen=True, eq=False)
class Truth:
    """What really was, at one frame: the robots' states, and the sensors' mounts (7,) on them."""

    robots: tuple[Array, ...]
    mounts: tuple[Array, ...]


@dataclass(frozen=True, eq=False)
class World:
    """What there is to see: points (n, 3), segments (k, 6), two ends each, and opaque triangles (f, 3, 3) [m].

    No id is used twice. Triangles hide what lies behind them, for simulators that ask for it.
    """

    points: Features = field(default_factory=lambda: Features.none(3))
    segments: Features = field(default_factory=lambda: Features.none(6))
    faces: Array = field(default_factory=lambda: np.zeros((0, 3, 3)))

    def __post_init__(self) -> None:
        for name, size in (("points", 3), ("segments", 6)):
            values = getattr(self, name).values
            if values.shape[1] != size:
                raise ShapeError(f"World: {name} have {size} numbers each, got {values.shape[1]}")
        faces = numbers(self.faces, "World", "faces")
        object.__setattr__(self, "faces", _read_only(finite(faces, (len(faces), 3, 3), "World", "faces")))
        if set(self.points.ids.tolist()) & set(self.segments.ids.tolist()):
            raise SlamlibError("World: a point and a segment share an id; number segments after the points")


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    """A read-only copy that keeps its type."""
    array = np.array(array)
    array.flags.writeable = False
    return array
