"""Benchmarks are no tests, but each part of what they time must still be there."""

import pytest

from benchmarks.stereo import ERRORS
from benchmarks.stereo_filter import Case, speed
from slamlib.slam import Options
from slamlib.vision.stereo import StereoSettings


def test_the_parts_of_the_stereo_filter_are_timed(monkeypatch):
    pytest.importorskip("cv2")
    monkeypatch.setattr("benchmarks.stereo_filter.FULL", 20)
    first, *parts, _ = speed(Case("covariance-intersection", ERRORS, StereoSettings(), Options()), 3)
    assert "with 20 landmarks" in first
    assert {line[:18].strip() for line in parts} == {"control", "features", "filter", "new landmarks", "search"}
