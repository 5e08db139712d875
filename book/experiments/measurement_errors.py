"""`make measurement-errors`: what the errors of a landmark's measurement are made of, one cause at a time.

A hand carries one camera past a wall, half of the films in a drawn room and half in one of photographs. Each cause is
switched on alone: in the pictures, in the lens that the filter believes in, or in the search. The point that a
landmark's first pixel shows is known, and so is its true pixel in every later picture: stored are statistics of the
differences, a row per film and run. The filter runs as `slamlib run images` does, from the true pose and points that
are known to 0.1 % of their distance, so NEES needs no alignment. Resumable: what is stored is run again with --only.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from slambook import rendering
from slambook.rendering.effects import NO_EFFECTS, Chip, Effects
from slambook.rendering.film import LENS

from book.experiments import stored
from book.experiments.starts import DT, walk
from book.tools import layout
from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.sources import of_pictures
from slamlib.evaluation.pose_errors import pose_error
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry.pose import compose, from_frame, relative, to_frame
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.manifolds import Array, Image
from slamlib.vision.active_search import ActiveSearch, ActiveSearchSettings
from slamlib.vision.corners import best_corner
from slamlib.vision.grid import Grid
from slamlib.vision.opening import camera_rig, image_run, options_for
from slamlib.vision.patches import centred, cut
from slamlib.vision.results import summary
from slamlib.vision.target import Target

FILE = layout.BOOK / "chapters" / "data" / "measurement_errors.json"
FILMS, FRAMES, LIGHT, ROWS = 20, 75, 26, 240  # films; pictures of each, and of the one that a test runs; rows
STEPS, OPEN, READOUT = 6, 3, 0.020  # moments rendered per picture, and in an exposure; [s] from first to last row
GUESS, JUDGED, LAG = 0.001, slice(24, None, 10), 10  # of a point's distance; pictures whose NEES is stored; pictures
STD, DRAWN = 0.5, 0.1  # [px]: what the command tells the filter by default; what is drawn instead of measured


@dataclass(frozen=True)
class Cause:
    """lens: (u0, v0, fu, fv, radial) that the filter believes, minus the true ones; considered: their stds. drawn:
    matches are replaced by the truth and an error, whose variance stays with the landmark by this share. std [px]: told
    to the filter, or which figure of the film is; interval: pictures from one measurement of a landmark to the next."""

    effects: Effects = NO_EFFECTS
    shutter: bool = False
    rolling: bool = False
    lens: tuple[float, ...] = (0.0,) * 5
    warps: bool = True
    drawn: float | None = None
    std: float | str = STD
    interval: int = 1
    considered: tuple[float, ...] = ()


ALONE, ALL, AGAIN = "search alone", "all of these, warped", "rolling, 20 ms"
CAUSES = {
    ALONE: Cause(),
    "patches not warped": Cause(warps=False),
    "noise, 2 grey levels": Cause(replace(NO_EFFECTS, noise=2.0)),
    "gain 5 %, vignetting": Cause(replace(NO_EFFECTS, gain=0.05, vignetting=0.2)),
    "shutter open 17 ms": Cause(shutter=True),
    AGAIN: Cause(rolling=True),
    "focal length 0.5 %": Cause(lens=(0.0, 0.0, 1.3, 1.3, 0.0)),
    "centre 1 px": Cause(lens=(1.0, 0.0, 0.0, 0.0, 0.0)),
    "distortion 0.02": Cause(lens=(0.0, 0.0, 0.0, 0.0, 0.02)),
    ALL: Cause(Effects(), True, True, (1.0, 0.0, 1.3, 1.3, 0.02)),
}
REMEDIES: dict[str, dict[str, Any]] = {
    "std as patches claim": {"std": "claimed"},
    "std as measured": {"std": "rms"},
    "as measured, 1 in 5": {"std": "rms", "interval": 5},
    "lens considered": {"considered": (1.0, 1.0, 1.3, 1.3, 0.02)},
}
RUNS = CAUSES | {"drawn": Cause(drawn=0.0, std=DRAWN), "drawn, 90 % stays": Cause(drawn=0.9, std=DRAWN)}
RUNS |= {f"{name}: {way}": replace(CAUSES[name], **how) for name in (ALONE, ALL) for way, how in REMEDIES.items()}


def delay(row: Any) -> Any:
    """When a row of a rolling picture is read, in moments after the picture's time."""
    return (row / (ROWS - 1) - 0.5) * READOUT / DT * STEPS


