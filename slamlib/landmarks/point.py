"""What a parametrization of points must offer."""

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
