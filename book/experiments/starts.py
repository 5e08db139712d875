"""`make starts`: does one camera start in the right direction, and is it found again? Twenty rendered films of each.

Four starts, half of the films in a drawn room and half in one of photographs, 5 s each, run as `slamlib run images`
does by default: at rest, in motion, turning in one place for 1.5 s before it moves, and in motion before a single wall.
The first two also with `--initialization priors`, at rest with narrow ones too, and at rest twenty more films of each
start. Then films that are cut after 3 s: the camera is elsewhere, with the map in view, or turned away. Stored: a row
per film.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from slambook import rendering
from slambook.rendering import drawing
from slambook.rendering.paths import RAMP

from book.experiments import stored
from book.tools import layout
from slamlib.datasets.pictures import TimedImage
from slamlib.datasets.sources import of_pictures
from slamlib.experiments.progress import progress
from slamlib.geometry.pose import compose, relative
from slamlib.manifolds import Array
from slamlib.vision.active_search import ActiveSearchSettings
from slamlib.vision.opening import IMAGES, camera_rig, image_run, make_front_end
from slamlib.vision.relocalization import relocalize
from slamlib.vision.results import summary
from slamlib.vision.sequence_run import SequenceRun
from slamlib.vision.tracking_loss import TrackingLostError
from slamlib.vision.two_views import direction_error, two_view_target

FILE = layout.BOOK / "chapters" / "data" / "starts.json"
FILMS, FRAMES, DT = 20, 150, 1 / 30  # of each kind; of a film; [s] between two
STARTS = "at rest", "in motion", "turning", "planar"
STILL = {"at rest": 1.0, "turning": 1.5}  # [s] before the camera leaves its place
CUT, BLIND = 90, 20  # frames before a kidnapping; images of another part of the room in which the map is sought
NARROW: dict[str, Any] = {"impulse": (0.012, 1.2), "velocity": (0.04, 5.0)}  # of chapter monocular, in units of 2.5 m
NARROW_NOISE = {"std": (0.1,)}  # [px]


def walk(start: str, rng: np.random.Generator, offset: Array | None = None) -> rendering.CameraPath:
    """A hand's way before one of the walls, at random; offset (6,) [m, rad]: of a camera that is kidnapped."""
    times = np.linspace(0, (FRAMES + 2) * DT, 41)
    moving = np.maximum(times - STILL.get(start, 0.0), 0)
    if start in STILL:
        moving = np.where(moving < RAMP, moving**2 / (2 * RAMP), moving - RAMP / 2)
    yaw = 0.0 if start == "planar" else rng.integers(4) * np.pi / 2
    ahead, left, up = np.array([np.cos(yaw), np.sin(yaw), 0]), np.array([-np.sin(yaw), np.cos(yaw), 0]), np.eye(3)[2]
    direction = rng.choice([-1, 1]) * left + rng.uniform(-0.4, 0.4) * ahead + rng.uniform(-0.4, 0.4) * up
    swing, speed = rng.uniform(0.5, 0.9), rng.uniform(0.3, 0.6)
    place = np.array([*rng.uniform(-0.4, 0.4, 2), 1.3]) - swing / 2 * direction
    sway = rng.uniform(0.01, 0.03, 6) * np.sin(np.outer(moving, rng.uniform(1, 4, 6)))
    turns = rng.choice([-1, 1]) * 0.25 * np.sin(2 * times) if start == "turning" else 0 * times
    swept = np.outer(swing * np.sin(speed / swing * moving), direction)
    knots = np.column_stack([place + swept, np.zeros((len(times), 3))])
    knots[:, 5] += yaw + turns
    return rendering.CameraPath(times, knots + sway + (0 if offset is None else offset))


def filmed(start: str, seed: int, away: bool | None = None) -> tuple[Any, list[Array], Array]:
    """The rig, images, and true camera poses (n, 7) of a film.

    away: cut after CUT frames, to a view of the map or not.
    """
    rng = np.random.default_rng([STARTS.index(start), seed])
    room = rendering.default_room(("drawn", "photographs")[seed % 2])
    if start == "planar":
        texture = rendering.photograph("brick") if seed % 2 else drawing.plaster(rng, shapes=240)
        wall = rendering.TexturedQuad(np.array([3.0, 3, 3.5]), np.array([0, -6.0, 0]), np.array([0, 0, -4.5]), texture)
        room = rendering.Room([wall])
    state = rng.bit_generator.state
    paths = [walk(start, rng)]
    if away is not None:
        moved = np.concatenate([rng.uniform(-0.3, 0.3, 3), rng.uniform(-0.15, 0.15, 3)])
        moved[5] += np.pi if away else 0.0
        rng.bit_generator.state = state
        paths.append(walk(start, rng, moved))
    images, poses = list[Array](), list[Array]()
    for path, part in zip(paths, (slice(None),) if away is None else (slice(CUT), slice(CUT, None)), strict=True):
        rig = rendering.rig_along_path(path)
        film = rendering.film(room, rig, path, frames=FRAMES, dt=DT, rng=np.random.default_rng([seed, 1]))
        for frame, truth in list(film)[part]:
            images.append(np.asarray(frame.scans[0].image))
            poses.append(compose(truth.poses[0], rig.sensors[0].extrinsics))
    return rig, images, np.array(poses)


