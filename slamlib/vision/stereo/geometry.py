"""Points of stereo measurements, and their covariances."""

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array
from slamlib.observation.points import initialize
from slamlib.sensors.sensor import Calibration

ORIGIN = np.array([0.0, 0, 0, 1, 0, 0, 0])


def triangulate(calibration: Calibration, values: Array, extrinsics: Array = ORIGIN) -> tuple[Array, Array]:
    """Points (n, 3) [m] of measurements (n, 3) [px], and covariances (n, 3, 3) = J R J', in the robot's frame.

    extrinsics (7,): the sensor's pose on the robot; the default gives points of the sensor's own frame. R, the noise of
    the calibration, is of (u, v, d); J is the model's own Jacobian. The result is nearly singular, and never diagonal:
    an error of the disparity moves the point along its ray. Raises SlamlibError for a disparity that is not above zero.
    """
    if not (values[:, 2] > 0).all():
        raise SlamlibError("triangulate: a disparity of zero or less belongs to no finite point; mask such features")
    points, J = initialize(EUC_POINT, calibration, ORIGIN, extrinsics, values)
    by = J.measurement
    return points, by @ calibration.noise @ by.swapaxes(-1, -2)


def pixel_noise(left: float, right: float) -> Array:
    """R (3, 3) of (u_l, v_l, u_l - u_r) [px^2], for independent u_l, v_l and u_r with these standard deviations [px].

    For both pixels detected independently: u and disparity are correlated then. For a disparity measured by aligning
    the left patch in the right image they are not, and R is diagonal.
    """
    J = np.array([[1.0, 0, 0], [0, 1, 0], [1, 0, -1]])
    return J @ np.diag([left**2, left**2, right**2]) @ J.T
