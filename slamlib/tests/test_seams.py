"""The seams: measurements without a landmark, the size of a control, linearization, retraction."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.entities.linearization import Linearization
from slamlib.errors import ShapeError, SlamlibError
from slamlib.experiments.presets import preset
from slamlib.experiments.runs import map_errors
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.models import model
from slamlib.motions import Motion
from slamlib.observation.family import columns_jacobian, viewpoint
from slamlib.records.inputs import Frame, RobotMeasurement, Scan
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate
from slamlib.slam import Options, Slam


@model(pose=Pose)
def gps(pose):
    """Position [m] of an antenna on the robot."""
    return pose[:3] + rotation(pose[3:]) @ np.array([1, 0, 0]) / 5 + rotation(pose[3:]) @ np.array([0, 0, 1]) / 2


@model(pose=Pose)
def compass(pose):
    """Direction of the robot's front in the horizontal plane: cosine and sine of its heading."""
    ahead = rotation(pose[3:])[:, 0]
    return ahead[:2]


def driven(measure, frames=120):
    """A robot that drives a circle by noisy odometry, and measures itself: its filter, and the last true pose."""
    p = replace(preset("points"), frames=frames, noise_in="truth", options=Options(points=None))
    rig = Rig((replace(p.rig.robots[0], position_std=(0.5,), orientation_std=(5.0,)),), p.rig.sensors)
    p = replace(p, rig=rig)
    slam, rng, nis, nees = p.slam(), np.random.default_rng(3), [], []
    for frame, truth in p.simulate():
        slam.step(replace(frame, absolute=measure(truth.robots[0], rng)))
        nis += [(update.nis, len(update.innovation), update.inlier) for update in slam.absolute]
        e = Pose.minus(truth.robots[0], slam.robots[0].pose)
        nees.append(e @ np.linalg.solve(slam.belief.covariance(slam.robots[0].block), e))
    return slam, np.array(nis), np.array(nees)


def by_gps(pose, rng):
    return (RobotMeasurement("gps", gps, gps(pose) + 0.1 * rng.standard_normal(3), 0.01 * np.eye(3)),)


def by_compass(pose, rng):
    return (RobotMeasurement("compass", compass, compass(pose) + 0.02 * rng.standard_normal(2), 4e-4 * np.eye(2)),)


@pytest.mark.parametrize(("measure", "rows"), [(by_gps, [0, 1, 2]), (by_compass, [5])])
def test_a_measurement_without_a_landmark_updates_the_robot(measure, rows):
    alone, none, _ = driven(lambda pose, rng: ())
    slam, nis, nees = driven(measure)
    sigma, free = (np.sqrt(s.belief.covariance(s.robots[0].block).diagonal())[rows] for s in (slam, alone))
    assert len(none) == 0
    assert len(nis) == 120
    assert (sigma < free / 2).all()
    assert 0.7 < nis[:, 0].mean() / nis[0, 1] < 1.3
    assert nis[:, 2].mean() > 0.95
    assert np.median(nees) < 15


def test_what_cannot_be_is_refused_by_the_gate_and_changes_nothing():
    slam = preset("points").slam()
    wild = RobotMeasurement("gps", gps, np.array([90.0, 0, 0]), 0.01 * np.eye(3))
    scans, state = (Scan(),), slam.belief.snapshot()
    slam.step(Frame(1, 0.1, (None,), scans, (wild,)))
    (judged,) = slam.absolute
    assert not judged.inlier
    assert judged.nis > 1000
    assert np.array_equal(slam.belief.covariance(slam.robots[0].block), slam.robots[0].noise + state.covariance)
    slam.step(Frame(2, 0.1, (None,), scans))
    assert slam.absolute == []
    with pytest.raises(SlamlibError, match="gps is of robot 3"):
        slam.step(Frame(3, 0.1, (None,), scans, (replace(wild, robot=3),)))


@model(state=Pose, control=2, dt=(), returns=Pose)
def unicycle(state, control, dt):
    """Ahead along the chord, at half of the turn; speed [m/s] and yaw rate [rad/s] for dt [s]."""
    turn = control[1] * dt / 2
    half, whole = exponential(np.array([0, 0, 1]) * turn), exponential(np.array([0, 0, 2]) * turn)
    middle = compose(state, np.concatenate([np.zeros(3), half]))
    along = compose(middle, np.concatenate([np.array([1, 0, 0]) * control[0] * dt, half]))
    return np.concatenate([along[:3], compose(state, np.concatenate([np.zeros(3), whole]))[3:]])


UNICYCLE = Motion("unicycle", Pose, control=2, step=unicycle, angles=(1,))


def test_a_control_is_as_large_as_its_motion_says():
    p = preset("points")
    robot = replace(p.rig.robots[0], motion=UNICYCLE, control=(0.8, 9.0), control_std=(0.05, 0.5))
    assert np.allclose(robot.nominal, [0.8, np.radians(9)])
    assert np.allclose(robot.noise, np.diag([0.05, np.radians(0.5)]) ** 2)
    assert replace(robot, control=()).nominal.tolist() == [0, 0]
    p = replace(p, rig=Rig((robot,), p.rig.sensors), frames=60)
    slam = p.slam()
    for frame, truth in p.simulate():  # noqa: B007
        slam.step(frame)
    assert frame.controls[0].value.shape == (2,)
    assert np.linalg.norm(slam.robots[0].pose[:3] - truth.robots[0][:3]) < 0.1
    assert np.median(map_errors(slam.snapshot(), p.world)["points"]) < 0.1  # [m]; without updates 2
    with pytest.raises(ShapeError, match=r"control should have shape \(2,\)"):
        replace(robot, control=(0.1,) * 6).nominal  # noqa: B018
    with pytest.raises(SlamlibError, match="controls of 2 numbers, got 6"):
        slam.step(replace(frame, controls=(replace(frame.controls[0], value=np.zeros(6), covariance=np.eye(6)),)))


