"""The figures of the house: lines, units, layers, arrows and circles of a small package."""

import pytest

from book.tools import sizes


@pytest.fixture
def root(tmp_path):
    """slamlib with three units in a row, the middle one of which is a folder that imports late too."""
    files = {
        "slamlib/__init__.py": "",
        "slamlib/errors.py": "from typing import Any\n\n\nclass Error(Exception):\n    many: list[Any]  # Anything\n",
        "slamlib/slam/__init__.py": "",
        "slamlib/slam/filter.py": "from slamlib.errors import Error\n" * 3,
        "slamlib/slam/options.py": "from slamlib.slam import filter\n\n\ndef late():\n    import slamlib.cli.run\n",
        "slamlib/cli/run.py": "from slamlib import errors\nfrom slamlib.slam import filter\n",
        "slamlib/generated/pose.py": "\n" * 7,
        "slamlib/tests/test_slam.py": "from typing import Any\nimport slamlib.cli\n",
        "book/slambook/scene.py": "from slamlib import slam\n",
        "book/tools/build.py": "\n" * 3,
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def test_lines_units_layers_and_arrows_of_a_small_package(root):
    numbers, notes = sizes.figures(root)
    assert numbers["slamlib, written by hand"] == 5 + 3 + 5 + 2
    assert numbers["its core"] == 5 + 3 + 5
    assert numbers["generated"] == 7
    assert numbers["slambook"] == 1
    assert numbers["book/tools"] == 3
    assert numbers["book/experiments"] == 0
    assert numbers["the word Any in slamlib"] == 2
    assert numbers["units"] == 4
    assert numbers["imports between units"] == 4  # slam and cli to errors, cli and slambook to slam
    assert numbers["layers"] == 3
    assert numbers["circles among files"] == 0
    assert notes == []


def test_units_that_import_each_other_are_one_layer():
    assert sizes.layers({"a": {"b"}, "b": {"a", "c"}, "c": set(), "d": {"a"}}) == 3
    assert sizes.circles({"a": {"b"}, "b": {"a", "c"}, "c": set()}) == [["a", "b"]]


@pytest.mark.parametrize(
    "late",
    [
        "def late():\n    from slamlib.slam.filter import Slam\n",
        "if TYPE_CHECKING:\n    import slamlib.slam.filter\n",
        "from slamlib.slam import filter\n",
    ],
)
def test_files_are_in_a_circle_however_they_import(root, late):
    (root / "slamlib/errors.py").write_text(late)
    numbers, notes = sizes.figures(root)
    assert numbers["circles among files"] == 1
    assert notes[-1] == "  circle of 2 files: slamlib.errors, slamlib.slam.filter"


def test_the_init_of_a_package_is_a_file_of_a_circle(root):
    (root / "slamlib/slam/__init__.py").write_text("from slamlib.slam.filter import Slam\n")
    (root / "slamlib/slam/filter.py").write_text("from slamlib.slam import options\n")
    (root / "slamlib/slam/options.py").write_text("def late():\n    from slamlib.slam import Slam\n")
    _, notes = sizes.figures(root)
    assert notes == ["  circle of 3 files: slamlib.slam.__init__, slamlib.slam.filter, slamlib.slam.options"]


def test_every_figure_is_printed(capsys):
    assert sizes.main() == 0
    said = capsys.readouterr().out
    numbers, _ = sizes.figures()
    for name, number in numbers.items():
        assert f"{name:<34} {number:>6}" in said
    assert said.endswith(f"sizes: {len(numbers)} figures\n")