def new_run(rig: Any, images: list[Array], priors: str | None = None) -> SequenceRun:
    """As `slamlib run images` on these images: by default, or with --initialization priors, "usual" or "narrow"."""
    pictures = of_pictures([TimedImage(str(i), i * DT, image) for i, image in enumerate(images)], DT)
    lens = {"image": rig.sensors[0].image, "parameters": rig.sensors[0].parameters}
    own = camera_rig(lens | NARROW_NOISE, **NARROW) if priors == "narrow" else camera_rig(lens)
    calibration, camera = own.sensors[0].calibration, own.sensors[0].extrinsics
    settings = ActiveSearchSettings(max_in_view=60)
    front_end = make_front_end(IMAGES.options, calibration, np.random.default_rng(1), settings)
    start = None if priors else two_view_target(pictures, calibration, camera)
    run = image_run(pictures, own, front_end=front_end, start=start)
    run.relocalizes = True
    return run


def finish(run: SequenceRun) -> bool:
    """Whether the run came to its end."""
    try:
        for _ in run:
            pass
    except TrackingLostError:
        return False
    return True


def displacements(poses: Array) -> Array:
    """Poses (n, 7) seen from the first of them."""
    return np.array([relative(poses[0], pose) for pose in poses])


def started(start: str, seed: int, priors: str | None = None) -> dict[str, Any]:
    """One film: cosine between the estimated and the true path, share of inliers, whether two views were found.

    From priors instead: by how much [deg] two views speak against the path, None without any.
    """
    rig, images, true = filmed(start, seed)
    run = new_run(rig, images, priors)
    ended = finish(run)
    found = displacements(np.array(run.path))[:, :3].ravel()
    real = displacements(true)[: len(run.path), :3].ravel()
    cosine = float(found @ real) / max(float(np.linalg.norm(found) * np.linalg.norm(real)), 1e-9)
    row = {"cosine": round(cosine, 3), "inliers": round(summary(run.result())["inlier_share"] or 0.0, 3)}
    if priors is None:
        return row | {"views": bool(run.target), "lost": not ended}
    told = direction_error(run.source, run.slam.sensors[0].calibration, np.array(run.path))
    return row | {"direction_error": told and round(told[0], 1), "lost": not ended}


def kidnapped(seed: int) -> dict[str, Any]:
    """One film cut to another view of the map: how far the camera jumps [m], and the last ten poses' rms errors.

    off [m], turn [deg]: after the scale of the images before the cut. false: of the next BLIND images, had the camera
    been turned to the opposite wall, those that gave a pose.
    """
    rig, images, _ = filmed("in motion", seed)
    _, other, _ = filmed("in motion", seed, away=True)
    before = new_run(rig, images[:CUT])
    finish(before)
    false = sum(relocalize(before.slam, image) for image in other[CUT : CUT + BLIND])
    rig, images, true = filmed("in motion", seed, away=False)
    run = new_run(rig, images)
    finish(run)
    found, real = displacements(np.array(run.path)), displacements(true)[: len(run.path)]
    known = found[:CUT, :3].ravel()
    scale = float(known @ real[:CUT, :3].ravel() / (known @ known))
    off = np.linalg.norm(scale * found[-10:, :3] - real[-10:, :3], axis=1)
    turned = [2 * np.linalg.norm(relative(a, b)[4:]) for a, b in zip(found[-10:], real[-10:], strict=True)]
    return {
        "jump": round(float(np.linalg.norm(real[CUT, :3] - real[CUT - 1, :3])), 3),
        "off": round(float(np.sqrt((off**2).mean())), 3),
        "turn": round(float(np.degrees(np.sqrt(np.square(turned).mean()))), 2),
        "frames": len(run.path),
        "false": int(false),
    }


def rows(function: Any, *names: Any, first: int = 1, **said: Any) -> list[dict[str, Any]]:
    """Of each film, from number `first` on."""
    label = " ".join([function.__name__, *names, *said.values()])
    return [function(*names, seed, **said) for seed in progress(range(first, first + FILMS), FILMS, label)]


PARTS: dict[str, Callable[[], Any]] = {
    "frames": lambda: FRAMES,
    "blind": lambda: BLIND,
    **{start: partial(rows, started, start) for start in STARTS},
    "at rest, 20 more": partial(rows, started, "at rest", first=FILMS + 1),
    "usual priors, in motion": partial(rows, started, "in motion", priors="usual"),
    **{f"{kind} priors, at rest": partial(rows, started, "at rest", priors=kind) for kind in ("usual", "narrow")},
    **{
        f"{kind} priors, 20 more": partial(rows, started, "at rest", priors=kind, first=FILMS + 1)
        for kind in ("usual", "narrow")
    },
    "kidnapped": partial(rows, kidnapped),
}

if __name__ == "__main__":
    stored.main(FILE, PARTS, __doc__)
