"""Every exercise's check accepts the published solution and rejects plausible wrong ones."""

import json
import linecache
import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from slambook.exercises import Rejected, check, exercise, kit, load_all

from book.tests.wrong_solutions import load
from book.tests.wrong_solutions import observability as wrong
from book.tools import layout
from slamlib.errors import SlamlibError, UnknownNameError

KNOWN = load_all()
WRONG = load()


def solutions() -> list[tuple[Path, str]]:
    """Every published solution that is code: its notebook, and the source of the cell."""
    found = []
    for notebook in layout.lessons():
        for cell in json.loads(notebook.read_text("utf-8"))["cells"]:
            if "solution" in cell["metadata"].get("tags", []):
                found.append((notebook, "".join(cell["source"])))
    return found


def run(chapter: str, source: str) -> None:
    """Run a cell by itself; its source is kept, so that models defined in it find their definition."""
    name = f"<solution in {chapter}, {hash(source)}>"
    linecache.cache[name] = (len(source), None, source.splitlines(keepends=True), name)
    exec(compile(source, name, "exec"), {"__name__": "__main__"})


@pytest.mark.parametrize(
    ("notebook", "source"), [pytest.param(n, s, id=f"{n.stem}-{i}") for i, (n, s) in enumerate(solutions())]
)
def test_published_solutions_run_by_themselves(notebook, source, capsys, monkeypatch):
    monkeypatch.chdir(notebook.parent)
    run(notebook.stem, source)
    checked = re.findall(r"""check\(\s*["'](\w+\.\d+)["']""", source)
    printed = capsys.readouterr().out
    assert [n for n in checked if f"Exercise {n} accepted" not in printed] == []


def test_every_exercise_has_a_solution_in_its_own_chapter_of_the_book():
    assert KNOWN, "no exercise is registered"
    checks = [(page.stem, n) for page, s in solutions() for n in re.findall(r"""check\(\s*["'](\w+\.\d+)["']""", s)]
    published = {n for chapter, n in checks if chapter == n.split(".")[0]}
    assert not sorted(set(KNOWN) - published), "registered, but no cell tagged `solution` checks it"
    assert not sorted(published - set(KNOWN)), "checked in a chapter, but not registered"


@pytest.mark.parametrize(("number", "candidate"), [pytest.param(n, f, id=f"{n}: {why}") for n, why, f in WRONG])
def test_wrong_solutions_are_rejected_for_a_reason(number, candidate):
    with pytest.raises(Rejected) as caught:
        check(number, candidate)
    assert caught.value.__cause__ is None, "rejected only because it crashed: that is not a plausible wrong solution"


@pytest.mark.parametrize("least", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6])
def test_a_right_arc_may_branch_at_any_small_turn(least):
    def predict(x, P, u, U):
        (length, turn), half = u, u[1] / 2
        chord = 1.0 if abs(turn) < least else np.sin(half) / half
        slope = 0.0 if abs(turn) < least else (np.cos(half) - chord) / turn
        ahead = np.array([np.cos(x[2] + half), np.sin(x[2] + half)])
        left = np.array([-ahead[1], ahead[0]])
        F, G = np.eye(3), np.zeros((3, 2))
        F[:2, 2] = length * chord * left
        G[:2] = np.stack([chord * ahead, length * (slope * ahead + chord * left / 2)], -1)
        G[2, 1] = 1
        return x + np.append(length * chord * ahead, turn), F @ P @ F.T + G @ U @ G.T

    check("motion_models.1", predict)


def test_every_exercise_has_two_wrong_solutions():
    count = Counter(number for number, _, _ in WRONG)
    assert not [n for n in KNOWN if count[n] < 2]
    assert not [n for n in count if n not in KNOWN]


# -- the framework itself ----------------------------------------------------------------------------------------------


@pytest.fixture
def doubling():
    @exercise("99.1", "twice a vector")
    def _check(candidate):
        kit.same(candidate(np.array([1.0, 2])), [2, 4], "twice the vector")

    yield "99.1"
    kit.KNOWN.pop("99.1")


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
        (lambda x: 2 * x * (1 + 1e-7), r"found \[2.0000002 4.0000004\].*asks for \[2. 4.\]"),
        (lambda x: None, "returned None"),
        (lambda x: x[0], r"for the input \(\[1. 2.\]\): .*should have shape"),
        (lambda x: x * np.nan, r"for the input \(\[1. 2.\]\): .*nan or infinity"),
        (lambda x: x["a"], "raised IndexError"),
        (lambda x: "a", "should be an array of numbers"),
        (in_place, "changed its argument in place"),
        (lambda: 0, "raised TypeError"),
    ],
)
def test_what_is_wrong_is_reported(doubling, candidate, message):
    with pytest.raises(Rejected, match=message):
        check(doubling, candidate)


def test_a_landmark_is_shown_by_the_numbers_that_it_has():
    """Not by the cosine and the sine of an angle, in which two angles are the same after a whole turn."""
    with pytest.raises(Rejected, match="a new landmark moves with its robot") as found:
        check("observability.1", wrong.anchor_stays)
    shown = re.search(r"found \[(.*)\], the property asks for \[(.*)\]", str(found.value))
    assert [len(numbers.split()) for numbers in shown.groups()] == [4, 4]


def test_a_small_negative_number_is_shown_as_more_than_a_sign():
    with pytest.raises(Rejected, match=r"found \[-1\.e-06 +0\.e\+00\], the property asks for \[0\. 0\.\]"):
        kit.same([-1e-6, 0.0], [0.0, 0.0], "nothing")


