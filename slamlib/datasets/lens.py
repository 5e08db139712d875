"""Lenses as calibration files describe them, of one camera or of a pair.

slamlib's pinHole has radial distortion only: the factor 1 + d1 r^2 + d2 r^4 + ... on points of the plane z = 1 (chapter
pinhole), which is OpenCV's k1, k2, k3 alone; its brownConrady has OpenCV's k1 k2 p1 p2 k3 k4 k5 k6; its fisheye is
OpenCV's. In all of them, pixel (0, 0) is the centre of the upper left pixel.
"""

import warnings
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.datasets.lens_models import MODELS, RADIAL
from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Array
from slamlib.plain_data.entries import Numbers
from slamlib.rigs.builders import SQUARE

RIGID = 0.01  # how far a rotation's columns may be from orthonormal: files round, and some are of single precision
FOCAL = 0.05, 100.0  # of the pictures' larger side: focal lengths of all lenses, from fisheyes to telescopes
CENTRED, ASIDE = 0.1, 0.3  # distance from the image's middle, in its sizes, of a principal point and of something else


@dataclass(frozen=True)
class Lens:
    """intrinsics (u0, v0, au, av) [px]; image (width, height) [px], or None where the file does not say.

    model: a name of lens_models.MODELS; distortion: its coefficients. transform: pose of the camera in the frame
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
        for name in ("intrinsics", "image", "distortion", "transform"):  # numbers of Python's, for messages and files
            if (given := getattr(self, name)) is not None:
                object.__setattr__(self, name, tuple(map(float, given)))
        if len(self.intrinsics) != 4 or not np.isfinite(self.intrinsics).all() or not min(self.intrinsics[2:]) > 0:
            raise SlamlibError(f"intrinsics are (u0, v0, au, av), two of them focal lengths above 0: {self.intrinsics}")
        max_coefficients = entry("model of a lens", self.model, MODELS).coefficients
        if len(self.distortion) > max_coefficients or not np.isfinite(self.distortion).all():
            raise SlamlibError(
                f"{self.model}: at most {max_coefficients} finite coefficients are wanted, got {self.distortion}"
            )
        for (name, (least, largest)), value in zip(MODELS[self.model].limits.items(), self.distortion, strict=False):
            if not least <= value <= largest:
                raise SlamlibError(
                    f"{self.model}: {name} is from {least:g} to {largest:.3g}, got {value:g}: are the numbers in "
                    "another order?"
                )

    @property
    def lens(self) -> "Lens":
        """Itself: a reader may also return a camera of another type."""
        return self

    @property
    def is_pinhole(self) -> bool:
        """Whether it is a pin-hole without distortion."""
        return MODELS[self.model].own(self.distortion) == ("pinHole", ())

    def setup(self) -> dict[str, Any]:
        """Plain data of a SensorSetup. Raises SlamlibError for a lens that no type of sensor has."""
        own = MODELS[self.model].own(self.distortion)
        if own is None:
            raise SlamlibError(
                f"slamlib has no type of sensor with this lens ({self.model}, coefficients "
                f"{', '.join(f'{d:g}' for d in self.distortion)}): remove it from the images with --undistort, which "
                "makes them those of a pin-hole without distortion"
            )
        name, distortion = own
        parameters = {"intrinsics": self.intrinsics, "distortion": distortion or (0.0,)}
        size = {} if self.image is None else {"image": self.image}
        return {"type": name, **size, "parameters": parameters}

    def pixels(self, rays: Array) -> Array:
        """Pixels (..., 2) of rays (..., 3) in the camera's frame; nan of what the lens cannot see."""
        model, (u, v, a, b) = MODELS[self.model], self.intrinsics
        k = (*self.distortion, *(0.0,) * (model.coefficients - len(self.distortion)))
        with np.errstate(invalid="ignore", divide="ignore"):
            x, y = model.image(rays[..., 0], rays[..., 1], rays[..., 2], k)
        return np.stack([u + a * x, v + b * y], axis=-1)

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


def rigid(matrix: ArrayLike, name: str, *, inverse: bool = False) -> Numbers:
    """A rigid motion (4, 4), or its inverse, row by row. Raises SlamlibError, which says its name, for another one."""
    found = np.reshape(np.asarray(matrix, dtype=float), (4, 4))
    turn = found[:3, :3]
    is_rotation = np.abs(turn @ turn.T - np.eye(3)).max() < RIGID and np.linalg.det(turn) > 0
    if not (is_rotation and np.allclose(found[3], (0, 0, 0, 1))):
        raise SlamlibError(f"{name} is no rigid motion: its 3 x 3 numbers are no rotation, or its last row not 0 0 0 1")
    return tuple((np.linalg.inv(found) if inverse else found).ravel().tolist())


