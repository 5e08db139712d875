"""Rigs and comparisons for the tests of the simulator."""

import numpy as np

from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import world

CLOISTER = world("thickCloister", n=7)
WALKER = RobotSetup(
    position=(0.0, -5.0, 0.0),
    control=(0.08, 0.0, 0.0, 0.0, 0.0, 0.9),
    control_std=(0.005, 0.005, 0.005, 0.05, 0.05, 0.05),
)
CAMERA = SensorSetup(position=(0.0, 0.0, 0.6))
LENS = SensorSetup(
    position=(0.0, 0.0, 0.6),
    parameters={"intrinsics": (320.0, 240.0, 320.0, 320.0), "distortion": (-0.3, 0.1)},
    noise=((1.0, 0.6), (0.6, 2.0)),
)
OMNI = SensorSetup(
    type="omniCam", parameters={"intrinsics": (320.0, 240.0, 1.01, 0.003, -0.002), "lens": (170.0, -3.0, 0.5)}
)
DEPTH = SensorSetup(type="pinHoleDepth", std=(1.0, 1.0, 0.05))
STEREO = SensorSetup(
    type="stereo", parameters={"intrinsics": (320.0, 240.0, 320.0, 320.0), "baseline": (0.3,)}, std=(0.5, 0.5, 0.4)
)
RANGE = SensorSetup(type="rangeBearing", euler=(0.0, 0.0, 180.0), std=(0.05, 0.01, 0.01), limits={"far": 9.0})
RELATIVE = SensorSetup(type="relativePosition", std=(0.1,), limits={"far": 6.0})
ALL_SENSORS = (CAMERA, LENS, OMNI, DEPTH, STEREO, RANGE, RELATIVE)


def rig_of(robot, *sensors):
    """One robot with these sensors, or with a camera."""
    return Rig((robot,), sensors or (CAMERA,))


def same_runs(one, other):
    """Assert that two runs are the same, bit for bit."""
    one, other = list(one), list(other)
    assert len(one) == len(other)
    for (a, real), (b, again) in zip(one, other, strict=True):
        assert (a.number, a.dt) == (b.number, b.dt)
        for here, there in zip(_arrays(a, real), _arrays(b, again), strict=True):
            assert here.dtype == there.dtype
            assert here.shape == there.shape
            assert here.tobytes() == there.tobytes()


def _arrays(frame, truth):
    for control in frame.controls:
        yield from (np.zeros(0),) if control is None else (control.value, control.covariance)
    for scan in frame.scans:
        for features in (scan.points, scan.segments):
            yield from (features.ids, features.values)
    if truth is not None:
        yield from (*truth.robots, *truth.extrinsics)
