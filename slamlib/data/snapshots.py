"""The filter's output at one frame: everything that displays and evaluations get. Frozen, arrays only."""

from dataclasses import dataclass

from slamlib.data.records import Scan
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Image, Mask


@dataclass(frozen=True, eq=False)
class RobotView:
    """An estimated robot: name, state (size,) whose first seven numbers are the pose, covariance (dof, dof)."""

    name: str
    state: Array
    covariance: Array

    @property
    def pose(self) -> Array:
        """Pose (7,)."""
        return self.state[:7]

    @property
    def pose_covariance(self) -> Array:
        """Covariance (6, 6) of the pose: position [m] in world axes, rotation vector [rad] in the robot's."""
        return self.covariance[:6, :6]


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

    ids: Array
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
    None; predictions: by the family's name.
    """

    name: str
    robot: int
    extrinsics: Array
    extrinsics_covariance: Array
    image: Image | None
    scan: Scan | None
    predictions: dict[str, MeasurementView]

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

    ids: Array
    kinds: tuple[str, ...]
    geometry: Array
    covariance: Array
    converged: Mask


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

    def camera(self, sensor: int) -> Array:
        """Pose (7,) of a sensor in the world."""
        view = self.sensors[sensor]
        return compose(self.robots[view.robot].pose, view.extrinsics)
