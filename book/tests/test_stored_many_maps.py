"""The file of `make many-maps` belongs to the code as it is, and chapter many says of it what it says."""

import numpy as np
import pytest

from book.experiments import many_maps
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from slamlib.evaluation.consistency import band

WAYS = {"one map, local", "one map, world", "many maps, local", "many maps, world", "all data"}
AT_ONCE = "all data"


@pytest.fixture(scope="module")
def stored():
    return results.kept(many_maps.FILE)


def column(stored, name, i):
    return {number: np.array(runs[name])[:, i] for number, runs in stored.items()}


def test_form_of_the_file(stored):
    assert list(stored) == [str(number) for number in many_maps.SETS]
    for runs in stored.values():
        assert set(runs) == WAYS
        assert {np.shape(rows) for rows in runs.values()} == {(many_maps.RUNS, 3)}


def test_the_first_run_comes_out_again(stored):
    """All but least squares to its digits, which ends where its steps gain nothing more."""
    number = many_maps.SETS[1]
    found, kept = many_maps.run(number, 0), {name: rows[0] for name, rows in stored[str(number)].items()}
    renew = "run `make many-maps`"
    comes_out_again(found.pop(AT_ONCE), kept.pop(AT_ONCE), renew, digits=3)
    comes_out_again(found, kept, renew)


def test_stored_claim_the_ordinary_filter_is_overconfident_in_one_map_and_the_transport_is_not(stored):
    low, high = band(6, many_maps.RUNS)
    for ways, inside in ((("one map, local",), False), (("one map, world", "many maps, world", AT_ONCE), True)):
        for name in ways:
            assert all((low < runs.mean() < high) == inside for runs in column(stored, name, 2).values()), name


def less(stored, name, other, i):
    """Difference run by run: mean and standard error, of both sets."""
    values = np.concatenate([*column(stored, name, i).values()]) - np.concatenate([*column(stored, other, i).values()])
    return values.mean(), values.std(ddof=1) / np.sqrt(len(values))


def test_stored_claim_many_maps_help_the_ordinary_filter_and_less_than_the_transport_does(stored):
    mean, error = less(stored, "many maps, local", "one map, local", 2)
    assert mean < -5 * error
    mean, error = less(stored, "many maps, local", "one map, world", 2)
    assert mean > 3 * error
    assert less(stored, "many maps, world", "one map, world", 2)[0] > 0


def test_stored_claim_with_the_transport_one_map_is_consistent_and_so_are_many_and_all_data(stored):
    for name in ("one map, world", "many maps, world", AT_ONCE):
        runs = np.concatenate([*column(stored, name, 2).values()])
        assert abs(runs.mean() - 6) < 2 * runs.std(ddof=1) / np.sqrt(len(runs)), name


def test_stored_claim_the_last_pose_is_equally_accurate_to_a_millimetre(stored):
    for name in WAYS - {AT_ONCE}:
        assert abs(less(stored, name, AT_ONCE, 0)[0]) < 0.001, name
