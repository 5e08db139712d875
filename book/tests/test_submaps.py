"""Maps closed and started anew, joined and tied (slambook.submaps)."""

from dataclasses import replace

import numpy as np
import pytest
from slambook.submaps import Atlas, Submap, SubmapSlam

from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import Consistency, band, nees, rmse
from slamlib.experiments import presets
from slamlib.geometry import pose, pose2
from slamlib.geometry.pose import Pose, from_frame
from slamlib.motions import ODOMETRY
from slamlib.motions.plane_odometry import PLANE_ODOMETRY
from slamlib.rigs.setup import Rig, SensorSetup
from slamlib.slam import Options
from slamlib.slam.snapshot import robot_view

EYES = SensorSetup(
    type="stereo", position=(0, 0, 0.6), parameters={"intrinsics": (320, 240, 320, 320), "baseline": (0.5,)}
)
OPTIONS = Options(points="eucPnt", max_new_first=5, max_new=2)
STEPS = {ODOMETRY: (0.16, 0, 0, 0, 0, 1.8), PLANE_ODOMETRY: (0.16, 0, 1.8)}  # [m], [deg]
in_space_and_in_the_plane = pytest.mark.parametrize("motion", STEPS, ids=lambda motion: motion.name)


def cloister(frames, sensor=EYES, options=OPTIONS, noise=(0.02, 0.2), motion=ODOMETRY):
    """A round of the cloister, in big steps; noise of each step's displacement [m] and rotation [deg]."""
    points, control = presets.points(), STEPS[motion]
    std = tuple(noise[i in motion.angles] for i in range(motion.control))
    robot = replace(points.rig.robots[0], motion=motion, control=control, control_std=std)
    return replace(points, rig=Rig((robot,), (sensor,)), options=options, frames=frames)


def some_map(rng, ids, motion, spread=0.1):
    """A submap whose pose and points are drawn, with a covariance that is full."""
    n = motion.manifold.dof + 3 * len(ids)
    root = spread * rng.normal(size=(n, n)) / np.sqrt(n)
    return Submap(motion.manifold.random(rng), np.array(ids, dtype=int), rng.normal(size=(len(ids), 3)), root @ root.T)


def drawn(submap, motion, rng):
    """A true state and points, drawn from the submap's covariance."""
    step = np.linalg.cholesky(submap.covariance + 1e-18 * np.eye(len(submap.covariance))) @ rng.normal(
        size=len(submap.covariance)
    )
    state, d = motion.manifold, motion.manifold.dof
    return state.plus(submap.state, step[:d]), submap.points + step[d:].reshape(-1, 3)


@pytest.mark.parametrize(
    ("motion", "compose", "origin"),
    [(ODOMETRY, pose.compose, pose.ORIGIN), (PLANE_ODOMETRY, pose2.compose, np.zeros(3))],
    ids=["odometry", "planeOdometry"],
)
def test_join_has_the_covariance_of_composed_samples(motion, compose, origin):
    rng = np.random.default_rng(3)
    maps = [some_map(rng, ids, motion, spread=1e-3) for ids in ([1, 2], [3, 4, 5], [6])]
    atlas, state = Atlas(motion), motion.manifold
    for submap in maps:
        atlas.join(submap)
    means = [block.mean for block in atlas.blocks]
    samples = []
    for _ in range(4000):
        base, step = origin, []
        for submap, mean in zip(maps, means, strict=True):
            last, points = drawn(submap, motion, rng)
            points, base = from_frame(motion.pose(base), points), compose(base, last)
            step += [state.minus(base, mean[: state.size]), points.ravel() - mean[state.size :]]
        samples.append(np.concatenate(step))
    white = np.linalg.solve(np.linalg.cholesky(atlas.belief.matrix), np.array(samples).T)
    size = len(white)
    print(f"covariance of {size} whitened numbers: {np.abs(white @ white.T / 4000 - np.eye(size)).max():.3f} off")
    assert np.abs(white @ white.T / 4000 - np.eye(size)).max() < 5 * np.sqrt(2 / 4000)
    assert np.abs(white.mean(1)).max() < 5 / np.sqrt(4000)


