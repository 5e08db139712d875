"""Relocalization: a lost camera's pose from the patches of its own map, found anywhere in an image.

It starts an ordinary step, with a covariance so wide that active search may use this image again. Chapter monocular.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, compose, inverse
from slamlib.manifolds import Array, Image
from slamlib.slam.entities import Landmark
from slamlib.slam.filter import Slam
from slamlib.vision.appearance import Appearance
from slamlib.vision.target import focal_length, normalized, refined

LOST = 4  # inliers: with no more of them, the next image is searched for the map
MOST, VIEWS, SEEN = 80, 3, 3  # landmarks searched for; patches of each; times that it must have been an inlier
SCORE, MAX_ERROR = 0.85, 3.0  # of a match; [px]
FEWEST, PLACE = 8, 16  # inliers of a pose, each in a square of its own; its side [px]: from afar all are in one
POSITION_STD, ORIENTATION_STD = 0.02, 1.0  # of the pose found: a share of the points' median distance; degrees


def relocalize(slam: Slam, image: Image) -> bool:
    """Whether the camera was found: then its robot's pose is the one found, at rest, independent of the map.

    Needs points with patches, and OpenCV: without either nothing is found, and nothing is changed.
    """
    try:
        cv2 = opencv("to relocalize")
    except SlamlibError:
        return False
    sensor, robot = slam.sensors[0], slam.robots[0]
    matches = list(_matches(cv2, slam.landmarks, np.asarray(image, np.float32)))
    if len(matches) < FEWEST:
        return False
    points, pixels = (np.array(column, dtype=float) for column in zip(*matches, strict=True))
    plane, limit = normalized(sensor.calibration, pixels), MAX_ERROR / focal_length(sensor.calibration)
    good, turn, shift, rows = cv2.solvePnPRansac(
        points[:, None], plane[:, None], np.eye(3), None, iterationsCount=2000, reprojectionError=limit,
        confidence=0.9999, flags=cv2.SOLVEPNP_EPNP,
    )  # fmt: skip
    if not good or rows is None or len(np.unique(pixels[rows[:, 0]] // PLACE, axis=0)) < FEWEST:
        return False
    camera = refined(cv2, points[rows], plane[rows], turn, shift)
    mean, P = slam.rig.robots[0].state, slam.rig.robots[0].covariance
    mean[:7] = compose(camera, inverse(sensor.extrinsics))
    distance = float(np.median(np.linalg.norm(points - camera[:3], axis=1)))
    stds = np.repeat([POSITION_STD * distance, np.radians(ORIENTATION_STD)], 3)
    P[:6, :6] = np.diag(stds**2)
    slam.belief.predict(robot.block, mean, np.zeros_like(P), P)  # F = 0: nothing of the old pose is left
    return True


def _matches(cv2: Any, landmarks: list[Landmark], image: Image) -> Iterator[tuple[Array, Array]]:
    """Points (3,) of the map, and the pixels (2,) where one of their patches is found best."""
    reliable = [lm for lm in landmarks if isinstance(lm.signature, Appearance) and lm.inliers >= SEEN]
    for landmark in sorted(reliable, key=lambda one: -one.inliers)[:MOST]:
        *point, rho = landmark.kind.to_frame(ORIGIN, landmark.block.mean)
        score, pixel = max(_best(cv2, image, view) for view in landmark.signature.all[:VIEWS])
        if score >= SCORE and rho > 0:
            yield np.array(point) / rho, np.array(pixel)


def _best(cv2: Any, image: Image, view: Appearance) -> tuple[float, tuple[int, int]]:
    """Score and centre (u, v) [px] of the best match of a patch in the whole image."""
    scores = cv2.matchTemplate(image, view.template.astype(np.float32), cv2.TM_CCOEFF_NORMED)
    _, score, _, (u, v) = cv2.minMaxLoc(scores)
    return score, (u + view.size // 2, v + view.size // 2)
