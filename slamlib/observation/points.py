"""A sensor on a robot observes points: the chain rule, once, for every pair of a sensor and a parametrization.

landmark --to_frame--> homogeneous point in the sensor's frame --project--> measurement, and back.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Annotated

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import Landmark, RigSensor
from slamlib.entities.landmark import landmark_means, state_rows
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry.pose import ORIGIN, compose
from slamlib.kalman.linalg import principal_blocks
from slamlib.landmarks import POINTS
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.linearity import THRESHOLD, beyond_infinity, should_convert, to_euclidean
from slamlib.landmarks.parametrization import PointLandmark
from slamlib.landmarks.plane_idp_point import PLANE_IDP_POINT
from slamlib.landmarks.plane_point import PLANE_POINT
from slamlib.manifolds import Array, Indices, Mask
from slamlib.models import Jacobians
from slamlib.observation.family import Family, FamilyOptions, TrueSensor, product, state_columns, viewpoint
from slamlib.plain_data.fields import NotNegative, OneOf, Range
from slamlib.sensors.sensor import Calibration, Sensor

EUCLIDEAN = {False: EUC_POINT, True: PLANE_POINT}  # what a point is converted to, in space or in the plane
PLACEHOLDER_POINT = np.array([0.25, 0.5, 1, 1])  # for points that cannot be measured: so their rows are finite


class NamedJacobians(SimpleNamespace):
    """Jacobians by the names of their arguments, as attributes; iterated in their order, as those of a model are."""

    def __iter__(self) -> Iterator[Array]:
        return iter(vars(self).values())


@dataclass(frozen=True)
class Observation:
    """Predicted measurements of landmarks: values (..., m), the mask of those in view, and Jacobians.

    jacobians.robot (..., m, 6), .extrinsics (..., m, 6), .landmark (..., m, dof), and one for each parameter of the
    sensor. The rows of landmarks out of view hold meaningless numbers. in_frame: the landmarks in the
    sensor's frame, homogeneous points (..., 4) or lines in Pluecker coordinates (..., 6).
    """

    value: Array
    visible: Mask
    jacobians: NamedJacobians
    in_frame: Array

    @property
    def depth(self) -> Array:
        """Depth of points in front of the sensor (...) [m], along its z axis; infinite for a point at infinity."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(self.in_frame[..., 2] / self.in_frame[..., 3])


def observe(
    kind: PointLandmark, calibration: Calibration, robot: Array, extrinsics: Array, landmarks: Array
) -> Observation:
    """Predict the measurements of landmarks (..., size) from a robot's pose (7,) and the sensor's extrinsics (7,).

    Raises SlamlibError for what is no point. Chapter pinhole, the chain rule of (ph-chain).
    """
    camera, by_camera = compose.jac(robot, extrinsics)
    found = observe_from(kind, calibration, camera, landmarks)
    parts = dict(vars(found.jacobians))
    return replace(found, jacobians=NamedJacobians(**through(by_camera, parts.pop("camera")), **parts))


def observe_from(kind: PointLandmark, calibration: Calibration, camera: Array, landmarks: Array) -> Observation:
    """The same from the sensor's own pose (7,) in the world: jacobians.camera (..., m, 6) is w.r.t. that one."""
    _check_point(kind, calibration, "observe")
    point, by_frame = kind.to_frame.jac(camera, landmarks)
    seen = calibration.visible(point)
    measurable = point if seen.all() else np.where(seen[..., None], point, PLACEHOLDER_POINT)
    value, by_sensor = calibration.project_jac(measurable)
    jacobians = NamedJacobians(
        camera=product(by_sensor.point, by_frame.pose),
        landmark=product(by_sensor.point, by_frame[1]),
        **{n: getattr(by_sensor, n) for n in calibration.given},
    )
    return Observation(value, seen & calibration.inside(value), jacobians, point)


