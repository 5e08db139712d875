"""The stored figures of chapter stereo_ekf_slam and of the pages on the report belong to the package as it is."""

import numpy as np
import pytest
from slambook import kitti_street
from slambook.report.findings import ran
from slambook.smoothing import Smoother

from book.experiments import stereo_room, stereo_slam, street
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from slamlib.evaluation.consistency import band, share_inside

RENEW = "run `make stereo-slam`, and the notebooks stereo_ekf_slam, report_audited, report_experiments"


@pytest.fixture(scope="module")
def stored():
    return results.kept(stereo_slam.FILE)


def test_form_of_the_file_is_every_part(stored):
    assert sorted(stored) == sorted(stereo_slam.PARTS), RENEW


def test_the_last_repairs_come_out_again(stored):
    for row, errors in zip(stored["repairs"]["gentle"][-2:], (stereo_slam.ORDER[-1:], []), strict=True):
        comes_out_again(stereo_slam.summary(ran("gentle", *errors)), {k: row[k] for k in row if k != "repaired"}, RENEW)


def test_a_row_of_wrong_covariances_comes_out_again(stored, monkeypatch):
    monkeypatch.setattr(stereo_slam, "FACTORS", (2.0,))
    comes_out_again(stereo_slam.tuning(), [row for row in stored["tuning"] if row["factor"] == 2], RENEW)


def test_shares_inside_come_out_again_of_the_stored_averages(stored):
    for name in [*stereo_room.WAYS, "all data"]:
        row = stored["ways"][name]
        halves = np.split(6 * np.array(row["nees"]), [len(row["nees"]) // 2])
        found = [share_inside(half, band(6, stored["ways"]["seeds"])) for half in halves]
        comes_out_again(found, row["inside"], RENEW, places=3)


def test_the_beginning_of_a_run_in_the_room_comes_out_again(stored):
    """Ten pairs of pictures, by the filter and by all data at once, take 6 s; a row of the file has 150, or 900."""
    pytest.importorskip("cv2")
    # Of an error of 1.4 mm, 3 micrometres: some ten-thousandths of a pixel, which a machine may decide.
    comes_out_again(stereo_room.light(), stored["light"], RENEW, share=2e-3)


def test_the_beginning_once_round_comes_out_again_by_each_of_the_eight_filters(stored):
    """Ten pairs of a film; the file has films of 900."""
    pytest.importorskip("cv2")
    found = stereo_room.beginning()
    comes_out_again(found, stored["beginning"], RENEW, share=2e-3)  # as below
    for ordinary, invariant in zip(found[:4], found[4:], strict=True):  # they differ by less than that, but they do
        assert (ordinary["error"], invariant["error"]) == stereo_room.ERRORS
        assert ordinary["quarters"] != invariant["quarters"]


SETS = {"turns": stereo_room.TURN_SEEDS, "turns, other seeds": stereo_room.OTHER_SEEDS}


def runs(stored, error, interval, motions=stereo_room.MOTIONS):
    """The runs of both sets by one error and one interval, by these sources of the motion."""
    rows = [row for name in SETS for row in stored[name] if row["motion"] in motions]
    return [row for row in rows if (row["error"], row["interval"]) == (error, interval)]


def test_form_of_both_sets_is_a_run_of_each_filter_for_each_film(stored):
    for name, seeds in SETS.items():
        ways = {(row["error"], row["motion"], row["interval"]) for row in stored[name]}
        assert len(stored[name]) == len(ways) * len(seeds), RENEW
        assert len([way for way in ways if way[0] != "all data"]) == 8


def test_form_of_the_figures_runs_is_that_of_the_same_films_in_the_table(stored):
    for error in stereo_room.ERRORS:
        for interval in stereo_room.INTERVALS:
            rows = runs(stored, error, interval, stereo_room.MOTIONS[:1])
            wanted = [row for row in stored["round"]["runs"] if (row["error"], row["interval"]) == (error, interval)]
            assert len(wanted) == len(stereo_room.ROUND_SEEDS)
            for drawn, row in zip(wanted, rows, strict=False):
                comes_out_again({name: drawn[name] for name in ("rms", "end", "quarters", "old")},
                                {name: row[name] for name in ("rms", "end", "quarters", "old")}, RENEW)  # fmt: skip


def test_stored_claim_one_pair_in_ten_or_the_right_invariant_error_closes_every_loop(stored):
    for error, interval in (("local", 10), ("world", 1), ("world", 10)):
        assert all(row["old"] > 0 for row in runs(stored, error, interval))
    films = len(SETS["turns"]) + len(SETS["turns, other seeds"])
    closed = [row["old"] > 0 for row in runs(stored, "local", 1)]
    assert len(closed) == 2 * films
    assert sum(closed) < films / 5
    assert not any(row["old"] > 0 for row in runs(stored, "local", 1, stereo_room.MOTIONS[:1]))


def test_stored_claim_red_and_green_claim_the_same_before_the_return_and_red_errs_more(stored):
    at = slice(700 // stereo_room.EVERY, 780 // stereo_room.EVERY)  # pairs, before the first landmarks come back
    by = {key: [row for row in stored["round"]["runs"] if (row["error"], row["interval"]) == key]
          for key in (("local", 1), ("world", 1), ("local", 10))}  # fmt: skip
    for red, green, blue in zip(*by.values(), strict=True):
        claims = [np.mean(row["claimed"][at]) for row in (red, green, blue)]
        errors = [np.mean(row["away"][at]) for row in (red, green, blue)]
        assert claims[1] == pytest.approx(claims[0], rel=0.05)
        assert 0.008 < claims[0] < 0.009 < 3 * claims[0] < claims[2]
        assert 0.03 < errors[0] < 0.04
        assert errors[0] > 1.7 * errors[1]
        assert errors[2] < claims[2]


def test_stored_claim_all_data_at_once_are_nearer_on_the_way_in_every_film(stored):
    rms = {
        by: [r["rms"] for r in stored["turns"] if (r["error"], r["interval"]) == (by, 10)]
        for by in ("world", "all data")
    }
    assert len(rms["world"]) == len(rms["all data"]) == 20
    assert all(ours < filters for ours, filters in zip(rms["all data"], rms["world"], strict=True))


def test_stored_claim_on_the_street_all_data_at_once_are_as_good_as_the_filter(stored):
    for key in ("plain", "corrected", "turned"):
        best, own = (stored["street"][key][name] for name in (street.ALL_DATA, street.AT_ONCE))
        assert best["translation"] == pytest.approx(own["translation"], rel=0.02)
        assert best["rotation"] == pytest.approx(own["rotation"], rel=0.02)


@pytest.mark.skipif(kitti_street.found() is None, reason="KITTI's street is not at hand")
def test_the_streets_row_of_all_data_at_once_comes_out_again(stored):
    source, camera, truth = street.street()
    run = dict(street.runs(source, camera, 0.0, [street.AT_ONCE]))[street.AT_ONCE]
    smoother = Smoother(run.slam)
    street.finished(street.AT_ONCE, run, smoother)
    found = street.errors(street.at_once(run, smoother), truth)
    assert found == pytest.approx(stored["street"]["plain"][street.ALL_DATA], rel=0.01), RENEW
