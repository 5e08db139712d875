"""What a run on images begins with if nothing else is said: a camera carried by hand, points, and how many of them."""

from dataclasses import replace
from typing import Any

from slamlib.data.setup import Rig, RobotSetup, SensorSetup, tuples
from slamlib.slam import Options

OPTIONS = Options(points="ahmPnt", updates=25, first=12, later=3, inverse_distance=(1.0, 0.5), consensus="joint")
IMPULSE = (0.3, 10.0)
VELOCITY = (0.3, 10.0)
NOISE = 0.1  # px, of a matched patch; the real sequences' NIS says that this is rather too much than too little


def hand_held(
    camera: dict[str, Any],
    *,
    unit: float = 1.0,
    motion: str = "constVel",
    impulse: tuple[float, float] | None = None,
    velocity: tuple[float, float] | None = None,
) -> Rig:
    """A camera (plain data of a SensorSetup) that is carried about, as a rig; it starts at the origin, looking along x.

    impulse: standard deviations of the changes of velocity [m/s] and spin [deg/s] from one picture to the next;
    velocity: of both at the start. unit: typical distance of what is seen [m], which the defaults of both are scaled
    with; with a free scale it is the metre of the run itself, 1. A camera without an std has NOISE.
    """
    pushed, moving = (
        (default[0] * unit, default[1]) if given is None else given
        for given, default in ((impulse, IMPULSE), (velocity, VELOCITY))
    )
    robot = RobotSetup(
        motion=motion,
        velocity_std=(moving[0],) * 3 + (moving[1],) * 3,
        control_std=(pushed[0],) * 3 + (pushed[1],) * 3,
    )
    return Rig((robot,), (SensorSetup(**{"std": (NOISE,), **tuples(camera)}),))


def options(unit: float = 1.0, known: int = 0, **said: Any) -> Options:
    """OPTIONS for what is about `unit` [m] away, with those that are said in their places.

    A prior that is wrong for most landmarks is a wrong measurement of the scale, repeated with each of them. known: how
    many points of a target there are. They are looked at besides the others, and first of all: by information alone the
    most uncertain landmarks are chosen, and the known ones, which hold the scale, never.
    """
    mean, std = OPTIONS.inverse_distance
    first = {"choose": "order", "updates": OPTIONS.updates + known} if known else {}
    return replace(OPTIONS, **{"inverse_distance": (mean / unit, std / unit), **first, **said})
