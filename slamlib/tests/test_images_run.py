"""A run on pictures, with a front end that is given its matches: tracking losses, scale, times, and lossless saving."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.sources import of_pictures
from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry.pose import compose, to_frame
from slamlib.geometry.quaternion import exponential
from slamlib.rigs.setup import SensorSetup
from slamlib.vision.opening import IMAGES, camera_rig, image_run, load, options_for
from slamlib.vision.results import COLUMNS, PARTS, innovation_correlation, lasting, summary, summary_warnings, table
from slamlib.vision.sequence_run import TrackingLostError
from slamlib.vision.target import Target

CAMERA = {
    "image": (64, 48),
    "parameters": {"intrinsics": (31.5, 23.5, 50.0, 50.0), "distortion": (0.0,)},
    "std": (0.1,),
}
CALIBRATION = SensorSetup(**CAMERA).calibration
DARK = 255  # a picture of this brightness shows nothing
COUNT, DT = 40, 0.04
OPTIONS, IMPULSE = IMAGES.options, IMAGES.impulse


def true_path():
    """A camera that moves to the right and turns, from the origin on, looking along x."""
    turn = exponential(np.stack([0 * np.arange(COUNT), 0 * np.arange(COUNT), -0.004 * np.arange(COUNT)], axis=1))
    x = np.arange(COUNT) * 0.02
    robot = np.concatenate([np.stack([0.3 * x, -x, 0.2 * np.sin(3 * x)], axis=1), turn], axis=1)
    return Trajectory(DT * np.arange(COUNT), compose(robot, SensorSetup().extrinsics))


def world():
    """Points ahead of the camera, near and far, by number."""
    rng = np.random.default_rng(3)
    return np.stack([rng.uniform(1, 4, 80), rng.uniform(-2.5, 1.5, 80), rng.uniform(-1, 1, 80)], axis=1)


class Told:
    """Sees the world's points from the true path; the brightness of a picture is its number, and DARK shows nothing."""

    def __init__(self, seed=0):
        self.rng, self.points, self.path = np.random.default_rng(seed), world(), true_path()

    def check(self, scan):
        pass

    def searchable(self, inputs):
        return inputs.predictions

    def _pixels(self, inputs, numbers):
        pose = self.path.poses[int(inputs.scan.image[0, 0])]
        seen = np.concatenate([to_frame(pose, self.points[numbers]), np.ones((len(numbers), 1))], axis=1)
        pixels = CALIBRATION.project(seen) + self.rng.normal(0, 0.1, (len(seen), 2))
        return pixels, CALIBRATION.visible(seen) & CALIBRATION.inside(pixels)

    def match(self, inputs, family, predictions):
        if inputs.scan.image[0, 0] == DARK:
            return np.full((len(predictions), 2), np.nan), np.zeros(len(predictions), dtype=bool)
        pixels, seen = self._pixels(inputs, np.array([prediction.landmark.signature for prediction in predictions]))
        return np.where(seen[:, None], pixels, np.nan), seen

    def detect(self, inputs, family, known, usable, count):
        if inputs.scan.image[0, 0] == DARK:
            return []
        pixels, seen = self._pixels(inputs, np.arange(len(self.points)))
        seen &= usable(pixels)
        fresh = [n for n in self.rng.permutation(len(seen)).tolist() if seen[n] and n not in known]
        return [(n, pixels[n], n) for n in fresh[:count]]

    def initialize_at(self, inputs, family, values):
        """Each pixel's point is the world's whose number comes next: targets in these tests are its first points."""
        return [(n, pixel, n) if pixel[0] > 3 else None for n, pixel in enumerate(values)]

    def dump(self):
        return self.rng.bit_generator.state

    def restore(self, state):
        self.rng.bit_generator.state = state

    def pack(self, signature):
        return signature

    def unpack(self, packed):
        return packed


def pictures(dark=(), count=COUNT):
    """Pictures whose brightness is their number."""
    shades = [DARK if i in dark else i for i in range(count)]
    return of_pictures(
        [TimedImage(f"{i}.png", DT * i, np.full((48, 64), s, np.uint8)) for i, s in enumerate(shades)], DT
    )


