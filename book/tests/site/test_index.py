"""What is in the site's own search, its index, the inventory for other documentation, and its archives."""

import json
import re
import zipfile

import pytest
from sphinx.util.inventory import InventoryFile

from book.tools import browser, layout

TERMS = re.findall(r"(?m)^(\S.*)\n  ", (layout.BOOK / "appendices" / "glossary.md").read_text("utf-8"))


def test_the_index_has_the_terms_of_the_glossary_and_the_names_of_the_packages():
    text = re.sub(r"<[^>]+>", "", (layout.SITE / "genindex.html").read_text("utf-8"))
    assert [term for term in TERMS if term not in text] == []
    for name in ("Belief (class in slamlib.belief)", "(in module slamlib.geometry.pose)", "CovarianceError"):
        assert name in text


def test_other_documentation_finds_names_here():
    with (layout.SITE / "objects.inv").open("rb") as file:
        found = InventoryFile.load(file, "", lambda start, end: start + end)
    assert found["py:class"]["slamlib.belief.Belief"][2].endswith("appendices/api/core.html#slamlib.belief.Belief")
    assert "slamlib.slam.Slam" in found["py:class"]  # by the name that it is imported by, too
    assert {term.lower() for term in TERMS} <= {term.lower() for term in found["std:term"]}


@pytest.mark.parametrize("word", ["gauge freedom", "search backoff", "innovation"])
def test_the_search_finds_a_term_where_it_is_explained(context, site, word):
    page = context.new_page()
    browser.load(page, f"{site}/search.html?q={word.replace(' ', '+')}")
    page.wait_for_selector("#search-results li a[href*='appendices/glossary.html#term']")


def test_a_cells_pictures_are_one_archive_with_whose_they_are():
    live = layout.SITE / "_static" / "live"
    listed = json.loads((live / "manifest.json").read_text("utf-8"))
    archives = [name for name in listed["files"] if name.startswith("pictures/")]
    for archive in archives:
        with zipfile.ZipFile(live / archive) as packed:
            names = packed.namelist()
            for name in names:
                assert packed.read(name) == (layout.BOOK / "chapters" / name).read_bytes()
        assert f"{archive.removesuffix('.zip')}/ATTRIBUTION.txt" in names
        assert archive not in (*listed["first"], *listed["data"])  # fetched when a cell asks for it
    assert archives == ["pictures/tum_fr1_xyz.zip"]
