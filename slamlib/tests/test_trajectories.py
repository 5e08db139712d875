"""Trajectories: files, pairs by time, alignment in closed form, errors; and what a straight path leaves open."""

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import Similarity, align, align_trajectory, straightness
from slamlib.evaluation.clocks import in_one_unit, time_offset
from slamlib.evaluation.comparison import ComparisonOptions, compared, parts
from slamlib.evaluation.motion_pairs import motion_pairs
from slamlib.evaluation.trajectory import Trajectory, associate, beside, read_trajectory, write_tum
from slamlib.evaluation.trajectory_files import read_times
from slamlib.geometry.pose import compose, relative
from slamlib.geometry.quaternion import exponential, product, rotation
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
    rows = np.concatenate([np.round(there.times[:, None] * 1e9), there.poses, np.zeros((60, 9))], axis=1)
    for separator in ", ":
        np.savetxt(tmp_path / "euroc.csv", rows, delimiter=separator, header="timestamp, p_RS_R_x [m], ...")
        found = read_trajectory(tmp_path / "euroc.csv")
        np.testing.assert_allclose(found.poses, there.poses, atol=1e-12)
        np.testing.assert_allclose(found.times, there.times, atol=1e-9)


# Two poses, a quarter turn about z apart; the same numbers in every order, named or of a format.
X, Z = (1.0, 2.0, 3.0), 0.5**0.5
TURNED = [*X, Z, 0, 0, Z]
NS = "1403636579763555584 {0}\n1403636579813555456 {0}\n"


def read(folder, text, encoding="utf-8", **options):
    """What is read of a text."""
    (folder / "file").write_bytes(text.encode(encoding))
    return read_trajectory(folder / "file", **options)


