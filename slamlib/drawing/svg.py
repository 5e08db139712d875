"""matplotlib figure -> a compact SVG element that may stand beside others in one page, the same bytes on every run."""

import hashlib
import html
import io
import re
from typing import Any

from slamlib.drawing.colors import colors, themed
from slamlib.errors import SlamlibError

_ROOT = (
    "width:100%;max-width:{width}px;height:auto;stroke-linejoin:round;"
    "fill:var(--figure-text, currentColor);font-family:'DejaVu Sans',Verdana,sans-serif"
)
_DROPPED = (  # metadata; a style that would reach the whole page; what matplotlib writes and nobody sees
    r"<metadata>.*?</metadata>|<defs>\s*<style.*?</style>\s*</defs>|<!--.*?-->"
    r'|<path d="[^"]*" style="fill: none"/>| transform="rotate\(-0 [^"]*"|(?:; )?font-family: \'DejaVu Sans\'[^;"]*'
)
_REFERENCE = re.compile(r'url\(#([^)]+)\)|href="#([^"]+)"')
_LONG = re.compile(r"-?\d+\.\d{3,}(?![\de])")


def svg_of(fig: Any, alt: str) -> str:
    """The figure as an inline SVG; its words stay words, its colours follow the theme. A figure of pyplot is closed."""
    if not hasattr(fig, "savefig"):
        raise SlamlibError(f"a matplotlib figure is wanted, not {type(fig).__name__}: pass the figure, not its axes")
    import matplotlib as mpl
    from matplotlib import pyplot

    buffer = io.StringIO()
    for legend in (ax.get_legend() for ax in fig.axes):
        if legend is not None:
            legend.set_frame_on(False)
    with mpl.rc_context({"svg.hashsalt": "slamlib", "svg.fonttype": "none"}):
        fig.savefig(buffer, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    pyplot.close(fig)
    written = buffer.getvalue()
    start = re.search(r"<svg [^>]*>", written)
    if start is None:
        raise SlamlibError("matplotlib wrote no SVG element")
    body = _compact(written[start.end() : written.rindex("</svg>")])
    body = _own_names(body, hashlib.sha256((body + alt).encode()).hexdigest()[:8])
    width, height = fig.get_size_inches() * 72
    style = _ROOT.format(width=round(width * 4 / 3))
    label = html.escape(alt)
    return (
        f'<svg viewBox="0 0 {width:.6g} {height:.6g}" role="img" aria-label="{label}" style="{style}">'
        f"{themed(body)}</svg>"
    )


def _compact(body: str) -> str:
    """Without what is not seen, with coordinates to a hundredth of a point; the words of the figure are not touched."""
    body = re.sub(_DROPPED, "", body, flags=re.DOTALL)
    body = re.sub(r"<[^>]*>", _shortened, body).replace("xlink:href", "href").replace(' style=""', "")
    body = re.sub(r">\s*\n\s*<", "><", body)
    for _ in range(3):
        body = re.sub(r"<g[^>]*></g>|<g[^>]*/>|<defs></defs>", "", body)
    return body.strip()


def _shortened(tag: re.Match[str]) -> str:
    text = tag[0]
    if "scale(" in text or "matrix(" in text or "data:" in text:
        return text
    text = re.sub(r"\s+", " ", text).replace(' "', '"').replace(f"; fill: {colors.text}", "", text.startswith("<text"))
    text = _LONG.sub(lambda m: f"{round(float(m[0]), 2) + 0.0:.2f}".rstrip("0").rstrip("."), text)
    return re.sub(r'(?<= d=")[^"]*', lambda path: re.sub(r" ?([A-Za-z]) ?", r"\1", path[0]), text)


def _own_names(body: str, prefix: str) -> str:
    """Only the names that are referred to stay, each with a prefix of its own: another figure may use the same ones."""
    used = {a or b for a, b in _REFERENCE.findall(body)}
    body = re.sub(r' id="([^"]+)"', lambda m: f' id="{prefix}-{m[1]}"' if m[1] in used else "", body)
    return _REFERENCE.sub(lambda m: f"url(#{prefix}-{m[1]})" if m[1] else f'href="#{prefix}-{m[2]}"', body)
