"""observe and initialize for every pair of a sensor and a point, calibrations that make no sense, and the registry."""

import itertools
import sys
from dataclasses import replace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.checks.landmarks import pose_for
from slamlib.checks.sensors import unmeasured, visible_points
from slamlib.entities import Landmark
from slamlib.errors import CovarianceError, NonFiniteError, ShapeError, SlamlibError, UnknownNameError
from slamlib.experiments.presets import preset
from slamlib.geometry.pose import Pose, compose
from slamlib.landmarks import LINES, POINTS, PointLandmark
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.linearity import euclidean_index
from slamlib.manifolds import as_manifold
from slamlib.motions import motion
from slamlib.observation import FAMILIES, parametrization
from slamlib.observation.points import initialize, observe
from slamlib.registry import Registry
from slamlib.sensors import SENSORS, Calibration, sensor
from slamlib.slam import Options
from slamlib.tests.test_every_type import example

PAIRS = [(k, s) for k, s in itertools.product(POINTS, SENSORS) if POINTS[k].plane == SENSORS[s].plane]
IDENTITY = np.array([0.0, 0, 0, 1, 0, 0, 0])


def scene(kind, calibration, count=4, seed=0):
    """Robot and extrinsics, and landmarks (count, size) that the sensor sees, a metre or more ahead of it."""
    rng = np.random.default_rng(seed)
    robot, extrinsics = pose_for(kind, rng), pose_for(kind, rng)
    points = visible_points(calibration, rng, 400) * [1, 1, not kind.plane, 1]
    points = points[points[:, 0 if kind.plane else 2] > 0.2][:count]
    return robot, extrinsics, np.array([kind.from_frame(compose(robot, extrinsics), p) for p in points]), rng


def derivative(function, manifold, x, minus):
    """Central differences (result, dof) of function(x) through plus and minus."""
    columns = []
    for unit in np.eye(manifold.dof):
        step = 1e-6 * unit
        columns.append(minus(function(manifold.plus(x, step)), function(manifold.plus(x, -step))) / 2e-6)
    return np.array(columns).reshape(manifold.dof, -1).T


def changed(calibration, name, value):
    """The calibration with another value of a parameter."""
    given = {**calibration.given, name: value}
    limits = {n: 0.99 * limit for n, limit in calibration.limits.items()}  # where a lens ends, parameters say, too
    return Calibration(calibration.sensor, calibration.noise, image=calibration.image, limits=limits, **given)


def close(found, wanted, what):
    assert found.shape == wanted.shape, what
    assert np.abs(found - wanted).max(initial=0) <= 2e-7 * max(1, np.abs(wanted).max(initial=0)), what


@pytest.mark.parametrize(("name", "by"), PAIRS)
def test_jacobians_of_observe_are_central_differences(name, by):
    kind, calibration = POINTS[name], example(SENSORS[by])
    robot, extrinsics, landmarks, _ = scene(kind, calibration)
    for x in landmarks:
        seen = observe(kind, calibration, robot, extrinsics, x)
        assert seen.visible
        own = calibration.sensor.manifold.minus

        def value(c=calibration, r=robot, m=extrinsics, x=x):
            return observe(kind, c, r, m, x).value

        J = seen.jacobians
        close(J.robot, derivative(lambda r: value(r=r), Pose, robot, own), "robot")
        close(J.extrinsics, derivative(lambda m: value(m=m), Pose, extrinsics, own), "extrinsics")
        close(J.landmark, derivative(lambda p: value(x=p), kind.manifold, x, own), "landmark")
        assert set(vars(J)) == {"robot", "extrinsics", "landmark", *calibration.given}
        for n, p in calibration.given.items():
            numerical = derivative(lambda v, n=n: value(c=changed(calibration, n, v)), as_manifold(len(p)), p, own)
            close(getattr(J, n), numerical, n)


