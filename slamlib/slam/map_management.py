"""Which landmarks a filter forgets that are not wrong: what left the window, and what makes room in a full map."""

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from slamlib.slam.entities import Landmark

if TYPE_CHECKING:
    from slamlib.slam.options import Options


def out_of_window(landmarks: Iterable[Landmark], number: int, options: "Options") -> list[Landmark]:
    """The landmarks that were not seen for more frames than the options' window, in frame `number`; in map order."""
    return [] if options.window is None else [lm for lm in landmarks if number - lm.last_seen > options.window]


def is_bad(landmark: Landmark, options: "Options") -> bool:
    """Whether it was looked for often, and too seldom found, or too seldom believed when it was found."""
    return landmark.searched >= options.min_searches and (
        landmark.matched < options.min_matched_ratio * landmark.searched
        or landmark.inliers < options.min_inlier_ratio * landmark.matched
    )


def prune_candidate(landmarks: Iterable[Landmark], number: int, options: "Options") -> Landmark | None:
    """The landmark that helps least by the options' rule, of those not seen in frame `number`; None: nothing goes."""
    away = [landmark for landmark in landmarks if landmark.last_seen < number]
    return min(away, key=PRUNING_RULES[options.pruning], default=None) if options.pruning else None


def least_recently_seen(landmark: Landmark) -> Any:
    """By when it was seen last; of equals, the one that was believed least often."""
    return landmark.last_seen, landmark.inliers


def least_reliable(landmark: Landmark) -> Any:
    """By the share of searches that ended in a measurement to believe; of equals, by when it was seen last."""
    return landmark.inliers / landmark.searched, landmark.last_seen


# What a landmark is worth, by the name of a rule: the least goes first.
PRUNING_RULES: dict[str, Callable[[Landmark], Any]] = {
    "least-recently-seen": least_recently_seen,
    "least-reliable": least_reliable,
}
