"""Lines: the five parametrizations, innovations, segments and endpoints; against independent routes and the toolbox."""

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.codegen import check_model
from slamlib.entities import Landmark
from slamlib.errors import SingularPointError, SlamlibError
from slamlib.geometry import plucker
from slamlib.geometry import pose as frames
from slamlib.geometry.pose import Pose, compose
from slamlib.geometry.quaternion import pi_matrix
from slamlib.landmarks import LINES, ahm_line, apl_line, endpoints, hmg_line, idp_line, line_innovation, plk_line
from slamlib.landmarks import segments as seg
from slamlib.landmarks.endpoints import EndpointExtension, ObservedEndpoints
from slamlib.models import Model
from slamlib.observation import FAMILIES
from slamlib.observation.lines import distort_segments, observe_line, undistort_segments
from slamlib.observation.segments import endpoints_converged, project_endpoints
from slamlib.sensors import Calibration
from slamlib.sensors.pinhole import PINHOLE
from slamlib.slam import Options
from slamlib.tests.differences import differences
from slamlib.tests.reference import cases

MODULES = (plucker, plk_line, apl_line, hmg_line, ahm_line, idp_line, line_innovation)
MODELS = [v for m in MODULES for v in vars(m).values() if isinstance(v, Model) and v.module == m.__name__]
KINDS = list(LINES.values())
TWO_POINT = ["hmgLin", "ahmLin", "idpLin"]
K, IMAGE = np.array([320.0, 240, 330, 310]), (640, 480)


@pytest.fixture
def rng():
    return np.random.default_rng(12)


def name(model):
    return f"{model.module.split('.')[-1]}.{model.name}"


def camera_line(pixels):
    """Unit rays (6,) of a segment, and its normal."""
    rays = np.array([[(u - K[0]) / K[2], (v - K[1]) / K[3], 1] for u, v in np.reshape(pixels, (2, 2))])
    return (rays / np.linalg.norm(rays, axis=1)[:, None]).ravel()


def matrix_of(k):
    """The image line is this matrix times the moment: derived in chapter pinhole."""
    u, v, fu, fv = k
    return np.array([[fv, 0, 0], [0, fu, 0], [-fv * u, -fu * v, fu * fv]])


def proportional(a, b):
    """The same ratios of numbers, up to a sign."""
    a, b = (x / np.linalg.norm(x) for x in (a, b))
    return min(np.abs(a - b).max(), np.abs(a + b).max())


# -- every model -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", MODELS, ids=name)
def test_value_and_jacobians_are_those_of_the_definition(model):
    check_model(model, silent=True)


@pytest.mark.parametrize("model", MODELS, ids=name)
def test_central_differences_and_a_batch_agree(model, rng):
    items = [
        [rng.standard_normal(a.shape) if a.manifold is None else a.manifold.random(rng) for a in model.arguments]
        for _ in range(4)
    ]
    for item in items:
        _, jacobians = model.jac(*item)
        for index in range(len(item)):
            numerical = differences(model, item, index)
            assert jacobians[index] == pytest.approx(numerical, abs=1e-6 * max(1, np.abs(numerical).max()))
    value, many = model.jac(*(np.array([item[k] for item in items]) for k in range(len(items[0]))))
    for n, item in enumerate(items):
        one, single = model.jac(*item)
        assert model(*item) == pytest.approx(one, rel=1e-12, abs=1e-13)
        assert value[n] == pytest.approx(one, abs=1e-12, rel=1e-12)
        for a, b in zip(many, single, strict=True):
            assert a[n] == pytest.approx(b, abs=1e-11 * max(1, np.abs(b).max()))


# -- Pluecker coordinates ----------------------------------------------------------------------------------------------


def test_a_line_holds_its_points_and_obeys_the_constraint(rng):
    p, q = rng.standard_normal((2, 3))
    line = plucker.join([*p, 1], [*q, 1])
    assert line[:3] == pytest.approx(np.cross(p, q))
    assert line[3:] == pytest.approx(q - p)
    assert line[:3] @ line[3:] == pytest.approx(0, abs=1e-15)
    for s in (-2.0, 0.0, 0.7):
        assert np.cross(p + s * (q - p), line[3:]) == pytest.approx(line[:3], abs=1e-14)
        h = plucker.point_at(line, s)
        assert np.cross(h[:3], line[3:]) == pytest.approx(h[3] * line[:3], abs=1e-12)
    foot, ahead = (plucker.point_at(line, s)[:3] / plucker.point_at(line, s)[3] for s in (0.0, 2.5))
    assert foot @ line[3:] == pytest.approx(0, abs=1e-14)
    assert np.linalg.norm(foot) == pytest.approx(np.linalg.norm(line[:3]) / np.linalg.norm(line[3:]))
    assert np.linalg.norm(ahead - foot) == pytest.approx(2.5)


