"""Sweeps as live sliders of a notebook, where a reader's kernel draws each frame.

They are offered only on request, `live(True)` or SLAMLIB_LIVE=1 in the environment: a notebook that stores a widget
shows nothing when it is opened without its kernel, and a stored output must not depend on who ran it.
"""

import html
import os
from importlib import import_module
from typing import Any

from slamlib.errors import SlamlibError

_asked = {"live": os.environ.get("SLAMLIB_LIVE", "") not in ("", "0")}
VIEW = "application/vnd.jupyter.widget-view+json"


def live(on: bool = True) -> None:
    """Show sweeps as live sliders in this kernel, or as pre-computed frames again."""
    _asked["live"] = bool(on)


def offered(sweep: Any) -> dict[str, Any]:
    """The widget's part of a sweep's output, if live sliders are asked for and can be had."""
    if not _asked["live"]:
        return {}
    bundle: dict[str, Any] = live_slider(sweep)._repr_mimebundle_()
    return {VIEW: bundle[VIEW]} if VIEW in bundle else {}


def live_slider(sweep: Any) -> Any:
    """A slider over all positions of a sweep; its value, figure and note are computed on each move."""
    try:
        ipywidgets = import_module("ipywidgets")
    except ModuleNotFoundError as error:
        raise SlamlibError("a live slider needs ipywidgets: pip install ipywidgets") from error
    slider = ipywidgets.IntSlider(
        value=sweep.start * sweep.steps,
        max=(len(sweep.values) - 1) * sweep.steps,
        description=sweep.label,
        readout=False,
        style={"description_width": "initial"},
        layout={"width": "90%"},
    )
    shown, drawing = ipywidgets.Label(), ipywidgets.HTML()

    def move(_: Any = None) -> None:
        value, svg, note = sweep.frame(slider.value / sweep.steps)
        shown.value = value
        drawing.value = f'<div class="picture">{svg}<p class="sweep-note">{html.escape(note)}</p></div>'

    slider.observe(move, names="value")
    move()
    return ipywidgets.VBox([ipywidgets.HBox([slider, shown]), drawing])
