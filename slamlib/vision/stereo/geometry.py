"""Two cameras of a rig as one stereo sensor: its rig and frames, and points of its measurements with covariances."""

from dataclasses import replace

import numpy as np

from slamlib.data.records import Frame, Scan
from slamlib.data.setup import Rig, SensorSetup
from slamlib.datasets.pictures import pair
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import relative
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


def stereo_rig(rig: Rig, std: tuple[float, ...] = (0.15, 0.15, 0.15)) -> Rig:
    """The same robot with one stereo sensor, in place of a left and a right camera of equal lenses without distortion.

    std: of u, v and the disparity [px]: a match in the rooms has errors of 0.05 px, but those of one landmark are
    correlated over frames, which the filter does not model. Raises SlamlibError for cameras that are no rectified pair.
    """
    if len(rig.robots) != 1 or len(rig.sensors) != 2:
        raise SlamlibError("joined: a rig of one robot with a left and a right camera is expected")
    left, right = rig.sensors
    baseline, *aside = relative(left.extrinsics, right.extrinsics)[:3].tolist()
    lens = dict(left.parameters)
    if lens != dict(right.parameters) or left.image != right.image or left.euler != right.euler:
        raise SlamlibError("joined: the two cameras differ in lens, image or direction: rectify them first")
    if any(lens.get("distortion", ())):
        raise SlamlibError("joined: the lenses have distortion, so rows do not correspond: rectify the images first")
    if not baseline > 0 or np.abs(aside).max() > 1e-9 * baseline:
        raise SlamlibError(
            f"joined: the right camera is {[baseline, *aside]} m from the left one (right, down, front), and should be "
            "to the right alone: rectify them, or exchange them"
        )
    parameters = {"intrinsics": lens["intrinsics"], "baseline": (baseline,)}
    sensor = SensorSetup("stereo", type="stereo", image=left.image, parameters=parameters, std=std)
    return replace(rig, sensors=(replace(sensor, position=left.position, euler=left.euler),))


def stereo_frame(frame: Frame) -> Frame:
    """A frame with the scans of two cameras as one with a single scan, whose image is the pair."""
    left, right = (scan.image for scan in frame.scans)
    if left is None or right is None:
        raise SlamlibError(f"frame {frame.number}: one of the two images is missing")
    return replace(frame, scans=(Scan(image=pair(left, right)),))
