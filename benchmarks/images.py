"""The image machinery: how long a frame's searches take, and the quality of a corner against that of its matches.

Times are the least of many, of one run with one BLAS thread. The matches are those of scikit-image's photographs: seen
6 % larger, turned by 5 degrees, darker by 10 %, with noise in both images, and drawn by scikit-image's splines, so that
the true position is known without the code under test. No template is warped, as predictions may be that wrong.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads

import argparse
import cProfile
import importlib.util
import pstats
import time
from collections.abc import Callable
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from slamlib.geometry.pose import compose
from slamlib.geometry.quaternion import exponential
from slamlib.sensors.pinhole import PINHOLE
from slamlib.sensors.sensor import Calibration
from slamlib.vision.appearance import Appearance, predict
from slamlib.vision.corners import QUALITY, best_corner, strength
from slamlib.vision.grid import Grid
from slamlib.vision.patches import cut
from slamlib.vision.search import correlate, register, search

COUNT, SIZE = 12, 11
PARTS = {  # of a frame, and what they call
    "predict": ("seen_by", "warp"),
    "search": ("correlate", "ellipse", "best"),
    "best_corner": ("structure_tensor", "eigenvalues"),
}
GOAL = 6.0  # ms for the searches of a frame
S = 10.9 * np.eye(2)  # a 99 % ellipse of 20 px across: with a patch of 11 px, a window of 31 px
BOUNDS = (0, 50, 100, 200, 400, 800, 1600, 3200, 6400, np.inf)  # of quality, grey^2/px^2
RIGHT = 1.5  # px
PHOTOGRAPHS = (
    "camera",
    "coins",
    "page",
    "brick",
    "gravel",
    "grass",
    "astronaut",
    "coffee",
    "chelsea",
    "rocket",
    "moon",
)


def quickest(call: Callable[[], Any], seconds: float) -> float:
    """Least time [ms] of a call, tried for so long."""
    least, end = np.inf, time.perf_counter() + seconds
    while time.perf_counter() < end:
        start = time.perf_counter()
        call()
        least = min(least, time.perf_counter() - start)
    return least * 1e3


def texture(shape: tuple[int, int] = (240, 320), seed: int = 1) -> Any:
    """An image (h, w) of uint8 with details of all sizes."""
    rng, image = np.random.default_rng(seed), np.zeros(shape)
    for width in (2, 4, 8, 16, 32):
        coarse = rng.standard_normal([n // width + 2 for n in shape])
        image += np.kron(coarse, np.ones((width, width)))[: shape[0], : shape[1]]
    return np.clip(128 + 25 * image, 0, 255).astype(np.uint8)


class Scene:
    """Twelve landmarks five metres in front of a camera that has moved a little since it saw them first."""

    def __init__(self) -> None:
        rng = np.random.default_rng(2)
        self.image = texture()
        self.calibration = Calibration(
            PINHOLE, np.eye(2), image=(320, 240), intrinsics=[159.5, 119.5, 260, 260], distortion=[-0.1, 0.01]
        )
        first = np.array([0.0, 0, 0, 1, 0, 0, 0])
        self.pixels = rng.uniform((60, 60), (260, 180), (COUNT, 2))
        rays = self.calibration.sensor.back_project(self.pixels, np.full((COUNT, 1), 0.2), **self.calibration.given)
        self.points = rays
        self.now = compose(first, np.concatenate([[0.2, 0.1, 0.3], exponential(np.array([0.0, 0.02, 0.1]))]))
        taken = [Appearance.taken(self.image, p, first, SIZE) for p in self.pixels]
        self.appearances = [a for a in taken if a is not None]
        self.templates = [a.template for a in self.appearances]

    def predict(self) -> Any:
        """The templates of all, warped to this pose."""
        return predict(self.appearances, self.now, self.calibration, self.points, SIZE)

    def search(self) -> None:
        """Search for all."""
        for template, pixel in zip(self.templates, self.pixels, strict=True):
            search(self.image, template, pixel + 2, S)

    def detect(self) -> None:
        """The best corner of one cell."""
        best_corner(self.image, Grid((320, 240)).rectangle((2, 3)), quality=0)


def speed(seconds: float) -> str:
    """Table 1: milliseconds of the parts of a frame."""
    scene = Scene()
    calls: dict[str, Callable[[], Any]] = {
        f"search: {COUNT} templates of {SIZE} px, 317 places each (goal {GOAL:.0f})": scene.search,
        f"predict: {COUNT} templates, distortion and all": scene.predict,
        "detect: best corner of a cell of 40 x 40 px": scene.detect,
        "strength of a whole image of 320 x 240 px": partial(strength, scene.image),
    }
    return "\n".join(f"{quickest(call, seconds):8.2f} ms  {name}" for name, call in calls.items())


def beside_opencv(seconds: float) -> str:
    """Table 2: the correlation alone, beside OpenCV's in single precision."""
    if importlib.util.find_spec("cv2") is None:
        return "OpenCV is not installed: skipped (pip install 'slamlib[images]')"
    import cv2

    image = texture()
    patch, piece = cut(image, np.array([150, 120]), SIZE), image[105:146, 135:176].astype(float)
    assert patch is not None
    single = piece.astype(np.float32), patch.astype(np.float32)
    theirs = partial(cv2.matchTemplate, *single, cv2.TM_CCOEFF_NORMED)
    most = np.abs(theirs() - correlate(piece, patch)).max()
    ours, other = quickest(partial(correlate, piece, patch), seconds), quickest(theirs, seconds)
    return f"correlate, 31 x 31 places: {ours:.3f} ms, OpenCV {other:.3f} ms; scores differ by at most {most:.1e}"


