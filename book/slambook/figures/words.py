"""Words of a figure: `$x_1 = 10^{-3}$` as italics, raised and lowered pieces; how wide they are, how they stand."""
# ruff: noqa: RUF001 - letters that look alike are meant here

import re
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from slambook.figures.colors import colors, paint
from slambook.figures.paths import Box, number
from slamlib.errors import UnknownNameError
from slamlib.manifolds import Array

# Advance of each character in hundredths of the font's size: DejaVu Sans, among the widest that a page may choose.
_ADVANCES = {
    27: "'",
    28: "ijl",
    29: "IJ",
    32: " ,.·",
    34: "/:;\\|ι",
    36: "-f",
    40: "()[]t!r⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉",
    50: '*_`"°',
    53: "sz?⁻₋εζ",
    56: "cLνξΓ",
    59: "Fkvxyγκλυχ",
    62: "PTYaoeαθπτ",
    64: "ESbdghnpqu$0123456789{}βδημρσφ",
    69: "KAVBRXZΔΛψ",
    76: "CUHNDGΠΩ",
    80: "&OQΘΦΨ",
    84: "w#+<=>^~−±×→≤≥ω∞",
    87: "M",
    100: "%mW@…—",
}
_WIDTH = {character: hundredths / 100 for hundredths, group in _ADVANCES.items() for character in group}
_COMMANDS = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega pm times cdot le ge approx infty to circ"
)
_GREEK = dict(zip(_COMMANDS.split(), "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ±×·≤≥≈∞→°", strict=True))
_PIECE = re.compile(r"([\^_]?)(?:\{([^{}]*)\}|(\\[A-Za-z]+) ?|(\\.)|(.))", re.DOTALL)
SMALL = 0.7  # size of raised and lowered pieces
LINE = 1.2  # height of a line of text, in sizes of its font
_SINK = 0.24  # of that, below the line on which the letters stand
_LEFT = {"left": 0.0, "center": 0.5, "right": 1.0}
_TOP = {"top": 0.0, "center": 0.5, "bottom": 1.0, "baseline": 1.0}
_FIRST = {"top": 0.76, "center": 0.36, "bottom": -_SINK, "baseline": 0.0}  # from the point down to a single line
_ANCHORS = {"left": "start", "center": "middle", "right": "end"}


@dataclass(frozen=True)
class TextRun:
    """A piece of a line: its text, whether it is raised (1), lowered (-1) or neither (0), whether it is slanted."""

    text: str
    level: int = 0
    italic: bool = False


@lru_cache(maxsize=4096)
def runs(line: str) -> tuple[TextRun, ...]:
    """The pieces of a line; what stands between two dollar signs is mathematics. Raises UnknownNameError."""
    parts = line.split("$")
    if len(parts) % 2 == 0:  # a single dollar sign is one
        parts = [line]
    found: list[TextRun] = []
    for i, part in enumerate(parts):
        found += _mathematics(part) if i % 2 else [TextRun(part)] if part else []
    return tuple(found)


def _mathematics(source: str) -> list[TextRun]:
    found: list[TextRun] = []
    for mark, group, command, escaped, plain in _PIECE.findall(source):
        text = _symbol(command) if command else (escaped[1:] or plain or re.sub(r"\\[A-Za-z]+ ?", _replaced, group))
        run = TextRun(text.replace("-", "\N{MINUS SIGN}"), {"^": 1, "_": -1}.get(mark, 0), text.isalpha())
        if found and (found[-1].level, found[-1].italic) == (run.level, run.italic):
            run = TextRun(found.pop().text + run.text, run.level, run.italic)
        found.append(run)
    return found


def _replaced(command: re.Match[str]) -> str:
    return _symbol(command[0].strip())


def _symbol(command: str) -> str:
    if command[1:] not in _GREEK:
        raise UnknownNameError.of("command in $...$", command, ["\\" + name for name in _GREEK])
    return _GREEK[command[1:]]


def width_of(line: str, size: float) -> float:
    """Estimated width of a line of text in points, for a font of this size: rarely too small."""
    return size * sum(
        (SMALL if run.level else 1.0) * sum(_WIDTH.get(c, 0.68 if c < "\u1100" else 1.05) for c in run.text)
        for run in runs(line)
    )


def power_of_ten(exponent: int) -> str:
    """10 with a raised exponent, as mathematics."""
    return f"$10^{{{exponent}}}$"


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
