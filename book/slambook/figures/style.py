"""The arguments of a call, checked: numbers as arrays of floats; style names as strokes, fills, marks and letters."""

from typing import Any

import numpy as np

from slambook.figures.colors import Fill, Stroke, color_named, colors
from slambook.figures.markers import MARKERS, Marker
from slambook.figures.words import Lettering
from slamlib.errors import NonFiniteError, ShapeError, SlamlibError, UnknownNameError
from slamlib.manifolds import Array

SHORT = {
    "c": "color",
    "lw": "linewidth",
    "linewidths": "linewidth",
    "ls": "linestyle",
    "ms": "markersize",
    "mew": "markeredgewidth",
    "mfc": "markerfacecolor",
    "mec": "markeredgecolor",
    "fc": "facecolor",
    "ec": "edgecolor",
    "edgecolors": "edgecolor",
    "facecolors": "facecolor",
    "size": "fontsize",
    "horizontalalignment": "ha",
    "verticalalignment": "va",
}
DASHES = {"-": (), "--": (3.7, 1.6), ":": (1.0, 1.65), "-.": (6.4, 1.6, 1.0, 1.6)}  # in line widths
LINESTYLES = {**{d: d for d in DASHES}, "solid": "-", "dashed": "--", "dotted": ":", "dashdot": "-."}
LINESTYLES |= {"": "", " ": "", "none": "", "None": ""}
COMMON = ("alpha", "label", "zorder", "clip_on", "gid")
STROKE = ("color", "linewidth", "linestyle")
MARKER = ("marker", "markersize", "markeredgewidth", "markerfacecolor", "markeredgecolor")
LETTERS = ("color", "fontsize", "ha", "va", "rotation", "zorder", "clip_on", "gid")
SIDES = {"ha": ("left", "center", "right"), "va": ("top", "center", "bottom", "baseline")}
TURNS = {"horizontal": 0.0, "vertical": 90.0}
FILL = ("color", "facecolor", "edgecolor", "linewidth", "linestyle")


LARGEST = 1e300  # greater numbers overflow when limits are computed from them


def numbers(function: str, name: str, values: Any) -> Array:
    """Numbers as floats; nan is a gap. Raises SlamlibError for what is no real number, NonFiniteError for infinity."""
    given = np.asarray(values)
    if given.dtype.kind not in "buif" and given.size:
        raise SlamlibError(f"{function}: {name} should be real numbers, not {given.dtype}")
    found = given.astype(float)
    beyond = np.abs(found) > LARGEST
    if np.any(beyond):
        at = tuple(int(i) for i in np.argwhere(beyond)[0])
        raise NonFiniteError(
            f"{function}: {name}[{', '.join(map(str, at))}] is {found[at]:g}: leave it out, or put nan for a gap"
        )
    return found


def row_of(function: str, name: str, values: Any) -> Array:
    """Numbers as one row; a single one is a row of one. Raises ShapeError too."""
    found = np.atleast_1d(numbers(function, name, values))
    if found.ndim != 1:
        raise ShapeError(f"{function}: {name} should be one row of numbers, but has shape {found.shape}")
    return found


def rows_of(function: str, **values: Any) -> list[Array]:
    """Rows of numbers of one length; a single number goes with each of the others'. Raises ShapeError too."""
    rows = [row_of(function, name, value) for name, value in values.items()]
    lengths = {len(row) for row in rows if len(row) != 1}
    if len(lengths) > 1:
        given = ", ".join(f"{name} {len(row)}" for name, row in zip(values, rows, strict=True))
        raise ShapeError(f"{function}: these should have the same length: {given}")
    length = lengths.pop() if lengths else 1
    return [np.broadcast_to(row, (length,)) for row in rows]


def named(function: str, given: dict[str, Any], known: tuple[str, ...]) -> dict[str, Any]:
    """The keywords under their long names; raises UnknownNameError for others, SlamlibError for one given twice."""
    found: dict[str, Any] = {}
    for name, value in given.items():
        long = SHORT.get(name, name)
        if long not in known:
            short = [s for s, full in SHORT.items() if full in known]
            raise UnknownNameError.of(f"keyword of {function}", name, [*known, *short])
        if long in found:
            raise SlamlibError(f"{function}: {long} is given twice, as {name} too")
        found[long] = value
    return found


