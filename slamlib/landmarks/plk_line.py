"""Pluecker line (n, v): six numbers for four degrees of freedom, with the constraint n . v = 0."""

from slamlib.geometry import plucker
from slamlib.geometry.pose import Pose
from slamlib.landmarks.parametrization import LineLandmark
from slamlib.manifolds import as_manifold
from slamlib.models import model


@model(pose=Pose, landmark=6)
def to_frame(pose, landmark):
    """Line in the frame. Chapter lines, eq. (li-toframe)."""
    return plucker.to_frame(pose, landmark)


@model(pose=Pose, rays=6, prior=2)
def from_frame(pose, rays, prior):
    """Prior: v in its plane, along the segment and against the view [1/m]. Chapter lines, eq. (li-rays)."""
    return plucker.from_frame(pose, plucker.from_rays(rays, prior))


@model(landmark=6, abscissa=())
def point_at(landmark, abscissa):
    """Homogeneous point, metres from the one nearest to the world's origin. Eq. (li-point)."""
    return plucker.point_at(landmark, abscissa)


@model(landmark=6, eye=3)
def constrain(landmark, eye):
    """Enforce n . v = 0, with the image from `eye` [m] unchanged. Eq. (li-constrain)."""
    return plucker.constrain(landmark, eye)


PLK_LINE = LineLandmark(
    "plkLin", as_manifold(6), to_frame, from_frame, point_at, (-8, 8), constrain, plucker.from_frame
)
