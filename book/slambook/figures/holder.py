"""What axes hold, in the order in which it was put there."""

from typing import Any, TypeVar

from slambook.figures.axis import Axis
from slambook.figures.colors import CYCLE, color_named
from slambook.figures.marks import Mark

M = TypeVar("M", bound=Mark)


class Holder:
    """A list of marks; colours that are not given come from the palette, one after the other."""

    def __init__(self) -> None:
        self.marks: list[Mark] = []
        self.x, self.y = Axis("x"), Axis("y")
        self.equal = False
        self._turns = {"lines": 0, "areas": 0}

    def _add(self, mark: M, style: dict[str, Any]) -> M:
        mark.label = "" if style.get("label") is None else str(style["label"])
        mark.zorder = mark.zorder if style.get("zorder") is None else float(style["zorder"])
        mark.clip = bool(style.get("clip_on", mark.clip))
        self.marks.append(mark)
        return mark

    def _next(self, kind: str, given: Any) -> str:
        """The colour that is asked for, or the next of the palette."""
        if given is not None:
            return color_named(given)
        self._turns[kind] += 1
        return CYCLE[(self._turns[kind] - 1) % len(CYCLE)]
