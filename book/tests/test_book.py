"""The chapters have all their parts, and the tools that build and check the book notice when something is wrong."""

import base64
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
import yaml

from book.tests.site import live_page
from book.tools import browser, build, ci, instructor, landing, layout, notebooks, site

CHAPTERS = sorted((layout.BOOK / "chapters").glob("*.ipynb"))
PARTS = [
    *("goals", "hook", "derivation", "proof", "scratch", "interactive", "realdata"),
    *("exercises", "quiz", "history"),
]
NUMBERS = re.compile(r"\b[EC]\d{2}\b|\bA\d{3}\b|\b[Ee]rrat(?:a|um)\b")  # of the errors, the gaps, the seeds
FENCE = re.compile(r"(`{3,}|:{3,})(.*)")
NUMBERED = re.compile(r"\$\$ \([\w-]+\)")  # the end of an equation that has a number: its label
LINK = re.compile(r"\{ref\}`[^`<]*<((?:manuals|report)-[\w-]+)>`")


def cells(notebook: Path) -> list[dict]:
    return json.loads(notebook.read_text("utf-8"))["cells"]


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda c: c.stem)
def test_a_chapter_has_all_its_parts(chapter):
    found = [c["metadata"]["part"] for c in cells(chapter) if "part" in c["metadata"]]
    assert not set(PARTS) - set(found), "parts are missing"
    assert "goals" in found[:2]  # the picture that asks the question may stand above it
    assert found[-3:] == ["exercises", "quiz", "history"]
    assert not [p for p in found if found.count(p) > 1]
    text = "".join(c["source"][0] if c["source"] else "" for c in cells(chapter)[:1])
    assert text.startswith("# ")


def prose(notebook: Path) -> str:
    return "\n".join("".join(c["source"]) for c in cells(notebook) if c["cell_type"] == "markdown")


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda c: c.stem)
def test_a_chapter_speaks_to_its_reader_and_not_by_numbers_of_errors(chapter):
    assert NUMBERS.findall(prose(chapter)) == []


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda c: c.stem)
def test_a_chapter_ends_its_history_with_its_headings_in_part_six(chapter):
    """In the last cell; each chapter that a page has a heading for leads there, and the heading leads back."""
    targets = LINK.findall("".join(cells(chapter)[-1]["source"]))
    pages = {kind: prose(layout.BOOK / "sources" / f"the_{kind}.ipynb") for kind in ("manuals", "report")}
    slug = chapter.stem.replace("_", "-")
    known = {f"{kind}-{slug}": page for kind, page in pages.items() if f"({kind}-{slug})=" in page}
    assert targets == list(known) != []
    for target, page in known.items():
        assert re.search(rf"\({target}\)=\n## \[[^]]+\]\(\.\./chapters/{chapter.stem}\.ipynb\)\n", page)


def title(page: Path) -> str:
    text = prose(page) if page.suffix == ".ipynb" else page.read_text("utf-8")
    return re.search(r"(?m)^# (.+)$", text)[1]


@pytest.mark.parametrize("page", layout.notebooks(), ids=lambda c: c.stem)
def test_links_to_pages_work_in_any_front_end_and_say_their_titles(page):
    """A role of Sphinx is a name of a file there. A title may be cut short."""
    assert "{doc}" not in prose(page)
    links = re.findall(r"\[([^]]+)\]\(([\w./]+\.(?:ipynb|md))\)", prose(page))
    assert [words for words, target in links if not title(page.parent / target).startswith(words)] == []
    targets = set(re.findall(r"\]\(#([\w-]+)\)", prose(page)))  # of its own headings MyST makes no targets
    labels = set(re.findall(r"(?m)^\(([\w-]+)\)=$", prose(page)))
    assert [target for target in targets - labels if not target.startswith("fig-")] == []