@pytest.mark.parametrize(
    "text",
    [
        f"0 0 0 0 0 0 0 1\n0.05 1 2 3 0 0 {Z} {Z}\n",
        f"0,0,0,0,0,0,0,1\n0.05,1,2,3,0,0,{Z},{Z}\n",  # TUM's order, with commas
        f"0;0;0;0;0;0;0;1\n0.05;1;2;3;0;0;{Z};{Z}\n",
        f"0,0,0,0,1,0,0,0\n50000000,1,2,3,{Z},0,0,{Z}\n",  # EuRoC's
        f"0,0,0,0,1,0,0,0,7,7,7,\n50000000,1,2,3,{Z},0,0,{Z},7,7,7,\n",  # VINS-Fusion's
        f"#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_x [], q_RS_y [], q_RS_z [], q_RS_w []\n"
        f"0,0,0,0,0,0,0,1\n50000000,1,2,3,0,0,{Z},{Z}\n",
        f"time,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n0.05,1,2,3,{Z},0,0,{Z}\n",
        f"# a tracker's file, time_ms, tx, ty, tz, qx, qy, qz, qw\n0,0,0,0,0,0,0,1\n50,1,2,3,0,0,{Z},{Z}\n",
        f"%time,field.header.seq,field.header.frame_id,field.pose.position.x,field.pose.position.y,field.pose.position.z,"
        f"field.pose.orientation.x,field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n"
        f"0,1,map,0,0,0,0,0,0,1\n50000000,2,map,1,2,3,0,0,{Z},{Z}\n",
        f"time,pos_x,pos_y,pos_z,qx,qy,qz,qw,pos_std_x,vx,v_t_y\n0,0,0,0,0,0,0,1,5,5,5\n0.05,1,2,3,0,0,{Z},{Z},5,5,5\n",
        f"# id timestamp tx ty tz qx qy qz qw\n0 0 0 0 0 0 0 0 1\n1 0.05 1 2 3 0 0 {Z} {Z}\n",
        f"#time, p_G_Ix [m], p_G_Iy [m], p_G_Iz [m], q_G_Iw, q_G_Ix, q_G_Iy, q_G_Iz, v_G_Ix [m s^-1]\n"
        f"0,0,0,0,1,0,0,0,9\n0.05,1,2,3,{Z},0,0,{Z},9\n",
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_columns_are_those_that_a_file_states(tmp_path, text, encoding):
    found = read(tmp_path, text, encoding)
    np.testing.assert_allclose(found.poses[1], TURNED, atol=1e-9)
    np.testing.assert_allclose(found.times, [0, 0.05])


def test_a_file_that_states_no_order_is_asked_for_its_format(tmp_path):
    for text in (NS.format("1 2 3 0 0 0 1"), NS.replace(" {0}", ".0,{0}").format("1,2,3,0,0,0,1")):
        with pytest.raises(
            SlamlibError, match="may be w x y z, as EuRoC's are, or x y z w, as TUM's: state its format"
        ):
            read(tmp_path, text)
    found = [read(tmp_path, NS.format(f"1 2 3 {Z} 0 0 {Z}"), form=form) for form in ("euroc", "tum")]
    np.testing.assert_allclose(found[0].poses[0], TURNED)
    np.testing.assert_allclose(found[1].poses[0], [*X, Z, Z, 0, 0])
    np.testing.assert_allclose([f.times[0] for f in found], 1403636579.763555584)
    assert "its times are nanoseconds" in found[1].notes[0]
    found = read(tmp_path, NS.replace(" {0}", ".000000 {0}").format(f"1 2 3 0 0 {Z} {Z}"))  # as ORB-SLAM3 writes
    np.testing.assert_allclose(found.poses[0], TURNED)
    with pytest.raises(SlamlibError, match="unknown format 'rosbag'"):
        read(tmp_path, NS, form="rosbag")
    with pytest.raises(SlamlibError, match="rows of 8 numbers, and kitti has 12"):
        read(tmp_path, NS.format("1 2 3 0 0 0 1"), form="kitti")


@pytest.mark.parametrize(
    ("header", "message"),
    [
        (
            "time,x,y,z,q0,q1,q2,q3",
            "no name for qw, qx, qy, qz; not known: q0, q1, q2, q3: correct its names, or state",
        ),
        ("#time, east, north, up, qx, qy, qz, qw", "no name for x, y, z; not known: east, north, up"),
        ("# t x y z roll pitch yaw id", "no name for qw, qx, qy, qz"),
        ("t,x,y,z,qx,qy,qz", "no name for qw"),
        ("# t x y z qx qy qz qw vx", "has 9 names, and its rows have 8 columns"),
        ("t [s],x [mm],y [mm],z [mm],qx,qy,qz,qw", r"not known: x\[mm\], y.* \(positions are wanted in metres\)"),
        ("t, px (cm), py (cm), pz (cm), qx, qy, qz, qw", "no name for x, y, z; .* in metres"),
        ("t,x_feet,y_feet,z_feet,qx,qy,qz,qw", "no name for x, y, z; .* in metres"),
        ("t,x,y,z,pos_x,qx,qy,qz,qw", "more than one name for the same: x, pos_x"),
    ],
)
def test_a_header_that_is_not_understood_is_refused_by_its_names(tmp_path, header, message):
    with pytest.raises(SlamlibError, match=message):
        read(tmp_path, f"{header}\n0,0,0,0,0,0,0,1\n")
    assert read(tmp_path, f"{header}\n0,0,0,0,0,0,0,1\n", form="tum").poses[0, 3] == 1  # what is stated counts


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no trajectory: there is no row"),
        ("1 2 3\n", "rows of 3 numbers, and TUM has 8"),
        ("0 0 0 0 0 0 0 1 5\n", "rows of 9 numbers, and TUM has 8"),
        ("# a\n0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0\n2 0 0 0 0 0 0 1\n", "line 3 has 7 columns, other rows 8"),
        ("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 one\n", "line 2, column 8: 'one' is no number"),
        ("0,0,0,0,0,0,0,1\n0.1,1_0,0,0,0,0,0,1\n", "line 2, column 2: '1_0' is no number"),
        ("0,0,0,0,0,0,0,1\n0.1,0,,0,0,0,0,1\n", "line 2, column 3: there is nothing between two separators"),
        ("0,0 0,1 0,2 0 0 0 0 1\n", "line 1: 0,0 has a decimal comma: write numbers with points, as 0.0"),
        ("0;0,5;0;0;0;0;0;1\n", "line 1: 0,5 has a decimal comma"),
        ("0 0 0 0 0 0 0 1\n1 0 inf 0 0 0 0 1\n", "line 2, column 3: inf is not finite"),
        ("0 0 0 0 0 0 0 1\n1 0 0 -1e200 0 0 0 1\n", "line 2, column 4: -1e200 is not finite, or too large"),
        ("0 0 0 0 0 0 0 1\nnan 0 0 0 0 0 0 1\n", "line 2: the time is nan"),
        ("0 nan 0 0 0 0 0 1\n", "nan is in each of its 1 rows"),
        ("1 0 0 0 0 0 0 1\n\n1 5 0 0 0 0 0 1\n", r"lines 1 and 3 have one time, 1\.000000000 s, and two poses"),
        ("0 0 0 0 0 0 0 1\n1 0 0 0 0.1 0 0 4\n", r"line 2: its quaternion \(qx, qy, qz, qw\) = \(0\.1, 0, 0, 4\)"),
        ("0.5 0 0 0 0 0 0 0\n", r"\(0, 0, 0, 0\) has length 0 instead of one"),
    ],
)
def test_what_is_damaged_is_refused_by_its_line(tmp_path, text, message):
    with pytest.raises(SlamlibError, match=message):
        read(tmp_path, text)
    with pytest.raises(SlamlibError, match="cannot be read"):
        read_trajectory(tmp_path / "absent")


