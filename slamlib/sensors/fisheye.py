"""Fisheye camera: equidistant, with odd powers of the angle as distortion: a pixel; axes right, down, front."""

import numpy as np

from slamlib.errors import SingularPointError, SlamlibError
from slamlib.models import AtMost, model
from slamlib.models.implicit import Implicit
from slamlib.sensors import omni, pinhole
from slamlib.sensors.sensor import Sensor
from slamlib.sensors.stages import BackProjection


@model(point=4, intrinsics=4, distortion=AtMost(8))
def project(point, intrinsics, distortion):
    """Pixel of a homogeneous point; intrinsics (u0, v0, au, av) [px]. Chapter omnidirectional, eq. (om-fisheye)."""
    return pinhole.pixel(omni.angles(point), intrinsics, distortion)


def _first_guess(measurement, intrinsics, distortion):
    found = pinhole.ideal_point.start(measurement, intrinsics, distortion)
    lost = (found**2).sum(-1) > np.pi**2
    if lost.any():
        first = np.broadcast_to(measurement, found.shape)[lost][0]
        raise SingularPointError(f"no ray gives the pixel {first.tolist()}, more than 180 degrees off the axis")
    return found


back_project = BackProjection(
    Implicit("direction", pinhole.pixel, unknown="ideal", start=_first_guess), omni.ray, size=2
)


def check(calibration):
    """Raise SlamlibError for invalid parameters; the default field of view ends at the fold, at pi at the latest."""
    intrinsics = calibration.given["intrinsics"]
    if len(intrinsics) != 4 or not (intrinsics[2:] > 0).all():
        raise SlamlibError(f"fisheye: intrinsics are (u0, v0, au, av) with au, av > 0, got {intrinsics.tolist()}")
    fold = min(float(pinhole.fold_radius(calibration.given["distortion"])), np.pi)
    if not 0 < calibration.limits.setdefault("angle", fold) <= fold:
        raise SlamlibError(
            f"fisheye: the distortion folds back at {fold:.4f} rad from the axis, before the field of view ends, "
            f"{calibration.limits['angle']} rad: give a smaller limit 'angle', or calibrate with points out there"
        )


PARAMETERS = ("intrinsics", "distortion")
MODELS = project, back_project
FISHEYE = Sensor("fisheye", *MODELS, PARAMETERS, omni.visible, check, limits=("angle",), pixels=True)
