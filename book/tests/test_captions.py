"""Every figure has a caption of its own, and the text speaks of it."""

import re

import nbformat
import pytest
from docutils.nodes import make_id

from book.tests.site.live_page import stored_text
from book.tools import landing, layout

CAPTION = re.compile(r"\*\*Figure: ([^*]+)\.\*\* \S")
LINK = re.compile(r"\[[^\]]+\]\((?:\w+\.ipynb)?#(fig-[a-z0-9-]+)\)")
DRAWN = re.compile(r"^(?:Picture: |Sweep of |Figure with handles: |Player of |Film of )", re.MULTILINE)
PAGES = [file for file in layout.notebooks() if file != landing.PAGE]  # whose two figures stand beside its text


def cells(file):
    return nbformat.read(file, as_version=4).cells


def draws(cell):
    """Whether a picture, slider or player is among the outputs of a cell."""
    return cell.cell_type == "code" and DRAWN.search(stored_text(cell)) is not None


def captions(file):
    """The labels of the captions of a page."""
    return ["fig-" + make_id(found[1]) for c in cells(file) if (found := CAPTION.match(c.source))]


@pytest.mark.parametrize("file", PAGES, ids=lambda file: file.stem)
def test_each_figure_has_a_caption_that_the_text_refers_to(file):
    found = cells(file)
    for cell, after in zip(found, [*found[1:], None], strict=True):
        has = after is not None and after.cell_type == "markdown" and CAPTION.match(after.source) is not None
        assert has == draws(cell), f"cell {cell.id}: a figure without a caption, or a caption without a figure"
    links = {label for c in found if c.cell_type == "markdown" for label in LINK.findall(c.source)}
    assert sorted(set(captions(file)) - links) == [], "figures that the text does not refer to"


def test_labels_are_told_apart_and_links_lead_to_one():
    labels = [label for file in PAGES for label in captions(file)]
    assert len(labels) == len(set(labels)) > 100
    links = {label for file in layout.notebooks() for c in cells(file) for label in LINK.findall(c.source)}
    assert sorted(links - set(labels)) == []
