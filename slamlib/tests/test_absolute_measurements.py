"""What tells where the world lies (GPS, a compass, meetings), in a filter that keeps the right-invariant error.

Chapter observability, eqs. (ob-told), (ob-screw) and (ob-rest).
"""

from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest

from slamlib.checks.jacobian import check_jacobian
from slamlib.entities.generator import generator
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band, share_inside
from slamlib.evaluation.pose_errors import invariant_error, pose_nees
from slamlib.geometry.pose import Pose, exponential, from_frame, to_frame
from slamlib.kalman.linalg import Carry, left_inverse
from slamlib.landmarks import LINES, POINTS
from slamlib.models import model
from slamlib.motions import MOTIONS
from slamlib.records.inputs import RobotMeasurement
from slamlib.rigs.setup import Rig
from slamlib.slam import transport
from slamlib.slam.snapshot import robot_view
from slamlib.slam.transport import told
from slamlib.slam.unobservable import generators
from slamlib.tests import test_plane_maps
from slamlib.tests.test_transport import run, with_landmark, with_options

TYPES = [*POINTS, *LINES]


@model(pose=Pose)
def position(pose):
    """Position [m], as GPS has it."""
    return pose[:3]


@model(pose=Pose)
def floor_position(pose):
    """Position on the floor [m]."""
    return pose[:2]


@model(pose=Pose)
def front(pose):
    """Direction of the robot's front, as a compass with an inclinometer has it."""
    return from_frame(pose, np.array([1, 0, 0])) - pose[:3]


def shown(slam):
    """What all sensors are predicted to measure; of a segment its line, as its endpoints are not in the state."""
    rows = []
    for predicted in (p for i in range(len(slam.sensors)) for p in slam.project(i)):
        line = (
            np.cross(np.append(predicted.value[:2], 1), np.append(predicted.value[2:], 1))
            if len(predicted.value) == 4
            else None
        )
        rows.append(predicted.value if line is None else line / np.linalg.norm(line[:2]))
    return np.concatenate(rows)


def told_its_pose(slam, robot, step, sigma):
    """An update by a prior on a robot's pose, which differs from the estimate by this step."""
    own = slam.robots[robot]
    H = np.eye(len(own.columns), own.block.dof)
    return slam.update([own.block], [H], np.array(step)[: len(own.columns)], sigma**2 * np.eye(len(H)), robot=robot)


@pytest.mark.parametrize("name", [*TYPES, "two_robots", "self_calibration"])
def test_a_map_that_is_known_in_itself_moves_as_one_rigid_body(name):
    """All that is unknown is where the world lies: an update by any amount leaves what the sensors see as it was."""
    slam = run((with_landmark if name in TYPES else with_options)(name, error="world", convert=False), 5)
    before, N, blocks = shown(slam), generators(slam.state), dict(enumerate(slam.belief.blocks))
    Q = np.diag(np.linspace(0.5, 1, N.shape[1]) ** 2)
    slam.belief.overwrite(blocks, {i: block.mean for i, block in blocks.items()}, N @ Q @ N.T)
    was, plane = slam.robots[0].pose, N.shape[1] == 3
    told_its_pose(slam, 0, [0.3, -0.2, 0.4] if plane else [0.3, -0.2, 0.1, 0.2, -0.1, 0.4], 0.1)
    assert np.linalg.norm(Pose.minus(slam.robots[0].pose, was)[3:]) > 0.2  # [rad]
    np.testing.assert_allclose(shown(slam), before, rtol=1e-8, atol=1e-9)
    N = generators(slam.state)
    P = slam.belief.matrix
    np.testing.assert_allclose(N @ np.linalg.pinv(N) @ P, P, atol=1e-9 * np.abs(P).max())


def test_what_one_robot_alone_is_unsure_of_is_told_by_its_own_errors():
    """The other robot is known exactly: the motion of the world that an update holds is read from the one it is of."""
    slam = run(with_options("two_robots", error="world", convert=False), 5)
    before, N, blocks = slam.project(1), generators(slam.state), dict(enumerate(slam.belief.blocks))
    N[slam.robots[0].block.slice] = 0
    slam.belief.overwrite(blocks, {i: block.mean for i, block in blocks.items()}, N @ N.T)
    told_its_pose(slam, 1, [0.3, -0.2, 0.1, 0.2, -0.1, 0.4], 0.1)
    after = slam.project(1)
    assert len(after) == len(before) > 3
    for old, new in zip(before, after, strict=True):
        np.testing.assert_allclose(new.value, old.value, rtol=1e-8)


