"""The filter's inputs and the ground truth: frozen, arrays only.

A filter gets frames, and cannot tell whether a simulator, a file or a camera made them. The ground truth, where
there is one, is passed separately, to the evaluation alone.
"""

from dataclasses import InitVar, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from slamlib.errors import NonFiniteError, ShapeError, SlamlibError
from slamlib.kalman.linalg import covariance
from slamlib.manifolds import Array, angles_of, check_turns, finite, numbers, read_only_copy, whole_rows
from slamlib.records.ids import Id, Ids, ids_of, joined

if TYPE_CHECKING:
    from slamlib.models import Model


@dataclass(frozen=True, eq=False)
class Features:
    """Measured features: ids (n,), unique integers or strings, and one row of numbers for each, values (n, m).

    Rows of masked arrays in which anything is masked are left out, and those of the id `unknown`: data sets write -1,
    say, where they do not know what was measured. Raises SlamlibError.

        >>> import slamlib as sl
        >>> from slamlib.records.inputs import Features
        >>> Features([7, -1, 8, -1], [[1, 0], [2, 0], [3, 0], [4, 0]], unknown=-1).ids.tolist()
        [7, 8]
    """

    ids: Ids
    values: Array
    unknown: InitVar[Id | None] = None

    def __post_init__(self, unknown: Id | None) -> None:
        keep = whole_rows(self.ids, self.values)
        given, rows = (
            (self.ids, self.values) if keep is None else (np.asarray(self.ids)[keep], np.ma.getdata(self.values)[keep])
        )
        ids, values = ids_of(given, "Features: ids"), numbers(rows, "Features", "values")
        if unknown is not None and len(values) == len(ids):
            known = [value != unknown for value in ids.tolist()]
            ids, values = ids[known], values[known]
        if values.ndim != 2 or len(values) != len(ids):
            raise ShapeError(f"Features: {len(ids)} ids need values of shape ({len(ids)}, m), got {values.shape}")
        if not np.isfinite(values).all():
            raise NonFiniteError("Features: values hold nan or infinity; leave such rows out")
        if len(set(ids.tolist())) < len(ids):
            raise SlamlibError(
                "Features: an id appears twice; what is seen twice in one image has two ids (and where an id says that "
                "what was measured is not known, as -1 may: Features(ids, values, unknown=-1) leaves those rows out)"
            )
        object.__setattr__(self, "ids", ids)
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
        manifold = self.model.result.manifold if self.model.result else None
        if manifold is not None:
            check_turns(self.value[None], angles_of(manifold), f"{self.name}:")


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
        ids = joined(features.ids for features in self.features.values())
        if len(set(ids)) < len(ids):
            raise SlamlibError("World: things of two families share an id; number segments after the points")
