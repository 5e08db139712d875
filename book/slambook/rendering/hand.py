"""Rigs that start where a path begins: one camera or two in somebody's hand."""

from typing import Any

import numpy as np

from slambook.rendering.paths import CameraPath
from slamlib.data.setup import Numbers, Rig, RobotSetup, SensorSetup

IMAGE: Numbers = (320.0, 240.0)
LENS: dict[str, Numbers] = {"intrinsics": (159.5, 119.5, 260.0, 260.0), "distortion": (-0.1, 0.01)}
# In a step of 1/30 s: a hand's accelerations are some 0.5 m/s^2 and 0.3 rad/s^2.
IMPULSES: Numbers = (0.015, 0.015, 0.015, 0.6, 0.6, 0.6)


def rig_along_path(
    path: CameraPath,
    *,
    baseline: float | None = None,
    motion: str = "constVel",
    control_std: Numbers = IMPULSES,
    velocity_std: Numbers = (0.05, 0.05, 0.05, 2.0, 2.0, 2.0),
    image: Numbers = IMAGE,
    parameters: dict[str, Numbers] | None = None,
    std: Numbers = (0.15,),
) -> Rig:
    """A robot that starts as the path does, with a pin-hole camera at its origin, which looks along its x axis.

    baseline [m]: with a second camera, `right`, so far to the right of the first, `left`. control_std and velocity_std
    as in RobotSetup; std [px], image (width, height) and parameters as in SensorSetup. The default std is that of
    correlation with sub-pixel steps in the rooms' pictures.
    """
    state = path.state(0)
    robot = RobotSetup(
        name="hand",
        motion=motion,
        position=tuple(state[:3].tolist()),
        euler=tuple(np.degrees(path.knots[0, 3:]).tolist()),
        velocity=tuple(np.concatenate([state[7:10], np.degrees(state[10:])]).tolist()),
        velocity_std=velocity_std,
        control_std=control_std,
    )
    camera: dict[str, Any] = {"image": image, "parameters": dict(parameters or LENS), "std": std}
    if baseline is None:
        return Rig((robot,), (SensorSetup(**camera),))
    left = SensorSetup("left", **camera)
    return Rig((robot,), (left, SensorSetup("right", position=(0.0, -baseline, 0.0), **camera)))
