"""Trajectories: files, pairs by time, alignment in closed form, errors; and what a straight path leaves open."""

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import Similarity, align, align_trajectory, straightness
from slamlib.evaluation.comparison import parts
from slamlib.evaluation.trajectory import Trajectory, associate, read_trajectory, write_tum
from slamlib.geometry.pose import compose, relative
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.tests.pictures import DATA

STORED = (
    0.10119560862569917,
    0.03304008342344318,
    2.1918313445196143,
)  # of evo: scale, root mean square of the distances [m], largest angle [deg]


def walk(rng, count=60):
    """A path that turns in all directions."""
    times = np.cumsum(rng.uniform(0.03, 0.08, count))
    poses = [np.array([0.0, 0, 0, 1, 0, 0, 0])]
    for _ in range(count - 1):
        step = np.concatenate([rng.normal([0.1, 0, 0], 0.03), exponential(rng.normal(0, 0.1, 3))])
        poses.append(compose(poses[-1], step))
    return Trajectory(times, np.array(poses))


def anyhow(rng):
    """A random similarity."""
    return Similarity(rng.uniform(0.1, 10), rotation(exponential(rng.normal(0, 2, 3))), rng.normal(0, 5, 3))


def test_tum_files_are_read_as_they_were_written(tmp_path):
    path, there = tmp_path / "out.txt", walk(np.random.default_rng(1))
    write_tum(path, there)
    found = read_trajectory(path)
    np.testing.assert_allclose(found.times, there.times, atol=1e-9)
    np.testing.assert_allclose(found.poses, there.poses, atol=1e-10)
    words = path.read_text().splitlines()[5].split()  # time x y z qx qy qz qw
    np.testing.assert_allclose([float(w) for w in words[4:]], there.poses[4][[4, 5, 6, 3]], atol=1e-10)
    assert [f.name for f in tmp_path.iterdir()] == ["out.txt"]


def test_kitti_and_euroc_files(tmp_path):
    there = walk(np.random.default_rng(2))
    turns = rotation(there.poses[:, 3:])
    np.savetxt(tmp_path / "kitti", np.concatenate([turns, there.positions[..., None]], axis=2).reshape(-1, 12))
    found = read_trajectory(tmp_path / "kitti", there.times)
    np.testing.assert_allclose(found.positions, there.positions)
    np.testing.assert_allclose(rotation(found.poses[:, 3:]), turns, atol=1e-12)
    with pytest.raises(SlamlibError, match="no times"):
        read_trajectory(tmp_path / "kitti")
    rows = np.concatenate([there.times[:, None] * 1e9, there.poses, np.zeros((60, 9))], axis=1)
    np.savetxt(tmp_path / "euroc.csv", rows, delimiter=",", header="timestamp, p_RS_R_x [m], ...")
    np.testing.assert_allclose(read_trajectory(tmp_path / "euroc.csv").poses, there.poses, atol=1e-12)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no trajectory"),
        ("1 2 3\n", "rows of 8"),
        ("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0\n", "as many in each"),
        ("0 0 0 0 0 0 0 one\n", "not numbers"),
        ("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", "times must grow"),
        ("1 0 0 0 0 0 0 0\n", "length one"),
    ],
)
def test_what_is_no_trajectory_is_refused(tmp_path, text, message):
    (tmp_path / "file").write_text(text)
    with pytest.raises(SlamlibError, match=message):
        read_trajectory(tmp_path / "file")
    with pytest.raises(SlamlibError, match="cannot be read"):
        read_trajectory(tmp_path / "absent")


def test_pairs_are_nearest_in_time_and_used_once():
    one = Trajectory([0.0, 0.1, 0.2, 0.9], np.tile([0.0, 0, 0, 1, 0, 0, 0], (4, 1)))
    other = Trajectory([-0.05, 0.11, 0.115, 0.205], one.poses)
    i, j = associate(one, other)
    assert (i.tolist(), j.tolist()) == ([1, 2], [1, 3])
    i, j = associate(other, one)  # two of them want the pose at 0.1 s: the nearer one gets it
    assert (i.tolist(), j.tolist()) == ([1, 3], [1, 2])
    with pytest.raises(SlamlibError, match="no two times"):
        associate(one, Trajectory([5.0], one.poses[:1]))
    i, j = associate(one[np.array([0])], other[np.array([0])], tolerance=0.05)
    assert (i.tolist(), j.tolist()) == ([0], [0])


