"""The search finds what students ask for, in the place that treats it: titles first, whole words, and no code."""

import functools
import gzip
import json
import re
import unicodedata
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
from sphinx.search.en import SearchEnglish

from book.tests.site.live_page import address, live_pages
from book.tools import browser, layout

# A question, the page or the place in it that treats it, and among how many of the first results it must be.
QUESTIONS = [
    ("inverse depth", "chapters/points.html", 1),
    ("gain", "chapters/kalman_filter.html", 1),
    ("Plucker lines manual", "sources/the_manuals.html", 3),
    ("Plücker lines manual", "sources/the_manuals.html", 3),
    ("Plucker coordinates", "chapters/lines.html", 1),
    ("quaternion", "chapters/frames_and_quaternions.html", 1),
    ("Rodrigues", "chapters/frames_and_quaternions.html#rodrigues-formula", 1),
    ("Euler angles", "chapters/frames_and_quaternions.html#euler-angles-for-people", 3),
    ("joint compatibility", "chapters/data_association.html#joint-compatibility", 1),
    ("one-point RANSAC", "chapters/data_association.html#one-point-is-enough", 3),
    ("RANSAC", "chapters/visual_odometry.html", 3),
    ("loop closing", "chapters/ekf_slam.html#a-loop-closes", 3),
    ("loop closure", "chapters/monocular.html", 3),
    ("relocalization", "chapters/monocular.html#loss-and-relocalization", 1),
    ("scale drift", "chapters/monocular.html", 1),
    ("NEES", "chapters/consistency.html", 1),
    ("chi-square", "chapters/consistency.html#how-far-from-n-is-too-far", 3),
    ("Mahalanobis", "chapters/gaussians.html#from-the-matrix-to-an-ellipse", 3),
    ("innovation", "chapters/kalman_filter.html", 1),
    ("Joseph form", "chapters/kalman_filter.html#does-the-joseph-form-matter", 1),
    ("what is a Jacobian", "chapters/proving_a_jacobian.html", 3),
    ("complex step", "chapters/proving_a_jacobian.html#tool-2-the-complex-step", 1),
    ("first-estimates Jacobian", "chapters/observability.html#first-estimates-and-constraints", 1),
    ("observability", "chapters/observability.html", 1),
    ("dead reckoning", "chapters/slam_in_five_minutes.html#without-looking-lost", 3),
    ("unscented", "chapters/other_filters.html#better-straight-lines-the-unscented-filter", 1),
    ("particle filter", "chapters/other_filters.html#particles-fastslam", 1),
    ("stereo baseline", "chapters/depth_stereo_range.html", 3),
    ("distortion", "chapters/pinhole.html", 1),
    ("pinhole", "chapters/pinhole.html", 1),  # the book writes pin-hole
    ("fisheye", "chapters/omnidirectional.html#the-fisheye-of-calibration-files", 1),
    ("anchored homogeneous point", "chapters/points.html#five-ways-to-hold-the-point", 1),
    ("linearity index", "chapters/points.html#when-to-convert-the-linearity-index", 1),
    ("marginalization", "chapters/stochastic_map.html#removing-a-landmark-is-marginalization-and-it-is-exact", 1),
    ("extrinsics", "chapters/many.html", 1),
    ("bicycle", "chapters/your_own_model.html#a-motion-of-your-own-a-bicycle", 1),
    ("how do I install slamlib", "appendices/using_slamlib.html#installing", 1),
]
FIRST = 3
ASK = """(query) => {
  document.getElementById('search-results').replaceChildren();
  Search.performSearch(query);
  const results = [...document.querySelectorAll('#search-results li')];
  return [Search.status.textContent, results.map(e => e.querySelector('a').getAttribute('href'))];
}"""
TEXT = """async ([page, anchor]) => {
  const read = new DOMParser().parseFromString(await (await fetch(page)).text(), 'text/html');
  const place = anchor ? read.getElementById(anchor) : read.querySelector('article');
  const below = place.matches('dt') ? place.nextElementSibling.textContent : '';
  return `${read.querySelector('h1').textContent} ${place.textContent} ${below}`;
}"""
ENGLISH = SearchEnglish({})
stem = functools.cache(ENGLISH.stem)


def stems(text: str) -> set[str]:
    """The words of a text without accents and endings; of words with a hyphen also what they are without it."""
    plain = "".join(c for c in unicodedata.normalize("NFD", text.lower()) if not unicodedata.combining(c))
    return {stem(word) for word in {*re.findall(r"\w+", plain), *re.findall(r"\w+", plain.replace("-", ""))}}


@pytest.fixture(scope="module")
def page(site: str, browser: Any) -> Iterator[Any]:
    """The search page, opened once."""
    page = browser.new_page()
    page.goto(f"{site}/search.html?q=filter")
    page.wait_for_selector("#search-results li")
    yield page
    page.close()


def found(page: Any, query: str) -> list[str]:
    """The addresses of the results, best first, as they are below the folder of the book."""
    return [href.removeprefix("./").removeprefix("book/") for href in page.evaluate(ASK, query)[1]]


@pytest.mark.parametrize(("query", "wanted", "first"), QUESTIONS, ids=[query for query, _, _ in QUESTIONS])
def test_a_question_finds_the_place_that_treats_it(query, wanted, first, page):
    results = found(page, query)
    places = results if "#" in wanted else [result.partition("#")[0] for result in results]
    assert wanted in places[:first], f"{query}: found {results[:8]}"


@pytest.mark.parametrize("query", [query for query, _, _ in QUESTIONS])
def test_a_result_leads_to_a_place_that_holds_the_words(query, page, site):
    asked = stems(query.replace("-", " ")) - ENGLISH.stopwords - {"what", "how", "do", "i"}
    for result in found(page, query)[:FIRST]:
        file, _, anchor = result.partition("#")
        text = stems(page.evaluate(TEXT, [f"{site}/book/{file}", anchor]))
        assert text >= asked, f"{result} lacks {asked - text}"


