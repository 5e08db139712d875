"""What no measurement can tell stays unknown: the null space of every model, and the covariance carried along it."""

import gc
import weakref
from dataclasses import replace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.entities.generator import change_of_generator, changing_columns, generator
from slamlib.entities.linearization import FirstEstimates, Linearization
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import preset
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.kalman.linalg import Carry
from slamlib.landmarks import LINES, POINTS
from slamlib.models.in_memory import is_affine
from slamlib.motions import MOTIONS
from slamlib.records.inputs import Control
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Slam
from slamlib.slam.prediction import predict_measurements
from slamlib.slam.snapshot import robot_view
from slamlib.slam.transport import TRANSPORTS, carried
from slamlib.slam.unobservable import Unobservable, generators, trade
from slamlib.tests import test_plane_maps, test_plane_motions


def with_options(name, **options):
    """A preset, or one in the plane, of this name with these options."""
    p = test_plane_maps.PRESET if name == "plane" else preset(name)
    return replace(p, options=replace(p.options, **options))


def with_landmark(name, **options):
    """The preset of a parametrization; Euclidean points are seen by a sensor of range and bearing."""
    if name in POINTS and POINTS[name].plane:
        return with_options("plane", points=name, **options)
    family = "points" if name in POINTS else "lines"
    p = with_options(family, **{family: name}, **options)
    if name == "eucPnt":
        laser = SensorSetup(type="rangeBearing", euler=(0.0, 0.0, 0.0), std=(0.05, 0.02, 0.02), image=None)
        p = replace(p, rig=Rig(p.rig.robots, (laser,)))
    return p


def run(p, frames):
    slam = p.slam()
    for frame, _ in replace(p, frames=frames).simulate():
        slam.step(frame)
    return slam


def test_a_filter_that_is_no_longer_used_is_freed():
    slam = run(with_options("points", error="world"), 8)
    generators(slam.state)
    landmark = weakref.ref(slam.landmarks[0])
    del slam
    gc.collect()
    assert landmark() is None


@pytest.mark.parametrize("name", [name for name, motion in MOTIONS.items() if motion.moved])
def test_the_motion_takes_what_cannot_be_known_along(name):
    """F N(x) = N(x'): a robot in a moved world moves as before."""
    motion, rng = MOTIONS[name], np.random.default_rng(1)
    for _ in range(20):
        x, u = motion.manifold.random(rng), 0.3 * rng.standard_normal(motion.control)
        if name == "constVel":
            u[:3] = 0  # a known impulse in the world's axes would tell how the world is turned
        g = possible(motion, Pose.random(rng))
        there, J = motion.step.jac(x, u, 0.1)
        np.testing.assert_allclose(motion.step(motion.moved(g, x), u, 0.1), motion.moved(g, there), atol=1e-9)
        before, after = (generator(motion, at) for at in (x, there))
        np.testing.assert_allclose(J.state @ before, after, atol=1e-9)


def possible(motion, pose):
    """The pose nearest to this one that the robot can have."""
    return pose if motion.from_pose is None else motion.pose(motion.from_pose(pose))


MOVED = {**POINTS, **LINES, **MOTIONS}
NOT_AFFINE = {"fhmPnt", "idpPnt", "idpLin", "constVel", "odometry"}  # those with angles, or a frame's quaternion


@pytest.mark.parametrize("name", MOVED)
def test_the_motion_of_the_world_is_the_derivative_of_the_model_of_one_state_and_of_many(name):
    kind, rng = MOVED[name], np.random.default_rng(1)
    before, after = (np.array([kind.manifold.random(rng) for _ in range(50)]) for _ in range(2))
    expected = [kind.moved.jac_where(ORIGIN, states) for states in (before, after)]
    np.testing.assert_allclose(generator(kind, before), expected[0], rtol=1e-15, atol=1e-15)
    assert np.array_equal(generator(kind, before[0]), expected[0][0])
    change = expected[1] - expected[0]
    np.testing.assert_allclose(change_of_generator(kind, before, after), change, rtol=1e-14, atol=1e-15)
    assert changing_columns(kind, kind.manifold.size) == set(np.flatnonzero(change.any((0, 1))))
    twice = [states.reshape(2, 25, -1) for states in (before, after)]
    assert np.array_equal(generator(kind, twice[0]), generator(kind, before).reshape(2, 25, -1, 6))
    assert change_of_generator(kind, *twice).shape == (2, 25, kind.manifold.dof, 6)


