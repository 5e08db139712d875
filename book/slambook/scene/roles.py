"""Styles by meaning: estimate or truth, converged or new, accepted or rejected.

The colours are the palette's, which readers with each kind of colour blindness tell apart; roles that stand side by
side differ in their marks or dashes too.
"""

from dataclasses import asdict, dataclass, replace

from slambook.figures.colors import Palette, colors
from slamlib.errors import UnknownNameError


@dataclass(frozen=True)
class Role:
    """A style: label for the legend, colour, line width [pt], line style, mark, its size [pt], opacity of the lines.

    hollow: the mark is empty. raised: height of the middle of words above their position [pt].
    """

    label: str
    color: str
    width: float = 1.2
    linestyle: str = "-"
    marker: str = "."
    size: float = 6.0
    alpha: float = 1.0
    hollow: bool = False
    raised: float = 0.0


# Of the map, in the order in which they are drawn: what comes later lies above.
MAP = {
    "ground": Role("", colors.faint, 0.6, alpha=0.35),
    "world": Role("world", colors.grey, 1.0, marker="+", size=6.5),
    "truth": Role("truth", colors.grey, 1.3, "--"),
    "new point": Role("new points", colors.orange, 1.0, marker="o", size=4.5, alpha=0.8, hollow=True),
    "point": Role("points", colors.green, 1.0, marker="o", size=3.5, alpha=0.8),
    "new line": Role("new lines", colors.orange, 1.6, "--"),
    "line": Role("lines", colors.green, 1.8),
    "sensor": Role("sensor", colors.purple, 1.1),
    "robot": Role("robot", colors.blue, 1.6),
    "label": Role("", colors.text, size=7.5, raised=3.0),
}
# Of a sensor's view; predicted measurements have the marks of the map.
SENSOR = {
    "raw": Role("delivered", colors.grey, 1.2, marker="+", size=7.0),
    "predicted_patch": Role("expected", colors.purple, 1.1, "--", marker=""),
    "missed": Role("not found", colors.orange, 1.7, ":", marker=""),
    "updated": Role("used", colors.blue, 1.4, marker=""),
    "rejected": Role("rejected", colors.red, 1.4, "-.", marker=""),
    "new point": Role("new", colors.orange, marker="o", size=4.5, hollow=True),
    "point": Role("converged", colors.green, marker="o", size=3.5),
    "measured": Role("matched", colors.text, 1.0, marker="x", size=5.5),
    "label": Role("", colors.text, size=7.5, raised=10.0),
    "line label": Role("", colors.text, size=7.5),
    "score": Role("", colors.text, size=6.5, raised=-10.0),
}
ROLES = {"map": MAP, "sensor": SENSOR}

# The palette on a dark page, as the page's style sheet has it.
DARK = Palette("#3592fa", "#f2a81b", "#47ce99", "#fd4b2e", "#cb6fb0", "#7d848b", "#ced6dd", "#737a81", "#121212")
THEMES = {"light": colors, "dark": DARK}
OUTLINE = "#010101"  # around everything that lies over a photograph, which may be bright there
HALO = 1.1  # points: how wide that is on either side


def over_image(role: Role) -> Role:
    """The role over a photograph: bright in each theme, for its outline is dark."""
    return replace(role, color=themed(role.color, "dark"))


def themed(color: str, theme: str) -> str:
    """A colour of the palette as it is on a light or a dark page; raises UnknownNameError."""
    if theme not in THEMES:
        raise UnknownNameError.of("theme", theme, THEMES)
    pairs = zip(asdict(colors).values(), asdict(THEMES[theme]).values(), strict=True)
    return dict(pairs).get(color, color)
