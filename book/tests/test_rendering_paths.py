"""Paths through rooms: smooth, exact velocities, sensible speeds, inside the room."""

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering.furnished import HEIGHT, LENGTH, WIDTH

from slamlib.errors import SlamlibError
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import minus

PATHS = {name: rendering.path(name) for name in rendering.PATHS}


@pytest.mark.parametrize("name", PATHS)
def test_velocities_are_the_derivatives(name):
    path, h = PATHS[name], 1e-4
    for time in np.linspace(h, path.duration - h, 40):
        before, state, after = (path.state(time + k * h) for k in (-1, 0, 1))
        assert np.allclose(path.pose(time), state[:7])
        assert np.allclose((after[:3] - before[:3]) / (2 * h), state[7:10], atol=1e-6)
        assert np.allclose(minus(after[3:7], before[3:7]) / (2 * h), state[10:], atol=1e-6)


@pytest.mark.parametrize("name", PATHS)
def test_paths_are_smooth(name):
    path, h = PATHS[name], 1e-5
    for knot in path.times[1:-1]:  # the acceleration is the same on both sides of a knot
        left, right = (path.state(knot + s)[7:] - path.state(knot + s - h)[7:] for s in (0, h))
        assert np.allclose(left / h, right / h, atol=1e-3)


@pytest.mark.parametrize("name", PATHS)
def test_paths_are_a_hands_and_stay_in_the_room(name):
    path = PATHS[name]
    states = np.array([path.state(t) for t in np.linspace(0, path.duration, 300)])
    assert (np.abs(states[:, :2]) < [LENGTH / 2 - 1, WIDTH / 2 - 1]).all()
    assert (np.abs(states[:, 2] - HEIGHT / 2) < 0.2).all()
    speed, spin = (np.linalg.norm(states[:, at], axis=1) for at in (slice(7, 10), slice(10, 13)))
    assert 0.2 < speed.mean() < 0.6
    assert speed.max() < 0.7
    assert spin.max() < 0.4


def test_still_is_still_and_then_moves():
    path = rendering.path("still", still=1.0)
    moved = [np.linalg.norm(path.pose(t)[:3] - path.pose(0)[:3]) for t in (0.5, 0.8, 3.0)]
    assert moved[0] < 1e-8
    assert moved[1] < 1e-5
    assert moved[2] > 0.2


def test_round_comes_back():
    path = rendering.path("round", duration=20)
    assert np.allclose(Pose.minus(path.pose(19.5), path.pose(0)), 0, atol=1e-9)
    assert np.linalg.norm(path.pose(9.75)[:3] - path.pose(0)[:3]) > 1.8


def test_a_path_of_ones_own_passes_through_its_knots():
    knots = np.random.default_rng(1).uniform(-1, 1, (5, 6))
    path = rendering.CameraPath([1.0, 2.0, 2.5, 4.0, 5.0], knots)
    assert path.duration == 4
    assert np.allclose(path.pose(1.5)[:3], knots[2, :3])
    straight = rendering.CameraPath([0, 1, 3], np.outer([0, 1, 3], [0.2, 0.1, 0, 0, 0, 0.3]))
    assert np.allclose(straight.state(2.0)[7:], [0.2, 0.1, 0, 0, 0, 0.3])


@pytest.mark.parametrize(
    ("times", "knots"), [([0, 1], np.zeros((2, 6))), ([0, 2, 1], np.zeros((3, 6))), ([0, 1, 2], np.zeros((3, 5)))]
)
def test_what_is_no_path_is_refused(times, knots):
    with pytest.raises(SlamlibError, match="Path"):
        rendering.CameraPath(times, knots)


def test_a_path_ends():
    with pytest.raises(SlamlibError, match="make it longer"):
        PATHS["sideways"].pose(13.0)
    with pytest.raises(SlamlibError, match="takes 1 s or more"):
        rendering.path("sideways", duration=0.5)
