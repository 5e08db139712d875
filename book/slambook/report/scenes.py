"""Small simulated worlds for the report's filter: a path, points around it, a sensor that sees them in 3-D."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from slambook.report import angles
from slambook.report.switches import Equations
from slamlib.manifolds import Array


@dataclass(frozen=True, eq=False)
class Scene:
    """start (6,), controls (steps, 6) true, control_std (6,), points (L, 3), what the sensor sees, and its noise.

    sees(points (L, 3) relative to the robot) -> mask (L,); covariance(equations, points (..., 3)) -> R (..., 3, 3) as
    the filter of these equations assumes. With the corrected equations R is the truth.
    """

    start: Array
    controls: Array
    control_std: Array
    points: Array
    sees: Callable[[Array], Array]
    covariance: Callable[[Equations, Array], Array]

    @property
    def U(self) -> Array:
        """Covariance of the control (6, 6)."""
        return np.diag(self.control_std**2)

    def path(self) -> Array:
        """The true poses (steps + 1, 6)."""
        poses = [self.start]
        for u in self.controls:
            poses.append(after(poses[-1], u))
        return np.array(poses)


def after(pose: Array, u: Array) -> Array:
    """The pose (..., 6) after a control (..., 6)."""
    moved = pose[..., :3] + (angles.rotation(pose[..., 3:]) @ u[..., :3, None])[..., 0]
    return np.concatenate([moved, angles.composed(pose[..., 3:], u[..., 3:], angles.extracted)], -1)


def constant(sigma: float) -> Callable[[Equations, Array], Array]:
    """The same noise in all three coordinates, wherever the point is."""

    def covariance(use: Equations, seen: Array) -> Array:
        return np.broadcast_to(use.noise(np.full(3, sigma)), (*seen.shape, 3))

    return covariance


def stereo(focal: float, base: float, pixels: float) -> Callable[[Equations, Array], Array]:
    """R = J sigma^2 J' of a triangulated point; camera along the robot's x axis, its columns to the right (-y)."""

    def covariance(use: Equations, seen: Array) -> Array:
        depth, left, up = np.moveaxis(seen, -1, 0)
        a, b, zero = depth / focal, depth / base / focal, np.zeros_like(depth)
        # by the columns in the left and in the right picture, and by their common row
        rows = ((-b * depth, b * depth, zero), (-b * left - a, b * left, zero), (-b * up, b * up, -a))
        J = np.stack([np.stack(row, -1) for row in rows], -2) * pixels
        return J @ J.swapaxes(-1, -2)

    return covariance


def within(reach: float) -> Callable[[Array], Array]:
    """Everything up to a distance, all around."""
    return lambda seen: np.linalg.norm(seen, axis=-1) < reach


def ahead(reach: float, nearest: float = 1.0) -> Callable[[Array], Array]:
    """What lies within 45 degrees of the robot's x axis, and neither too near nor too far."""
    return lambda seen: (seen[:, 0] > np.abs(seen[:, 1:]).max(-1)) & (seen[:, 0] > nearest) & (seen[:, 0] < reach)


def circle(pitch: float, roll: float, control: Array, std: Array, steps: int = 60, seed: int = 4) -> Scene:
    """A tilted robot drives round among forty points, up to 8 m from the middle; noise of 5 cm in each coordinate."""
    controls = np.tile(_radians(control), (steps, 1))
    start = _radians(np.array([0, 0, 0, 0, pitch, roll]))
    scene = Scene(start, controls, _radians(std), np.zeros((0, 3)), within(6.5), constant(0.05))
    return around(scene, np.random.default_rng(seed))


def around(scene: Scene, rng: np.random.Generator, count: int = 40) -> Scene:
    """The scene with points in a box of 16 by 16 by 5 m around the middle of its path."""
    points = rng.uniform(-1, 1, (count, 3)) * (8, 8, 2.5)
    return replace(scene, points=points + scene.path()[:, :3].mean(0))


def _radians(six: Array) -> Array:
    return np.concatenate([six[:3], np.radians(six[3:])])


def gentle() -> Scene:
    """Scene A of the list: pitch 10, roll 5; 0.3 m and (6, -0.5, 0.5) degrees a step; noise 0.02 m, 0.5 degrees."""
    return circle(10, 5, np.array([0.3, 0, 0, 6, -0.5, 0.5]), np.array([0.02] * 3 + [0.5] * 3))


def hard() -> Scene:
    """Scene B of the list: pitch 30, roll 20; 0.5 m and 10 degrees of yaw a step; noise 2 degrees in yaw alone."""
    return circle(30, 20, np.array([0.5, 0, 0, 10, 0, 0]), np.array([0.02] * 3 + [2, 0.1, 0.1]))


def uneven() -> Scene:
    """As gentle, but the robot starts and stops: no two controls in a row are alike."""
    scene = gentle()
    pace = 1 + np.sin(np.arange(len(scene.controls)) * np.pi / 3)
    return replace(scene, controls=scene.controls * pace[:, None])


def upright() -> Scene:
    """A level drive round, x axis ahead and z up: the heading is the yaw."""
    return circle(0, 0, np.array([0.3, 0, 0, 6, 0, 0]), np.array([0.02] * 3 + [0.5] * 3))


def optical() -> Scene:
    """The same drive in the axes of the first camera, z ahead and y down: the heading is the pitch (E06, E28)."""
    scene = upright()
    axes = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])
    controls = np.tile([0, 0, 0.3, 0, -np.radians(6), 0], (len(scene.controls), 1))
    return replace(scene, controls=controls, points=scene.points @ axes.T)


def rig() -> Scene:
    """A stereo camera of 700 pixels' focal length and 0.3 m base faces ahead, with half a pixel of noise."""
    scene = circle(0, 0, np.array([0.15, 0, 0, 6, 0, 0]), np.array([0.02] * 3 + [0.5] * 3))
    return replace(scene, sees=ahead(8.0, 2.0), covariance=stereo(700.0, 0.3, 0.5))


SCENES = {f.__name__: f for f in (gentle, hard, uneven, upright, optical, rig)}
