"""Straight edges in images: found where they are, distinguished, found again by the filter, and right in space."""

import json
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from slambook import rendering

from slamlib.errors import SlamlibError
from slamlib.landmarks import endpoints, hmg_point
from slamlib.landmarks.segments import length
from slamlib.observation.lines import undistort_segments
from slamlib.records.inputs import Frame, Scan
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.slam import Options, Slam
from slamlib.slam.data_association.front_end import FrontEndInput
from slamlib.tests.pictures import cube
from slamlib.tests.rooms import flat, pinhole, upright
from slamlib.vision.active_search import ActiveSearch
from slamlib.vision.edges import PROFILE, EdgeStrip, axes, directed, edge_strip, fitted, refined, segments_of
from slamlib.vision.image_front_end import CombinedFrontEnd
from slamlib.vision.line_search import SegmentSearch, SegmentSettings, across_covariances, lines_of
from slamlib.vision.opening import make_front_end

pytest.importorskip("cv2", reason="OpenCV, whose detector begins the segments, is not installed")
WIDTH, HEIGHT = 160, 120
DISTORTED, IDEAL = pinhole(), pinhole(distortion=(0.0,))
OPTIONS = Options(points=None, lines="idpLin", inverse_distance=(0.4, 0.4), updates=20, max_new_first=20)


def step(x):
    """From 0 to 1 about 0, as an edge under a Gaussian blur of 1."""
    return (1 + np.vectorize(math.erf)(x / math.sqrt(2))) / 2


def picture(*edges, calibration=IDEAL, noise=0.0, width=0.6):
    """An image (h, w) of steps: edges are (direction [rad], offset [px] from the middle, height), bright to the right
    of the direction; straight in the world."""
    v, u = np.mgrid[:HEIGHT, :WIDTH].astype(float)
    pixels = np.stack([u, v, u, v], -1).reshape(-1, 4)
    ideal = undistort_segments(calibration, pixels)[0][:, :2].reshape(HEIGHT, WIDTH, 2)
    image = np.full((HEIGHT, WIDTH), 90.0)
    for direction, offset, height in edges:
        right = np.array([-np.sin(direction), np.cos(direction)])
        image += height * step(((ideal - middle()) @ right - offset) / width)
    rng = np.random.default_rng(4)
    return np.clip(np.rint(image + noise * rng.standard_normal(image.shape)), 0, 255).astype(np.uint8)


def middle():
    return np.array([(WIDTH - 1) / 2, (HEIGHT - 1) / 2])


def shifted(segment, direction, offset, calibration=IDEAL):
    """Distances (2,) [px] of a segment's ends from the edge, in ideal pixels."""
    right = np.array([-np.sin(direction), np.cos(direction)])
    return (undistort_segments(calibration, segment)[0].reshape(2, 2) - middle()) @ right - offset


ANGLES = np.radians([0, 17, 45, 90, 133, 180, 250, 305])


@pytest.mark.parametrize("direction", ANGLES)
def test_a_segment_goes_along_its_edge_with_the_bright_side_to_its_right(direction):
    found = segments_of(picture((direction, 3.3, 80)), 30)
    assert len(found) >= 1
    forward, _ = axes(found[0])
    assert forward @ [np.cos(direction), np.sin(direction)] > 0.999
    assert np.abs(shifted(found[0], direction, 3.3)).max() < 0.6


@pytest.mark.parametrize("calibration", [IDEAL, DISTORTED], ids=["ideal", "distorted"])
@pytest.mark.parametrize("direction", ANGLES)
@pytest.mark.parametrize("offset", [0.0, -7.3, 11.75])
def test_the_fit_lies_on_the_edge_to_a_few_hundredths_of_a_pixel(direction, offset, calibration):
    image = picture((direction, offset, 80), calibration=calibration, noise=2.0)
    found = [refined(image, calibration, s) for s in segments_of(image, 25)]
    assert any(edge is not None for edge in found)
    for edge in found:
        if edge is not None and edge.support > 0.8:
            assert np.abs(shifted(edge.segment, direction, offset, calibration)).max() < 0.15
            assert edge.rms < 0.2
    best = max((e for e in found if e is not None), key=lambda e: length(e.segment))
    assert np.abs(shifted(best.segment, direction, offset, calibration)).max() < 0.06