def test_join_and_meet_work_at_infinity(rng):
    p, d, plane = rng.standard_normal(3), rng.standard_normal(3), rng.standard_normal(4)
    line = plucker.join([*p, 1], [*d, 0])
    assert proportional(line, np.concatenate([np.cross(p, d), d])) < 1e-15
    point = plucker.meet(line, plane)
    assert plane @ point == pytest.approx(0, abs=1e-14)
    assert np.cross(point[:3], line[3:]) == pytest.approx(point[3] * line[:3], abs=1e-14)
    assert plucker.meet(line, [0, 0, 0, 1]) == pytest.approx([*-line[3:], 0])


def test_lines_move_as_their_points_do(rng):
    pose, p, q = Pose.random(rng), *rng.standard_normal((2, 3))
    line = plucker.join([*p, 1], [*q, 1])
    moved = plucker.join([*frames.from_frame(pose, p), 1], [*frames.from_frame(pose, q), 1])
    assert plucker.from_frame(pose, line) == pytest.approx(moved, abs=1e-13)
    assert plucker.to_frame(pose, moved) == pytest.approx(line, abs=1e-13)


def test_a_rays_crossing_is_its_intersection_and_else_in_the_lines_plane(rng):
    line = plucker.join([*rng.standard_normal(3), 1], [*rng.standard_normal(3), 1])
    target = plucker.point_at(line, 0.4)
    exact = target[:3] / target[3]
    for ray in (exact, exact + 0.3 * line[:3]):
        found = plucker.crossing(line, ray)
        assert found[:3] / found[3] == pytest.approx(exact, abs=1e-12)
        assert found[3] > 0
    assert plucker.crossing(line, -exact)[3] < 0
    assert plucker.crossing(line, line[3:])[3] == pytest.approx(0, abs=1e-14)


def test_from_rays_gives_a_line_in_the_plane_of_the_rays_at_the_distance_of_the_slopes(rng):
    for _ in range(5):
        rays = rng.standard_normal((2, 3))
        rays /= np.linalg.norm(rays, axis=1)[:, None]
        slopes = rng.standard_normal(2)
        line = plucker.from_rays(rays.ravel(), slopes)
        n, v = line[:3], line[3:]
        assert np.array([n @ rays[0], n @ rays[1], n @ v]) == pytest.approx(np.zeros(3), abs=1e-15)
        assert np.linalg.norm(n) / np.linalg.norm(v) == pytest.approx(1 / np.linalg.norm(slopes))
        flat = plucker.point_at(plucker.from_rays(rays.ravel(), [0.1, 0]), 0.0)
        middle = rays.sum(0) / np.linalg.norm(rays.sum(0))
        assert flat[:3] / flat[3] == pytest.approx(10 * middle)
        tilted = plucker.from_rays(rays.ravel(), [0, 1])[3:]
        assert tilted == pytest.approx(-middle, abs=1e-12)
    with pytest.raises(SingularPointError):
        plucker.from_rays([0, 0, 1, 0, 0, 1], [0.1, 0])


# -- the constraint ----------------------------------------------------------------------------------------------------


def test_the_projection_keeps_the_constraint_the_view_and_the_tangent(rng):
    for _ in range(5):
        line, eye = rng.standard_normal(6), rng.standard_normal(3)
        there, J = plucker.constrain.jac(line, eye)
        assert there[:3] @ there[3:] == pytest.approx(0, abs=1e-14)
        seen = line[:3] - np.cross(eye, line[3:])
        assert there[:3] - np.cross(eye, there[3:]) == pytest.approx(seen, abs=1e-13)
        assert there[3:] - line[3:] == pytest.approx(-seen * (seen @ line[3:]) / (seen @ seen), abs=1e-13)
        again, J2 = plucker.constrain.jac(there, eye)
        assert again == pytest.approx(there, abs=1e-13)
        assert J2.line @ J2.line == pytest.approx(J2.line, abs=1e-11)
        assert J2.eye == pytest.approx(np.zeros((6, 3)), abs=1e-12)
        normal = np.concatenate([there[3:], there[:3]])
        assert normal @ J.line == pytest.approx(np.zeros(6), abs=1e-11)
        anchored = apl_line.constrain(np.concatenate([eye * 2, line[:3] - np.cross(2 * eye, line[3:]), line[3:]]), eye)
        assert plucker.point_at(there, 0.3) == pytest.approx(apl_line.point_at(anchored, 0.3), abs=1e-11)


