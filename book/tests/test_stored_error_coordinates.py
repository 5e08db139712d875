"""The stored runs of the right-invariant EKF and of the filters beside it: they come out again, and what they show."""

import csv

import numpy as np
import pytest
from slambook.report.planar import SCANNERS
from slambook.report.planar_ekf import PlanarEkf
from slambook.report.planar_invariant import PlanarFilter

from book.experiments import error_coordinates as tool
from book.experiments import other_filters
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from book.tools import layout

RENEW = "run `make error-coordinates`, and `python -m book.tools.notebooks run` for the chapters that read its file"
PLANE, SPACE = ([name for name in tool.SETTINGS if name.startswith(start)] for start in ("plane", "space"))


@pytest.fixture(scope="module")
def stored():
    return results.kept(tool.FILE)


def test_form_of_the_file_is_what_the_tool_makes(stored):
    assert set(stored) == set(tool.PARTS), RENEW
    assert stored["runs"] == tool.PARTS["runs"](), RENEW
    assert stored["seeds"] == tool.PARTS["seeds"](), RENEW


def test_numbers_are_those_of_the_runs(stored):
    for part in (*tool.SETTINGS, "chapter ekf_slam"):
        for row in (row for rows in stored[part].values() for row in rows.values()):
            for error in ("linear", "log"):
                found = tool.numbers(np.array(row["own"][error]), 6 if part in SPACE else 3)
                assert row[error] == pytest.approx(found, rel=1e-3, abs=1e-3)


@pytest.mark.parametrize("setting", tool.SETTINGS)
def test_the_first_runs_come_out_again(stored, setting):
    """Of the plane each filter's first; of space, where a run takes longer, two filters'."""
    number = tool.SEEDS[0]
    rows = stored[setting][str(number)]
    given = tool.SETTINGS[setting]
    frames = list(tool.record(given, tool.seeds(number, 1)[0]))
    for name in tool.names(given) if setting in PLANE else ("RI-EKF", "slamlib world"):
        found = tool.own(tool.run(given, frames, name)[0])
        first = [rows[name]["own"][column][0] for column in ("linear", "log", "rms")]
        comes_out_again(found, first, RENEW)


def test_a_run_of_chapter_ekf_slam_comes_out_again(stored):
    """And its filters from scratch, whose runs are stored beside, find the same as the filters here."""
    (first, *_), setting = tool.CHAPTER_SEEDS, tool.SETTINGS["plane, 0.3 m, 3 deg"]
    frames = tool.of_chapter(first)
    for name, row in stored["chapter ekf_slam"][str(first)].items():
        found = tool.own(tool.run(setting, frames, name, tool.one_by_one)[0])
        comes_out_again(found, [row["own"][column][0] for column in ("linear", "log", "rms")], RENEW)
    lines = (layout.BOOK / "chapters" / "data" / "plane_filters.csv").read_text().splitlines()[1:]
    theirs = {int(row["seed"]): row for row in csv.DictReader(lines)}
    for name, their_name in (("EKF", "PlaneSlam"), ("first estimates", "FirstEstimates"), ("RI-EKF", "Invariant")):
        for number, rows in stored["chapter ekf_slam"].items():
            ours = rows[name]["own"]["linear"]
            wanted = [float(theirs[int(number) + k][their_name]) for k in range(len(ours))]
            np.testing.assert_allclose(ours, wanted, rtol=1e-3)


@pytest.mark.parametrize("scene", SCANNERS)
def test_the_first_drives_come_out_again(stored, scene):
    number = tool.DRIVE_SEEDS[0]
    rows = stored[f"drives, {scene}"][str(number)]
    made = other_filters.by_chapter(scene, number, 1, {"EKF": PlanarEkf, "RI-EKF": PlanarFilter})
    for name, (_, nees, map_square, _) in made.items():
        found = {"linear": nees.mean(), "map_rmse": np.sqrt(map_square.mean())}
        comes_out_again(found, {column: rows[name]["own"][column][0] for column in found}, RENEW)