@pytest.mark.parametrize("name", [*TYPES, *MOTIONS])
def test_a_moved_state_changes_by_the_state_as_differences_say(name):
    kind = MOTIONS[name] if name in MOTIONS else run(with_landmark(name, convert=False), 3).landmarks[0].kind
    manifold, free = kind.manifold, getattr(kind, "free", np.eye(6)[:, [0, 1, 5]] if "plane" in name else np.eye(6))
    g = exponential(free @ free.T @ np.array([0.3, -0.2, 0.1, 0.2, -0.1, 0.5]))
    rng = np.random.default_rng(3)
    x = np.array([manifold.random(rng) for _ in range(2)])
    there, (by_motion, by_state) = kind.moved.jac(g, x)
    np.testing.assert_allclose(there, kind.moved(g, x), rtol=1e-12)
    for i in range(2):
        check_jacobian(
            lambda d, i=i: manifold.minus(kind.moved(g, manifold.plus(x[i], d)), there[i]),
            by_state[i],
            np.zeros(manifold.dof),
        )
        _, alone = kind.moved.jac(g, x[i])
        np.testing.assert_allclose(by_motion[i], alone[0], atol=1e-12)
        np.testing.assert_allclose(by_state[i], alone[1], atol=1e-12)


@contextmanager
def rest_as_it_was(state, robot):
    """As slamlib's `told`, but what is no motion of the world in the errors stays in the axes of the old one."""
    before, rows = generators(state), robot.columns
    with told(state, robot):
        state.belief.transport = lambda: Carry(rows, generators(state) - before, left_inverse(before[rows]))
        yield


def uncertainty_of_what_is_seen(name, error):
    """Covariances of all predicted measurements before and after the world is turned by 0.46 rad."""
    slam = run(with_landmark(name, error=error, convert=False), 6)
    N, blocks, rows = generators(slam.state), dict(enumerate(slam.belief.blocks)), slam.robots[0].columns
    beside = np.eye(len(N))
    beside[:, rows] -= N @ left_inverse(N[rows])
    rest = beside @ slam.belief.matrix @ beside.T
    slam.belief.overwrite(blocks, {i: b.mean for i, b in blocks.items()}, rest + 0.3 * N @ N.T)
    before, was = [p.S for p in slam.project(0)], shown(slam)
    told_its_pose(slam, 0, [0.3, -0.2, 0.1, 0.2, -0.1, 0.4], 1e-3)
    np.testing.assert_allclose(shown(slam), was, rtol=1e-7, atol=1e-8)
    after = [p.S for p in slam.project(0)]
    assert len(after) == len(before) >= 2
    return before, after


# Ends of these are counted from a place by the origin, and so are others of the same line once the world has moved.
OTHER_ENDS = {"plkLin", "aplLin"}
SEEN_ALIKE = [name for name in TYPES if name not in OTHER_ENDS and not name.startswith("plane")]


@pytest.mark.parametrize(
    ("name", "error"), [*((name, "world") for name in SEEN_ALIKE), ("idpPnt", "anchors"), ("fhmPnt", "anchors")]
)
def test_a_turn_of_the_world_leaves_how_sure_the_filter_is_of_what_is_seen(name, error):
    """The map as the robot sees it has not changed, and neither has its covariance: exactly, whatever the turn."""
    for old, new in zip(*uncertainty_of_what_is_seen(name, error), strict=True):
        np.testing.assert_allclose(new, old, rtol=1e-6, atol=1e-9 * np.abs(old).max())


@pytest.mark.parametrize("name", ["hmgPnt", "eucPnt"])
def test_control_with_the_rest_as_it_was_depths_point_where_they_did(name, monkeypatch):
    usual = transport.TRANSPORTS["world"]
    monkeypatch.setitem(transport.TRANSPORTS, "world", replace(usual, by_robot=rest_as_it_was))
    before, after = uncertainty_of_what_is_seen(name, "world")
    assert max(np.abs(new - old).max() / np.abs(old).max() for old, new in zip(before, after, strict=True)) > 0.1


@pytest.mark.parametrize("name", TYPES)
def test_a_small_step_moves_every_block_as_its_own_plus_does(name):
    """Of a step that is a tenth, the difference is a hundredth: both are the same update to first order."""
    off = []
    for size in (1e-2, 1e-3):
        kept, own = (run(with_landmark(name, error="world", convert=False), 5) for _ in range(2))
        own.options = replace(own.options, error="local")
        step = size * np.ones(6)
        for slam in (kept, own):
            blocks, means = dict(enumerate(slam.belief.blocks)), {}
            means = {i: block.mean for i, block in blocks.items()}
            slam.belief.overwrite(
                blocks, means, slam.belief.matrix + 0.01 * generators(slam.state) @ generators(slam.state).T
            )
            told_its_pose(slam, 0, step, 0.1)
        pairs = zip(kept.belief.blocks, own.belief.blocks, strict=True)
        off.append(np.concatenate([a.manifold.minus(a.mean, b.mean) for a, b in pairs]))
        moved = own.robots[0].block.manifold.minus(own.robots[0].block.mean, means[0])
        assert np.abs(moved).max() > 0.1 * size
    assert np.abs(off[0]).max() > 0
    assert np.abs(off[1]).max() < 0.015 * np.abs(off[0]).max()


