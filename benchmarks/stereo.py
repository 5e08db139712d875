"""The stereo front end: features and matches, plain visual odometry, and the filter, with truth beside them.

Rooms are rendered, 320 x 240 pixels, with a baseline of 12 cm. The street is an excerpt of KITTI's, where it is at hand
(it is not shipped: its licence is for non-commercial use); the filter on it is in book/experiments/street.py. Errors
are of the last position, as shares of the path. Times are the processor's.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
from collections.abc import Callable, Iterator

import numpy as np
from slambook import kitti_street
from slambook.stereo_films import stereo_film

from benchmarks.stereo_filter import Case, speed
from benchmarks.stereo_filter import room as filter_in_room
from book.experiments.stereo_room import STD
from book.experiments.visual_odometry import VARIANTS, odometry
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.sensors.sensor import Calibration
from slamlib.slam import Options
from slamlib.vision.stereo import MOTION_SOURCES, StereoSettings


def table(calibration: Calibration, extrinsics: Array, images: list[Array], poses: Array) -> Iterator[str]:
    """Rows of plain visual odometry for each variant; poses (n, 7): the robot's true ones."""
    path = np.linalg.norm(np.diff(poses[:, :3], axis=0), axis=1).sum()
    yield f"{'':27} stereo  cycle  inliers (least)  lost  z'S^-1z/dof  end error  ms/pair    (path {path:.2f} m)"
    for name, settings in VARIANTS.items():
        pose, c = odometry(calibration, extrinsics, images, poses[0], settings)
        error = np.linalg.norm(pose[:3] - poses[-1, :3]) / path
        yield (
            f"{name:27} {np.mean(c.stereo):6.0f} {np.mean(c.circular):6.0f} {np.mean(c.inliers):8.0f} "
            f"({min(c.inliers, default=0):5d}) {c.lost_frames:5d} {np.mean(c.nis_per_dof):12.2f} {error:10.2%} "
            f"{1e3 * c.seconds / len(images):8.0f}"
        )


def street() -> Iterator[str]:
    """Plain visual odometry on KITTI's street."""
    try:
        calibration, images, truth = kitti_street.pairs()
    except SlamlibError as error:
        yield f"skipped: {error}"
        return
    yield from table(calibration, np.array([0.0, 0, 0, 1, 0, 0, 0]), images, truth.poses)


def room(frames: int, path: str) -> Iterator[str]:
    """Plain visual odometry in the room, with the noise that the street has too."""
    rig, film, _ = stereo_film(frames, path, std=0.2)
    poses = np.array([truth.poses[0] for _, truth in film])
    images = [frame.scans[0].image for frame, _ in film]
    yield from table(rig.sensors[0].calibration, rig.sensors[0].extrinsics, images, poses)


FRAMES = {"sideways": 340, "round": 900}  # of a film past the wall, and of one once round and a little more


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--frames",
        type=int,
        help=f"of the filter's films (default {FRAMES['sideways']}; round: {FRAMES['round']}; for the speed: 60)",
    )
    parser.add_argument("--seeds", type=int, default=5, help="of the filter: textures and noise (default 5)")
    parser.add_argument("--std", type=float, nargs=3, default=STD, help="of u, v and d for the filter [px]")
    parser.add_argument("--path", choices=list(FRAMES), default="sideways", help="through the room (default sideways)")
    parser.add_argument(
        "--moving",
        dest="motion_source",
        choices=list(MOTION_SOURCES),
        default="correlated",
        help="motion source",
    )
    parser.add_argument(
        "--turns",
        dest="update_interval",
        type=int,
        default=10,
        help="a landmark is used for updates in one of so many frames (10)",
    )
    parser.add_argument("--enough", dest="max_in_view", type=int, default=30, help="landmarks in view (default 30)")
    parser.add_argument("--window", type=int, help="frames after which unseen landmarks are deleted (default: never)")
    parser.add_argument("--full", type=int, default=250, help="landmarks in the map whose speed is taken (default 250)")
    parser.add_argument("--sequence", action="store_true", help="update with one landmark after another")
    parser.add_argument("--only", choices=["street", "room", "filter", "speed"], help="one of the tables")
    given = parser.parse_args()
    options = Options(
        points="eucPnt",
        updates=60,
        max_new_first=given.max_in_view,
        max_new=5,
        window=given.window,
        reproject=given.sequence,
    )
    settings = StereoSettings(update_interval=given.update_interval, max_in_view=given.max_in_view)
    case = Case(given.motion_source, tuple(given.std), settings, options)
    tables: dict[str, Callable[[], Iterator[str]]] = {
        "street": street,
        "room": lambda: room(150, given.path),
        "filter": lambda: filter_in_room(case, given.path, given.frames or FRAMES[given.path], given.seeds),
        "speed": lambda: speed(case, given.frames or 60, given.full),
    }
    for name, rows in tables.items():
        if given.only in (None, name):
            print(f"--- {name}")
            for row in rows():
                print(row, flush=True)
            print()


if __name__ == "__main__":
    main()
