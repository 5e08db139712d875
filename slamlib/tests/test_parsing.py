"""Texts as plain data, whoever wrote them; and their named values, each of which must be asked for."""

import json

import pytest

from slamlib.errors import SlamlibError
from slamlib.plain_data.entries import Entries
from slamlib.plain_data.parsing import parsed

yaml = pytest.importorskip("yaml", reason="PyYAML reads YAML")
DATA = {"a": [[1.0, 2e-05], [3, -4.5]], "b": {"words": "two words", "yes": True, "none": None}, "c": [], "d": "12:30"}

XML = "<?xml version='1.0'?>\n<s><k>1. 2</k><w>\"a b\"</w><l><_>1</_><_>2</_></l></s>"
SECTIONS = "[A_LEFT]\nd = [-3.7e-001 0.5]  // K1 K2\n[B]\nr = [1 2 ;3 4 ]\nn=a.b\n"


@pytest.mark.parametrize("flow", [True, False, None])
def test_what_pyyaml_writes_is_read_back(flow):
    shared = {**DATA, "again": DATA["a"]}  # an anchor
    text = yaml.dump(shared, default_flow_style=flow)
    assert "&id001" in text
    assert parsed(text) == shared


def test_json_and_toml_are_read():
    assert parsed(json.dumps(DATA, indent=1)) == DATA
    assert parsed("size = [640, 480]\n[lens]\nk = 1.5 # and more\n") == {"size": [640, 480], "lens": {"k": 1.5}}


@pytest.mark.parametrize(
    ("text", "data"),
    [
        ("%YAML:1.0\n---\nk: !!opencv-matrix\n  rows: 1\n  dt: d\n", {"k": {"rows": 1, "dt": "d"}}),
        ("k:\t1e-3\r\nm:\n\tn: .5\n", {"k": 1e-3, "m": {"n": 0.5}}),
        ("k3:0.1\nd:[1, 2]\n", {"k3": 0.1, "d": [1, 2]}),  # OpenCV reads these, too
        ("a: &x {k: 1, l: 2}\nb:\n  <<: *x\n  l: 3\n", {"a": {"k": 1, "l": 2}, "b": {"k": 1, "l": 3}}),
        ("k: 1 # one\nl: '1'\n", {"k": 1, "l": "1"}),
        ("k: 1\n---\nk: 1\n---\n", {"k": 1}),  # as rostopic prints a message again and again
        (XML, {"k": [1.0, 2], "w": "a b", "l": [1, 2]}),
        (SECTIONS, {"A_LEFT": {"d": [-0.37, 0.5]}, "B": {"r": [[1, 2], [3, 4]], "n": "a.b"}}),
        ("K = [481.2, 0, 9.5; 0 -480 3\n 0 0 1];\n% a comment\n", {"K": [[481.2, 0, 9.5], [0, -480, 3], [0, 0, 1]]}),
    ],
)
def test_other_tools_texts_are_read(text, data):
    assert parsed(text.replace("\r\n", "\n")) == data


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a: 1\nb: {c: 2, c: 2}\n", "c is there twice"),
        ('{"a": 1, "a": 2}', "a is there twice"),
        ("<s><a>1</a><a>2</a></s>", "a is there twice"),
        ("[A]\nk = [1 2]\nk = [1 2]\n", "k is there twice"),
        ("a: [1,\nb: 2\n", r"no YAML, line \d"),
        ("{'a", "no JSON"),
        ("a = [1", "no TOML"),
        ("<s><a></s>", "no XML"),
        ("a: 1\n---\na: 2\n", "several documents"),
        ("a: &x [*x]\n", "no YAML"),
        ("[" * 5000, "nested too deeply|no YAML"),
    ],
)
def test_texts_with_errors_are_refused(text, message):
    with pytest.raises(SlamlibError, match=message):
        parsed(text)


def test_yaml_needs_pyyaml_and_nothing_else_does(monkeypatch):
    parsed.cache_clear()
    monkeypatch.setitem(__import__("sys").modules, "yaml", None)
    assert parsed('{"k": 5}') == {"k": 5}
    with pytest.raises(SlamlibError, match=r"yaml is needed to read a file of YAML.*slamlib\[images\]"):
        parsed("k: 7\n")


def test_a_name_may_be_written_in_many_ways():
    for name in ("distCoeffs", "dist_coeffs", "Dist-Coeffs", "DIST.COEFFS"):
        assert Entries({name: [[1], [2.5]]}).numbers("dist_coeffs") == (1.0, 2.5)
    entries = Entries({"K": {"rows": 1, "cols": 2, "data": [3, 4]}})
    assert entries.numbers("camera_matrix", "K", count=2) == (3.0, 4.0)
    with pytest.raises(SlamlibError, match="K and camera_matrix differ"):
        Entries({"K": [1], "camera_matrix": [2]}).numbers("camera_matrix", "K")


@pytest.mark.parametrize("value", [0.5, [1, 2], {"data": [1]}, [["a", 1]], True, "0.1 0.2"])
def test_numbers_that_nobody_asked_for_are_refused_by_name(value):
    entries = Entries({"dist": [1], "name": "a camera", "flag": False, "rms_error": 0.2, "dist_cofs": value}, "cam0")
    entries.numbers("dist")
    entries.value("dist_coeffs")
    with pytest.raises(SlamlibError, match=r"cam0\.dist_cofs is not known.* did you mean 'dist_coeffs'"):
        entries.close(["rms*"])
    entries.value("dist_cofs")
    entries.close(["rms*"])
    with pytest.raises(SlamlibError, match=r"rms_error is not known"):
        entries.close([])


def test_maps_inside_are_entered():
    inner = Entries({"board": {"width": 9, "title": "a"}, "lens": {"k": 1}})
    assert inner.inside("lens").number("k") == 1
    with pytest.raises(SlamlibError, match=r"board\.width is not known"):
        inner.close([])
    inner.close(["board*"])
    inner.inside("lens")
    with pytest.raises(SlamlibError, match=r"lens\.k is not known"):
        inner.close(["board*"])


def test_what_is_missing_is_said_with_the_nearest_that_is_there():
    with pytest.raises(SlamlibError, match="intrinsics is missing: is 'intrinsic' meant for it"):
        Entries({"intrinsic": [1]}).numbers("intrinsics")
    for value in ("x", None, [1, float("nan")], True, {"rows": 1}, 10**400, parsed(f"k: {'9' * 5000}")["k"]):
        with pytest.raises(SlamlibError, match=r"^k "):
            Entries({"k": value}).number("k")
    with pytest.raises(SlamlibError, match="k has 2 numbers, got 3"):
        Entries({"k": [1, 2, 3]}).numbers("k", count=2)
