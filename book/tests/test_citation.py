"""CITATION.cff claims no release that the change log does not know."""

import re

import yaml

from book.tools import layout


def test_a_version_that_is_cited_is_one_that_was_released():
    cited = yaml.safe_load((layout.ROOT / "CITATION.cff").read_text("utf-8"))
    released = dict(re.findall(r"(?m)^## \[?([\d.]+)\]? - (\S+)$", (layout.ROOT / "CHANGELOG.md").read_text("utf-8")))
    assert ("version" in cited) == ("date-released" in cited) == bool(released)
    assert not released or str(cited["date-released"]) == released[str(cited["version"])]
