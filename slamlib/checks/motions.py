"""Properties that every motion must have."""

import numpy as np

from slamlib.checks.judge import Judge
from slamlib.checks.models import DEFINED, INTERFACE, interface, model_properties, moved_derivatives
from slamlib.geometry.pose import Pose, compose, exponential
from slamlib.manifolds import Array
from slamlib.motions.motion import Motion
from slamlib.registry import Moved

STILL = "no control and no time change nothing"
POSED = "from_pose, then pose_of gives the pose back"
CARRIED = "the robot's pose moves with the world"
UNNOTICED = "a motion of the world is not noticed by a step without a control"


def motion_properties(judge: Judge, motion: Motion) -> None:
    """Interface first; then the models one by one; then how they fit together."""
    size, rng, name = motion.manifold.size, judge.rng, motion.name
    if not interface(judge, motion, {"step": {"state": size, "control": motion.control, "dt": 1}}):
        return
    result = motion.step.result
    found = "no manifold" if result is None else result.manifold
    how = f"returns {found}; should return {motion.manifold}, the state's: declare it by @model(..., returns=...)"
    judge.at(f"{name}.step").require(INTERFACE, result is not None and result.manifold is motion.manifold, how)
    states = [_state(motion, rng) for _ in range(8)]
    controls, times = rng.normal(0, 0.3, (len(states), motion.control)), rng.uniform(0.1, 1.0, len(states))
    steps = [(x, u, np.array(dt)) for x, u, dt in zip(states, controls, times, strict=True)]
    still = [(x, np.zeros(motion.control), np.array(0.0)) for x in states]
    model_properties(judge, motion.step, f"{name}.step", steps, still)
    if motion.pose_of is not None and motion.from_pose is not None:
        model_properties(judge, motion.pose_of, f"{name}.pose_of", [(x,) for x in states])
        poses = [motion.pose(x) for x in states]
        model_properties(judge, motion.from_pose, f"{name}.from_pose", [(pose,) for pose in poses])
        for pose in [] if judge.lacks(DEFINED) else poses:
            again = motion.pose(motion.from_pose(pose))
            judge.at(f"{name}.from_pose", pose=pose).compare(POSED, Pose.minus(again, pose), np.zeros(Pose.dof))
    if judge.lacks(DEFINED):
        return
    for place in still:
        change = motion.manifold.minus(motion.step(*place), place[0])
        judge.at(f"{name}.step", state=place[0]).compare(STILL, change, np.zeros(motion.manifold.dof))
    if motion.moved is not None:
        _moved(judge, motion, motion.moved, states)


def _state(motion: Motion, rng: np.random.Generator) -> Array:
    """A random state (size,)."""
    pose, rest = Pose.random(rng), np.zeros(max(motion.manifold.size - Pose.size, 0))
    base = np.concatenate([pose, rest]) if motion.from_pose is None else motion.from_pose(pose)
    return motion.manifold.plus(base, rng.normal(0, 0.3, motion.manifold.dof))


def _moved(judge: Judge, motion: Motion, moved: Moved, states: list[Array]) -> None:
    """Check the motion of the world, in the directions that the robot can make with it."""
    manifold = motion.manifold
    for state in states:
        world = exponential(motion.free @ judge.rng.normal(0, 0.5, motion.free.shape[1]))
        case, rest = judge.at(f"{motion.name}.moved", state=state, motion=world), np.zeros(motion.control)
        there = moved(world, state)
        apart = Pose.minus(motion.pose(there), compose(world, motion.pose(state)))
        case.compare(CARRIED, apart, np.zeros(Pose.dof), "motion")
        later = [motion.step(x, rest, 0.5) for x in (there, state)]
        case.compare(UNNOTICED, manifold.minus(later[0], moved(world, later[1])), np.zeros(manifold.dof), "motion")
        moved_derivatives(case, moved, manifold, world, state)