def started(dark=(), **options):
    return image_run(pictures(dark), camera_rig(CAMERA), OPTIONS, Told(), **options)


def error(run, scale=True):
    return align_trajectory(run.trajectory(), true_path()[np.arange(len(run.history))], scale=scale)


def test_a_run_of_all_pictures():
    run = started()
    assert len(run) == COUNT
    steps = list(run)
    assert len(run) == 0
    assert list(run) == []
    assert [s.frame.number for s in steps] == list(range(1, COUNT + 1))
    assert steps[3].picture.name == "3.png"
    assert set(steps[5].row) == set(COLUMNS)
    found = error(run)
    assert found.relative_ate < 0.02
    assert 0.2 < found.similarity.scale < 5
    result = run.result()
    assert result.matched[0] == 0
    assert (result.matched[1:] > 5).all()
    assert result.frames_without_match == 0
    assert 0.5 < result.nis[5:].sum() / result.nis_dof[5:].sum() < 1.5
    s = summary(result)
    assert s["frames"] == COUNT
    assert s["matched_share"] > 0.9
    assert set(s["milliseconds"]) == set(PARTS)
    assert table(s)[0][0] == "frames"
    # No errors last. Below zero: the camera moves more steadily than the filter supposes.
    assert -0.2 < s["innovation_correlation"] < 4 * s["innovation_correlation_std"]
    assert s["innovation_correlation_std"] < 0.1
    assert s["near_mean"] is None
    assert summary_warnings(s) == []
    assert "ideal" not in "".join(value for _, value in table(s))
    with pytest.raises(AttributeError):
        _ = result.nothing


@pytest.mark.parametrize("claimed", [1.0, 0.2, 5.0])
def test_errors_that_last_are_told_from_the_innovations_whatever_the_filter_claims(claimed):
    """A mean that stays, as large as the noise: a correlation of one half."""
    rng = np.random.default_rng(3)
    white = [{i: rng.standard_normal(3) / claimed for i in range(40)} for _ in range(20)]
    means = rng.standard_normal((40, 3)) / claimed
    lasts = [{i: value + means[i] for i, value in frame.items()} for frame in white]
    for frames, expected in ((white, 0.0), (lasts, 0.5)):
        found, _ = innovation_correlation(products(frames))
        assert found == pytest.approx(expected, abs=0.06)
    assert lasting(white[0], {}) == {"lasting": 0, "lasting_now": 0, "lasting_before": 0, "lasting_dof": 0}
    assert innovation_correlation(np.zeros((3, 3))) is None


def products(frames):
    """The three numbers of each pair of neighbouring frames."""
    return np.array([[*lasting(now, before).values()][:3] for before, now in itertools.pairwise(frames)])