def unclosed(text: str) -> list[str]:
    """What a front end would leave in the text of a Markdown cell as it is written: fences and formulas that do not
    close or share a line; equations with a blank line inside or, where they have a number, none around."""
    fences: list[tuple[str, str]] = []  # marks, and what follows them: {name} of a directive, or a language of code
    found, formula, lines = [], 0, ["", *map(str.strip, text.splitlines()), ""]  # formula: the line where one began
    for number, line in enumerate(lines[1:-1], start=1):
        fence, (marks, name) = FENCE.fullmatch(line), fences[-1] if fences else ("", "{")
        if formula and NUMBERED.fullmatch(line):
            alone = not lines[formula - 1] and not lines[number + 1]
            found += [] if alone else [f"line {number}: an equation with a number is a block of its own"]
            formula = 0
        elif formula and line != "$$":
            found += [f"line {number}: within a formula"] if fence or "$$" in line or not line else []
        elif fence and not fence[2] and marks and fence[1].startswith(marks):
            fences.pop()
        elif not name.startswith("{"):
            continue
        elif fence:
            found += [f"line {number}: as long as the one around it"] if marks and fence[1].startswith(marks) else []
            fences.append((fence[1], fence[2]))
        elif line == "$$":
            formula = 0 if formula else number
        elif "$$" in line and not re.fullmatch(r"\$\$[^$]+\$\$", line):
            found.append(f"line {number}: beside text")
    return found + [f"{marks}{name} is not closed" for marks, name in [*fences, *[("$$", "")] * bool(formula)]]


@pytest.mark.parametrize(
    ("text", "faults"),
    [
        ("$$\nx\n$$\n\n```{solution-start} a\n:class: dropdown\n```\n$$x$$\n:::{note}\n```\n$$ y\n```\n:::", 0),
        ("::::{note}\n:::{tip}\na\n:::\n::::", 0),
        ("so\n\n$$\nx\n$$ (a)\n\nso", 0),
        ("so\n$$\nx\n$$ (a)", 1),
        ("$$\nx\n$$ (a)\nso", 1),
        ("$$\nx\n\ny\n$$ (a)", 1),
        ("so\n\n$$\nx\n```\n\nThe weight", 3),
        ("$$\nx\n\nThe weight", 2),
        ("that is $$x$$ too", 1),
        ("$$x\ny$$", 2),
        ("```{math}\nx\n\nThe weight", 1),
        ("The weight\n```", 1),
        (":::{note}\n:::{tip}\na\n:::\n:::", 1),
    ],
)
def test_a_fault_of_markdown_is_found(text, faults):
    assert len(unclosed(text)) == faults


def test_no_formula_and_no_fence_is_left_open_in_the_text():
    for page in layout.pages():
        markdown = [c for c in cells(page) if c["cell_type"] == "markdown"] if page.suffix == ".ipynb" else []
        texts = {c["id"]: "".join(c["source"]) for c in markdown} or {"": page.read_text("utf-8")}
        for name, text in texts.items():
            assert unclosed(text) == [], f"{page.name} {name}"
            assert "{math}" not in text, f"{page.name} {name}: $$ ... $$ (label) is what every front end shows"


def test_every_number_of_an_error_is_explained_in_the_list():
    """Part VI uses numbers of errors; the audit says what each of them is, alone or in a range such as E41 to E44."""
    listed: set[str] = set()
    for first, last in re.findall(r"\bE(\d\d)(?:\u2013E(\d\d))?", prose(layout.BOOK / "sources" / "audit.ipynb")):
        listed |= {f"E{number:02}" for number in range(int(first), int(last or first) + 1)}
    assert listed >= {f"E{number:02}" for number in range(1, 62)}
    for page in (layout.BOOK / "sources").iterdir():
        text = page.read_text("utf-8") if page.suffix == ".md" else prose(page) if page.suffix == ".ipynb" else ""
        assert set(re.findall(r"\bE\d\d\b", text)) <= listed, page.name


def test_old_addresses_lead_to_pages(tmp_path):
    build.redirect(tmp_path)
    known = {p.relative_to(layout.ROOT).with_suffix(".html").as_posix() for p in layout.pages()}
    found = sorted(tmp_path.rglob("*.html"))
    assert len(found) > 20
    for old in found:
        (new,) = re.findall(r'url=([^"]+)"', old.read_text("utf-8"))
        assert (old.parent / new).resolve().relative_to(tmp_path).as_posix() in known


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda c: c.stem)
def test_a_chapter_has_three_to_five_exercises_with_folded_solutions(chapter):
    text = "\n".join("".join(c["source"]) for c in cells(chapter) if c["cell_type"] == "markdown")
    exercises = re.findall(r"```\{exercise\}\n:label: (\S+)", text)
    assert 3 <= len(exercises) <= 5
    assert re.findall(r"```\{solution-start\} (\S+)\n:class: dropdown", text) == exercises
    assert text.count("{solution-end}") == len(exercises)
    assert re.search(r"\*\*Bug hunt", text)
    assert re.search(r"\*\*By hand", text)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda c: c.stem)
