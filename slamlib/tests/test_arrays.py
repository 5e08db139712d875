"""Arrays as people have them: masked, of objects, with ids of all kinds, with times that do not grow."""

import csv
import json
from html import escape

import numpy as np
import pytest

import slamlib as sl
from slamlib.belief import Belief
from slamlib.errors import NonFiniteError, SlamlibError, UnitError
from slamlib.geometry.pose import to_frame
from slamlib.kalman.update import LinearizedMeasurement
from slamlib.manifolds import all_finite
from slamlib.records.ids import ids_of, packed, unpacked
from slamlib.records.inputs import Control, Features, Frame, RobotMeasurement, Scan, World
from slamlib.sensors import plane_bearing
from slamlib.sensors.pinhole import PINHOLE
from slamlib.simulation import recording

EYE = np.eye(3)


@pytest.mark.parametrize("dtype", [np.float16, np.float32, float, complex])
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_one_number_that_is_not_finite_is_noticed_and_large_ones_are_finite(dtype, bad):
    largest = np.full((3, 4), np.finfo(dtype).max, dtype=dtype)
    assert all_finite(largest)  # the sum of their squares is not
    assert all_finite(largest[:0])
    for number in (bad, 1j * bad) if dtype is complex else (bad,):
        largest[1, 2] = number
        assert not all_finite(largest)
        assert not all_finite(np.where(np.isfinite(largest), 0, largest).T)


def updated(z, H, R):
    belief = Belief()
    place = belief.add(3, [0, 0, 0], EYE)
    return belief.update([place], [H], z, R), place.mean, belief.matrix


@pytest.mark.parametrize("R", [EYE, np.array([1.0, 2.0, 3.0]), np.array(1.0)], ids=["matrix", "variances", "number"])
def test_masked_numbers_of_an_innovation_are_left_out(R):
    z = np.ma.array([1.0, 100.0, -2.0], mask=[False, True, False])
    found, mean, P = updated(z, EYE, R)
    noise = np.diag(np.broadcast_to(R, 3)) if R.ndim < 2 else R
    kept = [0, 2]
    wanted, wanted_mean, wanted_P = updated(z.data[kept], EYE[kept], noise[np.ix_(kept, kept)])
    assert found.nis == wanted.nis
    assert np.array_equal(mean, wanted_mean)
    assert np.array_equal(P, wanted_P)


def test_of_several_measurements_those_that_are_all_masked_are_left_out():
    belief = Belief()
    place = belief.add(1, [0], [[1]])
    given = [LinearizedMeasurement([place], [[[1]]], z, [[1]]) for z in (np.ma.masked_all(1), np.array([2.0]))]
    assert belief.update_all(given).nis == pytest.approx(2.0)
    with pytest.raises(SlamlibError, match="all that is given is masked"):
        belief.update_all(given[:1])


def test_what_cannot_be_left_out_is_refused_in_words():
    half = np.ma.array([1.0, 2.0, 3.0], mask=[0, 0, 1])
    for call in (
        lambda: Belief().add(3, half, EYE),
        lambda: Control(half, EYE),
        lambda: PINHOLE.back_project(half[1:], 0.1, [0, 0, 1, 1], [0.1]),
        lambda: to_frame(sl.Pose.random(np.random.default_rng(1)), half),
    ):
        with pytest.raises(SlamlibError, match="masked"):
            call()
    assert np.array_equal(Control(np.ma.array([1.0, 2]), EYE[:2, :2]).value, [1, 2])  # in which nothing is masked


def test_nees_of_masked_errors_is_that_of_the_others():
    P = np.array([[2.0, 0.5, 0.1], [0.5, 1.0, 0.2], [0.1, 0.2, 3.0]])
    e = np.ma.array([[1, 2, 3], [1, 99, 3], [99, 99, 99]], mask=[[0, 0, 0], [0, 1, 0], [1, 1, 1]], dtype=float)
    found = sl.nees(e, P)
    assert found[0] == sl.nees(e.data[0], P)
    assert found[1] == pytest.approx(sl.nees([1, 3], P[np.ix_([0, 2], [0, 2])]), rel=1e-12)
    assert found.mask.tolist() == [False, False, True]
    assert sl.nis(np.ma.array([1.0, 100], mask=[0, 1]), 2 * np.eye(2)) == pytest.approx(0.5, rel=1e-12)


def test_models_do_not_compute_masked_items():
    rng = np.random.default_rng(4)
    poses = np.array([sl.Pose.random(rng) for _ in range(4)])
    points = np.ma.array(rng.standard_normal((4, 3)))
    points[1, 2] = np.ma.masked
    value, (by_pose, by_point) = to_frame.jac(poses, points)
    for found in (value, by_pose, by_point):
        hidden = np.ma.getmaskarray(found)
        assert hidden[1].all()
        assert not hidden[[0, 2, 3]].any()
    assert np.array_equal(value[2:].data, to_frame.jac(poses[2:], points.data[2:])[0])
    one = to_frame(poses[0], points)  # one pose for all
    assert np.array_equal(one[3].data, to_frame(poses[0], points.data[3]))


