"""A figure as matplotlib itself draws it, in the colours of the surrounding page: what a notebook's reader sees."""

import io
import re
from typing import Any

from slambook.figures.colors import color_named, paint

_COLOR = re.compile(r"(?<=: )#[0-9a-f]{6}\b")


def native_svg(fig: Any, alt: str) -> str:
    """matplotlib's SVG of a figure, as an element of the page: the palette's colours follow its theme.

    In JupyterLab and VS Code that is the editor's own text and paper, light or dark.
    """
    import html

    import matplotlib

    written = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": "none"}):
        fig.savefig(written, format="svg", metadata={"Date": None, "Creator": None}, transparent=True)
    svg = written.getvalue()
    svg = re.sub(
        r"<metadata>.*?</metadata>|<defs>\s*<style.*?</style>\s*</defs>", "", svg[svg.index("<svg") :], flags=re.DOTALL
    )
    body = _COLOR.sub(lambda found: paint(color_named(found[0])), svg[svg.index(">") + 1 :])
    width, height = (72 * float(v) for v in fig.get_size_inches())
    style = f"width:100%;max-width:{4 * width / 3:.0f}px;height:auto;fill:currentColor;stroke-linejoin:round"
    words = html.escape(alt)
    head = (
        f'<svg class="matplotlib" viewBox="0 0 {width:g} {height:g}" role="img" aria-label="{words}" style="{style}">'
    )
    return head + body
