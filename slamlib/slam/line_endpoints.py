"""Where the ends of lines are in an image, and how well they are known there: for pictures, not for the filter."""

import numpy as np

from slamlib.belief import Belief
from slamlib.landmarks import hmg_point
from slamlib.manifolds import Array
from slamlib.observation.family import by_columns, columns_of, means_of, viewpoint
from slamlib.observation.points import AHEAD
from slamlib.slam.entities import Landmark, MountedSensor
from slamlib.slam.measurement_update import groups


def ends_in_image(belief: Belief, sensor: MountedSensor, landmarks: list[Landmark]) -> tuple[Array, Array]:
    """The two ends of lines in the image (n, 2, 2) [px] and their covariances (n, 2, 2, 2), as the filter has them now.

    The covariance is H P H' of robot, mount and line together, at ends that stay where they are on the line (in the
    manual Obs.par.endp, fig. 9). The noise of a pixel is left out: a segment that is detected ends somewhere else on
    the line, so this is no region in which its end should be found. nan: points, lines that were forgotten, ends that
    lie out of view.
    """
    ends, spreads = np.full((len(landmarks), 2, 2), np.nan), np.full((len(landmarks), 2, 2, 2), np.nan)
    alive, row = set(belief.blocks), {landmark: i for i, landmark in enumerate(landmarks)}
    for group in groups(lm for lm in landmarks if lm.abscissas is not None and lm.block in alive):
        rows = [row[landmark] for landmark in group]
        ends[rows], spreads[rows] = _of_one_kind(belief, sensor, group)
    return ends, spreads


def _of_one_kind(belief: Belief, sensor: MountedSensor, landmarks: list[Landmark]) -> tuple[Array, Array]:
    kind, abscissas = landmarks[0].kind, np.array([landmark.abscissas for landmark in landmarks])
    view = viewpoint(sensor)
    h, by_line = kind.point_at.jac(means_of(landmarks)[:, None, :], abscissas)
    point, F = hmg_point.to_frame.jac(view.pose, h)
    ahead = sensor.calibration.visible(point)
    pixel, by_sensor = sensor.calibration.project_jac(np.where(ahead[..., None], point, AHEAD))
    by = by_columns(view, F.pose, F.landmark @ by_line.landmark)
    H, columns = by_sensor.point @ by, columns_of(sensor, landmarks)
    P = belief.matrix[columns[:, :, None], columns[:, None, :]]
    seen = (ahead & sensor.calibration.inside(pixel))[..., None]
    covariance = H @ P[:, None] @ H.swapaxes(-1, -2)
    return np.where(seen, pixel, np.nan), np.where(seen[..., None], covariance, np.nan)
