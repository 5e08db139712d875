"""Pictures of two cameras as those of a rectified pair: rows correspond, and the right camera is to the right alone.

Both cameras are turned where they are: the new x axis is the baseline, the new z axis as near as can be to where both
looked. Fusiello, Trucco and Verri (2000). One pin-hole for both, as wide as it can be without a place that one of the
lenses did not see. Maps are computed once; OpenCV reads the pictures through them.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.datasets.lens import PURPOSE, Lens, inside, least_zoom, maps
from slamlib.datasets.optional_imports import opencv
from slamlib.datasets.pair_calibrations import PairCalibration
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image

SLANT, ASIDE, UNLIKE = 0.002, 0.01, 0.002  # rad; share of the baseline; share of the focal length


def why_not_rectified(pair: PairCalibration) -> str | None:
    """What keeps two cameras from being a rectified pair, or None."""
    x, *aside = pair.place[:3, 3].tolist()
    (_, v, a, b), (_, v_right, a_right, b_right) = pair.left.intrinsics, pair.right.intrinsics
    turned = float(np.linalg.norm(pair.place[:3, :3] - np.eye(3))) / np.sqrt(2)
    if any((*pair.left.distortion, *pair.right.distortion)):
        return "the lenses distort"
    if turned > SLANT:
        return f"the cameras are turned against each other by {np.degrees(turned):.2f} degrees"
    if max(abs(a - a_right), abs(b - b_right), abs(v - v_right)) > UNLIKE * a:
        return "the two cameras differ in their focal lengths or the rows of their principal points"
    if np.linalg.norm(aside) > ASIDE * abs(x):
        return f"the right camera is {[round(n, 4) for n in (x, *aside)]} m (right, down, front) from the left one"
    return None


def check_order(pair: PairCalibration) -> None:
    """Raise SlamlibError if the right camera is to the left of the left one."""
    if not pair.place[0, 3] > 0:
        raise SlamlibError(
            f"the right camera is {pair.place[0, 3]:.3g} m to the right of the left one, by the calibration: left and "
            "right are exchanged; give --left and --right (or --cameras, or the two files) the other way round"
        )


def rectified_setup(pair: PairCalibration, size: tuple[int, int]) -> tuple[dict[str, Any], float]:
    """Plain data of the stereo SensorSetup of a rectified pair, and the offset [px] of its disparities.

    size: (width, height) of the pictures. Columns of the two principal points that differ are the offset.
    """
    parameters = {"intrinsics": pair.left.intrinsics, "baseline": (float(pair.place[0, 3]),)}
    setup = {"name": "stereo", "type": "stereo", "image": tuple(map(float, size)), "parameters": parameters}
    return {**setup, **pair.said}, pair.right.intrinsics[0] - pair.left.intrinsics[0]


class Rectification:
    """Makes pairs (2, h, w) of two lenses those of a rectified pair; setup: plain data of the SensorSetup of those."""

    def __init__(self, pair: PairCalibration, size: tuple[int, int]) -> None:
        """size: (width, height) of both pictures. Raises SlamlibError for lenses that make no sense."""
        turns, baseline = _turns(pair.place)
        lenses = pair.left, pair.right
        centre = np.mean([_centre(lens, turn) for lens, turn in zip(lenses, turns, strict=True)], axis=0)
        focal = float(np.mean([lens.intrinsics[2:] for lens in lenses]))

        def places(zoom: float) -> list[Any]:
            new = _ideal(focal, zoom, centre, size)
            return [maps(lens, new.matrix, size, turn) for lens, turn in zip(lenses, turns, strict=True)]

        zoom = least_zoom(lambda zoom: all(inside(place, size) for place in places(zoom)))
        if zoom is None:
            raise SlamlibError(f"the two cameras see nothing in common: {np.round(pair.place, 3).tolist()}")
        self._maps = places(zoom)
        beside = replace(pair, left=_ideal(focal, zoom, centre, size), place=_shifted(baseline))
        self.setup, _ = rectified_setup(beside, size)

    def __call__(self, image: Image) -> Array:
        """The pair (2, h, w), rectified, bilinear."""
        cv2 = opencv(PURPOSE)
        both = zip(image, self._maps, strict=True)
        return np.stack([cv2.remap(picture, *places, cv2.INTER_LINEAR) for picture, places in both])


def _turns(place: Array) -> tuple[list[Array], float]:
    """Rotations (3, 3) of the rays of the left and of the right camera to the rectified ones, and the baseline [m]."""
    x = place[:3, 3] / np.linalg.norm(place[:3, 3])
    ahead = np.array([0.0, 0, 1]) + place[:3, 2]
    y = np.cross(ahead, x)
    y /= np.linalg.norm(y)
    new = np.stack([x, y, np.cross(x, y)])  # rows: the new axes in the left camera's frame
    return [new, new @ place[:3, :3]], float(np.linalg.norm(place[:3, 3]))


def _centre(lens: Lens, turn: Array) -> Array:
    """Where the middle of what a lens sees lies on the new plane z = 1, roughly (2,)."""
    ray = turn @ np.array([0.0, 0, 1])
    return ray[:2] / ray[2]


def _ideal(focal: float, zoom: float, centre: Array, size: tuple[int, int]) -> Lens:
    """A pin-hole with the old axis in the middle of its picture."""
    f = zoom * focal
    u, v = (np.subtract(size, 1) / 2 - f * centre).tolist()
    return Lens((u, v, f, f), (float(size[0]), float(size[1])))


def _shifted(baseline: float) -> Array:
    place = np.eye(4)
    place[0, 3] = baseline
    return place
