"""What was looked for in vain is left alone for a while.

What stands before a landmark is as a rule still there in the next frame. Without a rest, hidden landmarks, which
nothing corrects, would soon be the most uncertain ones, and be chosen first for ever.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any


@dataclass
class Rest:
    """A landmark that was missed so often in a row is not looked for in so many frames."""

    misses: int = 0
    frames: int = 0

    def is_over(self) -> bool:
        """Whether it may be looked for now; asked once a frame."""
        self.frames -= 1
        return self.frames < 0

    def longer(self, longest: int) -> "Rest":
        """After one more miss: 1, 2, 4 ... frames, at most `longest`."""
        return Rest(self.misses + 1, min(2**self.misses, longest))


class Rests:
    """The rests of all landmarks of a front end, by their ids."""

    def __init__(self) -> None:
        self.of: dict[int, Rest] = {}

    def __contains__(self, number: int) -> bool:
        """Whether a landmark was missed when it was last looked for."""
        return number in self.of

    def awake(self, looks: Iterable[Any]) -> list[Any]:
        """The looks at landmarks that do not rest; asked once a frame."""
        return [look for look in looks if self.of.get(look.landmark.id, Rest()).is_over()]

    def remember(self, looks: Iterable[Any], found: Iterable[bool], longest: int) -> None:
        """Landmarks that were not found rest, the longer the more often in a row; the others do not."""
        for look, is_found in zip(looks, found, strict=True):
            before = self.of.pop(look.landmark.id, Rest())
            if not is_found:
                self.of[look.landmark.id] = before.longer(longest)

    def dump(self) -> dict[int, tuple[int, int]]:
        """Plain data, for `restore`."""
        return {number: (rest.misses, rest.frames) for number, rest in self.of.items()}

    def restore(self, state: dict[Any, Any]) -> None:
        """Go on from what `dump` gave."""
        self.of = {int(number): Rest(*rest) for number, rest in state.items()}
