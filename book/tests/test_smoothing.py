"""Smoothing: exact Jacobians, the Kalman filter's answer where all is linear, GTSAM's where it is not, consistency."""

import sys
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from slambook.smoothing import Smoother, least_squares
from slambook.smoothing import smoother as smoother_module
from slambook.smoothing.factors import LOSSES
from slambook.smoothing.least_squares import by_cholmod, by_superlu

from book.experiments.consistency import by_range_and_bearing
from slamlib.analytic import arctan2, cos, sin
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band, share_inside
from slamlib.experiments.presets import preset
from slamlib.geometry.pose import Pose
from slamlib.landmarks import LINES, POINTS
from slamlib.manifolds import Angle
from slamlib.models import model
from slamlib.motions import MOTIONS, Motion
from slamlib.records.inputs import Features, RobotMeasurement, Scan, World
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate
from slamlib.slam import Options, Slam
from slamlib.slam.snapshot import robot_view
from slamlib.tests import test_plane, test_plane_maps, test_plane_motions
from slamlib.tests.test_seams import gps

pytest.importorskip("scipy.sparse")
FLYING = RobotSetup(
    motion="constVel", velocity=(1, 0, 0, 0, 0, 10), velocity_std=(0.1, 0.1, 0.1, 1, 1, 1), position=(0, -5, 0),
    control_std=(0.01, 0.01, 0.01, 0.1, 0.1, 0.1), position_std=(0.01,), orientation_std=(0.5,),
)  # fmt: skip


def with_options(name, **options):
    p = preset(name)
    return replace(p, options=replace(p.options, **options))


def recorded(p, change=lambda frame, truth: frame):
    """The smoother of all frames, the filter, the true poses (n, 7) and the filtered ones of the first robot."""
    slam, true, filtered = p.slam(), [], []
    smoother = Smoother(slam)
    for frame, truth in p.simulate():
        frame = change(frame, truth)
        slam.step(frame)
        smoother.record(frame)
        true.append(truth.poses[0])
        filtered.append(slam.robots[0].pose)
    return smoother, slam, np.array(true), np.array(filtered)


def flying():
    p = preset("stereo")
    return replace(p, rig=Rig((FLYING,), p.rig.sensors), noise_in="truth")


def in_the_plane(motion, **changes):
    """A robot that drives on an arc, and is not sure where it starts; what its sensor is else."""
    p = test_plane_motions.preset(MOTIONS[motion])
    (robot,), (sensor,) = p.rig.robots, p.rig.sensors
    robot = replace(robot, position_std=(0.3, 0.3, 0), orientation_std=(0, 0, 3))
    return replace(p, rig=Rig((robot,), (replace(sensor, **changes),)), frames=60)


def mounted_in_the_plane():
    p = in_the_plane("unicycle", estimated=True, position_std=(0.02,), orientation_std=(1.0,))
    return replace(p, options=replace(p.options, points="idpPnt", convert=False))


@model(state=Angle(1), control=1, dt=(), returns=Angle(1))
def rolled(state, control, dt):
    """Further round."""
    return state + control


@model(state=Angle(1), returns=Pose)
def on_the_ring(state):
    """On a ring of 5 m, looking outwards."""
    (a,) = state
    return np.array([5 * cos(a), 5 * sin(a), 0, cos(a / 2), 0, 0, sin(a / 2)])


@model(pose=Pose, returns=Angle(1))
def round_the_ring(pose):
    """How far round."""
    return np.array([arctan2(pose[1], pose[0])])


def on_rails():
    """A state of one number; how the pose depends on it depends on where it is."""
    p = test_plane_motions.preset(MOTIONS["unicycle"])
    ring = Motion("ring", Angle(1), 1, rolled, moved=None, angles=(0,), pose_of=on_the_ring, from_pose=round_the_ring)
    robot = RobotSetup(motion=ring, position=(5, 0, 0), control=(9,), control_std=(1,), position_std=(0, 0.3, 0))
    return replace(p, rig=Rig((robot,), p.rig.sensors), frames=30)


