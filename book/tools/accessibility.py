"""Run axe-core over every page, in light and dark: no serious finding may be left."""

import sys
import tarfile
from typing import Any

from book.tools import assets, browser

GRAVE = ("serious", "critical")
STILL = "*, *::before, *::after { transition: none !important; animation: none !important; }"


def program() -> str:
    """The text of axe-core."""
    with tarfile.open(assets.archive("axe")) as archive:
        file = archive.extractfile("package/axe.min.js")
        assert file is not None
        return file.read().decode("utf-8")


def findings(page: Any, axe: str) -> list[str]:
    """What axe-core finds serious in an open page."""
    page.evaluate(axe)
    found = page.evaluate("async () => (await axe.run(document, { resultTypes: ['violations'] })).violations")
    return [
        f"{f['id']} ({f['impact']}): {f['help']}: {len(f['nodes'])} places, such as {f['nodes'][0]['html'][:160]}"
        for f in found
        if f["impact"] in GRAVE
    ]


def main() -> int:
    """Exit status 0 if nothing serious was found."""
    executable = browser.browser_path()
    if executable is None:
        return browser.without_browser("axe")
    axe, found = program(), list[str]()
    pages = [p for p in browser.all_pages() if p != "index.html"]  # that one only leads to the first page
    with browser.site_in_chromium(executable) as (base, chromium):
        for scheme in ("light", "dark"):
            context = chromium.new_context(color_scheme=scheme, viewport={"width": 1280, "height": 900})
            for name in pages:
                page = context.new_page()
                browser.load(page, f"{base}/{name}")
                page.add_style_tag(content=STILL)  # a colour on its way from light to dark is none that a reader sees
                page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
                found += [f"{name} ({scheme}): {f}" for f in findings(page, axe)]
                page.close()
            context.close()
    for finding in found:
        print(finding, file=sys.stderr)
    print(f"axe: {len(pages)} pages, in light and dark, {len(found)} serious findings")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
