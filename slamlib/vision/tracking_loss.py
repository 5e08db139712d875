"""Frames without matches: predictions, as long as they last; too many of them in a row end a run."""

from dataclasses import dataclass

from slamlib.errors import SlamlibError

RECOVERED = 3  # landmarks that end a gap: one alone may be a wrong match


class TrackingLostError(SlamlibError):
    """Too many frames in a row without a match; what was done before is kept, and can be saved."""


@dataclass
class TrackingLoss:
    """The present gap in the matches, if there is one.

    It begins with a frame in which no match is believed. It ends with one that believes in three landmarks older than
    the gap: those that were begun in it are tied to nothing but a prediction, unless nothing was known before. first:
    number of its first frame, or None; last: of the last frame looked at; known: landmarks in the map before the gap.
    """

    first: int | None = None
    last: int = 0
    known: int = 0

    def update(self, number: int, births: list[int], landmarks: int) -> None:
        """Take note of a frame; births: of what is believed in it, the frame numbers; landmarks: in the map after."""
        if self.first is None:
            self.first = number if not births and self.last else None
        elif sum(born < self.first or not self.known for born in births) >= RECOVERED:
            self.first = None
        if self.first is None:
            self.known = landmarks
        self.last = number

    @property
    def frames(self) -> int:
        """How long it lasts, 0 if there is none."""
        return 0 if self.first is None else self.last - self.first + 1

    def check(self, patience: int, frames: str, causes: str, item: str) -> None:
        """Raise Lost if the gap has lasted for `patience` frames; the others are words of its message."""
        if self.frames >= patience:
            raise TrackingLostError(
                f"lost: {self.frames} {frames} in a row without a match, from frame {self.first} on; {causes} There is "
                f"no relocalization: go on with more patience, or begin anew at a later {item}"
            )
