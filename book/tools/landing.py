"""Draw what builds on what: the landing page's figure of all chapters, made from what each says that it needs.

`python -m book.tools.landing` writes it as the file that book/index.ipynb includes; a test says when it is not current.
"""

import json
import re
import sys

import matplotlib.pyplot as plt
import numpy as np
from slambook.figures import colors
from slambook.figures.page import svg_of

from book.tools import layout

PAGE = layout.BOOK / "index.ipynb"
FIGURE = layout.BOOK / "_static" / "what_builds_on_what.html"
GOALS = re.compile(
    r"^# (?P<title>.+?)$.*?\*\*You need\*\*(?P<needs>.*?)"
    r"\*\*Time\*\*: (?:about )?(?P<time>[^:]+?)(?:, exercises apart)?\.\n:::",
    re.MULTILINE | re.DOTALL,
)
ALT = (
    "The chapters one below the other, in the order of the book, a colour for each part. Arcs on the left lead from a "
    "chapter down to those that build on it."
)


def chapters() -> dict[str, dict[str, str]]:
    """Of each chapter, by its name and in the order of the book: its title, what it needs, and its time."""
    found = {}
    for page in layout.pages():
        if page.parent == layout.BOOK / "chapters":
            cells = [c for c in json.loads(page.read_text("utf-8"))["cells"] if c["cell_type"] == "markdown"]
            box = next((i for i, c in enumerate(cells) if c["metadata"].get("part") == "goals"), 0)
            goals = GOALS.search("\n".join("".join(c["source"]) for c in cells[: box + 1]))
            assert goals is not None, f"{page.name}: its box does not say what the chapter needs, and how long it takes"
            found[page.stem] = goals.groupdict()
    return found


def arcs(found: dict[str, dict[str, str]]) -> list[tuple[str, str]]:
    """Pairs (needed, chapter), without those that follow from others."""
    order = list(found)
    needs = {name: set(re.findall(r"\]\((\w+)\.ipynb\)", goals["needs"])) & set(order) for name, goals in found.items()}
    below: dict[str, set[str]] = {}
    for name in order:
        earlier = {one for one in needs[name] if order.index(one) < order.index(name)}
        below[name] = earlier.union(*(below[one] for one in earlier))
        needs[name] = {one for one in earlier if not any(one in below[other] for other in earlier)}
    return [(one, name) for name in order for one in sorted(needs[name], key=order.index)]


def drawn(found: dict[str, dict[str, str]], parts: dict[str, int]) -> str:
    """The figure as SVG; parts: the number of each chapter's part."""
    row = {name: -float(i) for i, name in enumerate(found)}
    shades = (colors.grey, colors.blue, colors.green, colors.orange, colors.red, colors.purple)
    fig, ax = plt.subplots(figsize=(4.2, 0.22 * len(row) + 0.2))
    half = np.linspace(-np.pi / 2, np.pi / 2, 25)
    for one, name in arcs(found):
        middle, reach = (row[one] + row[name]) / 2, (row[one] - row[name]) / 2
        ax.plot(-(0.4 + 0.42 * reach) * np.cos(half), middle + reach * np.sin(half), color=shades[parts[one]], lw=1.2)
    for name, goals in found.items():
        ax.plot([0], [row[name]], "o", color=shades[parts[name]], ms=6)
        ax.text(0.5, row[name], re.split("[:,]", goals["title"])[0], ha="left", va="center", fontsize=9)
    ax.set(xlim=(-8, 13), ylim=(-len(row), 1))
    ax.axis("off")
    return svg_of("landing", fig, ALT)


def current() -> str:
    """The figure as it should be."""
    found, parts = chapters(), dict[str, int]()
    for number, part in enumerate(layout.parts()):
        parts |= dict.fromkeys(part, number)
    return drawn(found, parts) + "\n"


if __name__ == "__main__":
    layout.write_whole(FIGURE, current().encode())
    sys.exit(print(f"what builds on what: {len(arcs(chapters()))} arcs"))
