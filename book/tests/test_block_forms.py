"""Block forms of Jacobians: those that chapters derive by hand are found, and a wrong one would not be."""

import json

import numpy as np
import pytest
from slambook import block_forms
from slambook.block_forms import Place, Sum, block_form

from book.tools import layout
from slamlib.codegen.trace import symbols_for
from slamlib.geometry import plucker, pose, quaternion
from slamlib.landmarks import idp_line
from slamlib.landmarks.ahm_point import to_frame
from slamlib.motions import CONSTANT_VELOCITY, ODOMETRY
from slamlib.sensors import omni

C_ = r"C^\top"


@pytest.mark.parametrize(
    ("model", "argument", "expected"),
    [
        (pose.to_frame, "pose", [["- C^\\top", "[p']_\\times"]]),
        (pose.compose, "outer", [["I", r"- C_1 [t_2]_\times"], ["0", r"C_2^\top"]]),
        (plucker.join, "second", [[r"[p]_\times", "0"], [r"c\, I", "- p"]]),
        (to_frame, "landmark", [[rf"\rho\, {C_}", C_, rf"{C_} (a - t)"], ["0", "0", "1"]]),
        (ODOMETRY.step, "control", [["C", "0"], ["0", "J_r"]]),
        (CONSTANT_VELOCITY.step, "dt", [["v"], [r"\omega"], ["0"], ["0"]]),
    ],
)
def test_what_chapters_derive_is_found(model, argument, expected):
    found = block_form(model, argument)
    assert [[" ".join(str(one).split()) for one in line] for line in found] == expected


def test_a_block_without_a_short_form_has_none():
    assert block_form(quaternion.logarithm, "q") == [[None]]


def test_what_holds_at_the_first_places_alone_is_no_form(monkeypatch):
    """A block that is named there, and not at the places of the test, is not taken for it."""
    named = []

    def search(blocks, places):
        named.append(len(blocks))
        return Sum(((1, "", "I"),))

    monkeypatch.setattr(block_forms, "search", search)
    assert block_form(pose.from_frame, "point") == [[None]]
    assert named == [block_forms.PLACES]


def test_a_sum_is_its_numbers():
    place = Place.random(pose.from_frame, np.random.default_rng(3))
    form = Sum(((1, "", "I"), (-1, r"\lVert t\rVert", "C")))
    expected = np.eye(3) - np.linalg.norm(place.vectors["t"]) * place.turns["C"]
    np.testing.assert_allclose(form.at(place, (3, 3)), expected)
    assert str(form) == r"I - \lVert t\rVert\, C"
    assert str(Sum()) == "0"


def catalogue(model):
    """The model's chain, by the catalogue's own cell."""
    cells = json.loads((layout.BOOK / "appendices" / "catalogue.ipynb").read_text("utf-8"))["cells"]
    (cell,) = ("".join(c["source"]) for c in cells if "class Chain:\n" in "".join(c["source"]))
    names: dict = {"__name__": __name__}
    exec(cell, names)
    return names["Chain"](model, [symbols_for(a) for a in model.arguments])


def test_a_model_that_calls_others_has_their_jacobians_as_factors():
    product = catalogue(omni.project).latex("point")
    assert product == " ".join(
        rf"\frac{{\partial\,\mathtt{{{name}}}}}{{\partial\,\mathtt{{{by}}}}}\,"
        for name, by in (("pixel", "angles"), ("angles", "point"))
    ).removesuffix(r"\,")
    assert "[r_2]" in catalogue(idp_line.from_frame).latex("pose")


def test_a_product_that_is_not_the_generated_jacobian_is_refused():
    chain = catalogue(omni.project)
    chain.places = block_forms.places_of(omni.project)
    chain.places[-1].jacobians = chain.places[-1].jacobians._replace(point=np.zeros((2, 4)))
    with pytest.raises(AssertionError, match="Not equal"):
        chain.latex("point")