def lens_of(fx: float, fy: float, cx: float, cy: float, **others: Any) -> Lens:
    """A lens by its focal lengths and its principal point, in the order of most tools; others: fields of Lens.

    Raises SlamlibError for focal lengths that no two sides of a pixel have.
    """
    if fy < 0 < fx:
        warnings.warn(
            f"fy = {fy:g} is read as {-fy:g}: the camera's y axis is said to point up, as in ICL-NUIM, whose pictures "
            "are upright all the same; what is compared with its trajectory needs the other sign of y",
            stacklevel=2,
        )
        fy = -fy
    found = Lens((cx, cy, fx, fy), **others)
    if not SQUARE < fx / fy < 1 / SQUARE:
        raise SlamlibError(
            f"the focal lengths {fx:g} and {fy:g} px differ by a factor of {max(fx / fy, fy / fx):.3g}, and pixels are "
            "nearly square: is one of them wrong, or their order? If it is right, write it as slamlib's own JSON, "
            '{"parameters": {"intrinsics": [u0, v0, au, av], ...}}'
        )
    return found


def focals_and_centre(matrix: Numbers) -> tuple[float, float, float, float]:
    """fx, fy, cx, cy of a camera matrix of nine numbers, row by row. Raises SlamlibError for any other matrix."""
    if len(matrix) != 9:
        raise SlamlibError(f"a camera matrix has 9 numbers, got {len(matrix)}")
    fx, skew, cx, b, fy, cy, *last = matrix
    if last[:2] != [0, 0] and (cx, cy) == (0, 0):
        raise SlamlibError(
            "the camera matrix is transposed, as MATLAB writes it: transpose it, and subtract 1 from its principal "
            "point, since MATLAB counts pixels from 1"
        )
    if last != [0, 0, 1] or b:
        raise SlamlibError(f"a camera matrix is (fx 0 cx, 0 fy cy, 0 0 1), got {matrix}")
    check_skew(skew, fx)
    return fx, fy, cx, cy


def check_skew(skew: float, focal: float) -> None:
    """Raise SlamlibError for axes of pixels that are not at right angles."""
    if abs(skew) > 1e-3 * abs(focal):
        raise SlamlibError(f"the pixels are skewed by {skew:g} px: slamlib has no skew; calibrate with it fixed to 0")


def fitted(setup: dict[str, Any], size: tuple[int, int], what: str) -> dict[str, Any]:
    """A setup with the size (width, height) of the pictures. Raises SlamlibError if it is for other images.

    what: the images' name. Focal lengths and the principal point are checked for intrinsics (u0, v0, au, av) only.
    """
    image = setup.get("image") or None  # an empty one is not given
    if image is not None and tuple(image) != size:
        raise SlamlibError(
            f"the calibration is of pictures of {image[0]:g}x{image[1]:g} pixels, and those of {what} have "
            f"{size[0]}x{size[1]}: calibrate these, or scale the calibration as the pictures were scaled"
        )
    given = setup.get("parameters", {}).get("intrinsics", (np.nan, np.nan))
    # Distances from the image's middle, in its sizes, of what should be the principal point, and of the other two.
    centre, others = np.resize(given, 4).reshape(2, 2) / size
    off, off_others = np.abs(centre - 0.5).max(), np.abs(others - 0.5).max()
    focal = float(np.abs(given[2:]).max()) if len(given) == 4 else 0.0
    if focal and not FOCAL[0] <= focal / max(size) <= FOCAL[1]:
        raise SlamlibError(
            f"the calibration's focal length of {focal:g} px does not fit pictures of {size[0]}x{size[1]} pixels "
            f"({what}): is it in pixels, or in millimetres, or a share of the pictures' size?"
        )
    spare = 0.0 if image is not None else 0.3
    exchanged = len(given) == 4 and off > ASIDE and off_others < CENTRED
    if off > 0.5 - spare or exchanged:
        say = "" if image else "; if they are cropped from larger images, give their width and height in the file"
        ask = f"is it of pictures of another size?{say}"
        if exchanged:
            ask = f"are the intrinsics {tuple(given)} (fx, fy, cx, cy)? slamlib's order is (u0, v0, au, av)"
        raise SlamlibError(
            f"the calibration's principal point ({centre[0] * size[0]:.1f}, {centre[1] * size[1]:.1f}) does not fit "
            f"pictures of {size[0]}x{size[1]} pixels ({what}): {ask}"
        )
    return {**setup, "image": (float(size[0]), float(size[1]))}
