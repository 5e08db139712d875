"""Draw the picture of the README from the run of chapter 0: python -m book.tools.readme_picture."""

import contextlib
import io
import json
import os
from typing import Any

import matplotlib as mpl

from book.tools import layout


def main() -> None:
    """Run the chapter's own cells up to its map, and save that map with a background of its own."""
    chapter = layout.BOOK / "chapters" / "00_slam_in_five_minutes.ipynb"
    names: dict[str, Any] = {"__name__": "__main__"}
    os.chdir(chapter.parent)
    for cell in json.loads(chapter.read_text("utf-8"))["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code":
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(source, "<chapter 0>", "exec"), names)
            if "def draw_state" in source:
                break
    figure = names["draw_state"](len(names["history"]) - 1)
    with mpl.rc_context({"svg.hashsalt": "slamlib"}):
        figure.savefig(layout.BOOK / "_static" / "readme.svg", facecolor="white", metadata={"Date": None})


if __name__ == "__main__":
    main()
