"""What a sensor saw, in matplotlib: the photograph, what was expected and found over it, and a strip of patches."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slambook.scene.artists import Sheet
from slambook.scene.image_scene import sensor_scene, sensor_view
from slambook.scene.options import SensorOptions
from slambook.scene.photographs import patched, photograph, strip
from slambook.scene.roles import SENSOR, themed
from slamlib.data.snapshots import Looks, SensorView, Snapshot
from slamlib.manifolds import Image

Place = tuple[float, float, float, float]  # left, bottom, width, height, in shares of the figure
BESIDE = 0.17  # share of a sensor's place that the strip takes
ACROSS = 3.1  # widths of a patch that are in it: a number, the patch predicted, the one found
SPARE = 1.1  # of them above the first row, for the words


class SensorSheet(Sheet):
    """A sensor's part of a window. `stale`: whether what does not change in each frame must be drawn anew."""

    def __init__(
        self,
        figure: Any,
        place: Place,
        snapshot: Snapshot,
        sensor: int | str,
        options: SensorOptions,
        theme: str,
        legend: bool,
    ) -> None:
        self.figure, self.place, self.sensor, self.options, self.theme = figure, place, sensor, options, theme
        view, axes = sensor_view(snapshot, sensor), figure.add_axes(place)
        ink, faint = (themed(color, theme) for color in (colors.text, colors.faint))
        axes.patch.set_visible(False)
        axes.tick_params(colors=ink, labelsize=8)
        axes.spines[:].set_color(faint)
        axes.text(1, 1.01, view.name, fontsize=9, color=ink, ha="right", transform=axes.transAxes)
        self.photo: Any = None
        if view.image is not None:
            axes.set(xlim=(0, view.image[0]), ylim=(view.image[1], 0))
            look = {"cmap": "gray", "vmin": 0, "vmax": 255, "zorder": 1, "interpolation": "bilinear"}
            self.photo = axes.imshow(np.zeros((1, 1), np.uint8), aspect="equal", animated=True, visible=False, **look)
            axes.set_anchor("N")
        super().__init__(axes, SENSOR, theme, legend)
        self.strip: Strip | None = None
        self.lifted, self.stale = False, False

    def room(self, snapshots: Sequence[Snapshot]) -> None:
        """Make room at once for the patches that these snapshots bring, if they bring any."""
        for snapshot in snapshots if self.options.patches and self.strip is None else ():
            view = sensor_view(snapshot, self.sensor)
            if view.image is not None and any(patched(looks) for looks in (view.points, view.segments)):
                self._make_strip(view.image)
                return

    def show(self, snapshot: Snapshot) -> None:
        """Show another snapshot."""
        view = sensor_view(snapshot, self.sensor)
        self.stale = self._fit(view)
        self.room([snapshot])
        self._show_photo(view)
        self.update(sensor_scene(snapshot, self.sensor, options=self.options))
        if self.strip is not None:
            self.strip.update((view.points, view.segments))

    def draw(self) -> None:
        """Draw all on what the canvas shows now."""
        if self.photo is not None:
            self.axes.draw_artist(self.photo)
        super().draw()
        if self.strip is not None:
            self.strip.draw()

    def _show_photo(self, view: SensorView) -> None:
        photo = photograph(view) if self.options.image else None
        if self.photo is None:
            return
        self.photo.set_visible(photo is not None)
        if photo is None:
            return
        self.photo.set_data(photo.pixels)
        self.photo.set_extent(photo.extent)
        if not self.lifted:
            self.lifted = True
            for artists in self.artists.values():
                artists.lift()

    def _make_strip(self, image: Image) -> None:
        """Take the right part of the place for the strip, as high as the image will be beside it."""
        left, bottom, width, height = self.place
        self.axes.set_position((left, bottom, (1 - BESIDE) * width, height))
        self.axes.set_anchor("NE")
        across, up = self.figure.get_size_inches()
        high = min(height * up, (1 - BESIDE) * width * across * float(image[1] / image[0]))
        rows = max(1, int(high / (BESIDE * width * across / ACROSS) - SPARE))
        place = (left + (1 - BESIDE) * width, bottom, BESIDE * width, height)
        self.strip = Strip(self.figure, place, rows, themed(colors.text, self.theme))
        self.stale = True

    def _fit(self, view: SensorView) -> bool:
        """Of a sensor without an image, widen the limits to hold what it delivered and expected; True if so."""
        if view.image is not None:
            return False
        pair, axes, scanned = list(self.options.numbers), self.axes, np.zeros((0, 2))
        expected = view.points.expected[:, pair] if len(view.points.ids) else np.zeros((0, 2))
        if view.scan is not None and len(view.scan.points):
            scanned = view.scan.points.values[:, pair]
        points = np.concatenate([expected, scanned])
        box = np.array([axes.get_xlim(), axes.get_ylim()])
        if not len(points) or (np.all(points.min(0) >= box[:, 0]) and np.all(points.max(0) <= box[:, 1])):
            return False
        low, high = np.minimum(points.min(0), box[:, 0]), np.maximum(points.max(0), box[:, 1])
        spare = 0.1 * (high - low)
        axes.set(xlim=(low[0] - spare[0], high[0] + spare[0]), ylim=(low[1] - spare[1], high[1] + spare[1]))
        return True


class Strip:
    """Patches beside an image: of each matched landmark its number, what was looked for, and what was found."""

    def __init__(self, figure: Any, place: Place, rows: int, ink: str) -> None:
        self.rows, self.axes = rows, figure.add_axes(place)
        self.axes.set_axis_off()
        self.axes.set(xlim=(2 - ACROSS, 2), ylim=(rows, -SPARE))
        self.axes.set_aspect("equal", anchor="NW")
        look = {"fontsize": 6.5, "color": ink, "va": "center"}
        self.axes.text(1, -0.3, "sought, found", ha="center", **look)
        self.image = self.axes.imshow(
            np.zeros((1, 1, 4), np.uint8),
            extent=(0, 2, rows, 0),
            aspect="equal",
            interpolation="nearest",
            animated=True,
        )
        self.numbers = [self.axes.text(-0.1, i + 0.46, "", ha="right", animated=True, **look) for i in range(rows)]

    def update(self, both: Sequence[Looks]) -> None:
        """Show the patches of the matched looks at points, or if there are none at segments; as many as have room."""
        looks = next((looks for looks in both if patched(looks)), both[0])
        rows = patched(looks)
        self.image.set_data(strip(looks, rows, self.rows))
        words = [str(looks.ids[row]) for row in rows[: self.rows]]
        for text, word in zip(self.numbers, words + [""] * (self.rows - len(words)), strict=True):
            text.set_text(word)

    def draw(self) -> None:
        """Draw all on what the canvas shows now."""
        for artist in (self.image, *self.numbers):
            self.axes.draw_artist(artist)
