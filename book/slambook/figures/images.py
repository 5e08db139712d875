"""Pictures made of pixels, embedded as PNG."""

import base64
import struct
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from slambook.figures.canvas import Canvas
from slambook.figures.marks import Mark
from slambook.figures.paths import number
from slambook.figures.scales import DataView, Scale
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.manifolds import Array

_VIRIDIS = (0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E, 0x1F9E89, 0x35B779, 0x6ECE58, 0xB5DE2B, 0xFDE725)
# Colours from low to high, evenly spaced; "viridis" grows evenly in lightness, seen by each kind of colour blindness.
COLORMAPS = {
    "gray": ("#000000", "#ffffff"),
    "gray_r": ("#ffffff", "#000000"),
    "viridis": tuple(f"#{c:06x}" for c in _VIRIDIS),
}


def png(pixels: Any) -> bytes:
    """A PNG file of pixels (rows, columns) of grey or (rows, columns, 3 or 4) of colour, 0 to 255."""
    pixels = np.asarray(pixels, dtype=np.uint8)
    rows, columns, *channels = pixels.shape
    kind = {(): 0, (3,): 2, (4,): 6}[tuple(channels)]
    lines = pixels.reshape(rows, -1)
    # each row as its change: it packs well
    up = np.diff(lines, axis=0, prepend=np.zeros((1, lines.shape[1]), np.uint8))
    filtered = np.concatenate([np.full((rows, 1), 2, np.uint8), up], axis=1).tobytes()
    header = struct.pack(">IIBBBBB", columns, rows, 8, kind, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(filtered, 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks
    )


def png_uri(pixels: Any) -> str:
    """A PNG file of pixels, as an address that holds it."""
    return "data:image/png;base64," + base64.b64encode(png(pixels)).decode()


def colored(values: Array, cmap: str = "gray", vmin: float | None = None, vmax: float | None = None) -> Array:
    """Numbers (rows, columns) as grey or coloured pixels from vmin to vmax (default: all); nan is transparent.

    Raises UnknownNameError for a colour map.
    """
    if cmap not in COLORMAPS:
        raise UnknownNameError.of("cmap", cmap, COLORMAPS)
    finite = values[np.isfinite(values)]
    low = float(finite.min() if vmin is None else vmin) if finite.size or vmin is not None else 0.0
    high = float(finite.max() if vmax is None else vmax) if finite.size or vmax is not None else 1.0
    level = np.clip((np.nan_to_num(values) - low) / ((high - low) or 1.0), 0, 1)
    table = np.array([[int(c[i : i + 2], 16) for i in (1, 3, 5)] for c in COLORMAPS[cmap]], dtype=float)
    place = np.linspace(0, 1, len(table))
    rgb = np.stack([np.floor(np.interp(level, place, channel) + 0.5) for channel in table.T], axis=-1)
    if np.all(np.isfinite(values)):
        return (rgb[..., 0] if cmap.startswith("gray") else rgb).astype(np.uint8)
    return np.concatenate([rgb, 255.0 * np.isfinite(values)[..., None]], axis=-1).astype(np.uint8)


def pixels_of(array: Any, cmap: str, vmin: float | None, vmax: float | None) -> Array:
    """An image as bytes: numbers by a colour map; colours as bytes, or as shares of 0 to 1. Raises SlamlibError."""
    values = np.asarray(array)
    if values.ndim == 2 and values.size:
        return colored(np.asarray(values, dtype=float), cmap, vmin, vmax)
    if values.ndim != 3 or values.shape[2] not in (3, 4) or not values.size:
        raise SlamlibError(f"an image is (rows, columns) or (rows, columns, 3 or 4), not {values.shape}")
    if values.dtype == np.uint8:
        return values
    return np.floor(np.clip(values, 0, 1) * 255 + 0.5).astype(np.uint8)


@dataclass(kw_only=True, repr=False)
class Image(Mark):
    """Pixels over an extent (left, right, bottom, top) in data units; the first row is at the top, or at the origin."""

    pixels: Array
    extent: tuple[float, float, float, float]
    lower: bool = False
    smooth: bool = False
    alpha: float = 1.0
    zorder: float = 0.0

    def bounds(self, xscale: Scale, yscale: Scale) -> Array:
        return np.array([sorted(self.extent[:2]), sorted(self.extent[2:])])

    def draw(self, canvas: Canvas, view: DataView) -> None:
        (x0, x1), (y0, y1) = view.points(np.array(self.extent[:2]), np.array(self.extent[2:]))
        rows = self.pixels[::-1] if self.lower else self.pixels  # now the first row belongs to extent[3]
        rows = rows[::-1] if y1 > y0 else rows
        rows = rows[:, ::-1] if x1 < x0 else rows
        box = {"x": min(x0, x1), "y": min(y0, y1), "width": abs(x1 - x0), "height": abs(y1 - y0)}
        style = ("" if self.smooth else "image-rendering:pixelated") + (f";opacity:{self.alpha:g}" * (self.alpha < 1))
        place = {name: number(value) for name, value in box.items()}
        canvas.element("image", style.strip(";"), **place, preserveAspectRatio="none", href=png_uri(rows))
