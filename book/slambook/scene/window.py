"""The two figures in matplotlib, in a window or for a film: the page's `draw` puts the layers into its axes.

A `Window` shows a run while it goes on, step by step. What stays (axes, names, keys) is drawn once, and each frame over
a copy of that. matplotlib is imported when a window is made: it is an extra.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slambook.scene.figures import view_of
from slambook.scene.image_scene import sensor_view
from slambook.scene.options import MapOptions, SensorOptions
from slambook.scene.parts import Part, SensorPart, extra
from slambook.scene.roles import MAP, themed
from slambook.scene.scene import bounds, map_scene
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.plain_data.fields import read
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

MAP_BESIDE, MAP_ALONE, SENSORS = (0.01, 0.02, 0.58, 0.86), (0.01, 0.02, 0.98, 0.86), (0.645, 0.02, 0.345, 0.86)
GAP = 0.025
WINDOWLESS = ("agg", "cairo", "pdf", "pgf", "ps", "svg", "template")  # backends of matplotlib
MOVES = {  # keys that move the viewer: degrees of azimuth and elevation, and the factor of the distance
    "shift+left": (-5.0, 0.0, 1.0),
    "shift+right": (5.0, 0.0, 1.0),
    "shift+up": (0.0, 5.0, 1.0),
    "shift+down": (0.0, -5.0, 1.0),
    "+": (0.0, 0.0, 0.8),
    "-": (0.0, 0.0, 1.25),
}


class Window:
    """The map and the sensors of a run, as a window or as pictures for a video.

    sensors: which are shown beside the map, by index or name; by default the first three. size [in]. show: open
    a window, else pictures are made unseen. corners: limits as `slambook.scene.scene.bounds` gives them, to keep them;
    without them and without a world the limits grow with the map. coming: the snapshots that will be shown, if they are
    known: room for what they need is left from the start.
    Keys in the window: shift and an arrow turn the map, + and - zoom; matplotlib's own tools shift and magnify each
    part. The other keywords are those of MapOptions; sensor_options is a SensorOptions. Raises SlamlibError if
    matplotlib is missing, or cannot open a window that is asked for.
    """

    def __init__(
        self,
        snapshot: Snapshot,
        *,
        world: World | None = None,
        sensors: Sequence[int | str] | None = None,
        size: tuple[float, float] = (12.8, 7.2),
        dpi: float = 100,
        theme: str = "light",
        show: bool = False,
        sensor_options: SensorOptions | None = None,
        corners: Array | None = None,
        coming: Sequence[Snapshot] = (),
        **options: Any,
    ) -> None:
        self.options = read(MapOptions, options)
        self.sensor_options = sensor_options or SensorOptions()
        self.world, self.corners = world, corners
        self.sensors = tuple(range(min(len(snapshot.sensors), 3)) if sensors is None else sensors)
        self.path: list[Snapshot] = []
        self.true_path: list[Truth] = []
        self.moved = np.array([0.0, 0.0, 1.0])
        self.largest: Array | None = None
        self.empty: Any = None  # the canvas without what changes
        with extra("matplotlib.style", "a picture").context("default"):  # whatever style the reader's figures have
            self.figure = self._figure(size, dpi, show)
            self.figure.set_facecolor(themed(colors.paper, theme))
            self._make_axes(snapshot, theme)
            for part in self.views:
                part.room(coming)
            self.figure.canvas.mpl_connect("draw_event", self._drawn)
            self.figure.canvas.mpl_connect("key_press_event", self._key)
            self.figure.canvas.draw()

    def _figure(self, size: tuple[float, float], dpi: float, show: bool) -> Any:
        if show:
            plot = extra("matplotlib.pyplot", "a window")
            try:
                if plot.get_backend().lower() in WINDOWLESS:
                    raise ImportError(f"its backend is {plot.get_backend()}")
                figure = plot.figure(figsize=size, dpi=dpi, layout="none")  # the parts have their places
            except Exception as error:  # each toolkit has its own for a display that is not there
                raise SlamlibError(
                    f"matplotlib opens no window here ({error}): it needs a screen, and Tk or Qt; or leave show out "
                    "(of the command, --live) and save the pictures"
                ) from None
            figure.stale_callback = None  # each frame is drawn here, once
            plot.show(block=False)
            return figure
        figure = extra("matplotlib.figure", "a picture").Figure(figsize=size, dpi=dpi, layout="none")
        extra("matplotlib.backends.backend_agg", "a picture").FigureCanvasAgg(figure)
        return figure

    def _make_axes(self, snapshot: Snapshot, theme: str) -> None:
        place = MAP_BESIDE if self.sensors else MAP_ALONE
        self.map = Part(self.figure, place, theme, MAP, self.options.legend)
        across, up = self.figure.get_size_inches() * place[2:]
        self.aspect = float(across / up)
        self.map.axes.set_axis_off()
        self.map.axes.set(xlim=(-self.aspect, self.aspect), ylim=(-1, 1))
        left, bottom, width, height = SENSORS
        each, self.views = height / max(len(self.sensors), 1), list[SensorPart]()
        for i, sensor in enumerate(self.sensors):
            place = left, bottom + height - (i + 1) * each + GAP, width, each - 2 * GAP
            shown = self.sensor_options if i == 0 else replace(self.sensor_options, legend=False)
            self.views.append(SensorPart(self.figure, place, sensor, sensor_view(snapshot, sensor), shown, theme))

    def update(self, snapshot: Snapshot, truth: Truth | None = None) -> None:
        """Show the next snapshot, and if there is one the truth; the robots' paths grow by them."""
        # a path is of robots alone: a long run has more images than the memory holds
        self.path[-1:] = [replace(past, sensors=(), landmarks={}) for past in self.path[-1:]]
        self.path.append(snapshot)
        self.true_path += [truth] if truth is not None else []
        self._draw_map()
        if any([part.update(snapshot) for part in self.views]):
            self.empty = None
        self._show()

    def _show(self) -> None:
        """Draw what has changed: the rest of the canvas is taken from the time before."""
        canvas = self.figure.canvas
        if self.empty is None:
            canvas.draw()
        else:
            canvas.restore_region(self.empty)
            for part in (self.map, *self.views):
                part.draw()
        canvas.blit(self.figure.bbox)
        canvas.flush_events()

    def _drawn(self, event: Any) -> None:
        """The canvas has been drawn without what changes: keep that, and add the rest. A file has all at once."""
        if self.figure.canvas.is_saving():
            return
        self.empty = self.figure.canvas.copy_from_bbox(self.figure.bbox)
        for part in (self.map, *self.views):
            part.draw()

    def _draw_map(self) -> None:
        snapshot, truth = self.path[-1], self.true_path[-1] if self.true_path else None
        corners = self.corners
        if corners is None:  # of what there is; they never shrink: the picture of a map that grows stays calm
            now = bounds(snapshot, self.world, truth, self.path, self.options)
            before = now if self.largest is None else self.largest
            corners = self.largest = np.stack([np.minimum(now[0], before[0]), np.maximum(now[1], before[1])])
        shown: dict[str, Any] = {"world": self.world, "truth": truth, "path": self.path, "true_path": self.true_path}
        layers = map_scene(snapshot, **shown, options=self.options, corners=corners)
        view = view_of(self.options, snapshot, corners, self.aspect).moved(*self.moved)
        self.map.put(view.flat(layers))

    def _key(self, event: Any) -> None:
        """Move the viewer."""
        if event.key in MOVES and self.path:
            azimuth, elevation, factor = MOVES[event.key]
            self.moved = np.array([self.moved[0] + azimuth, self.moved[1] + elevation, self.moved[2] * factor])
            self._draw_map()
            self._show()

    def wait(self) -> None:
        """Wait for a key or a mouse button, to view a run step by step in a window that is shown."""
        self.figure.waitforbuttonpress(0)

    def pixels(self) -> Array:
        """The picture (rows, columns, 3) as it is now, 0 to 255."""
        return np.asarray(self.figure.canvas.buffer_rgba())[..., :3].copy()

    def save(self, path: Any) -> None:
        """Write the picture as it is now; the suffix gives the format (png, pdf, svg)."""
        self.figure.savefig(path, facecolor=self.figure.get_facecolor())
