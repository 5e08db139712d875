"""A film: the frames, each with its images, of a rig that is carried through a room, and the truth beside them."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from slambook.rendering.effects import Chip, Effects
from slambook.rendering.paths import CameraPath
from slambook.rendering.quads import Room
from slambook.rendering.renderer import Renderer
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.geometry.pose import Pose, compose, relative
from slamlib.geometry.quaternion import logarithm
from slamlib.manifolds import Array, read_only_copy
from slamlib.records.inputs import Control, Frame, Scan, Truth
from slamlib.rigs.setup import Numbers, Rig, RobotSetup, SensorSetup
from slamlib.simulation.sensors import drawn, root, streams

ASTRAY = 6.0  # standard deviations: the largest distance of a path's start from its rig's start


def _odometry(before: Array, after: Array, setup: RobotSetup, rng: np.random.Generator) -> Control | None:
    """The step as odometry measures it, with its setup's noise."""
    step = relative(before, after)
    exact = np.concatenate([step[:3], logarithm(step[3:])])
    return Control(exact + root(setup.noise) @ rng.standard_normal(6), setup.noise)


# By the name of the robot's motion: its control for a step between two poses; none with constant velocity.
TOLD: dict[str, Callable[..., Control | None]] = {"constVel": lambda *step: None, "odometry": _odometry}


class Film:
    """Frames of a rig with one robot, which goes along a path, an image (h, w), uint8, per sensor each; and truths.

    Iterate over it, as often as you like; each time it is the same film. It is made as it is seen, a frame at a time.

    frames: how many, dt [s] between them; frame 1 is one dt after the path's start. The rig's start is where the
    path starts: rig_along_path(path) makes such a rig. A robot with constant velocity has no controls (they are
    None), one with odometry its true steps and its setup's noise. samples: s x s per pixel. The film depends on `rng`
    as it is at this call. Raises SlamlibError at the call.
    """

    def __init__(
        self,
        room: Room,
        rig: Rig,
        path: CameraPath,
        *,
        frames: int,
        dt: float = 1 / 30,
        rng: np.random.Generator,
        effects: Effects = Effects(),  # noqa: B008 - frozen
        samples: int = 2,
    ) -> None:
        _check(rig, path, frames, dt, rng)
        self.room, self.rig, self.path, self.effects = room, rig, path, effects
        self.frames, self.dt, self.samples = int(frames), float(dt), samples
        self._random = [int(n) for n in rng.integers(2**32, size=4)]
        self.renderers = _renderers(room, rig, samples)

    def __len__(self) -> int:
        return self.frames

    def __iter__(self) -> Iterator[tuple[Frame, Truth]]:
        own = streams(np.random.default_rng(self._random), 1 + len(self.rig.sensors))
        setup = self.rig.robots[0]
        sensors = zip(self.rig.sensors, own[1:], strict=True)
        all_extrinsics = tuple(  # the true extrinsics are drawn where the filter is uncertain of them
            read_only_copy(drawn(Pose, s.extrinsics, s.covariance, stream["extrinsics"])) for s, stream in sensors
        )
        chips = [
            Chip(self.effects, r.tiles.size, s["points"], s["faults"])
            for r, s in zip(self.renderers, own[1:], strict=True)
        ]
        for number in range(1, self.frames + 1):
            before, after = (self.path.pose((number - i) * self.dt) for i in (1, 0))
            control = TOLD[setup.model.name](before, after, setup, own[0]["control"])
            light = (self._light(j, extrinsics, number * self.dt) for j, extrinsics in enumerate(all_extrinsics))
            images = [chip.expose(seen, self.dt) for chip, seen in zip(chips, light, strict=True)]
            scans = tuple(Scan(image=image) for image in images)
            state, _ = setup.model.at(after, self.path.velocity(number * self.dt))
            truth = Truth((read_only_copy(state),), all_extrinsics, (read_only_copy(after),))
            yield Frame(number, self.dt, (control,), scans), truth

    def truth_of(self, truth: Truth, pixels: Array, sensor: int = 0) -> Array:
        """The points (n, 3) [m] of the room that a sensor sees at pixels (n, 2) of a frame; nan where nothing is."""
        camera = compose(truth.poses[0], truth.extrinsics[sensor])
        return self.renderers[sensor].seen(camera, pixels)

    def _light(self, sensor: int, extrinsics: Array, time: float) -> Array:
        """What falls on the chip, the mean over the exposure, which is cut at the path's ends."""
        moments = np.clip(time + self.effects.moments, 0, self.path.duration)
        cameras = (compose(self.path.pose(moment), extrinsics) for moment in moments)
        return np.mean([self.renderers[sensor].render(camera).image for camera in cameras], axis=0)