@pytest.mark.parametrize(("name", "by"), PAIRS)
def test_jacobians_of_initialize_are_central_differences(name, by):
    kind, calibration = POINTS[name], example(SENSORS[by])
    robot, extrinsics, landmarks, rng = scene(kind, calibration)
    for x in landmarks:
        y, hidden = observe(kind, calibration, robot, extrinsics, x).value, unmeasured(calibration, rng)
        _, G = initialize(kind, calibration, robot, extrinsics, y, *hidden)

        def made(c=calibration, r=robot, m=extrinsics, y=y, h=hidden):
            return initialize(kind, c, r, m, y, *h)[0]

        minus = kind.manifold.minus
        close(G.robot, derivative(lambda r: made(r=r), Pose, robot, minus), "robot")
        close(G.extrinsics, derivative(lambda m: made(m=m), Pose, extrinsics, minus), "extrinsics")
        close(G.measurement, derivative(lambda y: made(y=y), as_manifold(len(y)), y, minus), "measurement")
        for h in hidden:
            close(G.unmeasured, derivative(lambda h: made(h=[h]), as_manifold(len(h)), h, minus), "unmeasured")
        expected = {"robot", "extrinsics", "measurement", *calibration.given, *(["unmeasured"] if hidden else [])}
        assert set(vars(G)) == expected
        for n, p in calibration.given.items():
            numerical = derivative(lambda v, n=n: made(c=changed(calibration, n, v)), as_manifold(len(p)), p, minus)
            close(getattr(G, n), numerical, n)


