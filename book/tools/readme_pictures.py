"""Make the pictures of the README and the landing page: chapter slam_in_five_minutes's two laps as an animated GIF,
and an exercise solved in the page.

`python -m book.tools.readme_pictures`; needs a built book.
"""

import contextlib
import io
import json
import os
import sys
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from book.tools import browser, layout

STATIC = layout.BOOK / "_static"
WRONG = """import numpy as np

from slambook.exercises import check


def average_nees(errors, covariances):
    inverse = np.linalg.inv(covariances[0, 0])
    return ((errors @ inverse) * errors).sum(-1).mean(0)


check("consistency.2", average_nees)"""


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


def of_the_exercise(executable: str) -> None:
    """Exercise consistency.2 with a wrong solution, and what the check says of it; narrow, to be read on a phone."""
    with browser.site_in_chromium(executable) as (base, chromium):
        page = chromium.new_page(viewport={"width": 450, "height": 1000}, device_scale_factor=2)
        page.goto(f"{base}/book/chapters/consistency.html")
        page.wait_for_function("() => window.Live && Live.page")
        cell = page.locator("div.cell.tag_exercise", has_text="average_nees")
        area = cell.locator("textarea")
        area.press("Control+a")
        page.keyboard.insert_text(WRONG)
        cell.evaluate("e => { delete e.dataset.ran; }")
        area.press("Shift+Enter")
        page.wait_for_function("e => e.dataset.ran", arg=cell.element_handle(), timeout=60_000)
        page.evaluate("() => { Live.page.panel.hidden = true; document.activeElement.blur(); }")
        layout.write_whole(STATIC / "exercise.png", cell.screenshot())


def main() -> int:
    """Write them."""
    executable = browser.browser_path()
    if executable is None:
        print("no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER", file=sys.stderr)
        return browser.SKIPPED
    of_the_map()
    of_the_exercise(executable)
    return 0


if __name__ == "__main__":
    sys.exit(main())
