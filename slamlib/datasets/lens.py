"""Lenses as calibration files describe them, of one camera or of a pair, and their models of distortion.

slamlib's pin-hole has radial distortion only: the factor 1 + d1 r^2 + d2 r^4 + ... on points of the plane z = 1
(chapter pinhole), which is OpenCV's k1, k2, k3 with its p1 = p2 = 0; its fisheye is OpenCV's. In all of them, pixel
(0, 0) is the centre of the upper left pixel.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Array

Numbers = tuple[float, ...]
RADIAL, FISHEYE = "radial-tangential", "equidistant"
# How many coefficients: Brown's in OpenCV's order k1 k2 p1 p2 k3 k4 k5 k6; k1 to k4 of Kannala and Brandt (2006).
MODELS = {RADIAL: 8, FISHEYE: 4}


@dataclass(frozen=True)
class Lens:
    """intrinsics (u0, v0, au, av) [px]; image (width, height) [px], or None where the file does not say.

    model: a name of MODELS; distortion: its coefficients in OpenCV's order. transform: pose of the camera in the frame
    that the file gives it in (another camera, a body), as a 4 x 4 matrix, row by row, or None. extra: more fields of
    its SensorSetup, as its std.
    """

    intrinsics: Numbers
    image: Numbers | None = None
    model: str = RADIAL
    distortion: Numbers = ()
    transform: Numbers | None = field(default=None, repr=False)
    extra: dict[str, Any] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        if len(self.intrinsics) != 4 or not np.isfinite(self.intrinsics).all() or not min(self.intrinsics[2:]) > 0:
            raise SlamlibError(f"intrinsics are (u0, v0, au, av), two of them focal lengths above 0: {self.intrinsics}")
        max_coefficients = entry("model of a lens", self.model, MODELS)
        if len(self.distortion) > max_coefficients or not np.isfinite(self.distortion).all():
            raise SlamlibError(
                f"{self.model}: at most {max_coefficients} finite coefficients are wanted, got {self.distortion}"
            )

    @property
    def lens(self) -> "Lens":
        """Itself: a reader may also return a camera of another type."""
        return self

    @property
    def radial(self) -> Numbers | None:
        """The coefficients of slamlib's pin-hole, or None if it cannot represent the lens."""
        k1, k2, p1, p2, k3, *rest = (*self.distortion, *(0.0,) * (5 - len(self.distortion)))
        found: Numbers = (k1, k2, k3)
        while found and not found[-1]:
            found = found[:-1]
        return None if self.model != RADIAL or p1 or p2 or any(rest) else found

    def setup(self) -> dict[str, Any]:
        """Plain data of a SensorSetup: a pin-hole or a fisheye. Raises SlamlibError for any other lens."""
        distortion = self.distortion if self.model == FISHEYE else self.radial
        if distortion is None:
            raise SlamlibError(
                f"this lens ({self.model}, coefficients {', '.join(f'{d:g}' for d in self.distortion)}) is no pin-hole "
                "with radial distortion alone, as slamlib's pinHole is: remove it from the images with "
                "--undistort, which makes them those of a pin-hole without distortion"
            )
        parameters = {"intrinsics": self.intrinsics, "distortion": distortion or (0.0,)}
        size = {} if self.image is None else {"image": self.image}
        return {"type": "fisheye" if self.model == FISHEYE else "pinHole", **size, "parameters": parameters}

    @property
    def matrix(self) -> Array:
        """The camera matrix (3, 3)."""
        u, v, a, b = self.intrinsics
        return np.array([[a, 0, u], [0, b, v], [0, 0, 1.0]])


@dataclass(frozen=True)
class PairCalibration:
    """The lenses of the left and the right camera, with poses in one frame; a left one without pose is its origin."""

    left: Lens
    right: Lens

    @property
    def transform(self) -> Array:
        """Pose of the right camera in the left one's frame (4, 4)."""
        origin = np.eye(4) if self.left.transform is None else np.reshape(self.left.transform, (4, 4))
        return np.linalg.solve(origin, np.reshape(np.array(self.right.transform), (4, 4)))


def placed(position: ArrayLike, turn: ArrayLike = ((1, 0, 0), (0, 1, 0), (0, 0, 1))) -> Numbers:
    """The pose (row by row) of a camera at a position (3,) [m], with its axes as the columns of a matrix (3, 3)."""
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn, position
    return tuple(pose.ravel().tolist())


def fitted(setup: dict[str, Any], size: tuple[int, int], what: str) -> dict[str, Any]:
    """A setup with the size (width, height) of the pictures. Raises SlamlibError if it is for other images.

    what: the images' name. The principal point is checked for pin-holes only.
    """
    image = setup.get("image")
    if image is not None and tuple(image) != size:
        raise SlamlibError(
            f"the calibration is of pictures of {image[0]:g}x{image[1]:g} pixels, and those of {what} have "
            f"{size[0]}x{size[1]}: calibrate these, or scale the calibration as the pictures were scaled"
        )
    centre = np.array(setup.get("parameters", {}).get("intrinsics", (np.nan, np.nan))[:2]) / size
    spare = 0.0 if image is not None else 0.3
    if (np.abs(centre - 0.5) > 0.5 - spare).any():
        say = "" if image else "; if they are cropped from larger images, give their width and height in the file"
        raise SlamlibError(
            f"the calibration's principal point ({centre[0] * size[0]:.1f}, {centre[1] * size[1]:.1f}) does not fit "
            f"pictures of {size[0]}x{size[1]} pixels ({what}): is it of pictures of another size?{say}"
        )
    return {**setup, "image": (float(size[0]), float(size[1]))}
