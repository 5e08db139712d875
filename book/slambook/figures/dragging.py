"""Figures to hold in the hand: handles that a reader drags, with what follows from them drawn at once, in the page.

A cell draws the start with matplotlib and names what moves by `gid`:

    ax.plot(*ellipse(mean, P, sigmas=1), color=colors.blue, gid="ellipse")
    drag("ellipse", fig, {"axis": (2.0, 1.0), "across": 0.6}, alt="...", says="D = {D:.2f}", values={"D": 1.7})

In a notebook, on paper and without JavaScript it stays that picture. In the page `book/_static/drag.js` fetches
`book/_static/drag/ellipse.js`, which says where the handles of a state are, how a moved handle changes the state, and
what is drawn then: no Python runs. Its formulas are compared with slamlib's (`book/tests/test_dragging.py`).
"""

import html
import json
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from slambook.figures.page import must_describe, svg_of
from slambook.figures.ticks import MINUS
from slamlib.errors import SlamlibError

PART = re.compile(r' data-part="([^"]+)"')
NEGATIVE = re.compile(r"-(?=\d)")
NOTHING = re.compile(r"-(0(?:\.0+)?)(?![\d.])")  # a number that is rounded to zero has no sign


class Dragged:
    """A figure with handles: see drag. Its text is the description."""

    def __init__(self, name: str, svg: str, start: str, alt: str, says: str, values: Mapping[str, float]) -> None:
        self.name, self.svg, self.start, self.alt, self.says, self.values = name, svg, start, alt, says, values

    def __repr__(self) -> str:
        return f"Figure with handles: {self.alt}"

    @property
    def said(self) -> str:
        """The line below the figure, at the start."""
        return NEGATIVE.sub(MINUS, NOTHING.sub(r"\1", self.says.format_map(self.values)))

    def _repr_html_(self) -> str:
        told = {"drag": self.name, "start": self.start, "says": self.says}
        data = "".join(f' data-{name}="{html.escape(value)}"' for name, value in told.items())
        note = f'<p class="sweep-note">{html.escape(self.said)}</p>'
        return f'<figure class="drag"{data}><div class="picture">{self.svg}</div>{note}</figure>'


def drag(
    name: str, fig: Any, start: Mapping[str, Any], alt: str, says: str = "", values: Mapping[str, float] | None = None
) -> Dragged:
    """A figure whose handles a reader drags, shown as the last value of a cell: `book/_static/drag/NAME.js` moves it.

    fig: the start, what moves named by gid, on linear axes. start: the state that the script begins with (numbers and
    lists). says: a line below the figure, with places as {D:.2f} for numbers; values: what they are at the start.
    """
    must_describe("drag", alt)
    svg = svg_of("drag", fig, alt)
    if not PART.search(svg):
        raise SlamlibError("drag: nothing of the figure has a name: give what moves a gid, as plot(x, y, gid='curve')")
    made = Dragged(name, svg, json.dumps(dict(start), default=_plain), alt, says, values or {})
    try:
        made.said  # noqa: B018 - a place without a value is an error here
    except KeyError as error:
        raise SlamlibError(f"drag: says has a place for {error}, which values does not name") from error
    return made


def _plain(value: Any) -> Any:
    """An array or a number of NumPy's as JSON has it."""
    return np.asarray(value).tolist()