def test_segments_are_at_least_as_long_as_asked_for_and_the_longest_comes_first():
    image = picture((0.3, 0, 60), (1.7, 20, 50))
    for least in (10, 40, 90):
        lengths = length(segments_of(image, least))
        assert (lengths >= least).all()
        assert (np.diff(lengths) <= 0).all()
    assert len(segments_of(image, 500)) == 0
    assert segments_of(np.full((HEIGHT, WIDTH), 77, np.uint8)).shape == (0, 4)


def test_a_segment_is_turned_round_if_its_left_side_is_brighter():
    image = picture((0.0, 0, 80))
    right = np.array([20.0, 59.5, 120, 59.5])
    turned = directed(image, np.array([right, right[[2, 3, 0, 1]]]))
    np.testing.assert_array_equal(turned, [right, right])


def test_an_edge_ends_where_something_stands_before_it():
    image = picture((0.0, 0, 80)).copy()
    image[:, 100:] = 40  # T-junctions with an upright edge at u = 99.5
    piece = edge_strip(image, IDEAL, np.array([20.0, 59.5, 140, 59.5]), 8)
    edge = fitted(piece, IDEAL, np.zeros(2), 2.0)
    assert np.abs(shifted(edge.segment, 0.0, 0.0)).max() < 0.03
    assert 95 < edge.segment[2] < 101
    assert edge.support == pytest.approx(2 / 3, abs=0.06)


@pytest.mark.parametrize("seed", range(5))
def test_texture_does_not_stand_in_for_an_edge_that_has_ended(seed):
    image, rng = picture((0.0, 0, 80)).astype(float), np.random.default_rng(seed)
    image[:, 90:] = 130 + 12 * rng.standard_normal((HEIGHT, WIDTH - 90))
    edge = fitted(edge_strip(image, IDEAL, np.array([20.0, 59.5, 86, 59.5]), 8, beyond=40), IDEAL, np.zeros(2), 1.0)
    assert 80 < edge.segment[2] < 98
    assert np.abs(shifted(edge.segment, 0.0, 0.0)).max() < 0.1


def test_the_ends_of_a_fit_have_the_covariance_of_least_squares():
    """Of n points with the noise s: 4 s^2 / n each, and -2 s^2 / n of both: they are correlated by -1/2."""
    rng, n, s = np.random.default_rng(0), 41, 0.1
    along, across = np.linspace(0, 40, n), np.arange(-16, 17) * 0.5
    end_points = []
    for _ in range(1500):
        places = s * rng.standard_normal(n)
        grey = 100 * step((across[:, None] - places) / 0.8)
        piece = EdgeStrip(np.array([20.0, 60, 60, 60]), along, across, grey)
        end_points.append(fitted(piece, IDEAL, np.zeros(2), 2.0).offsets)
    C = np.cov(np.array(end_points).T) * n / s**2
    np.testing.assert_allclose(C, [[4, -2], [-2, 4]], atol=0.6)


# --- the filter ---


def rig_of(translation=0.01, rotation=0.1, distortion=(0.0,)):
    """A robot whose control is to stand still, and which may move by so many metres and degrees a step."""
    camera = {"intrinsics": (79.5, 59.5, 128.0, 128.0), "distortion": distortion}
    robot = RobotSetup(control_std=(translation,) * 3 + (rotation,) * 3)
    return Rig((robot,), (SensorSetup(image=(WIDTH, HEIGHT), parameters=camera, std=(0.1,)),))


def frame_of(number, image):
    return Frame(number, 1.0, (None,), (Scan(image=image),))


def seen(first, second, rig=None, options=OPTIONS, **settings):
    """The predictions for the second picture of a filter that started with the first."""
    rig = rig or rig_of()
    slam = Slam(
        rig, options=options, front_ends=[SegmentSearch(rig.sensors[0].calibration, SegmentSettings(**settings))]
    )
    slam.step(frame_of(1, first))
    slam.step(frame_of(2, second))
    return slam.predictions[0]


def test_an_edge_is_found_again_where_it_went():
    predictions = seen(picture((0.2, 0, 80)), picture((0.21, 0.7, 80)), rig=rig_of(0.03, 0.5))
    assert len(predictions) == 1
    assert predictions[0].matched
    assert predictions[0].inlier
    assert predictions[0].score > 0.98
    assert np.abs(shifted(predictions[0].measured, 0.21, 0.7)).max() < 0.05


def test_gain_and_offset_of_the_light_change_nothing():
    predictions = seen(picture((0.2, 0, 80)), picture((0.2, 0.5, 60)) + np.uint8(20))
    assert predictions[0].matched


