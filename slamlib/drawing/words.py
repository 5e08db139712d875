"""Words of a figure: how wide they are, and `$x_1 = 10^{-3}$` as italics, raised and lowered pieces."""
# ruff: noqa: RUF001 - letters that look alike are meant here

import re
from dataclasses import dataclass
from functools import lru_cache

from slamlib.errors import UnknownNameError

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


@dataclass(frozen=True)
class Run:
    """A piece of a line: its text, whether it is raised (1), lowered (-1) or neither (0), whether it is slanted."""

    text: str
    level: int = 0
    italic: bool = False


@lru_cache(maxsize=4096)
def runs(line: str) -> tuple[Run, ...]:
    """The pieces of a line; what stands between two dollar signs is mathematics. Raises UnknownNameError."""
    parts = line.split("$")
    if len(parts) % 2 == 0:  # a single dollar sign is one
        parts = [line]
    found: list[Run] = []
    for i, part in enumerate(parts):
        found += _mathematics(part) if i % 2 else [Run(part)] if part else []
    return tuple(found)


def _mathematics(source: str) -> list[Run]:
    found: list[Run] = []
    for mark, group, command, escaped, plain in _PIECE.findall(source):
        text = _symbol(command) if command else (escaped[1:] or plain or re.sub(r"\\[A-Za-z]+ ?", _replaced, group))
        run = Run(text.replace("-", "\N{MINUS SIGN}"), {"^": 1, "_": -1}.get(mark, 0), text.isalpha())
        if found and (found[-1].level, found[-1].italic) == (run.level, run.italic):
            run = Run(found.pop().text + run.text, run.level, run.italic)
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