def test_numbers_of_a_data_frame_are_numbers_and_what_is_none_is_named():
    pose = np.array([0, 0, 0, 1, 0, 0, 0], dtype=object)
    assert np.array_equal(to_frame(pose, np.array([1, 2.5, 3], dtype=object)), [1, 2.5, 3])
    assert Control(np.array([1, 2], dtype=object), EYE[:2, :2]).value.dtype == float
    for bad, said in ((None, "None"), ("7", "'7'")):
        with pytest.raises(SlamlibError, match=f"holds {said} .* at index \\(1,\\)"):
            to_frame(pose, np.array([1, bad, 3], dtype=object))
        with pytest.raises(SlamlibError, match="real numbers: int too large"):
            Control([10**400, 0], EYE[:2, :2])
        with pytest.raises(SlamlibError, match=f"holds {said} .* at index \\(0, 1\\)"):
            Features([1], np.array([[1, bad]], dtype=object))


def test_features_leave_out_masked_rows_and_unknown_ids():
    values = np.ma.array(np.arange(8.0).reshape(4, 2), mask=[[0, 0], [0, 1], [0, 0], [0, 0]])
    found = Features(np.ma.array([4, 5, 6, -1], mask=[0, 0, 1, 0]), values, unknown=-1)
    assert found.ids.tolist() == [4]
    assert found.values.tolist() == [[0, 1]]
    assert Features([-1, 3, -1], np.zeros((3, 1)), unknown=-1).ids.tolist() == [3]
    assert Features([-1], np.zeros((1, 1))).ids.tolist() == [-1]  # an id as any other, unless it is said
    with pytest.raises(SlamlibError, match="unknown=-1"):
        Features([-1, 3, -1], np.zeros((3, 1)))


@pytest.mark.parametrize(
    ("ids", "said"),
    [
        ([1.0], "astype"),
        ([True], "bool"),
        ([None], "NoneType"),
        ([1, "a"], "not some of each"),
        ([b"a"], "bytes"),
        (np.array([[1]]), "a list"),
        ("ab", "a list"),
        (7, "a list"),
        (np.ma.array([1, 2], mask=[0, 1]), "masked"),
    ],
)
def test_other_ids_are_refused_in_words(ids, said):
    with pytest.raises(SlamlibError, match=said):
        ids_of(ids, "ids")


MANY = ([3, 1], [2**63, 1], [2**64 - 1, -5], [10**30, 7], ["oak, old", 'a "b"'], np.array(["x", "y"]), ["7", "07"])


@pytest.mark.parametrize("ids", MANY, ids=str)
def test_ids_of_any_size_and_strings_come_back_from_archives(ids, tmp_path):
    wanted = list(ids)
    np.savez(tmp_path / "a.npz", ids=packed(ids_of(ids, "ids").tolist()))
    assert unpacked(np.load(tmp_path / "a.npz")["ids"]).tolist() == wanted


@pytest.mark.parametrize("ids", MANY, ids=str)
def test_ids_of_any_size_and_strings_go_through_filter_checkpoint_and_recording(ids, tmp_path):
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    values = np.array([[2.0, 0.1], [3.0, -0.2]])
    frames = [Frame(k, 0.1, (None,), (Scan({"points": Features(ids_of(ids, "ids"), values)}),)) for k in (1, 2)]
    slam.step(frames[0])
    slam.save(tmp_path / "run.npz")
    again = sl.Slam.load(tmp_path / "run.npz")
    again.step(frames[1])
    assert {lm.id for lm in again.landmarks} == set(ids)
    assert {type(lm.id) for lm in again.landmarks} <= {int, str}
    assert [lm.inliers for lm in again.landmarks] == [2, 2]  # recognized by their ids
    assert set(again.snapshot().landmarks["points"].ids.tolist()) == set(ids)
    assert escape(str(wanted_id := ids[0])) in again.map._repr_html_()
    assert str(wanted_id) in repr(again.map)
    world = World({"points": Features(ids_of(ids, "ids"), np.zeros((2, 3)))})
    recording.save(tmp_path / "seen.npz", [(frame, None) for frame in frames], rig=slam.rig, world=world)
    read = recording.load(tmp_path / "seen.npz")
    assert read.frames[1].scans[0].points.ids.tolist() == list(ids)
    assert read.world.points.ids.tolist() == list(ids)


