"""Relocalization and loop closure: a camera's pose from the patches of its own map, found anywhere in an image.

A lost camera starts an ordinary step with it, so uncertain that active search may use this image again. Where landmarks
long unseen are found elsewhere than predicted, it closes a loop. Chapter monocular.
"""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.entities import Landmark
from slamlib.entities.state import kinds_of
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN, Pose, compose, inverse
from slamlib.kalman.linalg import left_inverse
from slamlib.manifolds import Array, Image
from slamlib.slam.filter import Slam
from slamlib.slam.prediction import predict_measurements
from slamlib.slam.unobservable import generators
from slamlib.vision.appearance import Appearance
from slamlib.vision.target import focal_length, normalized, refined

LOST = 4  # inliers: with no more of them, the next image is searched for the map
MOST, VIEWS, SEEN = 80, 3, 3  # landmarks searched for; patches of each; times that it must have been an inlier
SCORE, MAX_ERROR = 0.85, 3.0  # of a match; [px]
FEWEST, PLACE = 8, 16  # inliers of a pose, each in a square of its own; its side [px]: from afar all are in one
UNSEEN, EVERY = 100, 10  # frames after which a landmark in view may tell of a drift; and from one search to the next
POSITION_STD, ORIENTATION_STD = 0.02, 1.0  # of the pose found: a share of the points' median distance; degrees


def relocalize(slam: Slam, image: Image) -> bool:
    """Whether the camera was found: then its robot's pose is the one found, at rest, independent of the map.

    Needs points with patches, OpenCV, and a robot that can be at any pose, which one in the plane cannot: without them
    nothing is found, and nothing is changed.
    """
    if (found := _robot(slam, slam.landmarks, image)) is None:
        return False
    mean, P = slam.rig.robots[0].start_at(*found)
    slam.belief.predict(slam.robots[0].block, mean, np.zeros_like(P), P)  # F = 0: nothing of the old pose is left
    return True


def close_loop(slam: Slam, image: Image) -> bool:
    """Whether landmarks long unseen were found elsewhere than predicted, after a step: then the drift is estimated.

    It is a random walk of the whole world's motion since they vanished, as large as what the pose found says of it, and
    each landmark took part in it until it was seen last: eq. (mn-loop). The next search finds them, or not. Raises
    SlamlibError for a parametrization, or a motion, without the model moved.
    """
    sensor, belief, number = slam.sensors[0], slam.belief, slam.number
    if number % EVERY:
        return False
    old = [landmark for landmark in slam.landmarks if number - landmark.last_seen > UNSEEN]
    predict = partial(predict_measurements, belief, sensor, slam.families, kinds_of(old), slam.options)
    shown = {prediction.landmark: prediction.value for prediction in predict()}
    if (found := _robot(slam, list(shown), image)) is None:
        return False
    robot, stds = found
    moved = [np.linalg.norm(p.value - shown[p.landmark]) for p in predict(robot) if p.landmark in shown]
    if not moved or np.median(moved) < MAX_ERROR:
        return False
    since, share = np.median([landmark.last_seen for landmark in shown]), np.ones(belief.size)
    for landmark in slam.landmarks:
        share[landmark.block.slice] = np.clip((landmark.last_seen - since) / (number - since), 0, 1)
    N = generators(slam.state)
    N = N @ left_inverse(N[sensor.robot.columns])
    z = Pose.minus(robot, sensor.robot.pose)
    Q = np.repeat((z.reshape(2, 3) ** 2).mean(axis=1), 3)  # and K: diagonals
    K = Q / (Q + stds**2)
    step, walk, told = share * (N @ (K * z)), N * np.sqrt(Q), N * np.sqrt(K * Q)
    shared = np.minimum(share[:, None], share) * (walk @ walk.T) - np.outer(share, share) * (told @ told.T)
    means = [block.manifold.plus(block.mean, step[block.slice]) for block in belief.blocks]
    belief.overwrite(dict(enumerate(belief.blocks)), dict(enumerate(means)), belief.matrix + shared)
    return True


def _robot(slam: Slam, landmarks: list[Landmark], image: Image) -> tuple[Array, Array] | None:
    """The robot's pose (7,) by these landmarks, and its standard deviations (6,); None: not found."""
    try:
        cv2 = opencv("to relocalize")
    except SlamlibError:
        return None
    if slam.rig.dof[0] < Pose.dof:
        return None  # the robot cannot be put at any pose
    sensor, matches = slam.sensors[0], list(_matches(cv2, landmarks, np.asarray(image, np.float32)))
    if len(matches) < FEWEST:
        return None
    points, pixels = (np.array(column, dtype=float) for column in zip(*matches, strict=True))
    plane, limit = normalized(sensor.calibration, pixels), MAX_ERROR / focal_length(sensor.calibration)
    good, turn, shift, rows = cv2.solvePnPRansac(
        points[:, None], plane[:, None], np.eye(3), None, iterationsCount=2000, reprojectionError=limit,
        confidence=0.9999, flags=cv2.SOLVEPNP_EPNP,
    )  # fmt: skip
    if not good or rows is None or len(np.unique(pixels[rows[:, 0]] // PLACE, axis=0)) < FEWEST:
        return None
    camera = refined(cv2, points[rows], plane[rows], turn, shift)
    distance = float(np.median(np.linalg.norm(points - camera[:3], axis=1)))
    stds = np.repeat([POSITION_STD * distance, np.radians(ORIENTATION_STD)], 3)
    return compose(camera, inverse(sensor.extrinsics)), stds


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