class First(Linearization):
    """Jacobians w.r.t. a landmark are taken where it was initialized, those of robots at their predictions."""

    def __init__(self):
        self.first = {}

    def at(self, block):
        mean = self.first.setdefault(block, block.mean)
        return mean if len(mean) == len(block.mean) else block.mean

    def predicted(self, block):
        self.first[block] = block.mean


@pytest.mark.parametrize("name", ["points", "lines"])
@pytest.mark.parametrize("reproject", [True, False])
def test_jacobians_are_taken_at_the_point_of_linearization(name, reproject):
    p = preset(name)
    p = replace(p, frames=12, options=replace(p.options, reproject=reproject, convert=False))
    runs = [p.slam() for _ in range(3)]
    runs[1].linearization, runs[2].linearization = Linearization(), First()
    for frame, _ in p.simulate():
        for slam in runs:
            slam.step(frame)
    plain, same, first = runs
    assert np.array_equal(plain.belief.matrix, same.belief.matrix)
    assert not np.allclose(plain.belief.matrix, first.belief.matrix, rtol=1e-6)
    predictions = first.project()
    assert predictions
    for prediction in (
        predictions if name == "points" else ()
    ):  # the value is of the present mean, the Jacobian of the first one
        view, lm, family = viewpoint(first.sensors[0]), prediction.landmark, prediction.family
        value, _, _ = family.observe(lm.kind, view.sensor.calibration, view.pose, lm.block.mean)
        J = family.observe(
            lm.kind, view.sensor.calibration, view.linearization_pose, first.linearization.first[lm.block]
        )[2]
        assert np.allclose(prediction.value, value, atol=1e-9)
        assert np.allclose(
            prediction.batch.jacobian[prediction.row], columns_jacobian(view, J.camera, J.landmark), atol=1e-9
        )


def test_a_belief_moves_its_means_by_its_retraction():
    calls = []

    def halfway(blocks, step):
        calls.append(len(blocks))
        return [block.manifold.plus(block.mean, step[block.slice] / 2) for block in blocks]

    found = []
    for retraction in (None, halfway):
        belief = Belief(retraction)
        pose = belief.add(Pose, np.array([0.0, 0, 0, 1, 0, 0, 0]), np.eye(6))
        point, other = (belief.add(n, np.ones(n), np.eye(n)) for n in (3, 2))
        belief.update([pose, point], [np.ones((1, 6)) / 9, np.ones((1, 3))], np.array([0.3]), np.eye(1))
        with belief.sequential_update() as sequence:
            sequence.update(np.arange(9, 11), np.ones((1, 2)), np.array([0.5]), np.eye(1))
        found.append((Pose.minus(pose.mean, np.array([0.0, 0, 0, 1, 0, 0, 0])), point.mean - 1, other.mean - 1))
    for plain, half in zip(*found, strict=True):
        assert np.abs(plain).max() > 0.005
        assert np.allclose(half, plain / 2, atol=1e-12)
    assert calls == [3, 3]


def test_options_are_read_where_they_are_used():
    p = replace(preset("points"), frames=12)
    slam = p.slam()
    frames = [frame for frame, _ in p.simulate()]
    slam.step(frames[0])
    slam.options = replace(slam.options, points="ahmPnt", max_new=5)
    slam.step(frames[1])
    assert {lm.kind.name for lm in slam.landmarks if lm.first_seen == 2} == {"ahmPnt"}


def test_what_is_expected_from_another_pose_changes_nothing():
    p = replace(preset("points"), frames=10)
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    before = slam.robots[0].pose.copy()
    still = slam.project(motion=np.array([0.0, 0, 0, 1, 0, 0, 0]))
    now = slam.project()
    assert [prediction.value.tolist() for prediction in still] == [prediction.value.tolist() for prediction in now]
    moved = slam.project(motion=np.array([0.1, 0, 0, 1, 0, 0, 0]))
    assert not np.allclose(moved[0].value, now[0].value, atol=1e-3)
    assert np.array_equal(slam.robots[0].pose, before)


def test_a_family_that_nobody_knows_is_named():
    with pytest.raises(AttributeError, match="pionts"):
        Scan().pionts  # noqa: B018
    assert len(Scan().segments) == 0
    with pytest.raises(SlamlibError, match=r"unknown Options\.others 'planes'"):
        Options(others={"planes": "footPln"})


def test_a_rig_without_controls_simulates_a_robot_that_stands():
    rig = Rig((RobotSetup(),), (SensorSetup(),))
    ((frame, truth),) = simulate(rig, preset("points").world, frames=1, dt=0.1, rng=np.random.default_rng(1))
    assert frame.controls[0].value.tolist() == [0.0] * 6
    assert np.array_equal(truth.robots[0], rig.robots[0].state)
    assert Slam(rig).step(frame).initialized
