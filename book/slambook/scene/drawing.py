"""What the command `slamlib` draws with: the entry point of the group `slamlib.drawing` in pyproject.toml.

A kernel tells its shell commands to draw as it does (MPLBACKEND), which they cannot: the variable is left out. Files
are drawn by Agg, whatever the backend is, and for a window matplotlib finds a backend that opens one here.
"""

import os

from slambook.scene.error_plot import check as check_plot
from slambook.scene.error_plot import write as write_plot
from slambook.scene.map_file import check as check_map
from slambook.scene.map_file import write as write_map
from slambook.scene.video import animate as write_video
from slambook.scene.video import ready as check_video
from slambook.scene.window import Window
from slamlib.records.inputs import World
from slamlib.records.snapshots import Snapshot

__all__ = ["check_map", "check_plot", "check_video", "open_window", "write_map", "write_plot", "write_video"]


os.environ.pop("MPLBACKEND", None)  # before matplotlib is imported, which refuses a name that it does not know


def open_window(snapshot: Snapshot, *, world: World | None) -> Window:
    """Open a window. Raises SlamlibError where matplotlib is missing or opens none."""
    return Window(snapshot, world=world, show=True)
