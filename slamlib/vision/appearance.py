"""A landmark's appearance: the image around it, the camera pose, and its prediction for another pose.

Steps 1f and 2e of active search (Chapter active_search). The patch is a small plane through the landmark that faces
the camera which took it (Davison et al., 2007; Molton et al., 2004, estimate its normal). Its
prediction is the better the less the view changes; a rule decides when to take another patch.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from slamlib.geometry.pose import relative
from slamlib.manifolds import Array, Image, Mask, finite, read_only
from slamlib.sensors.sensor import Calibration
from slamlib.vision.patches import as_floats, cut, grey, half_size
from slamlib.vision.search import Match, register
from slamlib.vision.warping import angle, facing_plane, in_camera, stretch, through_camera, towards, warp

# Appearance is not predicted beyond this angle [rad] between the plane's normal and the line of sight, nor beyond
# this factor of magnification or reduction.
MAX_ANGLE, MAX_ZOOM = np.radians(60), 2.0
# A match seen from a direction that differs by so much [rad] from all stored patches, or at so different a scale, gives
# a new patch if its score is at least this high, and the second-best below this share of it.
NEW_ANGLE, NEW_SCALE, SURE_SCORE, SURE_RATIO = np.radians(25), 1.5, 0.9, 0.8


@dataclass(frozen=True, eq=False)
class Appearance:
    """Pixels (h, w) of an image around a landmark's `pixel` (2,); `corner` (u, v) is the first of them.

    camera: pose (7,) in the world that took it. size [px]: of the templates; the pixels are about three times as
    wide, enough for zoom and rotation. quality: the corner's. previous: the appearance before this one, or None: no
    patch is deleted, and the most similar view is used. So patches do not drift where the camera returns.
    """

    pixels: Array
    corner: tuple[int, int]
    pixel: Array
    camera: Array
    size: int
    quality: float = 0.0
    previous: "Appearance | None" = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "pixels", read_only(grey(self.pixels, "Appearance")))
        for name, size in (("pixel", 2), ("camera", 7)):
            object.__setattr__(self, name, finite(getattr(self, name), (size,), "Appearance", name))

    @classmethod
    def taken(
        cls,
        image: Image,
        pixel: Array,
        camera: Array,
        size: int = 11,
        quality: float = 0.0,
        previous: "Appearance | None" = None,
    ) -> "Appearance | None":
        """The appearance around a pixel (2,) of an image (h, w); None where a template of `size` px does not fit.

        camera: its pose (7,) in the world. Raises SlamlibError for even sizes, ShapeError for colour images.
        """
        array, half = grey(image, "Appearance"), half_size(size, "Appearance") + size
        if cut(array, pixel, size) is None:
            return None
        u, v = np.rint(pixel).astype(int).tolist()
        corner = max(u - half, 0), max(v - half, 0)
        piece = array[corner[1] : v + half + 1, corner[0] : u + half + 1]
        piece = piece.copy() if piece.dtype == np.uint8 else as_floats(piece, "Appearance")
        return cls(piece, corner, pixel, camera, size, float(quality), previous)

    @property
    def template(self) -> Array:
        """The patch as it was taken, of `size` px."""
        patch = cut(self.pixels, self.pixel - self.corner, self.size)
        assert patch is not None, "checked by taken()"
        return patch

    def angle_change(self, camera: Array, point: Array) -> float:
        """Angle [rad] between the viewing directions of a point (4,) from its own camera and from this pose (7,)."""
        return float(view_change(self.camera, camera, point)[0])

    def change(self, camera: Array, point: Array) -> float:
        """Change of view of a point (4,) from its own camera to this one, pose (7,); above 1 a new patch is taken."""
        turned, grown = view_change(self.camera, camera, point)
        return float(max(turned / NEW_ANGLE, abs(np.log(grown) / np.log(NEW_SCALE))))

    def nearest(self, camera: Array, point: Array) -> "Appearance":
        """Of this one and those before it, the one with the view of a point (4,) nearest to a camera's, pose (7,)."""
        if self.previous is None:
            return self
        return min(self.all, key=lambda one: one.change(camera, point))

    @property
    def all(self) -> list["Appearance"]:
        """This one, and those before it."""
        return [self] if self.previous is None else [self, *self.previous.all]

    def needs_renewal(self, found: Match, camera: Array, point: Array) -> bool:
        """Whether a match is reliable, and its view from a camera pose (7,) differs enough for a new patch."""
        sure = found.score >= SURE_SCORE and found.ratio < SURE_RATIO
        return sure and self.nearest(camera, point).change(camera, point) > 1

    def renewed(self, image: Image, found: Match, template: Image, camera: Array) -> "Appearance":
        """With a new patch of this image, around where the template fits best; unchanged if it cannot be registered.

        The registration error stays in the new patch: hundredths of a pixel, tenths for a wrong plane.
        """
        pixel = register(image, template, found.pixel)
        if pixel is None:
            return self
        return Appearance.taken(image, pixel, camera, self.size, self.quality, self) or self


def view_change(before: Array, camera: Array, points: Array) -> tuple[Array, Array]:
    """Angles (...) [rad] between the directions in which two cameras, poses (..., 7), see points (..., 4), and the
    ratios (...) of their distances, first by second."""
    then, now = towards(before, points), towards(camera, points)
    return angle(then, now), np.linalg.norm(then, axis=-1) / np.linalg.norm(now, axis=-1)


def recognizable(appearances: Sequence[Appearance], camera: Array, points: Array) -> Mask:
    """Mask (n,) of the landmarks at points (n, 4) that a camera, pose (7,), sees neither too obliquely nor too large
    or too small, by the distances; in a fraction of the time of `predict`.
    """
    nearest = [a.nearest(camera, point) for a, point in zip(appearances, points, strict=True)]
    turned, grown = view_change(np.array([a.camera for a in nearest]).reshape(-1, 7), camera, points)
    return (turned <= MAX_ANGLE) & (grown <= MAX_ZOOM) & (grown * MAX_ZOOM >= 1)


def predict(
    appearances: Sequence[Appearance], camera: Array, calibration: Calibration, points: Array, size: int
) -> list[Array | None]:
    """The templates (size, size) of n landmarks, predicted for a camera, pose (7,), and world points (n, 4).

    None where one is too oblique, too large or too small, not visible, or beyond the stored pixels. Only offsets
    between pixels are predicted, so an error of a point does not shift its template.
    """
    templates: list[Array | None] = [None] * len(appearances)
    nearest = [a.nearest(camera, point) for a, point in zip(appearances, points, strict=True)]
    before = np.array([a.camera for a in nearest]).reshape(-1, 7)
    then, now = in_camera(before, points), in_camera(camera, points)
    oblique = view_change(before, camera, points)[0] > MAX_ANGLE
    rows = np.flatnonzero(~oblique & calibration.visible(then) & calibration.visible(now))
    if not len(rows):
        return templates
    seen = relative(camera, before[rows])
    maps = through_camera(calibration, seen, facing_plane(then[rows]), calibration.project(now[rows]), size)
    least, largest = stretch(maps)
    for row in np.flatnonzero((largest <= MAX_ZOOM) & (least * MAX_ZOOM >= 1)):  # nan is neither
        own = nearest[rows[row]]
        templates[rows[row]] = warp(own.pixels, own.pixel - own.corner, maps[row], size)
    return templates
