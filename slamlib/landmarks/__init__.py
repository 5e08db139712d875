"""Parametrizations of landmarks, one file each. Tangled from chapters points and lines."""

from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.registry import Registry

__all__ = ["LINES", "POINTS", "LineLandmark", "PointLandmark"]

POINTS = Registry(__name__, PointLandmark, "point landmark")
LINES = Registry(__name__, LineLandmark, "line landmark")
