"""Pictures and sliders as HTML that needs neither a kernel nor the network.

A sweep is written once and lives three times:

    def wave(frequency):
        fig, ax = plt.subplots()
        ax.plot(t, np.sin(2 * np.pi * frequency * t))
        ax.set(xlabel="t [s]", ylabel="x [m]", xlim=(0, 1), ylim=(-1, 1))
        return fig, f"one turn in {1 / frequency:.2f} s"

    sweep(wave, "frequency [Hz]", [1, 2, 4, 8], alt="A sine wave.")

In a page and in a stored notebook it is a slider over pre-computed frames, one a value. A live interpreter (the book's
own in the page, or a kernel) asks `frame(position)` for any place between them, `steps` places from value to value: see
slambook.figures.widget for notebooks.

A figure is matplotlib's. In the page it is drawn by the small renderer of this folder, which replays its artists (or,
where no matplotlib is, has been called in its place); a kernel's reader sees it as matplotlib draws it.
"""

import hashlib
import html
import sys
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from slambook.figures.figure import Figure
from slambook.figures.ticks import MINUS
from slambook.figures.widget import live_slider, offered, wanted
from slamlib.errors import SlamlibError

STEPS = 8  # places from one value to the next in a live slider
# The whole slider, without a script of its own: it works in a notebook, in the built page and in a saved copy of it.
MOVE = (
    "(function(r){var f=r.closest('figure');f.querySelectorAll('[data-frame]').forEach(function(e)"
    "{e.hidden=e.dataset.frame!==r.value});var c=f.querySelectorAll('[data-frame=\"'+r.value+'\"]')[0];"
    "if(r.type==='range')r.setAttribute('aria-valuetext',c.dataset.value);f.querySelector('output').textContent=c.dataset.value;"
    "f.querySelector('.sweep-note').textContent=c.dataset.note||''})(this)"
)
# Play moves the slider as a reader would, to its end in ten seconds or so; pressed again it pauses.
PLAY = (
    "(function(b){var r=b.parentNode.querySelector('input'),n=(r.max-r.min)/r.step,"
    "stop=function(){clearInterval(b.timer);b.timer=0;b.textContent='Play'};if(b.timer)return stop();"
    "var go=function(v){r.value=v;r.dispatchEvent(new Event('input'));"
    "if(+r.value===+r.max||!b.isConnected)stop()};b.textContent='Pause';"
    "b.timer=setInterval(function(){go(+r.value+ +r.step)},Math.min(1000,10000/n));if(r.value===r.max)go(r.min)})(this)"
)


class StaticPicture:
    """A figure as an inline SVG that follows the page's theme; its text is the description."""

    def __init__(self, fig: Any, alt: str) -> None:
        self.svg, self.alt = svg_of("picture", fig, alt), alt
        self._own = own_svg_of("picture", fig, alt) if wanted() else self.svg

    def __repr__(self) -> str:
        return f"Picture: {self.alt}"

    def _repr_html_(self) -> str:
        return f'<div class="picture">{self._own}</div>'


class Sweep:
    """Figures under a slider: see sweep. Frames are drawn when they are asked for, and once."""

    def __init__(
        self, draw: Callable[[Any], Any], label: str, values: list[Any], start: int, alt: str, play: bool
    ) -> None:
        self.draw, self.label, self.values, self.start, self.alt, self.play = draw, label, values, start, alt, play
        self._drawn: dict[int, tuple[str, str, str]] = {}

    def __repr__(self) -> str:
        return f"Sweep of {self.label} over {len(self.values)} values: {self.alt}"

    @property
    def names(self) -> list[str]:
        """What a menu offers in place of the slider: the values, unless they are numbers."""
        return [] if all(map(_is_number, self.values)) else list(map(str, self.values))

    @property
    def button(self) -> str:
        """Play, as HTML beside the slider, for those that have it."""
        return f'<button type="button" onclick="{html.escape(PLAY)}">Play</button>' * self.play

    @property
    def steps(self) -> int:
        """Places from one value to the next in a live slider: no more than there are whole numbers, for those."""
        if self.names:
            return 1
        if all(map(_is_whole, self.values)):
            return int(min(STEPS, max(1, np.abs(np.diff(np.array(self.values, dtype=np.int64))).max())))
        return STEPS

    def value(self, position: float) -> Any:
        """The value at a position 0 to n - 1, in proportion between two; whole numbers stay whole.

        Raises SlamlibError beyond the ends, and between values that are not numbers.
        """
        last = len(self.values) - 1
        position = _settled(position)
        if not 0 <= position <= last:
            raise SlamlibError(f"sweep: a position lies between 0 and {last}, got {position:g}")
        if position.is_integer():
            return self.values[int(position)]
        low, high = self.values[int(position)], self.values[int(position) + 1]
        if not (_is_number(low) and _is_number(high)):
            raise SlamlibError(f"sweep: there is nothing between {low!r} and {high!r}: take a whole position")
        between = float(low) + (position - int(position)) * (float(high) - float(low))
        return round(between) if all(map(_is_whole, self.values)) else between

    def frame(self, position: float) -> tuple[str, str, str]:
        """What stands beside the slider at a position 0 to n - 1: the value as words, the figure as SVG, the note."""
        position = _settled(position)
        if position in self._drawn:
            return self._drawn[int(position)]
        found = self._frame(position, svg_of)
        if position.is_integer():
            self._drawn[int(position)] = found
        return found

    def own_frame(self, position: float) -> tuple[str, str, str]:
        """The same with the figure as matplotlib draws it."""
        return self._frame(_settled(position), lambda _, fig, alt: own_svg_of("sweep", fig, alt))

    def _frame(self, position: float, svg: Callable[[str, Any, str], str]) -> tuple[str, str, str]:
        value = self.value(position)
        drawn = self.draw(value)
        fig, note = drawn if isinstance(drawn, tuple) else (drawn, "")
        shown = f"{value:.4g}".replace("-", MINUS) if _is_number(value) else str(value)
        return shown, svg("sweep", fig, f"{self.alt} {self.label}: {shown}."), str(note)

    @property
    def frames(self) -> list[tuple[str, str, str]]:
        """The frames of the values."""
        return [self.frame(i) for i in range(len(self.values))]

    def widget(self) -> Any:
        """A live slider for a notebook with a kernel (needs ipywidgets)."""
        return live_slider(self)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        return {"text/plain": repr(self), **offered(self)}

    def _repr_html_(self) -> str:
        frames = self.frames
        name = "sweep-" + hashlib.sha256(repr((self.label, frames, self.start)).encode()).hexdigest()[:8]
        value, _, note = frames[self.start]
        value, last, start = html.escape(value), len(frames) - 1, self.start
        named = [f"<option value={i}{' selected' * (i == start)}>{html.escape(n)}" for i, n in enumerate(self.names)]
        # autocomplete: a browser that restores a slider's value after a reload would leave the frame behind
        common = f'id="{name}" autocomplete="off" oninput="{html.escape(MOVE)}"'
        slider = f'<input type="range" {common} min="0" max="{last}" step="1" value="{start}" aria-valuetext="{value}">'
        bar = f'<label for="{name}">{html.escape(self.label)}</label>'
        bar += f"<select {common}>{''.join(named)}</select>" if named else slider
        bar += f'<output for="{name}"{" hidden" * bool(named)}>{value}</output>'
        bar += self.button
        shown = ""
        for i, (number, svg, words) in enumerate(frames):
            said = f' data-note="{html.escape(words)}"' if words else ""
            hidden = "" if i == self.start else " hidden"
            shown += f'<div data-frame="{i}" data-value="{html.escape(number)}"{said}{hidden}>{svg}</div>'
        caption = f'<p class="sweep-note" aria-live="polite">{html.escape(note)}</p>'
        return f'<figure class="sweep"><div class="sweep-bar">{bar}</div>{shown}{caption}</figure>'


