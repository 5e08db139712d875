"""A pose (x, y, z, yaw, pitch, roll) composed with an increment of the same form."""

import numpy as np

from slamlib.analytic import arctan2, sqrt
from slamlib.geometry.euler import to_rotation
from slamlib.models import model


@model(pose=6, control=6)
def compose(pose, control):
    """Composition through rotation matrices, not by adding angles [m, rad]. Chapter motion_models, eq. (mo-euler)."""
    before = to_rotation(pose[5:2:-1])
    after = before @ to_rotation(control[5:2:-1])
    yaw = arctan2(after[1, 0], after[0, 0])
    pitch = arctan2(-after[2, 0], sqrt(after[0, 0] * after[0, 0] + after[1, 0] * after[1, 0]))
    roll = arctan2(after[2, 1], after[2, 2])
    return np.concatenate([pose[:3] + before @ control[:3], np.array([yaw, pitch, roll])])
