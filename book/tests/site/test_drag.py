"""Figures with handles on the built pages: the page's script goes on from what Python drew and said."""

from typing import Any

import pytest

from book.tests.site.live_page import address
from book.tests.test_dragging import HELD, goes_on
from book.tools import browser, layout

PAGES = [file for file in layout.notebooks() if '"drag(' in file.read_text("utf-8")]


@pytest.mark.parametrize("file", PAGES, ids=[file.stem for file in PAGES])
def test_the_script_goes_on_from_what_python_drew(file: Any, page: Any, site: str, outside: list[str]) -> None:
    browser.load(page, f"{site}/{address(file)}")
    assert page.locator("figure.drag").count()
    page.wait_for_function(HELD)
    goes_on(page, (layout.SITE / address(file)).read_text("utf-8"))