@pytest.mark.parametrize("name", [*TYPES, "two_robots"])
def test_an_absolute_update_gains_nothing_where_it_tells_nothing(name):
    """GPS tells no turn of the world about the robot: of two filters one is unsure of it, and stays so, exactly."""
    far = {}
    for error in ("local", "world"):
        p = (with_landmark if name in TYPES else with_options)(name, error=error, convert=False)
        sure, unsure = run(p, 5), run(p, 5)
        robot = unsure.robots[0]
        gps = floor_position if generators(sure.state).shape[1] == 3 else position
        H = robot.motion.by_state(gps.jac(robot.pose)[1][0], robot.block.mean)
        N = generators(sure.state)
        blind = np.linalg.svd(H @ N[robot.columns])[2][len(H) :].T  # (f, 3), or (3, 1) on the floor
        assert blind.shape[1] == N.shape[1] - len(H)
        blocks = dict(enumerate(unsure.belief.blocks))
        means = {i: block.mean for i, block in blocks.items()}
        unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ blind @ blind.T @ N.T)
        for slam in (sure, unsure):
            own = slam.robots[0]
            jacobian = np.pad(H, ((0, 0), (0, own.block.dof - H.shape[1])))
            slam.update([own.block], [jacobian], np.full(len(H), 0.2), 1e-4 * np.eye(len(H)))
        added = generators(sure.state) @ blind
        difference = unsure.belief.matrix - sure.belief.matrix
        far[error] = np.linalg.norm(difference - added @ added.T) / np.linalg.norm(added @ added.T)
    assert far["world"] < 1e-8, far
    assert far["local"] > 1e-4, far


def test_which_motions_of_the_world_are_left_unknown():
    """H N is not zero: one place leaves every turn about it, two places those about their line, three none."""
    motion, rng = MOTIONS["odometry"], np.random.default_rng(2)
    states = [Pose.random(rng) for _ in range(3)]
    by_gps = [position.jac(x)[1][0] @ generator(motion, x) for x in states]
    ranks = [np.linalg.matrix_rank(np.concatenate(by_gps[: k + 1])) for k in range(3)]
    assert ranks == [3, 5, 6]
    between = np.diff([x[:3] for x in states[:2]], axis=0)[0]
    turn = np.concatenate([-np.cross(between, states[0][:3]), between])  # of the world, about the line of both
    assert np.abs(np.concatenate(by_gps[:2]) @ turn).max() < 1e-12
    by_compass = front.jac(states[0])[1][0] @ generator(motion, states[0])
    assert np.linalg.matrix_rank(by_compass) == 2
    assert np.abs(by_compass @ np.eye(6)[:, :3]).max() == 0  # no displacement
    ahead = front(states[0])
    assert np.abs(by_compass @ np.concatenate([np.zeros(3), ahead])).max() < 1e-12  # nor a roll about the front


def test_robots_that_meet_learn_nothing_of_where_the_world_lies():
    """A relative measurement by the same door: H N = 0, and the motion of the world stays exactly as unknown."""
    p = with_options("two_robots", error="world", convert=False)
    sure, unsure = run(p, 6), run(p, 6)
    N, blocks = generators(sure.state), dict(enumerate(unsure.belief.blocks))
    means = {i: block.mean for i, block in blocks.items()}
    unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ N.T)
    for slam in (sure, unsure):
        first, second = slam.robots
        there, (J, by_point) = to_frame.jac(first.pose, second.pose[:3])
        slam.update([first.block, second.block], [J, np.pad(by_point, ((0, 0), (0, 3)))], [0.2, 0.1, -0.1],
                    1e-4 * np.eye(3), robot=1)  # fmt: skip
        assert np.linalg.norm(to_frame(first.pose, second.pose[:3]) - there) > 0.1
    N = generators(sure.state)
    difference = unsure.belief.matrix - sure.belief.matrix
    np.testing.assert_allclose(difference, N @ N.T, atol=1e-9 * np.abs(N @ N.T).max())


def test_the_retraction_of_a_belief_is_back_after_an_update():
    slam = run(with_options("points", error="world"), 3)
    slam.belief.retraction = own = lambda blocks, step: [b.manifold.plus(b.mean, step[b.slice]) for b in blocks]
    told_its_pose(slam, 0, [0.1] * 6, 0.1)
    assert slam.belief.retraction is own
    assert slam.belief.transport is None


