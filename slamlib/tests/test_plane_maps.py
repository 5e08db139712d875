"""Maps of the plane: robots, points and sensors of two dimensions do what those of space do, by the same filter."""

from dataclasses import replace

import numpy as np
import pytest

import slamlib as sl
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band, share_inside
from slamlib.experiments.presets import Preset
from slamlib.experiments.runs import Run
from slamlib.geometry.pose import Pose
from slamlib.landmarks.plane_point import PLANE_POINT
from slamlib.rigs.setup import Rig
from slamlib.simulation import Faults
from slamlib.slam import Options, Slam

ROBOT = sl.robot("unicycle", noise=(0.02, 0.01), position=(0, -5, 0), control=(8.0, 90.0), position_std=(0.02, 0.02, 0))
SLOW = replace(ROBOT, control=(0.8, 9.0))  # a bearing's first updates are nearly linear only where little changes
LASER = sl.range_bearing(noise=(0.05, 0.02), position=(0.2, 0.1, 0.3), limits={"far": 6.0})
BEARINGS = sl.bearing_only(noise=0.01, position=(0.2, 0.1, 0.3))
RANGES = sl.range_only(noise=0.05, position=(-0.2, 0.1, 0.0))
# The true robot moves as the model says, with noise that the filter is told: what its consistency needs.
PRESET = Preset(
    "maps", Rig((ROBOT,), (LASER,)), Options(inverse_distance=(0.4, 0.2)), (("cloister", {}),), 40, noise_in="truth"
)
RIGS = {
    "range and bearing": (LASER,),
    "range only beside it": (LASER, RANGES),
    "bearing only": (replace(BEARINGS, name="left"), replace(BEARINGS, name="right", position=(0.2, -0.5, 0))),
}


def averages(preset, seeds, options=None):
    """NEES of the robot, averaged over runs, at each frame."""
    given = preset if options is None else replace(preset, options=options)
    runs = [Run(given, seed=seed).finish() for seed in seeds]
    assert runs[0].dof == (3,)
    return np.mean([run.nees[:, 0] for run in runs], axis=0)


@pytest.mark.parametrize("first", [0, 100], ids=["seeds 0-24", "seeds 100-124"])
@pytest.mark.parametrize("name", ["range and bearing", "range only beside it"])
def test_nees_of_the_robot_is_that_of_three_degrees_of_freedom(name, first):
    """25 runs of 40 frames, a lap, each frame's average with a band of 95 %."""
    nees = averages(replace(PRESET, rig=Rig((ROBOT,), RIGS[name])), range(first, first + 25))
    assert share_inside(nees, band(3, runs=25)) > 0.85
    assert 2.7 < nees.mean() < 3.3


@pytest.mark.parametrize("name", RIGS)
def test_points_of_the_floor_come_into_the_map_and_stay_where_they_are(name):
    preset = replace(PRESET, rig=Rig((SLOW,), RIGS[name]), frames=80)
    run = Run(preset)
    result = run.finish()
    assert {landmark.kind.plane for landmark in run.slam.landmarks} == {True}
    known = [landmark for landmark in run.slam.landmarks if landmark.kind is PLANE_POINT]
    assert len(known) > 15  # also those which were initialized by bearings, and converted
    true = dict(zip(preset.world.points.ids.tolist(), preset.world.points.values, strict=True))
    for landmark in known:
        error = landmark.block.mean - true[landmark.id][:2]
        P = run.slam.belief.covariance(landmark.block)
        assert error @ np.linalg.solve(P, error) < sl.chi2_quantile(0.99999, 2)
    assert np.abs(result.errors[-1, 0, [0, 1, 5]]).max() < 0.2
    assert not result.errors[:, 0, 2:5].any()


@pytest.mark.parametrize("changes", [
    {"reproject": False}, {"outlier_rejection": "joint"}, {"outlier_rejection": "one-point-ransac"},
    {"selection": "order", "updates": 4}, {"capacity": 12, "pruning": "least-recently-seen"}, {"window": 5},
    {"points": None}, {"convert": False}, {"points": "planeIdpPnt"},
], ids=str)  # fmt: skip
def test_every_option_works_in_the_plane(changes):
    run = Run(replace(PRESET, options=replace(PRESET.options, **changes)))
    result = run.finish()
    assert (len(run.slam.landmarks) > 5) == (changes.get("points", "") is not None)
    assert np.linalg.norm(result.errors[-1, 0, :2]) < (0.3 if run.slam.landmarks else 3)


