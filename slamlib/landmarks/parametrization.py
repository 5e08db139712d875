"""What a parametrization of landmarks must offer: one of points, and one of straight lines."""

from dataclasses import dataclass

from slamlib.manifolds import Manifold
from slamlib.model import Model


@dataclass(frozen=True)
class PointLandmark:
    """A way to hold a point in the map: name, space of the state, and three models.

    to_frame(pose, landmark): homogeneous point (h, w) (4,) in the frame `pose`; the Euclidean point is h / w, and w = 0
    is at infinity. from_frame(pose, point): the landmark of a homogeneous point (4,) in that frame; a camera's ray has
    |h| = 1, so that w is the inverse distance [1/m]. to_point(landmark): Euclidean point (3,) in the world [m].
    """

    name: str
    manifold: Manifold
    to_frame: Model
    from_frame: Model
    to_point: Model


@dataclass(frozen=True)
class LineLandmark:
    """A way to hold a line in the map: name, space of the state, three models, and where its endpoints start.

    to_frame(pose, landmark): Pluecker coordinates (n, v) (6,) in the frame `pose`. from_frame(pose, rays, prior): the
    landmark seen along two unit rays (6,) of that frame, its endpoints', with the two numbers `prior` of what they do
    not tell. point_at(landmark, abscissa): homogeneous point (4,) of the world. abscissas: of the two endpoints.
    constrain(landmark, eye), where the state has more numbers than it may: the landmark made a line again, the same as
    seen from `eye` (3,); the filter calls it after each correction.
    """

    name: str
    manifold: Manifold
    to_frame: Model
    from_frame: Model
    point_at: Model
    abscissas: tuple[float, float]
    constrain: Model | None = None
