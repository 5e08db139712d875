"""`make plane-filters`: the filters from scratch of chapter ekf_slam, and all data at once, on 400 runs of its loop.

By seed the mean NEES (3 dof) of the robot in the frames 6 to 160 of two laps; of all data at once the error, too. The
chapter makes the first runs again.
"""

import argparse
import json
from contextlib import redirect_stdout
from functools import cache
from io import StringIO
from typing import Any

import numpy as np

from book.tools import layout

DATA = layout.BOOK / "chapters" / "data"
FILTERED, SMOOTHED = DATA / "plane_filters.csv", DATA / "plane_all_data.csv"
OF_RUN = "mean NEES (3 dof) of the"
TITLES = {
    FILTERED: f"# chapter ekf_slam: {OF_RUN} robot in the frames 6 to 160 of a run of two laps (runs8), by seed",
    SMOOTHED: f"# chapter ekf_slam, all data of a run at once, by seed: {OF_RUN} poses 6 to 160; place, rms [m]",
}
SEEDS = *range(200), *range(2000, 2200)
FILTERS = "PlaneSlam", "Oracle", "FirstEstimates", "Invariant"
CELLS = "16-002", "16-004", "16-006", "16-093", "16-094", "16-045", "16-096", "16-193"  # world, filters, their trial
SKIPPED = 5  # frames, in which the covariance of the pose is still singular


@cache
def chapter() -> dict[str, Any]:
    """What some cells of the chapter define, by its name; what they print is left out."""
    cells = json.loads((layout.BOOK / "chapters" / "ekf_slam.ipynb").read_text("utf-8"))["cells"]
    own: dict[str, Any] = {"__name__": "__main__"}
    with redirect_stdout(StringIO()):
        exec("\n".join("".join(cell["source"]) for cell in cells if cell["id"] in CELLS), own)
    return own


def loop() -> tuple[Any, Any]:
    """World and rig of the chapter's runs8."""
    world, rig = chapter()["planar"](8, far=4.0, wheels=(0.05, 1.0), noise=(0.3, 3.0))
    return world, rig


def filtered(seed: int) -> list[float]:
    """Mean NEES of each filter in one run."""
    own, (world, rig) = chapter(), loop()
    runs = [list(own["frames_of"](world, rig, seed))]
    found = [own["trial"](own[name], runs, own["noise_of"](rig))["NEES"] for name in FILTERS]
    return [float(nees[0, SKIPPED:].mean()) for nees in found]


def smoothed(seed: int) -> list[float]:
    """Mean NEES and error [m] of the poses of one run, by all its data at once."""
    own, (world, rig) = chapter(), loop()
    nees, off = own["at_once"](list(own["frames_of"](world, rig, seed)), rig)
    return [float(nees[SKIPPED:].mean()), float(np.sqrt((off**2).mean()))]


def main() -> None:
    """Write each file when all of it is done."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    for file, names, numbers in ((FILTERED, FILTERS, filtered), (SMOOTHED, ("NEES", "place"), smoothed)):
        rows = [",".join([str(seed), *(f"{value:.4f}" for value in numbers(seed))]) for seed in SEEDS]
        layout.write_whole(file, "\n".join([TITLES[file], ",".join(["seed", *names]), *rows, ""]).encode())
        print(f"wrote {file.relative_to(layout.ROOT)}: {len(rows)} runs", flush=True)


if __name__ == "__main__":
    main()