def test_the_projection_does_not_depend_on_the_frame(rng):
    pose, line, eye = Pose.random(rng), rng.standard_normal(6), rng.standard_normal(3)
    moved = plucker.constrain(plucker.from_frame(pose, line), frames.from_frame(pose, eye))
    assert moved == pytest.approx(plucker.from_frame(pose, plucker.constrain(line, eye)), abs=1e-12)


# -- five parametrizations ---------------------------------------------------------------------------------------------


def test_all_five_are_found_by_the_toolboxs_names():
    assert sorted(LINES) == ["ahmLin", "aplLin", "hmgLin", "idpLin", "plkLin"]
    assert [LINES[n].manifold.size for n in ("plkLin", "aplLin", "hmgLin", "ahmLin", "idpLin")] == [6, 9, 8, 11, 9]


@pytest.mark.parametrize("kind", KINDS, ids=lambda k: k.name)
def test_an_initialized_line_is_seen_where_it_was_measured_and_behaves_as_its_points(kind, rng):
    for _ in range(5):
        camera, rays = Pose.random(rng), camera_line(rng.uniform([0, 0, 320, 0], [300, 480, 640, 480]))
        landmark = kind.from_frame(camera, rays, rng.uniform(0.05, 0.5, 2))
        line = kind.to_frame(camera, landmark)
        assert line_innovation.angles(line, rays) == pytest.approx(np.zeros(2), abs=1e-14)
        other = Pose.random(rng)
        end_points = endpoints.endpoints_at(kind, landmark, (0.2, 1.3))
        direct = plucker.join(*(np.array([*frames.to_frame(other, e[:3] / e[3]), 1]) for e in end_points))
        assert proportional(direct, kind.to_frame(other, landmark)) < 1e-12


@pytest.mark.parametrize("name", TWO_POINT)
def test_a_line_of_two_points_holds_its_endpoints_at_zero_and_one(name, rng):
    kind, camera, rays = LINES[name], Pose.random(rng), camera_line([100, 100, 500, 300])
    landmark = kind.from_frame(camera, rays, [0.2, 0.1])
    end_points = endpoints.endpoints_at(kind, landmark, kind.abscissas)
    for end, ray, distance in zip(end_points, rays.reshape(2, 3), (5, 10), strict=True):
        assert frames.to_frame(camera, end[:3] / end[3]) == pytest.approx(distance * ray, abs=1e-12)


@pytest.mark.parametrize("name", TWO_POINT)
@pytest.mark.parametrize("prior", [(0, 0.1), (0.1, 0), (0, 0)])
def test_inverse_distance_zero_is_an_ordinary_place(name, prior, rng):
    kind, camera, rays = LINES[name], Pose.random(rng), camera_line([100, 100, 500, 300])
    landmark = kind.from_frame(camera, rays, prior)
    line, J = kind.to_frame.jac(Pose.random(rng), landmark)
    assert np.isfinite(line).all()
    assert np.isfinite(J.landmark).all()
    seen, _ = kind.to_frame.jac(camera, landmark)
    assert line_innovation.angles(seen, rays) == pytest.approx(np.zeros(2), abs=1e-14)


@pytest.mark.parametrize("kind", KINDS, ids=lambda k: k.name)
def test_single_precision_is_kept_within_its_own_accuracy(kind, rng):
    camera, rays = Pose.random(rng), camera_line([100, 100, 500, 300])
    landmark = kind.from_frame(camera, rays, [0.2, 0.1])
    exact = kind.to_frame(camera, landmark)
    single = kind.to_frame(camera.astype(np.float32), landmark.astype(np.float32)[None])[0]
    assert single.dtype == np.float32
    assert single == pytest.approx(exact, abs=3e-6 * np.abs(landmark).max() ** 2)


# -- innovations -------------------------------------------------------------------------------------------------------


def test_a_line_through_its_own_segment_has_no_innovation_and_signs_are_consistent():
    segment = np.array([100.0, 100, 500, 300])
    line = line_innovation.image_line(segment)
    assert line_innovation.distances(line, segment) == pytest.approx([0, 0], abs=1e-12)
    assert line_innovation.rho_theta(line, segment, [320, 240]) == pytest.approx([0, 0], abs=1e-12)
    shifted = segment + np.array([0, 5, 0, 5])
    cosine = 400 / np.hypot(400, 200)
    assert np.abs(line_innovation.distances(line, shifted)) == pytest.approx(5 * cosine)
    assert line_innovation.distances(3 * line, shifted) == pytest.approx(line_innovation.distances(line, shifted))
    assert line_innovation.distances(-line, shifted) == pytest.approx(-line_innovation.distances(line, shifted))


