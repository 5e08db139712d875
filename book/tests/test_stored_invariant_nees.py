"""Stored NEES of the linear and of the invariant error: what the runs are, and some of them run again."""

import numpy as np
import pytest

from book.experiments import invariant_nees, stored
from book.tests.stored_results import comes_out_again
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.experiments.monte_carlo import seeds

RENEW = "run `make invariant-nees` and `python -m book.tools.notebooks run` for chapter observability"
KEPT = stored.kept(invariant_nees.FILE)
ROWS = [(case, name) for case in invariant_nees.cases() for name in invariant_nees.filters(case)]


def test_form_of_the_file_has_both_errors_of_each_start_by_each_filter_in_two_sets_of_seeds():
    assert [(case, name) for case, rows in KEPT.items() for name in rows] == ROWS, RENEW
    for case, name in ROWS:
        row = KEPT[case][name]
        assert [*row] == [*ERRORS, "first"]
        assert {np.shape(row[error]) for error in ERRORS} == {(len(invariant_nees.SEEDS), invariant_nees.RUNS)}, RENEW


@pytest.mark.parametrize(("case", "name"), ROWS)
def test_the_first_numbers_come_out_again(case, name):
    comes_out_again(invariant_nees.first_frames(case, name), KEPT[case][name]["first"], RENEW)


@pytest.mark.parametrize("case", ["plane, 20 degrees", "space, 5 degrees"])
def test_a_whole_run_comes_out_again(case):
    number, judged = invariant_nees.SEEDS[-1], invariant_nees.JUDGED
    found = invariant_nees.both(invariant_nees.cases()[case], seeds(number, 1)[0], "world")
    kept = {error: KEPT[case]["world"][error][-1][0] for error in ERRORS}
    comes_out_again({error: nees[judged].mean() for error, nees in found.items()}, kept, RENEW)


def test_stored_claim_a_filter_that_keeps_the_invariant_error_is_consistent_in_it_whatever_the_start():
    for case in invariant_nees.cases():
        dof = 3 if case.startswith("plane") else 6
        own = np.concatenate(KEPT[case]["world"]["invariant"])
        assert abs(own.mean() - dof) < 2.5 * own.std(ddof=1) / np.sqrt(len(own))