def same(batch, items):
    """A batch equals its items, one by one."""
    flat = batch.reshape(-1, *items[0].shape)
    assert len(flat) == len(items)
    for got, wanted in zip(flat, items, strict=True):
        np.testing.assert_allclose(got, wanted, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize(("name", "by"), PAIRS)
def test_a_batch_is_a_loop(name, by):
    kind, calibration = POINTS[name], example(SENSORS[by])
    robot, extrinsics, landmarks, rng = scene(kind, calibration)
    robots = np.array([Pose.plus(robot, 0.01 * rng.standard_normal(6)) for _ in range(3)])
    seen = observe(kind, calibration, robots[:, None], extrinsics, landmarks)
    assert seen.visible.shape == (3, len(landmarks))
    each = [observe(kind, calibration, r, extrinsics, x) for r in robots for x in landmarks]
    assert seen.visible.ravel().tolist() == [bool(e.visible) for e in each]
    same(seen.value, [e.value for e in each])
    for field in vars(seen.jacobians):
        same(getattr(seen.jacobians, field), [getattr(e.jacobians, field) for e in each])

    hidden = unmeasured(calibration, rng)
    y = observe(kind, calibration, robot, extrinsics, landmarks).value
    made, G = initialize(kind, calibration, robots[:, None], extrinsics, y, *hidden)
    each = [initialize(kind, calibration, r, extrinsics, item, *hidden) for r in robots for item in y]
    same(made, [x for x, _ in each])
    for field in vars(G):
        whole = np.broadcast_to(getattr(G, field), (3, len(y), *getattr(each[0][1], field).shape))
        same(whole, [getattr(g, field) for _, g in each])


@pytest.mark.parametrize(("name", "by"), PAIRS)
def test_what_is_not_seen_is_masked_and_finite(name, by):
    """Points all around, almost at the sensor's own position, behind, at infinity: a mask, never an error."""
    kind, calibration = POINTS[name], example(SENSORS[by])
    rng = np.random.default_rng(1)
    points = np.column_stack([rng.standard_normal((60, 3)), rng.uniform(0.01, 2, 60)])
    points = np.vstack([points, *([[*s * e, w]] for e in np.eye(3) for s in (1, -1) for w in (1.0, 1e-9))])
    if name not in ("eucPnt", "planePnt"):  # which have no place for them
        points = np.vstack([points, [[*h, 0] for h in rng.standard_normal((20, 3))], [[0, 0, 1, 0]]])
    # a landmark made in another frame, so that a position beside or behind this sensor can be made at all
    ahead = points[:, 2] > 0
    made = kind.from_frame(IDENTITY, points[ahead & (np.abs(points[:, :2]).sum(-1) > 0)])
    for extrinsics in (IDENTITY, np.array([0.1, 0.2, 0.3, 0, 1, 0, 0]), np.array([0, 0, 0, 0.5, 0.5, 0.5, 0.5])):
        seen = observe(kind, calibration, IDENTITY, extrinsics, made)
        assert np.isfinite(seen.value).all()
        assert all(np.isfinite(j).all() for j in seen.jacobians)
        assert seen.visible.dtype == bool
        point = kind.to_frame(extrinsics, made)
        assert seen.visible.tolist() == (calibration.visible(point) & calibration.inside(seen.value)).tolist()
    nothing = observe(kind, calibration, IDENTITY, IDENTITY, made[:0])
    assert nothing.value.shape == (0, calibration.sensor.size)
    assert nothing.visible.shape == (0,)


def test_arguments_stay_as_they_are_and_single_precision_is_taken():
    kind, calibration = POINTS["ahmPnt"], example(SENSORS["pinHole"])
    robot, extrinsics, landmarks, _ = scene(kind, calibration)
    before = [a.copy() for a in (robot, extrinsics, landmarks)]
    seen = observe(kind, calibration, robot, extrinsics, landmarks)
    initialize(kind, calibration, robot, extrinsics, seen.value, np.full((len(landmarks), 1), 0.1))
    assert all(np.array_equal(a, b) for a, b in zip((robot, extrinsics, landmarks), before, strict=True))
    single = observe(kind, calibration, *(a.astype(np.float32) for a in before))
    np.testing.assert_allclose(single.value, seen.value, rtol=1e-4)


def test_the_border_of_the_image_is_in_the_image():
    camera = Calibration(SENSORS["pinHole"], 1, image=(640, 480), intrinsics=[320, 240, 320, 320], distortion=[])
    corners = np.array([[0, 0], [640, 480], [640.001, 480], [-0.001, 0], [320, np.nan]])
    assert camera.inside(corners).tolist() == [True, True, False, False, False]
    assert camera.inside(corners, margin=1).tolist() == [False] * 5
    seen = observe(POINTS["eucPnt"], camera, IDENTITY, IDENTITY, np.array([[0.9, 0, 1], [1.1, 0, 1], [0, 0, -1]]))
    assert seen.visible.tolist() == [True, False, False]
    assert Calibration(SENSORS["relativePosition"], 1).inside(np.full((2, 3), 1e9)).all()


# -- misuse ------------------------------------------------------------------------------------------------------------

GOOD = {"noise": 1.0, "image": (640, 480), "intrinsics": [320, 240, 400, 410], "distortion": [-0.2, 0.04]}


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"noise": -1}, CovarianceError, "noise has the negative variance"),
        ({"noise": np.eye(3)}, ShapeError, r"noise should have shape \(2, 2\)"),
        ({"noise": [[1, 2], [3, 1]]}, CovarianceError, "noise is not symmetric"),
        ({"noise": [[1, 2], [3]]}, SlamlibError, "noise should be an array"),
        ({"noise": np.nan}, NonFiniteError, "noise holds nan"),
        ({"intrinsics": [320, 240, 400]}, SlamlibError, "intrinsics are"),
        ({"intrinsics": [320, 240, 0, 400]}, SlamlibError, "au, av > 0"),
        ({"intrinsics": [320, 240, -400, 400]}, SlamlibError, "au, av > 0"),
        ({"intrinsics": [320, 240, np.inf, 400]}, NonFiniteError, "intrinsics holds inf"),
        ({"intrinsics": [320, 240, 400, 400, 1]}, ShapeError, "intrinsics has at most 4 numbers"),
        ({"intrinsics": "wide"}, SlamlibError, "intrinsics should be an array of real numbers"),
        ({"distortion": np.zeros(9)}, ShapeError, "distortion has at most 8 numbers"),
        ({"distortion": [[0.1, 0.2]]}, ShapeError, "distortion has at most 8 numbers"),
        ({"distortion": 1j}, SlamlibError, "distortion should be an array of real numbers"),
        ({"distortion": [-3.0]}, SlamlibError, "folds back"),
        ({"image": (640,)}, ShapeError, "image should have shape"),
        ({"image": (640, 0)}, SlamlibError, "width and a height above zero"),
        ({"limits": {"angel": 1}}, UnknownNameError, "unknown limit of pinHole 'angel'"),
        ({"limits": {"radius": "a"}}, SlamlibError, "limit 'radius' should be"),
        ({"limits": {"radius": np.nan}}, SlamlibError, "limit 'radius' should be"),
        ({"limits": [1]}, SlamlibError, "limits are given by name"),
        ({"baseline": 1}, UnknownNameError, "unknown parameter of pinHole 'baseline'"),
        ({"intrinsics": None}, SlamlibError, "the calibration lacks intrinsics"),
    ],
)
def test_a_calibration_that_makes_no_sense_is_refused(change, error, message):
    given = {k: v for k, v in {**GOOD, **change}.items() if v is not None}
    before = repr(given)
    with pytest.raises(error, match=message):
        Calibration(SENSORS["pinHole"], given.pop("noise"), **given)
    assert before == repr({k: v for k, v in {**GOOD, **change}.items() if v is not None})


