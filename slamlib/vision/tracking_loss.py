"""Tracking loss of a run on images: when it starts, when it ends, and the error of one that lasts too long."""

from dataclasses import dataclass

from slamlib.errors import SlamlibError

RECOVERED = 3  # landmarks that end a tracking loss: one alone may be a wrong match


class TrackingLostError(SlamlibError):
    """Too many frames in a row without a match; the frames before are kept, and can be saved."""


@dataclass
class TrackingLoss:
    """The present tracking loss, if there is one.

    It starts with a frame without inliers. It ends with one that has inliers of three landmarks older than the loss:
    landmarks initialized in it depend on a prediction alone, unless the map was empty before. first: number of its
    first frame, or None; last: of the last frame processed; known: landmarks in the map before the loss.
    """

    first: int | None = None
    last: int = 0
    known: int = 0

    def update(self, number: int, births: list[int], landmarks: int) -> None:
        """Record a frame; births: frames in which its inliers were initialized; landmarks: in the map after it."""
        if self.first is None:
            self.first = number if not births and self.last else None
        elif sum(born < self.first or not self.known for born in births) >= RECOVERED:
            self.first = None
        if self.first is None:
            self.known = landmarks
        self.last = number

    @property
    def frames(self) -> int:
        """Its length in frames, 0 if there is none."""
        return 0 if self.first is None else self.last - self.first + 1
