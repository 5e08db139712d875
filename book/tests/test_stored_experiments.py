"""The file of chapter toolbox_tour's experiments belongs to the presets and to the filter as they are."""

import json
from dataclasses import replace

import numpy as np
import pytest

from book.tools import experiments
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import PRESETS
from slamlib.landmarks import LINES, POINTS

pytestmark = pytest.mark.skipif(not experiments.FILE.is_file(), reason="run `make experiments` first")
RENEW = "run `make experiments` and `python -m book.tools.notebooks run` for chapter toolbox_tour"


@pytest.fixture(scope="module")
def stored():
    return json.loads(experiments.FILE.read_text("utf-8"))


def test_every_preset_and_parametrization_is_there_with_enough_runs(stored):
    wanted = [("preset", PRESETS), ("points", POINTS), ("lines", LINES)]
    assert {f"{group} {name}" for group, names in wanted for name in names} <= set(stored["cases"])
    assert stored["runs"] >= 100


def test_the_presets_are_still_the_same(stored):
    now = {name: experiments.digest(preset) for name, preset in experiments.cases().items()}
    assert {name: case["digest"] for name, case in stored["cases"].items()} == now, RENEW


@pytest.mark.parametrize("name", [n for n in experiments.cases() if not n.startswith("switch")])
def test_the_first_numbers_come_out_again(stored, name):
    first = np.array(stored["cases"][name]["first"])
    runs, frames = first.shape
    preset = replace(experiments.cases()[name], frames=frames)
    found = monte_carlo(preset, runs, seed=stored["seed"]).nees[:, :, 0]
    np.testing.assert_allclose(found, first, rtol=1e-5, atol=1e-3, err_msg=RENEW)


def test_all_data_at_once_stand_beside_the_filter_in_two_sets_of_seeds(stored):
    assert stored["sets"] == list(experiments.SETS)
    for name, case in stored["cases"].items():
        asked = {str(number) for number in experiments.SETS} if name.startswith(experiments.AT_ONCE) else set()
        assert set(case.get("at once", {})) == asked, RENEW
        shapes = {np.shape(rows["runs"]) for rows in case.get("at once", {}).values()}
        assert shapes == ({(experiments.SMOOTHED, 2, 3)} if asked else set()), RENEW


@pytest.mark.parametrize("name", [n for n in experiments.cases() if n.startswith(experiments.AT_ONCE)])
def test_a_short_run_comes_out_again_by_the_filter_and_by_all_data_at_once(stored, name):
    preset = replace(experiments.cases()[name], frames=experiments.FIRST_SMOOTHED)
    for number, rows in stored["cases"][name]["at once"].items():
        found = experiments.smoothed(preset, experiments.seeds(int(number), 1)[0])
        np.testing.assert_allclose(found, rows["first"], rtol=1e-3, atol=1e-4, err_msg=RENEW)


def test_averages_and_shares_agree(stored):
    low, high = stored["band"]
    for case in stored["cases"].values():
        for average, inside in zip(case["nees"], case["inside"], strict=True):
            assert len(average) == case["frames"]
            edge = 0.01 * 0.5 + 1e-9  # a rounded average may lie on the other side of the band's edge
            sure = np.mean([low + edge < value < high - edge for value in average])
            maybe = np.mean([low - edge < value < high + edge for value in average])
            assert sure - 1e-3 <= inside <= maybe + 1e-3