def test_a_chapter_has_a_slider_and_describes_its_pictures(chapter):
    source = "\n".join("".join(c["source"]) for c in cells(chapter) if c["cell_type"] == "code")
    assert "sweep(" in source
    for cell in cells(chapter):
        if cell["cell_type"] == "code" and re.search(r"^(picture|sweep|drag)\(", "".join(cell["source"]), flags=re.M):
            assert {"nbval-ignore-output", "hide-input"} <= set(cell["metadata"].get("tags", []))
            assert "alt=" in "".join(cell["source"])


@pytest.mark.parametrize("page", layout.notebooks(), ids=lambda c: c.stem)
def test_legends_say_where_they_stand(page):
    """The best place is another one where matplotlib draws than where the page does."""
    source = "\n".join("".join(c["source"]) for c in cells(page) if c["cell_type"] == "code")
    places = [call.partition(")")[0] for call in source.split(".legend(")[1:]]
    assert [call for call in places if "loc=" not in call or "best" in call] == []


@pytest.mark.parametrize("page", layout.notebooks(), ids=lambda c: c.stem)
def test_listings_fit_a_page_of_1280_pixels(page):
    """The letters that fit beside the columns for contents are counted by book/_static/book.css, and by a browser in
    book/tests/site/test_pages.py; a solution stands in a frame of its own. What is folded away may be wider."""
    for cell in cells(page):
        tags = cell["metadata"].get("tags", [])
        if cell["cell_type"] == "code" and "hide-input" not in tags:
            most = 108 if "solution" in tags else 120
            assert [line for line in "".join(cell["source"]).splitlines() if len(line) > most] == []


def test_every_notebook_is_a_page():
    assert {p.resolve() for p in layout.notebooks()} == {
        p.resolve()
        for folder in (".", "chapters", "sources", "appendices")
        for p in (layout.BOOK / folder).glob("*.ipynb")
    }


@pytest.mark.parametrize("page", layout.notebooks(), ids=lambda c: c.stem)
def test_outputs_are_stored_as_text_with_counts_that_nbval_compares(page):
    stored = nbformat.read(page, as_version=4)
    counts = [c.execution_count for c in stored.cells if c.cell_type == "code"]
    assert counts == list(range(1, len(counts) + 1))
    assert "image/" not in page.read_text("utf-8")
    assert notebooks.unstored([page]) == []


@pytest.mark.parametrize("page", layout.notebooks(), ids=lambda c: c.stem)
def test_what_opens_a_fold_holds_no_link(page):
    """One control within another: a reader who presses it gets either, and a screen reader hears neither."""
    titles = re.findall(r"(?m)^:+\{dropdown\} (.*)$", prose(page))
    assert [title for title in titles if re.search(r"\]\(|\{(eq|ref|cite|doc|term)\}", title)] == []


def test_the_landing_page_lists_the_chapters_in_their_order_by_parts():
    listed = prose(landing.PAGE).partition(":::{div} chapters\n")[2].partition("\n:::")[0]
    found = re.findall(r"(?m)^(?:\*\*(.+)\*\*$|- \[[^]]+\]\(chapters/(\w+)\.ipynb\))", listed)
    _, *parts = yaml.safe_load((layout.ROOT / "_toc.yml").read_text("utf-8"))["parts"]  # the first has a button
    wanted = []
    for part in parts:
        names = [page["file"].rpartition("/") for page in part["chapters"]]
        if names[0][0] == "book/chapters":
            wanted += [(part["caption"], ""), *(("", name) for _, _, name in names)]
    assert found == wanted


def test_the_landing_page_says_how_long_chapters_take_and_what_builds_on_what():
    times = [instructor.minutes(goals["time"]) for goals in landing.chapters().values()]
    assert (min(times), max(times)) == (40, 180)
    assert "from 40 minutes to three hours" in prose(landing.PAGE)
    assert landing.current() == landing.FIGURE.read_text("utf-8"), "python -m book.tools.landing"


# -- notebooks ---------------------------------------------------------------------------------------------------------


def _notebook(folder: Path, *sources: str) -> Path:
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(s) for s in sources])
    file = folder / "one.ipynb"
    file.write_text(nbformat.writes(book), "utf-8")
    return file


def test_running_a_notebook_stores_its_text(tmp_path, monkeypatch):
    monkeypatch.setattr(layout, "ROOT", tmp_path)
    file = _notebook(tmp_path, "print('one', end='')", "print('two')\n3")
    assert notebooks.unstored([file]) == [file]
    assert notebooks.main(["run", str(file)]) == 0
    assert notebooks.main(["check", str(file)]) == 0
    outputs = nbformat.read(file, as_version=4).cells[1].outputs
    assert [o.get("text") or o["data"]["text/plain"] for o in outputs] == ["two\n", "3"]
    before = file.read_text()
    assert notebooks.main(["run", str(file)]) == 0
    assert file.read_text() == before


