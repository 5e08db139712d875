"""Pictures and sliders as HTML that needs neither a kernel nor the network."""

import html
import io
import itertools
import re
from collections.abc import Callable, Iterable
from typing import Any

from slamlib.drawing.colors import colors, themed
from slamlib.errors import SlamlibError

_STYLE = "max-width:{width}px;width:100%;height:auto"
_MOVE = (
    "(function(r){var f=r.closest('figure');f.querySelectorAll('[data-frame]').forEach(function(e)"
    "{e.hidden=e.dataset.frame!==r.value});var c=f.querySelectorAll('[data-frame=\"'+r.value+'\"]')[0];"
    "r.setAttribute('aria-valuetext',c.dataset.value);f.querySelector('output').textContent=c.dataset.value})(this)"
)
_numbers = itertools.count(1)


class Picture:
    """A figure as an inline SVG that follows the page's theme; its text is the description."""

    def __init__(self, svg: str, alt: str) -> None:
        self.svg, self.alt = svg, alt

    def __repr__(self) -> str:
        return f"Picture: {self.alt}"

    def _repr_html_(self) -> str:
        return f'<div class="picture">{self.svg}</div>'


class Sweep:
    """Pre-computed frames under a slider."""

    def __init__(self, label: str, frames: list[tuple[str, str, str]], start: int, alt: str) -> None:
        self.label, self.frames, self.start, self.alt = label, frames, start, alt

    def __repr__(self) -> str:
        return f"Sweep of {self.label} over {len(self.frames)} values: {self.alt}"

    def _repr_html_(self) -> str:
        number = next(_numbers)
        value = html.escape(self.frames[self.start][0])
        last = len(self.frames) - 1
        bar = (
            f'<label for="sweep-{number}">{html.escape(self.label)}</label>'
            f'<input type="range" id="sweep-{number}" min="0" max="{last}" step="1" value="{self.start}"'
            f' aria-valuetext="{value}" oninput="{html.escape(_MOVE)}"><output for="sweep-{number}">{value}</output>'
        )
        frames = "".join(self._frame(i) for i in range(len(self.frames)))
        return (
            f'<figure class="sweep"><div class="sweep-bar">{bar}</div>'
            f'<div class="sweep-frames" aria-live="polite">{frames}</div></figure>'
        )

    def _frame(self, index: int) -> str:
        value, svg, note = self.frames[index]
        hidden = "" if index == self.start else " hidden"
        caption = f'<p class="sweep-note">{html.escape(note)}</p>' if note else ""
        return f'<div data-frame="{index}" data-value="{html.escape(value)}"{hidden}>{svg}{caption}</div>'


def picture(fig: Any, alt: str) -> Picture:
    """Show a matplotlib figure; `alt` says what one sees, for those who cannot. Closes the figure."""
    if len(alt) < 20:
        raise SlamlibError("picture: alt should be a sentence that says what one sees")
    return Picture(_svg(fig, alt), alt)


def sweep(draw: Callable[[Any], Any], label: str, values: Iterable[Any], alt: str, start: int | None = None) -> Sweep:
    """A slider over pre-computed frames: draw(value) returns a figure, or (figure, note).

    label: what the slider moves, with its unit; values: one a frame (9 to 15 make a smooth slider and a light page);
    start: index of the first frame shown (default: the middle one). Fix the axes in `draw`: frames must not jump.
    """
    frames = []
    for value in values:
        drawn = draw(value)
        fig, note = drawn if isinstance(drawn, tuple) else (drawn, "")
        shown = value if isinstance(value, str) else f"{value:.4g}"
        frames.append((shown, _svg(fig, f"{alt} {label}: {shown}. {note}".strip()), note))
    if not frames:
        raise SlamlibError("sweep: no values given")
    return Sweep(label, frames, len(frames) // 2 if start is None else start, alt)


def _svg(fig: Any, alt: str) -> str:
    """The figure as SVG text: the same bytes on every run, names of its parts unique in the page, colours themed."""
    import matplotlib as mpl
    from matplotlib import pyplot

    number = next(_numbers)
    _restyle(fig)
    buffer = io.StringIO()
    width = fig.get_size_inches()[0] * 96
    with mpl.rc_context({"svg.hashsalt": "slamlib", "svg.fonttype": "none"}):
        fig.savefig(buffer, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    pyplot.close(fig)
    svg = buffer.getvalue()
    svg = svg[svg.index("<svg") :].strip()
    svg = re.sub(r"<metadata>.*?</metadata>|<defs>\s*<style.*?</style>\s*</defs>", "", svg, flags=re.DOTALL)
    svg = re.sub(r'\bid="([^"]+)"', rf'id="f{number}-\1"', svg)
    svg = re.sub(r'url\(#([^)]+)\)|href="#([^"]+)"', lambda m: _renamed(m, number), svg)
    svg = re.sub(r"font: ([^;\"]*?)'DejaVu Sans'[^;\"]*", r"font: \1inherit, sans-serif", svg)
    svg = re.sub(r"(\d\.\d{2})\d+", r"\1", svg)
    attributes = f'role="img" aria-label="{html.escape(alt)}" style="{_STYLE.format(width=round(width))}"'
    svg = re.sub(r'<svg ([^>]*?)width="[^"]*" ', rf"<svg {attributes} \1", svg, count=1)
    svg = re.sub(r'(<svg [^>]*?) height="[^"]*"', r"\1", svg, count=1)
    return themed(re.sub(r"\n\s*", "\n", svg))


def _restyle(fig: Any) -> None:
    """Bring what was drawn with matplotlib's defaults, legends and notes, into the house style."""
    from matplotlib.legend import Legend
    from matplotlib.text import Text

    for legend in fig.findobj(Legend):
        legend.set_frame_on(False)
    for label in fig.findobj(Text):
        if label.get_color() in ("black", "k"):
            label.set_color(colors.text)


def _renamed(match: re.Match[str], number: int) -> str:
    return f"url(#f{number}-{match[1]})" if match[1] else f'href="#f{number}-{match[2]}"'
