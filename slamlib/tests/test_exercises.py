"""Every exercise's check accepts the published solution and rejects plausible wrong ones."""

import json
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import slamlib
from slamlib.errors import UnknownNameError
from slamlib.exercises import Rejected, check, exercise, load_all, properties
from slamlib.tests.wrong_solutions import load

CHAPTERS = Path(slamlib.__file__).parent.parent / "book" / "chapters"
KNOWN = load_all()
WRONG = load()


def solutions() -> list[tuple[str, str]]:
    """Source of every published solution that is code: name of the chapter, and the cell."""
    found = []
    for notebook in sorted(CHAPTERS.glob("*.ipynb")):
        for cell in json.loads(notebook.read_text("utf-8"))["cells"]:
            if "solution" in cell["metadata"].get("tags", []):
                found.append((notebook.stem, "".join(cell["source"])))
    return found


@pytest.mark.parametrize(
    ("chapter", "source"), [pytest.param(c, s, id=f"{c}-{i}") for i, (c, s) in enumerate(solutions())]
)
def test_published_solutions_run_by_themselves(chapter, source, capsys):
    exec(compile(source, f"<solution in {chapter}>", "exec"), {"__name__": "__main__"})
    if "check(" in source:
        assert "accepted" in capsys.readouterr().out


def test_every_exercise_has_an_accepted_solution_in_the_book(capsys):
    for chapter, source in solutions():
        exec(compile(source, f"<solution in {chapter}>", "exec"), {"__name__": "__main__"})
    printed = capsys.readouterr().out
    missing = [n for n in KNOWN if f"Exercise {n} accepted" not in printed]
    assert not missing, f"no chapter publishes a solution for {missing}"
    assert KNOWN


@pytest.mark.parametrize(("number", "candidate"), [pytest.param(n, f, id=f"{n}: {why}") for n, why, f in WRONG])
def test_wrong_solutions_are_rejected_for_a_reason(number, candidate):
    with pytest.raises(Rejected) as caught:
        check(number, candidate)
    assert caught.value.__cause__ is None, "rejected only because it crashed: that is not a plausible wrong solution"


def test_every_exercise_has_two_wrong_solutions():
    count = Counter(number for number, _, _ in WRONG)
    assert not [n for n in KNOWN if count[n] < 2]
    assert not [n for n in count if n not in KNOWN]


# -- the framework itself ----------------------------------------------------------------------------------------------


@pytest.fixture
def doubling():
    @exercise("99.1", "twice a vector")
    def _check(candidate):
        properties.same(candidate(np.array([1.0, 2])), [2, 4], "twice the vector")

    yield "99.1"
    from slamlib import exercises

    exercises._known.pop("99.1")


def test_a_right_solution_is_accepted_with_its_properties(doubling, capsys):
    check(doubling, lambda x: 2 * x)
    assert capsys.readouterr().out == "  holds: twice the vector\nExercise 99.1 accepted: twice a vector.\n"


def in_place(x):
    x *= 2
    return x


@pytest.mark.parametrize(
    ("candidate", "message"),
    [
        (lambda x: 3 * x, r"twice the vector: differs: found \[3. 6.\].*\[2. 4.\]"),
        (lambda x: None, "returned None"),
        (lambda x: x[0], "should have shape"),
        (lambda x: x * np.nan, "nan or infinity"),
        (lambda x: x["a"], "raised IndexError"),
        (lambda x: "a", "should be an array of numbers"),
        (in_place, "changed its argument in place"),
    ],
)
def test_what_is_wrong_is_said(doubling, candidate, message):
    with pytest.raises(Rejected, match=message):
        check(doubling, candidate)


def test_an_unknown_exercise_is_named_with_the_known_ones():
    with pytest.raises(UnknownNameError, match=r"unknown exercise '0\.99'"):
        check("0.99", len)
