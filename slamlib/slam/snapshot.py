"""A snapshot of the filter: copies of its estimates, and of its sensors' predictions and measurements."""

from typing import Any

import numpy as np

from slamlib.belief import Belief
from slamlib.data.snapshots import MapView, MeasurementView, RobotView, SensorView, Snapshot
from slamlib.manifolds import Array
from slamlib.observation.family import columns_jacobian, state_columns, viewpoint
from slamlib.observation.segments import project_endpoints
from slamlib.slam.entities import POSE, Landmark, RigSensor
from slamlib.slam.measurement_update import KIND, group_by_kind

COLUMNS = {"chosen": bool, "matched": bool, "inlier": bool, "nis": float}


def snapshot_of(slam: Any) -> Snapshot:
    """A copy of everything that may be shown of a filter, after its last frame."""
    robots = tuple(RobotView(r.name, r.block.mean.copy(), slam.belief.covariance(r.block)) for r in slam.robots)
    sensors = tuple(_sensor_view(slam, i, sensor) for i, sensor in enumerate(slam.sensors))
    landmarks = {}
    for family in slam.families.values():
        own = [lm for lm in slam.landmarks if isinstance(lm.kind, family.kinds)]
        ids, kinds = np.array([lm.id for lm in own], dtype=int), tuple(lm.kind.name for lm in own)
        landmarks[family.name] = MapView(ids, kinds, *family.geometry(slam.belief, own))
    return Snapshot(slam.number, slam.time, robots, sensors, landmarks, slam.belief.size)


def _sensor_view(slam: Any, i: int, sensor: RigSensor) -> SensorView:
    covariance = np.zeros((POSE, POSE)) if sensor.block is None else slam.belief.covariance(sensor.block)
    predictions = {
        f.name: _measurement_view(slam, i, f.name, f.size(sensor.calibration)) for f in slam.families.values()
    }
    robot = slam.robots.index(sensor.robot)
    image = sensor.calibration.image
    return SensorView(sensor.name, robot, sensor.extrinsics.copy(), covariance, image, slam.scans[i], predictions)


def _measurement_view(slam: Any, i: int, family: str, size: int) -> MeasurementView:
    own = [prediction for prediction in slam.predictions[i] if prediction.family.name == family]
    landmarks, d = [prediction.landmark for prediction in own], len(own[0].S) if own else 2
    endpoints, endpoint_covariances = endpoints_in_image(slam.belief, slam.sensors[i], landmarks)
    columns: dict[str, Any] = {
        name: np.array([getattr(p, name) for p in own], dtype) for name, dtype in COLUMNS.items()
    }
    return MeasurementView(
        ids=np.array([landmark.id for landmark in landmarks], dtype=int),
        kinds=tuple(landmark.kind.name for landmark in landmarks),
        expected=np.array([prediction.value for prediction in own]).reshape(len(own), size),
        covariance=np.array([prediction.S for prediction in own]).reshape(len(own), d, d),
        measured=np.array([prediction.measured for prediction in own]).reshape(len(own), size),
        **columns,
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
    for group in group_by_kind([lm for lm in landmarks if lm.abscissas is not None and lm.block in alive], KIND):
        rows = [row[landmark] for landmark in group]
        endpoints[rows], endpoint_covariances[rows] = _of_one_kind(belief, sensor, group)
    return endpoints, endpoint_covariances


def _of_one_kind(belief: Belief, sensor: RigSensor, landmarks: list[Landmark]) -> tuple[Array, Array]:
    view, abscissas = viewpoint(sensor), np.array([landmark.abscissas for landmark in landmarks])
    ahead, pixel, parts = project_endpoints(sensor.calibration, view.pose, landmarks, abscissas)
    by_point, by_pose, by_place, by_line = parts
    by = columns_jacobian(view, by_pose, by_place @ by_line)
    H, columns = by_point @ by, state_columns(sensor, landmarks)
    P = belief.matrix[columns[:, :, None], columns[:, None, :]]
    seen = (ahead & sensor.calibration.inside(pixel))[..., None]
    covariance = H @ P[:, None] @ H.swapaxes(-1, -2)
    return np.where(seen, pixel, np.nan), np.where(seen[..., None], covariance, np.nan)