def test_both_innovations_weigh_alike(rng):
    for size, tolerance in ((1e-4, 1e-6), (1e-2, 1e-4)):
        segment = np.array([100.0, 100, 500, 300]) + 50 * rng.standard_normal(4)
        line = line_innovation.image_line(segment + size * rng.standard_normal(4))
        d, D = line_innovation.distances.jac(line, segment)
        weighed = d @ np.linalg.solve(D.segment @ D.segment.T, d)
        for origin in ([0, 0], [320, 240], segment[:2]):
            z, J = line_innovation.rho_theta.jac(line_innovation.oriented(-line, segment), segment, origin)
            assert line_innovation.rho_theta(line, segment, origin) == pytest.approx(z, abs=1e-9)
            assert z @ np.linalg.solve(J.segment @ J.segment.T, z) == pytest.approx(weighed, rel=tolerance)


def test_a_segment_along_a_line_through_the_image_centre_is_no_special_place():
    segment = np.array([320.0, 240, 420, 340])
    for model, more in ((line_innovation.distances, ()), (line_innovation.rho_theta, (K[:2],))):
        value, J = model.jac(line_innovation.image_line(segment), segment, *more)
        assert value == pytest.approx([0, 0], abs=1e-10)
        assert all(np.isfinite(j).all() for j in J)


def test_pixels_and_rays_agree_to_the_focal_length():
    segment = np.array([250.0, 200, 380, 260])
    rays, shifted = camera_line(segment), camera_line(segment + np.array([0, 1e-3, 0, 1e-3]))
    line = plucker.from_rays(rays, [0.1, 0])
    pixels = line_innovation.distances(matrix_of(K) @ line[:3], segment + np.array([0, 1e-3, 0, 1e-3]))
    assert np.abs(line_innovation.angles(line, shifted)) == pytest.approx(np.abs(pixels) / 320, rel=0.1)


# -- segments ----------------------------------------------------------------------------------------------------------


def homogeneous(*point):
    return np.array([*point, 1.0])


def test_a_segment_is_cut_at_the_image_and_behind_the_camera():
    left, right = homogeneous(-50, 0, 4), homogeneous(50, 1, 4)
    found = seg.visible(left, right, K, IMAGE)
    assert found.seen
    assert found.pixels[[0, 2]] == pytest.approx([0, 640], abs=1e-9)
    behind = seg.visible(homogeneous(0, 1, -3), homogeneous(0, 1, 20), K, IMAGE)
    assert behind.pixels == pytest.approx([320, 480, 320, 240 + 310 / 20])
    assert not seg.visible(homogeneous(0, 1, -3), homogeneous(1, 1, -1), K, IMAGE).seen
    assert not seg.visible(homogeneous(-3, 0, 1), homogeneous(0, 0, -1), K, IMAGE).seen


def test_half_lines_end_at_their_vanishing_point_and_inverse_distances_below_zero_change_the_sign_of_nothing():
    away = seg.visible(homogeneous(0, 1, 5), np.array([0.1, 0, 1, 0]), K, IMAGE)
    assert away.pixels[2:] == pytest.approx([320 + 33, 240])
    point = homogeneous(1, 1, 5)
    same = seg.visible(-point, homogeneous(0, 0, 5), K, IMAGE)
    assert same.pixels == pytest.approx(seg.visible(point, homogeneous(0, 0, 5), K, IMAGE).pixels)


def test_a_cut_segment_is_that_of_dense_samples(rng):
    for _ in range(200):
        p, q = rng.uniform(-6, 6, (2, 3))
        found = seg.visible(homogeneous(*p), homogeneous(*q), K, IMAGE, minimum_length=0)
        s = np.linspace(0, 1, 4001)[:, None]
        points = (1 - s) * p + s * q
        points = points[points[:, 2] > 0]
        pixels = K[:2] + K[2:] * points[:, :2] / points[:, 2:]
        inside = pixels[((pixels >= 0) & (pixels <= IMAGE)).all(1)]
        if len(inside) > 1:
            assert found.seen
            assert np.array([inside[0], inside[-1]]).ravel() == pytest.approx(found.pixels, abs=30)
            outside = seg.visible(
                homogeneous(*p), homogeneous(*q), K, IMAGE, minimum_length=seg.length(found.pixels) + 1
            )
            assert not outside.seen


def test_nothing_and_a_segment_through_the_eye_are_not_seen():
    assert not seg.visible(np.zeros(4), np.zeros(4), K, IMAGE).seen
    assert not seg.visible(homogeneous(0, 0, -1), homogeneous(0, 0, 1), K, IMAGE).seen
    assert not seg.visible(np.zeros(4), homogeneous(0, 0, 3), K, IMAGE, minimum_length=0.1).seen


