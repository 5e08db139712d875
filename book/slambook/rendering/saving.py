"""Films on disk, as programs for real sequences read them.

image_0/000001.png, ...    the pictures of camera 0, by the number of their frame; image_1 of camera 1, ...
times.txt                  a row for each: time [s]
calibration.json           the rig: robots and sensors, the fields of RobotSetup and SensorSetup
groundtruth_0.txt, ...     poses of camera 0, ... in the room, "time x y z qx qy qz qw" (TUM RGB-D's format)
"""

import json
from pathlib import Path

import numpy as np

from slambook.figures.images import png
from slambook.rendering.film import Film
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import Trajectory, write_tum
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import compose
from slamlib.manifolds import Array
from slamlib.plain_data.files import write_whole


def save_film(folder: str | Path, film: Film) -> Path:
    """Write a film into a folder that is not there yet, or empty; the list of times comes last.

    Each file is written atomically. Raises SlamlibError if the folder holds something, and for a film without
    frames.
    """
    root = Path(folder)
    if not len(film):
        raise SlamlibError("save_film: the film has no frames")
    if root.exists() and (not root.is_dir() or any(root.iterdir())):
        raise SlamlibError(f"{root} is there and not empty: give a new folder, so that two films are not mixed")
    count = len(film.rig.sensors)
    for camera in range(count):
        (root / f"image_{camera}").mkdir(parents=True)
    poses, times = [list[Array]() for _ in range(count)], list[float]()
    for frame, truth in progress(film, len(film), "filming"):
        times.append(frame.number * frame.dt)
        for camera, scan in enumerate(frame.scans):
            write_whole(root / f"image_{camera}" / f"{frame.number:06d}.png", png(scan.image))
            poses[camera].append(compose(truth.poses[0], truth.extrinsics[camera]))
    for camera, path in enumerate(poses):
        write_tum(root / f"groundtruth_{camera}.txt", Trajectory(np.array(times), np.array(path)))
    write_whole(root / "calibration.json", json.dumps(film.rig.to_dict(), indent=2) + "\n")
    write_whole(root / "times.txt", "".join(f"{time:.9f}\n" for time in times))
    return root
