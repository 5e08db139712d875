"""Points: the five parametrizations against each other, against differences, and against the toolbox's numbers."""

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.codegen import check_model
from slamlib.errors import ShapeError, SingularPointError, SlamlibError
from slamlib.geometry import pose as frames
from slamlib.geometry import quaternion
from slamlib.geometry.pose import Pose
from slamlib.landmarks import POINTS
from slamlib.landmarks.ahm_point import AHM_POINT
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.fhm_point import FHM_POINT
from slamlib.landmarks.hmg_point import HMG_POINT
from slamlib.landmarks.idp_point import IDP_POINT, angles_moved, angles_of, direction
from slamlib.landmarks.linearity import (
    beyond_infinity,
    euclidean_index,
    inverse_distance_prior,
    linearity_index,
    should_convert,
    to_euclidean,
)
from slamlib.models.numerical import central_difference
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

KINDS = [EUC_POINT, HMG_POINT, AHM_POINT, IDP_POINT, FHM_POINT]
AT_INFINITY = [k for k in KINDS if k is not EUC_POINT]
every_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda k: k.name)
infinite_kind = pytest.mark.parametrize("kind", AT_INFINITY, ids=lambda k: k.name)
MODELS = [m for k in KINDS for m in (k.to_frame, k.from_frame, k.to_point)] + [angles_of, angles_moved, direction]
named = pytest.mark.parametrize("model", MODELS, ids=lambda m: f"{m.module.split('.')[-1]}-{m.name}")


@pytest.fixture
def rng():
    return np.random.default_rng(11)


def ray(rng, w=0.2):
    """A homogeneous point in front of the frame, with a unit direction."""
    h = rng.standard_normal(3)
    h[2] = 0.5 + abs(h[2])
    return np.array([*(h / np.linalg.norm(h)), w])


def seen(kind, rng, w=0.2):
    """A camera, and a landmark that it has just initialized."""
    camera = Pose.random(rng)
    return camera, kind.from_frame(camera, ray(rng, w))


def spread(size, rng):
    """A covariance."""
    root = rng.standard_normal((size, size)) / 10
    return root @ root.T


def test_the_folder_holds_the_five():
    assert {"eucPnt", "hmgPnt", "ahmPnt", "idpPnt", "fhmPnt"} <= set(POINTS)
    assert [k.manifold.dof for k in KINDS] == [3, 4, 7, 6, 9]


@named
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@named
def test_central_differences_and_a_batch_agree(model, rng):
    items = [[rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments]]
    items += [[rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments]]
    _, jacobians = model.jac(*items[0])
    for index in range(len(items[0])):
        numerical = differences(model, items[0], index)
        assert jacobians[index] == pytest.approx(numerical, abs=1e-7 * max(1, np.abs(numerical).max()))
    value, many = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, single = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-12)
        assert many[0][n] == pytest.approx(single[0], abs=1e-11 * max(1, np.abs(single[0]).max()))


@every_kind
def test_what_a_camera_initializes_it_sees_where_it_was(kind, rng):
    for w in (0.01, 0.2, 3.0):
        camera, point = Pose.random(rng), ray(rng, w)
        again = kind.to_frame(camera, kind.from_frame(camera, point))
        assert again[:3] / np.linalg.norm(again[:3]) == pytest.approx(point[:3], abs=1e-12)
        assert again[3] / np.linalg.norm(again[:3]) == pytest.approx(w, rel=1e-12)


@every_kind
def test_another_camera_sees_the_euclidean_point(kind, rng):
    for _ in range(20):
        _, landmark = seen(kind, rng)
        other, point = Pose.random(rng), kind.to_point(landmark)
        found = kind.to_frame(other, landmark)
        assert found[:3] / found[3] == pytest.approx(frames.to_frame(other, point), abs=1e-10)


@infinite_kind
def test_points_at_infinity_turn_and_do_not_move(kind, rng):
    camera, landmark = seen(kind, rng, w=0.0)
    moved = camera + np.array([5.0, -2, 1, 0, 0, 0, 0])
    here, J = kind.to_frame.jac(camera, landmark)
    assert np.isfinite(J.landmark).all()
    assert here[3] == 0
    assert kind.to_frame(moved, landmark) == pytest.approx(here, abs=1e-14)
    assert J.pose[:, :3] == pytest.approx(np.zeros((4, 3)), abs=1e-15)
    with pytest.raises(SingularPointError):
        kind.to_point(landmark)


