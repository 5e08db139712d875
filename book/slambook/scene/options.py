"""What a reader may choose about the two figures: plain data, checked when it is made."""

from dataclasses import dataclass, fields, replace
from typing import Any, TypeVar

import numpy as np

from slambook.scene.view import NAMED
from slamlib.errors import SlamlibError, UnknownNameError

Custom = tuple[float, ...]


@dataclass(frozen=True)
class MapOptions:
    """Of the map.

    view: "top", "side", "front", "view" (from above and aside), "normal" (behind the first robot, following it), or
    (azimuth [deg], elevation [deg], field of view [deg], and if wanted distance [m]). perspective: False for a parallel
    projection. orbit: how many degrees of azimuth and elevation the viewer moves from frame to frame. limits: half the
    side [m] of the square around the origin that is shown; None: what there is. size: of a robot [m]; None: to fit.
    sigmas: of the ellipsoids.
    """

    view: str | Custom = "view"
    perspective: bool = True
    orbit: tuple[float, float] = (0.0, 0.0)
    limits: float | None = None
    size: float | None = None
    sigmas: float = 3.0
    ellipsoids: bool = True
    labels: bool = True
    world: bool = True
    ground: bool = True
    legend: bool = True

    def __post_init__(self) -> None:
        if isinstance(self.view, str) and self.view not in NAMED:
            raise UnknownNameError.of("view", self.view, NAMED)
        if not isinstance(self.view, str):
            _numbers("view", self.view, (3, 4))
            if not 0 < self.view[2] < 150:
                raise SlamlibError(f"MapOptions: the field of view is 0 to 150 degrees, got {self.view[2]:g}")
        _numbers("orbit", self.orbit, (2,))
        for name in ("limits", "size", "sigmas"):
            value = getattr(self, name)
            if value is not None and not value > 0:
                raise SlamlibError(f"MapOptions: {name} should be a positive number, got {value!r}")


@dataclass(frozen=True)
class SensorOptions:
    """Of a sensor's figure.

    gate: probability that the ellipses of expectations hold; in an image none is drawn smaller than a mark. numbers:
    which two numbers of a measurement are drawn, across and up (pixels: down); names: what they are called, with their
    units. image: whether what a camera delivered lies below, in a page at most image_width pixels wide (None: as the
    page has room). scores: what a front end says of how well each match agrees. patches: what it looked for and what it
    found, beside the image in windows and films.
    """

    gate: float = 0.99
    numbers: tuple[int, int] = (0, 1)
    names: tuple[str, str] | None = None
    ellipses: bool = True
    labels: bool = True
    raw: bool = True
    legend: bool = True
    image: bool = True
    image_width: int | None = None
    scores: bool = True
    patches: bool = True

    def __post_init__(self) -> None:
        if self.image_width is not None and not (isinstance(self.image_width, int) and self.image_width > 0):
            raise SlamlibError(f"SensorOptions: image_width is a number of pixels, got {self.image_width!r}")
        if not 0 < self.gate < 1:
            raise SlamlibError(f"SensorOptions: gate is a probability between 0 and 1, got {self.gate!r}")
        if len(self.numbers) != 2 or not all(isinstance(n, int) and n >= 0 for n in self.numbers):
            raise SlamlibError(f"SensorOptions: numbers are two places in a measurement, got {self.numbers!r}")


O = TypeVar("O", MapOptions, SensorOptions)  # noqa: E741


def chosen(options: O, changes: dict[str, Any]) -> O:
    """The options with some of them changed; raises UnknownNameError for what is none of them."""
    known = [f.name for f in fields(options)]
    for name in changes:
        if name not in known:
            raise UnknownNameError.of(f"keyword of {type(options).__name__}", name, known)
    return replace(options, **changes)


def _numbers(name: str, values: Any, counts: tuple[int, ...]) -> None:
    if np.shape(values) not in [(c,) for c in counts] or not np.isfinite(np.asarray(values, dtype=float)).all():
        wanted = " or ".join(map(str, counts))
        raise SlamlibError(f"MapOptions: {name} should be {wanted} finite numbers, got {values!r}")