CASES = {
    "odometry": lambda: with_options("points", points="idpPnt", convert=False),
    "converted": lambda: with_options("points", points="ahmPnt"),
    "extrinsics": lambda: with_options("self_calibration"),
    "robots": lambda: with_options("two_robots"),
    "lines": lambda: with_options("lines", lines="aplLin", max_new=3),
    "lines of two points": lambda: with_options("lines", lines="hmgLin", max_new=3),
    "constant velocity": flying,
    "plane": partial(in_the_plane, "planeOdometry"),
    "plane, extrinsics": mounted_in_the_plane,
    "points of the plane": lambda: replace(test_plane_maps.PRESET, frames=20),
    "bearings in the plane": lambda: replace(
        test_plane_maps.PRESET, rig=Rig((test_plane_maps.SLOW,), test_plane_maps.RIGS["bearing only"])
    ),
    "rails": on_rails,
}


def by_gps(frame, truth):
    """The frame, with the true position of the robot."""
    return replace(frame, absolute=(RobotMeasurement("gps", gps, gps(truth.poses[0]), 0.01 * np.eye(3)),))


@pytest.mark.parametrize("name", CASES)
def test_the_jacobians_are_those_of_the_residuals(name):
    """Central differences over all unknown numbers, at the solution, where no slack is left.

    Numbers of which J says that they share no residual move together: were that wrong, the differences would show it.
    """
    smoother, *_ = recorded(replace(CASES[name](), frames=7), by_gps)
    found = smoother.solve()
    matches = smoother._usable([m for m in smoother._matches if m.inlier])
    variables, values, _, groups = smoother._problem(matches)
    for i, states in enumerate(found.states):
        values[i] = states
    factors = smoother._motions(variables, values) + [partial(group.terms, loss=LOSSES["squares"]) for group in groups]
    assert len(groups) > 0
    size = found.minimum.size

    def residuals(step):
        moved = [v.moved(x, step) for v, x in zip(variables, values, strict=True)]
        return np.concatenate([factor(moved).residual.ravel() for factor in factors])

    J, start = np.zeros((len(residuals(np.zeros(size))), size)), 0
    for factor in factors:
        terms = factor(values)
        for variable, items, by in terms.parts:
            B = variable.basis(values[variable.index])
            for n, item in enumerate(items):
                rows = start + n * terms.residual.shape[1] + np.arange(terms.residual.shape[1])
                J[rows[:, None], variable.columns(np.array([item]))[0]] += by[n] @ B[item]
        start += terms.residual.size
    together: list[list[int]] = []
    for column in range(size):
        apart = [group for group in together if not (J[:, group].any(1) & (J[:, column] != 0)).any()]
        if not apart:
            together.append([column])
        else:
            apart[0].append(column)
    h = 1e-5
    scale = np.maximum(np.abs(J).max(1), 1e-3)  # next to nothing: the height of a robot in the plane
    for group in together:
        step = np.isin(np.arange(size), group).astype(float)
        numeric = (residuals(h * step) - residuals(-h * step)) / (2 * h)
        np.testing.assert_allclose(numeric / scale, J[:, group].sum(1) / scale, atol=2e-6)


TURN = float(np.degrees(2e-6))
ROBOTS = {  # that know their orientation to a few microradians
    "space": RobotSetup(control=(0.1, 0, 0, 0, 0, 2), control_std=(0.02,) * 3 + (TURN,) * 3, position_std=(0.3,),
                        orientation_std=(TURN,)),
    "plane": RobotSetup(motion="planeOdometry", control=(0.1, 0, 2), control_std=(0.02, 0.02, TURN),
                        position_std=(0.3, 0.3, 0), orientation_std=(0, 0, TURN)),
}  # fmt: skip


def linear(robot):
    """A robot that measures relative positions: all is linear."""
    sensor = SensorSetup(type="relativePosition", std=(0.05,), euler=(0, 0, 0), limits={"far": 5.0})
    p = with_options("points", points="eucPnt", gate=1.0, updates=99, max_new=99, max_new_first=99)
    return replace(p, rig=Rig((robot,), (sensor,)), frames=40, noise_in="truth")