def test_a_picture_is_written_once_however_often_it_is_shown(tmp_path, monkeypatch):
    content, write, written = bytes(7600), Path.write_bytes, []
    shown = f'<img src="data:image/png;base64,{base64.b64encode(content).decode()}">'
    for page in ("one.html", "two.html"):
        (tmp_path / page).write_text(2 * shown)
    monkeypatch.setattr(Path, "write_bytes", lambda path, data: written.append(path) or write(path, data))
    build.lighten(tmp_path)
    assert [path.read_bytes() for path in written] == [content]
    for page in ("one.html", "two.html"):
        assert (tmp_path / page).read_text() == 2 * f'<img src="_images/{written[0].name}">'


def test_each_work_of_the_bibliography_is_cited():
    bibliography = (layout.BOOK / "references.bib").read_text("utf-8")
    pages = [file for end in ("md", "ipynb") for file in layout.BOOK.rglob(f"*.{end}")]
    cited = re.findall(r"\{cite(?::\w+)?\}`([^`]+)`", "".join(page.read_text("utf-8") for page in pages))
    keys = {key.strip() for keys in cited for key in keys.split(",")}
    assert set(re.findall(r"^@\w+\{([^,]+),", bibliography, re.MULTILINE)) == keys


@pytest.mark.parametrize(
    ("source", "message"), [("1 / 0", "ZeroDivisionError"), ("import sys; print('x', file=sys.stderr)", "stderr")]
)
def test_a_notebook_that_fails_or_complains_is_broken_and_left_as_it_was(
    tmp_path, source, message, capsys, monkeypatch
):
    monkeypatch.setattr(layout, "ROOT", tmp_path)
    file = _notebook(tmp_path, source)
    before = file.read_text()
    assert notebooks.main(["run", str(file)]) == 1
    assert message in capsys.readouterr().err
    assert file.read_text() == before


# -- the site ----------------------------------------------------------------------------------------------------------


def test_site_check_finds_each_kind_of_fault(tmp_path):
    (tmp_path / "index.html").write_text(
        '<a href="other.html#here">right</a><a href="other.html#nowhere">anchor</a><a href="missing.html">page</a>'
        '<img src="missing.png"><script src="https://example.org/a.js"></script>'
        '<a href="https://example.org/">may lead out</a>'
    )
    (tmp_path / "other.html").write_text('<p id="here"></p>')
    count, found = site.problems(tmp_path, ["index.html", "never_built.html"])
    assert count == 6
    assert sorted(found) == [
        "index.html: https://example.org/a.js: loaded from outside; the site must serve it itself",
        "index.html: missing.html: no such file in the site",
        "index.html: missing.png: no such file in the site",
        "index.html: other.html#nowhere: no such anchor",
        "never_built.html: named in _toc.yml, but not built",
    ]


def test_an_old_address_leads_to_the_new_page_and_no_page_is_replaced(tmp_path):
    page = tmp_path / "book/chapters/stereo_ekf_slam.html"
    page.parent.mkdir(parents=True)
    page.write_text("the page")
    build.redirect(tmp_path)
    assert page.read_text() == "the page"
    assert "url=gaussians.html" in (tmp_path / "book/chapters/01_gaussians.html").read_text()


def test_a_page_of_the_toc_that_does_not_exist_stops_everything(tmp_path, monkeypatch):
    monkeypatch.setattr(layout, "ROOT", tmp_path)
    (tmp_path / "_toc.yml").write_text("format: jb-book\nroot: book/index\n")
    with pytest.raises(FileNotFoundError, match=r"_toc.yml names book/index, but there is no"):
        layout.pages()


def test_without_a_browser_the_stage_is_skipped_or_fails_where_it_is_needed():
    for needed, status in (("", browser.SKIPPED), ("1", 1)):
        environment = {**os.environ, "PATH": "/nowhere", "BOOK_BROWSER": "", "BOOK_BROWSER_NEEDED": needed}
        command = [sys.executable, "-m", "pytest", "-q", "book/tests/site"]
        run = subprocess.run(command, cwd=layout.ROOT, env=environment, capture_output=True, text=True)
        assert run.returncode == status, run.stdout + run.stderr
        assert "apt-get install chromium" in run.stdout + run.stderr


