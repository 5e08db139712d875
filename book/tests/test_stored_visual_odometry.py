"""Stored results of chapter visual_odometry's longer runs are what the tool computes: the start of one is run again."""

import json

import numpy as np
import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")

from book.tools import visual_odometry as tool

STORED = json.loads(tool.FILE.read_text("utf-8"))


def test_the_beginning_of_a_walk_is_the_stored_one():
    frames = tool.EVERY + 1
    again = tool.around(tool.SEEDS[0], frames)["rows"]
    np.testing.assert_allclose(again, STORED["round"][0]["rows"][: len(again)], atol=3e-4)


def test_the_file_has_what_the_chapter_reads():
    assert len(STORED["round"]) == len(tool.SEEDS)
    assert set(STORED["room"]) == set(STORED["street"]["rows"])
    for walk in STORED["round"]:
        assert len(walk["rows"]) == -(-tool.ROUND // tool.EVERY)
        assert len(walk["library"]) == (tool.ROUND - 1) // 64