def test_a_name_of_digits_is_the_same_name_whatever_stands_beside_it(tmp_path):
    """Labels of a reader of tags: "12" alone is no number, or it would be another landmark than "12" beside "oak"."""
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    slam.step([0, 0], {"12": [2, 0.1], "oak": [3, 0.2]})
    slam.save(tmp_path / "run.npz")
    for run in (slam, sl.Slam.load(tmp_path / "run.npz")):
        assert run.step([0, 0], {"12": [2, 0.1]}).initialized == []
        assert run.step([0, 0], {"012": [2, -0.1]}).initialized == ["012"]
        assert {lm.id: lm.inliers for lm in run.landmarks} == {"12": 2, "oak": 1, "012": 1}
    assert ids_of(["3"], "ids").tolist() == unpacked(packed(["3"])).tolist() == ["3"]


def test_names_are_given_to_step():
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    assert slam.step([0, 0], {"oak": [2, 0.1], "elm": [3, 0.2]}).initialized == ["elm", "oak"]


@pytest.mark.parametrize("dt", [np.nan, -1.0, np.inf, None, "0.1", np.timedelta64(1, "s"), 1j, np.complex64(1)])
def test_a_time_that_is_none_is_refused_before_anything_changes(dt):
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    slam.step(Frame(1, 0.1, (None,), (Scan({"points": Features([1], [[2.0, 0.1]])}),)))
    before = slam.time, slam.number, slam.belief.matrix.copy()
    for call in (lambda: slam.step(Frame(2, dt, (None,), (Scan(),))), lambda: slam.predict([None], dt)):
        with pytest.raises(SlamlibError, match="dt is the time since the frame before"):
            call()
        assert (slam.time, slam.number) == before[:2]
        assert np.array_equal(slam.belief.matrix, before[2])


def test_angles_in_degrees_are_refused_before_anything_changes():
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    with pytest.raises(UnitError, match="number 1 of row 1 is the angle 45, above a turn: angles are in radians"):
        slam.step(Frame(1, 0.1, (None,), (Scan({"points": Features([1, 2], [[2.0, 3.0], [50.0, 45.0]])}),)))
    assert (slam.number, slam.time) == (0, 0)
    with pytest.raises(UnitError, match=r"compass: .*radians"):
        RobotMeasurement("compass", plane_bearing.project, [90.0], [[0.01]])


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: sl.camera((320, 240, 250, 500)), "camera: the focal lengths 250 and 500 px differ by a factor of 2"),
        (lambda: sl.fisheye((320, 240, 500, 250)), "differ by a factor of 2"),
        (lambda: sl.stereo((320, 240, 500, 500), 200.0), "a baseline of 200 m right, or is it in another unit"),
        (lambda: sl.stereo((320, 240, 500, 500), 1e-4), "a baseline of 0.0001 m right"),
        (lambda: sl.range_bearing((0.1, 2.0)), "noise of an angle is 2: angles are in radians"),
        (lambda: sl.bearing_only(5.0), "noise of an angle is 5"),
        (lambda: sl.range_bearing(np.diag([0.01, 4.0])), "noise of an angle is 2"),
    ],
)
def test_what_cannot_be_in_its_unit_is_refused_by_the_builders(made, said):
    with pytest.raises(SlamlibError, match=said):
        made()


def test_what_is_unusual_and_right_is_made_by_hand():
    parameters = {"intrinsics": (320.0, 240.0, 500.0, 500.0), "baseline": (200.0,)}
    assert sl.SensorSetup(type="stereo", parameters=parameters).calibration.given["baseline"] == 200
    assert sl.camera((320, 240, 500, 600)).calibration.given["intrinsics"][3] == 600


def test_nan_is_refused_with_its_place():
    with pytest.raises(NonFiniteError, match="nan at index \\(1,\\); leave it out"):
        Control([0, np.nan], EYE[:2, :2])


def test_packed_ids_are_integers_where_they_fit():
    assert packed([1, 2]).dtype == np.int64
    assert json.loads(packed(["a"])[0]) == "a"


@pytest.mark.parametrize("ids", MANY, ids=str)
def test_ids_of_any_size_and_strings_are_in_maps(ids, tmp_path):
    map_file = pytest.importorskip("slambook.scene.map_file")
    slam = sl.Slam(sl.robot("unicycle"), sl.range_bearing((0.1, 0.02)))
    slam.step([0, 0], dict(zip(ids, ([2, 0.1], [3, 0.2]), strict=True)))
    texts = {}
    for ending in ("json", "csv", "ply"):
        map_file.write(tmp_path / f"map.{ending}", slam.snapshot())
        texts[ending] = (tmp_path / f"map.{ending}").read_text("utf-8")
    assert {landmark["id"] for landmark in json.loads(texts["json"])["landmarks"]} == set(ids)
    rows = [*csv.DictReader(texts["csv"].splitlines())]
    assert {row["id"] for row in rows} == set(map(str, ids))
    numbers = {int(line.split()[-1]) for line in texts["ply"].splitlines()[-2:]}
    named = {
        json.loads(line.partition(" is ")[2]) for line in texts["ply"].splitlines() if line.startswith("comment id")
    }
    assert (named or numbers) == set(ids)
