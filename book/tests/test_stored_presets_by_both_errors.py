"""The file of both errors by preset belongs to the filters as they are, and to the file of chapter observability."""

import numpy as np
import pytest
from slambook.filters_compared import rows_of_both_errors

from book.experiments import consistency, presets_by_both_errors, stored
from book.tests.stored_results import comes_out_again
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.experiments.monte_carlo import seeds

KEPT = stored.kept(presets_by_both_errors.FILE)
RENEW = "run `make presets-by-both-errors`"
SHORT = [consistency.START, *(name for name in KEPT if name.startswith(consistency.LEARNED))]


def test_form_of_the_file_has_both_errors_of_as_many_runs_as_it_says():
    assert {consistency.START, "eucPnt", "idpPnt", "hmgPnt"} <= set(KEPT) <= set(consistency.cases())
    for case, found in KEPT.items():
        assert list(found) == ["runs", *presets_by_both_errors.filters(case)], RENEW
        for name in presets_by_both_errors.filters(case):
            assert list(found[name]) == list(ERRORS)
            shapes = {np.shape(sets) for sets in found[name].values()}
            assert shapes == {(len(consistency.SEEDS), found["runs"])}, RENEW


def test_the_linear_nees_is_that_of_the_chapters_file_to_the_digit():
    there = stored.kept(consistency.FILE)["cases"]
    for case, found in KEPT.items():
        for name in presets_by_both_errors.filters(case):
            own = [there[case][name][str(number)]["own"][: found["runs"]] for number in consistency.SEEDS]
            assert found[name]["linear"] == own, RENEW


@pytest.mark.parametrize("case", SHORT)
def test_a_whole_run_comes_out_again(case):
    number = consistency.SEEDS[-1]
    for name in presets_by_both_errors.filters(case):
        found = presets_by_both_errors.means(consistency.cases()[case], seeds(number, 1)[0], name)
        comes_out_again(found, {error: KEPT[case][name][error][-1][0] for error in ERRORS}, RENEW, places=3)


def test_runs_that_are_missing_are_joined_to_those_that_are_there():
    case, name = f"{consistency.LEARNED}0", "world"
    before = {error: [own[:1] for own in sets] for error, sets in KEPT[case][name].items()}
    found = presets_by_both_errors.joined(case, name, before, 2)
    assert {error: [own[:2] for own in sets] for error, sets in KEPT[case][name].items()} == found


def test_other_runs_than_the_chapters_are_refused():
    case, name = f"{consistency.LEARNED}0", "world"
    before = {error: [[own[0] + 0.001] for own in sets] for error, sets in KEPT[case][name].items()}
    with pytest.raises(ValueError, match="extrinsics x 0, world, set 17"):
        presets_by_both_errors.joined(case, name, before, 1)


def test_stored_claim_both_errors_are_one_where_the_start_is_known():
    """And only there: of a start known to 5 degrees the invariant one alone is near six."""
    for case, found in KEPT.items():
        linear, invariant = (np.concatenate(found["world"][error]) for error in ERRORS)
        if case == consistency.START:
            assert linear.mean() > 1.5 * invariant.mean()
            assert abs(invariant.mean() - 6) < 2.5 * invariant.std(ddof=1) / np.sqrt(len(invariant))
        else:
            np.testing.assert_allclose(invariant, linear, rtol=0.02)


def test_the_table_says_how_many_runs_a_case_has():
    rows = rows_of_both_errors(KEPT, [consistency.START])
    assert [row[0] for row in rows[1:]] == ["local", "world"]
    assert rows[0] == f"{consistency.START}, 2 x {KEPT[consistency.START]['runs']} runs"
    invariant = np.array(KEPT[consistency.START]["world"]["invariant"])
    error = invariant[1].std(ddof=1) / np.sqrt(len(invariant[1]))
    assert rows[2][4] == f"{invariant[1].mean():.2f} ± {error:.2f}"
    assert rows[2][5] == pytest.approx(np.median(invariant))
