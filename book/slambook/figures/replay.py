"""A figure of matplotlib's as SVG of the page: drawn again by the small renderer, or as matplotlib itself draws it.

The first is a third as heavy, and raises SlamlibError for what the renderer does not know. Import this where matplotlib
is there.
"""

import html
import io
import re
from typing import Any

import numpy as np
from matplotlib import rc_context, ticker

from slambook.figures.artists import put_all, sample
from slambook.figures.axes import Axes
from slambook.figures.colors import color_named, paint
from slambook.figures.figure import Figure, figure
from slambook.figures.reading import CannotReplayError

USUAL_TICKS = (ticker.AutoLocator, ticker.LogLocator)  # the renderer places its own instead
USUAL_LABELS = (ticker.ScalarFormatter, ticker.LogFormatterSciNotation)
COLOR = re.compile(r"(?<=: )#[0-9a-f]{6}\b")


def replayed(fig: Any) -> Figure:
    """A matplotlib.figure.Figure as one of the renderer's; raises CannotReplayError, or what the renderer says."""
    places = [ax.get_subplotspec() for ax in fig.axes]
    if fig.texts or fig.legends or fig.images or fig.lines or fig.patches or fig.subfigs or fig.get_suptitle():
        raise CannotReplayError("there is something in the figure that is in none of its axes")
    tables = {place and place.get_gridspec() for place in places}
    table = tables.pop() if len(tables) == 1 else None
    if table is None or sorted(place.num1 for place in places) != list(range(table.nrows * table.ncols)):
        raise CannotReplayError("the axes are no plain table")
    width, height = (float(v) for v in fig.get_size_inches())
    made, _ = figure(table.nrows, table.ncols, width=width, height=height)
    for ax, place in zip(fig.axes, places, strict=True):
        _replay(ax, made.axes[place.num1])
    return made


def _replay(ax: Any, target: Axes) -> None:
    if (
        ax.name != "rectilinear"
        or ax.child_axes
        or ax.artists
        or ax.tables
        or ax.get_title("left") + ax.get_title("right")
    ):
        raise CannotReplayError("the axes hold more than the renderer draws")
    put_all(ax, target)
    target.set(title=ax.get_title(), xlabel=ax.get_xlabel(), ylabel=ax.get_ylabel())
    target.set(xscale=ax.get_xscale(), yscale=ax.get_yscale(), aspect=ax.get_aspect(), adjustable=ax.get_adjustable())
    target.set(xlim=ax.get_xlim(), ylim=ax.get_ylim())
    for axis, limits in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
        _ticks(axis, limits, target)
    target.axis("on" if ax.axison else "off")
    target.grid(any(axis.get_tick_params()["gridOn"] for axis in (ax.xaxis, ax.yaxis)))
    if ax.get_legend() is not None:
        _legend(ax.get_legend(), ax, target)


def _ticks(axis: Any, limits: tuple[float, float], target: Axes) -> None:
    """Ticks that somebody has set; the others are the renderer's own."""
    locator, formatter, name = axis.get_major_locator(), axis.get_major_formatter(), axis.axis_name
    if type(locator) in USUAL_TICKS and type(formatter) in USUAL_LABELS:
        return
    places = np.asarray(axis.get_majorticklocs(), dtype=float)
    places = places[(places >= min(limits)) & (places <= max(limits))]
    target.set(**{f"{name}ticks": places})
    if type(formatter) not in USUAL_LABELS and len(places):
        target.set(**{f"{name}ticklabels": formatter.format_ticks(places)})


def _legend(legend: Any, ax: Any, target: Axes) -> None:
    entries = list(zip(legend.legend_handles, (t.get_text() for t in legend.get_texts()), strict=True))
    samples = [sample(handle) for handle, _ in entries]
    box, options = legend.get_bbox_to_anchor(), dict[str, Any]()
    if box is not ax.bbox:
        (x0, y0), (x1, y1) = ax.transAxes.inverted().transform(box.get_points())
        if max(abs(x1 - x0), abs(y1 - y0)) > 1e-9:
            raise CannotReplayError("a legend that is placed in a box")
        options["bbox_to_anchor"] = float(x0), float(y0)
    target.legend(
        samples,
        [label for _, label in entries],
        loc=_loc(legend),
        ncols=_ncols(legend),
        title=legend.get_title().get_text(),
        fontsize=legend.get_texts()[0].get_fontsize() if entries else 10.6,
        frameon=legend.get_frame_on(),
        **options,
    )


def _loc(legend: Any) -> Any:
    """Where a legend stands in what it is anchored to: a corner or side, by its name, or the place of its lower left
    corner, in shares. matplotlib is not asked for what it was told: there is no public way to."""
    ground, box = legend.get_window_extent(), legend.get_bbox_to_anchor()
    pad = legend.borderaxespad * legend.prop.get_size_in_points() * legend.get_figure().dpi / 72
    sides = []
    for low, high, names in (
        (ground.y0 - box.y0, box.y1 - ground.y1, ("lower", "center", "upper")),
        (ground.x0 - box.x0, box.x1 - ground.x1, ("left", "center", "right")),
    ):
        fits = abs(low - pad) < 0.5, abs(high - low) < 0.5, abs(high - pad) < 0.5
        if not any(fits):
            return tuple((ground.p0 - box.p0) / box.size)
        sides.append(names[fits.index(True)])
    return " ".join(dict.fromkeys(sides))


def _ncols(legend: Any) -> int:
    """Its columns: below the title stands the box of them."""
    (_, below), *_ = (packed.get_children() for packed in legend.get_children())
    return len(below.get_children())


def native_svg(fig: Any, alt: str) -> str:
    """matplotlib's SVG of a figure, as an element of the page: the palette's colours follow its theme.

    In JupyterLab and VS Code that is the editor's own text and paper, light or dark.
    """
    written = io.StringIO()
    with rc_context({"svg.fonttype": "none"}):
        fig.savefig(written, format="svg", metadata={"Date": None, "Creator": None}, transparent=True)
    svg = written.getvalue()
    svg = re.sub(
        r"<metadata>.*?</metadata>|<defs>\s*<style.*?</style>\s*</defs>", "", svg[svg.index("<svg") :], flags=re.DOTALL
    )
    body = COLOR.sub(lambda found: paint(color_named(found[0])), svg[svg.index(">") + 1 :])
    width, height = (72 * float(v) for v in fig.get_size_inches())
    style = f"width:100%;max-width:{4 * width / 3:.0f}px;height:auto;fill:currentColor;stroke-linejoin:round"
    words = html.escape(alt)
    head = (
        f'<svg class="matplotlib" viewBox="0 0 {width:g} {height:g}" role="img" aria-label="{words}" style="{style}">'
    )
    return head + body