def test_rows_without_a_pose_twice_or_out_of_order_are_mended_and_said(tmp_path):
    rows = ["0 0 0 0 0 0 0 1", "3 3 0 0 0 0 0 1", "1 1 0 0 0 0 0 1", "2 nan nan nan nan nan nan nan", "3 3 0 0 0 0 0 1"]
    found = read(tmp_path, "# head\n" + "\n".join(rows))
    assert found.times.tolist() == found.positions[:, 0].tolist() == [0, 1, 3]
    said = [note.partition("file: ")[2] for note in found.notes]
    assert said == [
        "1 of 5 rows have nan for a pose, first line 5: left out",
        "line 4 is earlier than the row before it: the rows are sorted by time",
        "1 rows are there twice, first line 6: used once",
    ]
    kitti = read(
        tmp_path, "1 0 0 0 0 1 0 0 0 0 1 0\n" + 12 * "nan " + "\n1 0 0 5 0 1 0 0 0 0 1 0", times=np.arange(3.0)
    )
    assert kitti.times.tolist() == [0, 2]


@pytest.mark.parametrize(
    ("row", "message"),
    [
        (
            "2 0 0 0 0 2 0 0 0 0 2 0",
            r"line 2: .* is no rotation: its determinant is 8 \(the scale is 2: divide by it\)",
        ),
        ("1 0 0 0 0 1 0 0 0 0 -1 0", "its determinant is -1; the sign is that of left-handed axes"),
        ("1 0 0 0 1 0 0 0 1 4 5 6", "its first nine numbers are one, by rows or by columns"),
        ("1 0.5 0 0 0 1 0 0 0 0 1 0", "its determinant is 1, and its rows are not at right angles"),
        ("0 0 0 0 0 0 0 0 0 0 0 0", "its determinant is 0"),
    ],
)
def test_a_matrix_that_is_no_rotation_is_described(tmp_path, row, message):
    with pytest.raises(SlamlibError, match=message):
        read(tmp_path, f"1 0 0 0 0 1 0 0 0 0 1 0\n{row}\n")


