"""Two-view initialization: a monocular run that starts from the relative motion of two images. Chapter monocular.

One camera that moves already may take near points for far ones, and its motion for the opposite. The essential matrix
of two images tells; what it finds is a guess of the depths, so wide that the filter may use these images again.
"""

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.pictures import TimedImage, opencv
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import from_frame, relative, to_frame
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.target import Target, focal_length

PURPOSE = "for the two-view initialization"
LOOK_AHEAD = 150  # images in which the second view is looked for
PARALLAX = 2.0  # degrees: least median angle between the rays of a point, once the rotation is removed
MAX_ERROR = 0.5  # px: RANSAC's, of an epipolar line
CORNERS, QUALITY, SPACING = 300, 0.01, 10  # of the tracks; their least share of the best corner's quality; [px]
WIDEST = 70.0  # degrees off the optical axis: farther out a wide lens's points are not used
CYCLE = 1.0  # px: a track followed back ends at most so far from where it began
FEWEST, IN_FRONT = 40, 0.7  # tracks; the share of the inliers that must lie in front of both cameras
STD, LANDMARKS, BORDER = 0.3, 25, 16  # of a guessed depth, as a share of it; most of them; [px] from the border


class TwoViews(NamedTuple):
    """What an image of this number tells with the first: pixels (n, 2) in the first; in the frame of its camera their
    points (n, 3), nan for outliers, and the direction (3,) in which the second camera is."""

    number: int
    pixels: Array
    points: Array
    direction: Array


def two_views(pictures: Iterable[TimedImage], calibration: Calibration) -> TwoViews | None:
    """Of the first image and the first of the next LOOK_AHEAD to which the rays have enough parallax.

    None if no image is such: the camera rests, or turns only. Raises SlamlibError without OpenCV.
    """
    for number, (_, pixels, now) in enumerate(_tracks(pictures, calibration), 1):
        if (told := _triangulated(calibration, pixels, now)) is not None:
            return TwoViews(number, pixels, *told)
    return None


def two_view_target(
    pictures: Iterable[TimedImage], calibration: Calibration, camera: Array, known: Target | None = None
) -> Target | None:
    """Landmarks of the first image, seen by a camera at this pose (7,), as a target; their median depth is 1.

    known: a target, which comes first then; the depths are in its unit, by the tracked points nearest to its pixels.
    None without two views. Raises SlamlibError without OpenCV.
    """
    found = two_views(pictures, calibration)
    if found is None:
        return None
    usable, size = found.points[:, 2] > 0, calibration.image
    pixels, points = found.pixels[usable], found.points[usable]
    unit = np.median(points[:, 2])
    if known is not None:
        nearest = np.linalg.norm(pixels[:, None] - known.pixels, axis=2).argmin(0)
        unit = np.median(points[nearest, 2] / to_frame(camera, known.points)[:, 2])
    chosen = _spread(pixels, (np.minimum(pixels, size - 1 - pixels) >= BORDER).all(1), size[0] / 14)
    scaled = points[chosen] / unit
    guessed = Target(from_frame(camera, scaled), pixels[chosen], STD * np.linalg.norm(scaled, axis=1))
    return guessed if known is None else known.with_others(guessed)


def direction_error(source: ImageSource, calibration: Calibration, path: Array) -> tuple[float, int, int] | None:
    """Angle [deg] from the motion between two images to that of a path of cameras (n, 7), and the images' numbers.

    The images are the first with enough parallax; None if there are none. Raises SlamlibError without OpenCV.
    """
    for first in range(0, len(path) - 1, LOOK_AHEAD):
        found = two_views(source.part(first, 1, len(path) - first), calibration)
        if found is not None:
            moved = relative(path[first], path[first + found.number])[:3]
            angle = _angles(found.direction, moved / max(float(np.linalg.norm(moved)), 1e-12))
            return float(angle), first, first + found.number
    return None


def turning_rate(pictures: Iterable[TimedImage], calibration: Calibration) -> float:
    """Median rate [deg/s] at which the rays of points turn from the first image to the second, 0 if few are tracked."""
    tracks = next(_tracks(pictures, calibration), None)
    if tracks is None:
        return 0.0
    seconds, *pixels = tracks
    a, b = (_rays(calibration, part) for part in pixels)
    return float(np.median(_angles(a, b))) / seconds