@pytest.mark.parametrize("robot", ROBOTS)
def test_where_all_is_linear_the_last_pose_is_the_filters(robot):
    smoother, slam, *_ = recorded(linear(ROBOTS[robot]))
    found = smoother.solve()
    assert len(found.landmarks) > 10
    np.testing.assert_allclose(found.poses[-1, 0], slam.robots[0].pose, atol=1e-8)
    covariance = robot_view(slam.belief, slam.robots[0]).pose_covariance
    np.testing.assert_allclose(found.covariance(), covariance, atol=1e-9)
    for landmark in slam.landmarks:
        position, P = found.point(landmark.id)
        np.testing.assert_allclose(position, landmark.block.mean, atol=1e-8)
        np.testing.assert_allclose(P, slam.belief.covariance(landmark.block), atol=1e-9)
    assert (np.linalg.eigvalsh(found.covariance(0)[:3, :3]) < np.linalg.eigvalsh(covariance[:3, :3]) + 1).all()


def test_all_parametrizations_of_points_in_space_have_one_best_estimate():
    estimates = []
    for kind in POINTS:
        if kind != "eucPnt" and not POINTS[kind].plane:
            p = with_options("points", points=kind, convert=False, gate=1.0, updates=99, selection="order")
            smoother, *_ = recorded(replace(p, frames=30))
            estimates.append(smoother.solve())
    for other in estimates[1:]:
        assert other.left_out == estimates[0].left_out
        assert abs(other.costs[-1] - estimates[0].costs[-1]) < 1e-6
        np.testing.assert_allclose(other.poses, estimates[0].poses, atol=1e-7)
        np.testing.assert_allclose(other.covariance(), estimates[0].covariance(), rtol=1e-5, atol=1e-10)


@pytest.mark.parametrize("kind", LINES)
def test_every_line_is_smoothed(kind):
    smoother, *_ = recorded(replace(with_options("lines", lines=kind, max_new=3), frames=40))
    found = smoother.solve()
    assert found.costs[-1] < 1.3 * found.dof
    assert np.isfinite(found.covariance(np.arange(40))).all()
    with pytest.raises(SlamlibError, match=f"is a {kind}, no point"):
        found.point(next(iter(found.landmarks)))


def nees(errors, covariances):
    return np.einsum("ni,nij,nj->n", errors, np.linalg.inv(covariances), errors)


@pytest.mark.parametrize("name", ["points", "self_calibration", "constant velocity", "points of the plane"])
def test_ten_runs_are_consistent_and_no_worse_than_the_filter(name):
    p = CASES[name]() if name in CASES else replace(with_options(name, convert=False), noise_in="truth")
    places, free = p.world.points, p.rig.robots[0].model.free
    there = dict(zip(places.ids.tolist(), places.values, strict=True))
    last, everywhere, off, away = [], [], [], []
    for seed in range(10):
        smoother, _, true, filtered = recorded(replace(p, frames=60, seed=seed))
        found = smoother.solve()
        assert found.minimum.converged
        e = Pose.minus(true, found.poses[:, 0])
        series = nees(e[4:] @ free, free.T @ found.covariance(np.arange(4, 60)) @ free)
        last.append(series[-1])
        everywhere.append(series.mean())
        off.append([np.sqrt((x[:, :3] ** 2).sum(1).mean()) for x in (e, Pose.minus(true, filtered))])
        away += [np.linalg.norm(kind.to_point(x) - there[i]) for i, (kind, x) in found.landmarks.items()]
    assert np.median(away) < 0.1  # [m]; with no measurement there is no map
    low, high = band(free.shape[1], 10, 0.999)
    assert low < np.mean(last) < high
    assert low < np.mean(everywhere) < high
    smoothed, filter_ = np.mean(off, axis=0)
    assert smoothed < 1.02 * filter_