def initialize(
    kind: PointLandmark,
    calibration: Calibration,
    robot: Array,
    extrinsics: Array,
    measurement: Array,
    *unmeasured: Array,
) -> tuple[Array, NamedJacobians]:
    """Initialize a landmark from a measurement (..., m) and a prior of the unmeasured numbers (..., u); with Jacobians.

    jacobians.robot (..., dof, 6), .extrinsics (..., dof, 6), .measurement (..., dof, m), .unmeasured (..., dof, u) if
    the sensor leaves something unmeasured, and one for each parameter of the sensor. Raises SlamlibError for what is no
    point, and for an `unmeasured` that is missing, superfluous, or a negative inverse distance.
    """
    _check_point(kind, calibration, "initialize")
    wanted = calibration.sensor.unmeasured
    if len(unmeasured) != wanted:
        what = "a prior of what it does not measure" if wanted else "no prior, since it measures all three coordinates"
        raise SlamlibError(f"initialize: a {calibration.sensor.name} needs {what}; got {len(unmeasured)} arrays")
    for argument, array in zip(calibration.sensor.back_project.arguments, (measurement, *unmeasured), strict=False):
        argument.check(np.asarray(array), "initialize")
    if calibration.sensor.plane != kind.plane:
        raise SlamlibError(f"initialize: {_not_of_the_plane(kind, calibration.sensor)}")
    camera, by_camera = compose.jac(robot, extrinsics)
    point, by_sensor = calibration.back_project_jac(measurement, *unmeasured)
    if unmeasured and (point[..., 3] < 0).any():
        raise SlamlibError("initialize: the prior puts a point beyond infinity: its inverse distance is negative")
    landmark, by_frame = kind.from_frame.jac(camera, point)
    _seen_again(kind, camera, point, landmark)
    jacobians = NamedJacobians(
        **through(by_camera, by_frame.pose),
        measurement=product(by_frame.point, by_sensor[0]),
        **({"unmeasured": product(by_frame.point, by_sensor[1])} if unmeasured else {}),
        **{n: product(by_frame.point, getattr(by_sensor, n)) for n in calibration.given},
    )
    return landmark, jacobians


def _check_point(kind: object, calibration: object, function: str) -> None:
    if not isinstance(calibration, Calibration):
        raise SlamlibError(f"{function}: the second argument is a Calibration, not {type(calibration).__name__}")
    if not isinstance(kind, PointLandmark):
        raise SlamlibError(
            f"{function}: a {calibration.sensor.name} is asked for {getattr(kind, 'name', kind)!r}, which is no point; "
            f"points are in slamlib.landmarks.POINTS, lines are for slamlib.observation.lines.{function}_line"
        )


def _not_of_the_plane(kind: PointLandmark, sensor: Sensor) -> str:
    """Why one cannot initialize the other, of which only one is of the plane."""
    if sensor.plane:
        return f"a {sensor.name} measures no height, and {kind.name} is a point in space: use one of the plane"
    return f"a {sensor.name} measures in space, and {kind.name} lies on the floor: use a point in space"


def _seen_again(kind: PointLandmark, camera: Array, point: Array, landmark: Array) -> None:
    """Raise SingularPointError if a new landmark is not where it was measured: not every type holds every point."""
    turned = (kind.to_frame(camera, landmark)[..., :3] * point[..., :3]).sum(-1) <= 0
    if turned.any():
        example = np.broadcast_to(point, (*turned.shape, 4))[turned][0]
        raise SingularPointError(
            f"{kind.name} cannot hold the point {example.tolist()} (h, w) of the sensor's frame: mask such "
            "measurements, or hold them as another type"
        )


def through(by_camera: Jacobians, by_pose: Array) -> dict[str, Array]:
    """Jacobians w.r.t. the robot and the extrinsics, from a Jacobian w.r.t. the camera's pose."""
    both = product(by_pose, np.concatenate([by_camera.outer, by_camera.inner], axis=-1))
    return {"robot": both[..., :6], "extrinsics": both[..., 6:]}


@dataclass(frozen=True, repr=False)
class PointOptions(FamilyOptions):
    """Options of points, as slamlib.Options explains them."""

    points: Annotated[str, OneOf(POINTS)] | None = "idpPnt"
    convert: bool = True
    convert_below: NotNegative = THRESHOLD
    margin: Annotated[float, Range(ge=0, lt=0.5)] = 0.04


