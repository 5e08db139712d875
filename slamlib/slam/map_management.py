"""Which landmarks are deleted: bad ones, those outside the window, those pruned from a full map; a step's report."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Annotated

from slamlib.entities import Landmark
from slamlib.plain_data.fields import Count, OneOf, Plain, Share, Whole
from slamlib.records.ids import Id

# The rank of a landmark, by the name of a rule: the lowest is pruned first.
PRUNING_RULES: dict[str, Callable[[Landmark], tuple[float, ...]]] = {
    # the last frame as an inlier; of equals, the number of inliers
    "least-recently-seen": lambda landmark: (landmark.last_seen, landmark.inliers),
    # the share of searches that gave an inlier; of equals, the last frame as an inlier
    "least-reliable": lambda landmark: (landmark.inliers / landmark.searched, landmark.last_seen),
}


@dataclass(frozen=True, repr=False)
class UpkeepOptions(Plain):
    """Options of what stays in the map, as slamlib.Options explains them."""

    capacity: Whole | None = None
    pruning: Annotated[str, OneOf(PRUNING_RULES)] | None = None
    window: Whole | None = None
    min_searches: Count = 10
    min_matched_ratio: Share = 0.1
    min_inlier_ratio: Share = 0.5


@dataclass(frozen=True)
class StepReport:
    """What one step did: ids of the landmarks initialized, deleted, and refused because the map was full."""

    initialized: list[Id] = field(default_factory=list)
    deleted: list[Id] = field(default_factory=list)
    refused: list[Id] = field(default_factory=list)


def out_of_window(landmarks: Iterable[Landmark], number: int, options: UpkeepOptions) -> list[Landmark]:
    """The landmarks last accepted more frames before frame `number` than the options' window, in map order."""
    return [] if options.window is None else [lm for lm in landmarks if number - lm.last_seen > options.window]


def is_bad(landmark: Landmark, options: UpkeepOptions) -> bool:
    """Whether it was searched for often enough, and matched too seldom, or was too seldom an inlier when matched."""
    return landmark.searched >= options.min_searches and (
        landmark.matched < options.min_matched_ratio * landmark.searched
        or landmark.inliers < options.min_inlier_ratio * landmark.matched
    )


def prune_candidate(landmarks: Iterable[Landmark], number: int, options: UpkeepOptions) -> Landmark | None:
    """The landmark that ranks lowest by the options' rule, of those not seen in frame `number`; None: prune nothing."""
    away = [landmark for landmark in landmarks if landmark.last_seen < number]
    return min(away, key=PRUNING_RULES[options.pruning], default=None) if options.pruning else None
