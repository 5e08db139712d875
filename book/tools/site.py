"""Check the built site without a browser: all pages are there, and links, anchors and assets resolve in the site."""

import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from book.tools import layout

# Links that a reader follows by choice may lead outside; what a page loads by itself may not.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("source", "src"), ("iframe", "src"), ("video", "src")}
NOT_FETCHED = {"canonical", "author", "license", "prev", "next", "index", "search", "alternate"}


class Page(HTMLParser):
    """What one page refers to, and the names it defines."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.links: list[tuple[str, bool]] = []
        self.names: set[str] = set()
        self.feed(file.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note links and names."""
        values = {k: v for k, v in attrs if v is not None}
        self.names |= {values[k] for k in ("id", "name") if k in values}
        for key in ("href", "src"):
            if key in values:
                rel = set(values.get("rel", "").split())
                self.links.append((values[key], (tag, key) in LOADED and not (tag == "link" and rel & NOT_FETCHED)))


def problems(site: Path, wanted: list[str]) -> tuple[int, list[str]]:
    """Number of links followed, and what is wrong with the site; `wanted` are the pages that must be there."""
    found = [f"{page}: named in _toc.yml, but not built" for page in wanted if not (site / page).is_file()]
    pages = {f: Page(f) for f in sorted(site.rglob("*.html")) if "_static" not in f.parts}
    count = 0
    for file, page in pages.items():
        for link, loaded in page.links:
            count += 1
            found += [f"{file.relative_to(site)}: {link}: {why}" for why in _wrong(link, loaded, file, site, pages)]
    return count, found


def _wrong(link: str, loaded: bool, file: Path, site: Path, pages: dict[Path, Page]) -> Iterator[str]:
    parts = urlsplit(link)
    if parts.scheme in ("data", "mailto", "javascript"):
        return
    if parts.scheme or parts.netloc:
        if loaded:
            yield "loaded from outside; the site must serve it itself"
        return
    target = file if not parts.path else (site if parts.path.startswith("/") else file.parent) / unquote(parts.path)
    target = target.resolve()
    if target.is_dir():
        target = target / "index.html"
    if not target.is_file():
        yield "no such file in the site"
    elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].names:
        yield "no such anchor"


def wanted() -> list[str]:
    """The pages of _toc.yml, as paths in the site."""
    return [p.relative_to(layout.ROOT).with_suffix(".html").as_posix() for p in layout.pages()]


def main() -> int:
    """Exit status 0 if nothing is wrong and something was checked."""
    count, found = problems(layout.SITE.resolve(), wanted())
    for problem in found:
        print(problem, file=sys.stderr)
    print(f"site: {len(wanted())} pages, {count} links and assets, {len(found)} problems")
    return 1 if found or not count else 0


if __name__ == "__main__":
    sys.exit(main())