def profile(calls: int = 100) -> str:
    """Table 3: where the time of the searches goes."""
    scene, profiler = Scene(), cProfile.Profile()
    profiler.enable()
    for _ in range(calls):
        scene.predict()
        scene.search()
        scene.detect()
    profiler.disable()
    table = pstats.Stats(profiler).stats  # type: ignore[attr-defined]
    found = {key[2]: row[3] for key, row in table.items() if "slamlib/vision" in key[0].replace(os.sep, "/")}
    whole = sum(found[name] for name in PARTS)
    shares = {name: ", ".join(f"{n} {found[n] / whole:.0%}" for n in inner) for name, inner in PARTS.items()}
    return "; ".join(f"{name} {found[name] / whole:.0%} (of it {shares[name]})" for name in PARTS)


def photograph(name: str) -> Any:
    """One of scikit-image's pictures, grey (240, 320), as floats."""
    from skimage import data, transform

    image = getattr(data, name)()
    grey = image @ [0.299, 0.587, 0.114] if image.ndim == 3 else image.astype(float)
    return transform.resize(grey, (240, 320), order=1, anti_aliasing=True, preserve_range=True)


def seen_twice(
    name: str, noise: float, rng: np.random.Generator, zoom: float, degrees: float
) -> tuple[Any, Any, Callable[[Any], Any]]:
    """A photograph, the same seen from elsewhere, both of uint8, and the function from pixels (n, 2) to pixels."""
    from skimage import transform

    def shift(by: Any) -> Any:
        return transform.SimilarityTransform(translation=by)

    image, centre = photograph(name), np.array([159.5, 119.5])
    turn = transform.SimilarityTransform(scale=zoom, rotation=np.radians(degrees))
    move = shift(-centre) + turn + shift(centre + np.array([2.3, -1.6]))
    other = 0.9 * transform.warp(image, move.inverse, order=3, preserve_range=True) + 5
    noisy = [np.rint(x + noise * rng.standard_normal(x.shape)) for x in (image, other)]
    first, second = (np.clip(x, 0, 255).astype(np.uint8) for x in noisy)
    return first, second, move


def matches(noise: float, zoom: float = 1.06, degrees: float = 5.0, sigma: float = 4.0) -> Any:
    """Rows (n, 5): quality of a corner, error of its match [px], score, second-best's ratio, error registered [px].

    Sought in the 99 % ellipse of `sigma` px around a position with an error of that size.
    """
    grid, rng, rows = Grid((320, 240), (20, 15), skip_outer=False), np.random.default_rng(1), []
    for name in PHOTOGRAPHS:
        first, second, move = seen_twice(name, noise, rng, zoom, degrees)
        for cell in np.ndindex(15, 20):
            corner = best_corner(first, grid.rectangle(cell), quality=1, border=30)
            if corner is None:
                continue
            pixel = np.rint(corner.pixel)
            place = move(pixel[None])[0]
            template, guess = cut(first, pixel, SIZE), place + sigma * rng.standard_normal(2)
            found = None if template is None else search(second, template, guess, sigma**2 * np.eye(2))
            if template is not None and found is not None:
                finer = register(second, template, found.pixel)
                finer = found.pixel if finer is None else finer
                errors = [np.hypot(*(pixel - place)) for pixel in (found.pixel, finer)]
                rows.append([corner.quality, errors[0], found.score, found.ratio, errors[1]])
    return np.array(rows)


def quality(noise: float, score: float, ratio: float) -> str:
    """Table 4: results of corners by their quality; a match is right if it is within 1.5 px."""
    rows = matches(noise)
    head = f"noise of {noise:g} grey levels: quality"
    lines = [f"{head:>32} {'searches':>9} {'right':>7} {'accepted':>9} {'of them wrong':>14} {'rms px':>7}"]
    for low, high in pairwise(BOUNDS):
        q, error, scores, ratios, _ = rows[(rows[:, 0] >= low) & (rows[:, 0] < high)].T
        right, taken = error < RIGHT, (scores >= score) & (ratios < ratio)
        rms = np.sqrt((error[right & taken] ** 2).mean() / 2)
        lines.append(
            f"{f'{low:g} to {high:g}':>32} {len(q):9} {right.mean():7.1%} {taken.mean():9.1%} "
            f"{(~right)[taken].mean():14.1%} {rms:7.2f}"
        )
    return "\n".join(lines)


def fractions() -> str:
    """Table 5: error of right matches of good corners, where the prediction is right, whole and by fractions."""
    lines = []
    for noise in (1.0, 4.0):
        rows = matches(noise, zoom=1.0, degrees=0.0)
        good = rows[(rows[:, 0] >= QUALITY) & (rows[:, 1] < RIGHT)]
        search_, finer = (np.sqrt((good[:, i] ** 2).mean() / 2) for i in (1, 4))
        lines.append(f"noise of {noise:g} grey levels: search {search_:.3f} px, register {finer:.3f} px")
    return "\n".join(lines)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=0.5, help="time spent on each measurement (default 0.5)")
    parser.add_argument("--score", type=float, default=0.85, help="least score of a match (default 0.85)")
    parser.add_argument("--ratio", type=float, default=0.95, help="its second-best's share of it (default 0.95)")
    options = parser.parse_args()
    print(f"{speed(options.seconds)}\n\n{beside_opencv(options.seconds)}\n\n{profile()}\n", flush=True)
    for noise in (2.0, 4.0):
        print(quality(noise, options.score, options.ratio), end="\n\n", flush=True)
    print(fractions())


if __name__ == "__main__":
    main()