def test_trim_and_span_of_pixels():
    found = seg.trim(np.array([[-100.0, 240, 1000, 240], [10, 10, 20, 20], [-5, -5, -1, 700]]), IMAGE)
    assert found.pixels[:2] == pytest.approx(np.array([[0.0, 240, 640, 240], [10, 10, 20, 20]]))
    assert found.seen.tolist() == [True, True, False]
    assert np.isnan(found.pixels[2]).all()
    whole = seg.span(np.array([[0.0, 1, -100], [1, 0, 5], [0, 0, 1]]), IMAGE)
    assert np.sort(whole.pixels[0, [0, 2]]) == pytest.approx([0, 640], abs=1e-9)
    assert whole.seen.tolist() == [True, False, False]
    with pytest.raises(SlamlibError, match="nothing inside a margin"):
        seg.trim(np.zeros(4), IMAGE, margin=300)


# -- endpoints ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS, ids=lambda k: k.name)
def test_measured_ends_are_found_on_the_landmark(kind, rng):
    camera = np.array([1.0, 2, 3, *rng.standard_normal(4)])
    camera[3:] /= np.linalg.norm(camera[3:])
    landmark = kind.from_frame(camera, camera_line([100, 100, 500, 300]), [0.2, 0.15])
    measured = camera_line([200, 150, 400, 250])
    found = endpoints.observed_endpoints(kind, landmark, camera, measured)
    assert found.usable
    for end, ray in zip(endpoints.endpoints_at(kind, landmark, found.abscissas), measured.reshape(2, 3), strict=True):
        there = frames.to_frame(camera, end[:3] / end[3])
        assert min(np.linalg.norm(there / np.linalg.norm(there) - r) for r in measured.reshape(2, 3)) < 1e-12
        assert ray @ there > 0
    assert endpoints.abscissas_of(
        kind, landmark, endpoints.endpoints_at(kind, landmark, found.abscissas)
    ) == pytest.approx(found.abscissas)
    both = endpoints.observed_endpoints(kind, np.array([landmark, landmark]), camera, np.array([measured, measured]))
    assert both.abscissas == pytest.approx(np.tile(found.abscissas, (2, 1)))


def test_rays_along_the_line_and_lines_behind_are_not_used():
    identity = np.array([0, 0, 0, 1.0, 0, 0, 0])
    along = hmg_line.from_frame(identity, [0, 0, 1, 0, 0, 1], [0.1, 0.1])
    assert not endpoints.observed_endpoints(hmg_line.HMG_LINE, along, identity, [0, 0, 1, 0, 0, 1]).usable
    deep = np.array([0.1, 0, 1, 1, 0.1, 0, 50, 1])
    assert not endpoints.observed_endpoints(hmg_line.HMG_LINE, deep, identity, [0.05, 0, 1, 0.002, 0, 1]).usable
    behind = np.array([-1.0, 0, -4, 1, 1, 0, -4, 1])
    assert not endpoints.observed_endpoints(
        hmg_line.HMG_LINE, behind, identity, camera_line([200, 240, 400, 240])
    ).usable


def test_the_extension_policies_and_their_switch():
    old, new = np.array([0.0, 1]), np.array([-0.5, 0.5])
    yes, no = ObservedEndpoints(new, np.True_), ObservedEndpoints(new, np.False_)
    assert EndpointExtension(extend=False).update(old, yes, 1.0).tolist() == [0, 1]
    assert EndpointExtension(switch=10).update(old, yes, 1.0).tolist() == [-0.5, 1]
    assert EndpointExtension(switch=10).update(old, yes, 10.0).tolist() == [-0.5, 0.5]
    assert EndpointExtension(switch=10).update(old, no, 1.0).tolist() == [0, 1]
    assert EndpointExtension(switch=0).update(old, yes, 0.0).tolist() == [-0.5, 0.5]
    assert EndpointExtension(switch=np.inf).update(old, yes, 1e9).tolist() == [-0.5, 1]
    both = EndpointExtension().update(
        np.array([old, old]), ObservedEndpoints(np.array([new, new]), np.array([True, True])), np.array([1, 99])
    )
    assert both.tolist() == [[-0.5, 1], [-0.5, 0.5]]
    assert endpoints.largest_std(np.diag([4.0, 9.0])) == pytest.approx(3)
    with pytest.raises(SlamlibError, match="standard deviation"):
        EndpointExtension(switch=-1)


# -- the toolbox's numbers ---------------------------------------------------------------------------------------------


