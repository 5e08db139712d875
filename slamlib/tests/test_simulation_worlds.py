"""Worlds: the toolbox's to the last digit, larger ones, their names, and joining."""

import numpy as np
import pytest

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.records.inputs import Features, World
from slamlib.rigs.setup import Rig, RobotSetup, SensorSetup
from slamlib.simulation import WORLDS, controls, join, simulate, world
from slamlib.simulation.worlds import cloister, gallery_radius, house, numbered, thick_cloister
from slamlib.tests.reference import cases


def test_cloister_is_the_toolboxs():
    for given, wanted in cases("worlds", "cloister"):
        found = cloister(*(given[k] for k in ("xmin", "xmax", "ymin", "ymax", "n")))
        assert found.points.values[:, :2] == pytest.approx(wanted["f"].T, abs=1e-14)
        assert not found.points.values[:, 2].any()


def test_thick_cloister_is_the_toolboxs():
    for given, wanted in cases("worlds", "thickCloister"):
        found = thick_cloister(*(given[k] for k in ("x", "X", "y", "Y", "h", "n")))
        assert found.points.values == pytest.approx(wanted["world"].T, abs=1e-14)


def test_house_is_the_toolboxs():
    for given, wanted in cases("worlds", "house_default_demo") + cases("worlds", "house_full"):
        found = house(*(given[k] for k in ("x", "y", "z", "l", "w", "h") if k in given))
        assert found.segments.values == pytest.approx(wanted["H"].T, abs=1e-14)


def test_the_demos_have_72_points_and_23_segments_numbered_from_one():
    assert world("thickCloister", n=7).points.ids.tolist() == list(range(1, 73))
    assert world("house").segments.ids.tolist() == list(range(1, 24))


def test_a_stretched_and_moved_cloister_fills_its_rectangle():
    points = cloister(1, 5, -3, 9, 11).points.values
    assert points.min(0).tolist() == [1, -3, 0]
    assert points.max(0).tolist() == [5, 9, 0]
    assert len(points) == len(np.unique(points, axis=0)) == 8 * 11 - 20


def test_every_segment_of_a_house_lies_on_one_of_its_faces():
    there = world("house", x=1, y=2, z=3, length=4, width=6, height=5)
    for endpoints in there.segments.values.reshape(-1, 2, 3):
        normals = np.cross(there.faces[:, 1] - there.faces[:, 0], there.faces[:, 2] - there.faces[:, 0])
        off = np.abs(((endpoints[:, None] - there.faces[:, 0]) * normals).sum(-1)).max(0)
        assert off.min() < 1e-9


def test_joined_worlds_are_numbered_anew_and_keep_their_faces():
    own = World(
        {"points": Features(np.array([7, 3]), np.eye(3)[:2]), "segments": Features(np.array([99]), np.ones((1, 6)))}
    )
    both = join(own, world("house"), world("thickCloister", n=7))
    assert both.points.ids.tolist() == list(range(1, 75))
    assert both.segments.ids.tolist() == list(range(75, 99))
    assert both.points.values[:2].tolist() == np.eye(3)[:2].tolist()
    assert (both.segments.values[1:] == house().segments.values).all()
    assert (both.faces == house().faces).all()
    assert len(join().points) == 0


@pytest.mark.parametrize("n", [4, 100, 999, 1000])
def test_a_gallery_has_n_different_points(n):
    points = world("gallery", n=n).points
    assert len(points) == len(np.unique(points.values.round(9), axis=0)) == n


def test_the_points_in_view_of_a_gallery_do_not_grow_with_it():
    def in_view(n):
        radius, step = gallery_radius(n), 0.2
        start = RobotSetup(position=(radius, 0, 0), euler=(0, 0, 90))
        rig = Rig((start,), (SensorSetup(euler=(-90, 0, 180), position=(0, 0, 1)),))
        way = controls.circle(round(2 * np.pi * radius / step), radius)
        run = simulate(rig, world("gallery", n=n), frames=60, dt=1, rng=np.random.default_rng(1), controls=[way])
        return np.mean([len(frame.scans[0].points) for frame, _ in run])

    few, many = in_view(1000), in_view(8000)
    assert few == pytest.approx(many, rel=0.1)
    assert 15 < many < 30


@pytest.mark.parametrize("n", [1, 23, 24, 500])
def test_a_town_has_n_segments(n):
    assert len(world("town", n=n).segments) == n


def test_a_cloud_stays_in_its_box_and_has_a_seed():
    points = world("cloud", seed=1, n=500, size=4, h=1).points.values
    assert (np.abs(points[:, :2]) <= 2).all()
    assert ((points[:, 2] >= 0) & (points[:, 2] <= 1)).all()
    assert np.array_equal(points, world("cloud", n=500, size=4, h=1).points.values)
    assert not np.array_equal(points, world("cloud", n=500, size=4, h=1, seed=2).points.values)


def test_a_world_of_ones_own_is_found_by_its_name(monkeypatch):
    monkeypatch.setitem(WORLDS, "mine", lambda n=1: numbered(np.zeros((n, 3))))
    assert len(world("mine", n=3).points) == 3


def test_misuse_is_named():
    with pytest.raises(UnknownNameError, match=r"unknown world 'hause'; did you mean 'house'\?"):
        world("hause")
    with pytest.raises(SlamlibError, match=r"world house.*unexpected keyword argument 'size'"):
        world("house", size=3)
    for name, wrong in (("cloister", 3), ("cloister", 7.5), ("gallery", 0), ("town", 0)):
        with pytest.raises(SlamlibError, match=rf"world {name}\.n should be"):
            world(name, n=wrong)
