"""What a notebook's reader gets: figures as matplotlib draws them, and live sliders, each frame drawn by the kernel.

They are offered where somebody is there to move them: in a front end that takes input, as JupyterLab and VS Code do.
Where notebooks are only executed (nbconvert, nbval, the book's build) the pre-computed frames are all there is, so that
a stored output does not depend on a kernel. `live(True)` or `live(False)` decides instead.
"""

import html
import sys
from importlib import import_module
from typing import Any

from slamlib.errors import SlamlibError

_asked: dict[str, bool | None] = {"live": None}
VIEW = "application/vnd.jupyter.widget-view+json"


def live(on: bool | None = True) -> None:
    """Show figures and sliders as to a kernel's reader (True), as in the page (False), or as fits the front end."""
    _asked["live"] = on


def wanted() -> bool:
    """Whether what is shown is for a reader with a kernel."""
    if _asked["live"] is not None:
        return bool(_asked["live"])
    # a kernel whose front end can answer `input()` has a user, who can also move a slider
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return bool(getattr(getattr(shell, "kernel", None), "_allow_stdin", False))


def offered(sweep: Any) -> dict[str, Any]:
    """The widget's part of a sweep's output, if live sliders are asked for and can be had."""
    if not wanted():
        return {}
    try:
        bundle: dict[str, Any] = live_slider(sweep)._repr_mimebundle_()
    except SlamlibError:
        if _asked["live"]:
            raise
        return {}
    return {VIEW: bundle[VIEW]} if VIEW in bundle else {}


def live_slider(sweep: Any) -> Any:
    """A slider over all positions of a sweep; its value, figure and note are computed on each move."""
    try:
        ipywidgets = import_module("ipywidgets")
    except ModuleNotFoundError as error:
        raise SlamlibError("a live slider needs ipywidgets: pip install ipywidgets") from error
    common = {"description": sweep.label, "style": {"description_width": "initial"}, "layout": {"width": "90%"}}
    if sweep.names:
        options = [(name, i) for i, name in enumerate(sweep.names)]
        slider = ipywidgets.Dropdown(options=options, value=sweep.start, **common)
    else:
        last, start = (len(sweep.values) - 1) * sweep.steps, sweep.start * sweep.steps
        slider = ipywidgets.IntSlider(value=start, max=last, readout=False, **common)
    shown, drawing = ipywidgets.Label(), ipywidgets.HTML()

    def move(_: Any = None) -> None:
        value, svg, note = sweep.own_frame(slider.value / sweep.steps)
        shown.value = value
        drawing.value = f'<div class="picture">{svg}<p class="sweep-note">{html.escape(note)}</p></div>'

    slider.observe(move, names="value")
    move()
    bar = [slider, shown]
    if sweep.play:
        bar.append(ipywidgets.Play(value=slider.value, max=slider.max, interval=int(min(1000, 10_000 / slider.max))))
        ipywidgets.jslink((bar[-1], "value"), (slider, "value"))
    return ipywidgets.VBox([ipywidgets.HBox(bar), drawing])
