"""`slamlib datasets`: what is listed, what is found, and what is said where nothing is."""

import json
import runpy

import pytest

from slamlib.cli import main
from slamlib.datasets import public
from slamlib.datasets.public import VARIABLE, public_recordings

ADDRESSES = ("http://", "https://")


@pytest.fixture(autouse=True)
def _nowhere(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)


def listed(capsys, *words):
    assert main(["datasets", *words, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_each_recording_says_where_it_is_offered_and_under_which_licence(capsys):
    found = listed(capsys)
    assert set(found) == set(public_recordings())
    for row in found.values():
        assert row["address"].startswith(ADDRESSES)
        assert row["licence"]
        assert row["what"]
        assert row["folder"] == next(iter(row["places"]))
        assert row["found"] == []


def test_no_file_is_read_before_a_recording_is_asked_for(monkeypatch):
    monkeypatch.setattr("tomllib.loads", lambda text: {})
    assert runpy.run_path(public.__file__)["public_recordings"]() == {}
    monkeypatch.setattr("tomllib.loads", None)
    assert callable(runpy.run_path(public.__file__)["public_recordings"])


def test_what_is_there_is_found_by_its_file_not_by_its_folder_alone(capsys, tmp_path, monkeypatch):
    street = tmp_path / "dataset" / "sequences" / "04"
    for folder in (street, street.with_name("05"), tmp_path / "landmarks_plaza"):
        folder.mkdir(parents=True)
    (street / "calib.txt").touch()
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    found = listed(capsys)
    assert {name: row["found"] for name, row in found.items() if row["found"]} == {"kitti-odometry": [str(street)]}
    monkeypatch.delenv(VARIABLE)
    assert listed(capsys, "kitti-odometry", "--folder", str(tmp_path)) == {"kitti-odometry": found["kitti-odometry"]}


def test_the_text_says_where_to_put_what_is_not_there(capsys, tmp_path):
    assert main(["datasets", "plaza"]) == 0
    assert f"not here; put it in ${VARIABLE}/landmarks_plaza" in capsys.readouterr().out
    assert main(["datasets", "plaza", "--folder", str(tmp_path)]) == 0
    assert f"put it in {tmp_path}/landmarks_plaza" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "message"),
    [(["plasa"], "did you mean 'plaza'?"), (["--folder", "no-such"], "no-such is no folder: give one that exists")],
)
def test_mistakes_are_named(capsys, words, message):
    assert main(["datasets", *words]) == 2
    assert message in capsys.readouterr().err