def test_seven_columns_are_tartanairs(tmp_path):
    text = f"0 0 0 0 0 0 1\n1 2 3 0 0 {Z} {Z}\n"
    np.testing.assert_allclose(read(tmp_path, text, times=np.array([0, 0.1])).poses[1], TURNED)
    said = "columns are taken for x, y, z, qx, qy, qz, qw, as TartanAir's are"
    assert said in read(tmp_path, text, times=np.array([0, 0.1])).notes[0]  # others write qw first
    assert read(tmp_path, f"x y z qx qy qz qw\n{text}", times=np.array([0, 0.1])).notes[0].endswith("names no time")
    with pytest.raises(SlamlibError, match=r"has 2 poses, but no times: give them \(option times\)"):
        read(tmp_path, text)
    with pytest.raises(SlamlibError, match="has 2 poses, but no times: 3 are given, and as many are wanted"):
        read(tmp_path, text, times=np.arange(3.0))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0,5\n1,7\n2,9\n", "line 1: is 0,5 one number with a decimal comma, or are there two columns"),
        ("# of the pictures\n0,5 1\n1,7 1\n", "line 2: 0,5 has a decimal comma: write numbers with points, as 0.5"),
        ("00000 1378904190.1 0.5\n00001 1378904190.2 0.5\n", "its first column counts rows: leave it out"),
        ("0\n2\n1\n", "line 3: times must grow"),
    ],
)
def test_times_stand_first_and_alone_or_their_file_is_refused(tmp_path, text, message):
    (tmp_path / "times.txt").write_text(text)
    with pytest.raises(SlamlibError, match=message):
        read_times(tmp_path / "times.txt")


@pytest.mark.parametrize(
    "text", ["0\n0.5\n2\n", "0,0.1\n0.5,0.1\n2,0.1\n", "time,exposure\n0,5\n0.5,5\n2,7\n", "0 5\n0.5 5\n2 7\n"]
)
def test_what_stands_beside_times_does_not_matter(tmp_path, text):
    (tmp_path / "times.txt").write_text(text)
    assert read_times(tmp_path / "times.txt")[0].tolist() == [0, 0.5, 2]


def test_covariances_go_by_the_whole_name_of_a_path():
    assert [beside(name).name for name in ("run/path_0.5", "path_0.9", "p.txt")] == [
        "path_0.5.cov", "path_0.9.cov", "p.txt.cov",
    ]  # fmt: skip


def test_a_path_without_covariances_leaves_none_of_an_older_one_beside_it(tmp_path):
    path = Trajectory([0.0, 0.1], np.tile([0.0, 0, 0, 1, 0, 0, 0], (2, 1)))
    known = Trajectory(path.times, path.poses, np.tile(np.eye(6), (2, 1, 1)))
    for given in (known, path):
        write_tum(tmp_path / "p.txt", given)
        assert (read_trajectory(tmp_path / "p.txt").covariances is None) == (given.covariances is None)


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
    assert found.rotation_from == "positions and orientations"
    assert found.straightness < 1e-10
    np.testing.assert_allclose(found.similarity.rotation, true.rotation, atol=1e-9)
    assert found.similarity.scale == pytest.approx(true.scale)
    assert found.ate < 1e-8
    still = Trajectory(line.times, line.poses * [0, 0, 0, 1, 1, 1, 1])
    for two in ((still, line), (line, still)):
        with pytest.raises(SlamlibError, match="does not move, so that it has no scale"):
            align_trajectory(*two)
        found = align_trajectory(*two, scale=False)
        assert (found.similarity.scale, found.rotation_from) == (1, "orientations")


def road(rng, bend, noise, mounting=(1.0, 0, 0, 0)):
    """A road of 100 m with a bend [m], and an estimate with noise [m] of it by a sensor turned in the car."""
    along = np.linspace(0, 100, 200)
    places = np.stack([along, bend * np.sin(along / 15), 0 * along], axis=1)
    turns = exponential(np.outer(np.arctan(bend / 15 * np.cos(along / 15)), [0, 0, 1]))
    sensor = compose(np.concatenate([places, turns], axis=1), np.array([0, 0, 0, *mounting]))
    sensor[:, :3] += rng.normal(0, noise, places.shape)
    return Trajectory(along, np.concatenate([places, turns], axis=1)), Trajectory(along, sensor)


@pytest.mark.parametrize("mounting", [(1, 0, 0, 0), tuple(exponential(np.array([0, 0, 0.02]))), (0.5, -0.5, 0.5, -0.5)])
@pytest.mark.parametrize("bend", [0.5, 0.05])
def test_of_a_narrow_path_the_positions_still_say_where_it_goes(bend, mounting):
    """Whatever the axes of the two: ATE is that of the positions alone, but for what noise makes of a narrow bend."""
    truth, path = road(np.random.default_rng(3), bend, 0.03, mounting)
    best = align(path.positions, truth.positions, scale=False)
    least = np.sqrt(((best(path.positions) - truth.positions) ** 2).sum(1).mean())
    found = align_trajectory(path, truth, scale=False)
    assert found.straightness < 0.05
    assert found.ate == pytest.approx(least, rel=1e-9 if bend == 0.5 else 0.02)
    assert align_trajectory(path, truth, scale=False, rotation_from="orientations").ate > (least if mounting[1] else 0)