def test_in_the_plane_it_is_that_of_a_robot_in_space_which_cannot_leave_it():
    smoothers = []
    for rig, lift in ((test_plane.PRESET.rig, lambda frame: frame), (test_plane.lifted_rig(), test_plane.lifted)):
        slam = Slam(rig, options=test_plane.PRESET.options)
        smoothers.append(Smoother(slam))
        for frame, _ in test_plane.PRESET.simulate():
            slam.step(lift(frame))
            smoothers[-1].record(lift(frame))
    plane, space = (smoother.solve() for smoother in smoothers)
    assert plane.minimum.converged
    assert plane.dof == space.dof
    assert plane.minimum.size == space.minimum.size - 3 * 61
    assert abs(plane.costs[-1] - space.costs[-1]) < 1e-3
    assert np.abs(Pose.minus(plane.poses, space.poses)).max() < 1e-6
    P, Q = (found.covariance(np.arange(60)) for found in (plane, space))
    assert np.abs(P - Q).max() < 1e-6 * np.abs(Q).max()
    assert plane.landmarks.keys() == space.landmarks.keys()
    for number in plane.landmarks:
        for one, other in zip(plane.point(number), space.point(number), strict=True):
            np.testing.assert_allclose(one, other, atol=1e-6)


def test_on_rails_the_covariance_lies_along_them_at_each_frame():
    smoother, _, true, _ = recorded(on_rails())
    found = smoother.solve()
    P, e = found.covariance(np.arange(30)), Pose.minus(true, found.poses[:, 0])
    across = found.poses[:, 0, :3] / 5
    assert np.abs(P[:, :3, :3] @ across[:, :, None]).max() < 1e-9 * P.max()
    position, heading = np.trace(P[:, :3, :3], axis1=1, axis2=2), P[:, 5, 5]
    assert (np.linalg.norm(e[:, :3], axis=1) < 3 * np.sqrt(position)).all()
    np.testing.assert_allclose(position, 25 * heading, rtol=1e-9)


@pytest.mark.parametrize(("motion", "seeds"), [("planeOdometry", 1), ("unicycle", 2)])
def test_in_the_plane_nees_is_of_three_degrees_of_freedom(motion, seeds):
    """The average of 25 runs at each of 40 frames, after the first four; nothing is refused by a gate."""
    p, average, off, costs, free = test_plane_motions.preset(MOTIONS[motion]), 0.0, [], [], MOTIONS[motion].free
    p = replace(p, options=replace(p.options, gate=1.0))
    for seed in np.random.default_rng(seeds).integers(2**32, size=25).tolist():
        smoother, _, true, filtered = recorded(replace(p, seed=seed))
        found = smoother.solve()
        e, P = Pose.minus(true, found.poses[:, 0]), found.covariance(np.arange(40))
        assert np.abs(e[:, 2:5]).max() < 1e-9
        average += nees(e @ free, free.T @ P @ free)[4:] / 25
        off.append([np.sqrt((x[:, :3] ** 2).sum(1).mean()) for x in (e, Pose.minus(true, filtered))])
        costs.append(found.costs[-1] / found.dof)
    smoothed, filter_ = np.mean(off, axis=0)
    print(f"NEES {average.mean():.2f}, {smoothed:.3f} m off, the filter {filter_:.3f} m; cost {np.mean(costs):.3f} dof")
    assert share_inside(average, band(3, 25, 0.999)) == 1
    assert 0.97 < np.mean(costs) < 1.03
    assert smoothed < filter_


def with_gross_errors(rng):
    """A change of frames: one measurement in twenty is wrong by up to 60 px."""

    def change(frame, truth):
        points = frame.scans[0].points
        wrong = (rng.random(len(points)) < 0.05)[:, None] * rng.uniform(-60, 60, (len(points), 2))
        return replace(frame, scans=(Scan({"points": Features(points.ids, points.values + wrong)}),))

    return change


