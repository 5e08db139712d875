"""A palette that colour-blind readers can tell apart, and how it is put on; light and dark are the page's style.

Which colour a landmark, an ellipse, a robot of a map has is said in slambook.scene.roles.
"""

import re
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from slambook.figures.paths import number
from slamlib.errors import UnknownNameError


@dataclass(frozen=True)
class Palette:
    """Names of the colours; `text` and `paper` are the page's own, `faint` is for grids and the axes' lines.

    In the book the style sheet (figures.css) gives each a light and a dark value. Elsewhere the first six and `faint`
    keep these values, which are seen on white and on black; `text` and `paper` are those of the surrounding page.
    """

    blue: str = "#3690ff"
    orange: str = "#c2852c"
    green: str = "#057048"
    red: str = "#cc0407"
    purple: str = "#a251ba"
    grey: str = "#898989"
    text: str = "#1b1f24"
    faint: str = "#8c9299"
    paper: str = "#fffffe"


colors = Palette()
CYCLE = (colors.blue, colors.orange, colors.green, colors.red, colors.purple, colors.grey)
_ELSEWHERE = {
    "text": "currentColor",
    "paper": "var(--jp-layout-color0, var(--vscode-editor-background, Canvas))",
}
_NAMED = {
    **asdict(colors),
    **{f"C{i}": CYCLE[i % len(CYCLE)] for i in range(10)},
    "k": colors.text,
    "black": colors.text,
    "w": colors.paper,
    "white": colors.paper,
    "gray": colors.grey,
    "b": colors.blue,
    "g": colors.green,
    "r": colors.red,
    "m": colors.purple,
    "y": colors.orange,
    "none": "none",
}
# What matplotlib makes of the names of its own colours that the palette has too: they follow the theme as well.
_PLAIN = {
    "#000000": colors.text,
    "#ffffff": colors.paper,
    "#0000ff": colors.blue,
    "#008000": colors.green,
    "#ff0000": colors.red,
    "#808080": colors.grey,
}
_THEMED = {value: f"var(--figure-{name}, {_ELSEWHERE.get(name, value)})" for name, value in asdict(colors).items()} | {
    "none": "none"
}
_VARIABLE = re.compile(r"var\(--figure-(\w+), (?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)")


def color_named(color: Any) -> str:
    """A palette name, matplotlib letter ("k", "C1"), "#rrggbb", "none" or (r, g, b) of 0 to 1, as "#rrggbb" or "none".

    Raises UnknownNameError.
    """
    if not isinstance(color, str):
        levels = np.ravel(color)
        if levels.shape != (3,) or not np.all((levels >= 0) & (levels <= 1)):
            raise UnknownNameError.of("color", color, [*_NAMED, "#rrggbb", "(r, g, b) of 0 to 1"])
        return "#" + "".join(f"{round(255 * float(v)):02x}" for v in levels)
    if re.fullmatch(r"#[0-9a-fA-F]{6}", color):
        return _PLAIN.get(color.lower(), color.lower())
    if color not in _NAMED:
        raise UnknownNameError.of("color", color, [*_NAMED, "#rrggbb"])
    return _NAMED[color]


def paint(color: str) -> str:
    """The colour as CSS: the palette's colours, and plain black and white, are variables of the page's theme."""
    return _THEMED.get(color, color)


@dataclass(frozen=True)
class Stroke:
    """How a line is drawn: colour "#rrggbb", width in points, dashes in widths."""

    color: str
    width: float = 1.8
    dashes: tuple[float, ...] = ()
    alpha: float = 1.0

    def css(self) -> str:
        """The style of a path."""
        text = f"stroke:{paint(self.color)};stroke-width:{number(self.width)}"
        if self.dashes:
            text += ";stroke-dasharray:" + " ".join(number(d * self.width) for d in self.dashes)
        return text + (f";stroke-opacity:{number(self.alpha)}" if self.alpha < 1 else "")

    @property
    def seen(self) -> bool:
        """Whether it leaves anything on the paper."""
        return self.color != "none" and self.width > 0 and self.alpha > 0


@dataclass(frozen=True)
class Fill:
    """How an area is drawn: the colour inside, and the line around it, if any."""

    color: str
    alpha: float = 1.0
    edge: Stroke | None = None

    def css(self) -> str:
        """The style of a path."""
        faded = self.alpha < 1 and self.color != "none"
        text = f"fill:{paint(self.color)}" + (f";fill-opacity:{number(self.alpha)}" if faded else "")
        return text if self.edge is None or not self.edge.seen else f"{text};{self.edge.css()}"


def standing_alone(svg: str) -> str:
    """The drawing with the palette's light values in place of the page's variables: for a file of its own."""
    palette = {**asdict(colors), "paper": "#ffffff"}
    return _VARIABLE.sub(lambda found: palette[found[1]], svg)
