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
GOES = ".prev-next-footer, .headerlink, .copybtn, .toctree-wrapper, script, details.hide"  # what only a screen needs
STYLE = layout.BOOK / "_static" / "print.css"
WIDE = r"max-width:([6-9]\d\d|\d{4})px"  # a figure that needs the page's whole width
ANSWERS = "div.solution, #quiz details, #quiz .dropdown"


def prefixed(page: Path, anchor: str) -> str:
    """The name of an anchor of a page among those of all pages."""
    return f"{page.stem}--{anchor}" if anchor else page.stem


def joined(site: Path, pages: list[Path]) -> str:
    """The pages of a built site as one HTML document in its folder, whose links lead within it."""
    known = {(site / page).resolve() for page in pages}
    wholes = {page: BeautifulSoup((site / page).read_text("utf-8"), "html.parser") for page in pages}
    # The head that all share is that of a page with formulas: only there is the script that sets them.
    where = next((page for page in pages if wholes[page].select("script[src*=mathjax]")), pages[0])
    first = wholes[where]
    main = first.new_tag("main")
    for page, whole in wholes.items():
        article = whole.select_one("article.bd-article")
        assert isinstance(article, Tag), f"{page} has no article"
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
    head, body = first.select("head")[0], first.select("body")[0]
    body.clear()
    body.append(main)
    for tag in head.select("script:not([src*=mathjax])"):
        if "MathJax" not in tag.text:
            tag.decompose()
    relink(head, where, site, known)
    for title in head.select("title"):
        title.string = title.text.rpartition(" — ")[2]
    head.append(first.new_tag("style", string=STYLE.read_text("utf-8")))
    return str(first)


def answered(article: Tag, page: BeautifulSoup) -> None:
    """Solutions of exercises and answers to the quiz move to a section at the chapter's end; the questions stay."""
    answers, end = article.select(ANSWERS), page.new_tag("section", attrs={"id": "solutions"})
    for answer in answers:
        if answer.find_parent(id="quiz"):
            question = copy.copy(answer.select(".sd-summary-text, .admonition-title")[0])
            question.name, question["class"] = "p", "question"
            answer.insert_before(question)
        end.append(answer.extract())
    if answers:
        end.insert(0, page.new_tag("h2", string="Solutions"))
        (article.select_one("section") or article).append(end)


def shown(sweep: Tag, page: BeautifulSoup) -> None:
    """Of a slider's frames the first, the chosen and the last, each with its value and note below."""
    frames, label = sweep.select("[data-frame]"), "".join(tag.text for tag in sweep.select("label"))
    for tag in sweep.select(".sweep-bar, .sweep-note"):
        tag.decompose()
    for i, frame in enumerate(frames):
        if frame.has_attr("hidden") and 0 < i < len(frames) - 1:
            frame.decompose()
            continue
        del frame["hidden"]
        frame["class"] = "wide" if re.search(WIDE, str(frame)) else "narrow"
        words = f"{label}: {frame['data-value']}. {frame.get('data-note', '')}"
        frame.append(page.new_tag("p", attrs={"class": "sweep-note"}, string=words))


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
        page.evaluate(STYLE.with_suffix(".js").read_text("utf-8"))
        content = page.pdf(prefer_css_page_size=True, print_background=True, outline=True, tagged=True)
    (layout.SITE / "print.html").unlink()
    layout.write_whole(layout.SITE / PDF, content)
    landing = layout.SITE / "book" / "index.html"
    link = f'<span id="pdf">, or <a href="../{PDF}">as a PDF</a></span>'
    layout.write_whole(landing, re.sub(r'<span id="pdf">.*?</span>', link, landing.read_text("utf-8")).encode())
    print(f"the PDF: {layout.SITE / PDF}  ({len(content) / 1e6:.1f} MB, {time.perf_counter() - start:.0f} s)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