@infinite_kind
def test_nothing_jumps_where_the_inverse_distance_changes_sign(kind, rng):
    camera = Pose.random(rng)
    point, other = ray(rng), Pose.random(rng)
    sides = [kind.to_frame(other, kind.from_frame(camera, np.array([*point[:3], w]))) for w in (-1e-9, 1e-9)]
    assert sides[0] == pytest.approx(sides[1], abs=1e-7)


def test_a_euclidean_point_cannot_be_initialized_at_infinity(rng):
    with pytest.raises(SingularPointError):
        EUC_POINT.from_frame(Pose.random(rng), ray(rng, 0.0))


def test_the_ray_of_the_image_centre_is_an_ordinary_one():
    """Errata E60: elevation and azimuth are taken in the world, where the optical axis is not vertical."""
    ahead = np.array([0.0, 0, 0, 0.5, -0.5, 0.5, -0.5])  # camera axes right, down, front, on a robot's front, left, up
    for kind in KINDS:
        model = kind.from_frame
        _, J = model.jac(ahead, np.array([0.0, 0, 1, 0.1]))
        for index in range(2):
            numerical = central_difference(model, [ahead, np.array([0.0, 0, 1, 0.1])], index)
            assert J[index] == pytest.approx(numerical, abs=1e-6 * max(1, np.abs(numerical).max()))


def test_straight_up_has_no_azimuth():
    with pytest.raises(SingularPointError):
        IDP_POINT.from_frame.jac(np.array([0.0, 0, 0, 1, 0, 0, 0]), np.array([0.0, 0, 1, 0.1]))


@every_kind
def test_single_precision(kind, rng):
    camera, landmark = seen(kind, rng)
    exact = kind.to_frame(camera, landmark)
    single = kind.to_frame(camera.astype(np.float32), landmark.astype(np.float32)[None])
    assert single.dtype == np.float32
    assert single[0] == pytest.approx(exact, abs=1e-5 * max(1, np.abs(landmark).max()))


def test_homogeneous_is_a_linear_function_of_anchored(rng):
    """So that with known cameras both are one and the same filter (chapter points)."""
    camera, point = Pose.random(rng), ray(rng)
    anchor, m, w = np.split(AHM_POINT.from_frame(camera, point), [3, 6])
    assert HMG_POINT.from_frame(camera, point) == pytest.approx(np.concatenate([m + w * anchor, w]), abs=1e-14)


def test_seen_from_the_side_the_image_is_linear_in_a_framed_point(rng):
    camera = Pose.random(rng)
    side = frames.compose(camera, np.array([0.7, -0.2, 0.0, 1, 0, 0, 0]))
    u, v, w = 0.3, -0.1, 0.4
    h = FHM_POINT.to_frame(side, np.concatenate([camera, [u, v, w]]))
    assert h == pytest.approx(np.array([u - 0.7 * w, v + 0.2 * w, 1, w]), abs=1e-14)


# --- linearity -------------------------------------------------------------------------------------------------------


def test_index_of_a_euclidean_point_is_the_relative_error_of_its_distance(rng):
    camera, point, P = Pose.random(rng), rng.standard_normal(3) + 5, spread(3, rng)
    r = point - camera[:3]
    n = r / np.linalg.norm(r)
    expected = 4 * np.sqrt(n @ P @ n) / np.linalg.norm(r)
    assert linearity_index(EUC_POINT, point, P, camera) == pytest.approx(expected, rel=1e-12)
    assert euclidean_index(EUC_POINT, point, P, camera) == pytest.approx(expected, rel=1e-12)


@every_kind
def test_index_after_conversion_is_that_of_the_converted_point(kind, rng):
    for _ in range(10):
        _, landmark = seen(kind, rng)
        other, P = Pose.random(rng), spread(kind.manifold.dof, rng)
        point, J = kind.to_point.jac(landmark)
        expected = linearity_index(EUC_POINT, point, J.landmark @ P @ J.landmark.T, other)
        assert euclidean_index(kind, landmark, P, other) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("kind", [AHM_POINT, IDP_POINT], ids=lambda k: k.name)
