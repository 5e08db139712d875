"""ATE and RPE as evo (Grupp, github.com/MichaelGrupp/evo) has them, on drawn paths; `python -m book.tools.oracles`.

evo's PoseRelation.translation_part and rotation_angle_deg are our position and orientation errors.
"""

import copy

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align, align_trajectory
from slamlib.evaluation.comparison import _motion_errors, compared, parts, statistics
from slamlib.evaluation.trajectory import Trajectory, associate
from slamlib.geometry.pose import compose
from slamlib.geometry.quaternion import exponential

REASON = "evo is fetched by `python -m book.tools.oracles`, which runs these tests"
evo = pytest.importorskip("evo", reason=REASON)
metrics = pytest.importorskip("evo.core.metrics", reason=REASON)
sync = pytest.importorskip("evo.core.sync", reason=REASON)
geometry = pytest.importorskip("evo.core.geometry", reason=REASON)
lie = pytest.importorskip("evo.core.lie_algebra", reason=REASON)
paths = pytest.importorskip("evo.core.trajectory", reason=REASON)

POSITION, ORIENTATION = metrics.PoseRelation.translation_part, metrics.PoseRelation.rotation_angle_deg
SEEDS = range(12)
CLOSE = {"rtol": 1e-9, "atol": 1e-11}


def drawn(seed):
    """A reference, and an estimate of it: other rate, jitter, gaps, noise, and any similarity between them."""
    rng = np.random.default_rng(seed)
    count, interval = int(rng.integers(80, 200)), rng.uniform(0.02, 0.1)
    poses = [np.array([0.0, 0, 0, 1, 0, 0, 0])]
    for _ in range(count - 1):
        step = np.concatenate([rng.normal([interval, 0, 0], 0.3 * interval), exponential(rng.normal(0, 0.1, 3))])
        poses.append(compose(poses[-1], step))
    reference = Trajectory(rng.uniform(0, 1e5) + interval * np.arange(count), np.array(poses))
    every = int(rng.integers(1, 4))
    left = np.ones(count, dtype=bool)
    left[(start := rng.integers(10, 50)) : start + 15] = False  # a time without poses
    rows = np.flatnonzero(left)[::every]
    noise = np.concatenate([rng.normal(0, 0.02, (len(rows), 3)), exponential(rng.normal(0, 0.02, (len(rows), 3)))], 1)
    times = reference.times[rows] + rng.uniform(-0.2, 0.2, len(rows)) * min(interval, 0.05)
    there = np.concatenate([rng.normal(0, 20, 3), exponential(rng.normal(0, 2, 3))])
    moved = compose(there, compose(reference.poses[rows], noise))
    moved[:, :3] *= rng.uniform(0.2, 5)
    return reference, Trajectory(times, moved)


def theirs(path):
    """The same path, in evo."""
    return paths.PoseTrajectory3D(path.positions.copy(), path.poses[:, 3:].copy(), path.times.copy())


def six(errors):
    """evo's statistics, by our names."""
    return {name: value for name, value in errors.get_all_statistics().items() if name != "sse"}


def agree(ours, of_evo):
    assert ours.keys() == of_evo.keys()
    for name, value in ours.items():
        np.testing.assert_allclose(value, of_evo[name], **CLOSE, err_msg=name)


@pytest.mark.parametrize("seed", SEEDS)
def test_pairs_by_time(seed):
    reference, estimate = drawn(seed)
    i, j = associate(estimate, reference, 0.02)
    two = sync.associate_trajectories(theirs(reference), theirs(estimate), max_diff=0.02)
    assert len(i) == two[0].num_poses > 15
    np.testing.assert_array_equal(reference.times[j], two[0].timestamps)
    np.testing.assert_array_equal(estimate.times[i], two[1].timestamps)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("scale", [False, True], ids=["rigid", "similarity"])
def test_the_comparison_as_a_whole(seed, scale):
    """ATE with its statistics, position and orientation, and RPE from each pose to the next."""
    reference, estimate = drawn(seed)
    found, _ = compared(estimate, reference, metric=not scale)
    assert found["rotation_from"] == "positions"
    one, other = sync.associate_trajectories(theirs(reference), theirs(estimate), max_diff=0.02)
    turn, shift, factor = other.align(one, correct_scale=scale)
    assert found["poses"] == one.num_poses
    np.testing.assert_allclose([found["scale"], found["path_length"]], [factor, one.path_length], **CLOSE)
    for name, relation in (("position", POSITION), ("orientation", ORIENTATION)):
        absolute, relative = metrics.APE(relation), metrics.RPE(relation, 1, metrics.Unit.frames, all_pairs=True)
        for metric in (absolute, relative):
            metric.process_data((one, other))
        agree(found[name], six(absolute))
        agree(found["rpe"][name], six(relative))
    np.testing.assert_allclose(found["ate"], found["position"]["rmse"], **CLOSE)
    i, j = associate(estimate, reference, 0.02)
    own = align_trajectory(estimate[i], reference[j], scale=scale).similarity
    np.testing.assert_allclose(own.rotation, turn, atol=1e-11)
    np.testing.assert_allclose(own.translation, shift, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("delta", "unit"), [(1, "frames"), (3, "frames"), (10, "frames"), (0.5, "meters")])
