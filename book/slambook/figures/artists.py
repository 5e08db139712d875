"""The artists of matplotlib's axes as calls of the renderer's: lines, collections, patches, images, words."""

from functools import lru_cache, singledispatch
from itertools import chain
from typing import Any

import numpy as np
from matplotlib import collections, contour, image, lines, patches, text
from matplotlib.cbook import STEP_LOOKUP_MAP
from matplotlib.container import BarContainer
from matplotlib.markers import MarkerStyle

from slambook.figures.axes import Axes
from slambook.figures.markers import MARKERS
from slambook.figures.reading import (
    CannotReplayError,
    alike,
    base,
    color_of,
    must_be_data,
    pieces_of,
    place_of,
    strokes,
    turn,
)
from slambook.figures.shapes import areas, image_pixels, patch, patch_style, polygons


def put_all(ax: Any, target: Axes) -> None:
    """Every artist, in the order in which it came; the bars of one call together."""
    bars = {id(bar): c.patches for c in ax.containers if isinstance(c, BarContainer) for bar in c.patches}
    known = {id(a) for kind in (ax.lines, ax.patches, ax.collections, ax.images, ax.texts) for a in kind}
    for artist in ax.get_children():
        if id(artist) not in known or not artist.get_visible():
            continue
        if id(artist) in bars:
            if artist is bars[id(artist)][0]:
                areas(bars[id(artist)], ax, target)
            continue
        put(artist, ax, target)


@singledispatch
def put(artist: Any, ax: Any, target: Axes) -> None:
    """One artist; raises CannotReplayError for a kind that the renderer does not draw."""
    raise CannotReplayError(f"the renderer does not draw {type(artist).__name__}")


put.register(patches.Patch, patch)
put.register(collections.PolyCollection, polygons)
put.register(image.AxesImage, image_pixels)


# -- lines -------------------------------------------------------------------------------------------------------------


def _line_style(line: Any) -> dict[str, Any]:
    color, alpha = color_of(line.get_color(), line.get_alpha())
    marker = line.get_marker()
    return {
        "color": color,
        "alpha": alpha,
        "lw": line.get_linewidth(),
        "ls": line.get_linestyle(),
        "marker": None if marker in ("", " ", "none", "None", None) else marker,
        "ms": line.get_markersize(),
        "mew": line.get_markeredgewidth(),
        "mfc": color_of(line.get_markerfacecolor())[0],
        "mec": color_of(line.get_markeredgecolor())[0],
    }


@put.register(lines.Line2D)
def _line(line: Any, ax: Any, target: Axes) -> None:
    x, y = (np.ma.filled(v, np.nan).astype(float) for v in line.get_data(orig=False))
    place, style = place_of(line.get_transform(), ax), {**_line_style(line), **base(line)}
    if line.get_markevery() is not None:
        raise CannotReplayError("marks at some of the vertices")
    if place == "data":
        x, y = STEP_LOOKUP_MAP[line.get_drawstyle()](x, y) if len(x) else (x, y)
        target.plot(x, y, **style)
        return
    rule, (across, along) = (target.axvline, (x, y)) if place == "x data" else (target.axhline, (y, x))
    if place == "axes fraction" or len(x) != 2 or across[0] != across[1] or style["marker"]:
        raise CannotReplayError("a line is placed by shares of the axes")
    plain = {name: style[name] for name in ("color", "alpha", "lw", "ls", "zorder", "clip_on")}
    rule(across[0], *along, **plain)


@put.register(collections.LineCollection)
def _segments(artist: Any, ax: Any, target: Axes) -> None:
    """A LineCollection, or contour lines: what looks alike is one line with gaps."""
    must_be_data(artist.get_transform(), ax)
    parts = [pieces_of(path, ax) for path in artist.get_paths()]
    levels = isinstance(artist, contour.ContourSet)  # each a line of its own
    styles = [(i * levels, *style) for i, style in enumerate(strokes(artist, len(parts)))]
    for (_, color, alpha, width, dashes), curves in alike(styles, parts).items():
        line = np.concatenate([np.empty((2, 0)), *chain.from_iterable(curves)], axis=1)
        target.plot(*line, color=color, alpha=alpha, lw=width, ls=dashes, **base(artist))