def tangent(pose):
    """The stored seven numbers of a pose by the estimated six."""
    block = np.zeros((7, 6))
    block[:3, :3], block[3:, 3:] = np.eye(3), pi_matrix(pose[3:]) / 2
    return block


@pytest.mark.parametrize(
    ("function", "model", "inputs", "output", "jacobians"),
    [
        ("points2plucker", plucker.join, ["A", "B"], "L", {"L_a": "first", "L_b": "second"}),
        ("fromFramePlucker", plucker.from_frame, ["F", "L_F"], "L", {"L_f": "pose", "L_lf": "line"}),
        ("toFramePlucker", plucker.to_frame, ["F", "L"], "L_F", {"LF_f": "pose", "LF_l": "line"}),
    ],
)
def test_pluecker_agrees_with_the_toolbox(function, model, inputs, output, jacobians):
    for given, wanted in cases("lines", function):
        value, J = model.jac(*(given[i] for i in inputs))
        assert value == pytest.approx(wanted[output], abs=1e-11)
        for theirs, ours in jacobians.items():
            expected = wanted[theirs] @ tangent(given["F"]) if ours == "pose" else wanted[theirs]
            assert getattr(J, ours) == pytest.approx(expected, abs=1e-10)


@pytest.mark.parametrize(
    ("function", "kind"),
    [
        ("pluckerSegment", "plkLin"),
        ("aPluckerSegment", "aplLin"),
        ("hmgLinSegment", "hmgLin"),
        ("ahmLinSegment", "ahmLin"),
        ("idpLinSegment", "idpLin"),
    ],
)
def test_endpoints_agree_with_the_toolbox(function, kind):
    for given, wanted in cases("lines", function):
        state = next(v for k, v in given.items() if k != "t")
        points = endpoints.endpoints_at(LINES[kind], state, given["t"])
        assert (points[:, :3] / points[:, 3:]).ravel() == pytest.approx(wanted["s"], abs=1e-10)
        h, J = LINES[kind].point_at.jac(state[None], given["t"])
        by_state = J[0][..., :3, :] / h[..., 3:, None] - h[..., :3, None] * J[0][..., 3:, :] / h[..., 3:, None] ** 2
        assert by_state.reshape(6, -1) == pytest.approx(wanted["S_l"], abs=1e-9)


@pytest.mark.parametrize(
    ("function", "kind", "state", "jacobian"),
    [
        ("projPlkLinIntoPinHoleOnRob", "plkLin", "hm", "HM_l"),
        ("projAplLinIntoPinHoleOnRob", "aplLin", "hm", "HM_l"),
        ("projHmgLinIntoPinHoleOnRob", "hmgLin", "s", "S_l"),
        ("projAhmLinIntoPinHoleOnRob", "ahmLin", "s", "S_l"),
        ("projIdpLinIntoPinHoleOnRob", "idpLin", "s", "S_l"),
    ],
)
def test_projections_agree_with_the_toolbox(function, kind, state, jacobian):
    """Theirs ends in an image line, or in two pixels; ours in a moment, of which both are functions."""
    for given, wanted in cases("proj_lines", function):
        (camera, _), matrix = compose.jac(given["Rf"], given["Sf"]), matrix_of(given["k"])
        line, J = LINES[kind].to_frame.jac(camera, given["l"])
        ours, ours_by = matrix @ line[:3], matrix @ J.landmark[:3]
        if state == "hm":
            theirs, theirs_by = wanted["hm"], wanted[jacobian]
        else:
            theirs, by = line_innovation.image_line.jac(wanted["s"])
            theirs_by = by.segment @ wanted[jacobian]
        assert proportional(ours, theirs) < 1e-9
        segment = np.array([10.0, 20, 500, 300])  # what is left when the scale is: two distances from a segment
        d, D = line_innovation.distances.jac(ours, segment)
        e, E = line_innovation.distances.jac(theirs, segment)
        sign = np.sign(d @ e)
        assert d == pytest.approx(sign * e, abs=1e-8 * np.abs(d).max())
        assert D.line @ ours_by == pytest.approx(sign * E.line @ theirs_by, abs=1e-6 * np.abs(E.line @ theirs_by).max())


@pytest.mark.parametrize("kind", ["Hmg", "Ahm", "Idp"])
def test_initialized_two_point_lines_agree_with_the_toolbox(kind):
    for given, wanted in cases("retroproj_lines", f"retroProj{kind}LinFromPinHoleOnRob"):
        u, v, fu, fv = given["k"]
        pixels = given["seg"].reshape(2, 2)
        rays = np.array([[(a - u) / fu, (b - v) / fv, 1] for a, b in pixels])
        rays /= np.linalg.norm(rays, axis=1)[:, None]
        found = LINES[f"{kind.lower()}Lin"].from_frame(compose(given["Rf"], given["Sf"]), rays.ravel(), given["n"])
        assert found == pytest.approx(wanted["l"], abs=1e-11)