def test_the_turn_about_a_narrow_path_is_that_of_the_orientations():
    truth, path = road(np.random.default_rng(4), 0.02, 0.05)
    found = align_trajectory(path, truth, scale=False)
    assert found.rotation_from == "positions and orientations"
    assert np.degrees(found.orientation.max()) < 0.5
    assert np.degrees(align_trajectory(path, truth, scale=False, rotation_from="positions").orientation.max()) > 2


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
    assert 0 < found["translation_mean"] < 0.02 + 1e-12
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
    sources = None, "orientations"
    by_both, by_orientations = (align_trajectory(colmap, pnp, rotation_from=source) for source in sources)
    assert by_both.rotation_from == "positions and orientations"
    assert by_both.ate < by_orientations.ate
    assert by_orientations.relative_ate < 0.04  # the two were found to agree to 2 % of the path
    assert np.degrees(np.median(by_orientations.orientation)) < 1.2


def two_of_evo():
    """A path that turns in all directions, and a noisy one in other axes and of another scale."""
    rng = np.random.default_rng(21)
    there = walk(rng, 200)
    noise = np.concatenate([rng.normal(0, 0.02, (200, 3)), exponential(rng.normal(0, 0.01, (200, 3)))], axis=1)
    return anyhow(rng).moved(Trajectory(there.times, compose(there.poses, noise))), there


@pytest.mark.parametrize(
    ("scale", "options", "position", "orientation"),
    [  # evo_ape 1.38.1: rmse of trans_part and of angle_deg
        (False, {}, 48.626778, 1.033022),  # -a
        (True, {}, 0.033040, 1.033022),  # -as
        (False, {"align": "scale"}, 16.694629, 109.255011),  # -s
        (False, {"align": "origin"}, 98.455926, 1.144691),  # --align_origin
        (True, {"align": "origin"}, 0.060137, 1.144691),  # --align_origin -s
        (False, {"align_first": 30}, 87.934949, 2.231306),  # -a --n_to_align 30
        (True, {"align_first": 30}, 0.168155, 2.231306),  # -as --n_to_align 30
        (False, {"align": "none"}, 115.057638, 109.255011),
    ],
)
def test_alignments_are_those_of_evo(scale, options, position, orientation):
    found, _ = compared(*two_of_evo(), not scale, how=ComparisonOptions(**options))
    assert found["position"]["rmse"] == pytest.approx(position, abs=1e-6)
    assert found["orientation"]["rmse"] == pytest.approx(orientation, abs=1e-6)
    with pytest.raises(SlamlibError, match="align none leaves the estimate as it is"):
        compared(*two_of_evo(), False, how=ComparisonOptions(align="none"))


@pytest.mark.parametrize(
    ("delta", "unit", "all_pairs", "position", "orientation"),
    [  # evo_rpe 1.38.1 -as: rmse of trans_part and of angle_deg
        (1, "m", False, 0.045060, 1.441599),
        (1, "m", True, 0.049426, 1.371259),
        (10, "frames", False, 0.042040, 1.296725),
        (10, "frames", True, 0.047321, 1.428134),
        (20, "deg", False, 0.049606, 1.452839),
        (20, "deg", True, 0.121648, 1.475577),
        (0.4, "rad", False, 0.049300, 1.390245),
    ],
)
def test_relative_errors_over_any_motion_are_those_of_evo(delta, unit, all_pairs, position, orientation):
    found, _ = compared(*two_of_evo(), False, how=ComparisonOptions(delta=delta, delta_unit=unit, all_pairs=all_pairs))
    assert found["rpe"]["position"]["rmse"] == pytest.approx(position, abs=1e-6)
    assert found["rpe"]["orientation"]["rmse"] == pytest.approx(orientation, abs=1e-6)


