"""matplotlib's patches, polygons, filled contours and images as calls of the renderer's."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib import contour, patches
from matplotlib.colors import Normalize

from slambook.figures.axes import Axes
from slambook.figures.images import COLORMAPS
from slambook.figures.reading import CannotReplayError, alike, base, color_of, must_be_data, pieces_of, place_of, turn
from slamlib.manifolds import Array


def _fill_style(face: Any, edge: Any, width: float) -> dict[str, Any]:
    """Of an area; an edge of the area's own colour is none."""
    (inside, alpha), (outline, _) = color_of(face), color_of(edge)
    edged = {"edgecolor": outline, "lw": width} if outline not in ("none", inside) and width > 0 else {}
    return {"facecolor": inside, "alpha": alpha, **edged}


def patch_style(patch: Any) -> dict[str, Any]:
    """How a patch is filled and edged."""
    return _fill_style(patch.get_facecolor(), patch.get_edgecolor(), patch.get_linewidth())


def _rings(paths: Iterable[Any], ax: Any) -> Array:
    """Closed lines (2, N) with gaps between them."""
    return np.concatenate([np.empty((2, 0)), *(piece for path in paths for piece in pieces_of(path, ax))], axis=1)


def areas(shapes: list[Any], ax: Any, target: Axes) -> None:
    """Patches, or the bars of one call: those that look alike are one area."""
    for patch in shapes:
        must_be_data(patch.get_data_transform(), ax)
    for style, some in alike((tuple(patch_style(patch).items()) for patch in shapes), shapes).items():
        x, y = _rings((p.get_path().transformed(p.get_patch_transform()) for p in some), ax)
        if dict(style)["facecolor"] == "none":
            edge, alpha = color_of(some[0].get_edgecolor())
            look = {"color": edge, "alpha": alpha, "lw": some[0].get_linewidth(), "ls": some[0].get_linestyle()}
            target.plot(x, y, **look, **base(some[0]))
        else:
            target.fill(x, y, **dict(style), **base(some[0]))


def patch(shape: Any, ax: Any, target: Axes) -> None:
    """A patch of its own, or a band across the axes."""
    if isinstance(shape, patches.FancyArrowPatch):
        raise CannotReplayError("an arrow of its own")
    place = place_of(shape.get_data_transform(), ax)
    if place == "data":
        areas([shape], ax, target)
        return
    if place == "axes fraction" or not isinstance(shape, patches.Rectangle):
        raise CannotReplayError("a shape is placed by shares of the axes")
    (x0, y0), (x1, y1) = shape.get_corners()[[0, 2]]
    low, high, reach = (x0, x1, (y0, y1)) if place == "x data" else (y0, y1, (x0, x1))
    span = (target.axvspan if place == "x data" else target.axhspan)(low, high, **patch_style(shape), **base(shape))
    span.reach = float(reach[0]), float(reach[1])


def polygons(artist: Any, ax: Any, target: Axes) -> None:
    """A PolyCollection, or filled contours."""
    must_be_data(artist.get_transform(), ax)
    for i, path in enumerate(artist.get_paths()):
        style = _fill_style(
            *(turn(v, i) for v in (artist.get_facecolor(), artist.get_edgecolor(), artist.get_linewidth()))
        )
        x, y = _rings([path], ax)
        target.fill(x, y, **style, **base(artist)).holes = isinstance(artist, contour.ContourSet)


def image_pixels(artist: Any, ax: Any, target: Axes) -> None:
    """An image; colour maps that the renderer has not are applied here."""
    must_be_data(artist.get_transform(), ax)
    array, norm, cmap = artist.get_array(), artist.norm, artist.get_cmap().name
    if array.ndim == 2 and cmap in COLORMAPS and type(norm) is Normalize:
        pixels, look = np.ma.filled(array.astype(float), np.nan), {"cmap": cmap, "vmin": norm.vmin, "vmax": norm.vmax}
    else:
        pixels, look = (array if array.ndim == 3 else artist.to_rgba(array, bytes=True)), {}
    kept = {"alpha": artist.get_alpha(), "interpolation": artist.get_interpolation()}
    target.imshow(pixels, extent=artist.get_extent(), origin=artist.origin, **look, **kept, **base(artist))