film = Film

# -- rigs that start where a path begins: one camera or two in somebody's hand -----------------------------------------

IMAGE: Numbers = (320.0, 240.0)
LENS: dict[str, Numbers] = {"intrinsics": (159.5, 119.5, 260.0, 260.0), "distortion": (-0.1, 0.01)}
# In a step of 1/30 s: a hand's accelerations are some 0.5 m/s^2 and 0.3 rad/s^2.
IMPULSES: Numbers = (0.015, 0.015, 0.015, 0.6, 0.6, 0.6)


def rig_along_path(
    path: CameraPath,
    *,
    baseline: float | None = None,
    motion: str = "constVel",
    control_std: Numbers = IMPULSES,
    velocity_std: Numbers = (0.05, 0.05, 0.05, 2.0, 2.0, 2.0),
    image: Numbers = IMAGE,
    parameters: dict[str, Numbers] | None = None,
    std: Numbers = (0.15,),
) -> Rig:
    """A robot that starts as the path does, with a pin-hole camera at its origin, whose optical axis is its x axis.

    baseline [m]: with a second camera, `right`, so far to the right of the first, `left`. control_std and velocity_std
    as in RobotSetup; std [px], image (width, height) and parameters as in SensorSetup. The default std is that of
    correlation with sub-pixel steps in the rooms' pictures.
    """
    velocity = path.velocity(0)
    robot = RobotSetup(
        name="hand",
        motion=motion,
        position=tuple(path.pose(0)[:3].tolist()),
        euler=tuple(np.degrees(path.knots[0, 3:]).tolist()),
        velocity=tuple(np.concatenate([velocity[:3], np.degrees(velocity[3:])]).tolist()),
        velocity_std=velocity_std,
        control_std=control_std,
    )
    camera: dict[str, Any] = {"image": image, "parameters": dict(parameters or LENS), "std": std}
    if baseline is None:
        return Rig((robot,), (SensorSetup(**camera),))
    left = SensorSetup("left", **camera)
    return Rig((robot,), (left, SensorSetup("right", position=(0.0, -baseline, 0.0), **camera)))


def _renderers(room: Room, rig: Rig, samples: int) -> list[Renderer]:
    """One per sensor; sensors with the same calibration share theirs."""
    found, made = list[Renderer](), dict[str, Renderer]()
    for setup in rig.sensors:
        key = repr((setup.type, setup.image, sorted(setup.parameters.items()), sorted(setup.limits.items())))
        if key not in made:
            made[key] = Renderer(room, setup.calibration, samples)
        found.append(made[key])
    return found


def _check(rig: Rig, path: CameraPath, frames: int, dt: float, rng: np.random.Generator) -> None:
    """Raise SlamlibError for what cannot be filmed."""
    if not isinstance(rng, np.random.Generator):
        raise SlamlibError(f"film: rng is a generator, such as np.random.default_rng(1), not {rng!r}")
    if len(rig.robots) != 1:
        raise SlamlibError(f"film: a rig with one robot is filmed at a time, got {len(rig.robots)}")
    if not isinstance(frames, int | np.integer) or frames < 0:
        raise SlamlibError(f"film: frames is a whole number, 0 or more, got {frames}")
    if not 0 < dt < np.inf:
        raise SlamlibError(f"film: dt is a time above zero [s], got {dt}")
    if frames * dt > path.duration + 1e-9:
        raise SlamlibError(f"film: {frames} frames take {frames * dt:g} s, and the path {path.duration:g} s")
    setup = rig.robots[0]
    if setup.motion not in TOLD:
        raise UnknownNameError.of("motion to film", setup.motion, TOLD)
    start, P = setup.model.in_space(setup.state, setup.covariance)
    off = np.abs(Pose.minus(path.pose(0), start))
    if (off > ASTRAY * np.sqrt(np.diag(P)) + 1e-6).any():
        raise SlamlibError(
            f"film: the rig starts at {setup.position} m, {setup.euler} degrees, and the path at "
            f"{path.knots[0, :3].round(3).tolist()} m: use rig_along_path(path), or give the setup the path's start"
        )