def test_motions_of_a_number_of_seconds():
    times = 1.6e9 + 0.1 * np.arange(31)
    path = Trajectory(times, np.tile([0.0, 0, 0, 1, 0, 0, 0], (31, 1)))
    assert np.transpose(motion_pairs(path, 1, "s")).tolist() == [[0, 10], [10, 20], [20, 30]]
    assert np.transpose(motion_pairs(path, 1, "s", True)).tolist() == [*([i, i + 10] for i in range(21)), [21, 30]]
    for delta, unit, message in (
        (5, "s", "no two poses are 5 s apart"),
        (0, "s", "above zero"),
        (1.5, "frames", "a whole"),
    ):
        with pytest.raises(SlamlibError, match=message):
            motion_pairs(path, delta, unit)


def smooth(rng, times):
    """Poses of a body that moves and turns smoothly and never the same."""
    waves = np.sin(np.outer(times, rng.uniform(0.5, 2.5, 9)) + rng.uniform(0, 6, 9)) @ rng.normal(0, 0.4, (9, 6))
    return np.concatenate([waves[:, :3], exponential(waves[:, 3:])], axis=1)


@pytest.mark.parametrize("offset", [0.0, -0.137, 1234567.891])
def test_the_offset_of_two_clocks_is_found(offset):
    """Of two sensors on one body, at other rates, in other axes, and of another scale."""
    times, part, rng = np.arange(0, 30, 0.01), np.arange(5.004, 22, 1 / 30), np.random.default_rng(1)
    reference = Trajectory(times, smooth(np.random.default_rng(2), times))
    sensor = np.array([0.1, 0, 0.05, *exponential(np.array([0, 1.0, 0.2]))])
    poses = compose(smooth(np.random.default_rng(2), part), sensor)
    poses[:, :3] = 0.3 * poses[:, :3] + rng.normal(0, 0.001, (len(part), 3))
    path = Trajectory(part - offset, poses)
    assert time_offset(path, reference).seconds == pytest.approx(offset, abs=0.001)
    found, _ = compared(path, reference, False, how=ComparisonOptions(offset="auto"))
    assert found["pairs"]["offset"] == pytest.approx(offset, abs=0.001)
    assert found["poses"] == len(part)
    assert found["notes"][0].startswith(f"time offset {found['pairs']['offset']:.4f} s, added to the path's times")


def test_an_offset_that_nothing_determines_is_refused():
    times, rng = np.arange(0, 40, 0.05), np.random.default_rng(5)
    circle = np.stack(
        [np.cos(times), np.sin(times), 0 * times, np.cos(times / 2), 0 * times, 0 * times, np.sin(times / 2)], 1
    )
    swing = np.stack([np.sin(times), 0 * times, 0 * times, 1 + 0 * times, 0 * times, 0 * times, 0 * times], 1)
    noise = np.stack([*rng.normal(size=(2, 3, 800)).cumsum(2)], axis=1).reshape(3, 2, 800)
    walks = [np.concatenate([noise[:, k].T, np.tile([1.0, 0, 0, 0], (800, 1))], axis=1) for k in (0, 1)]
    for one, other, message in (
        (circle, circle, "neither speeds nor angular rates"),
        (swing, swing, "fit alike, as of a motion that repeats itself"),
        (walks[0], walks[1], "is not determined"),
        (swing[:5], swing[:5], "so few poses"),
    ):
        with pytest.raises(SlamlibError, match=message):
            time_offset(Trajectory(times[: len(one)], one), Trajectory(times[: len(other)] + 0.3, other))


@pytest.mark.parametrize(("factor", "unit"), [(1e3, "milliseconds"), (1e6, "microseconds"), (1e9, "nanoseconds")])
def test_times_in_other_units_are_recognized_and_said(factor, unit):
    there = walk(np.random.default_rng(6))
    other = Trajectory(factor * there.times[3:], there.poses[3:])
    for path, reference, whose in ((there, other, "reference"), (other, there, "path")):
        found, _ = compared(path, reference, True)
        assert found["poses"] == 57
        assert found["notes"] == [
            f"the times of the {whose} are {factor:.0f} times as large as the others: taken for {unit}"
        ]
    assert in_one_unit(there, there)[2] == []
    fast = Trajectory(0.001 * np.arange(5000), np.tile([0.0, 0, 0, 1, 0, 0, 0], (5000, 1)))
    assert in_one_unit(fast, fast)[2] == []  # whole seconds are in both: five pairs in milliseconds, too