def test_of_two_parallel_edges_the_one_with_the_same_direction_is_taken():
    first = picture((0.0, 0, 80), (np.pi, 30, 60))
    predictions = seen(first, picture((0.0, 1.5, 80), (np.pi, 2.5, 80)), rig=rig_of(0.03, 0.5))  # a thin bar
    own = min(predictions, key=lambda prediction: abs(prediction.value[1] - middle()[1]))
    assert own.matched
    assert np.abs(shifted(own.measured, 0.0, 1.5)).max() < 0.4


def test_two_edges_that_look_the_same_are_refused():
    first = picture((0.0, 0, 60))
    both = picture((0.0, -4.5, 60), (0.0, 4.5, 60))
    predictions = seen(first, both, rig=rig_of(0.05, 1.5))
    assert predictions[0].chosen
    assert not predictions[0].matched
    assert np.isnan(predictions[0].measured).all()


def test_a_profile_tells_parallel_edges_apart():
    """A step, and a line of the same direction whose dark side is a thin bar."""
    single, bar = (0.0, -5.0, 60), [(0.0, 4.0, 60), (np.pi, -1.5, 60)]
    predictions = seen(picture((0.0, 0, 60)), picture(single, *bar), rig=rig_of(0.05, 1.5))
    assert predictions[0].matched
    assert np.abs(shifted(predictions[0].measured, 0.0, -5.0)).max() < 0.2


def test_what_became_faint_or_vanished_is_not_found_and_backs_off():
    for second in (picture((0.0, 0, 20)), picture(noise=2.0)):
        predictions = seen(picture((0.0, 0, 80)), second)
        assert predictions[0].chosen
        assert not predictions[0].matched


def test_a_region_that_is_too_wide_is_not_searched():
    predictions = seen(picture((0.0, 0, 80)), picture((0.0, 0, 80)), rig=rig_of(0.3, 10.0))
    assert not predictions[0].chosen


@pytest.mark.parametrize("reading", ["ortDst", "rhoThe", "angles"])
@pytest.mark.parametrize("distortion", [(0.0,), (-0.1, 0.01)])
def test_the_region_is_the_same_whatever_the_reading(reading, distortion):
    calibration = rig_of(distortion=distortion).sensors[0].calibration
    image = picture((0.2, 3, 80), calibration=calibration)
    regions = []
    for innovation in ("ortDst", reading):
        rig = rig_of(distortion=distortion)
        slam = Slam(rig, options=replace(OPTIONS, innovation=innovation), front_ends=[SegmentSearch(calibration)])
        slam.step(frame_of(1, image))
        slam.step(frame_of(2, image))
        regions.append(across_covariances(slam.predictions[0], slam.sensors[0]))
    np.testing.assert_allclose(regions[1], regions[0], rtol=1e-3)


def test_the_innovation_of_orthogonal_distances_is_the_move_itself():
    rig, image = rig_of(), picture((0.2, 3, 80))
    slam = Slam(rig, options=OPTIONS, front_ends=[SegmentSearch(rig.sensors[0].calibration)])
    slam.step(frame_of(1, image))
    slam.step(frame_of(2, image))
    S = np.array([prediction.S for prediction in slam.predictions[0]])
    np.testing.assert_allclose(across_covariances(slam.predictions[0], slam.sensors[0]), S, rtol=1e-6)


def test_the_lines_that_are_tried_cover_the_ellipse():
    region, rng = np.array([[4.0, 3.5], [3.5, 4.0]]), np.random.default_rng(1)
    tried = lines_of(region, 9.21)
    drawn = rng.multivariate_normal([0, 0], region, 2000)
    inside = drawn[np.einsum("ni,ij,nj->n", drawn, np.linalg.inv(region), drawn) < 9.21]
    nearest = np.abs(inside[:, None] - tried).max(-1).min(-1)
    assert nearest.max() <= 0.25 + 1e-9
    assert len(lines_of(np.eye(2) * 1e-8, 9.21)) >= 1


def test_no_edge_is_initialized_on_a_predicted_one():
    image = picture((0.0, 0, 80), (np.pi / 2, 30, 80))
    rig = rig_of()
    slam = Slam(rig, options=OPTIONS, front_ends=[SegmentSearch(rig.sensors[0].calibration)])
    counts = [len(slam.step(frame_of(i, image)).initialized) for i in range(1, 6)]
    assert counts[0] >= 2
    assert sum(counts[1:]) == 0


