"""The chapter's cell is the source of a formula module."""

from pathlib import Path

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from book.tools import tangle
from slamlib.codegen import tangle as magic
from slamlib.errors import SlamlibError

PATH = "slamlib/geometry/doubling.py"
TEXT = '''"""A module of one model."""

from slamlib.models import model


@model(point=2)
def double(point):
    """Twice a point."""
    return 2 * point
'''


@pytest.fixture
def book(tmp_path, monkeypatch):
    """A package folder and a book with one chapter that holds one tangled cell."""
    monkeypatch.setattr(magic, "PACKAGE", tmp_path / "slamlib")
    (tmp_path / "slamlib/geometry").mkdir(parents=True)
    chapters = tmp_path / "book/chapters"
    chapters.mkdir(parents=True)
    _write(chapters / "01_one.ipynb", f"%%tangle {PATH}\n{TEXT}".rstrip("\n"))
    return tmp_path / "book"


def _write(notebook: Path, *sources: str) -> None:
    nbformat.write(new_notebook(cells=[new_code_cell(source) for source in sources]), notebook)


def test_write_makes_the_module_and_check_is_then_content(book):
    assert tangle.check(book) == [
        f"{PATH}: differs from its cell in 01_one.ipynb; run `make tangle` or `make untangle`"
    ]
    assert tangle.write(book) == 1
    assert (magic.PACKAGE.parent / PATH).read_text() == TEXT
    assert tangle.check(book) == []
    assert tangle.write(book) == 0
    assert tangle.main(["--check", "--book", str(book)]) == 0


def test_back_carries_an_edit_into_the_cell(book):
    tangle.write(book)
    file = magic.PACKAGE.parent / PATH
    file.write_text(TEXT.replace("2 * point", "point + point"))
    assert "differs" in tangle.check(book)[0]
    assert tangle.back(book) == 1
    assert tangle.check(book) == []
    assert "point + point" in next(tangle.cells(book))[3]
    assert tangle.back(book) == 0


def test_a_module_that_no_chapter_derives_and_one_that_is_written_twice_are_found(book):
    tangle.write(book)
    (magic.PACKAGE / "geometry/orphan.py").write_text(TEXT)
    _write(book / "chapters/02_two.ipynb", f"%%tangle {PATH}\n{TEXT}")
    problems = tangle.check(book)
    assert any("written twice" in p for p in problems)
    assert any("orphan.py: no chapter derives it" in p for p in problems)


def test_check_of_a_book_without_tangled_cells_fails(tmp_path, capsys):
    assert tangle.main(["--check", "--book", str(tmp_path)]) == 1
    assert "tangled cells: 0" in capsys.readouterr().out


def test_a_cell_may_write_only_into_the_package(book):
    _write(book / "chapters/03_three.ipynb", f"%%tangle ../elsewhere.py\n{TEXT}")
    with pytest.raises(SlamlibError, match="only write below slamlib/"):
        tangle.write(book)


def test_an_edited_cell_runs_and_reports_the_drift(book):
    tangle.write(book)
    names, drift = magic.run_cell(PATH, TEXT.replace("2 * point", "3 * point"))
    assert "+    return 3 * point" in str(drift)
    assert names["double"](np.ones(2)) == pytest.approx([3, 3])
    assert names["double"].jac(np.ones(2))[1].point == pytest.approx(3 * np.eye(2))


def test_a_cell_that_is_the_package_file_gives_the_packages_own_objects():
    from slamlib.geometry import pose

    text = Path(pose.__file__).read_text()
    names, drift = magic.run_cell("slamlib/geometry/pose.py", text)
    assert drift is None
    assert names["to_frame"] is pose.to_frame
