"""Identities of features: one number for each as long as it can be matched, without a filter."""

from typing import Any

import numpy as np

from slamlib.manifolds import Array, Indices


class Tracks:
    """Numbers of the features of the present pair, and how long each has been followed.

    ids (n,) of the present features; ages (n,): pairs in which each was seen. A feature that is lost gets another
    number when it is found again: only a filter's map remembers (slamlib.vision.stereo.front_end).
    """

    def __init__(self) -> None:
        self.last = 0
        self.ids = np.zeros(0, dtype=int)
        self.ages = np.zeros(0, dtype=int)

    def step(self, count: int, pairs: Indices) -> Array:
        """Go on to a pair with `count` features, `pairs` (k, 2) of old and new rows; the mask (n,) of the old ones.

        The mask is the report's of re-observation: which of the features of the pair before were matched again in both
        pictures of this one (5.2, C41).
        """
        seen = np.zeros(len(self.ids), dtype=bool)
        seen[pairs[:, 0]] = True
        ids, ages = np.zeros(count, dtype=int), np.ones(count, dtype=int)
        ids[pairs[:, 1]], ages[pairs[:, 1]] = self.ids[pairs[:, 0]], self.ages[pairs[:, 0]] + 1
        fresh = ids == 0
        ids[fresh] = self.last + 1 + np.arange(fresh.sum())
        self.last += int(fresh.sum())
        self.ids, self.ages = ids, ages
        return seen

    def dump(self) -> Any:
        """Plain data."""
        return {"last": self.last, "ids": self.ids.tolist(), "ages": self.ages.tolist()}

    def restore(self, state: Any) -> None:
        """Go on from what `dump` gave."""
        self.last = state["last"]
        self.ids, self.ages = (np.array(state[name], dtype=int) for name in ("ids", "ages"))
