"""One list of what is needed: the extras of pyproject.toml, which requirements.txt locks."""

import re
import tomllib

import pytest
from packaging.requirements import Requirement
from packaging.version import Version

from book.tests.bare import extras
from book.tools import layout

LOCK = (layout.ROOT / "requirements.txt").read_text("utf-8")
PROJECT = tomllib.loads((layout.ROOT / "pyproject.toml").read_text("utf-8"))


def name(text: str) -> str:
    """As indexes compare names."""
    return re.sub(r"[-_.]+", "-", text).lower()


LOCKED = {name(n): Version(v) for n, v in re.findall(r"(?m)^([\w.-]+)(?:\[.*\])?==([^\s;\\]+)", LOCK)}
CONSTRAINTS = [Requirement(text) for text in PROJECT["tool"]["uv"]["constraint-dependencies"]]
ASKED = {str(r): r for r in [*map(Requirement, PROJECT["project"]["dependencies"]), *extras()["dev"]]}


def test_dev_includes_every_other_extra():
    assert {str(r) for asked in extras().values() for r in asked} == {str(r) for r in extras()["dev"]}


@pytest.mark.parametrize("requirement", list(ASKED.values()), ids=str)
def test_what_is_asked_for_is_locked_in_a_version_that_satisfies_it(requirement):
    assert requirement.specifier.contains(LOCKED[name(requirement.name)])


@pytest.mark.parametrize("constraint", CONSTRAINTS, ids=str)
def test_the_lock_keeps_its_own_constraints(constraint):
    assert constraint.specifier.contains(LOCKED[name(constraint.name)])


def test_the_lock_names_no_index():
    assert not re.search(r"://|--index|--extra-index|--find-links", LOCK)