@pytest.mark.parametrize(("function", "kind"), [("Plk", "plkLin"), ("Apl", "aplLin")])
def test_initialized_pluecker_lines_agree_with_the_toolbox_in_our_base_of_the_plane(function, kind):
    for given, wanted in cases("retroproj_lines", f"retroProj{function}LinFromPinHoleOnRob"):
        camera, matrix = compose(given["Rf"], given["Sf"]), matrix_of(given["k"])
        normal = np.linalg.solve(matrix, given["hm"])
        normal /= np.linalg.norm(normal)
        along = np.array([normal[1], -normal[0], 0]) / np.hypot(*normal[:2])
        v = given["beta"][0] * along + given["beta"][1] * np.cross(normal, along)
        first = along - 2 * np.cross(normal, along)  # two rays in the plane, in the order of the line's direction
        rays = np.array([first, first + 3 * along])
        rays /= np.linalg.norm(rays, axis=1)[:, None]
        base = rays[1] - rays[0]
        base /= np.linalg.norm(base)
        moment = np.cross(*rays) / np.linalg.norm(np.cross(*rays))
        prior = np.array([base @ v, np.cross(moment, base) @ v])
        found = LINES[kind].from_frame(camera, rays.ravel(), prior)
        assert moment == pytest.approx(normal, abs=1e-12)
        assert found == pytest.approx(wanted["l"], abs=1e-10)


def test_distances_agree_with_the_toolbox():
    for given, wanted in cases("segments2d", "hms2hh"):
        value, J = line_innovation.distances.jac(given["hm"], given["seg"])
        assert value == pytest.approx(wanted["hh"], abs=1e-10)
        assert J.line == pytest.approx(wanted["HH_hm"], abs=1e-10)
        assert J.segment == pytest.approx(wanted["HH_s"], abs=1e-10)
    for given, wanted in cases("segments2d", "seg2hmgLin"):
        assert line_innovation.image_line(given["s"]) == pytest.approx(wanted["hm"], abs=1e-9)
        assert line_innovation.image_line.jac(given["s"])[1].segment == pytest.approx(wanted["HM_s"], abs=1e-9)


def test_rho_and_theta_of_a_segment_agree_with_the_toolbox():
    """Theirs are the two numbers of one line; ours the difference from another, here the vertical at zero."""
    for given, wanted in cases("segments2d", "seg2rt"):
        line = line_innovation.oriented(np.array([1.0, 0, 0]), given["s"])
        rho, turn = line_innovation.rho_theta(line, given["s"], np.zeros(2))
        theta = turn + np.arctan2(line[1], line[0])
        if rho < 0:
            rho, theta = -rho, theta + np.pi
        assert rho == pytest.approx(wanted["rt"][0], abs=1e-9)
        assert np.exp(1j * theta) == pytest.approx(np.exp(1j * wanted["rt"][1]), abs=1e-12)


def test_the_gate_agrees_with_the_toolbox():
    """Z and the squared Mahalanobis distance of the orthogonal distances."""
    for given, wanted in cases("segments2d", "innovation_ortDst"):
        d, J = line_innovation.distances.jac(given["e"], given["y"])
        S = J.line @ given["E"] @ J.line.T + J.segment @ given["R"] @ J.segment.T
        assert pytest.approx(wanted["Z"], abs=1e-9) == S
        assert d @ np.linalg.solve(S, d) == pytest.approx(wanted["MD2"])


def test_trimmed_segments_agree_with_the_toolbox():
    for given, wanted in cases("segments2d", "trimSegment"):
        found = seg.trim(given["s"], tuple(given["imSize"]), minimum_length=0)
        if wanted["e"].size:
            assert found.pixels == pytest.approx(wanted["e"], abs=1e-8)
        else:
            assert not found.seen


def test_crossings_agree_with_the_toolbox_where_the_ray_meets_the_line():
    """Seen from a point of the ray; for rays that miss, theirs depends on the origin, ours does not (chapter lines)."""
    for given, wanted in cases("lines", "intersectPlucker"):
        start = plucker.point_at(given["r"], -3.0)
        eye = np.array([*start[:3] / start[3], 1.0, 0, 0, 0])
        found = plucker.crossing(plucker.to_frame(eye, given["L"]), given["r"][3:])
        point = eye[:3] + found[:3] / found[3]
        assert point == pytest.approx(wanted["e"], abs=1e-9)
        kind = LINES["plkLin"]
        abscissa = endpoints.abscissas_of(kind, given["L"], np.array([[*point, 1.0]]))
        assert abscissa == pytest.approx([wanted["t"]], abs=1e-9)


