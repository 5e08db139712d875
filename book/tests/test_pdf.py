"""One page of all pages: names and links that fit, and what is only for a screen left out."""

from pathlib import Path

from bs4 import BeautifulSoup

from book.tools import pdf

FIRST = """<html><head><link href="style.css"><script src="only_a_screen.js"></script></head>
<body><article class="bd-article"><h1 id="top">A
<a class="headerlink" href="#top">#</a></h1><a href="second.html#there">there</a> <a href="#top">up</a>
<a href="https://example.org/x">out</a> <img src="plot.svg">
<a href="book.zip">download</a>
<details class="sd-dropdown"><p>aside</p></details>
<details class="hide"><pre>code</pre></details></article></body></html>
"""
SECOND = """<html><head><title>B — A</title><script src="mathjax/tex.js"></script></head>
<body><article class="bd-article"><h1 id="top">B</h1><p id="there">
<a href="first.html">back</a></p><figure class="sweep"><div class="sweep-bar"><label>angle</label></div>
<div data-frame="0" data-value="1" hidden>one</div><div data-frame="1" data-value="2" hidden>two</div>
<div data-frame="2" data-value="3" data-note="noted">three</div><div data-frame="3" data-value="4" hidden>four</div>
<p class="sweep-note">noted</p></figure>
<section id="chapter"><div class="solution"><p>solved</p></div>
<section id="quiz"><details><summary><span class="sd-summary-text">Why
<span class="math">x</span>?</span></summary><p>because</p></details></section><p>history</p></section>
</article></body></html>
"""


def joined(folder: Path) -> BeautifulSoup:
    """The two pages as one."""
    (folder / "first.html").write_text(FIRST, "utf-8")
    (folder / "second.html").write_text(SECOND, "utf-8")
    return BeautifulSoup(pdf.joined(folder, [Path("first.html"), Path("second.html")]), "html.parser")


def test_pages_become_one_whose_links_lead_within(tmp_path):
    page = joined(tmp_path)
    names = [tag["id"] for tag in page.select("[id]")]
    assert names[:5] == ["first", "first--top", "second", "second--top", "second--there"]
    links = [a.get("href") for a in page.select("a")]
    assert links == ["#second--there", "#first--top", "https://example.org/x", None, "#first"]
    assert page.select_one("img")["src"] == "plot.svg"
    assert "open" in page.select_one("details.sd-dropdown").attrs
    assert "code" not in page.text
    assert [p.text for p in page.select("figure.sweep p")] == ["angle: 1. ", "angle: 3. noted", "angle: 4. "]
    assert "two" not in page.text


def test_formulas_are_set_also_where_the_first_page_has_none(tmp_path):
    page = joined(tmp_path)
    assert [script["src"] for script in page.select("head script")] == ["mathjax/tex.js"]
    assert page.title.string == "A"


def test_answers_stand_at_the_end_of_their_chapter(tmp_path):
    chapter = joined(tmp_path).select_one("#second--chapter")
    questions = chapter.select_one("#second--quiz")
    assert questions.select_one("span.math").text == "x"
    assert "because" not in questions.text
    words = chapter.text
    assert words.index("history") < words.index("Solutions") < words.index("solved") < words.index("because")