def test_a_calibration_keeps_copies_and_cannot_be_changed():
    k, R, limits = np.array([320.0, 240, 400, 410]), np.eye(2), {"radius": 1.0}
    camera = Calibration(SENSORS["pinHole"], R, image=(640, 480), limits=limits, intrinsics=k, distortion=-0.2)
    k[0], R[0, 0], limits["radius"] = 0, 9, 0.1
    assert camera.given["intrinsics"][0] == 320
    assert camera.noise[0, 0] == 1
    assert camera.limits == {"radius": 1.0}
    for array in (camera.noise, camera.image, *camera.given.values()):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
    with pytest.raises(SlamlibError, match="make another one with the noise"):
        camera.noise = np.eye(2)


@pytest.mark.parametrize("by", list(SENSORS))
def test_wrong_kinds_and_priors_are_named(by):
    calibration = example(SENSORS[by])
    kind, robot = POINTS["planeIdpPnt" if calibration.sensor.plane else "ahmPnt"], IDENTITY
    y = observe(kind, calibration, robot, robot, scene(kind, calibration)[2][0]).value
    hidden = unmeasured(calibration, np.random.default_rng(0))
    with pytest.raises(SlamlibError, match=f"{by} is asked for 'plkLin', which is no point"):
        observe(LINES["plkLin"], calibration, robot, robot, np.ones(6))
    with pytest.raises(SlamlibError, match=f"{by} is asked for 'plkLin', which is no point"):
        initialize(LINES["plkLin"], calibration, robot, robot, y, *hidden)
    with pytest.raises(SlamlibError, match=f"{by} is asked for 'ahmPnt', which is no point"):
        observe("ahmPnt", calibration, robot, robot, np.ones(7))
    with pytest.raises(SlamlibError, match="the second argument is a Calibration, not Sensor"):
        observe(kind, calibration.sensor, robot, robot, np.ones(7))
    with pytest.raises(SlamlibError, match=f"{by} needs .*prior"):
        initialize(kind, calibration, robot, robot, y, *hidden, [0.1])
    if hidden:
        with pytest.raises(SlamlibError, match=f"{by} needs a prior of what it does not measure; got 0"):
            initialize(kind, calibration, robot, robot, y)
        if calibration.sensor.initializes:
            with pytest.raises(SlamlibError, match="inverse distance is negative"):
                initialize(kind, calibration, robot, robot, y, [-0.1])
        with pytest.raises(NonFiniteError):
            initialize(kind, calibration, robot, robot, y, [np.nan])
    with pytest.raises(SlamlibError):
        initialize(kind, calibration, robot, robot, y[:-1], *hidden)
    with pytest.raises(SlamlibError, match=r"robot|outer|pose"):
        observe(kind, calibration, robot[:6], robot, np.ones(7))


# -- the registry ------------------------------------------------------------------------------------------------------


def test_types_are_found_by_name():
    assert parametrization("ahmPnt") is POINTS["ahmPnt"]
    assert parametrization("plkLin") is LINES["plkLin"]
    assert sensor("pinHole") is SENSORS["pinHole"]
    assert "ahmPnt" in POINTS
    assert "ahmPnt" not in LINES
    assert LINES.get("ahmPnt") is None
    with pytest.raises(UnknownNameError, match=r"unknown landmark 'ahmpnt'; did you mean 'ahmPnt'\?.*plkLin"):
        parametrization("ahmpnt")
    with pytest.raises(UnknownNameError, match=r"unknown sensor 'pinhole'; did you mean 'pinHole'"):
        sensor("pinhole")
    with pytest.raises(UnknownNameError, match=r"unknown motion 'odo'"):
        motion("odo")