def _tracks(pictures: Iterable[TimedImage], calibration: Calibration) -> Iterator[tuple[float, Array, Array]]:
    """Time [s] from the first image to each of the next, and pixels (n, 2) in both, as long as FEWEST are tracked."""
    cv2, images = opencv(PURPOSE), iter(pictures)
    before = first = next(images)
    found = cv2.goodFeaturesToTrack(first.image, CORNERS, QUALITY, SPACING)
    pixels = np.zeros((0, 2)) if found is None else found.reshape(-1, 2).astype(float)
    pixels = now = pixels[_depths(calibration, pixels) > np.cos(np.radians(WIDEST))]
    for picture in islice(images, LOOK_AHEAD):
        if len(pixels):
            now, kept = _tracked(cv2, before.image, picture.image, now)
            pixels, before = pixels[kept], picture
        if len(pixels) < FEWEST:
            return
        yield picture.time - first.time, pixels, now


def _depths(calibration: Calibration, pixels: Array) -> Array:
    """Depths (n,) of the unit rays of pixels (n, 2), -1 where a wide lens's image has ended: one by one if it has."""
    try:
        return _rays(calibration, pixels)[:, 2]
    except SingularPointError:
        return np.concatenate([_depths(calibration, one[None]) for one in pixels]) if len(pixels) > 1 else -np.ones(1)


def _tracked(cv2: Any, before: Array, image: Array, pixels: Array) -> tuple[Array, Mask]:
    """Where pixels (n, 2) are in the next image, of those that a track back finds again; and the mask of these."""
    start = pixels[:, None].astype(np.float32)
    there, good, _ = cv2.calcOpticalFlowPyrLK(before, image, start, None, winSize=(15, 15))
    back, again, _ = cv2.calcOpticalFlowPyrLK(image, before, there, None, winSize=(15, 15))
    kept = (good[:, 0] > 0) & (again[:, 0] > 0) & (np.linalg.norm((back - start)[:, 0], axis=1) < CYCLE)
    return there[kept, 0].astype(float), kept


def _triangulated(calibration: Calibration, old: Array, new: Array) -> tuple[Array, Array] | None:
    """Points and direction, as of TwoViews; None without a unique, sure relative motion."""
    cv2, rays, later = opencv(PURPOSE), *(_rays(calibration, pixels) for pixels in (old, new))
    a, b = (np.ascontiguousarray(h[:, :2] / h[:, 2:]) for h in (rays, later))
    limit = MAX_ERROR / focal_length(calibration)
    E, mask = cv2.findEssentialMat(a, b, np.eye(3), method=cv2.USAC_MAGSAC, prob=0.9999, threshold=limit)
    if E is None or E.shape != (3, 3):
        return None
    least = max(IN_FRONT * mask.sum(), 1)
    good, R, t, front, points = cv2.recoverPose(E, a, b, np.eye(3), distanceThresh=1e3, mask=mask)
    parallax = _angles(rays, later @ R)[front[:, 0] > 0]
    if good < least or np.median(parallax) < PARALLAX:
        return None
    return np.where(front[:, 0] > 0, points[:3] / points[3], np.nan).T, -R.T @ t[:, 0]


def _rays(calibration: Calibration, pixels: Array) -> Array:
    """Unit vectors (n, 3) along the rays of pixels (n, 2), in the camera's frame."""
    return calibration.back_project_jac(pixels, np.ones((len(pixels), 1)))[0][:, :3]


def _angles(one: Array, other: Array) -> Array:
    """Angles (...) [deg] between unit vectors (..., 3)."""
    return np.degrees(np.arccos(np.clip((one * other).sum(-1), -1, 1)))


def _spread(pixels: Array, usable: Mask, spacing: float) -> list[int]:
    """Rows of the first LANDMARKS usable pixels (n, 2), none nearer to another than the spacing [px]."""
    chosen: list[int] = []
    for row in np.flatnonzero(usable).tolist():
        if len(chosen) < LANDMARKS and (np.abs(pixels[chosen] - pixels[row]).max(-1) > spacing).all():
            chosen.append(row)
    return chosen