def test_the_toolboxs_rule_is_the_special_case_of_an_uncertain_inverse_distance(kind, rng):
    """4 sigma_d |cos| / d1, sigma_d = sigma_rho / rho^2."""
    for _ in range(10):
        _, landmark = seen(kind, rng)
        other, sigma = Pose.random(rng), 0.03
        P = np.zeros((kind.manifold.dof, kind.manifold.dof))
        P[-1, -1] = sigma**2
        p, rho = kind.to_point(landmark), landmark[-1]
        m = (p - landmark[:3]) * rho
        r = p - other[:3]
        d1 = np.linalg.norm(r)
        assert np.linalg.norm(m) == pytest.approx(1)
        expected = 4 * sigma / rho**2 / d1 * abs(m @ r) / d1
        assert euclidean_index(kind, landmark, P, other) == pytest.approx(expected, rel=1e-9)
        own = 4 * sigma / rho * abs(1 - m @ r / (rho * d1 * d1))  # Civera's for the inverse distance
        assert linearity_index(kind, landmark, P, other) == pytest.approx(own, rel=1e-9)


@every_kind
def test_the_index_bounds_how_the_image_bends(kind, rng):
    """Its definition: second derivative times two sigmas, by the first, along the uncertainty."""
    camera, landmark = seen(kind, rng)
    other = camera + np.array([0.3, -0.2, 0.1, 0, 0, 0, 0])
    step = np.zeros(kind.manifold.dof)
    step[-1] = 1.0
    h = kind.to_frame(other, landmark)[:3]
    n = h / np.linalg.norm(h)
    across = np.cross(n, rng.standard_normal(3))

    def image(s):
        moved = kind.to_frame(other, kind.manifold.plus(landmark, s * step))[:3]
        return moved @ across / (moved @ n)

    e, sigma = 1e-3 * np.abs(landmark[-1]), 0.02
    first, second = (image(e) - image(-e)) / (2 * e), (image(e) - 2 * image(0) + image(-e)) / e**2
    P = sigma**2 * np.outer(step, step)
    assert linearity_index(kind, landmark, P, other) == pytest.approx(abs(second / first) * 2 * sigma, rel=1e-3)


def test_an_error_that_camera_and_point_share_does_not_count(rng):
    camera, point = Pose.random(rng), rng.standard_normal(3) + 5
    drift = np.vstack([np.eye(3), np.eye(3), np.zeros((3, 3))])  # both displaced alike
    P = drift @ drift.T
    assert linearity_index(EUC_POINT, point, P[:3, :3], camera) > 0.1
    assert linearity_index(EUC_POINT, point, P, camera) == pytest.approx(0, abs=1e-6)


def test_points_beyond_infinity_are_not_converted_and_deleted_only_when_sure(rng):
    camera, landmark = seen(IDP_POINT, rng)
    P = 1e-4 * np.eye(6)
    for rho, beyond in ((0.5, False), (0.0, False), (-0.02, False), (-0.031, True)):
        landmark[-1] = rho
        other = camera + np.array([1.0, 0, 0, 0, 0, 0, 0])
        assert should_convert(IDP_POINT, landmark, P, other) == (rho > 0.4)
        assert beyond_infinity(IDP_POINT, landmark, P) == beyond
        assert np.isinf(euclidean_index(IDP_POINT, landmark, P, other)) == (rho <= 0)
    assert not beyond_infinity(EUC_POINT, np.ones(3), np.eye(3))


def test_the_indices_broadcast(rng):
    camera = Pose.random(rng)
    landmarks = np.array([FHM_POINT.from_frame(camera, ray(rng)) for _ in range(4)])
    P = np.array([spread(15, rng) for _ in range(4)])
    for function in (linearity_index, euclidean_index, should_convert):
        many = function(FHM_POINT, landmarks, P, camera)
        assert many == pytest.approx(
            [float(function(FHM_POINT, x, p, camera)) for x, p in zip(landmarks, P, strict=True)]
        )
    assert np.isinf(linearity_index(EUC_POINT, camera[:3], np.eye(3), camera))


def test_clear_errors(rng):
    with pytest.raises(ShapeError, match=r"covariance of idpPnt should have shape \(..., 6, 6\), or \(..., 12, 12\)"):
        linearity_index(IDP_POINT, np.ones(6), np.eye(3), Pose.random(rng))
    for nearest in (0, -1, np.inf):
        with pytest.raises(SlamlibError, match="nearest distance should be positive"):
            inverse_distance_prior(nearest)


