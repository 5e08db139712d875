"""A snapshot of the filter: copies of its estimates, and of its sensors' predictions and measurements."""

from collections.abc import Mapping, Sequence

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import Landmark, RigSensor, Robot, State
from slamlib.entities.landmark import group_by_kind
from slamlib.geometry.pose import Pose
from slamlib.manifolds import Array
from slamlib.observation.family import AnyFamily, columns_jacobian, state_columns, viewpoint
from slamlib.observation.segments import project_endpoints
from slamlib.records.ids import array_of
from slamlib.records.inputs import Scan
from slamlib.records.snapshots import MapView, MeasurementView, RobotView, SensorView, Snapshot
from slamlib.slam.prediction import Predictions

Families = Mapping[str, AnyFamily]


def robot_view(belief: Belief, robot: Robot) -> RobotView:
    """A robot as it is estimated now."""
    state, P = robot.block.mean.copy(), belief.covariance(robot.block)
    return RobotView(robot.name, state, P, *robot.motion.in_space(state, P))


def map_views(state: State, families: Families) -> dict[str, MapView]:
    """The estimated landmarks, by the name of their family."""
    views = {}
    for family in families.values():
        own = [lm for lm in state.landmarks if isinstance(lm.kind, family.kinds)]
        ids, kinds = array_of([lm.id for lm in own]), tuple(lm.kind.name for lm in own)
        views[family.name] = MapView(ids, kinds, *family.geometry(state.belief, own))
    return views


def snapshot_of(
    state: State,
    families: Families,
    scans: Sequence[Scan | None],
    predictions: Sequence[Predictions],
    *,
    number: int,
    time: float,
) -> Snapshot:
    """A copy of everything that may be shown of a filter, after frame `number` at `time` [s]."""
    belief = state.belief
    robots = tuple(robot_view(belief, robot) for robot in state.robots)
    sensors = []
    for sensor, scan, predicted in zip(state.sensors, scans, predictions, strict=True):
        covariance = np.zeros((Pose.dof, Pose.dof)) if sensor.block is None else belief.covariance(sensor.block)
        views = {f.name: _measurement_view(belief, sensor, f, predicted) for f in families.values()}
        robot, calibration = state.robots.index(sensor.robot), sensor.calibration
        own = sensor.name, robot, sensor.extrinsics.copy(), covariance, calibration.image, scan, views
        sensors.append(SensorView(*own, plane=calibration.sensor.plane))
    return Snapshot(number, time, robots, tuple(sensors), map_views(state, families), belief.size)


def _measurement_view(
    belief: Belief, sensor: RigSensor, family: AnyFamily, predictions: Predictions
) -> MeasurementView:
    own = [prediction for prediction in predictions if prediction.family.name == family.name]
    landmarks, d = [prediction.landmark for prediction in own], len(own[0].S) if own else 2
    size = family.size(sensor.calibration)
    endpoints, endpoint_covariances = endpoints_in_image(belief, sensor, landmarks)
    return MeasurementView(
        ids=array_of([landmark.id for landmark in landmarks]),
        kinds=tuple(landmark.kind.name for landmark in landmarks),
        expected=np.array([prediction.value for prediction in own]).reshape(len(own), size),
        covariance=np.array([prediction.S for prediction in own]).reshape(len(own), d, d),
        measured=np.array([prediction.measured for prediction in own]).reshape(len(own), size),
        chosen=np.array([prediction.chosen for prediction in own], dtype=bool),
        matched=np.array([prediction.matched for prediction in own], dtype=bool),
        inlier=np.array([prediction.inlier for prediction in own], dtype=bool),
        nis=np.array([prediction.nis for prediction in own], dtype=float),
        endpoints=endpoints,
        endpoint_covariances=endpoint_covariances,
        scores=np.array([prediction.score for prediction in own], dtype=float),
        predicted_patch=tuple(prediction.predicted_patch for prediction in own),
        found_patch=tuple(prediction.found_patch for prediction in own),
    )


def endpoints_in_image(belief: Belief, sensor: RigSensor, landmarks: list[Landmark]) -> tuple[Array, Array]:
    """The two endpoints of lines in the image (n, 2, 2) [px] and their covariances (n, 2, 2, 2), as estimated now.

    The covariance is H P H' of robot, extrinsics and line together, for endpoints fixed on the line (in the manual
    Obs.par.endp, fig. 9). Pixel noise is left out: a detected segment ends somewhere else on the line, so this is no
    search region for its endpoint. nan: points, deleted lines, endpoints out of view.
    """
    n, alive, row = len(landmarks), set(belief.blocks), {landmark: i for i, landmark in enumerate(landmarks)}
    endpoints, endpoint_covariances = np.full((n, 2, 2), np.nan), np.full((n, 2, 2, 2), np.nan)
    for group in group_by_kind([lm for lm in landmarks if lm.abscissas is not None and lm.block in alive]):
        rows = [row[landmark] for landmark in group]
        endpoints[rows], endpoint_covariances[rows] = _of_one_kind(belief, sensor, group)
    return endpoints, endpoint_covariances


def _of_one_kind(belief: Belief, sensor: RigSensor, landmarks: list[Landmark]) -> tuple[Array, Array]:
    view, abscissas = viewpoint(sensor), np.array([landmark.abscissas for landmark in landmarks])
    shown = project_endpoints(sensor.calibration, view.pose, landmarks, abscissas)
    by = columns_jacobian(view, shown.point_by_pose, shown.point_by_end @ shown.end_by_line)
    H, columns = shown.pixel_by_point @ by, state_columns(sensor, landmarks)
    P = belief.matrix[columns[:, :, None], columns[:, None, :]]
    seen = (shown.visible & sensor.calibration.inside(shown.pixels))[..., None]
    covariance = H @ P[:, None] @ H.swapaxes(-1, -2)
    return np.where(seen, shown.pixels, np.nan), np.where(seen[..., None], covariance, np.nan)
