"""How words look and how much room they take."""

from dataclasses import dataclass

import numpy as np

from slamlib.drawing.colors import colors, paint
from slamlib.drawing.paths import Box, number
from slamlib.drawing.words import width_of
from slamlib.spaces import Array

LINE = 1.2  # height of a line of text, in sizes of its font
_SINK = 0.24  # of that, below the line on which the letters stand
_LEFT = {"left": 0.0, "center": 0.5, "right": 1.0}
_TOP = {"top": 0.0, "center": 0.5, "bottom": 1.0, "baseline": 1.0}
_FIRST = {"top": 0.76, "center": 0.36, "bottom": -_SINK, "baseline": 0.0}  # from the point down to a single line
_ANCHORS = {"left": "start", "center": "middle", "right": "end"}


@dataclass(frozen=True)
class Lettering:
    """Size [pt] and colour of words, which of their sides lies on their point, their turn [degrees, to the left]."""

    size: float = 11.0
    color: str = colors.text
    ha: str = "left"
    va: str = "baseline"
    turned: float = 0.0

    def css(self) -> str:
        """The style of a text, or of a group of texts."""
        anchor = f";text-anchor:{_ANCHORS[self.ha]}" if self.ha != "left" else ""
        return f"fill:{paint(self.color)};font-size:{number(self.size)}px{anchor}"

    def box(self, x: float, y: float, words: str) -> Box:
        """Estimated box of words at a point."""
        lines = words.split("\n")
        wide, high = max(width_of(line, self.size) for line in lines), LINE * self.size * len(lines)
        sink = _SINK * self.size * (self.va == "baseline")
        corners = np.array([[0, wide, wide, 0], [0, 0, high, high]])
        corners = corners - [[_LEFT[self.ha] * wide], [_TOP[self.va] * high - sink]]
        across, down = self._turn() @ corners
        return float(x + across.min()), float(y + down.min()), float(x + across.max()), float(y + down.max())

    def line(self, x: float, y: float, index: int, count: int) -> tuple[float, float]:
        """Where a line of several begins, or has its middle or end."""
        above = {"top": 0, "center": (count - 1) / 2}.get(self.va, count - 1)
        across, down = self._turn() @ [0.0, self.size * (_FIRST[self.va] + LINE * (index - above))]
        return float(x + across), float(y + down)

    def _turn(self) -> Array:
        c, s = np.cos(np.radians(self.turned)), np.sin(np.radians(self.turned))
        return np.array([[c, s], [-s, c]])
