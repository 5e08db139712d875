"""Stored results of what errors of a measurement are made of: a short film again, and what the chapter says of them."""

import numpy as np
import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")
pytest.importorskip("skimage", reason="scikit-image is not installed")

from book.experiments import measurement_errors as tool
from book.experiments import stored
from book.tests.stored_results import comes_out_again

KEPT = stored.kept(tool.FILE)
FILMS = [name for name in KEPT if name.isdigit()]
SETS = FILMS[:10], FILMS[10:]
RENEW = "run `make measurement-errors` and notebook stereo_ekf_slam"
LENSES = [name for name, cause in tool.CAUSES.items() if any(cause.lens)]


def figure(run, name, films=FILMS):
    column = list(KEPT["light"]).index(name)
    return np.array([KEPT[film][KEPT["runs"].index(run)][column] for film in films], float)


def median_nees(run, films=FILMS):
    return np.median(figure(run, "nees", films).mean(1))


def test_form_of_the_file_is_a_row_per_film_and_run():
    assert KEPT["runs"] == list(tool.RUNS)
    assert list(map(int, FILMS)) == list(range(1, tool.FILMS + 1))
    assert {len(KEPT[film]) for film in FILMS} == {len(tool.RUNS)}


def test_a_short_film_comes_out_again(monkeypatch):
    """26 pictures with one cause in them take 12 s; a row of the file has 75 with all causes, and twenty runs."""
    monkeypatch.setattr(tool, "CAUSES", {tool.AGAIN: tool.CAUSES[tool.AGAIN]})
    found, _ = tool.filtered(tool.Film(1, tool.LIGHT), tool.RUNS[tool.AGAIN])
    # Where a patch fits best is found step by step; a hundredth of a pixel, and with it which match counts, may differ.
    comes_out_again(found, KEPT["light"], RENEW, share=2e-2, places=3)


@pytest.mark.parametrize("films", SETS)
def test_stored_claim_errors_stay_from_every_cause_and_most_of_all_from_the_lens(films):
    stays = {run: figure(run, "later", films).mean() for run in tool.CAUSES}
    assert min(stays.values()) > 0.6
    assert min(stays[run] for run in LENSES) > max(stay for run, stay in stays.items() if run not in LENSES)


@pytest.mark.parametrize("films", SETS)
@pytest.mark.parametrize("name", [tool.ALONE, tool.ALL])
def test_stored_claim_told_what_patches_claim_the_nis_looks_ideal_and_the_pose_is_not(films, name):
    run = f"{name}: std as patches claim"
    assert figure(run, "nis", films).mean() == pytest.approx(1, abs=0.15)
    assert figure("drawn", "foretold", films).mean() < 0 < 0.2 < figure(run, "foretold", films).mean() < 0.35
    assert figure(name, "foretold", films).mean() > 0.3
    assert figure(run, "nees", films).mean() > 5


@pytest.mark.parametrize("films", SETS)
def test_stored_claim_the_default_is_conservative_for_pictures_and_overconfident_for_lenses(films):
    assert max(median_nees(run, films) for run in tool.CAUSES if run not in LENSES) < 0.5
    assert min(median_nees(run, films) for run in LENSES) > 1
    assert median_nees(tool.ALL, films) > 5


@pytest.mark.parametrize("films", SETS)
@pytest.mark.parametrize(
    "run",
    ["drawn", "drawn, 90 % stays", f"{tool.ALONE}: std as measured"]
    + [f"{tool.ALL}: {remedy}" for remedy in ("as measured, 1 in 5", "lens considered")],
)
def test_stored_claim_drawn_errors_and_the_remedies_are_consistent(films, run):
    assert 0.5 < figure(run, "nees", films).mean() < 2


@pytest.mark.parametrize("films", SETS)
def test_stored_claim_innovations_measure_the_new_part_of_an_error_alone(films):
    new = 1 - tool.RUNS["drawn, 90 % stays"].drawn
    assert figure("drawn, 90 % stays", "nis", films).mean() == pytest.approx(new, rel=0.15)


def test_the_share_of_an_error_in_common_is_found_in_drawn_ones():
    rng, groups = np.random.default_rng(1), np.repeat(np.arange(400), 20)
    errors = 0.5**0.5 * (rng.standard_normal((400, 2))[groups] + rng.standard_normal((8000, 2)))
    assert tool.shared(errors, groups) == pytest.approx(0.5, abs=0.05)
    at = np.tile(np.arange(20), 400)
    assert tool.correlation(groups, at, errors, 10) == pytest.approx(0.5, abs=0.05)
