"""Run axe-core over every page, in light and dark: no serious finding may be left."""

import contextlib
import sys
import tarfile
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from book.tools import assets, browser, workers

GRAVE = ("serious", "critical")
SCHEMES = ("light", "dark")
STILL = "*, *::before, *::after { transition: none !important; animation: none !important; }"


def program() -> str:
    """The text of axe-core."""
    with tarfile.open(assets.archive("axe")) as archive:
        file = archive.extractfile("package/axe.min.js")
        assert file is not None
        return file.read().decode("utf-8")


def findings(page: Any) -> list[str]:
    """What axe-core, which the page holds, finds serious in it."""
    found = page.evaluate("async () => (await axe.run(document, { resultTypes: ['violations'] })).violations")
    return [
        f"{f['id']} ({f['impact']}): {f['help']}: {len(f['nodes'])} places, such as {f['nodes'][0]['html'][:160]}"
        for f in found
        if f["impact"] in GRAVE
    ]


def examine(context: Any, base: str, name: str, axe: str) -> list[str]:
    """What is serious on a page, in light and then, when the reader's system turns to it, in dark."""
    page = context.new_page()
    browser.load(page, f"{base}/{name}")
    page.add_style_tag(content=STILL)  # a colour on its way from light to dark is none that a reader sees
    page.evaluate(axe)
    found = []
    for scheme in SCHEMES:
        page.emulate_media(color_scheme=scheme)
        page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        if page.evaluate("() => document.documentElement.dataset.theme") != scheme:
            found.append(f"{name} ({scheme}): the page does not follow the system to {scheme}")
        found += [f"{name} ({scheme}): {f}" for f in findings(page)]
    page.close()
    return found


@contextlib.contextmanager
def examiner(executable: str) -> Iterator[Callable[[str], list[str]]]:
    """What examines a page."""
    axe = program()
    with browser.site_in_chromium(executable) as (base, chromium):
        context = chromium.new_context(color_scheme=SCHEMES[0], viewport={"width": 1280, "height": 900})
        yield lambda name: examine(context, base, name, axe)


def main() -> int:
    """Exit status 0 if nothing serious was found."""
    executable = browser.browser_path()
    if executable is None:
        return browser.without_browser("axe")
    program()  # fetched once, before two ask for it
    pages = [p for p in browser.all_pages() if p != "index.html"]  # that one only leads to the first page
    found = [f for some in workers.each(partial(examiner, executable), pages) for f in some]
    for finding in found:
        print(finding, file=sys.stderr)
    print(f"axe: {len(pages)} pages, in light and dark, {len(found)} serious findings")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
