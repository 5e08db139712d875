"""Straight segments in an image: found by OpenCV's detector, directed by their gradient, and laid to sub-pixels.

The detector is LSD (von Gioi, Jakubowicz, Morel and Randall, 2010): regions of pixels whose gradients agree. The ends
of its segments are a quarter of a pixel off their edge, those of `refined` some hundredths. Chapter 20.
"""

import numpy as np

from slamlib.datasets.optional_imports import opencv
from slamlib.errors import SlamlibError
from slamlib.landmarks.segments import length
from slamlib.manifolds import Array, Image
from slamlib.observation.lines import undistort_segments
from slamlib.sensors.sensor import Calibration
from slamlib.vision.edges import PROFILE, Edge, edge_strip, fitted
from slamlib.vision.patches import grey, sample

SIDE = 1.5  # [px] to either side of a segment, where it is asked which one is brighter
REACH = 1.5  # [px]: the detector is not farther off


def segments_of(image: Image, minimum_length: float = 20.0) -> Array:
    """Straight segments (n, 4) [px] of an image (h, w), the longest first, each with its brighter side to its right.

    To the right as one goes from its first end to its second: to where v grows if u does. So an edge and its opposite
    have opposite directions. Needs OpenCV. Raises SlamlibError.
    """
    if not (np.isfinite(minimum_length) and minimum_length > 0):
        raise SlamlibError(f"segments_of: minimum_length is above zero [px], got {minimum_length}")
    pixels = np.clip(np.rint(grey(image, "segments_of")), 0, 255).astype(np.uint8)
    detector = opencv("to find straight segments").createLineSegmentDetector()
    found = detector.detect(np.ascontiguousarray(pixels))[0]
    segments = np.zeros((0, 4)) if found is None else np.asarray(found, dtype=float).reshape(-1, 4)
    lengths = length(segments)
    order = np.argsort(-lengths, kind="stable")
    return directed(pixels, segments[order[lengths[order] >= minimum_length]])


def directed(image: Image, segments: Array) -> Array:
    """The same segments (n, 4), turned round where their left side is brighter."""
    endpoints = segments.reshape(-1, 1, 2, 2)
    share = np.linspace(0.1, 0.9, 16)[:, None]
    middle = (1 - share) * endpoints[:, :, 0] + share * endpoints[:, :, 1]
    forward = endpoints[:, :, 1] - endpoints[:, :, 0]
    right = SIDE * np.stack([-forward[..., 1], forward[..., 0]], -1) / np.linalg.norm(forward, axis=-1, keepdims=True)
    rise = np.nan_to_num(sample(image, middle + right) - sample(image, middle - right)).mean(-1)
    return np.where(rise[:, None] < 0, segments[:, [2, 3, 0, 1]], segments)


def refined(image: Image, calibration: Calibration, segment: Array) -> Edge | None:
    """The edge of a segment (4,) of `segments_of`, laid through the places where the grey value grows most.

    None where there is no edge that is straight in the world.
    """
    ideal = undistort_segments(calibration, np.asarray(segment, dtype=float))[0]
    return fitted(edge_strip(image, calibration, ideal, REACH + PROFILE[-1]), calibration, np.zeros(2), REACH)