def test_where_the_motion_of_the_world_has_no_derivative_the_model_says_so():
    kind = MOVED["idpPnt"]
    states = np.array([kind.manifold.random(np.random.default_rng(1)) for _ in range(20)])
    states[7, 3] = np.inf
    with pytest.raises(SlamlibError, match="angles_moved"):
        generator(kind, states)


def test_of_points_and_directions_it_is_affine():
    """The slow way gives the same numbers: only this test notices where a type has fallen back to it."""
    slow = {name for name, kind in MOVED.items() if not is_affine(kind.moved.entries_where(ORIGIN), kind.manifold.size)}
    assert slow == NOT_AFFINE


@pytest.mark.parametrize("name", ["points", "self_calibration", "plane"])
def test_the_change_of_what_cannot_be_known_is_its_difference_and_its_other_columns_stay(name):
    p = with_options(name)
    slam = run(p, 5)
    frame = list(replace(p, frames=6).simulate())[-1][0]
    sensor = slam.sensors[-1]
    slam.predict(frame.controls, frame.dt)
    before = Unobservable(slam.state, sensor)
    blocks, rng = dict(enumerate(slam.belief.blocks)), np.random.default_rng(2)
    means = {i: b.manifold.plus(b.mean, 0.01 * rng.standard_normal(b.dof)) for i, b in blocks.items()}
    slam.belief.overwrite(blocks, means, slam.belief.matrix)
    after = Unobservable(slam.state, sensor)
    np.testing.assert_allclose(before.change(), after.N - before.N, atol=1e-13)
    changed = np.flatnonzero((after.N != before.N).any(axis=0))
    assert np.array_equal(before.changing(), changed)
    assert len(changed) < before.N.shape[1]
    np.testing.assert_array_equal(before.of_robots(sensor.columns), before.N[sensor.columns])
    (robot,) = slam.robots
    own = generator(robot.motion, robot.block.mean) @ robot.motion.free
    np.testing.assert_array_equal(after.N[robot.block.slice, : own.shape[1]], own)


@pytest.mark.parametrize("name", [*POINTS, *LINES])
def test_no_measurement_tells_the_motion_of_the_world(name):
    """H N = 0 for the filter's own Jacobians, of innovations too."""
    slam = run(with_landmark(name), 5)
    sensor, N = slam.sensors[0], generators(slam.state)
    predictions = predict_measurements(slam.belief, sensor, slam.families, slam.state.kinds(), slam.options)
    assert len(predictions) > 3
    for p in predictions:
        found = p.family.batch_innovation(sensor, p.batch.take([p.row]), p.value[None] + 1e-3)
        H, columns = found.H[0], p.batch.columns[p.row]
        assert np.abs(H @ N[columns]).max() < 1e-9 * np.abs(H).max() * np.abs(N[columns]).max()


def test_neither_robot_nor_extrinsics_are_told_apart_by_their_own_sensor():
    slam = run(with_options("self_calibration"), 5)
    right = slam.sensors[1]
    N = Unobservable(slam.state, right).N
    assert N.shape == (slam.belief.size, 12)
    assert np.linalg.matrix_rank(N) == 12
    for p in slam.project(1):
        H, columns = p.batch.jacobian[p.row], p.batch.columns[p.row]
        assert np.abs(H @ N[columns]).max() < 1e-9 * np.abs(H).max() * np.abs(N[columns]).max()


