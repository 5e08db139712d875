"""Frames without matches: predictions, as long as they last; too many of them in a row end a run."""

from dataclasses import dataclass
from typing import Any

from slamlib.errors import SlamlibError

FOUND_AGAIN = 3  # landmarks that end a gap: one alone may be a wrong match


class Lost(SlamlibError):
    """Too many frames in a row without a match; what was done before is kept, and can be saved."""


@dataclass
class Gap:
    """The present gap, if there is one.

    It begins with a frame in which no match is believed. It ends with one that believes in three landmarks older than
    the gap: those that were begun in it are tied to nothing but a prediction, unless nothing was known before. first:
    number of its first frame, or None; last: of the last frame looked at; known: landmarks in the map before the gap.
    """

    first: int | None = None
    last: int = 0
    known: int = 0

    def follow(self, number: int, looks: list[Any], landmarks: int) -> None:
        """Take note of a frame, of what was seen in it, and of how many landmarks are in the map after it."""
        believed = [look.landmark for look in looks if look.inlier]
        if self.first is None:
            self.first = number if not believed and self.last else None
        elif sum(landmark.born < self.first or not self.known for landmark in believed) >= FOUND_AGAIN:
            self.first = None
        if self.first is None:
            self.known = landmarks
        self.last = number

    @property
    def frames(self) -> int:
        """How long it lasts, 0 if there is none."""
        return 0 if self.first is None else self.last - self.first + 1

    def check(self, patience: int, landmarks: int) -> None:
        """Raise Lost if the gap has lasted for `patience` frames; landmarks: how many are in the map."""
        if self.frames < patience:
            return
        why = (
            "was there a cut, or was the camera covered? Did it move more than the motion's impulses allow for, or do "
            "they allow for so much that of regions only the middle was searched (active search's setting `largest`)?"
            if landmarks
            else "no landmark could be begun: is there light, and texture?"
        )
        raise Lost(
            f"lost: {self.frames} frames in a row without a match, from frame {self.first} on; {why} There is no "
            "relocalization: go on with more patience, or begin anew at a later picture"
        )
