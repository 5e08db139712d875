"""The catalogue of Jacobians: its contents, and the common chains that it writes as products of factors."""

import json
import re
from typing import Any

import numpy as np
import pytest

from book.tools import layout
from slamlib.codegen.__main__ import models

CELLS = {
    cell["id"]: cell
    for cell in json.loads((layout.BOOK / "appendices" / "catalogue.ipynb").read_text("utf-8"))["cells"]
}
CHAINS = "pin-hole camera"  # where the contents list the chains
LINK = re.compile(r'<a href="#([^"]+)">([^<]+)</a>')


def shown(cell: str) -> str:
    """The Markdown that a cell has stored."""
    return "".join("".join(output["data"]["text/markdown"]) for output in CELLS[cell]["outputs"])


def headings() -> dict[str, str]:
    """The headings of chains and models, by the anchors that Sphinx gives them."""
    from docutils.nodes import make_id

    text = shown("cat-chains-shown") + "\n" + shown("cat-002")
    return {make_id(title): title for title in re.findall(r"^### `?([^`\n]+)`?$", text, re.MULTILINE)}


def test_the_contents_list_every_model_once_by_a_link_to_its_section():
    lines = [line.removeprefix("  - ") for line in shown("cat-contents-list").splitlines() if line.startswith("  - ")]
    links = [(line.split(":")[0], *link) for line in lines for link in LINK.findall(line)]
    listed = {anchor: f"{module}.{words}" for module, anchor, words in links if module != CHAINS}
    names = [f"{m.module.removeprefix('slamlib.')}.{m.name}" for own in models().values() for m in own]
    there = headings()
    assert sorted(listed.values()) == sorted(names)
    assert all(there[anchor] == name for anchor, name in listed.items())
    assert [there[anchor].split(" through ")[0] for module, anchor, _ in links if module == CHAINS] == [
        words for module, _, words in links if module == CHAINS
    ]
    assert sorted(anchor for _, anchor, _ in links) == sorted(there)
    assert "Other models" not in shown("cat-contents-list"), "a module of no subject: name it in SUBJECTS"


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    """What the cells of the contents and of the chains define, after their own checks."""
    found: dict[str, Any] = {"__name__": __name__, "display": lambda _: None}
    for cell in ("cat-contents-list", "cat-chains-shown"):
        exec("".join(CELLS[cell]["source"]).replace("Markdown, display", "Markdown"), found)
    return found


@pytest.mark.parametrize("chain", range(4))
def test_a_product_that_is_not_the_jacobian_is_refused(names, chain):
    observed = names["CHAINS"][chain]
    right = dict(observed.jacobians)
    for by in right:
        observed.jacobians[by] = -right[by]
        with pytest.raises(AssertionError, match="Not equal"):
            names["check"](observed)
        observed.jacobians[by] = right[by]


def test_a_step_that_is_not_the_model_is_refused(names):
    observed, t = names["CHAINS"][0], names["t"]
    wrong = [{**observed.lines[0], t: -observed.lines[0][t]}, *observed.lines[1:]]
    chain = names["Observed"](observed.kind, observed.landmark, wrong, observed.value, observed.jacobians, "")
    with pytest.raises(AssertionError, match="Not equal"):
        names["check"](chain)


def test_what_is_shown_is_what_is_checked(names):
    """The text of a product is made with its value: the same letters, in the same order."""
    C, h, blocks = names["C"], names["h"], names["blocks"]
    product = C.T * (h - names["t"])
    assert product.text == r"C^\top\, (h - t)"
    numbers = dict(zip([*C.value, *h.value, *names["t"].value], np.arange(15.0), strict=True))
    expected = np.arange(9.0).reshape(3, 3).T @ (np.full(3, -3.0))
    np.testing.assert_allclose(names["numbers"](product, numbers).ravel(), expected)
    assert blocks([C, -h]).text == r"\left[\begin{array}{c|c} C & -h \end{array}\right]"
    assert blocks([C, -h]).value.shape == (3, 4)
