"""`make real-images`: fetch chapter monocular's real sequence, run the filter on it, and store the figures of merit.

The images (80 of a robot-held camera, Inria's ViSP, GPL-2) are in Debian's package visp-images-data. They are fetched
once, by version and checksum, into _build/real, and never committed. The calibration and the two references, which
are not part of that package, are in book/chapters/data (visp_cube_*); the chapter describes how they were made.
"""

import argparse
import io
import json
import platform
import shutil
import sys
import tarfile
import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from book.tools import assets, layout
from book.tools.assets import AssetError
from slamlib.datasets.opening import open_sequence
from slamlib.evaluation.alignment import AlignedTrajectory, align_trajectory
from slamlib.evaluation.consistency import rmse
from slamlib.evaluation.trajectory import Trajectory, read_trajectory
from slamlib.experiments.progress import progress
from slamlib.vision.active_search import ActiveSearch
from slamlib.vision.opening import camera_rig, image_run, options_for
from slamlib.vision.results import ImageResult, summary
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.tracking_loss import TrackingLostError

PACKAGE, VERSION = "visp-images-data", "3.5.0-1"
INSIDE = "usr/share/visp-images-data/ViSP-images/cube/"
FOLDER = layout.BUILD / "real" / "visp_cube"
DATA = layout.BOOK / "chapters" / "data"
CALIBRATION, FILE = DATA / "visp_cube_calibration.json", DATA / "visp_cube_run.json"
REFERENCES = {"structure from motion": "visp_cube_sfm.txt", "dots of the cube": "visp_cube_dots.txt"}
COUNT, FPS = 80, 25.0
OPENCV = "opencv-python-headless"

SEEDS, FEW, NOISE, IMPULSE = tuple(range(1, 21)), tuple(range(1, 6)), 0.1, (0.3, 10.0)  # [px]; [unit/s], [deg/s]
SAID: dict[str, Any] = {"updates": 25, "max_new": 3, "inverse_distance": (1.0, 0.5), "outlier_rejection": "joint"}
LIGHT = 20  # frames that a test runs again
# Variants by their names in the chapter's table, with a few seeds each.
CHANGES: dict[str, dict[str, Any]] = {
    "impulses 0.1, 3": {"impulse": (0.1, 3.0)},
    "impulses 0.1, 10": {"impulse": (0.1, 10.0)},
    "impulses 1, 10": {"impulse": (1.0, 10.0)},
    "impulses 0.3, 30": {"impulse": (0.3, 30.0)},
    "12 updates": {"updates": 12},
    "gate alone": {"outlier_rejection": "each"},
    "one-point-ransac": {"outlier_rejection": "one-point-ransac"},
}


def folder() -> Path | None:
    """Where the images are, if they have been fetched."""
    return FOLDER if len(list(FOLDER.glob("*.pgm"))) == COUNT else None


def fetch() -> Path:
    """The images' folder; the package is downloaded if they are not there yet. Raises AssetError."""
    if folder() is None:
        package = assets.archive(PACKAGE).read_bytes()
        with tempfile.TemporaryDirectory(dir=layout.BUILD) as partial:
            count = unpack(package, Path(partial))
            if count != COUNT:
                raise AssetError(f"{PACKAGE}: {count} images in {INSIDE}, and {COUNT} are wanted")
            shutil.rmtree(FOLDER, ignore_errors=True)
            shutil.copytree(partial, FOLDER)
    return FOLDER


def unpack(package: bytes, target: Path) -> int:
    """Write the images of a Debian package, an `ar` archive with a `tar` in it, into a folder; how many."""
    with tarfile.open(fileobj=io.BytesIO(member(package, "data.tar"))) as packed:
        images = [m for m in packed if m.isfile() and m.name.removeprefix("./").startswith(INSIDE)]
        for image in images:
            content = packed.extractfile(image)
            assert content is not None  # it is a file
            layout.write_whole(target / Path(image.name).name, content.read())
    return len(images)


def member(package: bytes, name: str) -> bytes:
    """The member of an `ar` archive whose name begins so. Raises AssetError."""
    at = 8
    while package[:8] == b"!<arch>\n" and at + 60 <= len(package):
        head, size = package[at : at + 60], int(package[at + 48 : at + 58])
        if head[:16].decode().startswith(name):
            return package[at + 60 : at + 60 + size]
        at += 60 + size + size % 2
    raise AssetError(f"this is no Debian package: there is no {name} in it")


# -- the runs ----------------------------------------------------------------------------------------------------------


