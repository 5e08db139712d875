"""ROS: what its package camera_calibration saves (camera_matrix, ...), or a printed message camera_info (K, D, ...).

Of a pair, a file for each: R turns the camera's rays to the rectified ones, and P has the baseline, -fx times it.
"""

from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from slamlib.datasets.dataset import METADATA, CalibrationReader, Cameras
from slamlib.datasets.formats.opencv import MATRIX, camera_lens
from slamlib.datasets.lens import Lens, placed, rigid
from slamlib.plain_data.entries import Entries, Numbers, alike, named_values

UNUSED = (*METADATA, "header", "roi", "binning*", "seq", "stamp")


def _fits(text: str) -> bool:
    names = set(map(alike, named_values(text)))
    return "distortionmodel" in names and bool(set(map(alike, MATRIX)) & names)


def _read(path: Path, text: str) -> Cameras:
    return {None: partial(_lens, Entries(named_values(text)))}


def _lens(entries: Entries) -> Lens:
    found = replace(camera_lens(entries), transform=_pose(entries))
    entries.close(UNUSED)
    return found


def _pose(entries: Entries) -> Numbers | None:
    """In the frame of the rectified left camera; None where R and P are not whole: a single camera needs neither."""
    turn = entries.numbers("rectification_matrix", "R", needed=False)
    projection = entries.numbers("projection_matrix", "P", needed=False)
    if len(turn) != 9 or len(projection) != 12 or not projection[0]:
        return None
    return rigid(placed((-projection[3] / projection[0], 0, 0), np.reshape(turn, (3, 3))), "R")


CALIBRATION = CalibrationReader("ROS", _fits, _read)
