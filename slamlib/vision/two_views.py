"""Two-view initialization: a monocular run that starts from the relative motion of two images. Chapter monocular.

One camera that moves already may take near points for far ones, and its motion for the opposite. The essential matrix
of two images tells; what it finds is a guess of the depths, so wide that the filter may use these images again.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from slamlib.datasets.pictures import TimedImage, opencv
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import from_frame
from slamlib.manifolds import Array, Mask
from slamlib.sensors.sensor import Calibration
from slamlib.vision.target import Target, focal_length

LOOK_AHEAD = 150  # images in which the second view is looked for
PARALLAX = 2.0  # degrees: least median angle between the rays of a point, once the rotation is removed
MAX_ERROR = 0.5  # px: RANSAC's, of an epipolar line
CORNERS, QUALITY, SPACING = 300, 0.01, 10  # of the tracks; their least share of the best corner's quality; [px]
WIDEST = 70.0  # degrees off the optical axis: farther out a wide lens's points are not used
CYCLE = 1.0  # px: a track followed back ends at most so far from where it began
FEWEST, IN_FRONT = 40, 0.7  # tracks; the share of the inliers that must lie in front of both cameras
STD, LANDMARKS, BORDER = 0.3, 25, 16  # of a guessed depth, as a share of it; most of them; [px] from the border


def two_view_target(pictures: Iterable[TimedImage], calibration: Calibration, camera: Array) -> Target | None:
    """Landmarks of the first image, seen by a camera at this pose (7,), as a target; their median depth is 1.

    The points of the first image are tracked until the rays to one of the next LOOK_AHEAD images have enough parallax.
    None if no image is such: the camera rests, or turns only. Raises SlamlibError without OpenCV.
    """
    cv2, images = opencv("for the two-view initialization"), (picture.image for picture in pictures)
    before = first = next(images)
    found = cv2.goodFeaturesToTrack(first, CORNERS, QUALITY, SPACING)
    pixels = np.zeros((0, 2)) if found is None else found.reshape(-1, 2).astype(float)
    pixels = now = pixels[_depths(calibration, pixels) > np.cos(np.radians(WIDEST))]
    for _, image in zip(range(LOOK_AHEAD), images, strict=False):
        if len(pixels) < FEWEST:
            return None
        now, kept = _tracked(cv2, before, image, now)
        pixels, before = pixels[kept], image
        points = _triangulated(cv2, calibration, pixels, now) if len(pixels) >= FEWEST else None
        if points is not None:
            inside = (np.minimum(pixels, np.array(first.shape[::-1]) - 1 - pixels) >= BORDER).all(1)
            chosen = _spread(pixels, inside & (points[:, 2] > 0), first.shape[1] / 14)
            scaled = points[chosen] / np.nanmedian(points[:, 2])
            return Target(from_frame(camera, scaled), pixels[chosen], STD * np.linalg.norm(scaled, axis=1))
    return None


def _depths(calibration: Calibration, pixels: Array) -> Array:
    """Depths (n,) of the unit rays of pixels (n, 2), -1 where a wide lens's image has ended: one by one if it has."""
    try:
        return calibration.back_project_jac(pixels, np.ones((len(pixels), 1)))[0][:, 2]
    except SingularPointError:
        return np.concatenate([_depths(calibration, one[None]) for one in pixels]) if len(pixels) > 1 else -np.ones(1)


def _tracked(cv2: Any, before: Array, image: Array, pixels: Array) -> tuple[Array, Mask]:
    """Where pixels (n, 2) are in the next image, of those that a track back finds again; and the mask of these."""
    start = pixels[:, None].astype(np.float32)
    there, good, _ = cv2.calcOpticalFlowPyrLK(before, image, start, None, winSize=(15, 15))
    back, again, _ = cv2.calcOpticalFlowPyrLK(image, before, there, None, winSize=(15, 15))
    kept = (good[:, 0] > 0) & (again[:, 0] > 0) & (np.linalg.norm((back - start)[:, 0], axis=1) < CYCLE)
    return there[kept, 0].astype(float), kept


def _triangulated(cv2: Any, calibration: Calibration, old: Array, new: Array) -> Array | None:
    """Points (n, 3) in the first camera's frame, nan for outliers; None without a unique, sure relative motion."""
    rays, later = (calibration.back_project_jac(p, np.ones((len(p), 1)))[0][:, :3] for p in (old, new))
    a, b = (np.ascontiguousarray(h[:, :2] / h[:, 2:]) for h in (rays, later))
    limit = MAX_ERROR / focal_length(calibration)
    E, mask = cv2.findEssentialMat(a, b, np.eye(3), method=cv2.USAC_MAGSAC, prob=0.9999, threshold=limit)
    if E is None or E.shape != (3, 3):
        return None
    least = max(IN_FRONT * mask.sum(), 1)
    good, R, _, front, points = cv2.recoverPose(E, a, b, np.eye(3), distanceThresh=1e3, mask=mask)
    parallax = np.degrees(np.arccos(np.clip((rays * (later @ R)).sum(1), -1, 1)))[front[:, 0] > 0]
    if good < least or np.median(parallax) < PARALLAX:
        return None
    return np.where(front[:, 0] > 0, points[:3] / points[3], np.nan).T


def _spread(pixels: Array, usable: Mask, spacing: float) -> list[int]:
    """Rows of the first LANDMARKS usable pixels (n, 2), none nearer to another than the spacing [px]."""
    chosen: list[int] = []
    for row in np.flatnonzero(usable).tolist():
        if len(chosen) < LANDMARKS and (np.abs(pixels[chosen] - pixels[row]).max(-1) > spacing).all():
            chosen.append(row)
    return chosen
