"""Plain data: what is written is read again, and a wrong key is named by its path, with what it should be."""

import json
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np
import pytest

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.experiments.presets import PRESETS, Preset, preset
from slamlib.plain_data.fields import OneOf, Range, check, read, written
from slamlib.plain_data.files import read_text


@dataclass(frozen=True)
class Wheel:
    radius: Annotated[float, Range(gt=0, unit="m")]
    spokes: Annotated[int, Range(ge=3)] | None = 8

    def __post_init__(self):
        check(self)


@dataclass(frozen=True)
class Cart:
    wheels: tuple[Wheel, ...] = ()
    pull: Annotated[str, OneOf(("horse", "mule"))] = "horse"
    size: tuple[float, float] = (1.0, 2.0)
    weights: tuple[float, ...] = ()
    new: bool = True
    load: dict[str, Any] = field(default_factory=dict)
    owner: str | Wheel | None = None


CART = Cart((Wheel(0.5), Wheel(0.4, None)), "mule", weights=(1.0,), load={"hay": (1, (2, 3))}, owner="me")


def test_it_comes_back_from_json():
    assert read(Cart, json.loads(json.dumps(written(CART)))) == CART
    assert "spokes" not in written(CART)["wheels"][1]
    assert read(Cart, {"owner": {"radius": 1}}).owner == Wheel(1, None)


@pytest.mark.parametrize("name", PRESETS)
def test_presets_come_back(name):
    assert Preset.from_dict(json.loads(json.dumps(preset(name).to_dict()))) == preset(name)


def test_lists_arrays_and_one_number_for_all_become_tuples():
    assert read(Cart, {"size": [3, 4], "weights": 5.0, "load": {"x": [1]}}) == Cart(
        (), size=(3, 4), weights=(5.0,), load={"x": (1,)}
    )
    wheel = Wheel(np.float64(0.5), np.int64(6))
    assert [type(v) for v in (wheel.radius, wheel.spokes)] == [float, int]
    assert read(Cart, {"weights": np.arange(2.0)}).weights == (0.0, 1.0)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"wheel": []}, "unknown key of Cart 'wheel'; did you mean 'wheels'"),
        ({"wheels": [{"radius": 1}, {"spoks": 1}]}, r"unknown key of Cart\.wheels\[1\] 'spoks'; did you mean 'spokes'"),
        ({"wheels": [{}]}, r"Cart\.wheels\[0\]: radius is missing"),
        ({"wheels": [{"radius": -1}]}, r"Cart\.wheels\[0\]\.radius should be above 0 \[m\], got -1"),
        ({"wheels": [{"radius": 1, "spokes": 2}]}, r"spokes should be 3 or more, got 2"),
        ({"wheels": [{"radius": 1, "spokes": 3.5}]}, r"spokes should be a whole number, got 3\.5"),
        ({"wheels": 3}, r"Cart\.wheels should be a list, got 3"),
        ({"pull": "hose"}, r"unknown Cart\.pull 'hose'; did you mean 'horse'"),
        ({"size": [1]}, r"Cart\.size should be 2 values, got \[1\]"),
        ({"size": [1, "a"]}, r"Cart\.size\[1\] should be a number, got 'a'"),
        ({"weights": [1, True]}, r"Cart\.weights\[1\] should be a number, got True"),
        ({"new": 1}, r"Cart\.new should be True or False, got 1"),
        ({"load": [1]}, r"Cart\.load should be values by name"),
        ({"load": {1: 2}}, r"Cart\.load should be a text, got 1"),
        ([], "Cart should be values by name"),
    ],
)
def test_a_wrong_key_is_named_by_its_path(data, said):
    with pytest.raises(SlamlibError, match=said):
        read(Cart, data)


def test_nested_plain_data_of_a_preset_is_checked():
    data = preset("stereo").to_dict()
    data["rig"]["sensors"][1]["eular"] = (0, 0, 0)
    with pytest.raises(UnknownNameError, match=r"preset\.rig\.sensors\[1\] 'eular'; did you mean 'euler'"):
        Preset.from_dict(data)
    with pytest.raises(SlamlibError, match=r"key of preset\.faults 'mis'"):
        Preset.from_dict({**preset("stereo").to_dict(), "faults": {"mis": 0.1}})


def test_without_a_limit_a_number_is_finite():
    with pytest.raises(SlamlibError, match="finite"):
        Range(gt=-np.inf, lt=np.inf).check(np.nan, "x")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_text_is_read_in_the_encoding_that_its_mark_says(tmp_path, encoding):
    path = tmp_path / "text.txt"
    path.write_bytes("größe: 1\r\nnext\r".encode(encoding))
    assert read_text(path) == "größe: 1\nnext\n"


def test_a_comment_in_another_encoding_does_no_harm_and_binary_data_are_no_text(tmp_path):
    path = tmp_path / "text.txt"
    path.write_bytes("# Größe\n1 2\n".encode("latin-1"))
    assert read_text(path).splitlines()[1] == "1 2"
    path.write_bytes(bytes(range(256)))
    with pytest.raises(SlamlibError, match="binary"):
        read_text(path)
    with pytest.raises(SlamlibError, match="cannot be read: No such file"):
        read_text(tmp_path / "none.txt")
