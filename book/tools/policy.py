"""What a served page may do: the headers that keep it from the world outside, and from scripts that are not its own.

Scripts in files come from the site alone. Of those that stand in a page itself (the theme's, the sliders') a browser
runs what the page was built with, by hashes: no text that gets into it later, from a search box or a cell's result,
becomes a program. The directives: https://www.w3.org/TR/CSP3/
"""

import base64
import functools
import hashlib
import html
import re
from importlib.resources import files
from pathlib import Path

from slambook.figures.page import PLAY
from slambook.scene.player_page import START

SHUT = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
HEADERS = {  # of every answer
    "Content-Security-Policy": SHUT,  # unless a file has its own
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}
WORKER = f"{SHUT}; script-src 'self' blob: 'wasm-unsafe-eval'; connect-src 'self'"  # the page's Python; blob: unzipped
PAGE = (  # style attributes are MathJax's, the theme's and the figures'; pictures in data: are the theme's
    "default-src 'self'; script-src 'self' 'unsafe-hashes' {hashes}; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; worker-src 'self'; object-src 'none'; base-uri 'self'; form-action 'self'; "
    "frame-ancestors 'none'"
)
# One that this misses does not run, and the tests of the pages say so.
PROGRAM = re.compile(r'<script(?![^>]* (?:src=|type="application/json"))[^>]*>(.*?)</script>| on[a-z]+="([^"]*)"', re.S)


@functools.lru_cache(maxsize=256)
def of(file: Path, changed: float) -> str:
    """The policy of a file of the site; `changed`, its time of change, makes an old one useless."""
    if file.suffix != ".html":
        return WORKER if file.suffix == ".js" else SHUT
    # A cell that the reader runs may show a player, or a slider that plays, which bring their programs along, also
    # where the page has none.
    programs = {START, PLAY, files("slambook.scene").joinpath("player.js").read_text("utf-8")}
    found = PROGRAM.findall(file.read_text("utf-8", errors="replace"))  # each a script or a handler of an event
    programs |= {script or html.unescape(handler) for script, handler in found}
    hashes = (base64.b64encode(hashlib.sha256(program.encode()).digest()).decode() for program in programs)
    return PAGE.format(hashes=" ".join(sorted(f"'sha256-{name}'" for name in hashes)))