def test_a_heading_is_found_first_by_its_words(page):
    """19 in 20 of the headings that the chapters have once; the others are as "The model", which suits many places."""
    index = {url.removeprefix("book/"): rows for url, rows in places().items() if "/chapters/" in url}
    times = Counter(row[2] for rows in index.values() for row in rows)
    wanted = {
        row[2]: f"{url}#{row[1]}".removesuffix("#")
        for url, rows in index.items()
        for row in rows
        if row[0] in ("page", "section") and times[row[2]] == 1
    }
    first = {heading: found(page, heading)[0] for heading in wanted}
    missed = [heading for heading, place in wanted.items() if not first[heading].startswith(place)]
    assert len(wanted) > 300
    assert len(missed) < 0.05 * len(wanted), missed
    titles = {rows[0][2] for rows in index.values()}
    assert len(titles) > 20
    assert titles.isdisjoint(missed)


@pytest.mark.parametrize(("word", "inside"), [("IMU", "simulation"), ("gain", "against"), ("rank", "Frank")])
def test_a_word_is_not_found_inside_another_one(word, inside, page):
    index = {url.removeprefix("book/"): json.dumps(rows, ensure_ascii=False).lower() for url, rows in places().items()}
    assert any(inside.lower() in text for text in index.values())
    own = {url for url, text in index.items() if stem(word.lower()) in stems(text)}
    assert len(own) < len(index)
    assert {result.partition("#")[0] for result in found(page, word)} <= own


def test_a_glossary_term_comes_with_its_own_place(page):
    assert "appendices/glossary.html#term-gauge-freedom" in found(page, "gauge freedom")[:FIRST]
    assert found(page, "gauge freedoms")[:FIRST] == found(page, "gauge freedom")[:FIRST]


def test_what_is_not_there_is_said(page):
    assert page.evaluate(ASK, "xyzzy") == ["No page has these words.", []]
    assert page.evaluate(ASK, "") == ["No page has these words.", []]
    said, results = page.evaluate(ASK, "quaternion xyzzy")
    assert said.startswith("No page has all of these words.")
    assert "frames_and_quaternions" in results[0]


def test_a_word_s_beginning_is_enough_where_there_is_no_such_word(page):
    assert found(page, "quatern")[0].startswith("chapters/frames_and_quaternions.html")


def places() -> dict[str, list[list[Any]]]:
    """The index: of each page the places, each with kind, anchor, heading and text."""
    text = (layout.SITE / "searchindex.js").read_text("utf-8")
    return json.loads(text.removeprefix("Search.setIndex(").removesuffix(")"))


def test_the_index_is_small_and_has_prose_and_captions_but_no_code_nor_what_it_prints():
    index = places()
    assert len(index) > 50
    text = json.dumps(index)
    assert len(gzip.compress((layout.SITE / "searchindex.js").read_bytes())) < 450_000
    for code in ("import numpy", "np.linspace(", "entries by symbolic difference"):
        assert code not in text
    assert any("Fig. " in row[3] for rows in index.values() for row in rows)
    points = " ".join(row[3] for row in index["book/chapters/points.html"])
    assert "Solution" not in {row[2].split()[0] for row in index["book/chapters/points.html"]}
    assert "idpPnt" in points  # code within a sentence is a word of it
    (notes,) = index["book/appendices/instructors_notes.html"]  # the title: its text would give answers away
    assert notes[2].startswith("Instructor")
    assert notes[3] == ""


def test_a_summary_is_of_the_place_and_marks_whole_words(page):
    page.evaluate(ASK, "gain")
    first = page.locator("#search-results li").first
    marked = first.locator(".context mark").all_inner_texts()
    assert marked
    assert {word.lower().rstrip("s") for word in marked} == {"gain"}
    assert len(first.locator(".context").inner_text()) < 300
    assert first.locator(".also a").count() > 0


def test_the_search_works_from_a_file_without_a_server(browser):
    page = browser.new_page()
    page.goto(f"{(layout.SITE / 'search.html').as_uri()}?q=inverse+depth")
    page.wait_for_selector("#search-results li .context mark")
    page.locator("#search-results li a").first.click()
    page.wait_for_url("**/chapters/points.html#*")
    page.close()


@pytest.mark.parametrize(("width", "kind"), [(1280, "field"), (390, "button")])
def test_the_search_is_at_hand_wherever_one_reads(width, kind, site, browser):
    page = browser.new_page(viewport={"width": width, "height": 800})
    page.goto(f"{site}/{address(live_pages()[-1])}")
    page.evaluate("() => scrollTo(0, document.documentElement.scrollHeight / 2)")
    button = page.locator(".search-button__button:visible")
    assert button.count() == 1
    assert 0 <= button.bounding_box()["y"] < 60
    assert ("Ctrl" in button.inner_text()) == (kind == "field")
    typed = page.locator(".search-button__search-container input")
    button.click()
    assert typed.is_visible()
    page.keyboard.press("Escape")
    assert not typed.is_visible()
    page.keyboard.press("Control+k")
    page.keyboard.type("loop closing")
    page.keyboard.press("Enter")
    page.wait_for_selector("#search-results li .context")
    page.close()


def test_no_other_page_loads_the_index(context, site):
    loaded: list[str] = []
    page = context.new_page()
    page.on("request", lambda request: loaded.append(request.url))
    browser.load(page, f"{site}/{address(live_pages()[0])}")
    assert not [url for url in loaded if "searchindex" in url or "/search.js" in url]
