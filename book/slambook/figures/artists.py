"""The artists of matplotlib's axes as calls of the renderer's: lines, collections, patches, images, words."""

from collections.abc import Iterable
from functools import lru_cache, singledispatch
from itertools import chain
from typing import Any

import numpy as np
from matplotlib import collections, contour, image, lines, patches, quiver, text
from matplotlib.cbook import STEP_LOOKUP_MAP
from matplotlib.colors import Normalize
from matplotlib.container import BarContainer
from matplotlib.markers import MarkerStyle

from slambook.figures.axes import Axes
from slambook.figures.images import COLORMAPS
from slambook.figures.markers import MARKERS
from slambook.figures.reading import (
    CannotReplayError,
    alike,
    base,
    color_of,
    fill_style,
    must_be_data,
    pieces_of,
    place_of,
    strokes,
    turn,
)
from slamlib.manifolds import Array


def put_all(ax: Any, target: Axes) -> None:
    """Every artist, in the order in which it came; the bars of one call together."""
    bars = {id(bar): c.patches for c in ax.containers if isinstance(c, BarContainer) for bar in c.patches}
    known = {id(a) for kind in (ax.lines, ax.patches, ax.collections, ax.images, ax.texts) for a in kind}
    for artist in ax.get_children():
        if id(artist) not in known or not artist.get_visible():
            continue
        if id(artist) in bars:
            if artist is bars[id(artist)][0]:
                _areas(bars[id(artist)], ax, target)
            continue
        put(artist, ax, target)


@singledispatch
def put(artist: Any, ax: Any, target: Axes) -> None:
    """One artist; raises CannotReplayError for a kind that the renderer does not draw."""
    raise CannotReplayError(f"the renderer does not draw {type(artist).__name__}")


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
    plain = {name: style[name] for name in ("color", "alpha", "lw", "ls", "zorder", "clip_on", "gid")}
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


# -- areas and images -------------------------------------------------------------------------------------------------


def _patch_style(patch: Any) -> dict[str, Any]:
    """How a patch is filled and edged."""
    return fill_style(patch.get_facecolor(), patch.get_edgecolor(), patch.get_linewidth())


def _rings(paths: Iterable[Any], ax: Any) -> Array:
    """Closed lines (2, N) with gaps between them."""
    return np.concatenate([np.empty((2, 0)), *(piece for path in paths for piece in pieces_of(path, ax))], axis=1)


def _areas(shapes: list[Any], ax: Any, target: Axes) -> None:
    """Patches, or the bars of one call: those that look alike are one area."""
    for patch in shapes:
        must_be_data(patch.get_data_transform(), ax)
    for style, some in alike((tuple(_patch_style(patch).items()) for patch in shapes), shapes).items():
        x, y = _rings((p.get_path().transformed(p.get_patch_transform()) for p in some), ax)
        if dict(style)["facecolor"] == "none":
            edge, alpha = color_of(some[0].get_edgecolor())
            look = {"color": edge, "alpha": alpha, "lw": some[0].get_linewidth(), "ls": some[0].get_linestyle()}
            target.plot(x, y, **look, **base(some[0]))
        else:
            target.fill(x, y, **dict(style), **base(some[0]))


@put.register(patches.Patch)
def _patch(shape: Any, ax: Any, target: Axes) -> None:
    """A patch of its own, or a band across the axes."""
    if isinstance(shape, patches.FancyArrowPatch):
        raise CannotReplayError("an arrow of its own")
    place = place_of(shape.get_data_transform(), ax)
    if place == "data":
        _areas([shape], ax, target)
        return
    if place == "axes fraction" or not isinstance(shape, patches.Rectangle):
        raise CannotReplayError("a shape is placed by shares of the axes")
    (x0, y0), (x1, y1) = shape.get_corners()[[0, 2]]
    low, high, reach = (x0, x1, (y0, y1)) if place == "x data" else (y0, y1, (x0, x1))
    span = (target.axvspan if place == "x data" else target.axhspan)(low, high, **_patch_style(shape), **base(shape))
    span.reach = float(reach[0]), float(reach[1])


@put.register(collections.PolyCollection)
def _polygons(artist: Any, ax: Any, target: Axes) -> None:
    """A PolyCollection, or filled contours."""
    must_be_data(artist.get_transform(), ax)
    for i, path in enumerate(artist.get_paths()):
        style = fill_style(
            *(turn(v, i) for v in (artist.get_facecolor(), artist.get_edgecolor(), artist.get_linewidth()))
        )
        x, y = _rings([path], ax)
        target.fill(x, y, **style, **base(artist)).holes = isinstance(artist, contour.ContourSet)


@put.register(image.AxesImage)
def _pixels(artist: Any, ax: Any, target: Axes) -> None:
    """An image; colour maps that the renderer has not are applied here."""
    must_be_data(artist.get_transform(), ax)
    array, norm, cmap = artist.get_array(), artist.norm, artist.get_cmap().name
    if array.ndim == 2 and cmap in COLORMAPS and type(norm) is Normalize:
        pixels, look = np.ma.filled(array.astype(float), np.nan), {"cmap": cmap, "vmin": norm.vmin, "vmax": norm.vmax}
    else:
        pixels, look = (array if array.ndim == 3 else artist.to_rgba(array, bytes=True)), {}
    kept = {"alpha": artist.get_alpha(), "interpolation": artist.get_interpolation()}
    target.imshow(pixels, extent=artist.get_extent(), origin=artist.origin, **look, **kept, **base(artist))


@put.register(quiver.Quiver)
def _arrows(artist: Any, ax: Any, target: Axes) -> None:
    """One arrow at each point, of the colour of all."""
    if (artist.angles, artist.scale_units) != ("xy", "xy") or len(artist.get_facecolor()) != 1:
        raise CannotReplayError("a quiver of many colours, or not in units of the axes: angles='xy', scale_units='xy'")
    style = {"arrowstyle": "-|>", "shrinkA": 0.0, "shrinkB": 0.0, "color": color_of(artist.get_facecolor()[0])[0]}
    change = np.stack([artist.U, artist.V], axis=-1) / (artist.scale or 1.0)
    for tail, tip in zip(artist.XY, artist.XY + change, strict=True):
        target.annotate("", tip, tail, arrowprops=style)


@put.register(contour.ContourSet)
def _contours(artist: Any, ax: Any, target: Axes) -> None:
    (_polygons if artist.filled else _segments)(artist, ax, target)


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
        "gid": words.get_gid(),
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
        return scratch.fill([0, 1], [0, 1], **_patch_style(handle))
    if isinstance(handle, collections.LineCollection):
        color, alpha, width, dashes = strokes(handle, 1)[0]
        return scratch.plot([0], [0], color=color, alpha=alpha, lw=width, ls=dashes)[0]
    if isinstance(handle, collections.PathCollection):
        marker, styles = _scatter_styles(handle)
        return scratch.plot([0], [0], **_mark_style(marker, styles[len(styles) // 2]))[0]
    raise CannotReplayError(f"a legend with {type(handle).__name__}")
