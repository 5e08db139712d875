"""Pictures and sliders as HTML that needs neither a kernel nor the network."""

import hashlib
import html
from collections.abc import Callable, Iterable
from typing import Any

from slamlib.drawing.svg import svg_of
from slamlib.errors import SlamlibError

# The whole slider, without a script of its own: it works in a notebook, in the built page and in a saved copy of it.
_MOVE = (
    "(function(r){var f=r.closest('figure');f.querySelectorAll('[data-frame]').forEach(function(e)"
    "{e.hidden=e.dataset.frame!==r.value});var c=f.querySelectorAll('[data-frame=\"'+r.value+'\"]')[0];"
    "r.setAttribute('aria-valuetext',c.dataset.value);f.querySelector('output').textContent=c.dataset.value})(this)"
)


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
        name = "sweep-" + hashlib.sha256(repr((self.label, self.frames, self.start)).encode()).hexdigest()[:8]
        value = html.escape(self.frames[self.start][0])
        bar = (  # autocomplete: a browser that restores the slider's place after a reload would leave the frame behind
            f'<label for="{name}">{html.escape(self.label)}</label><input type="range" id="{name}" min="0"'
            f' max="{len(self.frames) - 1}" step="1" value="{self.start}" autocomplete="off"'
            f' aria-valuetext="{value}" oninput="{html.escape(_MOVE)}"><output for="{name}">{value}</output>'
        )
        frames = "".join(self._frame(i) for i in range(len(self.frames)))
        return (
            f'<figure class="sweep"><div class="sweep-bar">{bar}</div><div aria-live="polite">{frames}</div></figure>'
        )

    def _frame(self, index: int) -> str:
        value, svg, note = self.frames[index]
        hidden = "" if index == self.start else " hidden"
        caption = f'<p class="sweep-note">{html.escape(note)}</p>' if note else ""
        return f'<div data-frame="{index}" data-value="{html.escape(value)}"{hidden}>{svg}{caption}</div>'


def picture(fig: Any, alt: str) -> Picture:
    """A matplotlib figure for the page, shown as the last value of a cell; the figure is closed.

    alt: a sentence that says what one sees, for those who cannot; it is also the output's text in the notebook.
    """
    _described("picture", alt)
    return Picture(svg_of(fig, alt), alt)


def sweep(draw: Callable[[Any], Any], label: str, values: Iterable[Any], alt: str, start: int | None = None) -> Sweep:
    """A slider over pre-computed frames: draw(value) returns a figure, or (figure, note).

    label: what the slider moves, with its unit; values: one a frame (9 to 15 make a smooth slider and a light page);
    start: index of the first frame shown (default: the middle one). Fix the axes in `draw`: frames must not jump.
    """
    _described("sweep", alt)
    frames = []
    for value in values:
        drawn = draw(value)
        fig, note = drawn if isinstance(drawn, tuple) else (drawn, "")
        shown = value if isinstance(value, str) else f"{value:.4g}".replace("-", "\N{MINUS SIGN}")
        frames.append((shown, svg_of(fig, f"{alt} {label}: {shown}."), note))
    if len(frames) < 2:
        raise SlamlibError(f"sweep: a slider needs at least two values, got {len(frames)}")
    first = len(frames) // 2 if start is None else start
    if not 0 <= first < len(frames):
        raise SlamlibError(f"sweep: start is the index of a frame, 0 to {len(frames) - 1}, got {start}")
    return Sweep(label, frames, first, alt)


def _described(function: str, alt: str) -> None:
    if len(alt) < 20:
        raise SlamlibError(f"{function}: alt should be a sentence that says what one sees, got {alt!r}")
