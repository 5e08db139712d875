"""Who draws for the command: a package that declares it, as an entry point of the group `slamlib.drawing`.

slamlib draws nothing itself, and knows no package that does. An entry point is a module with the functions
of the protocol `Drawing`; it is loaded only when a window or a drawn file is asked for.
"""

from collections.abc import Iterable, Mapping
from importlib.metadata import entry_points
from typing import Protocol

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

GROUP = "slamlib.drawing"
ErrorSeries = Mapping[str, Mapping[str, Array]]  # by name, a robot's or a path's: arrays (n,) of times [s] and errors


class RunWindow(Protocol):
    """A window that shows a run."""

    def update(self, snapshot: Snapshot, truth: Truth | None) -> None:
        """Show the next snapshot, and the truth if there is one."""


class Drawing(Protocol):
    """Maps, plots, films and windows; each method raises SlamlibError for what it cannot do."""

    def check_map(self, path: str) -> object:
        """Raise SlamlibError for a path to which no map can be written."""

    def write_map(self, path: str, snapshot: Snapshot) -> None:
        """Write the map of a snapshot, in the format of the path's ending."""

    def check_plot(self, path: str) -> None:
        """Raise SlamlibError for a path to which no plot can be written."""

    def write_plot(self, path: str, series: ErrorSeries) -> None:
        """Draw errors over time, in the format of the path's ending."""

    def check_video(self, path: str, *, overwrite: bool) -> object:
        """Raise SlamlibError for a path to which no film can be written."""

    def write_video(
        self,
        snapshots: Iterable[Snapshot],
        path: str,
        *,
        truths: Iterable[Truth],
        world: World | None,
        fps: float,
        overwrite: bool,
    ) -> object:
        """Write a film of snapshots, each drawn when it comes, with one truth each or none."""

    def open_window(self, snapshot: Snapshot, *, world: World | None) -> RunWindow:
        """Open a window with room for what this snapshot has."""


def drawing() -> Drawing:
    """What draws here. Raises SlamlibError if no installed package does."""
    found = sorted(entry_points(group=GROUP), key=lambda point: point.name)
    if not found:
        raise SlamlibError(
            f"no installed package draws (none has an entry point {GROUP!r}): slamlib's wheel has one, and a clone of "
            "its repository gets it by `make environment`, or by `pip install -e .`"
        )
    loaded: Drawing = found[0].load()
    return loaded
