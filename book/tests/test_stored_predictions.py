"""The file of `make predictions` belongs to the code as it is, and the chapters say of it what it says."""

import numpy as np
import pytest

from book.experiments import consistency, predictions
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from slamlib.experiments.monte_carlo import seeds

RENEW = "run `make predictions`"
SIGMA = np.radians(1.5)  # of the roll at the start


@pytest.fixture(scope="module")
def stored():
    return results.kept(predictions.FILE)


def both(stored, part, name):
    return np.concatenate([np.array(stored[part][str(number)][name]) for number in predictions.SEEDS])


def test_form_of_the_file(stored):
    assert set(stored) == set(predictions.PARTS)
    counts = {
        "roll": predictions.RUNS,
        "nothing": 3,
        "scale": predictions.SCALE_RUNS,
        "exact": 100,
        "many measurements": predictions.RUNS,
    }
    for part, sets in stored.items():
        assert list(sets) == [str(number) for number in predictions.SEEDS]
        assert {len(column) for columns in sets.values() for column in columns.values()} == {counts[part]}


def first(stored, part):
    number = predictions.SEEDS[0]
    return seeds(number, 1)[0], {name: column[0] for name, column in stored[part][str(number)].items()}


def test_the_first_runs_come_out_again(stored):
    """All of the roll but what least squares makes of it, which ends where its steps gain nothing more."""
    seed, kept = first(stored, "roll")
    heard = predictions.frames(predictions.STRAIGHT, seed)
    found = {
        "local": predictions.filtered(heard, "local")[predictions.ROLL],
        "step told": predictions.filtered(heard, "world")[predictions.ROLL],
        "step made": predictions.carried(heard, lambda i: predictions.STRAIGHT[i])[predictions.ROLL],
        "step by the next picture": predictions.carried_twice(heard)[0][predictions.ROLL],
    }
    comes_out_again(found, {name: kept[name] for name in found}, RENEW)
    seed, kept = first(stored, "nothing")
    comes_out_again(results.plain(predictions.nothing(seed), 15), kept, RENEW)
    seed, kept = first(stored, "scale")
    comes_out_again(predictions.scale(seed), kept, RENEW, places=5)
    seed, kept = first(stored, "exact")
    comes_out_again(predictions.exact(seed), kept, RENEW)


def test_a_run_by_all_data_at_once_comes_out_again(stored):
    seed, kept = first(stored, "roll")
    found = predictions.smoothed(predictions.frames(predictions.STRAIGHT, seed))
    comes_out_again(list(found), [kept["all data"], kept["held"]], RENEW, digits=3)


def test_stored_claim_a_twentieth_is_taken_by_the_step_told_and_nothing_by_the_one_made(stored):
    assert np.round(both(stored, "roll", "step told").mean(), 2) == 0.95
    assert both(stored, "roll", "step made").min() > 0.995
    assert np.round(both(stored, "roll", "all data").mean(), 2) == 0.98
    assert np.round(both(stored, "roll", "step by the next picture").mean(), 2) == 0.98
    held = both(stored, "roll", "held")
    assert np.round(held.mean(), 2) == 1
    assert abs(held.mean() - 1) < 3 * held.std(ddof=1) / np.sqrt(len(held))


def test_stored_claim_no_more_is_taken_than_was_derived(stored):
    """Less than four by each step told, and less than one by each step estimated: (1 + 4 K s^2)^-1/2 of the roll."""
    least = {count: (1 + count * predictions.STEPS * SIGMA**2) ** -0.5 for count in (4, 1)}
    assert both(stored, "roll", "step told").min() > least[4]
    for name in ("all data", "step by the next picture"):
        assert both(stored, "roll", name).min() > least[1]


def test_stored_claim_who_carries_every_trade_learns_nothing(stored):
    assert both(stored, "nothing", "all trades").min() > 0.999
    told, made = (both(stored, "nothing", name) for name in ("step told", "step made"))
    assert np.sort(told, axis=1)[:, :5].max() < 0.35
    np.testing.assert_allclose(told, made, atol=0.01)


def test_stored_claim_the_scale_is_too_large_by_the_square_of_the_noise_in_what_was_told(stored):
    """More than nothing, less than 3 (sigma / d)^2, three times as much for twice the noise; and none in the truth."""
    for number in predictions.SEEDS:
        shares = {name: np.array(column) for name, column in stored["scale"][str(number)].items()}
        mean = {name: column.mean() for name, column in shares.items()}
        error = {name: column.std(ddof=1) / np.sqrt(len(column)) for name, column in shares.items()}
        for times in (1, 2):
            name = f"control, {times}"
            assert 3 * error[name] < mean[name] < 3 * (times * 0.005 / 0.08) ** 2
        assert mean["control, 2"] > 3 * mean["control, 1"]
        assert abs(mean["truth, 2"]) < 3 * error["truth, 2"]


def test_stored_claim_with_exact_pictures_the_scale_alone_is_as_biased_as_on_the_steps_told(stored):
    share = 3 * (0.005 / 0.08) ** 2
    expected = {
        "control, on the steps told": share, "control, with the steps": 0, "control, alone": share,
        "truth, on the steps told": 0, "truth, with the steps": -share, "truth, alone": 0,
    }  # fmt: skip
    for name, value in expected.items():
        column = both(stored, "exact", name)
        assert abs(column.mean() - value) < 4 * column.std(ddof=1) / np.sqrt(len(column)) + share**2, name


def test_stored_claim_with_many_measurements_the_bias_of_scale_is_of_the_square_of_the_noise(stored):
    """With half of the noise about a quarter of the bias of the whole one, and NEES nearer to six."""
    whole = results.kept(consistency.FILE)["cases"][consistency.BIASED]["world"]
    before = np.concatenate([whole[str(number)]["away"] for number in consistency.SEEDS])
    after = both(stored, "many measurements", "away")
    error = after.std(ddof=1) / np.sqrt(len(after))
    assert abs(after.mean() - before.mean() / 4) < 2 * error
    assert before.mean() / 2 - after.mean() > 2 * error
    nees = np.concatenate([whole[str(number)]["own"] for number in consistency.SEEDS])
    assert both(stored, "many measurements", "nees").mean() < nees.mean() - 1