def test_a_point_is_converted_by_its_error_beside_the_camera_s():
    """The index is that of the joint covariance of landmark and camera, whose Jacobian is a central difference here."""
    p = preset("points")
    p = replace(p, frames=12, options=replace(p.options, convert=False))
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    (sensor,), landmark = slam.sensors, slam.landmarks[0]
    robot, block = sensor.robot.block, landmark.block
    by_robot = derivative(lambda x: compose(x, sensor.given_extrinsics), Pose, robot.mean, Pose.minus)
    T = np.zeros((block.dof + 6, 6 + block.dof))
    T[: block.dof, 6:], T[block.dof :, :6] = np.eye(block.dof), by_robot
    rows = [*range(robot.start, robot.start + 6), *range(block.start, block.start + block.dof)]
    joint = T @ slam.belief.matrix[np.ix_(rows, rows)] @ T.T
    index = euclidean_index(landmark.kind, block.mean, joint, sensor.camera)
    alone = euclidean_index(landmark.kind, block.mean, slam.belief.covariance(block), sensor.camera)
    assert abs(index - alone) > 0.05 * index
    for share in (0.99, 1.01):
        options = replace(p.options, convert=True, convert_below=share * index)
        slam.families["points"].after_update(slam.belief, sensor, [landmark], np.zeros((1, 2)), options)
        assert (landmark.kind is EUC_POINT) == (share > 1)


def test_a_point_near_the_border_of_the_image_begins_no_landmark():
    (sensor,), options = preset("points").slam().sensors, Options(margin=0.1)  # of 640 x 480 pixels: 64
    values = np.array([[64.0, 240], [63, 240], [320, 64], [320, 63], [576, 240], [577, 240]])
    assert FAMILIES["points"].usable(sensor, values, options).tolist() == [True, False] * 3


def test_a_point_that_is_surely_beyond_infinity_is_impossible():
    """Its inverse distance is negative: by more than three of its standard deviations, or by fewer."""
    kind, belief = POINTS["idpPnt"], Belief()
    means, P = [np.array([0.0, 0, 0, 0.3, 0.2, rho]) for rho in (0.1, -0.29, -0.31)], 0.01 * np.eye(6)
    landmarks = [Landmark(i, kind, belief.add(kind.manifold, mean, P), 1) for i, mean in enumerate(means)]
    assert FAMILIES["points"].invalid(belief, landmarks) == {landmarks[2]}
    exact = Landmark(3, EUC_POINT, belief.add(EUC_POINT.manifold, np.ones(3), np.eye(3)), 1)
    assert FAMILIES["points"].invalid(belief, [exact]) == set()


def test_what_is_shown_of_a_point_is_its_place_and_the_covariance_of_that():
    kind, belief, rng = POINTS["ahmPnt"], Belief(), np.random.default_rng(2)
    means = [kind.from_frame(IDENTITY, [*rng.uniform(1, 3, 3), 1]) for _ in range(2)]
    root = rng.standard_normal((kind.manifold.dof,) * 2)
    landmarks = [Landmark(i, kind, belief.add(kind.manifold, mean, root @ root.T), 1) for i, mean in enumerate(means)]

    def place(mean):
        h = kind.to_frame(IDENTITY, mean)
        return h[:3] / h[3]

    positions, covariances, converged = FAMILIES["points"].geometry(belief, landmarks)
    for mean, position, P in zip(means, positions, covariances, strict=True):
        J = derivative(place, kind.manifold, mean, np.subtract)
        assert position == pytest.approx(place(mean), rel=1e-12)
        assert pytest.approx(J @ root @ root.T @ J.T, rel=1e-6) == P
    assert converged.tolist() == [False, False]


def test_a_new_file_is_found_and_two_of_one_name_are_refused(tmp_path, monkeypatch):
    package = tmp_path / "own_points"
    package.mkdir()
    (package / "__init__.py").write_text("")
    source = "from slamlib.landmarks.ahm_point import *\nfrom slamlib.landmarks.parametrization import PointLandmark\n"
    made = "PointLandmark('my_Pnt', AHM_POINT.manifold, to_frame, from_frame, to_point)\n"
    (package / "mine.py").write_text(f"{source}MINE = {made}")
    monkeypatch.syspath_prepend(tmp_path)
    found = Registry("own_points", PointLandmark, "point")
    assert sorted(found) == ["ahmPnt", "my_Pnt"]  # ahmPnt is imported there: the same value, not another one
    (package / "other.py").write_text(f"{source}OWN = {made}")
    again = Registry("own_points", PointLandmark, "point")
    monkeypatch.delitem(sys.modules, "own_points.mine")
    with pytest.raises(SlamlibError, match="two points are called 'my_Pnt'"):
        list(again)