def nees(slam, pose, robot=0):
    """NEES of a robot's pose in the invariant error, which is the one that is kept."""
    own = slam.robots[robot]
    P = robot_view(slam.belief, own).pose_covariance
    return pose_nees(invariant_error(pose, own.pose), P, own.motion.free)[0]


def by_gps(name, error, seeds, frames=60):
    """Invariant NEES (runs, frames) of a robot whose heading is known to 20 degrees, with GPS in every fifth frame."""
    p = replace(with_landmark(name, error=error, reproject=False), noise_in="truth", frames=frames)
    robot = p.rig.robots[0]
    p = replace(p, rig=Rig((replace(robot, orientation_std=(0.0, 0.0, 20.0)),), p.rig.sensors))
    fix = floor_position if MOTIONS[robot.motion].pose_of else position
    found = []
    for seed in seeds:
        slam, rng, row = (q := replace(p, seed=seed)).slam(), np.random.default_rng([1, seed]), []
        for frame, truth in q.simulate():
            if not frame.number % 5:
                z = fix(truth.poses[0])
                noisy = RobotMeasurement("gps", fix, z + 0.1 * rng.standard_normal(len(z)), 0.01 * np.eye(len(z)))
                frame = replace(frame, absolute=(noisy,))
            slam.step(frame)
            if frame.number > 5:
                row.append(nees(slam, truth.poses[0]))
        found.append(row)
    return np.array(found)


@pytest.mark.parametrize("name", TYPES)
def test_every_parametrization_is_consistent_with_gps(name):
    """Invariant NEES averaged over 12 runs, and its control: a filter that keeps each block's own error."""
    found, dof = by_gps(name, "world", range(12)), 3 if name.startswith("plane") else 6
    average, (low, high) = found.mean(0), band(dof, 12)
    assert np.mean((low < average) & (average < high)) > 0.7
    assert found.mean() < 1.3 * dof
    assert by_gps(name, "local", range(3)).mean() > 3 * dof


def of_two_robots(error, seeds, frames=40):
    """Invariant NEES (runs, frames, 2) of two robots in the plane: they know each other, and the world's heading to 20
    degrees. The second one has GPS in every fifth frame."""
    other = replace(test_plane_maps.ROBOT, name="other", position=(0, 5, 0), euler=(0, 0, 180))
    rig = Rig(
        (test_plane_maps.ROBOT, other), (test_plane_maps.LASER, replace(test_plane_maps.LASER, name="second", robot=1))
    )
    p = replace(test_plane_maps.PRESET, rig=rig, frames=frames)
    p, Q, found = replace(p, options=replace(p.options, error=error)), np.diag([0.01, 0.01, np.radians(20)]) ** 2, []
    for seed in seeds:
        slam, rng, rows = (q := replace(p, seed=seed)).slam(), np.random.default_rng([1, seed]), []
        motion, blocks = slam.robots[0].motion, dict(enumerate(slam.belief.blocks))
        by = exponential(motion.free @ (np.sqrt(Q.diagonal()) * rng.standard_normal(3)))
        P, means = slam.belief.matrix.copy(), {i: motion.moved(by, block.mean) for i, block in blocks.items()}
        slam.belief.overwrite(blocks, means, P)
        N = generators(slam.state)
        slam.belief.overwrite(blocks, means, P + N @ Q @ N.T)
        for frame, truth in q.simulate():
            if not frame.number % 5:
                z = floor_position(truth.poses[1]) + 0.1 * rng.standard_normal(2)
                frame = replace(frame, absolute=(RobotMeasurement("gps", floor_position, z, 0.01 * np.eye(2), 1),))
            slam.step(frame)
            if frame.number > 5:
                rows.append([nees(slam, pose, r) for r, pose in enumerate(truth.poses)])
        found.append(rows)
    return np.array(found)


@pytest.mark.parametrize("first", [0, 100], ids=["seeds 0-9", "seeds 100-109"])
def test_two_robots_of_the_plane_are_consistent_wherever_their_world_lies(first):
    average = of_two_robots("world", range(first, first + 10)).mean(0)
    for of_one in average.T:
        assert share_inside(of_one, band(3, runs=10)) > 0.85
    assert of_two_robots("local", range(first, first + 3)).mean() > 20


@pytest.mark.parametrize("robot", [-1, 2])
def test_an_update_by_a_robot_that_is_none_is_refused_before_anything_is_changed(robot):
    slam = run(with_options("two_robots", error="world"), 2)
    own, before = slam.robots[0], slam.belief.matrix.copy()
    with pytest.raises(SlamlibError, match=f"one of 2, from 0 on, got {robot}"):
        slam.update([own.block], [np.eye(6)], np.full(6, 0.1), np.eye(6), robot=robot)
    assert np.array_equal(slam.belief.matrix, before)
