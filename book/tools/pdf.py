"""Print the built book as one PDF: `make pdf`, after `make book`; needs Chromium.

The pages of the site, one after the other, become one page whose links lead within it, and Chromium prints that, with
bookmarks, in light colours. Sliders show their first, chosen and last frames; solutions and the quiz's answers stand at
the end of their chapter; code that a page folds away, such as that of figures, is left out.
"""

import copy
import re
import sys
import time
from pathlib import Path

from bs4 import BeautifulSoup, Tag

from book.tools import browser, layout

PDF = "ekf-slam-book.pdf"
GOES = (  # what only a screen needs
    ".prev-next-footer, .headerlink, .copybtn, .toctree-wrapper, script, details.hide"
)
STYLE = """
@page { size: A4; margin: 16mm 16mm 18mm 16mm; }
html { font-size: 12.5px; }
body { background: white; max-width: none; }
main { max-width: 178mm; margin: 0 auto; }
main > section.page { break-before: page; }
/* Of a heading that wraps, the bookmark keeps the space only if the page does. */
h1, h2, h3, h4 { break-after: avoid; white-space: break-spaces; }
p, li, pre { orphans: 3; widows: 3; }
tr, dt, mjx-container[display], img, svg, .sweep [data-frame] { break-inside: avoid; }
dt { break-after: avoid; }
/* Letters of figures are as large as the text's, and what a figure does not need is not left empty. */
.picture svg, .sweep svg { zoom: 0.75; min-width: 0; }
.sweep { display: flex; flex-wrap: wrap; justify-content: center; gap: 0.5rem; }
.sweep [data-frame] { flex: 0 1 calc(50% - 0.5rem); }
.sweep [data-frame].wide { flex-basis: 100%; }
pre { white-space: pre-wrap !important; font-size: 9.5px !important; line-height: 1.3; }
"""
WIDE = 620  # pixels of a figure that needs the page's whole width
ANSWERS = "div.solution, #quiz details, #quiz .dropdown"


def prefixed(page: Path, anchor: str) -> str:
    """The name of an anchor of a page among those of all pages."""
    return f"{page.stem}--{anchor}" if anchor else page.stem


def joined(site: Path, pages: list[Path]) -> str:
    """The pages of a built site as one HTML document in its folder, whose links lead within it."""
    known = {(site / page).resolve() for page in pages}
    first = BeautifulSoup((site / pages[0]).read_text("utf-8"), "html.parser")
    main, formulas = first.new_tag("main"), None
    for page in pages:
        whole = BeautifulSoup((site / page).read_text("utf-8"), "html.parser")
        article = whole.select_one("article.bd-article")
        assert isinstance(article, Tag), f"{page} has no article"
        if not formulas and (formulas := mathjax(whole)):  # only pages with formulas have it
            head = formulas[-1].parent
            assert head is not None
            relink(head, page, site, known)
        for tag in article.select(GOES):
            tag.decompose()
        for tag in article.select("details"):
            tag["open"] = ""
        for sweep in article.select("figure.sweep"):
            shown(sweep, first)
        answered(article, first)
        for tag in article.select("[id]"):
            tag["id"] = prefixed(page, str(tag["id"]))
        relink(article, page, site, known)
        section = first.new_tag("section", attrs={"class": "page", "id": prefixed(page, "")})
        section.extend(list(article.contents))
        main.append(section)
    assert first.body is not None
    assert first.head is not None
    first.body.clear()
    first.body.append(main)
    for tag in first.head.select("script"):
        tag.decompose()
    relink(first.head, pages[0], site, known)
    first.head.extend(formulas or [])
    if first.title and first.title.string:
        first.title.string = first.title.string.partition(" — ")[0]
    style = first.new_tag("style")
    style.string = STYLE
    first.head.append(style)
    return str(first)


def mathjax(page: BeautifulSoup) -> list[Tag]:
    """The scripts of a page's head that set its formulas; [] on a page without any."""
    return [tag for tag in page.select("head script") if "mathjax" in f"{tag.get('src', '')} {tag.text}".lower()]