def test_edges_are_initialized_only_up_to_the_maximum():
    image = picture(*((np.pi / 2, x, 25) for x in (-60, -30, 0, 30, 60)))
    rig = rig_of()
    front_end = SegmentSearch(rig.sensors[0].calibration, SegmentSettings(max_in_view=3, slope=3.0))
    slam = Slam(rig, options=OPTIONS, front_ends=[front_end])
    for i in range(1, 4):
        slam.step(frame_of(i, image))
    assert len(slam.landmarks) == 3


# --- a room ---


@pytest.fixture(scope="module")
def film():
    """Plain boards before a plain wall, filmed by a robot that feels its own steps well, so that the scale is known."""
    boards = [(2.9, 0.6, 1.3, 0.8, 0.6, 60), (2.4, -0.5, 1.5, 0.5, 0.7, 230), (1.9, 0.1, 0.9, 0.6, 0.35, 100)]
    quads = [upright((x, y, z), w, h, flat(grey)) for x, y, z, w, h, grey in boards]
    room = rendering.Room([upright((3.0, 0.0, 1.3), 8.0, 5.0, flat(160), outlined=False), *quads])
    path = rendering.path("sideways")
    rig = rendering.rig_along_path(path, motion="odometry", control_std=(0.0005,) * 3 + (0.02,) * 3, std=(0.1,))
    made = rendering.film(room, rig, path, frames=30, dt=0.06, rng=np.random.default_rng(2))
    return SimpleNamespace(rig=rig, steps=list(made), world=room.world.segments.values.reshape(-1, 2, 3))


def ran(film, front_end=None, options=OPTIONS):
    calibration = film.rig.sensors[0].calibration
    slam, predictions = Slam(film.rig, options=options, front_ends=[front_end or SegmentSearch(calibration)]), []
    for frame, _ in film.steps:
        slam.step(frame)
        predictions += [prediction for prediction in slam.predictions[0] if prediction.chosen]
    return slam, predictions


@pytest.fixture(scope="module")
def done(film):
    return ran(film)


def settled(slam):
    """The lines whose two endpoints are known, by the filter's own account, to a tenth of their length."""
    found = slam.families["segments"].geometry(slam.belief, slam.landmarks)[2]
    return [k for k, is_settled in zip(slam.landmarks, found, strict=True) if is_settled]


def in_image(slam, landmark):
    """A line's ends in the image (4,), where the filter has them."""
    h = endpoints.endpoints_at(landmark.kind, landmark.block.mean, landmark.abscissas)
    sensor = slam.sensors[0]
    return sensor.calibration.project(hmg_point.to_frame(sensor.camera, h)).ravel()


def from_edges(landmark, world):
    """Least, over true edges (n, 2, 3), of the larger distance [m] of a line's two endpoints from an edge's line."""
    h = endpoints.endpoints_at(landmark.kind, landmark.block.mean, landmark.abscissas)
    end_points = h[:, :3] / h[:, 3:]
    along = world[:, 1] - world[:, 0]
    along /= np.linalg.norm(along, axis=1)[:, None]
    away = end_points[:, None] - world[:, 0]
    return np.linalg.norm(away - (away * along).sum(-1)[..., None] * along, axis=-1).max(0).min()


def test_lines_lie_on_the_true_edges_of_the_room(film, done):
    slam, predictions = done
    well = settled(slam)
    assert len(well) >= 4
    distances = np.array([from_edges(k, film.world) for k in well])
    upright_ones = np.array([np.abs(axes(in_image(slam, k))[0][1]) > 0.9 for k in well])
    assert upright_ones.sum() >= 3  # across the camera's way, and so well known
    assert distances[upright_ones].max() < 0.03
    endpoint_covariances = slam.families["segments"].geometry(slam.belief, well)[1]
    std = np.sqrt(np.trace(endpoint_covariances, axis1=-2, axis2=-1)).max(-1)
    assert (distances < 3 * std).all()
    assert np.mean([prediction.matched for prediction in predictions]) > 0.9
    nis = np.array([prediction.nis for prediction in predictions if prediction.inlier])
    assert 0.3 < nis.mean() < 2.5  # two degrees of freedom
    assert len(nis) > 0.95 * sum(prediction.matched for prediction in predictions)


def test_the_camera_is_where_it_should_be_with_lines_alone(film, done):
    off_by = done[0].robots[0].pose[:3] - film.steps[-1][1].robots[0][:3]
    assert np.linalg.norm(off_by) < 0.01


