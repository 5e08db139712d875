"""Block forms of Jacobians: those that chapters derive by hand are found, and a wrong one would not be."""

import numpy as np
import pytest
from slambook import block_forms
from slambook.block_forms import Place, Sum, block_form

from slamlib.geometry import plucker, pose, quaternion
from slamlib.landmarks.ahm_point import to_frame
from slamlib.motions import CONSTANT_VELOCITY, ODOMETRY

R_ = r"R^\top"


@pytest.mark.parametrize(
    ("model", "argument", "expected"),
    [
        (pose.to_frame, "pose", [["- R^\\top", "[p']_\\times"]]),
        (pose.compose, "outer", [["I", r"- R_1 [t_2]_\times"], ["0", r"R_2^\top"]]),
        (plucker.join, "second", [[r"[p]_\times", "0"], [r"c\, I", "- p"]]),
        (to_frame, "landmark", [[rf"\rho\, {R_}", R_, rf"{R_} (a - t)"], ["0", "0", "1"]]),
        (ODOMETRY.step, "control", [["R", "0"], ["0", "J_r"]]),
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
    form = Sum(((1, "", "I"), (-1, r"\lVert t\rVert", "R")))
    expected = np.eye(3) - np.linalg.norm(place.vectors["t"]) * place.turns["R"]
    np.testing.assert_allclose(form.at(place, (3, 3)), expected)
    assert str(form) == r"I - \lVert t\rVert\, R"
    assert str(Sum()) == "0"
