"""What a rigid motion of the world does to the parts of a state: points, vectors, numbers, poses.

Taking a part from a frame into the world and moving the world are one thing: the pose is the motion.
"""

import numpy as np

from slamlib.geometry.pose import Pose
from slamlib.geometry.pose import from_frame as into_world
from slamlib.geometry.pose2 import Pose2, from_space
from slamlib.geometry.pose2 import compose as compose2
from slamlib.geometry.quaternion import rotation
from slamlib.manifolds import ranges
from slamlib.models import model


@model(motion=Pose, vector=3)
def vector(motion, vector):
    """A direction or a velocity turns with the world. Chapter frames_and_quaternions, eq. (fq-moved)."""
    return rotation(motion[3:]) @ vector


@model(motion=Pose, number=1)
def number(motion, number):
    """A distance, or a pixel, stays. Chapter frames_and_quaternions, eq. (fq-moved)."""
    return number


@model(motion=Pose, point=2)
def plane_point(motion, point):
    """A point of the floor, by a motion along the floor. Chapter frames_and_quaternions, eq. (fq-moved)."""
    return into_world(motion, np.array([*point, 0]))[:2]


@model(motion=Pose, pose=Pose2, returns=Pose2)
def plane_pose(motion, pose):
    """A pose in the plane, by a motion along the floor. Chapter frames_and_quaternions, eq. (fq-moved)."""
    return compose2(from_space(motion), pose)


class Parts:
    """moved(motion, state) of a state made of parts, each with its own model of a motion (7,) and the part."""

    def __init__(self, *parts):
        self.parts = parts
        self.stops = np.cumsum([part.arguments[1].size for part in parts])[:-1]

    def __call__(self, motion, state):
        """The state (..., size) after the motion."""
        return np.concatenate([part(motion, own) for part, own in self._split(state)], axis=-1)

    def jac_where(self, motion, state):
        """(..., dof, 6): its Jacobian with respect to the motion, where that is `motion` (7,)."""
        return np.concatenate([part.jac_where(motion, own) for part, own in self._split(state)], axis=-2)

    def entries_where(self, motion):
        """The function of the state's numbers, a list, that gives the entries of that Jacobian, row by row."""
        functions = [part.entries_where(motion) for part in self.parts]
        pieces = ranges(part.arguments[1].size for part in self.parts)
        return lambda state: sum((f(state[at]) for f, at in zip(functions, pieces, strict=True)), ())

    def jac(self, motion, state):
        """The state after a motion, and its Jacobians: (..., dof, 6) by the motion, (..., dof, dof) by the state."""
        values, jacobians = zip(*(part.jac(motion, own) for part, own in self._split(state)), strict=True)
        by_motion, by_part = zip(*jacobians, strict=True)
        ends = np.cumsum([own.shape[-1] for own in by_part])
        by_state = np.zeros((*by_part[0].shape[:-2], ends[-1], ends[-1]))
        for end, own in zip(ends, by_part, strict=True):
            by_state[..., end - own.shape[-1] : end, end - own.shape[-1] : end] = own
        return np.concatenate(values, axis=-1), (np.concatenate(by_motion, axis=-2), by_state)

    def _split(self, state):
        return zip(self.parts, np.split(np.asarray(state), self.stops, axis=-1), strict=True)