def test_a_correlation_is_one_at_most_and_minus_one_at_least():
    same = [{1: np.array([1.0, 2.0]) * (-1) ** k} for k in range(5)]
    assert innovation_correlation(products(same)) == pytest.approx((-1.0, 0.0), abs=1e-12)
    assert innovation_correlation(products([same[0]] * 5)) == pytest.approx((1.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("share", [0.0, 0.6])
def test_its_standard_error_is_what_many_runs_show_also_where_a_frame_s_innovations_are_one(share):
    """Innovations of a frame that share an error: to take them for independent would claim a third of the error."""
    rng, rows = np.random.default_rng(5), []
    for _ in range(300):
        shared, own = rng.standard_normal((2, 60, 1, 2)), rng.standard_normal((60, 20, 2))
        values = np.sqrt(share) * shared[0] + np.sqrt(1 - share) * own
        rows.append(innovation_correlation(products([dict(enumerate(frame)) for frame in values])))
    found, claimed = np.array(rows).T
    assert found.mean() == pytest.approx(0, abs=4 * found.std() / 300**0.5)
    assert np.sqrt((claimed**2).mean()) == pytest.approx(found.std(), rel=0.12)


def test_a_run_doubts_itself_in_words():
    said = {
        "innovation_correlation": 0.6, "innovation_correlation_std": 0.03, "innovation_lasting": 0.3, "near_mean": 3.4,
    }  # fmt: skip
    assert [text.split()[1] for text in summary_warnings(said)] == ["innovations", "3.4"]
    assert summary_warnings({**said, "innovation_correlation_std": 0.2, "near_mean": None}) == []  # by chance
    assert summary_warnings({**said, "innovation_lasting": 0.02, "near_mean": None}) == []  # a generous noise covers it


def test_going_on_is_the_same_as_not_stopping(tmp_path):
    whole, cut = started({20, 21}), started({20, 21})
    list(whole)
    steps = iter(cut)
    for _ in range(21):
        next(steps)
    cut.save(tmp_path / "run.npz")
    again = load(tmp_path / "run.npz", source=pictures({20, 21}), front_end=lambda calibration: Told(seed=9))
    assert (len(again), again.tracking_loss.frames) == (COUNT - 21, 1)
    list(again)
    assert np.array_equal(whole.trajectory().poses, again.trajectory().poses)
    assert np.array_equal(whole.slam.belief.matrix, again.slam.belief.matrix)
    timeless = [i for i, name in enumerate(COLUMNS) if name not in PARTS]
    numbers, resumed = (np.array(run.history)[:, timeless] for run in (whole, again))
    assert np.array_equal(numbers, resumed, equal_nan=True)  # of one camera no point is known to be near
    with pytest.raises(SlamlibError, match="were in memory"):
        load(tmp_path / "run.npz", front_end=lambda calibration: Told())
    again.slam.save(tmp_path / "other.npz")
    with pytest.raises(SlamlibError, match="holds no run on pictures"):
        load(tmp_path / "other.npz")
    again.history = [row[:-1] for row in again.history]
    again.save(tmp_path / "older.npz")
    with pytest.raises(SlamlibError, match="other columns than those of this version"):
        load(tmp_path / "older.npz", source=pictures({20, 21}), front_end=lambda calibration: Told())


def test_what_is_broken_off_in_the_middle_is_not_saved(tmp_path):
    run = started()
    steps = iter(run)
    next(steps)
    run.slam.front_ends[0].match = None  # fails
    with pytest.raises(TypeError):
        next(steps)
    with pytest.raises(SlamlibError, match="frame 2 was interrupted"):
        run.save(tmp_path / "run.npz")
    assert not list(tmp_path.iterdir())


def test_frames_without_matches_are_predictions():
    run = started({15, 16, 17})
    gaps = [run.tracking_loss.frames for _ in run]
    assert gaps[14:19] == [0, 1, 2, 3, 0]
    assert run.result().frames_without_match == 3
    assert error(run).relative_ate < 0.03
    moved = np.linalg.norm(np.diff(run.trajectory().positions, axis=0), axis=1)
    assert (moved[14:17] > 0.25 * np.median(moved)).all()


def test_missing_pictures_pass_as_dark_ones_do():
    spoilt = set(range(15, 23))
    dark = started(spoilt)
    there = [p for i, p in enumerate(pictures()) if i not in spoilt]
    missing = image_run(of_pictures(there, DT), camera_rig(CAMERA), OPTIONS, Told())
    seen = []
    for run in (dark, missing):
        step = next(step for step in run if step.picture.name == "23.png")
        assert (step.frame.number, run.slam.time) == (24 if run is dark else 16, pytest.approx(23 * DT))
        seen.append({prediction.landmark.signature: prediction for prediction in run.slam.predictions[0]})
    assert len(seen[0]) > 10
    assert seen[0].keys() == seen[1].keys()
    for name, prediction in seen[0].items():
        np.testing.assert_allclose(prediction.value, seen[1][name].value, atol=1e-9)
        np.testing.assert_allclose(prediction.S, seen[1][name].S, rtol=1e-9)


def test_a_long_tracking_loss_ends_the_run_and_the_result_is_kept(tmp_path):
    run = started(set(range(10, 25)), patience=6)
    with pytest.raises(
        TrackingLostError, match=r"6 pictures in a row without a match, from frame 11 on; was there a cut"
    ):
        list(run)
    assert len(run.history) == 16
    run.save(tmp_path / "run.npz")
    again = load(tmp_path / "run.npz", source=run.source, front_end=lambda calibration: Told())
    again.patience = 100
    list(again)
    assert len(again.history) == COUNT


def test_after_a_cut_new_landmarks_do_not_hide_that_the_old_ones_are_gone():
    run = started(patience=8)
    for step in run:
        if step.frame.number == 12:  # another place, where nothing known is in view
            run.slam.front_ends[0].points = run.slam.front_ends[0].points * [1, 1, 1] + [0, 0, 50]
            run.slam.front_ends[0].points[40:] = world()[40:]
            known = {lm.signature for lm in run.slam.landmarks}
            run.slam.front_ends[0].points[sorted(known)] += 50
        if run.tracking_loss.frames == 7:
            break
    assert run.result().initialized[12:].sum() > 0
    assert run.tracking_loss.first == 13
    with pytest.raises(TrackingLostError):
        list(run)


def test_a_dark_beginning_keeps_the_start_known():
    run = started(set(range(5)), patience=30)
    list(run)
    result = run.result()
    assert result.initialized[:6].tolist() == [0, 0, 0, 0, 0, OPTIONS.max_new_first]
    np.testing.assert_array_equal(result.trajectory.positions[:6], 0)
    with pytest.raises(TrackingLostError, match="is there enough light and texture"):
        list(started(set(range(COUNT)), patience=10))


def test_over_a_longer_time_more_impulses():
    there = pictures()
    sparse = of_pictures([p for i, p in enumerate(there) if i not in (20, 21, 22)], DT)
    endpoint_covariances = []
    for source in (there, sparse):
        run = image_run(source, camera_rig(CAMERA), OPTIONS, Told())
        seen = []
        correct = run.slam._update
        run.slam._update = lambda i, scan, s=run.slam, c=correct, a=seen: (
            a.append(s.belief.covariance(s.robots[0].block)[6:9, 6:9].trace()), c(i, scan)
        )  # fmt: skip
        list(run)
        endpoint_covariances.append(seen)
    impulse = 3 * IMPULSE[0] ** 2
    assert endpoint_covariances[0][20] < 2.5 * impulse
    assert endpoint_covariances[1][20] > 3.9 * impulse


def test_a_picture_of_another_size_is_refused_before_the_filter_moves():
    source = of_pictures([TimedImage("a.png", 0.0, np.zeros((24, 32), np.uint8))], DT)
    run = image_run(source, camera_rig(CAMERA), OPTIONS, Told())
    with pytest.raises(SlamlibError, match=r"a\.png is 32x24, and the calibration is of 64x48"):
        list(run)
    assert run.is_intact
    for what in (run.result, run.trajectory):
        with pytest.raises(SlamlibError, match="nothing has been run"):
            what()
    rig = camera_rig(CAMERA)
    with pytest.raises(SlamlibError, match="one robot with one camera"):
        image_run(source, replace(rig, sensors=(rig.sensors[0], replace(rig.sensors[0], name="right"))))


# -- a known target ----------------------------------------------------------------------------------------------------


def target(count=6, noise=0.0, std=0.0):
    """The first points that are seen in the first picture, with which the world then starts."""
    told = Told()
    pixels, seen = told._pixels(type("S", (), {"scan": type("I", (), {"image": np.zeros((1, 1))})}), np.arange(80))
    inside = seen & (pixels[:, 0] > 6)
    order = np.concatenate([np.flatnonzero(inside), np.flatnonzero(~inside)])
    rng = np.random.default_rng(4)
    return Target(told.points[order[:count]], pixels[order[:count]] + rng.normal(0, noise, (count, 2)), std), order


def with_target(**options):
    known, order = target(**options)
    told = Told()
    told.points = told.points[order]
    unit = known.distance(CALIBRATION)
    return image_run(pictures(), camera_rig(CAMERA, unit=unit), options_for(unit, 6), told, scale=known), known


def test_a_target_gives_the_true_scale_and_the_place():
    run, known = with_target()
    first = next(iter(run))
    assert first.row["searched"] == 0
    assert first.row["landmarks"] == len(known.points) + OPTIONS.max_new_first
    P = run.slam.belief.covariance(run.slam.robots[0].block)
    assert np.sqrt(P[:3, :3].diagonal()).max() < 0.1
    np.testing.assert_allclose(run.trajectory().positions[0], 0, atol=4 * np.sqrt(P[:3, :3].diagonal().max()))
    list(run)
    found = align_trajectory(run.trajectory(), true_path(), scale=True)
    assert found.similarity.scale == pytest.approx(1, abs=0.05)
    off = np.linalg.norm(run.trajectory().positions - true_path().positions, axis=1)  # without any alignment
    assert off.max() < 0.15
    assert run.slam.options.updates == OPTIONS.updates + 6


def test_the_uncertainty_of_the_start_is_that_of_the_pixels():
    """The batch of pixels counts once: errors of the first pose are as large as its covariance, over many draws."""
    rng, squared = np.random.default_rng(5), []
    known, order = target(8)
    for _ in range(60):
        noisy = replace(
            known, pixels=Target(known.points, true_pixels(known.points)).pixels + rng.normal(0, 0.1, (8, 2))
        )
        told = Told()
        told.points = told.points[order]
        run = image_run(pictures(), camera_rig(CAMERA), OPTIONS, told, scale=noisy)
        next(iter(run))
        from slamlib.geometry.pose import Pose, inverse

        true = compose(true_path().poses[0], inverse(SensorSetup().extrinsics))
        e = Pose.minus(true, run.slam.robots[0].pose)
        squared.append(e @ np.linalg.solve(run.slam.belief.covariance(run.slam.robots[0].block)[:6, :6], e))
    assert 4.5 < np.mean(squared) < 8.0  # 6 degrees of freedom, 99.9 % band of 60 draws about [4.7, 7.5]


def true_pixels(points):
    seen = np.concatenate([to_frame(true_path().poses[0], points), np.ones((len(points), 1))], axis=1)
    return CALIBRATION.project(seen)


def test_targets_are_read_from_json(tmp_path):
    known, _ = target()
    path = tmp_path / "target.json"
    import json

    path.write_text(json.dumps({"points": known.points.tolist(), "pixels": known.pixels.tolist(), "std": 0.01}))
    found = Target.load(path)
    assert np.array_equal(found.points, known.points)
    assert found.std == 0.01
    for text in ("", "[]", '{"points": 3}', '{"points": [[1, 2, 3]]}'):
        path.write_text(text)
        with pytest.raises(SlamlibError, match="is no target"):
            Target.load(path)
    with pytest.raises(SlamlibError, match="absent cannot be read"):
        Target.load(tmp_path / "absent")


def test_targets_that_say_too_little_or_do_not_fit():
    known, _ = target(8)
    with pytest.raises(SlamlibError, match="at least 4 points, got 3"):
        Target(known.points[:3], known.pixels[:3])
    with pytest.raises(SlamlibError, match="one line"):
        Target(np.outer(np.arange(5.0), [1, 2, 3]), known.pixels[:5])
    with pytest.raises(SlamlibError, match="std"):
        Target(known.points, known.pixels, -1.0)
    with pytest.raises(SlamlibError, match="do not fit its points"):
        Target(known.points, known.pixels[::-1]).camera(CALIBRATION)
    square = Target([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[20, 15], [40, 15], [40, 35], [20, 35]])
    assert np.linalg.norm(square.camera(CALIBRATION)[:3] - [0.5, 0.5, 0]) == pytest.approx(2.5, abs=0.1)

    run, _ = with_target()
    run.target = Target(known.points, known.pixels * [0, 1])
    with pytest.raises(SlamlibError, match="too near the image's border"):
        next(iter(run))
    run = image_run(
        pictures(), camera_rig(CAMERA), OPTIONS, type("Other", (Told,), {"initialize_at": property()})(), scale=known
    )
    with pytest.raises(SlamlibError, match="has no `initialize_at`"):
        next(iter(run))
