"""The interface of parametrizations of landmarks: points and straight lines."""

from dataclasses import dataclass
from typing import Protocol

from slamlib.manifolds import Manifold
from slamlib.models import Model
from slamlib.registry import Moved, TypeDescription


class Parametrization(Protocol):
    """What a parametrization of landmarks of any family has."""

    @property
    def name(self) -> str: ...

    @property
    def manifold(self) -> Manifold: ...

    @property
    def moved(self) -> Moved | None: ...


@dataclass(frozen=True)
class PointLandmark(TypeDescription):
    """A parametrization of points: name, manifold of the state, and its models.

    to_frame(pose, landmark): homogeneous point (h, w) (4,) in the frame `pose`; the Euclidean point is h / w, and w = 0
    is at infinity. from_frame(pose, point): the landmark of a homogeneous point (4,) in that frame; a camera's ray has
    |h| = 1, so that w is the inverse distance [1/m]. to_point(landmark): Euclidean point (3,) in the world [m].
    moved(motion, landmark): the landmark after a rigid motion (7,) of the world; a consistent filter needs it.
    plane: it holds points of the floor alone, z = 0 in the world, for sensors that measure in the plane.
    anchor: how many of the first degrees of freedom say where its ray begins, which is a convention; 0: none.
    """

    name: str
    manifold: Manifold
    to_frame: Model
    from_frame: Model
    to_point: Model
    moved: Moved | None = None
    plane: bool = False
    anchor: int = 0


@dataclass(frozen=True)
class LineLandmark(TypeDescription):
    """A parametrization of lines: name, manifold of the state, its models, and the endpoints' initial abscissas.

    to_frame(pose, landmark): Pluecker coordinates (n, v) (6,) in the frame `pose`. from_frame(pose, rays, prior): the
    landmark seen along two unit rays (6,) of that frame, its endpoints', with the prior (2,) of two unmeasured
    numbers. point_at(landmark, abscissa): homogeneous point (4,) in the world. abscissas: of the two endpoints.
    constrain(landmark, eye), for states with redundant numbers: enforces the line constraint with the image from
    `eye` (3,) unchanged; the filter calls it after each update. moved, anchor: as of points.
    """

    name: str
    manifold: Manifold
    to_frame: Model
    from_frame: Model
    point_at: Model
    abscissas: tuple[float, float]
    constrain: Model | None = None
    moved: Moved | None = None
    anchor: int = 0
