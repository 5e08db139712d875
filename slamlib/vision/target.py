"""A known target in the first image, which fixes the scale and the reference frame of a monocular run."""

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.datasets.pictures import opencv
from slamlib.entities import Landmark
from slamlib.errors import SlamlibError
from slamlib.evaluation.alignment import straightness
from slamlib.geometry.euler import from_rotation
from slamlib.geometry.pose import compose, inverse, to_frame
from slamlib.geometry.quaternion import exponential, rotation
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array, finite
from slamlib.plain_data.files import read_text
from slamlib.records.inputs import Scan
from slamlib.rigs.setup import Rig
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import FrontEndInput
from slamlib.slam.filter import Slam
from slamlib.slam.measurement_update import update_in_batch

LEAST = 4  # points; with three, up to four poses fit
LARGEST = 5.0  # px: largest rms error of the pixels at the best pose; beyond it they do not belong to these points


def normalized(calibration: Calibration, pixels: Array) -> Array:
    """Where the rays of pixels (n, 2) meet the plane at depth 1 (n, 2)."""
    rays, _ = calibration.back_project_jac(pixels, np.ones((len(pixels), 1)))
    return np.ascontiguousarray(rays[:, :2] / rays[:, 2:3])


def focal_length(calibration: Calibration) -> float:
    """How many pixels are 1 in the plane at depth 1, near the optical axis; every lens has its own name for it."""
    beside = calibration.project(np.array([[0, 0, 1, 0], [1e-4, 0, 1, 0], [0, 1e-4, 1, 0]]))
    return float(np.linalg.norm(beside[1:] - beside[0], axis=1).mean() / 1e-4)


def refined(cv2: Any, points: Array, plane: Array, turn: Array, shift: Array) -> Array:
    """Pose (7,) of the camera that fits normalized pixels of points best, from OpenCV's world-to-camera motion."""
    turn, shift = cv2.solvePnPRefineLM(points, plane, np.eye(3), None, turn, shift)
    return inverse(np.concatenate([shift.ravel(), exponential(turn.ravel())]))


@dataclass(frozen=True, eq=False)
class Target:
    """Points (n, 3) [m] of the world, n >= 4, their pixels (n, 2) in the first image, and their std [m] or (n,)."""

    points: Array
    pixels: Array
    std: float | Array = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", finite(self.points, (None, 3), "Target", "points"))
        count = len(self.points)
        object.__setattr__(self, "pixels", finite(self.pixels, (count, 2), "Target", "pixels"))
        if count < LEAST:
            raise SlamlibError(
                f"a target has at least {LEAST} points, got {count}: fewer do not determine the camera's pose"
            )
        if straightness(self.points) < 1e-3:
            raise SlamlibError("the target's points lie on one line: a rotation about it is not observable")
        if not (np.isfinite(self.std) & (np.asarray(self.std) >= 0)).all():
            raise SlamlibError(f"the target's std is a length, 0 or more, got {self.std!r}")

    @classmethod
    def load(cls, path: str | Path) -> "Target":
        """Load from JSON: {"points": [[x, y, z], ...], "pixels": [[u, v], ...], "std": s}. Raises SlamlibError."""
        text = read_text(path)
        try:
            data = json.loads(text)
            return cls(data["points"], data["pixels"], data.get("std", 0.0))
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            wanted = 'JSON with "points" (n, 3), "pixels" (n, 2) and perhaps "std"'
            raise SlamlibError(f"{path} is no target: {wanted} is expected ({type(error).__name__}: {error})") from None

    def with_others(self, other: "Target") -> "Target":
        """These points, then those of another target."""
        points, pixels = np.concatenate([self.points, other.points]), np.concatenate([self.pixels, other.pixels])
        return Target(points, pixels, np.concatenate([np.broadcast_to(t.std, len(t.points)) for t in (self, other)]))

    def camera(self, calibration: Calibration) -> Array:
        """Pose (7,) of the camera in the target's frame that fits the pixels best; raises SlamlibError.

        Found by OpenCV's PnP from the pixels' rays, so any calibrated camera with rays in front of it will do.
        """
        cv2 = opencv("to find the camera's pose relative to the target")
        plane = normalized(calibration, self.pixels)[:, None]
        points = np.ascontiguousarray(self.points)[:, None]
        good, turn, shift = cv2.solvePnP(points, plane, np.eye(3), None, flags=cv2.SOLVEPNP_SQPNP)
        if not good:
            raise SlamlibError("no pose of the camera fits the target's pixels")
        pose = refined(cv2, points, plane, turn, shift)
        seen = np.column_stack([to_frame(pose, self.points), np.ones(len(self.points))])
        fits = calibration.visible(seen).all()
        error = np.linalg.norm(calibration.project(seen) - self.pixels, axis=1) if fits else np.array([np.inf])
        rms = np.sqrt((error**2).mean())
        if not rms <= LARGEST:
            raise SlamlibError(
                f"the target's pixels do not fit its points: their error is {rms:.1f} px (rms) "
                "at the best pose; are both in the same order, pixels u to the right and v down, calibration right?"
            )
        return pose

    def distance(self, calibration: Calibration) -> float:
        """Median distance [m] of the points from the camera, taken as typical of all landmarks."""
        return float(np.median(np.linalg.norm(self.points - self.camera(calibration)[:3], axis=1)))

    def placed(self, rig: Rig) -> Rig:
        """The rig with its robot at the pose the target is seen from. Position and orientation have large standard
        deviations, which the update by the pixels reduces."""
        setup, sensor = rig.robots[0], rig.sensors[0]
        camera = self.camera(sensor.calibration)
        pose = compose(camera, inverse(sensor.extrinsics))
        distance = float(np.linalg.norm(self.points - camera[:3], axis=1).max())
        start = replace(
            setup,
            position=tuple(pose[:3].tolist()),
            euler=tuple(np.degrees(from_rotation(rotation(pose[3:]))).tolist()),
            position_std=(distance,) * 3,
            orientation_std=(60.0,) * 3,
        )
        return replace(rig, robots=(start, *rig.robots[1:]))

    def put(self, slam: Slam, scan: Scan) -> None:
        """Add the points to a filter, Euclidean, and update it by their pixels once; `scan` holds the first image.

        The update is one batch, linearized at the pose that fits the pixels best. Raises SlamlibError if fewer than
        four of the points can be tracked.
        """
        sensor, front_end = slam.sensors[0], slam.front_ends[0]
        if not hasattr(front_end, "initialize_at"):
            raise SlamlibError(
                f"{type(front_end).__name__} cannot initialize landmarks at given pixels: it has no `initialize_at`"
            )
        found = front_end.initialize_at(FrontEndInput(scan, sensor, []), "points", self.pixels)
        if sum(one is not None for one in found) < LEAST:
            raise SlamlibError(
                f"{found.count(None)} of the target's {len(found)} points lie too near the image's border: "
                f"at least {LEAST} must be left"
            )
        pixel_of: dict[Landmark, Array] = {}
        stds = np.broadcast_to(self.std, len(found))
        for one, point, pixel, std in zip(found, self.points, self.pixels, stds, strict=True):
            if one is not None:
                number, _, signature = one
                block = slam.belief.add(EUC_POINT.manifold, point, std**2 * np.eye(3))
                landmark = Landmark(number, EUC_POINT, block, first_seen=1, signature=signature)
                slam.landmarks.append(landmark)
                pixel_of[landmark] = pixel
        predictions = slam.project()
        for prediction in predictions:
            prediction.measured, prediction.matched = pixel_of[prediction.landmark], True
        update_in_batch(slam.belief, sensor, predictions, replace(slam.options, gate=1.0))