def format_of(text: str) -> dict[str, Any]:
    """matplotlib's short form of line style, marker and color, as "o-" or "r--"; raises UnknownNameError."""
    found: dict[str, Any] = {}
    rest = text
    while rest:
        for name, known in (("linestyle", DASHES), ("marker", MARKERS), ("color", "bgrmykw")):
            token = next((t for t in (rest[:2], rest[:1]) if t and t in known), "")
            if token and name not in found:
                found[name], rest = token, rest[len(token) :]
                break
        else:
            raise UnknownNameError.of("part of a line format", rest, [*DASHES, *MARKERS, *"bgrmykw"])
    return found if "linestyle" in found or "marker" not in found else {**found, "linestyle": ""}


def stroke_of(style: dict[str, Any], color: str, width: float = 1.8) -> Stroke | None:
    """The stroke that keywords (long names) ask for, None for no line; `color` if none is. Raises UnknownNameError."""
    linestyle = style.get("linestyle", "-")
    if linestyle is not None and (not isinstance(linestyle, str) or linestyle not in LINESTYLES):
        raise UnknownNameError.of("linestyle", linestyle, [name for name in LINESTYLES if name.strip()])
    dashes = LINESTYLES[linestyle or ""]
    if not dashes:
        return None
    chosen = color_named(style.get("color") or color)
    return Stroke(chosen, positive(style, "linewidth", width), DASHES[dashes], alpha_of(style))


def fill_of(style: dict[str, Any], color: str) -> Fill:
    """The fill that keywords (long names) ask for; an edge only if it has a colour or a width."""
    inside = color_named(style.get("facecolor") or style.get("color") or color)
    alpha = alpha_of(style)
    width, outline = style.get("linewidth"), style.get("edgecolor")
    if outline is None and not width:
        return Fill(inside, alpha)
    edge = stroke_of({**style, "color": outline or inside}, inside, width=1.0)
    return Fill(inside, alpha, edge)


def alpha_of(style: dict[str, Any]) -> float:
    """The opacity asked for, 0 to 1."""
    given = style.get("alpha")
    alpha = 1.0 if given is None else float(given)
    if not 0 <= alpha <= 1:
        raise SlamlibError(f"alpha is an opacity between 0 and 1, got {alpha:g}")
    return alpha


def positive(style: dict[str, Any], name: str, default: float) -> float:
    """A size in points, at least zero."""
    value = float(default if style.get(name) is None else style[name])
    if not (np.isfinite(value) and value >= 0):
        raise SlamlibError(f"{name} is a size in points, at least 0, got {value:g}")
    return value


def marker_of(style: dict[str, Any], color: str) -> Marker | None:
    """The marker that keywords (long names) ask for, or None; raises UnknownNameError."""
    name = style.get("marker")
    if name in (None, "", " ", "none", "None"):
        return None
    if name not in MARKERS:
        raise UnknownNameError.of("marker", name, MARKERS)
    edge, face = (color_named(style.get(k) or color) for k in ("markeredgecolor", "markerfacecolor"))
    size, width = positive(style, "markersize", 6.0), positive(style, "markeredgewidth", 1.0)
    alpha = alpha_of(style)
    return Marker(MARKERS[name], Fill(face, alpha, Stroke(edge, width, alpha=alpha)), size)


def lettering_of(style: dict[str, Any]) -> Lettering:
    """The style of words that keywords (long names) ask for; raises UnknownNameError."""
    for name, sides in SIDES.items():
        if style.get(name, sides[0]) not in sides:
            raise UnknownNameError.of(name, style[name], sides)
    rotation = style.get("rotation") or 0.0
    return Lettering(
        positive(style, "fontsize", 11.0),
        color_named(style.get("color") or colors.text),
        style.get("ha", "left"),
        style.get("va", "baseline"),
        TURNS[rotation] if rotation in TURNS else float(rotation),
    )
