"""What the filter shows of itself at one frame: all that pictures and evaluations get to see. Frozen, arrays only."""

from dataclasses import dataclass

from slamlib.data.records import ByFamily, Scan
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Image, Mask


@dataclass(frozen=True, eq=False)
class RobotView:
    """A robot as it is estimated: name, state (size,) whose first seven numbers are the pose, covariance (dof, dof)."""

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
    """How a sensor looked at the landmarks of one family (points, segments, ...) in one frame.

    One row for each landmark that it expected to see: ids (n,), kinds, what it expected (n, m) (of a segment: its two
    ends in the image) with the covariance (n, d, d) of the innovation, what it measured (n, m) (nan where nothing was
    looked for or found), masks (n,) chosen, matched, inlier, and z' S^-1 z (n,) (nan where nothing was matched).

    What not every look has: of a segment endpoints (n, 2, 2), where the filter puts its two ends in the image after the
    frame, with their covariances (n, 2, 2, 2) [px^2], nan for points and for ends out of view; from a front end that
    looks at images scores (n,), nan where there is none, and for each look the patch that was predicted and the one
    that was found there, as grey images or None.
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
class SensorView(ByFamily):
    """A sensor as it is estimated, what it delivered, and what it looked at.

    extrinsics (7,) on robot number `robot`, with covariance (6, 6), zero where it is given; image (width, height) or
    None; predictions: by the family's name; view.points is view.looks["points"].
    """

    _FAMILIES = "predictions"
    name: str
    robot: int
    extrinsics: Array
    extrinsics_covariance: Array
    image: Image | None
    scan: Scan | None
    predictions: dict[str, MeasurementView]


@dataclass(frozen=True, eq=False)
class MapView:
    """Landmarks of one family as they are estimated: ids (n,), kinds, geometry [m], covariance, converged (n,).

    Points: geometry (n, 3), covariance (n, 3, 3); nan where the estimate lies at infinity. Segments: both ends,
    (n, 2, 3) and (n, 2, 3, 3). converged: points that are held as Euclidean ones; lines whose ends are known, in their
    worst direction, to a tenth of the length between them.
    """

    ids: Array
    kinds: tuple[str, ...]
    geometry: Array
    covariance: Array
    converged: Mask


@dataclass(frozen=True, eq=False)
class Snapshot(ByFamily):
    """Everything that a picture or an evaluation needs of the filter after one frame; nothing of it changes later.

    time [s] since the start; landmarks: by the family's name, snapshot.points is snapshot.landmarks["points"]; size:
    degrees of freedom of the whole state.
    """

    _FAMILIES = "landmarks"
    number: int
    time: float
    robots: tuple[RobotView, ...]
    sensors: tuple[SensorView, ...]
    landmarks: dict[str, MapView]
    size: int

    def camera(self, sensor: int) -> Array:
        """Pose (7,) of a sensor in the world."""
        view = self.sensors[sensor]
        return compose(self.robots[view.robot].pose, view.extrinsics)
