"""Two rendered cameras as one stereo sensor: its rig, and its frames."""

from dataclasses import replace

import numpy as np

from slamlib.datasets.pictures import pair
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import relative
from slamlib.records.inputs import Frame, Scan
from slamlib.rigs.setup import Rig, SensorSetup


def stereo_rig(rig: Rig, std: tuple[float, ...] = (0.15, 0.15, 0.15)) -> Rig:
    """The same robot with one stereo sensor, in place of a left and a right camera of equal lenses without distortion.

    std: of u, v and the disparity [px]: a match in the rooms has errors of 0.05 px, but those of one landmark are
    correlated over frames, which the filter does not model. Raises SlamlibError for cameras that are no rectified pair.
    """
    if len(rig.robots) != 1 or len(rig.sensors) != 2:
        raise SlamlibError("stereo_rig: a rig of one robot with a left and a right camera is expected")
    left, right = rig.sensors
    baseline, *aside = relative(left.extrinsics, right.extrinsics)[:3].tolist()
    lens = dict(left.parameters)
    if lens != dict(right.parameters) or left.image != right.image or left.euler != right.euler:
        raise SlamlibError("stereo_rig: the two cameras differ in lens, image or direction: rectify them first")
    if any(lens.get("distortion", ())):
        raise SlamlibError(
            "stereo_rig: the lenses have distortion, so rows do not correspond: rectify the images first"
        )
    if not baseline > 0 or np.abs(aside).max() > 1e-9 * baseline:
        raise SlamlibError(
            f"stereo_rig: the right camera is {[baseline, *aside]} m (right, down, front) from the left one, and "
            "should be to the right alone: rectify them, or exchange them"
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
