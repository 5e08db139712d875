"""Stored results of the starts of one camera: what the films are, and one of them run again."""

import numpy as np
import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")
pytest.importorskip("skimage", reason="scikit-image is not installed")

from book.experiments import starts, stored
from book.tests.stored_results import comes_out_again
from slamlib.cli.images import MAX_DIRECTION_ERROR

RENEW = "run `make starts` and notebook monocular"
KEPT = stored.kept(starts.FILE)


def test_form_of_the_file_is_a_row_per_film():
    assert set(KEPT) == set(starts.PARTS)
    assert (KEPT["frames"], KEPT["blind"]) == (starts.FRAMES, starts.BLIND)
    assert {len(rows) for rows in KEPT.values() if isinstance(rows, list)} == {starts.FILMS}


def test_stored_claim_the_two_view_start_is_right_as_often_as_promised():
    for start in (*starts.STARTS, "at rest, 20 more"):
        assert sum(row["cosine"] > 0.9 for row in KEPT[start]) >= 0.95 * starts.FILMS
    assert max(row["off"] / row["jump"] for row in KEPT["kidnapped"]) < 0.3


def test_stored_claim_two_views_speak_against_wrong_paths_and_not_against_right_ones():
    told = [
        row
        for rows in KEPT.values()
        if isinstance(rows, list)
        for row in rows
        if row.get("direction_error") is not None
    ]
    wrong = [row["direction_error"] for row in told if row["cosine"] < 0.9]
    right = [row["direction_error"] for row in told if row["cosine"] >= 0.9]
    assert len(wrong) >= 10
    assert np.mean(np.array(wrong) > MAX_DIRECTION_ERROR) >= 0.95
    assert np.mean(np.array(right) > MAX_DIRECTION_ERROR) < 0.05


@pytest.mark.parametrize(("start", "turned"), [("at rest", 0), ("turning", 14)])
def test_the_camera_is_where_it_was_until_it_leaves(start, turned):
    path = starts.walk(start, np.random.default_rng(1))
    poses = starts.displacements(np.array([path.pose(t) for t in np.arange(0, starts.STILL[start], starts.DT)]))
    assert np.linalg.norm(poses[:, :3], axis=1).max() < 1e-3  # metres
    assert np.degrees(2 * np.arccos(poses[:, 3].min())) == pytest.approx(turned, abs=0.5)


def test_a_film_comes_out_again():
    """A whole row, of 150 frames: 10 s to render them and 7 s to filter; a kidnapping has three such films."""
    film = 16  # the shortest run: no two views are found in it
    comes_out_again(starts.started("planar", film), KEPT["planar"][film - 1], RENEW, places=3)