def picture(fig: Any, alt: str) -> StaticPicture:
    """A figure for the page, shown as the last value of a cell: matplotlib's, or one of map_figure and sensor_figure.

    It is closed, so that a notebook does not show it again. alt: a sentence that says what one sees, for those who
    cannot; it is also the output's text in the notebook.
    """
    must_describe("picture", alt)
    return StaticPicture(fig, alt)


def sweep(
    draw: Callable[[Any], Any],
    label: str,
    values: Iterable[Any],
    alt: str,
    start: int | None = None,
    play: bool = False,
) -> Sweep:
    """A slider over figures: draw(value) returns a figure, or (figure, note).

    label: what the slider moves, with its unit; values: one a frame (9 to 15 make a smooth slider and a light page);
    start: index of the first frame shown (default: the middle one). Fix the axes in `draw`: frames must not jump.
    play: a button that moves the slider, for values that are moments, one after the other.
    The first frame is drawn at once, so that a mistake in `draw` is an error here.
    """
    must_describe("sweep", alt)
    values = list(values)
    if len(values) < 2:
        raise SlamlibError(f"sweep: a slider needs at least two values, got {len(values)}")
    first = len(values) // 2 if start is None else start
    if not 0 <= first < len(values):
        raise SlamlibError(f"sweep: start is the index of a frame, 0 to {len(values) - 1}, got {start}")
    made = Sweep(draw, label, values, first, alt, play)
    if play and made.names:
        raise SlamlibError(f"sweep: only numbers can be played, and one value is {made.names[0]!r}: leave play out")
    made.frame(first)
    return made


def svg_of(function: str, fig: Any, alt: str) -> str:
    """A figure, drawn by the small renderer if it can and by matplotlib if not, and closed. Raises SlamlibError."""
    if isinstance(fig, Figure):
        return _closed(fig).svg(alt)
    if not _is_matplotlibs(fig):
        raise SlamlibError(
            f"{function}: a figure of matplotlib's is wanted, not {type(fig).__name__}: pass the figure, not its axes"
        )
    from slambook.figures.replay import replayed

    try:
        return replayed(_closed(fig)).svg(alt)
    except SlamlibError:
        return own_svg_of(function, fig, alt)


def own_svg_of(function: str, fig: Any, alt: str) -> str:
    """A figure as matplotlib draws it, if it is matplotlib's, and closed. Raises SlamlibError."""
    if not _is_matplotlibs(fig):
        return svg_of(function, fig, alt)
    from slambook.figures.replay import native_svg

    return native_svg(_closed(fig), alt)


def _is_matplotlibs(fig: Any) -> bool:
    matplotlibs = sys.modules.get("matplotlib.figure")
    return matplotlibs is not None and isinstance(fig, matplotlibs.Figure)


def _closed(fig: Any) -> Any:
    """The figure, closed in pyplot."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if isinstance(fig, Figure):
        fig.close()
    elif pyplot is not None:
        pyplot.close(fig)
    return fig


def must_describe(function: str, alt: str) -> None:
    """Raise SlamlibError for words that are too few to describe a figure."""
    if len(alt) < 20:
        raise SlamlibError(f"{function}: alt should be a sentence that says what one sees, got {alt!r}")


def _settled(position: float) -> float:
    """A slider's position without the rounding of its steps."""
    whole = round(position) if np.isfinite(position) else position
    return float(whole if abs(position - whole) < 1e-9 else position)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)


def _is_whole(value: Any) -> bool:
    return _is_number(value) and isinstance(value, int | np.integer)
