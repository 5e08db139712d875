"""A palette that colour-blind readers can tell apart; each colour has a light and a dark value in the page's style."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Palette:
    """Names of the colours; `text` and `paper` are the page's own, `faint` is for grids and the axes' lines.

    In the book the style sheet (figures.css) gives each a light and a dark value. Elsewhere the first six and `faint`
    keep these values, which are seen on white and on black; `text` and `paper` are those of the surrounding page.
    """

    blue: str = "#3690ff"
    orange: str = "#c2852c"
    green: str = "#057048"
    red: str = "#cc0407"
    purple: str = "#a251ba"
    grey: str = "#898989"
    text: str = "#1b1f24"
    faint: str = "#8c9299"
    paper: str = "#fffffe"


colors = Palette()
_ELSEWHERE = {
    "text": "currentColor",
    "paper": "var(--jp-layout-color0, var(--vscode-editor-background, Canvas))",
}


def themed(svg: str) -> str:
    """The drawing with each palette colour, and plain black and white, as a variable of the page's theme."""
    svg = svg.replace("#000000", colors.text).replace("#ffffff", colors.paper)
    for name, value in asdict(colors).items():
        svg = svg.replace(value, f"var(--figure-{name}, {_ELSEWHERE.get(name, value)})")
    return svg
