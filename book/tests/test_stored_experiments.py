"""The file of chapter toolbox_tour's experiments belongs to the presets and to the filter as they are."""

from dataclasses import replace

import numpy as np
import pytest
from slambook.filters_compared import FILTERS, run

from book.experiments import stored as results
from book.experiments import toolbox_tour
from book.tests.stored_results import comes_out_again
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import OF_TOOLBOX
from slamlib.landmarks import LINES, POINTS

RENEW = "run `make experiments` and `python -m book.tools.notebooks run` for chapter toolbox_tour"
CASES = toolbox_tour.cases()
SLOW = "preset points_and_lines"


@pytest.fixture(scope="module")
def stored():
    return results.kept(toolbox_tour.FILE)


def test_form_of_the_file_has_every_preset_and_parametrization_with_enough_runs(stored):
    of_space = [name for name in POINTS if not POINTS[name].plane]
    wanted = [("preset", [f.__name__ for f in OF_TOOLBOX]), ("points", of_space), ("lines", LINES)]
    assert {f"{group} {name}" for group, names in wanted for name in names} <= set(stored["cases"])
    assert stored["runs"] >= 100


def test_the_presets_are_still_the_same(stored):
    now = {name: toolbox_tour.digest(preset) for name, preset in CASES.items()}
    assert {name: case["digest"] for name, case in stored["cases"].items()} == now, RENEW


@pytest.mark.parametrize("name", [n for n in CASES if not n.startswith("switch")])
def test_the_first_numbers_come_out_again(stored, name):
    first = stored["cases"][name]["first"][:1]  # of one run: a second one costs as much and would tell the same
    preset = replace(CASES[name], frames=len(first[0]))
    found = monte_carlo(preset, len(first), seed=stored["seed"]).nees[:, :, 0]
    comes_out_again(found, first, RENEW, digits=5, places=3)


def test_form_of_the_file_has_all_data_at_once_beside_the_filter_in_two_sets_of_seeds(stored):
    assert stored["sets"] == list(toolbox_tour.SETS)
    for name, case in stored["cases"].items():
        asked = {str(number) for number in toolbox_tour.SETS} if name.startswith(toolbox_tour.AT_ONCE) else set()
        assert set(case.get("at once", {})) == asked, RENEW
        shapes = {np.shape(rows["runs"]) for rows in case.get("at once", {}).values()}
        assert shapes == ({(toolbox_tour.SMOOTHED, 2, 3)} if asked else set()), RENEW


def seed(number):
    """The first one of a set."""
    return toolbox_tour.seeds(number, 1)[0]


@pytest.mark.parametrize(
    ("name", "number"),
    [(n, toolbox_tour.SETS[0]) for n in CASES if n.startswith(toolbox_tour.AT_ONCE) and n != SLOW]
    + [("theory linear", number) for number in toolbox_tour.SETS[1:]],  # in the other sets, the one that takes least
)
def test_a_short_run_comes_out_again_by_the_filter_and_by_all_data_at_once(stored, name, number):
    preset = replace(CASES[name], frames=toolbox_tour.FIRST_SMOOTHED)
    found = toolbox_tour.smoothed(preset, seed(number))
    comes_out_again(found, at_once(stored, name, number)["first"], RENEW, places=5)  # a machine decides the fifth digit


def test_a_short_run_of_points_and_lines_comes_out_again_by_the_filter(stored, monkeypatch):
    """All its data at once take 19 s, more than all else in this file: of them the form alone is checked."""
    monkeypatch.setattr(toolbox_tour, "beside", lambda *given: [run(*given, FILTERS[0])])
    (found,) = toolbox_tour.smoothed(
        replace(CASES[SLOW], frames=toolbox_tour.FIRST_SMOOTHED), seed(toolbox_tour.SETS[0])
    )
    comes_out_again(found, at_once(stored, SLOW, toolbox_tour.SETS[0])["first"][0], RENEW, places=5)


def test_a_whole_run_comes_out_again_by_the_filter_and_by_all_data_at_once(stored):
    name = "theory start known to 0.1 degrees"  # the shortest: 200 frames
    found = toolbox_tour.smoothed(CASES[name], seed(toolbox_tour.SETS[0]))
    comes_out_again(found, at_once(stored, name, toolbox_tour.SETS[0])["runs"][0], RENEW, places=5)


def at_once(stored, name, number):
    """What is stored of a case and a set of seeds by the filter and by all data at once."""
    return stored["cases"][name]["at once"][str(number)]


def test_form_of_averages_and_shares_is_that_they_agree(stored):
    low, high = stored["band"]
    for case in stored["cases"].values():
        for average, inside in zip(case["nees"], case["inside"], strict=True):
            assert len(average) == case["frames"]
            edge = 0.01 * 0.5 + 1e-9  # a rounded average may lie on the other side of the band's edge
            sure = np.mean([low + edge < value < high - edge for value in average])
            maybe = np.mean([low - edge < value < high + edge for value in average])
            assert sure - 1e-3 <= inside <= maybe + 1e-3
