"""Print what a reader of each chapter has before the eyes: where the first figure stands, and the shares of the page's
height, in a window of 1280 by 800 with everything folded as it opens.

What is missing to a hundred is the space between the blocks. The figures are printed and gate nothing: none is
enlarged, and no code is hidden, for their sake.
"""

import sys
from typing import Any

from book.tools import browser, layout

KINDS = ("prose", "equations", "figures", "captions", "code", "printed", "folds")
# The heights of the blocks of a page by what they are; what holds other blocks is taken apart.
HEIGHTS = """() => {
  const sum = {}, FIGURE = '.picture, figure.sweep, figure.player, img';
  const tall = (e) => e.checkVisibility() ? e.getBoundingClientRect().height : 0;
  const add = (kind, e) => { sum[kind] = (sum[kind] ?? 0) + tall(e); };
  const cell = (e) => {
    for (const part of e.children) {
      if (part.matches('details.hide')) {
        if (part.open) add('code', part); else add('folds', part);
      } else if (part.matches('figure.of-cell')) add('captions', part);
      else if (part.matches('.cell_input')) add('code', part);
      else if (part.matches('.cell_output')) add(part.querySelector(FIGURE) ? 'figures' : 'printed', part);
      else if (!part.matches('.live-bar')) add('folds', part);
    }
  };
  const block = (e) => {
    if (e.matches('div.cell')) cell(e);
    else if (e.matches('section, .exercise, .solution') || e.querySelector('div.cell')) [...e.children].forEach(block);
    else if (e.matches('div.math')) add('equations', e);
    else if (e.matches('[class*=highlight-]')) add('code', e);
    else if (e.matches('figure, img')) add('figures', e);
    else add('prose', e);
  };
  const article = document.querySelector('.bd-article'), first = article.querySelector(FIGURE);
  [...article.children].forEach(block);
  return { height: tall(article), first: first && first.getBoundingClientRect().top + scrollY, sum };
}"""


def measured(page: Any, url: str) -> dict[str, float]:
    """Height of a page and top of its first figure [px], and the share of each kind of block."""
    browser.load(page, url)
    page.wait_for_function("() => !document.querySelector('div.cell.tag_live') || (window.Live && Live.page)")
    found = page.evaluate(HEIGHTS)
    shares = {kind: found["sum"].get(kind, 0.0) / found["height"] for kind in KINDS}
    return {"height": found["height"], "first": found["first"] or float("nan")} | shares


def main() -> int:
    """Exit status 0 if all chapters were measured."""
    if (path := browser.browser_path()) is None:
        print("no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER")
        return browser.SKIPPED
    chapters = [file for file in layout.notebooks() if file.parent.name == "chapters"]
    rows = {}
    with browser.site_in_chromium(path) as (base, chromium):
        page = chromium.new_page(viewport={"width": 1280, "height": 800})
        for file in chapters:
            address = file.relative_to(layout.ROOT).with_suffix(".html").as_posix()
            rows[file.stem] = measured(page, f"{base}/{address}")
    print(f"{'chapter':<24}{'first figure':>14}{'height':>9}" + "".join(f"{kind:>11}" for kind in KINDS))
    for name, row in rows.items():
        shares = "".join(f"{row[kind]:>11.0%}" for kind in KINDS)
        print(f"{name:<24}{row['first']:>11.0f} px{row['height']:>9.0f}{shares}")
    height = sum(row["height"] for row in rows.values())
    whole = "".join(f"{sum(row[kind] * row['height'] for row in rows.values()) / height:>11.0%}" for kind in KINDS)
    print(f"{'all':<24}{'':>14}{height:>9.0f}{whole}")
    print(f"shares: {len(rows)} chapters")
    return 0


if __name__ == "__main__":
    sys.exit(main())