@lru_cache(maxsize=1)
def _marker_shapes() -> list[tuple[str, Any]]:
    styles = map(MarkerStyle, MARKERS)
    return [(n, m.get_path().transformed(m.get_transform()).vertices) for n, m in zip(MARKERS, styles, strict=True)]


def _scatter_styles(artist: Any) -> tuple[str, list[tuple[Any, ...]]]:
    """The marker, and for each point size, width of the edge, colours of edge and face, opacity."""
    artist.update_scalarmappable()
    shape = artist.get_paths()[0].vertices if len(artist.get_paths()) == 1 else np.empty((0, 2))
    marker = next(
        (n for n, known in _marker_shapes() if known.shape == shape.shape and np.allclose(known, shape)), None
    )
    if marker is None:
        raise CannotReplayError("a marker without a name")
    styles = []
    for i in range(max(len(artist.get_offsets()), 1)):
        edge, alpha = color_of(turn(artist.get_edgecolor(), i))
        face, inside = color_of(turn(artist.get_facecolor(), i))
        size, width = float(turn(artist.get_sizes(), i)) ** 0.5, float(turn(artist.get_linewidth(), i))
        styles.append((size, width, edge, face, inside if edge == "none" else alpha))
    return marker, styles


@put.register(collections.PathCollection)
def _scatter(artist: Any, ax: Any, target: Axes) -> None:
    must_be_data(artist.get_offset_transform(), ax)
    marker, styles = _scatter_styles(artist)
    offsets = np.ma.filled(artist.get_offsets().astype(float), np.nan)
    for style, some in alike(styles[: len(offsets)], offsets).items():
        target.plot(*np.array(some).T, **_mark_style(marker, style), **base(artist))


def _mark_style(marker: str, style: tuple[Any, ...]) -> dict[str, Any]:
    size, width, edge, face, alpha = style
    return {"ls": "", "marker": marker, "ms": size, "mew": width, "mec": edge, "mfc": face, "alpha": alpha}


@put.register(contour.ContourSet)
def _contours(artist: Any, ax: Any, target: Axes) -> None:
    (polygons if artist.filled else _segments)(artist, ax, target)


# -- words and samples -------------------------------------------------------------------------------------------------


@put.register(text.Text)
def _words(words: Any, ax: Any, target: Axes) -> None:
    style: dict[str, Any] = {
        "color": color_of(words.get_color())[0],
        "fontsize": words.get_fontsize(),
        "ha": words.get_ha(),
        "va": words.get_va().replace("center_baseline", "center"),
        "rotation": words.get_rotation(),
        "zorder": words.get_zorder(),
        "clip_on": words.get_clip_on() and words.get_clip_path() is not None,
    }
    if isinstance(words, text.Annotation):
        style |= {"xycoords": words.xycoords, "textcoords": words.anncoords, "arrowprops": words.arrowprops}
        target.annotate(words.get_text(), words.xy, words.xyann, **style)
    else:
        x, y = words.get_position()
        target.text(x, y, words.get_text(), transform=place_of(words.get_transform(), ax), **style)


def sample(handle: Any) -> Any:
    """A mark that looks like a sample in a legend."""
    scratch = Axes()
    if isinstance(handle, lines.Line2D):
        return scratch.plot([0], [0], **_line_style(handle))[0]
    if isinstance(handle, patches.Patch):
        return scratch.fill([0, 1], [0, 1], **patch_style(handle))
    if isinstance(handle, collections.LineCollection):
        color, alpha, width, dashes = strokes(handle, 1)[0]
        return scratch.plot([0], [0], color=color, alpha=alpha, lw=width, ls=dashes)[0]
    if isinstance(handle, collections.PathCollection):
        marker, styles = _scatter_styles(handle)
        return scratch.plot([0], [0], **_mark_style(marker, styles[len(styles) // 2]))[0]
    raise CannotReplayError(f"a legend with {type(handle).__name__}")