def answered(article: Tag, page: BeautifulSoup) -> None:
    """Solutions of exercises and answers to the quiz move to a section at the chapter's end; the questions stay."""
    answers = article.select(ANSWERS)
    if not answers:
        return
    section, heading = page.new_tag("section", attrs={"id": "solutions"}), page.new_tag("h2")
    heading.string = "Solutions"
    section.append(heading)
    for answer in answers:
        if answer.find_parent(id="quiz"):
            question = answer.select_one(".sd-summary-text, summary, .admonition-title")
            assert question is not None, "an answer of the quiz without its question"
            asked = page.new_tag("p")
            asked.extend(copy.copy(part) for part in question.contents)
            answer.insert_before(asked)
        section.append(answer.extract())
    (article.select_one("section") or article).append(section)


def shown(sweep: Tag, page: BeautifulSoup) -> None:
    """Of a slider's frames the first, the chosen and the last, each with its value and note below."""
    frames, label = sweep.select("[data-frame]"), sweep.select_one("label")
    label = label.extract() if label else None
    for tag in sweep.select(".sweep-bar, .sweep-note"):
        tag.decompose()
    for i, frame in enumerate(frames):
        if frame.has_attr("hidden") and 0 < i < len(frames) - 1:
            frame.decompose()
            continue
        del frame["hidden"]
        if any(float(width) > WIDE for width in re.findall(r"max-width:(\d+)px", str(frame.select_one("svg")))):
            frame["class"] = "wide"
        caption = page.new_tag("p", attrs={"class": "sweep-note"})
        words = (label.text if label else "", ": ", frame["data-value"], ". ", frame.get("data-note", ""))
        caption.string = "".join(map(str, words))
        frame.append(caption)


def relink(part: Tag, page: Path, site: Path, known: set[Path]) -> None:
    """All links of a part of a page as they are in the joined document, which lies in the site's own folder."""
    for tag in part.select("[href], [src]"):
        name = "href" if tag.has_attr("href") else "src"
        tag[name] = moved(str(tag[name]), (site / page).resolve(), site, known)
        if tag.name == "a" and not re.match(r"#|[a-z]+:|//", str(tag["href"])):
            del tag["href"]  # a file beside the page, such as a download: it does not come with the PDF


def moved(link: str, file: Path, site: Path, known: set[Path]) -> str:
    """A link that stands in a file of the site as it is in the joined document; `known`: the files that it joins."""
    if re.match(r"[a-z]+:|//", link):
        return link
    path, _, anchor = link.partition("#")
    target = (file.parent / path.partition("?")[0]).resolve() if path else file
    if target in known:
        return "#" + prefixed(target, anchor)
    return target.relative_to(site.resolve()).as_posix() if target.is_relative_to(site.resolve()) else link


def main() -> int:
    """Write the PDF beside the site's other files; exit status 0 if it is there."""
    start, executable = time.perf_counter(), browser.browser_path()
    if executable is None:
        print("no Chromium found; install one (apt-get install chromium) or set BOOK_BROWSER", file=sys.stderr)
        return browser.SKIPPED
    if not (layout.SITE / "index.html").is_file():
        print("the site is not built yet: make book", file=sys.stderr)
        return 1
    pages = [page.relative_to(layout.ROOT).with_suffix(".html") for page in layout.pages()]
    layout.write_whole(layout.SITE / "print.html", joined(layout.SITE, pages).encode())
    with browser.chromium(executable) as chromium:
        page = chromium.new_page(color_scheme="light")
        page.set_default_timeout(1_800_000)
        browser.load(page, (layout.SITE / "print.html").as_uri())
        page.evaluate("() => { document.documentElement.dataset.theme = 'light'; return document.fonts.ready; }")
        content = page.pdf(
            prefer_css_page_size=True,
            print_background=True,
            outline=True,
            tagged=True,
            display_header_footer=True,
            header_template="<span></span>",
            footer_template='<div style="width: 100%; text-align: center; font-size: 8px" class="pageNumber"></div>',
        )
    (layout.SITE / "print.html").unlink()
    layout.write_whole(layout.SITE / PDF, content)
    landing = layout.SITE / "book" / "index.html"
    link = f'<span id="pdf">, or <a href="../{PDF}">as a PDF</a></span>'
    layout.write_whole(landing, re.sub(r'<span id="pdf">.*?</span>', link, landing.read_text("utf-8")).encode())
    print(f"the PDF: {layout.SITE / PDF}  ({len(content) / 1e6:.1f} MB, {time.perf_counter() - start:.0f} s)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
