"""The reference has every public name of the packages, and the examples on its pages print what they say."""

import ast
import doctest
import re
import sys

import pytest

from book.tools import layout

sys.path.append(str(layout.BOOK / "_ext"))
import api_reference

PAGES = sorted((layout.BOOK / "appendices" / "api").glob("*.md"))
REFERENCE = api_reference.Reference({"points": "book/chapters/points"}, {"pt-euc"})


@pytest.mark.parametrize("file", PAGES, ids=lambda file: file.stem)
def test_the_examples_of_a_page_print_what_they_say(file):
    (example,) = re.findall(r"```pycon\n(.*?)```", file.read_text("utf-8"), flags=re.DOTALL)
    found = doctest.DocTestParser().get_doctest(example, {}, file.name, str(file), 0)
    assert len(found.examples) >= 2
    assert any(one.want for one in found.examples)
    assert doctest.DocTestRunner().run(found).failed == 0


def test_every_public_name_of_slamlib_is_on_one_page():
    text = "\n".join(REFERENCE.filled(page.read_text("utf-8")) for page in PAGES)
    listed = re.findall(r"\.\. py:(?:current)?module:: (\S+)", text)
    assert len(listed) == len(set(listed))
    files = [f.relative_to(layout.ROOT).with_suffix("") for f in (layout.ROOT / "slamlib").rglob("*.py")]
    wanted = {".".join(f.parts).removesuffix(".__init__") for f in files if not {"tests", "generated"} & set(f.parts)}
    wanted -= {"slamlib.__main__", "slamlib.codegen.__main__"}
    assert wanted == {name for name in listed if name.startswith("slamlib")}
    for module in map(api_reference.Module.of, wanted):
        own = [node.name for node in module.tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)]
        for name in own:
            assert name.startswith("_") or re.search(rf"\.\. py:\w+:: {name}\b", text), f"{module.name}.{name}"


def test_every_package_of_slambook_is_on_the_page():
    text = next(page for page in PAGES if page.stem == "slambook").read_text("utf-8")
    top = layout.BOOK / "slambook"
    wanted = {f.stem for f in top.iterdir() if (f / "__init__.py").is_file() or f.suffix == ".py"} - {"__init__"}
    assert {name for _, name in re.findall(r"\{(api|exported)\} slambook\.(\w+)", text)} == wanted


def test_a_model_shows_its_arguments_and_leads_to_its_chapter():
    text = REFERENCE.all("slamlib.landmarks.euc_point")
    assert ".. py:function:: to_frame(pose: Pose, landmark: array[3])" in text
    assert "Chapter :doc:`/book/chapters/points`, eq. :eq:`pt-euc`." in text
    assert ".. py:data:: EUC_POINT" in text


def test_words_are_escaped_and_code_is_not():
    assert REFERENCE.linked("P_i and `a_b`s, |h| = 1") == r"P\_i and ``a_b``\ s, \|h\| = 1"
    assert REFERENCE.words("One.\n\n    f(x)\n") == ["One.", "", ".. code-block:: python", "", "   f(x)", ""]
    example = ["One.", "", ".. code-block:: pycon", "", "   >>> f(x)", "   4", ""]
    assert REFERENCE.words("One.\n\n    >>> f(x)\n    4\n") == REFERENCE.words("One.\n\n>>> f(x)\n4\n") == example


def test_a_second_name_is_the_one_that_a_package_exports():
    assert ":canonical: slamlib.slam.Slam" in REFERENCE.all("slamlib.slam")
    assert ":canonical: slambook.figures.page.sweep" in REFERENCE.exported("slambook.figures")
