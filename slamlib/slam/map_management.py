"""Which landmarks a filter forgets that are not wrong: what left the window, and what makes room in a full map."""

from collections.abc import Callable, Iterable
from typing import Any

from slamlib.slam.entities import Landmark
from slamlib.slam.options import Options


def out_of_window(landmarks: Iterable[Landmark], looks: Iterable[Any], number: int, options: Options) -> set[Landmark]:
    """The landmarks that were not seen for more frames than the options' window, after the looks of frame `number`."""
    for look in looks:
        if look.inlier:
            look.landmark.seen = number
    return set() if options.window is None else {lm for lm in landmarks if number - lm.seen > options.window}


def makes_room(landmarks: Iterable[Landmark], number: int, options: Options) -> Landmark | None:
    """The landmark that helps least by the options' rule, of those not seen in frame `number`; None: nothing goes."""
    away = [landmark for landmark in landmarks if landmark.seen < number]
    return min(away, key=FULL[options.full], default=None) if options.full else None


def unseen(landmark: Landmark) -> Any:
    """By when it was seen last; of equals, the one that was believed least often."""
    return landmark.seen, landmark.inliers


def useless(landmark: Landmark) -> Any:
    """By the share of searches that ended in a measurement to believe; of equals, by when it was seen last."""
    return landmark.inliers / landmark.searched, landmark.seen


# What a landmark is worth, by the name of a rule: the least goes first.
FULL: dict[str, Callable[[Landmark], Any]] = {"unseen": unseen, "useless": useless}