def test_an_unknown_exercise_is_named_with_the_known_ones():
    with pytest.raises(UnknownNameError, match=r"unknown exercise 'slam_in_five_minutes\.99'"):
        check("slam_in_five_minutes.99", len)


def test_a_number_that_is_not_quoted_is_named_too():
    with pytest.raises(UnknownNameError, match=r"unknown exercise 99\.1"):
        check(99.1, len)


def test_what_held_before_the_rejection_is_printed(capsys):
    @exercise("99.2", "two properties")
    def _check(candidate):
        kit.same(candidate(1.0), 2.0, "doubles one")
        a, b = candidate(3.0)
        kit.same(a, b, "never reached")

    try:
        with pytest.raises(Rejected, match="cannot be used: TypeError: cannot unpack") as caught:
            check("99.2", lambda x: 2 * x)
        assert capsys.readouterr().out == "  so far: doubles one\n"
        assert isinstance(caught.value.__cause__, TypeError)
    finally:
        kit.KNOWN.pop("99.2")


def test_a_property_that_fails_for_a_later_case_is_not_said_to_hold(capsys):
    @exercise("99.4", "a property of every case")
    def _check(candidate):
        for x in kit.cases((1.0, 2.0), "x = {}"):
            kit.holds(candidate(x) > 0, "it is positive")
            kit.holds(candidate(x) < 1.5, "it is small")

    try:
        with pytest.raises(Rejected, match=r"it is small, for x = 2\.0"):
            check("99.4", lambda x: x)
        assert capsys.readouterr().out == "  so far: it is positive\n"
    finally:
        kit.KNOWN.pop("99.4")


@pytest.mark.parametrize("pair", [(1.0, 2.0), [1.0, 2.0], np.array([1.0, 2.0])])
def test_a_pair_may_be_a_tuple_a_list_or_an_array(pair):
    assert kit.parts(pair, {"the mean": (), "the variance": ()}) == [1.0, 2.0]


@pytest.mark.parametrize("other", [1.0, np.array(1.0), (1.0, 2.0, 3.0), np.ones(3)])
def test_what_is_no_pair_is_told_so(other):
    with pytest.raises(Rejected, match=r"return the pair \(the mean, the variance\), but returned"):
        kit.parts(other, {"the mean": (), "the variance": ()})


def test_a_number_is_given_once():
    def other(candidate):
        pass

    other.__module__ = "elsewhere"
    exercise("99.3", "first")(lambda candidate: None)
    try:
        with pytest.raises(SlamlibError, match=r"99\.3 is registered twice"):
            exercise("99.3", "second")(other)
    finally:
        kit.KNOWN.pop("99.3")


def guarded(function):
    return kit.Found(function).candidate


def test_arrays_inside_lists_and_named_arguments_are_guarded_too():
    def inside(pieces, scale):
        pieces[0] *= scale
        return pieces

    with pytest.raises(Rejected, match="in place"):
        guarded(inside)([np.ones(2)], scale=np.array(2.0))
    assert guarded(lambda x, scale: x * scale)(np.array([np.nan, 1.0]), scale=2)[1] == 2.0


def test_a_reader_sees_the_message_and_the_own_line_only():
    with pytest.raises(Rejected) as caught:
        guarded(lambda x: x["a"])(np.ones(2))
    shown = "\n".join(caught.value._render_traceback_())
    assert shown.startswith("Rejected: for the input ([1. 1.]) your function raised IndexError")
    assert "test_exercises.py" in shown
    assert "kit.py" not in shown


TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


@pytest.mark.parametrize(
    ("judge", "good", "bad"),
    [
        (lambda x: kit.same(x, [1.0, 2.0], "p"), [1.0, 2.0], [1.0, 2.0 + 1e-6]),
        (lambda x: kit.covariance(x, 2, "p"), np.diag([1.0, 0.0]), np.array([[1.0, 0.1], [0.0, 1.0]])),
        (lambda x: kit.covariance(x, 2, "p"), np.eye(2), np.array([[1.0, 2.0], [2.0, 1.0]])),
        (lambda x: kit.rotation_matrix(x, "p"), TURN, np.diag([1.0, 1.0, -1.0])),
        (lambda x: kit.rotation_matrix(x, "p"), TURN[:2, :2], 1.001 * TURN),
        (lambda x: kit.between(x, 0.9, 1.1, "p"), 1.0, 1.2),
        (lambda x: kit.between(x, 0.9, 1.1, "p"), 0.9, np.nan),
    ],
)
def test_each_property_accepts_what_has_it_and_rejects_what_lacks_it(judge, good, bad):
    judge(good)
    with pytest.raises(Rejected, match="p"):
        judge(bad)


def test_the_batch_oracle_minimises_the_sum_of_squares():
    rng = np.random.default_rng(5)
    mean, P = rng.standard_normal(3), np.diag([1.0, 2.0, 3.0])
    batch = [(rng.standard_normal((2, 3)), rng.standard_normal(2), np.diag([0.5, 0.1])) for _ in range(4)]

    def cost(x):
        prior = (x - mean) @ np.linalg.solve(P, x - mean)
        return prior + sum((y - H @ x) @ np.linalg.solve(R, y - H @ x) for H, y, R in batch)

    best, covariance = kit.least_squares(mean, P, batch)
    steps = 0.01 * rng.standard_normal((20, 3))
    for d in steps:  # the cost is exactly quadratic, with the inverse of the covariance as its curvature
        assert cost(best + d) - cost(best) == pytest.approx(d @ np.linalg.solve(covariance, d), rel=1e-6)
