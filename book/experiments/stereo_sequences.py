"""Each source of a stereo filter's motion against visual odometry alone, by defaults, on real sequences at hand.

A rig waved by hand that sees the same places again and again (EuRoC's MH_01 before it flies: Burri and others, 2016)
and a street that is passed once (KITTI). Neither is shipped. ATE: root mean square of the distances
after the best rigid motion [m]; EuRoC's reference of the position is some 8 ms late against that of the orientation,
which is why the ATE is given by the time shift that makes odometry's own least, too.

With --numbers: odometry alone and the filter by the number of features that a cell of the grid may hold, and their
speeds relative to the default's, in the same run.
"""

import argparse
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from slambook import kitti_street
from slambook.stereo_films import DATA, EUROC_CAMERAS

from book.experiments import street
from slamlib.datasets.dataset import ImageSource
from slamlib.datasets.sources import of_pictures
from slamlib.errors import SlamlibError
from slamlib.evaluation.comparison import compared
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.experiments.progress import progress
from slamlib.vision.opening import PAIR_MOTION_SOURCES, open_stereo, stereo_run
from slamlib.vision.stereo import StereoSettings

EUROC = DATA / "stereo_euroc_mh01_hand"
LATE = 0.008  # s
NUMBERS = (1, 2, 3, 5, 8, 12)  # features of a cell

Sequence = tuple[ImageSource, dict[str, Any], Trajectory]


def waved() -> Sequence:
    """EuRoC's rig, waved by hand: the rectified pairs in memory, their camera, and the true path of the raw one."""
    with tempfile.TemporaryDirectory() as folder:
        files = [str(Path(folder) / f"cam{i}.yaml") for i in (0, 1)]
        for file, text in zip(files, EUROC_CAMERAS, strict=True):
            Path(file).write_text(text)
        left, right = (str(EUROC / f"cam{i}" / "*.jpg") for i in (0, 1))
        source, camera, _ = open_stereo(left=left, right=right, calibration=files, rectify=True, fps=20)
    pairs = list(progress(source, len(source), "reading"))
    first = np.loadtxt(EUROC / "frames.txt", usecols=0)[0]
    truth = read_trajectory(EUROC / "groundtruth.txt")
    begun = replace(truth, times=truth.times - first)
    return replace(of_pictures(pairs, source.interval), original=source.original), camera, begun


SEQUENCES: dict[str, tuple[Callable[[], object], Callable[[], Sequence]]] = {  # whether it is at hand, what opens it
    "waved": (EUROC.is_dir, waved),
    "street": (kitti_street.found, street.street),
}


def figures() -> dict[str, dict[str, dict[str, float]]]:
    """By sequence and source of the motion; of the sequences at hand."""
    found: dict[str, dict[str, dict[str, float]]] = {}
    for name, (at_hand, opened) in SEQUENCES.items():
        if at_hand():
            sequence = opened()
            found[name] = {motion: judged(sequence, motion) for motion in PAIR_MOTION_SOURCES}
    return found


def judged(sequence: Sequence, motion: str, **settings: Any) -> dict[str, float]:
    """A run by defaults, but for these settings: errors, how many landmarks (of odometry, features) a pair has inliers
    of, and its time."""
    source, camera, truth = sequence
    run = stereo_run(source, camera, motion_source=motion, settings=StereoSettings(**settings))
    began = time.process_time()
    try:
        street.finished(motion, run)
        stopped = 0
    except SlamlibError:  # lost: judged by what it has
        stopped = len(run.history)
    spent = 1e3 * (time.process_time() - began) / len(run.history)
    path, later = run.trajectory(), replace(truth, times=truth.times - LATE)
    ate, shifted = (compared(path, there, True)[0]["ate"] for there in (truth, later))
    matched = float(np.mean(run.result().inliers))
    return {"ate": ate, "shifted": shifted, "inliers": matched, "stopped": stopped, "milliseconds": spent}


def table(found: dict[str, dict[str, dict[str, float]]]) -> Iterator[str]:
    """As printed lines."""
    for name, rows in found.items():
        yield f"{name:24}    ATE     against    8 ms later   inliers   ms/pair"
        alone = rows["odometry"]["ate"]
        for motion, row in rows.items():
            lost = f"   lost at pair {row['stopped']:.0f}" if row["stopped"] else ""
            errors = f"{1e3 * row['ate']:6.1f} mm {row['ate'] / alone - 1:+12.0%} {1e3 * row['shifted']:10.1f} mm"
            yield f"{motion:24} {errors} {row['inliers']:9.1f} {row['milliseconds']:9.0f}{lost}"


def by_number(name: str) -> Iterator[str]:
    """Printed lines on one sequence: accuracy and speed by the number of features of a cell."""
    sequence, default = SEQUENCES[name][1](), StereoSettings().per_cell
    yield f"{name:8} features of a cell " + "".join(f"{per_cell:>11}" for per_cell in NUMBERS)
    for motion in ("odometry", "covariance-intersection"):
        rows = {per_cell: judged(sequence, motion, per_cell=per_cell) for per_cell in NUMBERS}
        usual = rows[default]["milliseconds"]
        yield f"{motion:24} ATE " + "".join(f"{1e3 * row['ate']:8.1f} mm" for row in rows.values())
        yield f"{'':21} inliers" + "".join(f"{row['inliers']:11.0f}" for row in rows.values())
        yield f"{'':23} speed" + "".join(f"{usual / row['milliseconds']:11.2f}" for row in rows.values())


def main() -> None:
    """Print the table, or that of the numbers."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--numbers", choices=SEQUENCES, help="numbers of features, on this sequence")
    given = parser.parse_args()
    if not any(at_hand() for at_hand, _ in SEQUENCES.values()):
        print("set SLAMLIB_DATA")
        return
    for line in by_number(given.numbers) if given.numbers else table(figures()):
        print(line, flush=True)


if __name__ == "__main__":
    main()
