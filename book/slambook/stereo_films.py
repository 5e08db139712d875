"""Films of two cameras, for the tests, benchmarks and longer runs of stereo: rendered; odometry alone; tracks."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from slambook import rendering
from slambook.rendering import stereo_frame, stereo_rig
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array, Indices
from slamlib.vision.stereo import RelativeMotion, VisualOdometry

LENS = {"intrinsics": (159.5, 119.5, 260.0, 260.0), "distortion": (0.0,)}
DATA = Path(os.environ.get("SLAMLIB_DATA", ""))
_EUROC = """%YAML:1.0
sensor_type: camera
T_BS:
  cols: 4
  rows: 4
  data: [{}, 0, 0, 0, 1]
resolution: [752, 480]
camera_model: pinhole
distortion_model: radial-tangential
intrinsics: [{}]
distortion_coefficients: [{}]
"""
EUROC_CAMERAS = (  # pose in the body, row by row; intrinsics; distortion: of EuRoC's own files
    _EUROC.format(
        "0.0148655429818, -0.999880929698, 0.00414029679422, -0.0216401454975, 0.999557249008, 0.0149672133247, "
        "0.025715529948, -0.064676986768, -0.0257744366974, 0.00375618835797, 0.999660727178, 0.00981073058949",
        "458.654, 457.296, 367.215, 248.375",
        "-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05",
    ),
    _EUROC.format(
        "0.0125552670891, -0.999755099723, 0.0182237714554, -0.0198435579556, 0.999598781151, 0.0130119051815, "
        "0.0251588363115, 0.0453689425024, -0.0253898008918, 0.0179005838253, 0.999517347078, 0.00786212447038",
        "457.587, 456.134, 379.999, 255.238",
        "-0.28368365, 0.07451284, -0.00010473, -3.5559070e-05",
    ),
)


def stereo_film(
    frames: int, path: str = "sideways", seed: int = 1, std: Any = 0.1, room: rendering.Room | None = None
) -> tuple[Any, list[Any], Any]:
    """The rig with its one stereo sensor, frames with pairs and truths, and the film, 320 x 240 pixels, 12 cm apart.

    seed: of the noise, and of the textures if no room is given; std [px]: of each of u, v, d, or one for all.
    """
    way, room = rendering.path(path), rendering.default_room(seed=seed) if room is None else room
    rig = rendering.rig_along_path(way, baseline=0.12, image=(320.0, 240.0), parameters=LENS)
    made = rendering.film(room, rig, way, frames=frames, rng=np.random.default_rng(seed))
    pairs = [(stereo_frame(frame), truth) for frame, truth in made]
    return stereo_rig(rig, std if np.ndim(std) else (std,) * 3), pairs, made


def odometry(
    source: VisualOdometry, images: Iterable[Array], start: Array
) -> Iterator[tuple[Array, RelativeMotion | None]]:
    """The robot's pose (7,) after each pair, by visual odometry alone, and the motion that led to it, if one is known.

    start (7,): the pose at the first pair.
    """
    pose = start
    for image in images:
        motion = source.step(image)
        pose = pose if motion is None else compose(pose, motion.pose)
        yield pose, motion


class Tracks:
    """Ids of the features of the present pair, and how long each has been tracked.

    ids (n,) of the present features; ages (n,): pairs in which each was seen. A lost feature gets a new id when
    it is detected again: only a filter's map re-identifies it (slamlib.vision.stereo.stereo_search).
    """

    def __init__(self) -> None:
        self.last = 0
        self.ids = np.zeros(0, dtype=int)
        self.ages = np.zeros(0, dtype=int)

    def step(self, count: int, pairs: Indices) -> Array:
        """Advance to a pair with `count` features, `pairs` (k, 2) of old and new rows; the mask (n,) of the old ones.

        The mask is the report's re-observation mask: the features of the pair before that were matched again in both
        images of this one (5.2).
        """
        seen = np.zeros(len(self.ids), dtype=bool)
        seen[pairs[:, 0]] = True
        ids, ages = np.zeros(count, dtype=int), np.ones(count, dtype=int)
        ids[pairs[:, 1]], ages[pairs[:, 1]] = self.ids[pairs[:, 0]], self.ages[pairs[:, 0]] + 1
        fresh = ids == 0
        ids[fresh] = self.last + 1 + np.arange(fresh.sum())
        self.last += int(fresh.sum())
        self.ids, self.ages = ids, ages
        return seen


def pixel_noise(left: float, right: float) -> Array:
    """R (3, 3) of (u_l, v_l, u_l - u_r) [px^2], for independent u_l, v_l and u_r with these standard deviations [px].

    For both pixels detected independently: u and disparity are correlated then. For a disparity measured by aligning
    the left patch in the right image R is taken as diagonal.
    """
    J = np.array([[1.0, 0, 0], [0, 1, 0], [1, 0, -1]])
    return J @ np.diag([left**2, left**2, right**2]) @ J.T
