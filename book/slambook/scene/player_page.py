"""The interactive map as HTML: its bar, its picture, its key, its data and its script, in one element.

Nothing runs when it is shown. Its first event starts the script, so that it works where HTML is put into a page by a
program too, in which browsers do not run scripts.
"""

import html
import json
from importlib.resources import files
from typing import Any

START = (  # runs once, at the first event: the script defines slamlibPlayer, which takes over all later ones
    "var f=this,s=document.createElement('script');s.textContent=f.querySelector('.player-code').textContent;"
    "document.head.append(s);s.remove();window.slamlibPlayer(f)(event)"
)
STYLE = (
    ".player button,.player select{font:inherit;font-size:.85rem;padding:.2rem .6rem;min-height:1.9rem;cursor:pointer;"
    "border-radius:4px;border:1px solid var(--figure-faint,#8c9299);color:inherit;background:transparent}"
    ".player option{color:#1b1f24;background:#fff}"
    ".player [aria-pressed=true]{outline:2px solid var(--figure-blue,#3690ff)}"
    ".player :focus-visible{outline:2px solid var(--figure-blue,#3690ff);outline-offset:2px}"
    ".player-bar{display:flex;flex-wrap:wrap;gap:.35rem .5rem;align-items:center;justify-content:center}"
    ".player-bar input[type=range]{flex:1 1 8rem;max-width:22rem;min-height:1.6rem}"
    ".player-stage{display:flex;flex-wrap:wrap;gap:.5rem;align-items:center;justify-content:center}"
    ".player-stage svg{flex:3 1 21rem;min-width:0}.player-stage svg+svg{flex:2 1 15rem}"
    ".player-stage{touch-action:pan-y;cursor:grab;user-select:none}"
    ".player-key{display:flex;flex-wrap:wrap;gap:.1rem 1rem;justify-content:center;list-style:none;padding:0;"
    "margin:.2rem 0;font-size:.85rem}.player-key li{margin:0}.player-key svg{width:26px;height:12px}"
    ".player p{margin:.2rem 0;font-size:.9em;min-height:1.4em;font-variant-numeric:tabular-nums}"
    "@media(scripting:none){.player-bar{display:none}}"
)
BUTTONS = {
    "play": ("Play", "Play or pause"),
    "back": ("\u2039 Back", "One frame back"),
    "on": ("Step \u203a", "One frame on"),
}
TURNS = {"orbit": ("Orbit", "Turn around the map"), "nearer": ("+", "Nearer"), "farther": ("\u2212", "Farther away")}
KEYS = "Drag the map, or focus it and use the arrow keys, to turn it; + and \u2212 zoom, the space bar plays."


class Player:
    """The interactive map: shown as the last value of a cell; its text is the description."""

    def __init__(self, data: dict[str, Any], svg: str, alt: str, labels: bool) -> None:
        self.data, self.svg, self.alt, self.labels = data, svg, alt, labels

    def __repr__(self) -> str:
        return f"Player of {len(self.data['frames'])} frames: {self.alt}"

    def _repr_html_(self) -> str:
        events = "".join(f' {name}="{START}"' for name in ("onclick", "oninput", "onkeydown", "onpointerdown"))
        script = files("slambook.scene").joinpath("player.js").read_text("utf-8")
        data = json.dumps(self.data, separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
        stage = f'data-player="stage" role="application" tabindex="0" aria-label="{html.escape(self.alt + " " + KEYS)}"'
        shown = [self.data["roles"], self.data.get("sensor", {}).get("roles", {})]  # of the map, of the sensor's view
        keys = "".join(_key(roles) for roles in shown if roles)
        return (
            f'<figure class="player picture"{events}><style>{STYLE}</style>{self._bar()}'
            f'<div class="player-stage" {stage}>{self.svg}</div>{keys}'
            f'<p><span data-player="note" aria-live="polite">{html.escape(self.data["frames"][-1]["note"])}</span></p>'
            f'<script type="application/json" class="player-data">{data}</script>'
            f'<script type="text/plain" class="player-code">{script}</script></figure>'
        )

    def _bar(self) -> str:
        last, said = len(self.data["frames"]) - 1, html.escape(self.data["frames"][-1]["said"])
        names = "".join(f"<option>{html.escape(name)}</option>" for name in self.data["views"])
        slider = (
            f'<input type="range" data-player="frame" min="0" max="{last}" step="1" value="{last}" autocomplete="off"'
            f' aria-label="Frame" aria-valuetext="{said}">'
        )
        choice = f'<label>View <select data-player="view" autocomplete="off">{names}</select></label>'
        labels = '<label><input type="checkbox" data-player="labels"{}> Labels</label>'
        checked = labels.format(" checked" if self.labels else "")
        first = f'{_buttons(BUTTONS)}{slider}<span data-player="said">{said}</span>'
        return f'<div class="player-bar">{first}</div><div class="player-bar">{choice}{_buttons(TURNS)}{checked}</div>'


def _buttons(known: dict[str, tuple[str, str]]) -> str:
    pressed = ' aria-pressed="false"'
    return "".join(
        f'<button type="button" data-player="{name}" aria-label="{said}"{pressed * (name == "orbit")}>{text}</button>'
        for name, (text, said) in known.items()
    )


SAMPLES = {  # marks of the key; any other role is a stroke
    "o": '<circle cx="13" cy="6" r="2.5" style="{mark}"/>',
    "+": '<path d="M9 6h8M13 2v8" style="{mark}"/>',
    "x": '<path d="M10 3l6 6M16 3l-6 6" style="{mark}"/>',
}


def _key(roles: dict[str, dict[str, Any]]) -> str:
    """What the colours mean, as a list beside the map, so that its words keep their size on a phone."""
    items = []
    for role in filter(lambda role: role["label"], roles.values()):
        sample = SAMPLES.get(role["marker"], '<path d="M2 6h22" style="{line}"/>').format(**role)
        items.append(f'<li><svg viewBox="0 0 26 12" aria-hidden="true">{sample}</svg> {role["label"]}</li>')
    return f'<ul class="player-key">{"".join(items)}</ul>'
