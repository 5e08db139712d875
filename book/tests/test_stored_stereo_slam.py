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


def test_stored_claim_a_landmark_in_every_pair_closes_the_loop_by_the_right_invariant_error_alone(stored):
    closed = dict.fromkeys(("local", "world"), 0)
    for row in stored["turns"]:
        if row["interval"] == 1:
            closed[row["error"]] += row["old"] > 0
    assert closed == {"local": 1, "world": 20}


def test_stored_claim_all_data_at_once_are_nearer_on_the_way_in_every_film(stored):
    rms = {
        by: [r["rms"] for r in stored["turns"] if (r["error"], r["interval"]) == (by, 10)]
        for by in ("world", "all data")
    }
    assert len(rms["world"]) == len(rms["all data"]) == 20
    assert all(ours < filters for ours, filters in zip(rms["all data"], rms["world"], strict=True))


def test_stored_claim_once_round_all_data_have_the_filters_matches_and_half_its_error(stored):
    for best, own in zip(stored["round"]["all data"], stored["round"]["full"], strict=True):
        assert (best["old"], best["landmarks"], best["true"]) == (own["old"], own["landmarks"], own["true"])
        assert best["rms"] < own["rms"] / 2


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