@pytest.mark.parametrize("seed", range(20))
def test_a_similarity_is_recovered_exactly(seed):
    rng = np.random.default_rng(seed)
    there, true = walk(rng), anyhow(rng)
    found = align(there.positions, true(there.positions))
    assert found.scale == pytest.approx(true.scale, rel=1e-10)
    np.testing.assert_allclose(found.rotation, true.rotation, atol=1e-9)
    np.testing.assert_allclose(found.translation, true.translation, atol=1e-8)
    whole = align_trajectory(there, true.moved(there))
    assert whole.rotation_from == "positions"
    assert whole.ate < 1e-8
    assert whole.orientation.max() < 1e-7


@pytest.mark.parametrize("scale", [True, False])
def test_no_other_motion_fits_better(scale):
    rng = np.random.default_rng(5)
    x = rng.normal(size=(30, 3))
    y = anyhow(rng)(x) + rng.normal(0, 0.3, x.shape)
    best = align(x, y, scale=scale)
    least = ((best(x) - y) ** 2).sum()
    assert scale or best.scale == 1
    for _ in range(200):
        turn = best.rotation @ rotation(exponential(rng.normal(0, 0.05, 3)))
        size = best.scale * (1 + scale * rng.normal(0, 0.05))
        other = Similarity(size, turn, best.translation + rng.normal(0, 0.05, 3))
        assert ((other(x) - y) ** 2).sum() > least


def test_a_reflection_is_never_the_answer():
    x = np.random.default_rng(6).normal(size=(20, 3))
    found = align(x, x * [1, 1, -1])
    assert np.linalg.det(found.rotation) == pytest.approx(1)
    flat = x * [1, 1, 0]  # of a flat path either side would do: the rotation is found
    np.testing.assert_allclose(align(flat, flat).rotation, np.eye(3), atol=1e-12)


def test_of_a_straight_path_the_attitudes_say_the_turn():
    rng = np.random.default_rng(7)
    bent, true = walk(rng), anyhow(rng)
    poses = np.concatenate([np.outer(np.linspace(0, 4, 60), [1, 2, 2]) / 3, bent.poses[:, 3:]], axis=1)
    line = Trajectory(bent.times, poses)
    with pytest.raises(SlamlibError, match="one line"):
        align(line.positions, true(line.positions))
    found = align_trajectory(line, true.moved(line))
    assert found.rotation_from == "orientations"
    assert found.straightness < 1e-10
    np.testing.assert_allclose(found.similarity.rotation, true.rotation, atol=1e-9)
    assert found.similarity.scale == pytest.approx(true.scale)
    assert found.ate < 1e-8
    still = Trajectory(line.times, line.poses * [0, 0, 0, 1, 1, 1, 1])
    with pytest.raises(SlamlibError, match="does not move"):
        align_trajectory(still, line)
    assert align_trajectory(still, line, scale=False).similarity.scale == 1


def test_a_path_that_goes_the_wrong_way_fits_at_no_scale():
    there = walk(np.random.default_rng(12))
    back = Trajectory(there.times, there.poses * [-1, -1, -1, 1, 1, 1, 1])
    found = align_trajectory(back, there, rotation_from="orientations")
    assert found.similarity.scale == 0
    assert found.ate == pytest.approx(np.sqrt(there.positions.var(0).sum()))


def test_misuse_of_alignment_is_named():
    there = walk(np.random.default_rng(8))
    with pytest.raises(SlamlibError, match="associate"):
        align_trajectory(there, there[np.arange(5)])
    with pytest.raises(SlamlibError, match="positions, orientations"):
        align_trajectory(there, there, rotation_from="looks")
    with pytest.raises(SlamlibError, match=r"align: reference should have shape"):
        align(np.zeros((4, 3)), np.zeros((5, 3)))


