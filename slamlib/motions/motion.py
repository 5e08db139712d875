"""The interface of a motion model."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.manifolds import Array, Manifold, read_only
from slamlib.models import Model
from slamlib.registry import Moved, TypeDescription


@dataclass(frozen=True)
class Motion(TypeDescription):
    """A motion: name, manifold of the robot's state, size of the control, and the model step(state, control, dt).

    moved(motion, state): the state after a rigid motion (7,) of the world; the default is that of a pose.
    pose_of(state): the robot's pose (7,) in space, of a state that does not begin with one, as in the plane;
    from_pose(pose): the state of such a pose, at rest. Without them a state's first seven numbers are its pose.
    angles: which numbers of the control are angles; a setup gives those in degrees. Default: of six the last three.
    """

    name: str
    manifold: Manifold
    control: int
    step: Model
    moved: Moved | None = compose
    angles: tuple[int, ...] = (3, 4, 5)
    pose_of: Model | None = None
    from_pose: Model | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if (self.pose_of is None) != (self.from_pose is None) or (
            self.pose_of is None and self.manifold.size < Pose.size
        ):
            raise SlamlibError(
                f"Motion {self.name!r}: a state that does not begin with a pose in space has models of both, "
                "pose_of(state) and from_pose(pose)"
            )

    @property
    def pose_dof(self) -> int:
        """How many degrees of freedom of a state, the first ones, its pose depends on."""
        return Pose.dof if self.pose_of is None else self.manifold.dof

    @cached_property
    def free(self) -> Array:
        """Basis (6, f) of the directions in which a pose can be: all six, or three in the plane."""
        if self.pose_of is None or self.from_pose is None:
            return _IDENTITY
        U, s, _ = np.linalg.svd(self.pose_jacobian(self.from_pose(ORIGIN)))
        return U[:, : int((s > 1e-9).sum())]

    def pose(self, state: Array) -> Array:
        """The robot's pose (..., 7) in space, of states (..., size)."""
        return state[..., : Pose.size] if self.pose_of is None else _posed(self.pose_of, state)[0]

    def pose_jacobian(self, state: Array) -> Array:
        """Jacobian (..., 6, pose_dof) of the pose w.r.t. the first degrees of freedom of states (..., size)."""
        return _IDENTITY if self.pose_of is None else _posed(self.pose_of, state)[1]

    def by_state(self, by_pose: Array, state: Array) -> Array:
        """Jacobians (..., m, 6 + n) w.r.t. the robot's pose, and more, as those w.r.t. its state (..., size), and more.

        Of the state's degrees of freedom only the first pose_dof are there.
        """
        if self.pose_of is None:
            return by_pose  # the pose is the beginning of the state
        by_robot = by_pose[..., : Pose.dof] @ self.pose_jacobian(state)
        return np.concatenate([by_robot, by_pose[..., Pose.dof :]], axis=-1)

    def in_space(self, state: Array, covariance: Array) -> tuple[Array, Array]:
        """Poses (..., 7) of states (..., size), and their covariances (..., 6, 6) by the states' (..., dof, dof)."""
        k, J = self.pose_dof, self.pose_jacobian(state)
        P = covariance[..., :k, :k]
        return self.pose(state), P if self.pose_of is None else J @ P @ J.swapaxes(-1, -2)

    def at(self, pose: Array, velocity: Array) -> tuple[Array, Array]:
        """The state (size,) with a pose (7,) and velocities (6,), and its Jacobian (dof, 12) by both.

        Velocities that it lacks are left out. Raises SlamlibError for a pose that it cannot have.
        """
        if self.pose_of is None or self.from_pose is None:
            return np.concatenate([pose, velocity])[: self.manifold.size], np.eye(self.manifold.dof, 12)
        state, J = self.from_pose.jac(pose)
        nearest = self.pose_of(state)
        if np.abs(Pose.minus(nearest, pose)).max() > 1e-9:
            what = f"by {self.name} no robot can have the pose {pose.round(6).tolist()}"
            raise SlamlibError(f"{what}; the nearest is {nearest.round(6).tolist()}")
        return state, np.pad(J[0], ((0, 0), (0, 6)))


_IDENTITY = np.eye(Pose.dof)


def _posed(pose_of: Model, states: Array) -> tuple[Array, Array]:
    """Poses (..., 7) of states (..., size), and their Jacobians (..., 6, dof)."""
    if states.ndim == 1 and states.dtype == float:
        return _posed_one(pose_of, states.tobytes())
    poses, J = pose_of.jac(states)
    return poses, J[0]


@lru_cache(maxsize=32)  # by the numbers themselves: one frame asks several times between two measurement updates
def _posed_one(pose_of: Model, state: bytes) -> tuple[Array, Array]:
    pose, J = pose_of.jac(np.frombuffer(state))
    return read_only(pose), read_only(J[0])