def test_a_robust_loss_bears_gross_errors():
    """Position errors over three runs, with all that the filter's gate refused: the loss does what the gate did."""
    off = {"clean": [], "squares": [], "huber": [], "cauchy": []}
    for seed in range(3):
        p = replace(with_options("points", points="idpPnt", convert=False), frames=60, seed=seed)
        clean, _, true, _ = recorded(p)
        dirty, *_ = recorded(p, with_gross_errors(np.random.default_rng(seed)))
        for name, values in off.items():
            found = clean.solve() if name == "clean" else dirty.solve(loss=name, refused=True)
            e = Pose.minus(true, found.poses[:, 0])[:, :3]
            values.append(np.sqrt((e**2).sum(1).mean()))
    mean = {name: np.mean(values) for name, values in off.items()}
    assert mean["huber"] < 1.2 * mean["clean"], mean
    assert mean["cauchy"] < 1.2 * mean["clean"], mean
    assert mean["squares"] > 2 * mean["clean"], mean


def test_no_step_ever_raises_the_cost_and_damping_finds_the_same_place():
    smoother, *_ = recorded(replace(with_options("points"), frames=40))
    found = smoother.solve()
    assert found.minimum.converged
    assert (np.diff(found.costs) <= 0).all()
    first = smoother.solve(steps=1)
    assert not first.minimum.converged
    assert first.costs[-1] > found.costs[-1]
    assert smoother.solve(steps=0).costs == found.costs[:1]


def round_the_square():
    """Two laps of a robot that cannot slip aside, with coarse measurements of eight landmarks."""
    places = [[3, -2], [7, -2.2], [9.8, 1], [9.9, 5], [7, 9.2], [3, 9.3], [-0.8, 8], [-1.5, 4.5]]
    robot = RobotSetup(control_std=(0.05, 0, 0, 0, 0, 1.0))
    sensor = SensorSetup(type="rangeBearing", euler=(0, 0, 0), std=(0.3, *np.radians([3.0, 3.0])), limits={"far": 4.0})
    way = np.zeros((160, 6))
    way[:, [0, 5]] = [*[(0.4, 0.0)] * 15, *[(0.4, np.radians(18))] * 5] * 8
    world = World({"points": Features(np.arange(8), np.column_stack([places, np.zeros(8)]))})
    return Rig((robot,), (sensor,)), world, way


@pytest.mark.parametrize("seed", [6, 9])
def test_where_the_robot_cannot_slip_aside_the_steps_come_from_a_wider_valley(monkeypatch, seed):
    rig, world, way = round_the_square()
    slam = Slam(rig, options=Options(points="eucPnt", max_new_first=8, max_new=8, updates=8, gate=1))
    smoother = Smoother(slam)
    for frame, _ in simulate(rig, world, frames=160, dt=1.0, rng=np.random.default_rng(seed), controls=[way]):
        slam.step(frame)
        smoother.record(frame)
    found = smoother.solve()
    assert found.minimum.converged
    assert found.costs[-1] < 1.2 * found.dof
    monkeypatch.setattr(smoother_module, "LOOSE", (1.0,))
    stuck = smoother.solve()
    assert not stuck.minimum.converged
    assert stuck.costs[-1] > 3 * found.costs[-1]


@pytest.mark.parametrize("seed", [2, 4])
def test_what_was_measured_at_the_edge_of_the_view_is_used(seed):
    """After a step its prediction may lie beyond the edge."""
    p = by_range_and_bearing(replace(preset("points"), noise_in="truth", frames=150, seed=seed))
    smoother, *_ = recorded(p)
    found = smoother.solve()
    assert found.minimum.converged
    assert found.left_out == sum(not match.inlier for match in smoother._matches)
    assert found.costs[-1] < 1.15 * found.dof


def with_cholmod():
    pytest.importorskip("sksparse", minversion="0.5", reason="pip install 'scikit-sparse>=0.5', to factor by CHOLMOD")


@pytest.mark.parametrize("name", ["odometry", "lines of two points", "robots"])
def test_cholmod_finds_what_scipy_finds(monkeypatch, name):
    """After as many steps: which one is the last is a matter of rounding."""
    with_cholmod()
    smoother, *_ = recorded(replace(CASES[name](), frames=60))
    with monkeypatch.context() as patched:
        patched.setattr(least_squares, "by_superlu", None)
        found = smoother.solve(steps=3)
    monkeypatch.setitem(sys.modules, "sksparse.cholmod", None)  # as if it were not installed
    other = smoother.solve(steps=3)
    for ours, theirs in zip(found.minimum.values, other.minimum.values, strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-9)
    ours, theirs = (smoothed.covariance(np.arange(60)) for smoothed in (found, other))
    assert np.abs(ours - theirs).max() < 1e-9 * np.abs(theirs).max()


