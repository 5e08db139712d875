"""The excerpt of TUM's fr1/xyz that is shipped: whole, small, attributed, and good for a run."""

import numpy as np
import pytest

from book.tools import layout
from slamlib.datasets.opening import open_sequence
from slamlib.datasets.public import public_recordings
from slamlib.datasets.sources import open_source
from slamlib.evaluation.trajectory import read_trajectory

FOLDER = layout.BOOK / "chapters" / "pictures" / "tum_fr1_xyz"
COUNT, LARGEST = 100, 1_200_000


def test_it_is_small_and_says_whose_it_is():
    assert sum(file.stat().st_size for file in FOLDER.rglob("*") if file.is_file()) <= LARGEST
    words = (FOLDER / "ATTRIBUTION.txt").read_text("utf-8")
    licence = public_recordings()["tum-fr1-xyz"].licence
    for needed in ("Sturm", licence, "creativecommons.org/licenses/by/4.0", "Changes"):
        assert needed in words


def test_it_is_a_sequence_of_tum_with_a_reference_for_each_picture():
    source = open_source(FOLDER)
    assert (source.layout, len(source)) == ("TUM RGB-D", COUNT)
    reference = read_trajectory(FOLDER / "groundtruth.txt")
    inner = reference.times - np.array(source.times)[:, None]
    assert np.abs(inner).min(1).max() < 0.02


def test_its_lens_is_that_of_the_benchmark_at_half_the_size():
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    from slamlib.datasets.calibrations import read_lens

    whole, half = read_lens("fr1"), read_lens(FOLDER / "camera.txt")
    (u, v, au, av), (small_u, small_v, small_au, small_av) = whole.intrinsics, half.intrinsics
    assert (small_au, small_av) == pytest.approx((au / 2, av / 2))
    assert (small_u, small_v) == pytest.approx(((u + 0.5) / 2 - 0.5, (v + 0.5) / 2 - 0.5))
    assert half.distortion[:5] == pytest.approx(whole.distortion)


def test_pictures_are_read_and_undistorted():
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    source, camera = open_sequence(str(FOLDER), str(FOLDER / "camera.txt"), undistort=True)
    first = next(iter(source))
    assert first.image.shape == (240, 320)
    assert first.image.std() > 30  # of a desk with a bright wall, not of a blank
    assert tuple(camera["image"]) == (320, 240)
