"""One page of all pages: names and links that fit, and what is only for a screen left out."""

from pathlib import Path

from bs4 import BeautifulSoup

from book.tools import pdf

FIRST = """<html><head><link href="style.css"></head><body><article class="bd-article"><h1 id="top">A
<a class="headerlink" href="#top">#</a></h1><a href="second.html#there">there</a> <a href="#top">up</a>
<a href="https://example.org/x">out</a> <img src="plot.svg">
<details class="sd-dropdown"><p>answer</p></details>
<details class="hide"><pre>code</pre></details></article></body></html>
"""
SECOND = """<html><head></head><body><article class="bd-article"><h1 id="top">B</h1><p id="there">
<a href="first.html">back</a></p><figure class="sweep"><div class="sweep-bar"><label>angle</label></div>
<div data-frame="0" data-value="1" hidden>one</div><div data-frame="1" data-value="2" hidden>two</div>
<div data-frame="2" data-value="3" data-note="noted">three</div><div data-frame="3" data-value="4" hidden>four</div>
<p class="sweep-note">noted</p></figure></article></body></html>
"""


def test_pages_become_one_whose_links_lead_within(tmp_path):
    (tmp_path / "first.html").write_text(FIRST)
    (tmp_path / "second.html").write_text(SECOND)
    page = BeautifulSoup(pdf.joined(tmp_path, [Path("first.html"), Path("second.html")]), "html.parser")
    names = [tag["id"] for tag in page.select("[id]")]
    assert names == ["first", "first--top", "second", "second--top", "second--there"]
    assert [a["href"] for a in page.select("a")] == ["#second--there", "#first--top", "https://example.org/x", "#first"]
    assert page.select_one("img")["src"] == "plot.svg"
    assert "open" in page.select_one("details.sd-dropdown").attrs
    assert "code" not in page.text
    assert [p.text for p in page.select("figure.sweep p")] == ["angle: 1. ", "angle: 3. noted", "angle: 4. "]
    assert "two" not in page.text
