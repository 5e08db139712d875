"""`make plane-filters`: the filters from scratch of chapter ekf_slam on 400 runs of its loop, and store their NEES.

By seed the mean NEES (3 dof) of the robot in the frames 6 to 160 of two laps; the chapter makes the first 50 again.
"""

import argparse
import json
from contextlib import redirect_stdout
from functools import cache
from io import StringIO
from typing import Any

from book.tools import layout

FILE = layout.BOOK / "chapters" / "data" / "plane_filters.csv"
TITLE = (
    "# chapter ekf_slam: mean NEES (3 dof) of the robot in the frames 6 to 160 of a run of two laps (runs8), by seed"
)
SEEDS = *range(200), *range(2000, 2200)
FILTERS = "PlaneSlam", "Oracle", "FirstEstimates", "Invariant"
CELLS = "16-002", "16-004", "16-006", "16-094", "16-045", "16-096"  # of the chapter: world, filters and their trial
SKIPPED = 5  # frames, in which the covariance of the pose is still singular


@cache
def chapter() -> dict[str, Any]:
    """What some cells of the chapter define, by its name; what they print is left out."""
    cells = json.loads((layout.BOOK / "chapters" / "ekf_slam.ipynb").read_text("utf-8"))["cells"]
    own: dict[str, Any] = {"__name__": "__main__"}
    with redirect_stdout(StringIO()):
        exec("\n".join("".join(cell["source"]) for cell in cells if cell["id"] in CELLS), own)
    return own


def of_run(seed: int) -> list[float]:
    """Mean NEES of each filter in one run."""
    own = chapter()
    world, rig = own["planar"](8, far=4.0, wheels=(0.05, 1.0), noise=(0.3, 3.0))
    runs = [list(own["frames_of"](world, rig, seed))]
    found = [own["trial"](own[name], runs, own["noise_of"](rig))["NEES"] for name in FILTERS]
    return [float(nees[0, SKIPPED:].mean()) for nees in found]


def main() -> None:
    """Write the file, when all of it is done."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    rows = [",".join([str(seed), *(f"{value:.4f}" for value in of_run(seed))]) for seed in SEEDS]
    layout.write_whole(FILE, "\n".join([TITLE, ",".join(["seed", *FILTERS]), *rows, ""]).encode())
    print(f"wrote {FILE.relative_to(layout.ROOT)}: {len(rows)} runs")


if __name__ == "__main__":
    main()