def test_pages_are_tried_where_a_change_reaches_and_everywhere_if_what_is_behind_them_changed(monkeypatch):
    everywhere = live_page.live_pages()
    monkeypatch.setattr(live_page, "changed_files", lambda: {"book/chapters/points.ipynb", "README.md"})
    assert {f.stem for f in live_page.live_pages(every=False)} == {*live_page.ALWAYS, "points"}
    monkeypatch.setattr(live_page, "changed_files", lambda: {"slamlib/belief.py"})
    assert live_page.live_pages(every=False) == everywhere
    urgent = [f.stem for f in live_page.most_urgent_first(everywhere)]
    assert {*urgent[: len(live_page.ALWAYS)]} == {*live_page.ALWAYS}  # where time is short, these are tried
    assert {f.stem for f in live_page.shown_pages(every=False)} == {*live_page.ALWAYS}
    monkeypatch.setattr(live_page, "changed_files", lambda: {"book/slambook/figures/axes.py"})
    assert live_page.shown_pages(every=False) == layout.pages()
    monkeypatch.setattr(live_page, "changed_files", lambda: None)
    assert live_page.live_pages(every=False) == everywhere


# -- the checks --------------------------------------------------------------------------------------------------------


def test_each_stage_counts_what_its_command_really_prints():
    printed = {
        "lint": "All checks passed!",
        "format": "63 files already formatted",
        "types": "Success: no issues found in 55 source files",
        "generated": "generated code: 25 models in 9 files, 0 out of date",
        "tangled": "tangled cells: 7 in the book, 7 formula modules, 0 problems",
        "sizes": "sizes: 9 figures",
        "stored": "notebooks: 11 in the book, 0 not in the stored form",
        "core": "90 passed in 20.0s",
        "pytest": "320 passed, 2 skipped in 60.0s",
        "nbval": "200 passed in 50.0s",
        "book": "running 11 notebooks",
        "oracles": "154 passed in 14.0s",
        "platforms": "platforms: 6 of 6 install the lock",
        "site": "site: 13 pages, 900 links and assets, 0 problems",
        "shares": "shares: 27 chapters",
        "browser": "39 passed in 200.0s",
        "axe": "16 passed in 200.0s",
        "readers": "46 passed in 210.0s",
        "live": "4 passed, 27 skipped in 140.0s",
    }
    assert [s.name for s in ci.stages()] == list(printed)
    for stage in ci.stages():
        assert ci.judge(stage, 0, printed[stage.name])[0] == "ok"
        assert ci.judge(stage, 1, printed[stage.name])[0] == "FAILED"


@pytest.mark.parametrize(
    "text",
    ["", "no tests ran in 0.01s", "0 passed", "running 0 notebooks", "tangled cells: 0 in the book", "2 skipped"],
)
def test_a_stage_that_ran_nothing_has_failed(text):
    for stage in ci.stages():
        assert ci.judge(stage, 0, text) == ("NOTHING", 0)


def test_the_summary_fails_for_one_failed_stage_and_for_none(capsys):
    stage = ci.stages()[0]
    good, bad = ci.Result(stage, "ok", 3, 1.0), ci.Result(stage, "NOTHING", 0, 1.0)
    assert ci.summary([good]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "stages: 1 passed, 0 failed, 0 skipped"
    assert ci.summary([good, bad]) == 1
    assert ci.summary([good, ci.Result(stage, "skipped", 0, 1.0)]) == 0
    assert ci.summary([]) == 1


def test_after_a_stage_that_failed_the_others_are_left_out_unless_they_are_wanted(monkeypatch, capsys):
    def quick(name, code):
        return ci.Stage(name, [sys.executable, "-c", f"print('1 thing'); raise SystemExit({code})"], r"(\d+) thing", "")

    monkeypatch.setattr(ci, "stages", lambda every=False: [quick("good", 0), quick("bad", 1), quick("last", 0)])
    assert ci.main([]) == 1
    said = capsys.readouterr().out
    assert re.search(r"(?m)^bad +FAILED", said)
    assert re.search(r"(?m)^last +left out$", said)
    assert ci.main(["--keep-going"]) == 1
    assert re.search(r"(?m)^last +ok", capsys.readouterr().out)


def test_a_stage_says_how_long_processors_worked():
    code = "import time\nwhile time.process_time() < 0.3: pass\nprint('1 thing')"
    stage = ci.Stage("busy", [sys.executable, "-c", code], r"(\d+) thing", "things")
    assert ci.run(stage).processor >= 0.3
