"""Every page, in light, dark and at a phone's width: what a reader would notice, and what axe-core finds serious."""

import tarfile
from typing import Any

import pytest

from book.tools import assets, browser

HEAVIEST = 1.5e6  # bytes on their way to a reader who has clicked on nothing yet
VIEWS = {"light": ("light", 1280), "dark": ("dark", 1280), "phone": ("light", 390)}
FAULTS = """() => {
  const faults = [];
  const shown = [...document.querySelectorAll('.bd-article p, .bd-article li, .bd-article td, .bd-article dd')];
  if (shown.some(e => /\\\\\\(|\\\\\\[|\\$\\$/.test(e.innerText))) faults.push('unrendered mathematics');
  if (document.querySelector('mjx-merror, [data-mjx-error]')) faults.push('mathematics with an error');
  const asked = document.querySelectorAll('.math').length, set = document.querySelectorAll('mjx-container').length;
  if (asked && !set) faults.push('no mathematics set');
  const size = t => parseFloat(getComputedStyle(t).fontSize) * Math.hypot(t.getScreenCTM().a, t.getScreenCTM().b);
  const letters = [...document.querySelectorAll(':is(.picture, .sweep) text')];
  const small = letters.filter(t => t.getBoundingClientRect().width && size(t) < 8.9).map(t => t.textContent);
  if (small.length) faults.push('letters of a figure below 9 px: ' + small.slice(0, 5).join(', '));
  const box = e => e.getBoundingClientRect();
  const covered = [...document.querySelectorAll('.bd-article .eqno')].filter(number => {
    const shown = [...number.parentElement.querySelectorAll('mjx-container, mjx-math')].map(e => box(e).right);
    return box(number).left < Math.min(...shown) - 1;
  }).map(number => number.parentElement.id);
  if (covered.length) faults.push('numbers on top of their equations: ' + covered.join(', '));
  const listings = [...document.querySelectorAll('.bd-article :is(.highlight pre, .live-editor)')];
  const long = innerWidth < 1280 ? [] : listings.filter(e => e.scrollWidth > e.clientWidth + 1
    && !e.closest('details.hide, .cell_output'));
  if (long.length) faults.push('listings that scroll: ' + long.map(e => e.textContent.slice(0, 40)).join(', '));
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (wide > 1) faults.push('the page is ' + wide + ' px wider than the window');
  return faults;
}"""
MOVED = """range => {
  const figure = range.closest('figure');
  const seen = [...figure.querySelectorAll('[data-frame]')].filter(e => !e.hidden).map(e => e.dataset.frame);
  return seen.length === 1 && seen[0] === range.value && figure.querySelector('output').textContent.length > 0;
}"""
STILL = "*, *::before, *::after { transition: none !important; animation: none !important; }"
SETTLED = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
SERIOUS = """async () => (await axe.run(document, { resultTypes: ['violations'] })).violations
  .filter(f => ['serious', 'critical'].includes(f.impact))
  .map(f => `${f.id}: ${f.help}: ${f.nodes.length} places, such as ${f.nodes[0].html.slice(0, 160)}`)"""


@pytest.fixture
def browser_context_args(browser_context_args: dict[str, Any], request: Any) -> dict[str, Any]:
    """The reader's colour scheme and the width of the window."""
    scheme, width = VIEWS[request.node.callspec.params.get("view", "light")]
    return {**browser_context_args, "color_scheme": scheme, "viewport": {"width": width, "height": 900}}


def wrong(answer: Any) -> list[str]:
    """What is missing, or came without the server's policy; what a policy forbids is an error of the console."""
    return [
        *([f"{answer.status} {answer.url}"] if answer.status >= 400 else []),
        *([f"no policy: {answer.url}"] if "content-security-policy" not in answer.headers else []),
    ]


@pytest.mark.parametrize("view", VIEWS)
def test_a_page_shows_no_faults(name, view, page, site, outside):
    faults: list[str] = []
    page.on("console", lambda m: faults.append(f"console: {m.text}") if m.type == "error" else None)
    page.on("pageerror", lambda e: faults.append(f"script error: {e}"))
    page.on("response", lambda r: faults.extend(wrong(r)) if r.url.startswith(site) else None)
    loaded: list[int] = []
    page.on("response", lambda r: loaded.append(int(r.headers.get("content-length", 0))))
    browser.load(page, f"{site}/{name}")
    faults += page.evaluate(FAULTS)
    if sum(loaded) > HEAVIEST:
        faults.append(f"{sum(loaded) / 1e6:.2f} MB are loaded, of at most {HEAVIEST / 1e6:.1f}")
    for slider in page.query_selector_all("figure.sweep :is(input[type=range], select)"):
        for key in ("Home", "End", "ArrowUp"):
            slider.focus()
            slider.press(key)
            if not slider.evaluate(MOVED):
                faults.append(f"a slider does not follow the key {key}")
    assert faults == []


@pytest.fixture(scope="session")
def axe() -> str:
    """The text of axe-core."""
    with tarfile.open(assets.archive("axe")) as archive:
        file = archive.extractfile("package/axe.min.js")
        assert file is not None
        return file.read().decode("utf-8")


def test_axe_finds_nothing_serious_in_light_and_dark(name, page, site, axe):
    browser.load(page, f"{site}/{name}")
    page.add_style_tag(content=STILL)  # a colour on its way from light to dark is none that a reader sees
    page.evaluate(axe)
    found = []
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.evaluate(SETTLED)
        if page.evaluate("() => document.documentElement.dataset.theme") != scheme:
            found.append(f"{scheme}: the page does not follow the system")
        found += [f"{scheme}: {f}" for f in page.evaluate(SERIOUS)]
    assert found == []