def run(
    images: Path,
    *,
    seed: int = 1,
    noise: float = NOISE,
    impulse: tuple[float, float] = IMPULSE,
    frames: int = COUNT,
    **said: Any,
) -> SequenceRun:
    """The filter on the sequence, a free scale; seed: of the choice of new landmarks; said: filter options."""
    source, camera = open_sequence(str(images), str(CALIBRATION), fps=FPS)
    rig = camera_rig({**camera, "std": (noise,)}, impulse=impulse)
    search = ActiveSearch(rig.sensors[0].calibration, np.random.default_rng(seed))
    work = image_run(source.part(0, 1, frames), rig, options_for(1.0, **{**SAID, **said}), search)
    for _ in work:
        pass
    return work


def compared(path: Trajectory, name: str = "structure from motion") -> AlignedTrajectory:
    """A path of the camera laid over one of the references (a similarity, its rotation from the orientations)."""
    reference = read_trajectory(DATA / REFERENCES[name])
    return align_trajectory(path, reference[np.arange(len(path))], rotation_from="orientations")


def merit(aligned: AlignedTrajectory) -> list[float]:
    """Errors that remain, rms: [% of the path], and [degrees]."""
    return [round(100 * aligned.relative_ate, 2), round(float(np.degrees(rmse(aligned.orientation[:, None]))), 2)]


def figures(result: ImageResult) -> dict[str, Any]:
    """Figures of merit of one run, rounded. `error`: by the reference's name, rms [% of the path], and [degrees]."""
    s = summary(result)
    both = {name: compared(result.trajectory, name) for name in REFERENCES}
    return {
        "off": {name: merit(a) for name, a in both.items()},
        "scale": round(both["structure from motion"].similarity.scale, 2),
        "tracked_mean": round(s["tracked_mean"], 1),
        "tracked_least": s["tracked_least"],
        "matched_share": round(s["matched_share"], 3),
        "inlier_share": round(s["inlier_share"], 3),
        "nis_per_dof": round(s["nis_per_dof"], 2),
        "landmarks": s["landmarks"],
    }


def told(result: ImageResult) -> dict[str, Any]:
    """One run frame by frame, for the figures: its aligned path, and the counts of searched, matched, inliers."""
    c, over = result.columns, compared(result.trajectory)
    whole = {name: c[name].astype(int).tolist() for name in ("searched", "matched", "inliers", "landmarks")}
    with np.errstate(invalid="ignore", divide="ignore"):
        nis = np.nan_to_num(c["nis"] / c["nis_dof"])
    return {
        **whole,
        "nis_per_dof": np.round(nis, 2).tolist(),
        "position": np.round(over.estimate.positions, 3).tolist(),
        "off": np.round(over.position, 3).tolist(),
    }


def measured(images: Path) -> dict[str, Any]:
    """Everything that the file holds."""
    cases: list[tuple[str, int, dict[str, Any]]] = [("as told", seed, {}) for seed in SEEDS]
    cases += [(name, seed, change) for name, change in CHANGES.items() for seed in FEW]
    found: dict[str, list[Any]] = {}
    first: SequenceRun | None = None
    for name, seed, change in progress(cases, len(cases), "runs"):
        try:
            work = run(images, seed=seed, **change)
            row: dict[str, Any] | None = figures(work.result())
            first = first or work
        except TrackingLostError:
            row = None
        found.setdefault(name, []).append(row)
    if first is None:
        raise AssetError("every run was lost")
    apart = compared(read_trajectory(DATA / REFERENCES["dots of the cube"]))  # rms, [% of the path], and [degrees]
    light = run(images, frames=LIGHT).trajectory().positions[-1]
    return {
        "images": f"{PACKAGE} {VERSION}, cube, {COUNT} of 384 x 288 pixels",
        "made with": {"python": platform.python_version(), **{n: version(n) for n in ("numpy", OPENCV)}},
        "noise": NOISE,
        "impulse": list(IMPULSE),
        "options": options_for(1.0, **SAID).to_dict(),
        "references agree to": merit(apart),
        "light": np.round(light, 4).tolist(),
        "first": told(first.result()),
        "runs": found,
    }


def main() -> int:
    """Fetch, run, store; exit status 0 if all went well."""
    parser = argparse.ArgumentParser(description="Fetch chapter monocular's real sequence, and run the filter on it.")
    parser.add_argument("--images", type=Path, help="a folder that holds the 80 images already")
    parser.add_argument("--only-fetch", action="store_true", help="do not run the filter")
    given = parser.parse_args()
    try:
        images = given.images or fetch()
    except AssetError as error:
        print(error, file=sys.stderr)
        return 1
    print(images)
    if not given.only_fetch:
        rows = json.dumps(measured(images), indent=None)
        layout.write_whole(FILE, (rows.replace('}, {"off"', '},\n{"off"').replace('], "', '],\n"') + "\n").encode())
        print(f"wrote {FILE.relative_to(layout.ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