def test_outliers_are_rejected():
    for rejection in ("individual", "joint", "one-point-ransac"):
        options = replace(PRESET.options, outlier_rejection=rejection)
        run, rejected = Run(replace(PRESET, faults=Faults(outlier=0.2), options=options)), 0
        for _ in run:
            rejected += sum(p.measured is not None and not p.inlier for p in run.slam.predictions[0])
        assert rejected > 20
        assert np.linalg.norm(run.result().errors[:, 0, :2], axis=1).max() < 0.15


def test_a_mount_in_the_plane_is_estimated():
    """Where it sits ahead of the wheels, and how it is turned: height, roll and pitch are given, and stay."""
    mounted = replace(LASER, estimated=True, position_std=(0.05, 0.05, 0), orientation_std=(0, 0, 3.0))
    run = Run(replace(PRESET, rig=Rig((ROBOT,), (mounted,)), frames=80))
    *_, last = run
    (sensor,) = run.slam.sensors
    before, after = (np.sqrt(P.diagonal()) for P in (mounted.covariance, run.slam.belief.covariance(sensor.block)))
    assert (after[[1, 5]] < 0.3 * before[[1, 5]]).all()  # how far ahead shows only beside the angle, on an arc
    assert after[[2, 3, 4]] == pytest.approx(0, abs=1e-9)
    error = Pose.minus(sensor.extrinsics, last.truth.extrinsics[0])[[0, 1, 5]]
    assert (np.abs(error) < 4 * after[[0, 1, 5]]).all()


def test_two_robots_share_a_map_of_the_plane():
    other = replace(ROBOT, name="other", position=(0, 5, 0), euler=(0, 0, 180))
    two = replace(PRESET, rig=Rig((ROBOT, other), (LASER, replace(LASER, name="second", robot=1))))
    nees = np.mean([Run(two, seed=seed).finish().nees for seed in range(10)], axis=0)
    assert nees.shape == (40, 2)
    for of_one in nees.T:
        assert share_inside(of_one, band(3, runs=10)) > 0.8
    alone = Run(PRESET).finish()
    assert Run(two).finish().sigmas[-1, 0, 0] < alone.sigmas[-1, 0, 0]  # each profits from what the other has seen


def test_a_filter_is_saved_and_goes_on(tmp_path):
    slam, frames = PRESET.slam(), [frame for frame, _ in PRESET.simulate()]
    for i, frame in enumerate(frames):
        slam.step(frame)
        if i == 19:
            slam.save(tmp_path / "half.npz")
    again = Slam.load(tmp_path / "half.npz")
    for frame in frames[20:]:
        again.step(frame)
    assert np.array_equal(again.belief.matrix, slam.belief.matrix)
    assert [landmark.kind for landmark in again.landmarks] == [landmark.kind for landmark in slam.landmarks]


def test_what_can_make_no_landmark_is_said():
    for wrong, words in (
        (replace(LASER, landmark="idpPnt"), "measures no height, and idpPnt is a point in space"),
        (sl.camera([320, 240, 400, 400], landmark="planePnt"), "measures in space, and planePnt lies on the floor"),
    ):
        with pytest.raises(SlamlibError, match=words):
            sl.Slam(ROBOT, wrong)
    with pytest.raises(SlamlibError, match="planePnt lies on the floor"):
        sl.Slam(ROBOT, sl.camera([320, 240, 400, 400]), options=Options(points="planePnt"))


def test_a_camera_in_the_air_sees_points_of_the_floor_that_a_robot_in_the_plane_has_found():
    """One map: the camera initializes points in space, and measures those of the floor by their numbers."""
    flying = sl.robot(
        "odometry", noise=(0.002,) * 3 + (0.001,) * 3, name="flying", position=(0, 0, 6.0), euler=(0, 0, 0)
    )
    below = sl.camera([320, 240, 320, 320], position=(0, 0, 0), euler=(180, 0, -90), robot=1)
    both = replace(PRESET, rig=Rig((ROBOT, flying), (LASER, below)), frames=20)
    run = Run(both)
    result = run.finish()
    kinds = {landmark.kind.plane for landmark in run.slam.landmarks}
    assert kinds == {True, False}
    seen_by_both = [p for p in run.slam.project(1) if p.landmark.kind.plane]
    assert len(seen_by_both) > 5
    assert result.dof == (3, 6)
    assert result.nees[-1, 1] < sl.chi2_quantile(0.9999, 6)
    without = Run(replace(both, rig=Rig((ROBOT,), (LASER,))))
    without.finish()
    camera_too, laser_alone = (
        {lm.id: np.sqrt(np.trace(r.slam.belief.covariance(lm.block))) for lm in r.slam.landmarks if lm.kind.plane}
        for r in (run, without)
    )
    better = [camera_too[i] < 0.8 * laser_alone[i] for i in camera_too.keys() & laser_alone.keys()]
    assert np.mean(better) > 0.5