def test_a_run_that_was_saved_goes_on_identically(film, tmp_path):
    calibration = film.rig.sensors[0].calibration

    def front_end():
        return CombinedFrontEnd(ActiveSearch(calibration, np.random.default_rng(3)), SegmentSearch(calibration))

    options = replace(OPTIONS, points="ahmPnt")
    slam = Slam(film.rig, options=options, front_ends=[front_end()])
    for frame, _ in film.steps[:12]:
        slam.step(frame)
    slam.save(tmp_path / "half.npz")
    assert json.loads(json.dumps(slam.front_ends[0].dump())) is not None
    again = Slam.load(tmp_path / "half.npz", front_ends=[front_end()])
    for frame, _ in film.steps[12:20]:
        slam.step(frame)
        again.step(frame)
    np.testing.assert_array_equal(again.belief.matrix, slam.belief.matrix)
    assert [k.id for k in again.landmarks] == [k.id for k in slam.landmarks]
    kinds = {k.kind.name for k in slam.landmarks}
    assert "idpLin" in kinds
    assert len(kinds) > 1
    assert len({k.id for k in slam.landmarks}) == len(slam.landmarks)


def test_both_ask_the_front_end_of_the_family(film):
    calibration = film.rig.sensors[0].calibration
    front_end = CombinedFrontEnd(ActiveSearch(calibration, np.random.default_rng(3)), SegmentSearch(calibration))
    slam, predictions = ran(film, front_end, replace(OPTIONS, points="ahmPnt", updates=30))
    found = {
        name: np.mean([k.matched for k in predictions if k.family.name == name]) for name in ("points", "segments")
    }
    assert min(found.values()) > 0.8
    assert set(front_end.seconds) == {"search", "detection"}
    assert all(front_end.seconds[part] > spent > 0 for part, spent in front_end.points.seconds.items())
    adopted = front_end.initialize_at(
        FrontEndInput(film.steps[0][0].scans[0], slam.sensors[0], []), "points", np.array([[160.0, 120]])
    )
    assert adopted[0][0] > max(k.id for k in slam.landmarks)
    with pytest.raises(SlamlibError, match="no image"):
        front_end.check(Scan())


def test_the_front_end_is_the_one_that_the_options_need():
    made = [make_front_end(o, IDEAL, np.random.default_rng(1)) for o in (OPTIONS, replace(OPTIONS, lines=None))]
    assert [type(front_end) for front_end in made] == [CombinedFrontEnd, ActiveSearch]


# --- what is wrong, and a real picture ---


def test_wrong_inputs_say_so():
    image = picture((0.0, 0, 80))
    with pytest.raises(SlamlibError, match="minimum_length"):
        segments_of(image, 0)
    with pytest.raises(SlamlibError, match="channels"):
        segments_of(np.zeros((20, 20, 3), np.uint8))
    with pytest.raises(SlamlibError, match="four pixel coordinates"):
        edge_strip(image, IDEAL, np.array([1.0, 2, np.nan, 4]), 5)
    with pytest.raises(SlamlibError, match="same pixel"):
        edge_strip(image, IDEAL, np.array([10.0, 20, 10, 20]), 5)
    with pytest.raises(SlamlibError, match="no image of straight lines"):
        SegmentSearch(SensorSetup(type="omniCam", parameters={"intrinsics": (80, 60, 1, 0, 0), "lens": (48.0, 2.0)},
                                  image=(160, 120), limits={"angle": 1.2}).calibration)  # fmt: skip
    search = SegmentSearch(IDEAL)
    with pytest.raises(SlamlibError, match="no image"):
        search.check(Scan())
    with pytest.raises(SlamlibError, match="shape"):
        search.check(Scan(image=np.zeros((3, 4))))


def test_a_strip_that_leaves_the_image_is_unknown_there():
    piece = edge_strip(picture((0.0, 0, 80)), IDEAL, np.array([100.0, 59.5, 170, 59.5]), 6)
    outside = piece.along + 100 > WIDTH - 1
    assert np.isnan(piece.grey[:, outside]).all()
    edge = fitted(piece, IDEAL, np.zeros(2), 1.5)
    assert edge.support > 0.95
    assert edge.segment[2] <= WIDTH - 1
    assert edge.profile.shape == PROFILE.shape


def test_the_edges_of_a_real_picture_are_straight_and_sharp():
    image = cube(0)
    lens = {"intrinsics": (192, 144, 576.63, 554.99), "distortion": (0.0,)}
    calibration = SensorSetup(image=(384, 288), parameters=lens, std=(0.1,)).calibration
    edges = [refined(image, calibration, s) for s in segments_of(image, 30)]
    good = [e for e in edges if e is not None and e.support > 0.8]
    assert len(good) >= 10
    assert np.median([e.rms for e in good]) < 0.3
