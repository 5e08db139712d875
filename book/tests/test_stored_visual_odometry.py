"""Stored results of chapter visual_odometry's longer runs are what the tool computes: the start of one is run again."""

import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")

from book.experiments import stored
from book.experiments import visual_odometry as tool
from book.tests.stored_results import comes_out_again

STORED = stored.kept(tool.FILE)


def test_the_beginning_of_a_walk_comes_out_again():
    """Nine pairs of pictures, of which two are stored, take 5 s; the whole walk has 449, a row of the room 120."""
    again = tool.around(tool.SEEDS[0], tool.EVERY + 1)["rows"]
    renew = "run `make visual-odometry` and notebook visual_odometry"
    comes_out_again(again, STORED["round"][0]["rows"][: len(again)], renew, places=5)  # [m], as they are stored


def test_form_of_the_file_is_what_the_chapter_reads():
    assert len(STORED["round"]) == len(tool.SEEDS)
    assert set(STORED["room"]) == set(STORED["street"]["rows"])
    for walk in STORED["round"]:
        assert len(walk["rows"]) == -(-tool.ROUND // tool.EVERY)
        assert len(walk["library"]) == (tool.ROUND - 1) // 64
