"""For those who teach: no solution is in what their students get, every exercise is, and the notes are current."""

import json
import re
import zipfile

import pytest

from book.tools import instructor, layout


@pytest.mark.parametrize("file", layout.lessons(), ids=lambda file: file.stem)
def test_the_exercises_stay_and_their_solutions_go(file):
    before, after = instructor.cells(file), json.loads(instructor.without_solutions(file))["cells"]
    whole, text = ("\n".join("".join(cell["source"]) for cell in cells) for cells in (before, after))
    labels = re.findall(r"\{exercise\}\n:label: (\S+)", whole)
    assert re.findall(r"\{exercise\}\n:label: (\S+)", text) == labels == [one[0] for one in instructor.exercises(file)]
    hidden = re.findall(r"\{solution-start\}.*?\n```\n(.*?)```\{solution-end\}", whole, flags=re.DOTALL)
    assert len(hidden) == len(labels)
    assert not [one for one in hidden if one.strip() in text]
    assert "solution-" not in text
    assert not [cell for cell in after if "solution" in cell["metadata"].get("tags", [])]
    parts = [[cell["metadata"]["part"] for cell in cells if "part" in cell["metadata"]] for cells in (before, after)]
    assert parts[0] == parts[1]


def test_a_solution_without_an_end_is_an_error(tmp_path):
    file = tmp_path / "page.ipynb"
    cell = {"cell_type": "markdown", "source": ["before\n", "```{solution-start} ex-1\n", "```"], "metadata": {}}
    file.write_text(json.dumps({"cells": [cell]}))
    with pytest.raises(ValueError, match="a solution does not end"):
        instructor.without_solutions(file)
    ends = {**cell, "source": ["hidden\n", "```{solution-end}\n", "```\n", "after"]}
    file.write_text(json.dumps({"cells": [cell, ends]}))
    kept = ["".join(cell["source"]) for cell in json.loads(instructor.without_solutions(file))["cells"]]
    assert kept == ["before", "after"]


def test_the_archive_has_what_the_notebooks_need(tmp_path, monkeypatch):
    monkeypatch.setattr(instructor, "ZIP", tmp_path / "course.zip")
    with zipfile.ZipFile(instructor.export()) as archive:
        names = {name.removeprefix("course/") for name in archive.namelist()}
        read_me = archive.read("course/README.md").decode()
    assert {f"chapters/{page.name}" for page in (layout.BOOK / "chapters").glob("*.ipynb")} <= names
    assert {f"chapters/data/{file.name}" for file in (layout.BOOK / "chapters" / "data").iterdir()} <= names
    (wheel,) = [name for name in names if name.endswith(".whl")]
    assert f"pip install {wheel} " in read_me


def test_the_notes_are_current():
    assert instructor.current() == instructor.NOTES.read_text("utf-8"), "python -m book.tools.instructor --notes"
    assert len(instructor.COURSE) == 14


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("45 minutes", 45),
        ("an hour", 60),
        ("an hour and a half", 90),
        ("two and a quarter hours", 135),
        ("two hours", 120),
        ("five minutes, down to *Three things happen*; forty more for the formulas", 45),
    ],
)
def test_times_as_chapters_say_them(text, expected):
    assert instructor.minutes(text) == expected


def test_what_is_no_time_is_an_error():
    with pytest.raises(ValueError, match="is no time"):
        instructor.minutes("a while, perhaps")
