"""Which landmarks a filter forgets that are not wrong: what left the window, and what makes room in a full map."""

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from slamlib.slam.entities import Landmark

if TYPE_CHECKING:
    from slamlib.slam.options import Options


def out_of_window(landmarks: Iterable[Landmark], number: int, options: "Options") -> list[Landmark]:
    """The landmarks that were not seen for more frames than the options' window, in frame `number`; in map order."""
    return [] if options.window is None else [lm for lm in landmarks if number - lm.seen > options.window]


def is_bad(landmark: Landmark, options: "Options") -> bool:
    """Whether it was looked for often, and too seldom found, or too seldom believed when it was found."""
    return landmark.searched >= options.search_first and (
        landmark.matched < options.keep_matched * landmark.searched
        or landmark.inliers < options.keep_inliers * landmark.matched
    )


def makes_room(landmarks: Iterable[Landmark], number: int, options: "Options") -> Landmark | None:
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
