"""What the command `slamlib` draws with: the entry point of the group `slamlib.drawing` in pyproject.toml."""

from collections.abc import Iterable

from slambook.scene import error_plot, map_file
from slambook.scene.video import animate, ready
from slambook.scene.window import Window
from slamlib.cli import drawing
from slamlib.data.records import Truth, World
from slamlib.data.snapshots import Snapshot


class BookDrawing(drawing.Drawing):
    """The book's maps, plots, films and windows."""

    def check_map(self, path: str) -> None:
        """Raise SlamlibError for an ending of no format."""
        map_file.check(path)

    def write_map(self, path: str, snapshot: Snapshot) -> None:
        """Write .ply, .json or .csv."""
        map_file.write(path, snapshot)

    def check_plot(self, path: str) -> None:
        """Raise SlamlibError for an ending of no format, and without matplotlib."""
        error_plot.check(path)

    def write_plot(self, path: str, series: drawing.ErrorSeries) -> None:
        """Draw .svg, .png or .pdf."""
        error_plot.write(path, series)

    def check_video(self, path: str, *, overwrite: bool) -> None:
        """Raise SlamlibError for an ending of no format, what exists, and a missing package."""
        ready(path, overwrite=overwrite)

    def write_video(
        self,
        path: str,
        snapshots: Iterable[Snapshot],
        *,
        truths: Iterable[Truth],
        world: World | None,
        fps: float,
        overwrite: bool,
    ) -> None:
        """Write .mp4, .webm, .gif, or a folder of pictures."""
        animate(snapshots, path, world=world, truths=truths, fps=fps, overwrite=overwrite)

    def open_window(self, snapshot: Snapshot, *, world: World | None) -> Window:
        """Open a window. Raises SlamlibError where matplotlib is missing or opens none."""
        return Window(snapshot, world=world, show=True)