@pytest.mark.parametrize("factored", [by_superlu, by_cholmod])
def test_what_is_not_positive_definite_is_not_solved(factored):
    if factored is by_cholmod:
        with_cholmod()
    sparse = pytest.importorskip("scipy.sparse")
    H = np.array([[4.0, 2, 0], [2, 3, 1], [0, 1, 2]])
    b = np.array([1.0, 2, 3])
    np.testing.assert_allclose(H @ factored(sparse.csc_matrix(H))(b), b, atol=1e-14)
    assert factored(sparse.csc_matrix(H - 2.5 * np.eye(3))) is None
    assert factored(sparse.csc_matrix(H * np.array([[1, 1, 0], [1, 1, 0], [0, 0, 0]]))) is None


def test_a_deleted_landmark_still_tells_where_the_robot_was():
    p = replace(with_options("points", window=3, points="idpPnt"), frames=60)
    smoother, slam, *_ = recorded(p)
    found = smoother.solve()
    assert len(smoother._last) > len(slam.landmarks)
    assert set(found.landmarks) <= {landmark.id for landmark in slam.landmarks}
    assert (
        sum(v.width * len(found.states[0]) for v in found.minimum.variables[:1]) + 3 * len(found.landmarks)
        < found.minimum.size
    )


@pytest.mark.parametrize("name", ["odometry", "extrinsics", "plane, extrinsics"])
def test_a_filter_that_was_loaded_again_has_all_factors(name, tmp_path):
    p, found = replace(CASES[name](), frames=12), []
    for resumed in (False, True):
        slam = p.slam()
        smoother = Smoother(slam)
        for frame, _ in p.simulate():
            slam.step(frame)
            if resumed and frame.number == 9:
                with pytest.raises(SlamlibError, match=r"at 0\.9 s, and the last frame was recorded at 0\.8 s; record"):
                    smoother.resume(slam)
            smoother.record(frame)
            if resumed and frame.number in (1, 7):
                slam.save(tmp_path / "slam.npz")
                slam = Slam.load(tmp_path / "slam.npz")
                smoother.resume(slam)
        found.append(smoother.solve())
    assert found[0].dof == found[1].dof
    assert np.array_equal(found[0].states[0], found[1].states[0])
    assert found[0].landmarks.keys() == found[1].landmarks.keys()
    with pytest.raises(SlamlibError, match="has another rig"):
        smoother.resume(preset("two_robots").slam())


def test_misuse_is_named():
    p = replace(preset("points"), frames=3)
    slam = p.slam()
    smoother, (frame, other, last) = Smoother(slam), [frame for frame, _ in p.simulate()]
    with pytest.raises(SlamlibError, match="no frame has been recorded"):
        smoother.solve()
    slam.step(frame)
    with pytest.raises(SlamlibError, match="frame 2 is not the filter's last step"):
        smoother.record(other)
    smoother.record(frame)
    with pytest.raises(SlamlibError, match="frame 1 is not the filter's last step"):
        smoother.record(frame)
    with pytest.raises(SlamlibError, match="has begun already"):
        Smoother(slam)
    slam.step(other)
    slam.step(last)
    with pytest.raises(SlamlibError, match="frame 3 is not the filter's last step"):
        smoother.record(last)
    with pytest.raises(SlamlibError, match="unknown loss 'hubber'; did you mean 'huber'"):
        smoother.solve(loss="hubber")
    found = smoother.solve()
    with pytest.raises(SlamlibError, match="whole numbers from -1 to 0, got 1"):
        found.covariance(1)
    with pytest.raises(SlamlibError, match="landmark 999 was not smoothed"):
        found.point(999)
