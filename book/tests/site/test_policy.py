"""The server's policy in a browser: what the book brings along works under it, and nothing that comes later does."""

import contextlib
import socket
from typing import Any

import pytest

from book.tests.site.live_page import FIRST, address, live_pages, open_page, run_one
from book.tools import browser, layout

REFUSED = """async (url) => {
  const refused = [], stop = new AbortController();
  addEventListener('securitypolicyviolation', (e) => refused.push(e.effectiveDirective), { signal: stop.signal });
  const put = (html) => document.body.insertAdjacentHTML('beforeend', html);
  const script = document.createElement('script');
  script.textContent = 'window.stolen = 1';
  document.body.append(script);
  put('<p onclick="window.stolen = 2">press</p>');
  document.body.lastElementChild.click();
  put('<a href="javascript:window.stolen = 3">press</a>');
  document.body.lastElementChild.click();
  put(`<img src="${url}picture.png"><iframe src="${url}"></iframe><form action="${url}" target="_blank"></form>`);
  document.body.lastElementChild.submit();
  await fetch(url).catch(() => null);
  await import(url + 'module.js').catch(() => null);
  try { new Worker(URL.createObjectURL(new Blob(['1']))); } catch { /* or refused by an event */ }
  await new Promise((done) => setTimeout(done, 500));
  stop.abort();
  return [window.stolen ?? null, [...new Set(refused)].sort()];
}"""
DIRECTIVES = ["connect-src", "form-action", "frame-src", "img-src", "script-src-attr", "script-src-elem", "worker-src"]
ASK = """
from js import XMLHttpRequest

def ask(url):
    request = XMLHttpRequest.new()
    request.open("GET", url, False)
    try:
        request.send()
        return request.status
    except BaseException as error:
        return error.name

ask("{own}"), ask("{other}")
"""
PLAY = """
from slambook.scene import player
from slamlib.experiments import presets, runs

run = runs.Run(presets.points())
player([run.slam.snapshot() for _, _ in zip(range(3), run)], alt="A map in three frames.")
"""


@pytest.fixture
def faults() -> list[str]:
    """What pages complain of."""
    return []


@pytest.fixture
def elsewhere():
    """A place on this machine that is not the site, and notes who comes."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(0.5)
        yield listener


def heard(listener: socket.socket) -> bytes:
    """What somebody said who came; a connection that a browser opens beforehand, and says nothing on, is none."""
    said = b""
    with contextlib.suppress(TimeoutError):
        while True:
            line, _ = listener.accept()
            line.settimeout(0.5)
            with line, contextlib.suppress(TimeoutError):
                said += line.recv(1000)
    return said


def opened(context: Any, url: str, faults: list[str]) -> Any:
    """A page with its errors noted, those of the policy among them; browsers ask for an icon, and the book has none."""
    page = context.new_page()
    page.on("pageerror", lambda e: faults.append(f"script error: {e}"))
    page.on(
        "console", lambda m: faults.append(m.text) if m.type == "error" and "icon" not in m.location["url"] else None
    )
    browser.load(page, url)
    return page


def test_what_gets_into_a_page_later_neither_runs_nor_leads_outside(context, site, faults, elsewhere):
    page = opened(context, f"{site}/{address(FIRST)}", faults)
    assert faults == []
    stolen, refused = page.evaluate(REFUSED, f"http://127.0.0.1:{elsewhere.getsockname()[1]}/")
    assert stolen is None
    assert refused == DIRECTIVES
    assert sum("Content Security Policy" in fault for fault in faults) >= len(DIRECTIVES)  # so no test overlooks one
    assert heard(elsewhere) == b""


def test_the_page_s_python_reaches_the_site_alone(context, site, faults, elsewhere):
    page = open_page(context, site, FIRST, faults)
    own, other = f"{site}/index.html", f"http://127.0.0.1:{elsewhere.getsockname()[1]}/"
    assert run_one(page, ASK.format(own=own, other=other)).strip() == "(200, 'NetworkError')"
    assert heard(elsewhere) == b""
    assert run_one(page, "from pyodide.code import run_js\nrun_js('1 + 1')").strip() != "2"  # no eval of JavaScript


def test_a_player_plays_in_the_page_and_where_a_cell_made_it(context, site, faults, outside):
    chapters = [file for file in live_pages() if file.parent == FIRST.parent]  # players there wait for a reader
    still = next(f for f in chapters if "player-code" in (layout.SITE / address(f)).read_text("utf-8"))
    bare = next(f for f in chapters if "player-code" not in (layout.SITE / address(f)).read_text("utf-8"))
    played = opened(context, f"{site}/{address(still)}", faults)
    made = open_page(context, site, bare, faults)
    said = run_one(made, PLAY)
    assert said == "Player of 3 frames: A map in three frames.\n"
    for page in (played, made):
        figure = page.locator("figure.player").first
        before = figure.locator("[data-player=frame]").input_value()
        figure.locator("[data-player=back]").click()
        assert int(figure.locator("[data-player=frame]").input_value()) == int(before) - 1
    assert faults == []


def test_the_theme_s_buttons_and_the_search_work(context, site, faults, outside):
    context.add_init_script("window.print = () => { window.printed = true; }")
    page = opened(context, f"{site}/{address(FIRST)}", faults)
    mode = page.evaluate("() => document.documentElement.dataset.mode")
    page.locator(".theme-switch-button").first.click()
    assert page.evaluate("() => document.documentElement.dataset.mode") != mode
    page.evaluate("() => document.querySelector('button[onclick]').click()")
    assert page.evaluate("() => window.printed")
    browser.load(page, f"{site}/search.html?q=covariance")
    page.wait_for_function("() => document.querySelectorAll('#search-results li .context').length > 3")
    assert faults == []
