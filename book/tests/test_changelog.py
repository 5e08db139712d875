"""The change log speaks of what there is: each name on its page is one of today, and the page stays a page."""

import importlib
import re
from functools import reduce

import pytest
from slambook.exercises import load_all

from book.tools import layout
from slamlib import cli

LOG = layout.ROOT / "CHANGELOG.md"
SPANS = sorted(set(re.findall(r"`([^`\n]+)`", LOG.read_text("utf-8"))))
PROGRAMS = ("slamlib", "make", "pip", "python")  # whose arguments book/tests/test_commands.py checks
NAMES = [s for s in SPANS if re.search(r"[./]|^--", s) and s.split()[0] not in PROGRAMS]
PROSE = " ".join(LOG.read_text("utf-8").split())


def attribute(name: str) -> bool:
    """Whether it is a module, or an attribute of one, however deep."""
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        try:
            found = importlib.import_module(".".join(parts[:count]))
        except ImportError:
            continue
        try:
            reduce(getattr, parts[count:], found)
        except AttributeError:
            return False
        return True
    return False


def exists(name: str) -> bool:
    """Whether it is a module or an attribute, an option of the command, an exercise, or a file of the repository."""
    if name.startswith("--"):
        choices = next(a.choices for a in cli.parser()._actions if a.dest == "command")
        return any(name.split()[0] in command._option_string_actions for command in choices.values())
    return attribute(name) or name in load_all() or (layout.ROOT / name).exists()


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_one_of_today(name):
    assert exists(name)


@pytest.mark.parametrize(
    "name",
    [
        *("slamlib.slam.Slma", "slamlib.tangle", "slamlib.slam.Options.gates", "matplotlb.pyplot"),
        *("book/report", "kalman_filter.99", "--refrence-std"),
    ],
)
def test_a_name_that_is_gone_is_found(name):
    assert not exists(name)


def test_it_is_one_page_says_that_there_was_no_release_and_gives_no_address():
    assert len(NAMES) > 10
    assert len(PROSE.split()) < 1100
    assert re.findall(r"^## (.*)$", LOG.read_text("utf-8"), re.M) == ["Unreleased"]
    assert "://" not in PROSE


def test_the_history_says_that_its_names_may_be_gone_and_is_no_page_of_the_site():
    history = layout.BOOK / "history.md"
    assert "names in them are gone" in history.read_text("utf-8")[:300]
    assert "://" not in history.read_text("utf-8")
    assert history not in layout.pages()
    assert "book/history.md" in PROSE
