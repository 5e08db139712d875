"""Frames per second of rendered rooms, with the profile, and how well features can be followed in them.

Times are CPU times of one core. "followed": the share of strong corners whose patch of 13 x 13 pixels is found again at
its true position in the next frame, and in the fifth, with a correlation above 0.9.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import cProfile
import io
import pstats
import time
from collections.abc import Callable

import numpy as np
from slambook import rendering
from slambook.rendering.film import LENS
from slambook.rendering.judging import patches, strong_corners, zncc

from slamlib.geometry.pose import compose
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array

SIZES = (1, 2)  # times 320 x 240


def film(textures: str, path: str, samples: int, scale: int, frames: int) -> rendering.Film:
    """A film whose camera has so many times 320 x 240 pixels."""
    way = rendering.path(path)
    parameters = {"intrinsics": tuple(scale * n for n in LENS["intrinsics"]), "distortion": LENS["distortion"]}
    rig = rendering.rig_along_path(way, image=(320.0 * scale, 240.0 * scale), parameters=parameters)
    room = rendering.default_room(textures)
    return rendering.film(room, rig, way, frames=frames, rng=np.random.default_rng(1), samples=samples)


def seconds(act: Callable[[], object]) -> float:
    """CPU time of one call [s]."""
    began = time.process_time()
    act()
    return time.process_time() - began


def followed(made: rendering.Film, apart: int) -> Array:
    """Correlations of strong corners' patches with those at their true positions some frames later, all ten frames."""
    calibration = made.rig.sensors[0].calibration
    found, kept = [], {}
    for frame, truth in made:
        kept[frame.number] = frame.scans[0].image, truth
        if frame.number % 10 == apart and frame.number - apart in kept:
            image, before = kept[frame.number - apart]
            corners = strong_corners(image)
            camera = compose(truth.poses[0], truth.extrinsics[0])
            pixels = calibration.project(EUC_POINT.to_frame(camera, made.truth_of(before, corners)))
            inside = calibration.inside(pixels, 9)
            found.append(zncc(patches(image, corners[inside]), patches(frame.scans[0].image, pixels[inside])))
    return np.concatenate(found)


def report(frames: int, profile: bool) -> None:
    """Print the figures."""
    print(f"{'textures':12} {'path':9} {'image':8} samples  frames/s  first [s]")
    for textures in rendering.ROOM_STYLES:
        for path in rendering.PATHS:
            for scale in SIZES:
                start = time.process_time()
                made = film(textures, path, 2, scale, frames)
                ready = time.process_time() - start
                rate = frames / seconds(lambda made=made: list(made))  # type: ignore[misc]
                print(f"{textures:12} {path:9} {320 * scale}x{240 * scale:<4} 2 x 2   {rate:8.1f}  {ready:8.2f}")
    for textures in rendering.ROOM_STYLES:
        for apart in (1, 5):
            share = np.mean(followed(film(textures, "round", 2, 1, 150), apart) > 0.9)
            print(f"{textures}: followed after {apart} frame(s): {100 * share:.1f} %")
    if profile:
        made, profiler, text = film("drawn", "sideways", 2, 1, frames), cProfile.Profile(), io.StringIO()
        profiler.runcall(list, made)
        pstats.Stats(profiler, stream=text).sort_stats("tottime").print_stats(14)
        print(text.getvalue())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--profile", action="store_true")
    arguments = parser.parse_args()
    report(arguments.frames, arguments.profile)
