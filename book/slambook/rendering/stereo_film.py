"""A film of the rendered room by a stereo rig, as the tests, benchmarks and tools of stereo use it."""

from typing import Any

import numpy as np

from slambook import rendering
from slamlib.vision.stereo import stereo_frame, stereo_rig

LENS = {"intrinsics": (159.5, 119.5, 260.0, 260.0), "distortion": (0.0,)}


def stereo_film(frames: int, path: str = "sideways", seed: int = 1, std: Any = 0.1) -> tuple[Any, list[Any], Any]:
    """The rig with its one stereo sensor, frames with pairs and truths, and the film; seed: of textures and noise."""
    way = rendering.path(path)
    rig = rendering.rig_along_path(way, baseline=0.12, image=(320.0, 240.0), parameters=LENS)
    made = rendering.film(rendering.default_room(seed=seed), rig, way, frames=frames, rng=np.random.default_rng(seed))
    return (
        stereo_rig(rig, std if np.ndim(std) else (std,) * 3),
        [(stereo_frame(frame), truth) for frame, truth in made],
        made,
    )