@pytest.mark.parametrize("motion", ["odometry", "planeOdometry", "unicycle"])
def test_robot_and_extrinsics_are_traded_in_as_many_directions_as_the_robot_is_free_to_move_in(motion):
    p = test_plane_motions.preset(MOTIONS["unicycle"])
    robot = RobotSetup(motion=motion, position=(0, -5, 0), euler=(0, 0, 70))
    sensor = replace(p.rig.sensors[0], euler=(20, 10, 30), estimated=True, position_std=(0.1,), orientation_std=(1,))
    slam = Slam(Rig((robot,), (sensor,)), options=p.options)
    ((frame, _),) = replace(p, frames=1).simulate()
    slam.step(replace(frame, controls=(None,)))
    (own,) = slam.sensors
    N = trade(slam.belief.size, own, own.block)
    (dof,) = slam.rig.dof
    assert N.shape == (slam.belief.size, dof)
    assert np.linalg.matrix_rank(N[own.robot.columns]) == dof
    assert len(slam.project()) > 5
    for predicted in slam.project():
        H, columns = predicted.batch.jacobian[predicted.row], predicted.batch.columns[predicted.row]
        assert np.abs(H @ N[columns]).max() < 1e-9 * np.abs(H).max() * np.abs(N[columns]).max()


def test_where_one_robot_stays_on_the_floor_the_world_moves_along_the_floor():
    rover, flyer = replace(test_plane_maps.ROBOT, name="rover"), RobotSetup(position=(0, 0, 1.0), name="flyer")
    camera = SensorSetup(robot=1, position=(0, 0, 0))
    options = replace(test_plane_maps.PRESET.options, error="world")
    p = replace(test_plane_maps.PRESET, rig=Rig((rover, flyer), (test_plane_maps.LASER, camera)), options=options)
    slam = run(p, 5)
    N = Unobservable(slam.state, slam.sensors[1]).N
    assert N.shape == (slam.belief.size, 3)
    assert np.linalg.matrix_rank(N[slam.robots[1].columns]) == 3
    seen = [prediction for prediction in slam.project(1) if prediction.landmark.kind.plane]
    assert seen
    for prediction in seen:
        H, columns = prediction.batch.jacobian[prediction.row], prediction.batch.columns[prediction.row]
        assert np.abs(H @ N[columns]).max() < 1e-9 * np.abs(H).max() * np.abs(N[columns]).max()
        with carried(slam.state, slam.sensors[1]) as project:  # of any Jacobian, what tells the motion is taken away
            assert np.abs(project(columns, H + 1) @ N[columns]).max() < 1e-9 * np.abs(N[columns]).max()


@pytest.mark.parametrize("n", [20, 200])
def test_coordinates_of_the_error_change_as_their_matrix_says(n):
    rng = np.random.default_rng(3)
    belief, A = Belief(), rng.standard_normal((n, n))
    belief.add(n, np.zeros(n), A @ A.T)
    before, rows, C = belief.matrix.copy(), np.array([4, 5, 9]), rng.standard_normal((n, 2))
    L = rng.standard_normal((2, 3))
    belief.transport = lambda: Carry(rows, C, L)
    H = rng.standard_normal((2, n))
    belief.update(list(belief.blocks), [H], np.zeros(2), np.eye(2))
    K = np.linalg.solve(H @ before @ H.T + np.eye(2), H @ before).T
    T, after = np.eye(n) + C @ L @ np.eye(n)[rows], before - K @ H @ before
    np.testing.assert_allclose(belief.matrix, T @ after @ T.T, rtol=1e-9, atol=1e-9 * np.abs(before).max())
    assert np.array_equal(belief.matrix, belief.matrix.T)


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize(
    "name", ["points", "lines", "two_robots", "self_calibration", "points_and_lines", "plane", *LINES]
)
def test_an_update_gains_nothing_where_nothing_is_told(name, reproject):
    """Of two filters one is unsure of the motion of the world; it stays exactly as unsure of that of the new means."""
    far, given = {}, with_landmark if name in LINES else with_options
    for error in ("local", "world"):
        p = replace(given(name, error=error, reproject=reproject, convert=False), frames=7)
        *frames, last = [frame for frame, _ in p.simulate()]
        sure, unsure = p.slam(), p.slam()
        for slam in (sure, unsure):
            for frame in frames:
                slam.step(frame)
            slam.predict(last.controls, last.dt)
        N, blocks = generators(unsure.state), dict(enumerate(unsure.belief.blocks))
        means = {i: block.mean for i, block in blocks.items()}
        unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ N.T)
        for slam in (sure, unsure):
            update(slam, last)
        assert not np.allclose(sure.robots[0].block.mean, means[0], atol=1e-6)
        N = generators(sure.state)
        difference = unsure.belief.matrix - sure.belief.matrix
        far[error] = np.linalg.norm(difference - N @ N.T) / np.linalg.norm(N @ N.T)
    assert far["world"] < 1e-9, far
    assert far["local"] > 1e-5, far