@in_space_and_in_the_plane
def test_where_all_is_linear_tied_maps_are_one_map(motion):
    """Attitudes known without doubt: the same Gaussian, whether it was computed in one map or in four."""
    all_of_it = Options(points="eucPnt", max_new_first=1000, max_new=1000, updates=1000, gate=1.0, min_searches=10**6)
    there = SensorSetup(type="relativePosition", std=(0.05, 0.07, 0.03))
    preset = cloister(12, there, all_of_it, noise=(0.02, 0.0), motion=motion)
    one, many = preset.slam(), SubmapSlam(preset.rig, preset.options, max_landmarks=1000)
    for frame, _ in preset.simulate(np.random.default_rng(0)):
        one.step(frame)
        many.step(frame)
        if frame.number % 4 == 0:
            many.close()
    assert [len(ids) for ids in many.atlas.ids] == [72] * 3
    assert many.atlas.merge_duplicates() == 2 * 72
    robot = robot_view(one.belief, one.robots[0])
    np.testing.assert_allclose(many.atlas.pose, robot.pose, atol=1e-9)
    np.testing.assert_allclose(many.atlas.covariance(), robot.pose_covariance, atol=1e-9)
    known = {lm.id: lm.block.mean for lm in one.landmarks}
    for row, number in enumerate(many.atlas.ids[0].tolist()):
        np.testing.assert_allclose(many.atlas.points(0)[row], known[number], atol=1e-9)


@in_space_and_in_the_plane
def test_tied_maps_are_consistent(motion):
    """20 runs of a round: the error of the last pose against its covariance; 6 dof or 3, the 99.9 % band of a step."""
    preset, found, off, free = cloister(215, motion=motion), [], [], motion.free
    (dof,) = preset.rig.dof
    for seed in range(20):
        many = SubmapSlam(preset.rig, preset.options, max_landmarks=30)
        for frame, truth in preset.simulate(np.random.default_rng(seed)):
            many.step(frame)
            last = truth.poses[0]
        many.close()
        many.atlas.merge_duplicates()
        e = Pose.minus(last, many.atlas.pose)
        found.append([float(nees(free.T @ e, free.T @ many.atlas.covariance() @ free))])
        off.append(e[:3])
    print(f"NEES, {dof} dof, 20 runs, 95 % band {band(dof, 20)}: five maps, tied {np.mean(found):.2f}")
    assert Consistency.of(np.array(found), dof, probability=0.999).inside == 1
    print(f"position {rmse(np.array(off)):.3f} m off")
    assert rmse(np.array(off)) < 0.08  # [m]; tied as they begin, without updates, 0.2, and dead reckoning alone 0.7


@in_space_and_in_the_plane
def test_the_later_of_two_tied_points_is_forgotten(motion):
    rng = np.random.default_rng(5)
    atlas = Atlas(motion)
    for ids in ([1, 2, 3], [2, 4], [3, 2]):
        atlas.join(some_map(rng, ids, motion))
    assert atlas.shared() == [(0, 1, 1, 0), (0, 2, 2, 0), (0, 1, 2, 1)]
    assert atlas.merge_duplicates() == 3
    assert [ids.tolist() for ids in atlas.ids] == [[1, 2, 3], [4], []]
    assert atlas.belief.size == 3 * motion.manifold.dof + 4 * 3
    assert np.linalg.eigvalsh(atlas.belief.matrix)[0] > 0
    assert atlas.merge_duplicates() == 0


@in_space_and_in_the_plane
def test_a_full_map_is_closed_and_the_next_one_starts_where_the_robot_is(motion):
    preset = cloister(60, motion=motion)
    many = SubmapSlam(preset.rig, preset.options, max_landmarks=12)
    sizes = []
    for frame, _ in preset.simulate(np.random.default_rng(1)):
        many.step(frame)
        sizes.append(len(many.slam.landmarks))
    assert max(sizes) < 12
    assert len(many.atlas.blocks) >= 3
    assert all(len(ids) >= 12 for ids in many.atlas.ids)
    before = many.pose
    many.close()
    np.testing.assert_allclose(many.pose, before, atol=1e-12)
    assert not many.slam.belief.covariance(many.slam.robots[0].block).any()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda rig: replace(rig, robots=(rig.robots[0], replace(rig.robots[0], name="other"))), "one robot"),
        (lambda rig: replace(rig, robots=(replace(rig.robots[0], motion="constVel"),)), "its pose"),
        (lambda rig: replace(rig, sensors=(replace(rig.sensors[0], estimated=True),)), "extrinsics"),
    ],
)
def test_rigs_whose_maps_would_not_be_independent_are_refused(change, says):
    with pytest.raises(SlamlibError, match=says):
        SubmapSlam(change(cloister(2).rig))


def test_a_map_without_landmarks_is_refused():
    with pytest.raises(SlamlibError, match="1 or more"):
        SubmapSlam(cloister(2).rig, max_landmarks=0)
