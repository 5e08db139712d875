"""What a camera delivered, as bytes that can be shown: whole, or small enough for a page; and patches of it."""

from dataclasses import dataclass

import numpy as np

from slambook.figures.images import png_uri
from slamlib.errors import ShapeError
from slamlib.manifolds import Array, Image
from slamlib.records.snapshots import MeasurementView, SensorView

LEVELS = 32  # of grey in a small picture: what is flat packs well, and no eye misses the rest
CELL = 28  # pixels across a patch in a strip
GAP = 2  # of them empty, between a patch and the next


@dataclass(frozen=True, eq=False)
class Photograph:
    """Grey bytes (rows, columns), and where their edges are in pixels of the camera: left, right, bottom, top."""

    pixels: Array
    extent: tuple[float, float, float, float]

    @property
    def uri(self) -> str:
        """The picture itself as an address."""
        return png_uri(self.pixels)


def grey(image: Image) -> Image:
    """An image (h, w) as bytes: integers as shares of the largest of their type, others of 1, or of 255 if above 1.

    Raises ShapeError for what is no grey image.
    """
    image = np.asarray(image)
    if image.ndim != 2 or not image.size:
        raise ShapeError(f"the image of a scan is grey, (rows, columns), not {image.shape}: average its colours")
    if image.dtype == np.uint8:
        return image
    whole = np.issubdtype(image.dtype, np.integer)
    values = np.nan_to_num(image.astype(float))
    full = np.iinfo(image.dtype).max if whole else 1.0 if values.max() <= 1 else 255.0
    found = np.rint(255 * (values / full).clip(0, 1)).astype(np.uint8)
    return found


def photograph(view: SensorView, width: int | None = None) -> Photograph | None:
    """What a sensor saw, whole, or in few greys and at most `width` pixels wide; None if it delivered no image."""
    if view.scan is None or view.scan.image is None:
        return None
    pixels, step = grey(view.scan.image), 1
    if width is not None:
        step = -(-pixels.shape[1] // width)
        down, across = max(pixels.shape[0] // step, 1), pixels.shape[1] // step  # what is left over is not shown
        means = pixels[: down * step, : across * step].reshape(down, -1, across, step).mean(axis=(1, 3))
        pixels = np.rint(np.rint(means * ((LEVELS - 1) / 255)) * (255 / (LEVELS - 1))).astype(np.uint8)
    rows, columns = step * np.array(pixels.shape)
    return Photograph(pixels, (-0.5, float(columns) - 0.5, float(rows) - 0.5, -0.5))


def patched(predictions: MeasurementView) -> list[int]:
    """The rows of the measurements that were matched and have a patch, predicted or found."""
    pairs = zip(predictions.matched.tolist(), predictions.predicted_patch, predictions.found_patch, strict=True)
    return [i for i, (m, p, f) in enumerate(pairs) if m and (p is not None or f is not None)]


def strip(predictions: MeasurementView, rows: list[int], count: int) -> Image:
    """The patches of some matches, one below the other, predicted beside found: (count CELL, 2 CELL, 4), 0 to 255.

    Both patches of a match share one scale from black to white, which shows a change of light. The rest is transparent.
    """
    sheet = np.zeros((count * CELL, 2 * CELL, 4), np.uint8)
    for place, row in enumerate(rows[:count]):
        pair = [predictions.predicted_patch[row], predictions.found_patch[row]]
        values = np.concatenate([np.ravel(patch) for patch in pair if patch is not None])
        low, high = float(np.nanmin(values)), float(np.nanmax(values))
        for side, patch in enumerate(pair):
            if patch is not None:
                share = (np.nan_to_num(np.asarray(patch, dtype=float), nan=low) - low) / ((high - low) or 1.0)
                cell = sheet[place * CELL :, side * CELL :][: CELL - GAP, : CELL - GAP]
                nearest = np.ix_(*(np.arange(CELL - GAP) * n // (CELL - GAP) for n in share.shape))
                cell[..., :3], cell[..., 3] = (255 * share)[nearest][..., None], 255
    return sheet
