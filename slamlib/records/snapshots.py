"""The filter's output at one frame: everything that displays and evaluations get. Frozen, arrays only."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from slamlib.geometry.euler import from_rotation
from slamlib.geometry.pose import compose
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import Array, Image, Mask
from slamlib.plain_data.tables import html_table
from slamlib.records.ids import Id, Ids
from slamlib.records.inputs import Scan


@dataclass(frozen=True, eq=False, repr=False)
class RobotView:
    """An estimated robot: name, state (size,), covariance (dof, dof), and the pose (7,) that follows from the state.

    pose_covariance (6, 6): of the position [m] in world axes, and the rotation vector [rad] in the robot's.
    """

    name: str
    state: Array
    covariance: Array
    pose: Array
    pose_covariance: Array

    @property
    def mean(self) -> Array:
        """The mean (size,): `state` by its other name."""
        return self.state

    @property
    def std(self) -> Array:
        """Standard deviations (dof,)."""
        return standard_deviations(self.covariance)

    def __repr__(self) -> str:
        """Where it is, and how surely."""
        std = standard_deviations(self.pose_covariance)
        euler = np.degrees(from_rotation(rotation(self.pose[3:]))).round(1) + 0.0  # no -0.0
        return (
            f"{self.name}: position {_listed(self.pose[:3], '.3f')} m, std {_listed(std[:3], '.3g')}; "
            f"roll, pitch, yaw {_listed(euler, '.1f')} deg, std {_listed(np.degrees(std[3:]), '.2g')}"
        )


@dataclass(frozen=True, eq=False)
class MeasurementView:
    """A sensor's predictions and measurements of the landmarks of one family (points, segments, ...) in one frame.

    One row for each landmark that was predicted to be in view: ids (n,), kinds, predicted measurements (n, m) (of a
    segment: its two endpoints in the image) with the innovation covariances (n, d, d), measurements (n, m) (nan where
    not searched for or not found), masks (n,) chosen, matched, inlier, and z' S^-1 z (n,) (nan where not matched).

    Optional: of segments endpoints (n, 2, 2), the filter's estimate in the image after the frame, with their
    covariances (n, 2, 2, 2) [px^2], nan for points and for endpoints out of view; from an image front end scores (n,),
    nan where there is none, and for each prediction the predicted patch and the one found, as grey images or None.
    """

    ids: Ids
    kinds: tuple[str, ...]
    expected: Array
    covariance: Array
    measured: Array
    chosen: Mask
    matched: Mask
    inlier: Mask
    nis: Array
    endpoints: Array
    endpoint_covariances: Array
    scores: Array
    predicted_patch: tuple[Array | None, ...]
    found_patch: tuple[Array | None, ...]


@dataclass(frozen=True, eq=False)
class SensorView:
    """An estimated sensor, with its scan, predictions and measurements.

    extrinsics (7,) on robot number `robot`, with covariance (6, 6), zero where they are given; image (width, height) or
    None; predictions: by the family's name. plane: it measures in the plane and tells no heights.
    """

    name: str
    robot: int
    extrinsics: Array
    extrinsics_covariance: Array
    image: Image | None
    scan: Scan | None
    predictions: dict[str, MeasurementView]
    plane: bool = False

    @property
    def points(self) -> MeasurementView:
        """Predictions and measurements of points."""
        return self.predictions["points"]

    @property
    def segments(self) -> MeasurementView:
        """Predictions and measurements of segments."""
        return self.predictions["segments"]


@dataclass(frozen=True, eq=False)
class MapView:
    """Estimated landmarks of one family: ids (n,), kinds, geometry [m], covariance, converged (n,).

    Points: geometry (n, 3), covariance (n, 3, 3); nan where the estimate lies at infinity. Segments: both endpoints,
    (n, 2, 3) and (n, 2, 3, 3). converged: points held as Euclidean ones; lines whose endpoints are known, in their
    worst direction, to a tenth of the length between them.
    """

    ids: Ids
    kinds: tuple[str, ...]
    geometry: Array
    covariance: Array
    converged: Mask


@dataclass(frozen=True, eq=False)
class MappedLandmark:
    """A landmark in the world: its type, mean [m] (3,) and standard deviations (3,); (2, 3) of a segment's endpoints.

    nan where the estimate lies at infinity.
    """

    kind: str
    mean: Array
    std: Array


class Map(Mapping[Id, MappedLandmark]):
    """The estimated landmarks of all families, by their numbers; a notebook shows them as a table.

    >>> import slamlib as sl
    >>> slam = sl.Slam(sl.robot(), sl.relative_position(noise=0.1), options=sl.Options(points="eucPnt"))
    >>> report = slam.step(None, {7: (2.0, 0.0, 1.0)})
    >>> slam.map
    Map of 1 landmark, in metres:
      7 eucPnt    2.000   0.000   1.000   std 0.100 0.100 0.100
    >>> slam.map[7].mean.tolist()
    [2.0, 0.0, 1.0]
    """

    def __init__(self, views: Mapping[str, MapView]) -> None:
        """views: by the name of their family."""
        self._found = {
            number: MappedLandmark(kind, mean, standard_deviations(covariance))
            for view in views.values()
            for number, kind, mean, covariance in zip(
                view.ids.tolist(), view.kinds, view.geometry, view.covariance, strict=True
            )
        }

    def __getitem__(self, number: Id) -> MappedLandmark:
        return self._found[number]

    def __iter__(self) -> Iterator[Id]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def _rows(self) -> Iterator[tuple[str, ...]]:
        """Number, type, means, standard deviations; a segment has two rows."""
        for number, found in self._found.items():
            for mean, std in zip(found.mean.reshape(-1, 3), found.std.reshape(-1, 3), strict=True):
                yield str(number), found.kind, *(f"{round(x, 3) + 0.0:.3f}" for x in (*mean.tolist(), *std.tolist()))

    def __repr__(self) -> str:
        """A line for each landmark."""
        lines = [
            f"{number:>3} {kind} {x:>8} {y:>7} {z:>7}   std {a:>4} {b:>4} {c:>4}"
            for number, kind, x, y, z, a, b, c in self._rows()
        ]
        return "\n".join([f"Map of {len(self)} landmark{'s' * (len(self) != 1)}, in metres:", *lines])

    def _repr_html_(self) -> str:
        """A row for each landmark, two for a segment."""
        return html_table(("", "type", "x [m]", "y [m]", "z [m]", "std x", "std y", "std z"), self._rows())


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Everything that a display or an evaluation needs of the filter after one frame; it never changes.

    time [s] since the start; landmarks: by the family's name; size: degrees of freedom of the whole state.
    """

    number: int
    time: float
    robots: tuple[RobotView, ...]
    sensors: tuple[SensorView, ...]
    landmarks: dict[str, MapView]
    size: int

    @property
    def points(self) -> MapView:
        """The points of the map."""
        return self.landmarks["points"]

    @property
    def segments(self) -> MapView:
        """The lines of the map, as segments."""
        return self.landmarks["segments"]

    @property
    def plane(self) -> bool:
        """Whether all that was measured lies in the plane, so that a map from above shows everything."""
        return all(sensor.plane for sensor in self.sensors)

    def camera(self, sensor: int) -> Array:
        """Pose (7,) of a sensor in the world."""
        view = self.sensors[sensor]
        return compose(self.robots[view.robot].pose, view.extrinsics)


def standard_deviations(covariance: Array) -> Array:
    """Standard deviations (..., n) of covariances (..., n, n)."""
    return np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))


def _listed(values: Array, form: str) -> str:
    return "(" + ", ".join(format(value, form) for value in values.tolist()) + ")"
