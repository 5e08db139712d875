"""Two workers side by side, as the checks in the browser use them: order, failures, and that nothing is left undone."""

import contextlib
import threading
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
pytestmark = pytest.mark.skipif(not (ROOT / "book").is_dir(), reason="the book is not beside the package")


@pytest.fixture
def workers(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT))
    from book.tools import workers

    monkeypatch.setattr(workers, "WORKERS", 2)
    return workers


class Place:
    """What a worker enters: it notes who came and who left, and does `action` there."""

    def __init__(self, action, begin=None, end=None):
        self.action, self.begin, self.end = action, begin or (lambda: None), end or (lambda: None)
        self.entered, self.left = [], []

    @contextlib.contextmanager
    def __call__(self):
        self.entered.append(threading.get_ident())
        self.begin()
        try:
            yield self.action
        finally:
            self.left.append(threading.get_ident())
        self.end()


def failing(message):
    def raises(*_):
        raise RuntimeError(message)

    return raises


def test_two_work_at_the_same_time_and_results_come_in_the_order_of_the_items(workers):
    together = threading.Barrier(2, timeout=20)

    def action(item):
        if item < 2:
            together.wait()  # passes only if both are at work
        time.sleep(0.02 * (item % 2))
        return item**2, threading.get_ident()

    place = Place(action)
    found = list(workers.each(place, range(9)))
    assert [square for square, _ in found] == [i**2 for i in range(9)]
    assert {who for _, who in found} == set(place.entered)
    assert len(place.entered) == 2
    assert sorted(place.left) == sorted(place.entered)
    assert threading.get_ident() not in place.entered


def test_a_result_is_there_before_the_last_item_is_begun(workers):
    begun = []
    results = workers.each(Place(lambda item: begun.append(item) or time.sleep(0.05)), range(40))
    next(results)
    assert len(begun) < 40
    results.close()
    assert len(begun) < 40


def test_nothing_to_do_enters_nowhere(workers):
    place = Place(failing("never"))
    assert list(workers.each(place, [])) == []
    assert place.entered == []


def test_an_item_that_fails_is_raised_in_its_turn_and_nothing_new_is_begun(workers):
    begun = []

    def action(item):
        begun.append(item)
        time.sleep(0.02)
        return 1 / (item - 3)

    place = Place(action)
    results = workers.each(place, range(100))
    assert [next(results) for _ in range(3)] == [1 / -3, 1 / -2, 1 / -1]
    with pytest.raises(ZeroDivisionError):
        next(results)
    assert len(begun) < 50
    assert len(place.left) == 2


@pytest.mark.parametrize("items", [range(1), range(7)])
def test_a_worker_that_cannot_begin_is_a_failure(workers, items):
    with pytest.raises(RuntimeError, match="no browser"):
        list(workers.each(Place(lambda item: item, begin=failing("no browser")), items))


def test_one_worker_of_two_that_cannot_begin_is_a_failure_even_if_the_other_does_all(workers):
    turn = iter([None, failing("no second browser")])
    place = Place(lambda item: time.sleep(0.01), begin=lambda: (next(turn) or (lambda: None))())
    with pytest.raises(RuntimeError, match="no second browser"):
        list(workers.each(place, range(5)))


def test_a_worker_that_breaks_down_at_the_end_is_a_failure(workers):
    with pytest.raises(RuntimeError, match="would not close"):
        list(workers.each(Place(lambda item: item, end=failing("would not close")), range(3)))