def test_pairs_are_within_half_of_the_denser_interval():
    """Keyframes, one a second, and a reference of 20 Hz with a hole of 0.9 s: what is in the hole has no reference."""
    times = np.arange(0, 20, 0.05)
    poses = smooth(np.random.default_rng(8), times)
    seen = ~((times > 7.56) & (times < 8.46))
    keyframes = Trajectory(times[::20] + 0.004, poses[::20])
    found, _ = compared(keyframes, Trajectory(times[seen], poses[seen]), True)
    assert (found["poses"], found["pairs"]["of"]) == (19, 20)
    assert found["pairs"]["largest"] == pytest.approx(0.004)
    assert found["pairs"]["tolerance"] == pytest.approx(0.025)
    wide, _ = compared(keyframes, Trajectory(times[seen], poses[seen]), True, how=ComparisonOptions(tolerance=0.5))
    assert wide["poses"] == 20
    assert wide["ate"] > 5 * found["ate"]


def test_too_few_pairs_and_a_reference_that_stands_still_are_refused():
    there = walk(np.random.default_rng(9), 200)
    late = Trajectory(there.times + there.times[-1] - there.times[1], there.poses)
    with pytest.raises(SlamlibError, match=r"only 2 of 200 poses .* s, in common are .*: are both in seconds"):
        compared(there, late, True)
    with pytest.raises(SlamlibError, match="only 2 of 2 poses"):
        compared(there[:2], there, True)
    with pytest.raises(SlamlibError, match="no time is in common"):
        compared(there, Trajectory(there.times + 1e4, there.poses), True)
    still = Trajectory(there.times, np.tile([1.0, 2, 3, 1, 0, 0, 0], (len(there), 1)))
    with pytest.raises(SlamlibError, match="the reference does not move, so that it has no scale"):
        compared(there, still, False)


def test_a_reference_that_only_turns_is_compared_by_orientations_whether_or_not_the_scale_is_known():
    there = walk(np.random.default_rng(9), 200)
    turning = Trajectory(there.times, there.poses * [0, 0, 0, 1, 1, 1, 1])
    found, _ = compared(turning, turning, True)
    assert found["relative_ate"] is None
    assert found["notes"] == ["path or reference does not move: they are aligned by their orientations alone"]
    assert found["orientation"]["rmse"] < 1e-6
    elsewhere = exponential(np.array([0.3, -1, 0.4]))
    path = np.concatenate([0.05 * there.positions, product(elsewhere, there.poses[:, 3:])], axis=1)
    free, known = (compared(Trajectory(there.times, path), turning, metric)[0] for metric in (False, True))
    assert free["orientation"]["rmse"] < 1e-6
    assert free["ate"] == known["ate"] == pytest.approx(0.05 * np.sqrt(there.positions.var(0).sum()))
    assert (free["scale"], free["rotation_from"]) == (1, "orientations")
    assert free["notes"] == ["the reference only turns: it has no scale, and the path keeps its own", *known["notes"]]


def test_two_body_frames_are_said():
    there = walk(np.random.default_rng(10))
    found, _ = compared(there.sensor_trajectory(np.array([0, 0, 0, 0.5, -0.5, 0.5, -0.5])), there, True)
    assert found["notes"][0].startswith("orientations differ by one turn of 120 degrees at all poses")


def test_what_evo_finds():
    """The same two paths in evo 1.38 (pip install evo), whose figures stand here for whoever has none."""
    estimate, there = two_of_evo()
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
        (metrics.PoseRelation.translation_part, metrics.StatisticsType.rmse),
        (metrics.PoseRelation.rotation_angle_deg, metrics.StatisticsType.max),
    )
    of_evo = [scale]
    for relation, statistic in kinds:
        error = metrics.APE(relation)
        error.process_data(tuple(two))
        of_evo.append(error.get_statistic(statistic))
    np.testing.assert_allclose(same, of_evo, rtol=1e-9)