KINDS = ["idpPnt", "hmgPnt", "plkLin", "aplLin"]


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize("name", ["points", "two_robots", "self_calibration", "plane", *KINDS])
def test_a_start_known_less_by_a_motion_of_the_world_changes_nothing_else(name, reproject):
    """Over a whole run, with new, converted and extended landmarks: no mean, and the covariance by that motion alone.

    Chapter observability, eq. (ob-theorem).
    """
    given = with_landmark if name in POINTS or name in LINES else with_options
    p = replace(given(name, error="world", reproject=reproject), frames=20)
    sure, unsure = p.slam(), p.slam()
    N, blocks = generators(unsure.state), dict(enumerate(unsure.belief.blocks))
    means = {i: block.mean for i, block in blocks.items()}
    motion = np.diag([0.1, 0.1, 0.1, 0.09, 0.09, 0.09] if N.shape[1] == 6 else [0.1, 0.1, 0.09]) ** 2
    unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ motion @ N.T)
    for frame, _ in p.simulate():
        for slam in (sure, unsure):
            slam.step(frame)
    N = generators(sure.state)
    np.testing.assert_allclose(unsure.belief.matrix - sure.belief.matrix, N @ motion @ N.T, atol=1e-8)
    for a, b in zip(sure.belief.blocks, unsure.belief.blocks, strict=True):
        np.testing.assert_allclose(b.mean, a.mean, atol=1e-8)
    for a, b in zip(sure.landmarks, unsure.landmarks, strict=True):
        if a.abscissas is not None:
            np.testing.assert_allclose(b.abscissas, a.abscissas, atol=1e-8)


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize("name", ["points", "lines", "two_robots", "plane"])
def test_first_estimates_gain_nothing_where_nothing_is_told(name, reproject):
    """Of two filters one is unsure of the motion of the world; over motions and updates it stays exactly as unsure."""
    p = with_options(name, error="first-estimates", reproject=reproject, convert=False, gate=1.0)
    *frames, last = [frame for frame, _ in replace(p, frames=7).simulate()]
    sure, unsure = p.slam(), p.slam()
    for slam in (sure, unsure):
        for frame in frames:
            slam.step(frame)
    N, blocks = at_first_estimates(unsure), dict(enumerate(unsure.belief.blocks))
    means = {i: block.mean for i, block in blocks.items()}
    unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ N.T)
    for slam in (sure, unsure):
        slam.predict(last.controls, last.dt)
        update(slam, last)
    N = at_first_estimates(sure)
    np.testing.assert_allclose(unsure.belief.matrix - sure.belief.matrix, N @ N.T, atol=1e-9 * np.abs(N @ N.T).max())


