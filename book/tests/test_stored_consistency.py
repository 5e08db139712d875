"""The file of chapter observability's experiments belongs to the presets and to the filters as they are."""

from dataclasses import replace

import numpy as np
import pytest
from slambook.filters_compared import ALL_DATA, Verdict, run

from book.experiments import consistency
from book.experiments import stored as results
from book.experiments.toolbox_tour import digest
from book.tests.stored_results import comes_out_again

RENEW = "run `make experiments` and `python -m book.tools.notebooks run` for chapter observability"
CASES = consistency.cases()


@pytest.fixture(scope="module")
def stored():
    return results.kept(consistency.FILE)


def test_form_of_the_file_and_its_presets_are_those_of_now(stored):
    assert {name: case["digest"] for name, case in stored["cases"].items()} == {
        name: digest(preset) for name, preset in CASES.items()
    }, RENEW
    for name, case in stored["cases"].items():
        for filter_name in consistency.filters(name):
            sets = [case[filter_name][str(number)] for number in consistency.SEEDS]
            assert [len(s["own"]) for s in sets] == [s["runs"] for s in sets] == [sets[0]["runs"]] * 2, RENEW


def test_what_is_said_of_the_stored_runs_comes_out_again(stored):
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
        comes_out_again(found["nees"][:, 0], first, RENEW, digits=5, places=3)


@pytest.mark.parametrize(
    ("name", "filter_name"), [(f"{consistency.LEARNED}1", ALL_DATA), (f"{consistency.LEARNED}0", "world")]
)
def test_a_whole_run_comes_out_again(stored, name, filter_name):
    """Of the shortest cases, 60 frames: those of 400 take as long as all other checks of this file."""
    number, kept = consistency.SEEDS[0], stored["cases"][name][filter_name]
    found = run(CASES[name], consistency.seeds(number, 1)[0], filter_name)
    made = {"own": found["nees"].mean(), "position": np.sqrt((found["position"] ** 2).mean())}
    comes_out_again(made, {key: kept[str(number)][key][0] for key in made}, RENEW)
