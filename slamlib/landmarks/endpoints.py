"""The two endpoints of a line landmark, kept outside the filter's state, and their update. Chapter segments.

The filter estimates an infinite line. Its endpoints matter for drawing and for predicting its visibility, and every
image shows others, because of occlusion and the image's border.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry import plucker
from slamlib.landmarks import hmg_point
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import Array, Mask


class ObservedEndpoints(NamedTuple):
    """Abscissas (..., 2) of a measured segment's endpoints, ascending, and the mask (...) of the usable ones."""

    abscissas: Array
    usable: Mask


@dataclass(frozen=True)
class EndpointExtension:
    """How endpoints follow a measurement: never (extend=False), or by the rule of eq. (li-extension).

    While the larger of both endpoints' standard deviations in the image is at least `switch` [px], a measurement
    replaces the endpoints; from then on it may only move them outwards. switch = inf: always outwards; 0: always
    replaced.
    """

    extend: bool = True
    switch: float = 10.0

    def __post_init__(self) -> None:
        if not self.switch >= 0:
            raise SlamlibError(f"EndpointExtension: switch is a standard deviation in pixels, not {self.switch}")

    def update(self, abscissas: Array, seen: ObservedEndpoints, spread: Array) -> Array:
        """New abscissas (..., 2), from the old ones, a measured segment's, and `largest_std` (...) [px]."""
        old = np.sort(np.asarray(abscissas, dtype=float), axis=-1)
        if not self.extend:
            return old
        wider = np.stack(
            [np.minimum(old[..., 0], seen.abscissas[..., 0]), np.maximum(old[..., 1], seen.abscissas[..., 1])], -1
        )
        follow = np.where((np.asarray(spread) < self.switch)[..., None], wider, seen.abscissas)
        return np.where(np.asarray(seen.usable)[..., None], follow, old)


def endpoints_at(kind: LineLandmark, landmark: Array, abscissas: Array) -> Array:
    """Homogeneous points (..., 2, 4) in the world at two abscissas (..., 2) of landmarks (..., size)."""
    return kind.point_at(np.asarray(landmark)[..., None, :], abscissas)


def abscissas_of(kind: LineLandmark, landmark: Array, points: Array) -> Array:
    """Abscissas (..., k) of the landmark's points nearest to homogeneous points (..., k, 4); nan if one is at infinity.

    The abscissa is a coordinate along the line, fixed by its points at 0 and at 1: eq. (li-abscissa).
    """
    zero, one = (kind.point_at(landmark, float(s)) for s in (0, 1))
    with np.errstate(divide="ignore", invalid="ignore"):
        start, end, found = (np.asarray(h)[..., :3] / np.asarray(h)[..., 3:] for h in (zero, one, points))
        along = end - start
        return ((found - start[..., None, :]) @ along[..., None])[..., 0] / (along * along).sum(-1)[..., None]


def observed_endpoints(
    kind: LineLandmark, landmark: Array, camera: Array, rays: Array, *, smallest_angle: float = np.radians(10)
) -> ObservedEndpoints:
    """Where the rays (..., 6) of a measured segment's endpoints, from the pose `camera` (7,), meet the landmark.

    Not usable where a ray makes less than `smallest_angle` [rad] with the line, and where they meet behind the camera.
    """
    line = kind.to_frame(camera, landmark)
    ray = np.asarray(rays, dtype=float)
    ray = ray.reshape(*ray.shape[:-1], 2, 3)
    point = plucker.crossing(line[..., None, :], ray)
    v = line[..., None, 3:]
    sine = np.linalg.norm(np.cross(ray, v), axis=-1)
    wide = sine > np.sin(smallest_angle) * np.linalg.norm(ray, axis=-1) * np.linalg.norm(v, axis=-1)
    found = np.sort(abscissas_of(kind, landmark, hmg_point.from_frame(camera, point)), axis=-1)
    usable = (wide & (point[..., 3] > 0)).all(-1) & np.isfinite(found).all(-1)
    return ObservedEndpoints(found, usable)


def largest_std(covariance: Array) -> Array:
    """Standard deviation (...) [px] in the worst direction, of covariances (..., 2, 2) of points in the image."""
    return np.sqrt(np.maximum(np.linalg.eigvalsh(covariance)[..., -1], 0))
