"""What a reader may choose about the two figures: plain data, checked when it is made."""

from dataclasses import dataclass
from math import inf
from typing import Annotated

from slambook.scene.view import NAMED
from slamlib.errors import SlamlibError
from slamlib.plain_data.fields import OneOf, Range, check

Finite = Annotated[float, Range(gt=-inf, lt=inf)]
Positive = Annotated[float, Range(gt=0)]
Place = Annotated[int, Range(ge=0)]


@dataclass(frozen=True)
class MapOptions:
    """Of the map.

    view: "top", "side", "front", "view" (from above and aside), "normal" (behind the first robot, following it), or
    (azimuth [deg], elevation [deg], field of view [deg], and if wanted distance [m]); None: "top" of a map in the
    plane, else "view". perspective: False for a parallel projection. orbit: how many degrees of azimuth and elevation
    the viewer moves from frame to frame. limits: half the side [m] of the square around the origin that is shown; None:
    what there is. size: of a robot [m]; None: to fit. sigmas: of the ellipsoids.
    """

    view: str | tuple[Finite, ...] | None = None
    perspective: bool = True
    orbit: tuple[Finite, Finite] = (0.0, 0.0)
    limits: Positive | None = None
    size: Positive | None = None
    sigmas: Positive = 3.0
    ellipsoids: bool = True
    labels: bool = True
    world: bool = True
    ground: bool = True
    legend: bool = True

    def __post_init__(self) -> None:
        check(self)
        if isinstance(self.view, str):
            OneOf(NAMED).check(self.view, "MapOptions.view")
        elif self.view is not None and (len(self.view) not in (3, 4) or not 0 < self.view[2] < 150):
            raise SlamlibError(
                "MapOptions.view should be (azimuth, elevation, field of view above 0 and below 150 [deg], and if "
                f"wanted distance [m]), got {self.view}"
            )


@dataclass(frozen=True)
class SensorOptions:
    """Of a sensor's figure.

    gate: probability within the ellipses of predictions; in an image none is drawn smaller than a mark. numbers:
    which two numbers of a measurement are drawn, across and up (pixels: down); names: what they are called, with their
    units. image: whether what a camera delivered lies below, in a page at most image_width pixels wide (None: as the
    page has room). scores: the front end's score of each match. patches: those it searched for and those it
    found, beside the image in windows and films.
    """

    gate: Annotated[float, Range(gt=0, lt=1)] = 0.99
    numbers: tuple[Place, Place] = (0, 1)
    names: tuple[str, str] | None = None
    ellipses: bool = True
    labels: bool = True
    raw: bool = True
    legend: bool = True
    image: bool = True
    image_width: Annotated[int, Range(gt=0, unit="px")] | None = None
    scores: bool = True
    patches: bool = True

    def __post_init__(self) -> None:
        check(self)