def test_the_prior_reaches_from_the_nearest_distance_to_infinity():
    mean, sigma = inverse_distance_prior(0.8)
    assert mean - 2 * sigma == pytest.approx(0)
    assert 1 / (mean + 2 * sigma) == pytest.approx(0.8)


@every_kind
def test_conversion_in_the_map_is_first_order_exact(kind, rng):
    """Belief.replace with to_point: covariance J P J', cross terms too, and the handle stays valid."""
    camera = Pose.random(rng)
    belief = Belief()
    robot = belief.add(Pose, camera, 0.01 * np.eye(6))
    point, J = kind.from_frame.jac(camera, ray(rng))
    noise = J.point @ (1e-4 * np.eye(4)) @ J.point.T
    block = belief.add(kind.manifold, point, noise, given=[robot], jacobians=[J.pose])
    before, cross = belief.covariance(block), belief.covariance(block, robot)
    euclid, by = to_euclidean(kind, block.mean)
    belief.replace(block, 3, euclid, by)
    assert block.manifold.dof == 3
    assert block.mean == pytest.approx(kind.to_point(point), abs=1e-14)
    assert belief.covariance(block) == pytest.approx(by @ before @ by.T, abs=1e-12)
    assert belief.covariance(block, robot) == pytest.approx(by @ cross, abs=1e-12)


def test_points_of_one_picture_may_share_their_frame(rng):
    """One clone of the camera with points of three numbers is the same map as a clone for each point."""
    start, spread_of_pose = Pose.random(rng), np.diag([0.02, 0.02, 0.02, 0.01, 0.01, 0.01]) ** 2
    noise = np.diag([1e-5, 1e-5, 0.06])
    shared, single = Belief(), Belief()
    robots = [b.add(Pose, start, spread_of_pose) for b in (shared, single)]
    frame = shared.add(Pose, start, np.zeros((6, 6)), given=[robots[0]], jacobians=[np.eye(6)])
    own = np.zeros((9, 9))
    own[6:, 6:] = noise
    points, framed = [], []
    for u in (-0.2, 0.1, 0.3):
        image = np.array([u, 0.1, 0.5])
        points.append(shared.add(3, image, noise))
        mean = np.concatenate([start, image])
        framed.append(single.add(FHM_POINT.manifold, mean, own, given=[robots[1]], jacobians=[np.eye(9, 6)]))
    assert (shared.size, single.size) == (6 + 6 + 9, 6 + 27)
    moved = frames.compose(start, np.array([0.3, 0.1, 0.0, 1, 0, 0, 0]))
    for belief, robot in zip((shared, single), robots, strict=True):
        belief.predict(robot, moved, np.eye(6), spread_of_pose)
    k = [320.0, 240, 320, 320]
    for n, shift in enumerate((2.0, -1.0, 0.5)):
        for belief, robot, mark in (
            (shared, robots[0], np.concatenate([frame.mean, points[n].mean])),
            (single, robots[1], framed[n].mean),
        ):
            point, J = FHM_POINT.to_frame.jac(robot.mean, mark)
            value, by = _pixel(point, k)
            H = by @ J.landmark
            blocks = [frame, points[n]] if belief is shared else [framed[n]]
            parts = [H[:, :6], H[:, 6:]] if belief is shared else [H]
            truth = _pixel(FHM_POINT.to_frame(moved, np.array([*start, (-0.2, 0.1, 0.3)[n], 0.1, 0.2])), k)[0]
            belief.update([robot, *blocks], [by @ J.pose, *parts], truth + shift - value, np.eye(2))
    assert robots[0].mean == pytest.approx(robots[1].mean, abs=1e-10)
    for point, whole in zip(points, framed, strict=True):
        assert np.concatenate([frame.mean, point.mean]) == pytest.approx(whole.mean, abs=1e-9)


# --- the toolbox's numbers -------------------------------------------------------------------------------------------


def _pixel(point, k):
    """Pin-hole without distortion, and its Jacobian by the homogeneous point."""
    x, y, z, _ = point
    J = np.array([[k[2] / z, 0, -k[2] * x / z**2, 0], [0, k[3] / z, -k[3] * y / z**2, 0]])
    return np.array([k[0] + k[2] * x / z, k[1] + k[3] * y / z]), J


