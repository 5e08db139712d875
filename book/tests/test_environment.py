"""What `make environment` makes, and when it makes it again; make only says here what it would do."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from book.tools import layout

STAMPS = (".venv/.ready", ".venv/.command")
MADE_FROM = ("Makefile", "requirements.txt", "pyproject.toml")
ANEW, LOCK, COMMAND = "-m venv --clear .venv", "--require-hashes -r requirements.txt", "--editable ."


def test_the_environment_has_the_command():
    command = Path(sys.executable).with_name("slamlib")
    run = subprocess.run([command, "list"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert "points" in run.stdout


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
@pytest.mark.parametrize(
    ("changed", "steps"),
    [
        (None, []),
        ("requirements.txt", [ANEW, LOCK, COMMAND]),
        ("pyproject.toml", [COMMAND]),
        (".venv", [ANEW, LOCK, COMMAND]),
    ],
)
def test_what_has_changed_is_made_anew_and_nothing_else(changed, steps, tmp_path):
    for name in MADE_FROM:
        shutil.copy(layout.ROOT / name, tmp_path / name)
    (tmp_path / ".venv").mkdir()
    for moment, name in enumerate((*MADE_FROM, *STAMPS)):
        (tmp_path / name).touch()
        os.utime(tmp_path / name, (moment, moment))
    if changed == ".venv":
        shutil.rmtree(tmp_path / ".venv")
    elif changed:
        os.utime(tmp_path / changed, (9, 9))
    said = subprocess.run(
        ["make", "-n", "environment"], cwd=tmp_path, capture_output=True, text=True, check=True
    ).stdout
    places = [said.find(step) for step in (ANEW, LOCK, COMMAND)]
    assert [step for step, place in zip((ANEW, LOCK, COMMAND), places, strict=True) if place >= 0] == steps
    assert sorted(places) == places