@pytest.mark.parametrize("every", [False, True], ids=["one after another", "all pairs"])
def test_relative_errors_without_an_alignment(seed, delta, unit, every):
    """The errors of each pair of poses that evo picks: it picks by frames, or by metres along the estimate."""
    reference, estimate = drawn(seed)
    i, j = associate(estimate, reference, 0.02)
    estimate, reference = estimate[i], reference[j]
    two = theirs(reference), theirs(estimate)
    kind = metrics.Unit[unit]
    pairs = np.array(metrics.id_pairs_from_delta(two[1].poses_se3, delta, kind, 0.1, all_pairs=every))
    assert len(pairs) > 1
    for ours, relation in zip(_motion_errors(estimate, reference, *pairs.T), (POSITION, ORIENTATION), strict=True):
        errors = metrics.RPE(relation, delta, kind, 0.1, all_pairs=every)
        errors.process_data(copy.deepcopy(two))
        np.testing.assert_allclose(ours, errors.error, **CLOSE)
        agree(statistics(ours), six(errors))


@pytest.mark.parametrize("seed", SEEDS)
def test_kitti_s_measure_from_evo_s_error_of_one_pair(seed):
    reference, estimate = drawn(seed)
    i, j = associate(estimate, reference, 0.02)
    estimate, reference = estimate[i], reference[j]
    one, other = theirs(reference), theirs(estimate)
    length = 0.3 * one.path_length
    found = parts(estimate, reference, (length,), step=2)
    off, turned = [], []
    for start in range(0, one.num_poses, 2):
        ends = [k for k in range(start, one.num_poses) if one.distances[k] > one.distances[start] + length]
        if ends:
            k = ends[0]
            error = metrics.RPE.rpe_base(
                one.poses_se3[start], one.poses_se3[k], other.poses_se3[start], other.poses_se3[k]
            )
            off.append(np.linalg.norm(error[:3, 3]) / length)
            turned.append(np.degrees(lie.so3_log_angle(error[:3, :3])) / length)
    assert found["counts"] == [len(off)]
    np.testing.assert_allclose(found["translation_mean"], np.mean(off), **CLOSE)
    np.testing.assert_allclose(found["rotation_mean"], np.mean(turned), **CLOSE)


def shaped(positions):
    positions = np.asarray(positions, dtype=float)
    turns = np.tile([1.0, 0, 0, 0], (len(positions), 1))
    return Trajectory(np.arange(len(positions)), np.concatenate([positions, turns], axis=1))


LINE = np.outer(np.arange(9.0), [1.0, 0, 0])
BENT = np.random.default_rng(5).normal(size=(9, 3))


@pytest.mark.parametrize(("points", "reference"), [(LINE, LINE), (BENT, LINE), (0 * LINE, BENT), (BENT[:2], BENT[1:3])],
    ids=["a line", "onto a line", "in one place", "two points"])  # fmt: skip
@pytest.mark.parametrize("scale", [False, True], ids=["rigid", "similarity"])
def test_what_determines_no_rotation_is_refused_by_both(points, reference, scale):
    with pytest.raises(SlamlibError, match="lie on one line"):
        align(points, reference, scale=scale)
    with pytest.raises(geometry.GeometryException, match="Degenerate"):
        theirs(shaped(points)).align(theirs(shaped(reference)), correct_scale=scale)


def test_a_plane_and_a_mirrored_path_are_rotated_not_reflected():
    for points in (BENT * [1, 1, 0], BENT * [1, 1, -1]):
        ours = align(points, BENT, scale=True)
        turn, shift, factor = geometry.umeyama_alignment(points.T, BENT.T, with_scale=True)
        np.testing.assert_allclose(ours.rotation, turn, atol=1e-11)
        np.testing.assert_allclose(ours.translation, shift, atol=1e-11)
        np.testing.assert_allclose(ours.scale, factor, **CLOSE)
        assert np.linalg.det(ours.rotation) > 0


def test_paths_of_other_times_or_counts_are_refused_by_both():
    one, other = shaped(BENT), shaped(BENT)
    later = Trajectory(other.times + 100, other.poses)
    with pytest.raises(SlamlibError, match="no two times"):
        associate(one, later)
    with pytest.raises(evo.EvoException):
        sync.associate_trajectories(theirs(one), theirs(later), max_diff=0.02)
    with pytest.raises(SlamlibError, match="9 poses against 8"):
        align_trajectory(one, other[:-1])
    with pytest.raises(evo.EvoException):
        metrics.APE(POSITION).process_data((theirs(other[:-1]), theirs(one)))