def test_errors_over_parts_of_the_path():
    there = walk(np.random.default_rng(9), 400)
    long = Trajectory(there.times, there.poses * [1.02, 1.02, 1.02, 1, 1, 1, 1])
    found = parts(long, there, (2.0, 5.0, 1000.0))
    np.testing.assert_array_less(found["translation"][:2], 0.02 + 1e-12)  # of a bent part the chord is 2 % too long
    assert found["counts"][2] == 0
    assert np.isnan(found["translation"][2])
    np.testing.assert_allclose(found["rotation"][:2], 0, atol=1e-9)
    # a constant error of the heading, 0.01 rad a step, over steps of one metre
    x = np.arange(300.0)
    straight = np.stack([x, 0 * x, 0 * x, 1 + 0 * x, 0 * x, 0 * x, 0 * x], axis=1)
    turned = np.concatenate([straight[:, :3], exponential(np.stack([0 * x, 0 * x, 0.01 * x], axis=1))], axis=1)
    found = parts(Trajectory(x, turned), Trajectory(x, straight), (99.5,), step=10)
    assert found["rotation"][0] == pytest.approx(np.degrees(1.0 / 99.5))
    assert found["counts"][0] == 20
    with pytest.raises(SlamlibError, match="give shorter lengths"):
        parts(there, there, (500.0,))


def test_nothing_depends_on_where_the_world_is():
    rng = np.random.default_rng(10)
    there = walk(rng)
    moved = Similarity(1.0, anyhow(rng).rotation, rng.normal(size=3)).moved(there)
    np.testing.assert_allclose(
        relative(moved.poses[0], moved.poses)[:, :3], relative(there.poses[0], there.poses)[:, :3], atol=1e-12
    )
    found = parts(there, moved, (1.0,), step=1)
    assert found["translation"][0] < 1e-12


def test_the_two_references_of_a_real_sequence_agree():
    files = [DATA / "mono_visp_cube" / f"reference_{name}.txt" for name in ("dotpnp", "colmap")]
    if not all(f.is_file() for f in files):
        pytest.skip("the excerpt mono_visp_cube is not at hand")
    pnp, colmap = (Trajectory(rows[:, 0], rows[:, 1:]) for rows in map(np.loadtxt, files))
    assert straightness(pnp.positions) < 0.05
    found = align_trajectory(colmap, pnp)
    assert found.rotation_from == "orientations"
    assert found.relative_ate < 0.04  # the two were found to agree to 2 % of the path
    assert np.degrees(np.median(found.orientation)) < 1.2


def test_what_evo_finds():
    """The same two paths in evo 1.38 (pip install evo), whose figures stand here for whoever has none."""
    rng = np.random.default_rng(21)
    there = walk(rng, 200)
    noise = np.concatenate([rng.normal(0, 0.02, (200, 3)), exponential(rng.normal(0, 0.01, (200, 3)))], axis=1)
    estimate = anyhow(rng).moved(Trajectory(there.times, compose(there.poses, noise)))
    found = align_trajectory(estimate, there, rotation_from="positions")
    same = found.similarity.scale, found.ate, np.degrees(found.orientation.max())
    np.testing.assert_allclose(same, STORED, rtol=1e-9)
    geometry = pytest.importorskip("evo.core.geometry", reason="evo is not installed: its stored figures were compared")
    metrics, paths = pytest.importorskip("evo.core.metrics"), pytest.importorskip("evo.core.trajectory")
    turn, shift, scale = geometry.umeyama_alignment(estimate.positions.T, there.positions.T, with_scale=True)
    np.testing.assert_allclose(found.similarity.rotation, turn, atol=1e-10)
    np.testing.assert_allclose(found.similarity.translation, shift, atol=1e-9)
    two = [paths.PoseTrajectory3D(t.positions, t.poses[:, 3:], t.times) for t in (there, estimate)]
    two[1].align(two[0], correct_scale=True)
    kinds = (
        (metrics.PoseRelation.translation_part, metrics.StatisticsType.ate),
        (metrics.PoseRelation.rotation_angle_deg, metrics.StatisticsType.max),
    )
    of_evo = [scale]
    for relation, statistic in kinds:
        error = metrics.APE(relation)
        error.process_data(tuple(two))
        of_evo.append(error.get_statistic(statistic))
    np.testing.assert_allclose(same, of_evo, rtol=1e-9)
