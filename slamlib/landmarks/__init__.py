"""How landmarks are held in the map, a file for each parametrization. Tangled from chapters 11 and 12."""

from typing import Any

from slamlib.errors import UnknownNameError
from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.modeling.registry import Registry

__all__ = ["LINES", "POINTS", "LineLandmark", "PointLandmark", "landmark"]

POINTS = Registry(__name__, PointLandmark, "point landmark")
LINES = Registry(__name__, LineLandmark, "line landmark")


def landmark(name: str) -> Any:
    """The parametrization of a name, as the seeds' toolbox spells it: 'ahmPnt', 'plkLin', ..."""
    for kinds in (POINTS, LINES):
        if name in kinds:
            return kinds[name]
    raise UnknownNameError.of("landmark", name, [*POINTS, *LINES])