# What the chapters may say.


def values(stored, setting, filter, error="linear", number="median"):
    """A number of a filter's, in both sets of seeds."""
    return np.array([rows[filter][error][number] for rows in stored[setting].values()])


def test_stored_claim_the_transport_is_the_invariant_filter(stored):
    for setting in tool.SETTINGS:
        one, other = (values(stored, setting, name, "log", "mean") for name in ("RI-EKF", "transport"))
        assert (np.abs(other - one) < values(stored, setting, "RI-EKF", "log", "error") / 4).all()
    one, other = (values(stored, "chapter ekf_slam", name) for name in ("RI-EKF", "transport"))
    np.testing.assert_allclose(other, one, rtol=0.02)
    for setting in SPACE:  # slamlib's filter, all numbers of it
        for rows in stored[setting].values():
            for error, found in rows["transport"]["own"].items():
                np.testing.assert_allclose(found, rows["slamlib world"]["own"][error], rtol=2e-3)


def test_stored_claim_first_estimates_are_better_in_a_typical_run_and_ruin_a_few(stored):
    for setting in ("plane, 0.1 m, 1 deg", "plane, 0.05 m, 0.5 deg, wheels 2 deg"):
        assert (values(stored, setting, "first estimates") < values(stored, setting, "EKF")).all()
        for number in ("mean", "error"):
            worse = values(stored, setting, "first estimates", number=number)
            assert (worse > values(stored, setting, "EKF", number=number)).all()
        means, errors = (values(stored, setting, "first estimates", number=number) for number in ("mean", "error"))
        assert (means - values(stored, setting, "EKF", number="mean") < 1.5 * errors).all()


def test_stored_claim_the_correction_needs_landmarks_in_view(stored):
    few = "plane, 0.05 m, 0.5 deg, wheels 2 deg"
    means = [values(stored, setting, "FEJ2", number="mean") for setting in (few, f"{few}, more in view")]
    assert (means[0] > 50).all()
    assert (means[1] < 4).all()


def test_stored_claim_the_invariant_filter_is_consistent_in_its_own_error(stored):
    for setting in PLANE:
        assert (values(stored, setting, "RI-EKF", "log", "mean") < 3.5).all()
    for setting in SPACE:
        assert (values(stored, setting, "RI-EKF", "log", "mean") < 7).all()
    assert (values(stored, "plane, start known to 20 deg", "RI-EKF", "linear", "mean") > 30).all()


def test_stored_claim_most_of_what_the_sonars_map_lost_was_the_choice_of_error(stored):
    for rows in stored[f"drives, {tool.COARSE}"].values():
        ekf, invariant, whole = (rows[name]["map_rmse"] for name in ("EKF", "RI-EKF", "all data"))
        assert ekf - invariant > 0.8 * (ekf - whole)
        assert rows["EKF"]["inside"] < 0.45
        assert rows["RI-EKF"]["inside"] > 0.85


def test_stored_claim_better_tangents_alone_do_not_mend_the_sonars_map(stored):
    for rows in stored[f"drives, {tool.COARSE}"].values():
        for name in ("secants", "iterated"):
            assert rows[name]["linear"]["mean"] > 12
            assert rows[name]["map_rmse"] > 0.85 * rows["EKF"]["map_rmse"]
            assert rows[name]["inside"] < 0.45
            assert rows["RI-EKF"]["linear"]["mean"] < 5


def test_stored_claim_with_the_sonar_the_transport_is_a_little_worse_in_most_drives(stored):
    for rows in stored[f"drives, {tool.COARSE}"].values():
        for column in ("linear", "map_rmse"):
            transport, exact = (np.array(rows[name]["own"][column]) for name in ("transport", "RI-EKF"))
            assert np.mean(transport > exact) > 0.6
            assert abs(np.mean(transport - exact)) < np.mean(exact) / 8
