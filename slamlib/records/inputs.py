"""The filter's inputs and the ground truth: frozen, arrays only.

A filter gets frames, and cannot tell whether a simulator, a file or a camera made them. The ground truth, where
there is one, is passed separately, to the evaluation alone.
"""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.kalman.linalg import covariance
from slamlib.manifolds import Array, Indices, finite, numbers, read_only, read_only_copy

if TYPE_CHECKING:
    from slamlib.models import Model


@dataclass(frozen=True, eq=False)
class Features:
    """Measured features: ids (n,), unique integers, and one row of numbers for each, values (n, m)."""

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
        if not np.diff(np.sort(ids)).all():
            raise SlamlibError("Features: an id appears twice; what is seen twice in one image has two ids")
        object.__setattr__(self, "ids", read_only(np.array(ids, np.int64)))
        object.__setattr__(self, "values", read_only_copy(values))

    def __len__(self) -> int:
        return len(self.ids)

    @classmethod
    def none(cls, size: int) -> "Features":
        """Return no feature, of `size` numbers each."""
        return cls(np.zeros(0, np.int64), np.zeros((0, size)))


NO_FEATURES = Features.none(0)


def _keep(record: "Control | RobotMeasurement", name: str) -> None:
    """Check the value (m,) of a record and its noise (m, m), and keep read-only copies."""
    value = finite(record.value, (None,), name, "value")
    object.__setattr__(record, "value", read_only_copy(value))
    object.__setattr__(record, "covariance", read_only_copy(covariance(record.covariance, value.size, name, "noise")))


@dataclass(frozen=True, eq=False)
class Control:
    """A control input, or its measurement by odometry, in one step: value (c,), and its noise (c, c)."""

    value: Array
    covariance: Array

    def __post_init__(self) -> None:
        _keep(self, "Control")


class ByFamily:
    """Features by the name of their family, those of slamlib.observation.FAMILIES."""

    features: dict[str, Features]

    def of(self, family: str) -> Features:
        """The features of a family; none if there are none of them."""
        return self.features.get(family, NO_FEATURES)

    @property
    def points(self) -> Features:
        """The points."""
        return self.of("points")

    @property
    def segments(self) -> Features:
        """The segments."""
        return self.of("segments")


@dataclass(frozen=True, eq=False)
class Scan(ByFamily):
    """One sensor's measurements in one frame: features by the name of their family, and an image if it has one.

    Families are those of slamlib.observation.FAMILIES: "points" (n, m), "segments" (k, 4) [px], ...
    """

    features: dict[str, Features] = field(default_factory=dict)
    image: Any = None  # one picture (h, w), a pair (2, h, w), or None


@dataclass(frozen=True, eq=False)
class RobotMeasurement:
    """A robot's measurement of its own pose without any landmark: a position by GPS, a heading.

    model(pose): the predicted measurement (m,) at a pose (7,), a Model; a result on a manifold (`returns`) is
    subtracted there. value (m,), noise (m, m); robot: its index.
    """

    name: str
    model: "Model"
    value: Array
    covariance: Array
    robot: int = 0

    def __post_init__(self) -> None:
        _keep(self, self.name)


@dataclass(frozen=True, eq=False)
class Frame:
    """One instant: its number, the time dt [s] since the one before, a control per robot, and a scan per sensor.

    A robot without a control (None) is predicted with a control of zeros and the noise of its setup. absolute: the
    robots' measurements of themselves, used before the scans.
    """

    number: int
    dt: float
    controls: tuple[Control | None, ...]
    scans: tuple[Scan, ...]
    absolute: tuple[RobotMeasurement, ...] = ()


@dataclass(frozen=True, eq=False)
class Truth:
    """Ground truth at one frame: the robots' states, the sensors' extrinsics (7,), and the robots' poses (7,)."""

    robots: tuple[Array, ...]
    extrinsics: tuple[Array, ...]
    poses: tuple[Array, ...]


@dataclass(frozen=True, eq=False)
class World(ByFamily):
    """Everything there is to observe: features by the name of their family, and opaque triangles (f, 3, 3) [m].

    Families are those of slamlib.observation.FAMILIES: "points" (n, 3), "segments" (n, 6), two endpoints each, ... in
    the world [m]. No id is used twice. Triangles occlude what lies behind them in simulations with occlusion.
    """

    features: dict[str, Features] = field(default_factory=dict)
    faces: Array = field(default_factory=lambda: np.zeros((0, 3, 3)))

    def __post_init__(self) -> None:
        given = {"points": Features.none(3), "segments": Features.none(6), **self.features}
        object.__setattr__(self, "features", given)
        object.__setattr__(self, "faces", read_only_copy(finite(self.faces, (None, 3, 3), "World", "faces")))
        ids = np.concatenate([features.ids for features in self.features.values()])
        if not np.diff(np.sort(ids)).all():
            raise SlamlibError("World: things of two families share an id; number segments after the points")
