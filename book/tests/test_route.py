"""The route of a frame through the filter: the chapter's steps in their order, none twice, nothing predicted twice."""

import json
from collections import Counter

import pytest
from slambook import route

from book.tools import layout
from slamlib.observation.points import PointFamily
from slamlib.slam import Slam


@pytest.fixture(scope="module")
def routes():
    return route.routes()


def test_each_frame_visits_the_steps_in_their_order_and_none_twice(routes):
    assert len(routes) == 2
    for found in routes.values():
        assert found.steps == list(route.STEPS)


def test_nothing_is_predicted_twice(routes):
    for found in routes.values():
        count = Counter(call.function for call in found.calls)
        for function in ("PointFamily.observe", "Family.predict_batch", "Family.linearized", "Family.residual"):
            assert count[function] == 1, function
        assert count["Family.batch_innovation"] == count["Family.innovation"] == 0


def test_the_steps_are_functions_that_there_are(routes):
    called = {call.function for found in routes.values() for call in found.calls}
    assert set(route.STEPS.values()) <= called
    convert, initialize = (list(found.calls) for found in routes.values())
    assert "to_euclidean" in {call.function for call in convert}
    assert {"Slam.prune", "Slam._initialize_one"} <= {call.function for call in initialize}


def test_a_step_that_comes_twice_is_seen(monkeypatch):
    def twice(self, *arguments, own=PointFamily.after_update):
        own(self, *arguments)
        slams[0].project()

    slams, init = [], Slam.__init__
    monkeypatch.setattr(Slam, "__init__", lambda self, *a, **k: (init(self, *a, **k), slams.insert(0, self))[0])
    monkeypatch.setattr(PointFamily, "after_update", twice)
    for found in route.routes().values():
        assert found.steps.count("project") == 2 or "convert" not in found.steps


def test_the_chapter_shows_the_steps():
    cells = json.loads((layout.BOOK / "chapters" / "ekf_slam.ipynb").read_text("utf-8"))["cells"]
    table = next(t for c in cells if "| step | question it answers" in (t := "".join(c["source"])))
    rows = [line.split("|")[2].strip() for line in table.splitlines() if line.startswith("| ") and "---" not in line]
    assert [row for row in rows if row in route.STEPS] == list(route.STEPS)
