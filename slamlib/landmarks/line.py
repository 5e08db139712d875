"""What a parametrization of straight lines must offer."""

from dataclasses import dataclass

from slamlib.manifolds import Manifold
from slamlib.model import Model


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
