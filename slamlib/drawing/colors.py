"""A palette that colour-blind readers can tell apart; each colour has a light and a dark value in the page's style."""

from dataclasses import astuple, dataclass, fields


@dataclass(frozen=True)
class Palette:
    """Names of the colours; the values are what a notebook shows where the book's style sheet is absent."""

    blue: str = "#1f77c9"
    orange: str = "#d9730d"
    green: str = "#12875f"
    red: str = "#cc3d55"
    purple: str = "#8f5fd0"
    grey: str = "#808890"
    text: str = "#767b80"
    faint: str = "#b4b8bc"


colors = Palette()


def themed(svg: str) -> str:
    """The drawing with each palette colour as a variable of the page's theme."""
    for field, value in zip(fields(colors), astuple(colors), strict=True):
        svg = svg.replace(value, f"var(--figure-{field.name}, {value})")
    return svg
