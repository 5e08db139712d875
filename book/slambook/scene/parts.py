"""The parts of a window: axes of matplotlib into which the page's `draw` puts the layers of each frame anew."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slambook.scene.figures import draw
from slambook.scene.image_scene import delivered, sensor_scene, sensor_view
from slambook.scene.layers import Flat
from slambook.scene.options import SensorOptions
from slambook.scene.photographs import Photograph, patched, photograph, strip
from slambook.scene.roles import HALO, OUTLINE, SENSOR, Role, themed
from slamlib.errors import optional
from slamlib.records.snapshots import SensorView, Snapshot

Box = tuple[float, float, float, float]  # left, bottom, width, height, in shares of the figure
ABOVE = 0.025  # of the figure's height: from the top of axes to their key
STRIP = 0.17  # share of a sensor's place that the strip of patches takes
ACROSS = 3.1  # widths of a patch that are in it: a number, the patch predicted, the one found
SPARE = 1.1  # of them above the first row, for the words


def extra(module: str, purpose: str) -> Any:
    """A module of the extra `draw`; raises SlamlibError that says how to get it."""
    return optional(module, f"for {purpose}", "draw")


class Part:
    """Axes of a window whose contents are drawn anew with each frame, over what stays."""

    def __init__(self, figure: Any, place: Box, theme: str, roles: dict[str, Role], legend: bool = False) -> None:
        self.figure, self.place, self.theme, self.axes = figure, place, theme, figure.add_axes(place)
        self.ink = themed(colors.text, theme)
        self.roles = {name: replace(role, color=themed(role.color, theme), label="") for name, role in roles.items()}
        self.outline = [extra("matplotlib.patheffects", "a window").withStroke(linewidth=2 * HALO, foreground=OUTLINE)]
        self.artists: list[Any] = []
        if not legend:
            return
        # the key of all roles, whether a frame shows them or not: it never changes
        labelled = {n: replace(self.roles[n], label=role.label) for n, role in roles.items() if role.label}
        lined, nowhere = [n for n, role in labelled.items() if role.marker in ("", ".")], np.full((1, 2), np.nan)
        samples = [Flat(n, lines=nowhere) if n in lined else Flat(n, marks=nowhere) for n in labelled]
        self.show(lambda axes: draw(axes, samples, labelled))
        corner = {"bbox_to_anchor": (place[0], place[1] + place[3] + ABOVE), "loc": "lower left"}
        look = {"labelcolor": self.ink, "ncols": 4, "fontsize": 8, "frameon": False}
        self.axes.legend(bbox_transform=figure.transFigure, **corner, **look)

    def show(self, put: Callable[[Any], None]) -> None:
        """Show what `put` puts into the axes, and nothing of the frame before."""
        for artist in self.artists:
            artist.remove()
        put(self.axes)
        self.artists = [*self.axes.images, *self.axes.lines, *self.axes.texts]
        for artist in self.artists:
            artist.set_animated(True)  # it is no part of what stays

    def put(self, layers: Sequence[Flat], photo: Photograph | None = None) -> None:
        """Show these layers."""
        words: dict[str, Any] = {"annotation_clip": False, "clip_box": self.axes.bbox}  # sooner than one box each
        if photo is not None:
            words["path_effects"] = self.outline
        self.show(lambda axes: draw(axes, layers, self.roles, photo, words))

    def draw(self) -> None:
        """Draw the contents on what the canvas shows now."""
        renderer = self.figure.canvas.get_renderer()
        for artist in self.artists:
            artist.draw(renderer)


class SensorPart(Part):
    """What a sensor saw, and beside its image the patches: of each match the predicted one and the one found."""

    def __init__(
        self, figure: Any, place: Box, sensor: int | str, shown: SensorView, options: SensorOptions, theme: str
    ) -> None:
        super().__init__(figure, place, theme, SENSOR, options.legend)
        self.sensor, self.options, self.rows = sensor, options, 0
        self.patches: Part | None = None
        self.axes.patch.set_visible(False)
        self.axes.tick_params(colors=self.ink, labelsize=8)
        self.axes.spines[:].set_color(themed(colors.faint, theme))
        self.axes.set_title(shown.name, fontsize=9, color=self.ink, loc="right", pad=2)
        if shown.image is not None:
            self.axes.set(xlim=(0, shown.image[0]), ylim=(shown.image[1], 0), aspect="equal", anchor="N")

    def update(self, snapshot: Snapshot) -> bool:
        """Show another snapshot; True if what stays has changed: limits, or the room for patches."""
        view = sensor_view(snapshot, self.sensor)
        changed = self._fit(view) | self.room([snapshot])
        photo = photograph(view) if self.options.image and view.image is not None else None
        self.put(sensor_scene(snapshot, self.sensor, options=self.options), photo)
        if self.patches is not None:
            self.patches.show(lambda axes: self._put_patches(axes, view))
        return changed

    def draw(self) -> None:
        """Draw the contents on what the canvas shows now."""
        super().draw()
        if self.patches is not None:
            self.patches.draw()

    def room(self, snapshots: Sequence[Snapshot]) -> bool:
        """Make room for the patches that these snapshots bring, the first time that they bring any; True if so."""
        for snapshot in snapshots if self.options.patches and self.patches is None else ():
            view = sensor_view(snapshot, self.sensor)
            if view.image is not None and any(patched(predictions) for predictions in (view.points, view.segments)):
                self._make_room(float(view.image[1] / view.image[0]))
                return True
        return False

    def _make_room(self, shape: float) -> None:
        """Take the right part of the place for the patches, as high as an image of this height / width beside it."""
        left, bottom, width, height = self.place
        self.axes.set_position((left, bottom, (1 - STRIP) * width, height))
        self.axes.set_anchor("NE")
        across, up = self.figure.get_size_inches()
        high = min(height * up, (1 - STRIP) * width * across * shape)
        self.rows = max(1, int(high / (STRIP * width * across / ACROSS) - SPARE))
        self.patches = Part(self.figure, (left + (1 - STRIP) * width, bottom, STRIP * width, height), self.theme, {})
        self.patches.axes.set_axis_off()
        self.patches.axes.set(xlim=(2 - ACROSS, 2), ylim=(self.rows, -SPARE), aspect="equal", anchor="NW")

    def _put_patches(self, axes: Any, view: SensorView) -> None:
        """Those of the matched points, or if there are none of the matched segments; as many as have room."""
        predictions = view.points if patched(view.points) else view.segments
        rows = patched(predictions)
        axes.imshow(strip(predictions, rows, self.rows), extent=(0, 2, self.rows, 0), interpolation="nearest")
        prediction = {"fontsize": 6.5, "color": self.ink, "va": "center"}
        axes.text(1, -0.3, "sought, found", ha="center", **prediction)
        for i, row in enumerate(rows[: self.rows]):
            axes.text(-0.1, i + 0.46, str(predictions.ids[row]), ha="right", **prediction)

    def _fit(self, view: SensorView) -> bool:
        """Of a sensor without an image, widen the limits to hold what was delivered and predicted; True if so."""
        if view.image is not None:
            return False
        points, axes = delivered([view], list(self.options.numbers)), self.axes
        box = np.array([axes.get_xlim(), axes.get_ylim()])
        if not len(points) or (np.all(points.min(0) >= box[:, 0]) and np.all(points.max(0) <= box[:, 1])):
            return False
        low, high = np.minimum(points.min(0), box[:, 0]), np.maximum(points.max(0), box[:, 1])
        spare = 0.1 * (high - low)
        axes.set(xlim=(low[0] - spare[0], high[0] + spare[0]), ylim=(low[1] - spare[1], high[1] + spare[1]))
        return True