def at_first_estimates(slam):
    """N (size, f) at the linearization points."""
    N = np.zeros((slam.belief.size, 6))
    for owner, kind in [(r, r.motion) for r in slam.robots] + [(lm, lm.kind) for lm in slam.landmarks]:
        N[owner.block.slice] = generator(kind, slam.linearization.at(owner.block))
    return N @ slam.robots[0].motion.free


def update(slam, frame):
    """The measurement update of the first sensor alone."""
    slam.predictions[0] = slam.project()
    slam._update(0, frame.scans[0])


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize("error", TRANSPORTS)
@pytest.mark.parametrize("name", ["points_and_lines", "self_calibration", "plane"])
def test_a_resumed_run_goes_on_bit_for_bit(name, error, reproject, tmp_path):
    p = replace(with_options(name, error=error, reproject=reproject), frames=24)
    slam, other = p.slam(), None
    for i, (frame, _) in enumerate(p.simulate()):
        slam.step(frame)
        if other:
            other.step(frame)
        if i == 11:
            slam.save(tmp_path / "half.npz")
            other = Slam.load(tmp_path / "half.npz")
    assert np.array_equal(slam.belief.matrix, other.belief.matrix)


def test_the_error_may_be_changed_between_two_steps(monkeypatch):
    p = with_options("points", points="idpPnt")
    slam, frames = p.slam(), [frame for frame, _ in replace(p, frames=12).simulate()]
    for i, error in enumerate(["local", "world", "first-estimates", "local"]):
        slam.options = replace(slam.options, error=error)
        assert isinstance(slam.linearization, FirstEstimates) == (error == "first-estimates")
        for frame in frames[3 * i : 3 * i + 3]:
            slam.step(frame)
    slam.linearization = own = Linearization()
    slam.options = replace(slam.options, updates=3)
    assert slam.linearization is own
    monkeypatch.setattr(slam.robots[0], "motion", replace(MOTIONS["odometry"], moved=None))
    with pytest.raises(SlamlibError, match="which has none"):
        slam.options = replace(slam.options, error="world")
    assert slam.options.error == "local"


def test_what_says_nothing_of_the_motion_of_the_world_is_refused_before_the_run():
    p, own = preset("points"), replace(POINTS["ahmPnt"], name="mine", moved=None)
    rig = Rig((replace(p.rig.robots[0], motion=replace(MOTIONS["odometry"], moved=None)),), p.rig.sensors)
    with pytest.raises(SlamlibError, match=r"needs the model moved\(motion, state\) of odometry, which has none"):
        Slam(rig, options=replace(p.options, error="world"))
    slam = run(with_options("points", error="world"), 3)
    slam.landmarks[0].kind = own
    with pytest.raises(SlamlibError, match="of mine, which has none"), carried(slam.state, slam.sensors[0]):
        pass


def reckoned_sigma(p):
    """Deviation [m] of the position at the end of a preset's run, by its controls alone."""
    slam, (robot,) = p.slam(), p.rig.robots
    for _ in range(p.frames):
        slam.predict([Control(robot.nominal, robot.noise)], p.dt)
    return np.sqrt(robot_view(slam.belief, slam.robots[0]).pose_covariance[:3, :3].trace())


@pytest.mark.parametrize("name", [*POINTS, *LINES])
def test_every_parametrization_is_consistent(name):
    """NEES of the pose with error="world", averaged over 8 runs at each of 60 frames."""
    p = replace(with_landmark(name, error="world", reproject=False), noise_in="truth", frames=60)
    runs = monte_carlo(p, 8, seed=5)
    found = runs.nees[:, :, 0]
    (dof,) = p.rig.dof
    average, (low, high) = found.mean(0), band(dof, 8)
    assert found.mean() < 1.25 * dof
    assert np.mean((low < average) & (average < high)) > 0.9
    # So far that holds for dead reckoning as well: what the measurements gain is a smaller deviation, and a map.
    assert runs.sigmas[:, -1, 0].max() < 0.8 * reckoned_sigma(p)
    assert runs.map_error.max() < 0.15  # [m]
