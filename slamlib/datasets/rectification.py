"""Undistortion of images and rectification of pairs: where each lens has the pixels, and OpenCV's remapping.

In a rectified pair rows correspond, and the right camera is to the right alone: both cameras are rotated about their
centres. The new x axis is the baseline, the new z axis as near as possible to both optical axes: Fusiello, Trucco and
Verri (2000). One pin-hole for both, with the widest view in which all pixels are seen by both lenses.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.datasets.lens import Lens, PairCalibration, placed
from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import best_pivot, from_rotation
from slamlib.manifolds import Array

PURPOSE = "to undistort images"
ZOOMS = 0.1, 10.0  # of focal lengths
INSIDE = 8  # px, between the pixels inside an image that are looked at, beside all those of its border
SLANT, ASIDE, UNLIKE = 0.002, 0.01, 0.002  # rad; share of the baseline; share of the focal length


def why_not_rectified(pair: PairCalibration) -> str | None:
    """The reason why two cameras are no rectified pair, or None."""
    x, *aside = pair.transform[:3, 3].tolist()
    (_, v, a, b), (_, v_right, a_right, b_right) = pair.left.intrinsics, pair.right.intrinsics
    turned = float(np.linalg.norm(pair.transform[:3, :3] - np.eye(3))) / np.sqrt(2)
    if not (pair.left.is_pinhole and pair.right.is_pinhole):
        return "the lenses distort"
    if turned > SLANT:
        return f"the cameras are turned against each other by {np.degrees(turned):.2f} degrees"
    if max(abs(a - a_right), abs(b - b_right), abs(v - v_right)) > UNLIKE * a:
        return "the two cameras differ in their focal lengths or the rows of their principal points"
    if np.linalg.norm(aside) > ASIDE * abs(x):
        return f"the right camera is {[round(n, 4) for n in (x, *aside)]} m (right, down, front) from the left one"
    return None


def rectified_setup(pair: PairCalibration, size: tuple[int, int]) -> tuple[dict[str, Any], float]:
    """Plain data of the stereo SensorSetup of a rectified pair, and the offset [px] of its disparities.

    size: (width, height) of the pictures. The offset is the difference of the columns of the two principal points.
    """
    parameters = {"intrinsics": pair.left.intrinsics, "baseline": (float(pair.transform[0, 3]),)}
    setup = {"name": "stereo", "type": "stereo", "image": tuple(map(float, size)), "parameters": parameters}
    return {**setup, **pair.left.extra}, pair.right.intrinsics[0] - pair.left.intrinsics[0]


class Remapping:
    """Maps images (h, w) of one lens, or pairs (2, h, w) of two, to those of one pin-hole without distortion.

    ideal(zoom): that pin-hole, by a factor of its focal lengths; the least one is taken for which all pixels are
    seen by the lenses, and is then `lens`. turns (3, 3): of their rays; original (7,): of the first camera, as a pose.
    size: (width, height) of the pictures. Raises SlamlibError for invalid lenses.
    """

    def __init__(
        self, lenses: Sequence[Lens], turns: Sequence[Array], ideal: Callable[[float], Lens], size: tuple[int, int]
    ) -> None:
        pixels = np.stack(np.meshgrid(*map(np.arange, size)), axis=-1).astype(float)
        borders = pixels[[0, -1]], pixels[:, [0, -1]], pixels[::INSIDE, ::INSIDE]
        checked = np.concatenate([part.reshape(-1, 2) for part in borders])

        def places(zoom: float, of: Array) -> list[Array]:
            new = ideal(zoom).matrix
            return [_places(lens, new, turn, of) for lens, turn in zip(lenses, turns, strict=True)]

        def fits(zoom: float) -> bool:
            last = np.subtract(size, 1)
            return all(((place >= 0) & (place <= last)).all() for place in places(zoom, checked))

        low, high = ZOOMS  # bisected: where one fits, all larger ones do
        if not fits(high):
            seen = "does not describe" if len(lenses) == 1 else "see nothing in common in"
            raise SlamlibError(f"{' and '.join(map(str, lenses))} {seen} pictures of {size[0]}x{size[1]} pixels")
        while high / low > 1 + 1e-4:
            middle = float(np.sqrt(low * high))
            low, high = (low, middle) if fits(middle) else (middle, high)
        self.lens = ideal(high)
        found = (np.moveaxis(place.astype(np.float32), -1, 0) for place in places(high, pixels))
        self._maps = [tuple(map(np.ascontiguousarray, each)) for each in found]
        self.original = np.concatenate([np.zeros(3), from_rotation(turns[0], best_pivot(turns[0]))])

    def __call__(self, image: Array) -> Array:
        """The remapped image (h, w) or pair (2, h, w), bilinear."""
        cv2 = opencv(PURPOSE)
        pictures = image if image.ndim == 3 else image[None]
        each = zip(pictures, self._maps, strict=True)
        found = np.stack([cv2.remap(picture, *places, cv2.INTER_LINEAR) for picture, places in each])
        return found if image.ndim == 3 else found[0]


def undistortion(lens: Lens, size: tuple[int, int]) -> tuple[Remapping, dict[str, Any]]:
    """Maps images of a lens to those of a pin-hole, with plain data of its SensorSetup.

    Both focal lengths are scaled by one factor; the principal point is kept.
    """
    u, v, a, b = lens.intrinsics
    image = float(size[0]), float(size[1])
    found = Remapping([lens], [np.eye(3)], lambda zoom: Lens((u, v, zoom * a, zoom * b), image), size)
    return found, found.lens.setup()


def rectification(pair: PairCalibration, size: tuple[int, int]) -> tuple[Remapping, dict[str, Any]]:
    """Maps pairs (2, h, w) of two lenses to rectified pairs, with plain data of their SensorSetup."""
    turns, baseline = _turns(pair.transform)
    lenses = pair.left, pair.right
    # Approximate middle of the common view on the new plane z = 1, which is mapped to the image's middle.
    centre = np.mean([turn[:2, 2] / turn[2, 2] for turn in turns], axis=0)
    focal = float(np.mean([lens.intrinsics[2:] for lens in lenses]))

    def ideal(zoom: float) -> Lens:
        f = zoom * focal
        u, v = (np.subtract(size, 1) / 2 - f * centre).tolist()
        return Lens((u, v, f, f), (float(size[0]), float(size[1])))

    found = Remapping(lenses, turns, ideal, size)
    left, right = replace(found.lens, extra=pair.left.extra), replace(found.lens, transform=placed((baseline, 0, 0)))
    return found, rectified_setup(PairCalibration(left, right), size)[0]


def _turns(transform: Array) -> tuple[list[Array], float]:
    """Rotations (3, 3) of the rays of the left and of the right camera to the rectified ones, and the baseline [m]."""
    x = transform[:3, 3] / np.linalg.norm(transform[:3, 3])
    ahead = np.array([0.0, 0, 1]) + transform[:3, 2]
    y = np.cross(ahead, x)
    y /= np.linalg.norm(y)
    new = np.stack([x, y, np.cross(x, y)])  # rows: the new axes in the left camera's frame
    return [new, new @ transform[:3, :3]], float(np.linalg.norm(transform[:3, 3]))


def _places(lens: Lens, new: Array, turn: Array, pixels: Array) -> Array:
    """Pixels (..., 2) of the old image for pixels (..., 2) of the new one, whose camera matrix is new (3, 3).

    turn (3, 3): takes rays of the old camera to those of the new one.
    """
    rays = np.concatenate([pixels, np.ones_like(pixels[..., :1])], axis=-1) @ np.linalg.inv(new).T
    return lens.pixels(rays @ turn)
