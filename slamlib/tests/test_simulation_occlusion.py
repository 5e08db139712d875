"""Opaque triangles: against rays, against what is known of convex bodies, and in a whole run."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import simulate, world
from slamlib.simulation.occlusion import hidden, longest_seen, shadows


def crossed(point, face, eye):
    """Whether the open sight line meets the triangle: barycentric coordinates by solving three equations."""
    a, b, c = face
    system = np.column_stack([b - a, c - a, eye - point])
    if abs(np.linalg.det(system)) < 1e-9:
        return False
    v, w, t = np.linalg.solve(system, eye - a)
    return v > 0 and w > 0 and v + w < 1 and 0 < t < 1


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_hidden_points_are_those_whose_sight_line_meets_a_triangle(seed):
    rng = np.random.default_rng(seed)
    faces, points, eye = rng.normal(size=(4, 3, 3)), 2 * rng.normal(size=(30, 3)), 2 * rng.normal(size=3)
    wanted = [any(crossed(p, f, eye) for f in faces) for p in points]
    assert (hidden(points, faces, eye) == wanted).all()


@settings(max_examples=50, deadline=None)
@example(600)  # a shadow of three hundred-thousandths of the segment
@given(st.integers(0, 2**32 - 1))
def test_what_is_left_of_a_segment_is_its_longest_stretch_of_seen_points(seed):
    rng = np.random.default_rng(seed)
    faces, segments, eye = rng.normal(size=(4, 3, 3)), 2 * rng.normal(size=(10, 2, 3)), 2 * rng.normal(size=3)
    endpoints, seen = longest_seen(segments, faces, eye)
    planes = shadows(faces, eye).reshape(-1, 4).T
    for segment, found, any_left in zip(segments, endpoints, seen, strict=True):
        a, along = segment[0], segment[1] - segment[0]
        low, high = (found - a) @ along / (along @ along) if any_left else (0.0, 0.0)
        heights = [np.concatenate([points, [1]]) @ planes for points in segment]  # between two planes all is the same
        cuts = heights[0] / (heights[0] - heights[1])
        cuts = np.sort([0, 1, *cuts[(cuts > 0) & (cuts < 1)]])
        mask = ~hidden(a + (cuts[:-1] + cuts[1:])[:, None] / 2 * along, faces, eye)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], mask, [0]])))
        runs = cuts[edges[1::2]] - cuts[edges[::2]]
        assert high - low == pytest.approx(runs.max(initial=0), abs=1e-9)
        assert np.cross(found - a, along) == pytest.approx(np.zeros((2, 3)), abs=1e-12)


@pytest.mark.parametrize("eye", [(-9, 0.1, 1.5), (9, 8, 1), (0.3, -7, 6), (0.2, 0.3, 12), (-5, -5, 0.5)])
def test_of_a_house_one_sees_the_segments_of_the_faces_that_look_this_way(eye):
    """True of every convex body; a house is one."""
    there, eye = world("house"), np.array(eye, float)
    middle = there.faces.mean((0, 1))
    normals = np.cross(there.faces[:, 1] - there.faces[:, 0], there.faces[:, 2] - there.faces[:, 0])
    normals *= np.sign((normals * (there.faces[:, 0] - middle)).sum(-1))[:, None]
    ahead = (normals * (eye - there.faces[:, 0])).sum(-1) > 0
    segments = there.segments.values.reshape(-1, 2, 3)
    distance = np.abs(((segments[:, None] - there.faces[:, :1]) * normals[:, None]).sum(-1)).max(-1)
    wanted = ((distance < 1e-9) & ahead).any(1)
    endpoints, seen = longest_seen(segments, there.faces, eye)
    left = np.linalg.norm(endpoints[:, 1] - endpoints[:, 0], axis=-1) / np.linalg.norm(
        segments[:, 1] - segments[:, 0], axis=-1
    )
    assert left[wanted] == pytest.approx(np.ones(wanted.sum()), abs=1e-5)
    assert (left[~wanted & seen] < 1e-5).all()


def test_no_slit_between_two_triangles_of_a_wall():
    square = np.array([[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]], float)
    faces = np.array([square[[0, 1, 2]], square[[0, 2, 3]]])
    diagonal = 3 * (square[0] + np.linspace(0.01, 0.99, 50)[:, None] * (square[2] - square[0]))
    assert hidden(diagonal, faces, np.zeros(3)).all()
    behind = np.array([[[3, -2, -1], [3, 2, 1.5]]])
    assert not longest_seen(behind, faces, np.zeros(3))[1].any()


def test_a_triangle_hides_neither_itself_nor_anything_when_it_is_seen_from_the_edge():
    face = np.array([[[1, -1, 0], [1, 1, 0], [3, 0, 0.0]]])
    beyond = np.array([[5, 0, 0], [5, 0, 1], [5, 0, -1], [2, 0, 0.0]])
    assert not hidden(beyond, face, np.zeros(3)).any()
    assert not hidden(face[0], face, np.array([0, 0, 1.0])).any()
    assert not hidden(np.ones((1, 3)), np.zeros((1, 3, 3)), np.zeros(3)).any()


def test_occlusion_takes_features_out_of_a_run_and_changes_no_other():
    start = RobotSetup(position=(-5, 0, 0), euler=(0, 0, -90), control=(0.08, 0, 0, 0, 0, 0.9))
    rig = Rig((start,), (SensorSetup(position=(0, 0, 1.5), euler=(-90, 0, 0)),))
    runs = [
        list(simulate(rig, world("house"), frames=50, dt=0.1, rng=np.random.default_rng(1), occlusion=occlusion))
        for occlusion in (False, True)
    ]
    fewer = 0
    for (free, _), (solid, _) in zip(*runs, strict=True):
        a, b = free.scans[0].segments, solid.scans[0].segments
        assert set(b.ids) <= set(a.ids)
        fewer += len(a) - len(b)
        same = a.values[np.isin(a.ids, b.ids)] == b.values
        assert same[np.isin(b.ids, range(16, 24))].all()  # door and window are whole
    assert fewer > 50
