"""Make the picture of the README: chapter slam_in_five_minutes's two laps as an animated GIF.

`python -m book.tools.readme_pictures`. The landing page shows the same run in a player.
"""

import contextlib
import io
import json
import os
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from book.tools import layout

STATIC = layout.BOOK / "_static"


def of_the_map() -> None:
    """Run chapter slam_in_five_minutes's own cells up to its map, and save the two laps as a film."""
    chapter = layout.BOOK / "chapters" / "slam_in_five_minutes.ipynb"
    names: dict[str, Any] = {"__name__": "__main__"}
    os.chdir(chapter.parent)
    for cell in json.loads(chapter.read_text("utf-8"))["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code":
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(source, "<chapter slam_in_five_minutes>", "exec"), names)
            if "def draw_state" in source:
                break
    last = len(names["history"]) - 1  # comes first, and is what paper shows
    pictures = [pixels(names["draw_state"](step)) for step in (last, *range(3, last, 4))]
    colors = pictures[0].quantize(32)
    first, *others = (picture.quantize(palette=colors, dither=Image.Dither.NONE) for picture in pictures)
    times = [3000] + [120] * len(others)  # [ms] of each
    film = io.BytesIO()
    first.save(film, "GIF", save_all=True, append_images=others, duration=times, loop=0, optimize=True)
    layout.write_whole(STATIC / "two_laps.gif", film.getvalue())


def pixels(fig: Any) -> Image.Image:
    """A matplotlib figure as an image, and closed."""
    fig.set_dpi(90)
    fig.canvas.draw()
    image = Image.fromarray(np.asarray(fig.canvas.buffer_rgba())).convert("RGB")
    plt.close(fig)
    return image


if __name__ == "__main__":
    of_the_map()