# -- a camera sees lines -----------------------------------------------------------------------------------------------


def test_lines_are_observed_through_the_pixels_of_their_points(rng):
    camera = Calibration(PINHOLE, np.eye(2), image=IMAGE, intrinsics=K, distortion=[0.0])
    robot, extrinsics = Pose.random(rng), Pose.random(rng)
    points = np.append(rng.uniform([-1, -1, 2], [1, 1, 4], (3, 2, 3)), np.ones((3, 2, 1)), axis=-1)
    lines = [plucker.from_frame(compose(robot, extrinsics), plucker.join(p, q)) for p, q in points]
    found = observe_line(LINES["plkLin"], camera, robot, extrinsics, np.array(lines))
    assert found.visible.tolist() == [True, True, True]
    for line, pixels in zip(found.value, camera.project(points), strict=True):
        assert np.append(pixels, [[1], [1]], axis=1) @ (line / np.linalg.norm(line[:2])) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("count", [1, 3])
def test_endpoints_are_projected_as_the_points_they_are(count, rng):
    camera = Calibration(PINHOLE, np.eye(2), image=IMAGE, intrinsics=K, distortion=[-0.2, 0.03])
    pose, kind, belief, landmarks, abscissas = Pose.random(rng), LINES["plkLin"], Belief(), [], []
    points = np.append(rng.uniform([-1, -1, 2], [1, 1, 4], (count, 2, 3)), np.ones((count, 2, 1)), axis=-1)
    for i, (p, q) in enumerate(points):
        line = plucker.from_frame(pose, plucker.join(p, q))
        ends = np.append(frames.from_frame(pose, np.array([p, q])[:, :3]), np.ones((2, 1)), axis=1)
        abscissas.append(endpoints.abscissas_of(kind, line, ends))
        landmarks.append(Landmark(i, kind, belief.add(kind.manifold, line, np.eye(kind.manifold.dof)), 1))
    shown = project_endpoints(camera, pose, landmarks, np.array(abscissas))
    assert shown.visible.all()
    assert shown.pixels == pytest.approx(camera.project(points), abs=1e-6)


@pytest.mark.parametrize("lead", [(), (3,)])
def test_segments_are_distorted_end_by_end(lead, rng):
    bent = Calibration(PINHOLE, np.eye(2), image=IMAGE, intrinsics=K, distortion=[-0.2, 0.03])
    straight = Calibration(PINHOLE, np.eye(2), image=IMAGE, intrinsics=K, distortion=[0.0])
    ends = np.append(rng.uniform([-0.5, -0.5, 1], [0.5, 0.5, 1], (*lead, 2, 3)), np.ones((*lead, 2, 1)), axis=-1)
    ideal, seen = (c.project(ends).reshape(*lead, 4) for c in (straight, bent))
    assert np.abs(seen - ideal).max() > 1
    assert distort_segments(bent, ideal) == pytest.approx(seen, abs=1e-6)
    assert undistort_segments(bent, seen)[0] == pytest.approx(ideal, abs=1e-6)


# -- what the filter does with a line ----------------------------------------------------------------------------------


def test_the_shortest_segment_that_may_begin_a_line_is_as_long_as_the_options_say():
    family, values = (
        FAMILIES["segments"],
        np.array([[10.0, 10, 22, 26], [10, 10, 22, 25], [10, 10, 22, 27]]),
    )  # 20: 12, 16
    assert family.usable(None, values, Options(minimum_length=20.0)).tolist() == [True, False, True]


def test_the_distance_of_a_true_segment_is_that_of_its_farther_end():
    geometry = np.array([[1.0, 0, 0], [1, 0, 4]])  # an estimated line along z, of a length that must not count
    assert FAMILIES["segments"].distance(geometry, np.array([1.0, 3, 7, 5, 3, -2])) == pytest.approx(5)


@pytest.mark.parametrize(("std", "converged"), [(0.39, True), (0.41, False)])
def test_a_line_has_converged_when_both_ends_are_known_to_a_tenth_of_its_length(std, converged):
    geometry, covariance = np.array([[[1.0, 0, 0], [1, 0, 4]]]), np.zeros((1, 2, 3, 3))
    covariance[0, 1, 2, 2] = std**2
    assert endpoints_converged(geometry, covariance).tolist() == [converged]
    assert endpoints_converged(np.full((1, 2, 3), np.nan), covariance).tolist() == [False]
