"""The file of chapter observability's experiments belongs to the presets and to the filters as they are."""

import json
from dataclasses import replace

import numpy as np
import pytest
from slambook.filters_compared import ALL_DATA, Verdict, run

from book.tools import consistency
from book.tools.experiments import digest

RENEW = "run `make experiments` and `python -m book.tools.notebooks run` for chapter observability"
CASES = consistency.cases()


@pytest.fixture(scope="module")
def stored():
    return json.loads(consistency.FILE.read_text("utf-8"))


def test_every_case_is_there_and_still_the_same(stored):
    assert {name: case["digest"] for name, case in stored["cases"].items()} == {
        name: digest(preset) for name, preset in CASES.items()
    }, RENEW
    for name, case in stored["cases"].items():
        for filter_name in consistency.filters(name):
            sets = [case[filter_name][str(number)] for number in consistency.SEEDS]
            assert [len(s["own"]) for s in sets] == [s["runs"] for s in sets] == [sets[0]["runs"]] * 2, RENEW


def test_what_is_said_of_the_runs_follows_from_their_numbers(stored):
    for name, case in stored["cases"].items():
        for filter_name in consistency.filters(name):
            for said in case[filter_name].values():
                verdict = Verdict(np.array(said["own"]), np.array(said["average"]).T).numbers()
                assert {key: said[key] for key in verdict} == pytest.approx(verdict, abs=6e-4), name


@pytest.mark.parametrize("name", CASES)
def test_the_first_numbers_come_out_again(stored, name):
    frames, number = consistency.FIRST_FRAMES, consistency.SEEDS[0]
    for filter_name in set(consistency.filters(name)) - {ALL_DATA}:  # it looks back from the last frame
        first = stored["cases"][name][filter_name][str(number)]["first"]
        found = run(replace(CASES[name], frames=frames), consistency.seeds(number, 1)[0], filter_name)
        np.testing.assert_allclose(found["nees"][:, 0], first, rtol=1e-4, atol=1e-2, err_msg=RENEW)
