"""A build gives the same site whatever was built before it."""

import shutil
from pathlib import Path

import nbformat
import pytest

from book.tools import build, layout, notebooks

INDEX = "# The book\n\n{doc}`first` says what a {term}`gain` is.\n"
FIRST = "# First\n\nA {term}`gain`, {ref}`elsewhere <there>`, and `Slam`.\n"
GLOSSARY = (
    "# Glossary\n\n```{glossary}\ngain\n  What weighs the {term}`innovation`.\n\ninnovation\n  What is new.\n```\n"
)
OTHER = "(there)=\n# There\n\nWords that are found: pseudo-range.\n"
API = "# Reference\n\n```{api} slamlib.errors```\n".replace("errors```", "errors\n```")


def write_book(folder: Path, pages: dict[str, str], extension: str = "") -> Path:
    """The sources of a small book, built as the large one is; `extension`: code that its extension has besides."""
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("_ext", "_static"):
        shutil.copytree(layout.BOOK / name, folder / "book" / name, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(layout.BOOK / "references.bib", folder / "book")
    local = folder / "book" / "_ext" / "book_local.py"
    local.write_text(local.read_text("utf-8") + extension, "utf-8")
    config = (
        (layout.ROOT / "_config.yml").read_text("utf-8").replace("execute_notebooks: force", "execute_notebooks: 'off'")
    )
    (folder / "_config.yml").write_text(config, "utf-8")
    chapters = "".join(f"  - file: book/{name}\n" for name in pages if name != "index")
    (folder / "_toc.yml").write_text(f"format: jb-book\nroot: book/index\nchapters:\n{chapters}", "utf-8")
    for name, text in pages.items():
        (folder / "book" / f"{name}.md").write_text(text, "utf-8")
    return folder


def built(source: Path, site: Path) -> dict[str, bytes]:
    """The contents of all files of the site of these sources."""
    assert build.html(source, site)
    return {file.relative_to(site).as_posix(): file.read_bytes() for file in site.rglob("*") if file.is_file()}


def test_the_site_is_that_of_a_clean_build_whatever_was_built_before(tmp_path):
    """Before: another text, a page that is gone, one that is not there yet, and another state of our extensions."""
    before = {"index": INDEX, "first": FIRST + "Old.\n", "glossary": GLOSSARY, "gone": OTHER.replace("There", "Gone")}
    after = {"index": INDEX, "first": FIRST, "glossary": GLOSSARY, "other": OTHER, "api": API}
    louder = (
        "\nChapterLexer.name = 'other'\nplain = plain_bibliography\n\n\n"
        "def plain_bibliography(app, page, template, context, tree):\n"
        "    context['body'] = context.get('body', '') + '<p>loud</p>'\n"
    )
    site = tmp_path / "used" / "html"
    old = built(write_book(tmp_path / "source", before, louder), site)
    assert b"<p>loud</p>" in old["book/first.html"]
    found = built(write_book(tmp_path / "source", after), site)
    clean = built(write_book(tmp_path / "source", after), tmp_path / "clean" / "html")
    assert sorted(found) == sorted(clean)
    assert [name for name in clean if found[name] != clean[name]] == []
    assert b'["term","term-innovation","innovation"' in clean["searchindex.js"]
    assert "book/gone.html" in old
    assert "book/gone.html" not in found


def test_a_build_that_fails_leaves_the_site_that_is_there(tmp_path):
    site = tmp_path / "html"
    site.mkdir()
    (site / "index.html").write_text("as it was")
    assert not build.html(write_book(tmp_path / "source", {"index": "# The book\n\n{doc}`nowhere`\n"}), site)
    assert (site / "index.html").read_text() == "as it was"


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    """A folder that stands for the checkout, with one file of each kind that a site is made from."""
    names = [
        *("slamlib/errors.py", "slamlib/datasets/list.toml", "book/slambook/book.mplstyle", "benchmarks/one.py"),
        *("book/chapters/data/run.json", "book/chapters/pictures/a/1.jpg", "book/tools/build.py", "requirements.txt"),
        *("book/offline/open.py", "book/tools/notebooks.py", "_build/source/book/_ext/x.py", "_build/source/_toc.yml"),
    ]
    for name in [*names, "book/sources/x.csv", "slamlib/tests/test_x.py"]:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    monkeypatch.setattr(layout, "ROOT", tmp_path)
    monkeypatch.setattr(layout, "BOOK", tmp_path / "book")
    monkeypatch.setattr(build, "SOURCE", tmp_path / "_build" / "source")
    return names


def test_whatever_a_site_is_made_from_makes_a_new_one(checkout, tmp_path):
    state = build.made_from()
    for name in checkout:
        (tmp_path / name).write_text("changed")
        assert build.made_from() != state, name
        (tmp_path / name).write_text(name)
    assert build.made_from() == state
    (tmp_path / "slamlib" / "tests" / "test_x.py").write_text("no page shows a test")
    assert build.made_from() == state


def test_new_words_reach_the_page_without_running_a_notebook_again(tmp_path, monkeypatch):
    file, ran = tmp_path / "page.ipynb", []
    monkeypatch.setattr(notebooks, "EXECUTED", tmp_path / "executed")
    monkeypatch.setattr(notebooks, "execute", lambda file: ran.append(file) or run_by_hand(file))

    def run_by_hand(file):
        notebook = nbformat.read(file, as_version=4)
        notebook.cells[1].outputs = [nbformat.v4.new_output("stream", text="2\n")]
        return notebook

    def written(words, code):
        cells = [nbformat.v4.new_markdown_cell(words, id="a"), nbformat.v4.new_code_cell(code, id="b")]
        nbformat.write(nbformat.v4.new_notebook(cells=cells), file)
        copy, cached = notebooks.executed(file, "key")
        made = nbformat.read(copy, as_version=4)
        return cached, made.cells[0].source, made.cells[1].outputs[0].text

    assert written("First words.", "print(1 + 1)") == (False, "First words.", "2\n")
    assert written("Other words.", "print(1 + 1)") == (True, "Other words.", "2\n")
    assert written("Other words.", "print(2)") == (False, "Other words.", "2\n")
    assert len(ran) == 2


def test_a_notebook_runs_again_when_one_that_it_reads_has_other_code(tmp_path):
    """The landing page shows a chapter's run."""

    def write(name, words, code):
        cells = [nbformat.v4.new_markdown_cell(words, id="a"), nbformat.v4.new_code_cell(code, id="b")]
        nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / name)

    def place():
        return notebooks._cached(tmp_path / "index.ipynb", "key").name

    (tmp_path / "chapters").mkdir()
    write("index.ipynb", "Words.", 'run(Path("chapters/one.ipynb"))')
    write("chapters/one.ipynb", "Words.", "print(1)")
    first = place()
    write("chapters/one.ipynb", "Other words.", "print(1)")
    assert place() == first
    write("chapters/one.ipynb", "Other words.", "print(2)")
    assert place() != first
