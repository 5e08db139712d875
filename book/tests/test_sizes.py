"""The figures of the house: lines, units, layers and arrows of a small package."""

import pytest

from book.tools import sizes


@pytest.fixture
def root(tmp_path):
    """slamlib with three units in a row, the middle one of which is a folder that imports late too."""
    files = {
        "slamlib/__init__.py": "",
        "slamlib/errors.py": "class Error(Exception): ...\n",
        "slamlib/slam/__init__.py": "",
        "slamlib/slam/filter.py": "from slamlib.errors import Error\n" * 251,
        "slamlib/slam/options.py": "from slamlib.slam import filter\n\n\ndef late():\n    import slamlib.cli.run\n",
        "slamlib/cli/run.py": "from slamlib import errors\nfrom slamlib.slam import filter\n",
        "slamlib/generated/pose.py": "\n" * 7,
        "slamlib/tests/test_slam.py": "import slamlib.cli\n",
        "book/slambook/scene.py": "from slamlib import slam\n",
        "book/tools/build.py": "\n" * 3,
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def test_lines_units_layers_and_arrows_of_a_small_package(root):
    numbers, notes = sizes.figures(root)
    assert numbers["slamlib, written by hand"] == 1 + 251 + 5 + 2
    assert numbers["its core"] == 1 + 251 + 5
    assert numbers["generated"] == 7
    assert numbers["slamlib, slambook and book/tools"] == 259 + 1 + 3
    assert numbers["units"] == 4
    assert numbers["imports between units"] == 4  # slam and cli to errors, cli and slambook to slam
    assert numbers["layers"] == 3
    assert numbers["files over 250 lines"] == 1
    assert "slamlib/slam/filter.py" in notes[0]


def test_units_that_import_each_other_are_one_layer():
    assert sizes.layers({"a": {"b"}, "b": {"a", "c"}, "c": set(), "d": {"a"}}) == 3
    assert sizes.circles({"a": {"b"}, "b": {"a"}}) == ["  a and b import each other"]


def test_every_figure_is_printed(capsys):
    assert sizes.main() == 0
    said = capsys.readouterr().out
    numbers, _ = sizes.figures()
    for name, number in numbers.items():
        assert f"{name:<34} {number:>6}" in said
    assert said.endswith(f"sizes: {len(numbers)} figures\n")
