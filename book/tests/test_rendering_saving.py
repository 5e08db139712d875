"""Films on disk, read as real sequences are."""

import json

import numpy as np
import pytest
from slambook import rendering
from slambook.rendering import saving

from book.tests.test_rendering_film import PATH, SMALL, shot
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import read_trajectory
from slamlib.geometry.pose import Pose, compose
from slamlib.rigs.setup import Rig

pytest.importorskip("cv2")


@pytest.fixture(scope="module")
def film():
    room = rendering.Room(rendering.default_room("drawn").quads[:20])
    return shot(room, 3, rig=rendering.rig_along_path(PATH, baseline=0.1, **SMALL))


@pytest.fixture(scope="module")
def folder(film, tmp_path_factory):
    return rendering.save_film(tmp_path_factory.mktemp("films") / "new" / "one", film)


def test_pictures_are_read_as_they_were(film, folder):
    sources = pytest.importorskip("slamlib.datasets.sources")
    for where, camera in ((folder / "image_0", 0), (folder / "image_1", 1)):
        pictures = list(sources.open_source(str(where)))
        for picture, (frame, _) in zip(pictures, film, strict=True):
            assert (picture.image == frame.scans[camera].image).all()
    times = [picture.time for picture in sources.open_source(str(folder))]
    assert np.allclose(times, [1 / 30, 2 / 30, 3 / 30], atol=1e-8)


def test_calibration_and_truth_are_read_as_they_were(film, folder):
    rig = Rig.from_dict(json.loads((folder / "calibration.json").read_text()))
    assert rig == film.rig
    for camera, setup in enumerate(rig.sensors):
        trajectory = read_trajectory(folder / f"groundtruth_{camera}.txt")
        for pose, (frame, truth) in zip(trajectory.poses, film, strict=True):
            exact = compose(truth.poses[0], setup.extrinsics)
            assert np.allclose(Pose.minus(pose, exact), 0, atol=1e-9)
            assert frame.number in (1, 2, 3)


def test_nothing_is_overwritten(film, folder):
    before = {p: p.stat().st_mtime_ns for p in folder.rglob("*")}
    with pytest.raises(SlamlibError, match="not empty"):
        rendering.save_film(folder, film)
    with pytest.raises(SlamlibError, match="no frames"):
        rendering.save_film(folder.parent / "two", shot(film.room, 0))
    assert {p: p.stat().st_mtime_ns for p in folder.rglob("*")} == before
    assert not (folder.parent / "two").exists()


def test_a_film_that_breaks_off_leaves_whole_pictures_and_no_list(film, tmp_path, monkeypatch):
    def breaking(items, total, label):
        yield from list(items)[:2]
        raise KeyboardInterrupt

    monkeypatch.setattr(saving, "progress", breaking)
    with pytest.raises(KeyboardInterrupt):
        rendering.save_film(tmp_path / "film", film)
    names = sorted(p.name for p in (tmp_path / "film").rglob("*") if p.is_file())
    assert names == ["000001.png", "000001.png", "000002.png", "000002.png"]
