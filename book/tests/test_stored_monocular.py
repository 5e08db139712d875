"""Stored results of chapter monocular: of the rendered room, and of the real sequence if its images are there."""

import io
import json
import os
import tarfile
from pathlib import Path

import numpy as np
import pytest

from book.experiments import monocular, real_images
from book.experiments.stored import kept as stored
from book.tests.stored_results import comes_out_again
from book.tools import assets
from slamlib.evaluation.alignment import align_trajectory
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.vision.opening import options_for

CUBE = Path(os.environ.get("SLAMLIB_DATA") or "no-data") / "mono_visp_cube" / "frames"
RENEW = "run `make {}` and `python -m book.tools.notebooks run book/chapters/monocular.ipynb`"


def images():
    found = real_images.folder() or (CUBE if CUBE.is_dir() else None)
    if found is None:
        pytest.skip("the real images are not here: `make real-images` fetches them")
    return found


def test_the_beginning_of_a_run_past_the_wall_comes_out_again():
    """15 frames take 8 s to render, filter and smooth; a row of the file has 300, or once round the room 449."""
    (light,) = stored(monocular.FILE)["light"]
    found = monocular.row(monocular.sideways(monocular.SEEDS[0], monocular.LIGHT))
    # Where a patch fits best is found step by step, and ends a little elsewhere on another machine.
    comes_out_again(found, light, RENEW.format("monocular"), share=1e-2, places=3)


@pytest.mark.parametrize("run", range(len(monocular.SEEDS)))
def test_the_errors_of_a_stored_path_round_the_room_come_out_again(run):
    row, renew = stored(monocular.FILE)["round"][run], RENEW.format("monocular")
    true, own, best = (path(places) for places in (row["true"], row["place"], row["at once"]["place"]))
    found = {"off": align_trajectory(own, true).relative_ate, "at once": align_trajectory(best, true).relative_ate}
    kept = {"off": row["off"] / 100, "at once": row["at once"]["off"] / 100}
    comes_out_again(found, kept, renew, share=0.06)  # one position in eight is stored: the way between them is shorter


def path(places):
    """A trajectory of these positions; which way the camera looked is not stored."""
    return Trajectory(np.arange(len(places), dtype=float), np.insert(np.array(places), [3] * 4, [1, 0, 0, 0], axis=1))


@pytest.mark.parametrize("run", range(len(monocular.SEEDS)))
def test_the_end_of_a_way_round_comes_out_again_of_the_stored_path(run, monkeypatch):
    kept = stored(monocular.FILE)
    monkeypatch.setattr(monocular, "around", lambda seed, closes=False: kept["round"][run])
    without, _ = monocular.closed(monocular.SEEDS[run])
    comes_out_again(without, kept["closed"][run][0], RENEW.format("monocular"))


def test_stored_claim_the_room_is_within_the_promised_bounds():
    kept = stored(monocular.FILE)
    assert kept["frames"] == 300
    assert len(kept["sideways"]) == 5
    assert max(run["off"] for run in kept["sideways"]) < 2
    assert min(run["matched"] for run in kept["sideways"]) > 0.85
    assert all(run["at once"] < run["off"] for run in kept["sideways"])


def test_stored_claim_all_data_at_once_repair_the_way_round_where_the_loop_has_closed():
    left = {True: list[float](), False: list[float]()}
    for run in stored(monocular.FILE)["round"]:
        left[run["old"][-1] >= 10].append(run["at once"]["off"] / run["off"])
    assert max(left[True]) < 0.25
    assert min(left[False]) > 0.8


def test_stored_claim_appearance_closes_every_loop():
    pairs = stored(monocular.FILE)["closed"]
    assert len(pairs) == len(monocular.CLOSED)
    assert sum(without["old"] >= 8 for without, _ in pairs) <= 3
    assert all(found["old"] >= 8 and found["end"] < 0.05 for _, found in pairs)
    changed = [(without["at once"], found["at once"]) for without, found in pairs if without != found]
    assert sum(after < before / 2 for before, after in changed) >= len(changed) - 1


def test_what_the_two_references_agree_to_comes_out_again():
    dots = read_trajectory(real_images.DATA / real_images.REFERENCES["dots of the cube"])
    found = real_images.merit(real_images.compared(dots))
    comes_out_again(found, stored(real_images.FILE)["references agree to"], RENEW.format("real-images"), places=2)


def test_form_of_the_stored_real_run_and_its_settings():
    kept = stored(real_images.FILE)
    assert kept["options"] == json.loads(json.dumps(options_for(1.0, **real_images.SAID).to_dict()))
    assert set(kept["runs"]) == {"as told", *real_images.CHANGES}
    assert len(kept["first"]["position"]) == real_images.COUNT


def test_the_beginning_of_the_real_run_comes_out_again():
    folder, light = images(), stored(real_images.FILE)["light"]
    found = real_images.run(folder, frames=real_images.LIGHT).trajectory().positions[-1]
    np.testing.assert_allclose(found, light, atol=2e-3, err_msg=RENEW.format("real-images"))


def package(files):
    """A Debian package: an ar archive of a version, and of a tar with files {name: content}."""
    inner = io.BytesIO()
    with tarfile.open(fileobj=inner, mode="w:xz") as packed:
        for name, content in files.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(content)
            packed.addfile(entry, io.BytesIO(content))
    parts = b"!<arch>\n"
    for name, content in (("debian-binary", b"2.0\n"), ("data.tar.xz", inner.getvalue())):
        parts += f"{name:16}{0:<12}{0:<6}{0:<6}{'100644':8}{len(content):<10}`\n".encode() + content
        parts += b"\n" * (len(content) % 2)
    return parts


def test_the_images_are_taken_out_of_a_package(tmp_path):
    files = {f"./{real_images.INSIDE}image.0000.pgm": b"one", "./usr/share/doc/copyright": b"no"}
    assert real_images.unpack(package(files), tmp_path) == 1
    assert [(p.name, p.read_bytes()) for p in tmp_path.iterdir()] == [("image.0000.pgm", b"one")]


def test_what_is_no_package_is_refused(tmp_path):
    with pytest.raises(assets.AssetError, match="no Debian package"):
        real_images.unpack(b"<html>not found</html>", tmp_path)


def test_a_package_with_another_checksum_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(real_images, "FOLDER", tmp_path / "cube")
    monkeypatch.setattr(assets, "ASSETS", tmp_path)
    monkeypatch.setitem(assets.DOWNLOADS, "deb", lambda path: b"something else")
    with pytest.raises(assets.AssetError, match="checksum"):
        real_images.fetch()
    assert real_images.folder() is None