class PointFamily(Family[PointOptions]):
    """Points: every sensor measures them."""

    name = "points"
    kinds = PointLandmark
    parametrizations = POINTS
    exact = EUC_POINT

    def chosen(self, options: PointOptions) -> str | None:
        """The name of the parametrization of new points, or None for none."""
        return options.points

    def new_kind(self, options: PointOptions, sensor: RigSensor) -> PointLandmark | None:
        """As of every family; a sensor of the plane has points of the plane where the options say some in space.

        Raises SlamlibError for points of the plane and a sensor in space, and for a choice of its own that it cannot
        initialize.
        """
        kind, type_ = super().new_kind(options, sensor), sensor.calibration.sensor
        if not isinstance(kind, PointLandmark) or not type_.initializes:
            return None
        if kind.plane == type_.plane:
            return kind
        if kind.plane or sensor.landmark is not None:
            raise SlamlibError(f"{sensor.name}: {_not_of_the_plane(kind, type_)}")
        return PLANE_IDP_POINT if type_.unmeasured else PLANE_POINT

    def usable(self, sensor: RigSensor, values: Array, options: PointOptions) -> Mask:
        """Mask (n,) of the measurements (n, m) that may initialize a landmark: not too near the image's border."""
        image = sensor.calibration.image
        return sensor.calibration.inside(values, 0.0 if image is None else options.margin * image[0])

    def observe(
        self, kind: PointLandmark, calibration: Calibration, camera: Array, means: Array
    ) -> tuple[Array, Mask, NamedJacobians]:
        """As `observe_from`."""
        found = observe_from(kind, calibration, camera, means)
        return found.value, found.visible, found.jacobians

    def innovation_input(self, calibration: Calibration, in_frame: Array) -> Array:
        """Predicted measurements of homogeneous points (..., 4) in the sensor's frame; nan where it cannot see them."""
        seen = calibration.visible(in_frame)[..., None]
        return np.where(seen, calibration.project(np.where(seen, in_frame, PLACEHOLDER_POINT)), np.nan)

    def initialize(
        self, sensor: RigSensor, kind: PointLandmark, value: Array, options: PointOptions
    ) -> tuple[Array, Array, list[Array]]:
        """Mean, own noise and Jacobians w.r.t. robot and extrinsics of a new point. Chapter initialization."""
        mean, std = options.inverse_distance
        calibration = sensor.calibration
        prior = [np.array([mean])] * calibration.sensor.unmeasured
        x, J = initialize(kind, calibration, sensor.robot.pose, sensor.extrinsics, value, *prior)
        own = J.measurement @ calibration.noise @ J.measurement.T
        if prior:
            own = own + J.unmeasured @ J.unmeasured.T * std**2
        return x, own, [J.robot, J.extrinsics]

    def after_update(
        self, belief: Belief, sensor: RigSensor, landmarks: list[Landmark], measured: Array, options: PointOptions
    ) -> None:
        """After a measurement update: convert points that are known well enough to Euclidean ones. Chapter points."""
        kind = landmarks[0].kind
        euclidean = EUCLIDEAN[kind.plane]
        if not options.convert or kind is euclidean:
            return
        view = viewpoint(sensor)
        columns, dof = state_columns(sensor, landmarks), landmarks[0].block.dof
        T = np.zeros((dof + 6, columns.shape[1]))  # from (robot, extrinsics, landmark) to (landmark, camera)
        T[:dof, -dof:], T[dof:, :-dof] = np.eye(dof), view.jacobian
        means, P = landmark_means(landmarks), principal_blocks(belief.matrix, columns)
        ripe = should_convert(kind, means, P, view.pose, options.convert_below, T)
        for landmark, is_ripe in zip(landmarks, ripe.tolist(), strict=True):
            if is_ripe:
                point, by = to_euclidean(kind, landmark.block.mean)  # on the floor without its height
                size = euclidean.manifold.size
                belief.replace(landmark.block, euclidean.manifold, point[:size], by[:size])
                landmark.kind = euclidean

    def invalid(self, belief: Belief, landmarks: list[Landmark]) -> set[Landmark]:
        """The landmarks, of one kind, that lie beyond infinity, where no point can be. Chapter points."""
        kind = landmarks[0].kind
        if kind is EUCLIDEAN[kind.plane]:
            return set()
        means = landmark_means(landmarks)
        if (kind.to_frame(ORIGIN, means)[:, 3] >= 0).all():
            return set()  # mostly the case: quick, without Jacobians
        beyond = beyond_infinity(kind, means, principal_blocks(belief.matrix, state_rows(landmarks)))
        return {landmarks[i] for i in np.flatnonzero(beyond)}

    def geometry(self, belief: Belief, landmarks: list[Landmark]) -> tuple[Array, Array, Mask]:
        """Points (n, 3) in the world and their covariances (n, 3, 3); nan for those at infinity."""
        geometry, covariance = np.full((len(landmarks), 3), np.nan), np.full((len(landmarks), 3, 3), np.nan)
        for i, landmark in enumerate(landmarks):
            h, J = landmark.kind.to_frame.jac(ORIGIN, landmark.block.mean)
            if h[3] > 0:
                by = (J.landmark[:3] - np.outer(h[:3], J.landmark[3]) / h[3]) / h[3]
                geometry[i], covariance[i] = h[:3] / h[3], by @ belief.covariance(landmark.block) @ by.T
        converged = np.array([landmark.kind is EUCLIDEAN[landmark.kind.plane] for landmark in landmarks], dtype=bool)
        return geometry, covariance, converged

    def simulate(self, sensor: TrueSensor, camera: Array, places: Array, noise: Array) -> tuple[Indices, Array]:
        """Measurements of points in view and not occluded, with noise, if they are still in the image with it."""
        calibration = sensor.calibration
        inside = EUC_POINT.to_frame(camera, places)
        seen = np.flatnonzero(calibration.visible(inside) & ~sensor.hidden(places, camera))
        values = calibration.sensor.manifold.plus(calibration.project(inside[seen]), noise[seen])
        delivered = calibration.inside(values)
        return seen[delivered], values[delivered]


POINT_FAMILY = PointFamily()