def _back(pixel, w, k):
    """Unit ray with the inverse distance, and the Jacobian by the pixel."""
    h = np.array([(pixel[0] - k[0]) / k[2], (pixel[1] - k[1]) / k[3], 1])
    n = np.linalg.norm(h)
    by_h = np.eye(3) / n - np.outer(h, h) / n**3
    return np.array([*(h / n), w]), by_h @ np.array([[1 / k[2], 0], [0, 1 / k[3]], [0, 0]])


def _tangent(stored, frame):
    """Columns by the seven stored numbers of a pose, on its six-dimensional tangent space."""
    return np.hstack([stored[:, :3], stored[:, 3:] @ quaternion.pi_matrix(frame[3:]) / 2])


@pytest.mark.parametrize(
    ("kind", "name"), [(EUC_POINT, "Euc"), (IDP_POINT, "Idp"), (HMG_POINT, "Hmg"), (AHM_POINT, "Ahm")]
)
def test_projection_agrees_with_the_toolbox(kind, name):
    for given, wanted in cases("proj_points", f"proj{name}PntIntoPinHoleOnRob_nodist"):
        camera, by = frames.compose.jac(given["Rf"], given["Sf"])
        point, J = kind.to_frame.jac(camera, given["l"])
        pixel, P = _pixel(point, given["k"])
        assert pixel == pytest.approx(wanted["u"], abs=1e-9)
        assert P @ J.landmark == pytest.approx(wanted["U_l"], rel=1e-9, abs=1e-9)
        assert P @ J.pose @ by.outer == pytest.approx(_tangent(wanted["U_rf"], given["Rf"]), rel=1e-9, abs=1e-8)
        assert P @ J.pose @ by.inner == pytest.approx(_tangent(wanted["U_sf"], given["Sf"]), rel=1e-9, abs=1e-8)


@pytest.mark.parametrize(("kind", "name"), [(IDP_POINT, "Idp"), (HMG_POINT, "Hmg"), (AHM_POINT, "Ahm")])
def test_back_projection_agrees_with_the_toolbox(kind, name):
    for given, wanted in cases("retroproj_points", f"retroProj{name}PntFromPinHoleOnRob_nodist"):
        camera, by = frames.compose.jac(given["Rf"], given["Sf"])
        point, by_pixel = _back(given["u"], given["n"], given["k"])
        landmark, J = kind.from_frame.jac(camera, point)
        assert landmark == pytest.approx(wanted["l"], abs=1e-10)
        assert J.pose @ by.outer == pytest.approx(_tangent(wanted["L_rf"], given["Rf"]), abs=1e-9)
        assert J.pose @ by.inner == pytest.approx(_tangent(wanted["L_sf"], given["Sf"]), abs=1e-9)
        assert J.point[:, 3] == pytest.approx(np.ravel(wanted["L_n"]), abs=1e-10)
        if kind is IDP_POINT:  # for the others the toolbox's Jacobian of a normalised vector is an approximate one
            assert J.point[:, :3] @ by_pixel == pytest.approx(wanted["L_u"], abs=1e-9)


@pytest.mark.parametrize(
    ("kind", "function", "argument"),
    [(IDP_POINT, "idp2euc", "idp"), (AHM_POINT, "ahm2euc", "ahm"), (HMG_POINT, "hmg2euc", "hm")],
)
def test_conversion_agrees_with_the_toolbox(kind, function, argument):
    for given, wanted in cases("points", function):
        point, J = kind.to_point.jac(given[argument])
        assert point == pytest.approx(wanted["p"], abs=1e-10)
        assert J.landmark == pytest.approx(wanted[f"P_{argument}"], rel=1e-10, abs=1e-10)


def test_directions_and_angles_agree_with_the_toolbox():
    for given, wanted in cases("points", "py2vec"):
        v, J = direction.jac(given["py"])
        assert v == pytest.approx(wanted["v"], abs=1e-12)
        assert J.angles == pytest.approx(wanted["V_py"], abs=1e-12)
    for given, wanted in cases("points", "vec2py"):
        py, J = angles_of.jac(given["v"])
        assert py == pytest.approx(wanted["py"], abs=1e-12)
        assert J.vector == pytest.approx(wanted["PY_v"], abs=1e-12)