class Film:
    """Pictures with each of the causes in them, and the truth."""

    def __init__(self, seed: int, frames: int = FRAMES) -> None:
        self.seed, self.path = seed, walk("in motion", np.random.default_rng([7, seed]))
        self.sensor = rendering.rig_along_path(self.path).sensors[0]
        room = rendering.default_room(("drawn", "photographs")[seed % 2])
        self.renderer = rendering.Renderer(room, self.sensor.calibration)
        self.poses = np.array([self.camera(STEPS * k) for k in range(frames)])
        looks = {(c.effects, c.shutter, c.rolling) for c in CAUSES.values()}
        chips = {look: Chip(look[0], (ROWS, 320), *np.random.default_rng([8, seed]).spawn(2)) for look in looks}
        self.pictures: dict[Any, list[Image]] = defaultdict(list)
        light: dict[int, Image] = {}
        for k in range(frames):
            moments = range(STEPS * k - 3, STEPS * k + 4)
            light = {m: light[m] if m in light else self.renderer.render(self.camera(m)).image for m in moments}
            for look, chip in chips.items():
                opened = (np.arange(OPEN) - OPEN // 2)[:, None] * look[1]
                apart = np.abs(np.arange(-3, 4) - delay(np.arange(ROWS))[:, None, None] * look[2] - opened)
                seen = np.einsum("vm,mvu->vu", np.maximum(1 - apart, 0).mean(1), np.array(list(light.values())))
                self.pictures[look].append(chip.expose(seen, DT))

    def camera(self, moment: float) -> Array:
        """True pose (7,) of the camera, so many moments after the first picture."""
        return compose(self.path.pose(DT * (1 + moment / STEPS)), self.sensor.extrinsics)

    def point(self, pixel: Array, picture: int, rolling: bool) -> Array:
        """The point (3,) of the room that is seen at a pixel (2,), when its row is read."""
        return self.renderer.seen(self.camera(STEPS * picture + delay(pixel[1]) * rolling), pixel[None])[0]

    def start(self, image: Image, rolling: bool) -> Target:
        """The points of the first picture that are given, in the frame of the rig's start."""
        grid, rng = Grid((320, ROWS)), np.random.default_rng([9, self.seed])
        corners = [best_corner(image, grid.rectangle((i, j)), border=12) for i, j in np.argwhere(grid.usable).tolist()]
        pixels = np.array([corner.pixel for corner in corners if corner is not None])
        points = np.array([self.point(pixel, 0, rolling) for pixel in pixels])
        std = GUESS * np.linalg.norm(points - self.poses[0][:3], axis=1)
        points += std[:, None] * rng.standard_normal(points.shape)
        return Target(from_frame(self.sensor.extrinsics, to_frame(self.poses[0], points)), pixels, std)


class Search(ActiveSearch):
    """Active search with a cause, that knows the truth; k: the number of its picture, from 0."""

    def __init__(self, calibration: Any, film: Film, cause: Cause) -> None:
        super().__init__(calibration, np.random.default_rng(1), ActiveSearchSettings(max_in_view=60))
        self.film, self.cause, self.k, self.points = film, cause, 1, dict[int, Array]()
        self.noise = np.random.default_rng([10, film.seed])
        self.own: dict[int, Array] = defaultdict(lambda: DRAWN * self.noise.standard_normal(2))

    def searchable(self, inputs: Any) -> list[Any]:
        """Those whose turn it is."""
        return [p for p in super().searchable(inputs) if (int(p.landmark.id) + self.k) % self.cause.interval == 0]

    def predict_appearances(self, inputs: Any, predictions: list[Any]) -> None:
        """Of the present pose, or the patches of the first views."""
        super().predict_appearances(inputs, predictions)
        for prediction in () if self.cause.warps else predictions:
            prediction.predicted_patch = prediction.landmark.signature.all[-1].template

    def find(self, inputs: Any, predictions: list[Any]) -> Iterator[tuple[int, Array]]:
        """What is found, or in its place the truth with a drawn error."""
        for row, pixel in super().find(inputs, predictions):
            if self.cause.drawn is not None:
                stays = np.sqrt(self.cause.drawn) * self.own[predictions[row].landmark.id]
                new = np.sqrt(1 - self.cause.drawn) * DRAWN * self.noise.standard_normal(2)
                true = self.true_pixel(predictions[row].landmark)
                pixel = np.where(np.isnan(true), pixel, true + stays + new)
            yield row, pixel

    def true_pixel(self, landmark: Any) -> Array:
        """Where the filter's lens shows the point (2,) in this picture; nan where the landmark's pixel shows none."""
        first, number = landmark.signature.all[-1], landmark.id
        if number not in self.points:
            self.points[number] = self.film.point(first.pixel, landmark.first_seen - 1, self.cause.rolling)
        return self.calibration.project(EUC_POINT.to_frame(self.film.poses[self.k], self.points[number])[None])[0]


def claimed(image: Image, template: Image, pixel: Array) -> float:
    """Standard deviation [px] of a match: what is left between the pictures, by the template's structure tensor."""
    if (seen := cut(image, pixel, len(template))) is None:
        return np.nan
    down, across = np.gradient(np.asarray(template, float))
    columns = np.stack([x.ravel() for x in (across, down, centred(template)[0], np.ones(template.shape))], axis=1)
    solution, *_ = np.linalg.lstsq(columns, seen.ravel(), rcond=None)
    left = seen.ravel() - columns @ solution
    P = (left @ left) / (left.size - 4) / solution[2] ** 2 * np.linalg.inv(columns.T @ columns)
    return float(np.sqrt(np.trace(P[:2, :2]) / 2))


def shared(errors: Array, groups: Array) -> float:
    """The share of the mean square of errors (n, 2) that the members of a group have in common: by pairs of them."""
    sums = sum(np.bincount(groups, x) ** 2 - np.bincount(groups, x**2) for x in errors.T)
    return float((sums / np.maximum(np.bincount(groups) - 1, 1)).sum() / (errors**2).sum())


def correlation(numbers: Array, at: Array, errors: Array, lag: int) -> float:
    """Of the errors of a landmark so many pictures apart; about zero, so that an error that stays counts."""
    key = numbers * 2 * FRAMES + at
    _, i, j = np.intersect1d(key + lag, key, return_indices=True)
    return float((errors[i] * errors[j]).sum() / np.sqrt((errors[i] ** 2).sum() * (errors[j] ** 2).sum()))


def filtered(film: Film, cause: Cause) -> tuple[dict[str, Any], Trajectory]:
    """One run of the filter over a film with a cause: its errors of measurement [px] and position [m], and its path."""
    images = film.pictures[cause.effects, cause.shutter, cause.rolling]
    pictures = of_pictures([TimedImage(str(i), i * DT, image) for i, image in enumerate(images)], DT)
    target, origin = film.start(images[0], cause.rolling), film.sensor.extrinsics
    unit = float(np.median(np.linalg.norm(target.points, axis=1)))
    lens = np.add([*LENS["intrinsics"], *LENS["distortion"]], [*cause.lens, 0.0]).tolist()
    camera = {"image": (320.0, float(ROWS)), "parameters": {"intrinsics": lens[:4], "distortion": lens[4:]}}
    rig = camera_rig({**camera, "std": (cause.std,)}, unit=unit)
    search, rows = Search(rig.sensors[0].calibration, film, cause), list[Any]()
    run = image_run(pictures, rig, options_for(unit), search, start=target)
    for step in run:
        for p in run.slam.predictions[0]:
            if p.inlier and p.predicted_patch is not None:
                claim = claimed(step.picture.image, p.predicted_patch, p.measured)
                rows.append((p.landmark.id, search.k, p.measured - search.true_pixel(p.landmark), claim))
        search.k = run.done
    path = run.trajectory()
    for off in np.diag(cause.considered):  # eq. (se-considered)
        other = replace(cause, lens=tuple(np.add(cause.lens, off)), considered=())
        path = path.considering(filtered(film, other)[1])
    numbers, at, errors, claims = map(np.array, zip(*rows, strict=True))
    numbers, at, errors = (x[np.isfinite(errors[:, 0])] for x in (numbers, at, errors))
    true = [compose(origin, relative(film.poses[0], pose)) for pose in film.poses]
    judged = map(pose_error, true, path.poses, np.array(path.covariances))
    off, _, nees, _ = map(np.array, zip(*judged, strict=True))
    return {
        "rms": float(np.sqrt((errors**2).mean())),
        "median": float(np.median(np.linalg.norm(errors, axis=1))),
        "picture": shared(errors, at),
        "landmark": shared(errors, numbers),
        "next": correlation(numbers, at, errors, 1) if cause.interval == 1 else None,
        "later": correlation(numbers, at, errors, LAG),
        "claimed": float(np.nanmedian(claims)),
        "nis": (found := summary(run.result()))["nis_per_dof"],
        "foretold": found["innovation_correlation"],
        "off": float(np.sqrt((off[JUDGED, :3] ** 2).sum(1).mean())),
        "nees": nees[JUDGED] / 6,
    }, path


def measured(seed: int) -> Any:
    """A film's numbers of each run."""
    film, rows = Film(seed), dict[str, dict[str, Any]]()
    for name, cause in RUNS.items():
        std = rows[name.partition(": ")[0]][cause.std] if isinstance(cause.std, str) else cause.std
        rows[name], _ = filtered(film, replace(cause, std=std))
    return stored.plain([list(row.values()) for row in rows.values()], 3)


PARTS: dict[str, Callable[[], Any]] = {
    "runs": lambda: list(RUNS),
    "light": lambda: stored.plain(filtered(Film(1, LIGHT), RUNS[AGAIN])[0], 3),
    **{str(seed): partial(measured, seed) for seed in range(1, FILMS + 1)},
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__, resumable=True)
