"""The wheel of both packages: the same bytes on every run, and of use where there is NumPy and nothing else."""

import os
import re
import sys
import zipfile
from pathlib import Path

import pytest

from book.tools import layout, wheel

PACKAGES = {"slamlib": layout.ROOT / "slamlib", "slambook": layout.ROOT / "book" / "slambook"}
OWN = {".git", ".venv", "_build", "__pycache__"}  # folders of the checkout that are not the project's
SAY = "import matplotlib, slambook, slamlib; print(matplotlib.__file__, slambook.__file__, slamlib.__file__)"


def said(bare, *command, **more):
    """What a command of the bare environment prints."""
    run = bare.run(bare.python, *command, **more)
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_the_wheel_is_the_same_bytes_on_every_run_and_holds_both_packages_and_nothing_else(built, tmp_path):
    assert built.read_bytes() == wheel.build(tmp_path).read_bytes()
    with zipfile.ZipFile(built) as archive:
        packed = {n: archive.read(n) for n in archive.namelist() if ".dist-info/" not in n}
        metadata = archive.read(next(n for n in archive.namelist() if n.endswith("METADATA"))).decode()
    source = {
        f"{name}/{file.relative_to(folder).as_posix()}": file.read_bytes()
        for name, folder in PACKAGES.items()
        for file in folder.rglob("*.py")
    }
    source = {n: c for n, c in source.items() if not n.startswith("slamlib/tests/")}
    assert {n: c for n, c in packed.items() if n.endswith(".py")} == source
    assert {n.split("/")[0] for n in packed} == set(PACKAGES)
    assert not [n for n in packed if n.startswith("slamlib/tests/")]
    assert {"slambook/scene/player.js", "slamlib/py.typed", "slambook/py.typed"} <= set(packed)
    assert re.findall(r"^Requires-Dist: (?!.*extra)(.*)$", metadata, flags=re.M) == ["numpy>=1.25"]


def test_a_preset_runs_on_numpy_alone(bare):
    assert "points" in said(bare, "-m", "slamlib", "run", "points", "--frames", "5")
    modules = "import sys, slamlib.cli, slamlib.experiments, slambook.scene; print(*sys.modules)"
    loaded = {name.split(".")[0] for name in said(bare, "-c", modules).split()}
    assert not loaded & {"matplotlib", "scipy", "sympy", "cv2", "PIL", "IPython"}


def test_the_description_holds_where_no_repository_is(bare):
    text = said(bare, "-c", "import importlib.metadata; print(importlib.metadata.metadata('slamlib').get_payload())")
    assert text.startswith("# slamlib")
    assert not re.findall(r"\]\((?!https://)", text)  # pictures and links into the repository
    first, checked, run, fed = re.findall(r"```python\n(.*?)```", text, flags=re.S)
    assert "(1000, 3, 6) (1000, 3, 3)" in said(bare, "-c", f"{first}print(J.pose.shape, J.point.shape)")
    assert "the property holds" in said(bare, "-c", checked)
    short = run.replace("sl.presets.points()", "dataclasses.replace(sl.presets.points(), frames=3)")
    assert said(bare, "-c", f"import dataclasses\n{short}").count("[") == 2
    assert "  7 eucPnt    9.000   4.000" in said(bare, "-c", fed)


def test_mypy_sees_the_types_of_what_is_installed(bare, tmp_path):
    imports = "import slamlib as sl\nfrom slamlib.errors import ShapeError\nfrom slambook.report.table import Rows\n"
    calls = "rows: Rows = [{}]\nShapeError.of('f', 'point', (3,), (4,))\nlow, high = sl.band(2)\n"
    (tmp_path / "right.py").write_text(imports + calls)
    (tmp_path / "wrong.py").write_text(
        imports + calls.replace("[{}]", "[1]").replace("(3,)", "3").replace("(2)", "('2')")
    )
    options = ["--strict", "--config-file=", "--cache-dir", os.devnull, "--python-executable", str(bare.python)]
    run = bare.run(sys.executable, "-m", "mypy", *options, "right.py", "wrong.py", cwd=tmp_path)
    found = re.findall(r"(?m)^(\w+\.py:\d+): error: .*\[([\w-]+)\]$", run.stdout)
    assert found == [("wrong.py:4", "list-item"), ("wrong.py:5", "arg-type"), ("wrong.py:6", "arg-type")], (
        run.stdout + run.stderr
    )


@pytest.mark.parametrize("example", sorted((layout.ROOT / "examples").glob("*.py")), ids=lambda file: file.stem)
def test_an_example_is_ten_to_thirty_lines_and_runs_on_the_wheel(example, bare):
    lines = [line for line in example.read_text("utf-8").splitlines() if line.strip()]
    assert 10 <= len(lines) <= 30
    assert said(bare, example, extras_named=re.findall(r"extra `(\w+)`", lines[0]))


def test_with_the_extra_a_film_is_drawn(bare):
    matplotlib = pytest.importorskip("matplotlib", reason="films are drawn by matplotlib (extra `draw`)")
    pytest.importorskip("PIL.Image", reason="GIF files are written by Pillow")
    said(bare, "-m", "slamlib", "run", "points", "--frames", "3", "--video", "film.gif", extras_named=["draw"])
    assert (bare.packages.parent / "film.gif").read_bytes().startswith(b"GIF8")
    real, *installed = said(bare, "-c", SAY, extras_named=["draw"]).split()
    assert Path(real).resolve() == Path(matplotlib.__file__).resolve()
    assert all(Path(file).is_relative_to(bare.packages) for file in installed)


def test_nothing_on_disk_is_called_matplotlib_but_the_real_one(built):
    """The page's stand-in is registered under that name by the page's worker, and lies under another."""
    named = re.compile(r"matplotlib(\.\w+)*")
    for folder, below, files in os.walk(layout.ROOT):
        below[:] = [name for name in below if name not in OWN]
        assert not [name for name in (*below, *files) if named.fullmatch(name)], folder
    with zipfile.ZipFile(built) as archive:
        assert not [n for n in archive.namelist() if any(named.fullmatch(part) for part in n.split("/"))]
