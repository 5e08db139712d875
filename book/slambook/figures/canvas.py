"""The sheet that marks draw on: SVG elements with shared styles, names of its own, and nothing else."""

import hashlib
import html
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from math import floor, inf

from slambook.figures.paths import Box, number
from slambook.figures.words import SMALL, Lettering, runs

READABLE = 9.0  # pixels: where the page has less room than letters of this size need (--least), the figure scrolls
_ROOT = (
    "width:100%;max-width:{width}px;height:auto;--least:{least}px;fill:none;stroke-linejoin:round;"
    "font-family:'DejaVu Sans',Verdana,sans-serif"
)
_FORBIDDEN = re.compile("[^\t\n -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # what XML cannot hold
_NAME = "\x00"  # stands for the figure's own prefix until its content is known


class Canvas:
    """A sheet of width times height points; y points down."""

    def __init__(self, width: float, height: float) -> None:
        self.width, self.height = width, height
        self._parts: list[str] = []
        self._clips = 0
        self._smallest = inf  # size of its letters

    def element(self, tag: str, style: str = "", **attributes: str) -> None:
        """Any empty element."""
        given = "".join(f' {name}="{value}"' for name, value in attributes.items())
        self._parts.append(f"<{tag}{given}{_styled(style)}/>")

    def path(self, data: str, style: str) -> None:
        """A path; nothing for empty data."""
        if data:
            self.element("path", style, d=data)

    def rectangle(self, box: Box, style: str, radius: float = 0.0) -> None:
        """A box (left, top, right, bottom)."""
        left, top, right, bottom = box
        place = {"x": left, "y": top, "width": right - left, "height": bottom - top} | (
            {"rx": radius} if radius else {}
        )
        self.element("rect", style, **{name: number(value) for name, value in place.items()})

    @contextmanager
    def group(self, style: str = "", clip: Box | None = None, **data: str) -> Iterator[None]:
        """Elements that share a style, or are cut at a box; an empty group leaves nothing.

        data: what a script reads: part="mean" becomes data-part="mean".
        """
        outer, self._parts = self._parts, []
        yield
        inner, self._parts = self._parts, outer
        if not inner:
            return
        reference = ""
        if clip:
            self._parts.append(f'<clipPath id="{_NAME}{self._clips}">')
            self.rectangle(clip, "")
            self._parts.append("</clipPath>")
            reference, self._clips = f' clip-path="url(#{_NAME}{self._clips})"', self._clips + 1
        told = "".join(f' data-{name}="{html.escape(value)}"' for name, value in data.items())
        self._parts += [f"<g{reference}{told}{_styled(style)}>", *inner, "</g>"]

    def text(self, x: float, y: float, words: str, look: Lettering, bare: bool = False) -> None:
        """Words at a point, moved and if need be shrunk to stay on the sheet; bare: the group has their style."""
        words = str(words)
        if not words.strip():
            return
        left, top, right, bottom = look.box(0, 0, words)
        shrink = min(1.0, self.width / max(right - left, 1e-9), self.height / max(bottom - top, 1e-9))
        fitted = look
        if shrink < 1:
            fitted = replace(look, size=max(floor(100 * shrink * look.size) / 100, 0.01))
            left, top, right, bottom = fitted.box(0, 0, words)
        x, y = min(max(x, -left), self.width - right), min(max(y, -top), self.height - bottom)
        self._smallest = min(self._smallest, fitted.size)
        style = "" if bare and fitted == look else fitted.css()
        lines = words.split("\n")
        for i, line in enumerate(lines):
            across, down = map(number, fitted.line(x, y, i, len(lines)))
            turn = f' transform="rotate({number(-look.turned)} {across} {down})"' if look.turned else ""
            place = f'x="{across}" y="{down}"{turn}'
            self._parts.append(f"<text {place}{_styled(style)}>{_tspans(line, fitted.size)}</text>")

    def finished(self, alt: str) -> str:
        """The whole SVG element; alt describes it for those who cannot see it."""
        body = "".join(self._parts)
        own = hashlib.sha256((body + alt).encode("utf-8", "replace")).hexdigest()[:8]
        widest = round(self.width * 4 / 3)
        least = min(widest, round(READABLE * self.width / self._smallest))
        style = _ROOT.format(width=widest, least=least)
        size = f"{number(self.width)} {number(self.height)}"
        return (
            f'<svg viewBox="0 0 {size}" role="img" aria-label="{html.escape(legal(alt))}" style="{style}">'
            f"{body.replace(_NAME, own + '-')}</svg>"
        )


def legal(words: str) -> str:
    """Words without the characters that no SVG may hold."""
    return _FORBIDDEN.sub("", words)


def _styled(style: str) -> str:
    return f' style="{style}"' if style else ""


def _tspans(line: str, size: float) -> str:
    """A line of text; raised and lowered pieces are small and moved from the line of the piece before."""
    found, level = [], 0
    for run in runs(line):
        text = html.escape(legal(run.text), quote=False)
        move = f' dy="{number(0.34 * size * (level - run.level))}"' if run.level != level else ""
        small = f"font-size:{number(SMALL * size)}px;" if run.level else ""
        style = (small + ("font-style:italic" if run.italic else "")).rstrip(";")
        found.append(f"<tspan{move}{_styled(style)}>{text}</tspan>" if move or style else text)
        level = run.level
    return "".join(found)
