"""The page's Python, as far as it can be tested without a page: its runner, its wheel, its archives."""

import ast
import builtins
import dis
import importlib.util
import io
import json
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

from book.live import opencv
from slamlib.errors import SlamlibError

ROOT = Path(__file__).parents[2]
CHECK = re.compile(r"""^check\("(\w+\.\d+)", (\w+)\)""", re.MULTILINE)
pytestmark = pytest.mark.skipif(not (ROOT / "book").is_dir(), reason="the book is not beside the package")


@pytest.fixture
def page(monkeypatch):
    """A runner and what it has sent."""
    spec = importlib.util.spec_from_file_location("book_runner", ROOT / "book" / "live" / "runner.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(sys, "meta_path", list(sys.meta_path))
    monkeypatch.setattr(module, "LIMIT", 1000)
    sent = []
    runner = module.Runner(lambda kind, text: sent.append((kind, text)), lambda name: b"", {})
    runner.sent = sent
    return runner


def said(page, kind):
    return "".join(text for k, text in page.sent if k == kind)


def failed(page):
    return json.loads(said(page, "error"))


def test_a_cell_prints_defines_and_shows_its_last_value(page):
    assert page.run("a = 2\nprint('two')\na + 1", "cell 1")
    assert said(page, "stdout") == "two\n"
    assert json.loads(said(page, "value")) == {"text": "3"}
    assert page.run("b = a * 10; b;", "cell 2")
    assert page.user_ns["b"] == 20
    assert len([k for k, _ in page.sent if k == "value"]) == 1


def test_values_come_in_their_richest_form_and_as_text(page):
    page.run("import sympy\nsympy.sqrt(2)", "cell 1")
    shown = json.loads(said(page, "value"))
    assert shown["text"] == "sqrt(2)"
    assert r"\sqrt{2}" in shown["latex"]
    page.run("class H:\n    def _repr_html_(self): return '<b>h</b>'\nH()", "cell 2")
    assert json.loads(page.sent[-1][1])["html"] == "<b>h</b>"


def test_an_error_points_to_the_line_of_the_reader(page):
    assert not page.run("def f(x):\n    return 1 / x\n\nprint('before')\nf(0)\n", "cell 1")
    assert said(page, "stdout") == "before\n"
    found = failed(page)
    assert (found["line"], found["name"]) == (2, "ZeroDivisionError")
    assert 'File "cell 1", line 5' in found["text"]
    assert "return 1 / x" in found["text"]
    assert "runner" not in found["text"]


def test_an_error_inside_a_library_points_to_the_call(page):
    page.run("import numpy as np\nx = 3\nnp.linalg.inv(np.zeros((2, 3)))", "cell 1")
    found = failed(page)
    assert (found["line"], found["name"]) == (3, "LinAlgError")


def test_a_function_of_another_cell_is_named(page):
    page.run("def f():\n    raise ValueError('no')", "cell 1")
    page.run("\n\nf()", "cell 2")
    found = failed(page)
    assert found["line"] == 3
    assert 'File "cell 1", line 2' in found["text"]


def test_code_that_cannot_be_read_is_an_error_with_its_line(page):
    assert not page.run("x = 1\ny = (2\nz = 3", "cell 1")
    assert failed(page)["name"] == "SyntaxError"
    assert failed(page)["line"] == 2


def test_leaving_python_is_an_error_like_any_other(page):
    assert not page.run("raise SystemExit(3)", "cell 1")
    assert failed(page)["name"] == "SystemExit"


def test_endless_output_is_cut_and_says_so(page):
    assert page.run("for i in range(1000): print(i, 'x' * 20)", "cell 1")
    assert len(said(page, "stdout")) == 1000
    assert "more characters were printed" in said(page, "stderr")


def test_a_caller_who_wants_more_or_less_says_so(page):
    assert page.run("print('x' * 5000)", "cell 1", 10_000)
    assert len(said(page, "stdout")) == 5001
    assert page.run("print('y' * 5000)", "cell 2", 10)
    assert said(page, "stdout").count("y") == 10


def test_a_rejected_exercise_speaks_for_itself(page):
    text = "from slambook.exercises import check\ndef gain(P, Q, R):\n    return P[0]\ncheck('kalman_filter.3', gain)"
    assert not page.run(text, "cell 1")
    found = failed(page)
    assert found["line"] == 3
    assert found["text"].startswith("Rejected:")


def test_an_exercise_that_is_not_written_is_not_judged(page):
    text = "from slambook.exercises import check\ndef gain(P, Q, R):\n    ...\ncheck('kalman_filter.3', gain)"
    assert page.run(text, "cell 1")
    assert "write the function, then run the cell again" in said(page, "stdout")


def test_extensions_and_their_magics_work_as_in_a_notebook(page):
    assert page.run("%load_ext slamlib.codegen\n1", "cell 1")
    text = (ROOT / "slamlib" / "geometry" / "pose.py").read_text("utf-8")
    assert page.run("%%tangle slamlib/geometry/pose.py\n" + text, "cell 2")
    assert "this cell is slamlib/geometry/pose.py" in said(page, "stdout")
    assert page.run("compose", "cell 3")
    assert not page.run("%unknown 3", "cell 4")


def test_a_figure_with_a_slider_asks_for_frames(page):
    page.run("class S:\n    label, values, start, steps, names, button = 'x', [1, 2], 0, 4, [], '<p>'\n"
             "    def frame(self, p): return (str(p), '<svg/>', 'note')\nS()", "cell 1")  # fmt: skip
    shown = json.loads(json.loads(said(page, "value"))["slider"])
    wanted = {"key": "cell 1", "last": 1, "steps": 4, "names": [], "button": "<p>", "frame": ["0", "<svg/>", "note"]}
    assert {name: shown[name] for name in wanted} == wanted
    assert json.loads(page.frame("cell 1", 0.25)) == ["0.25", "<svg/>", "note"]


@pytest.fixture
def plotting(page, monkeypatch):
    """The page's runner, where matplotlib has not been imported yet."""
    for name in [n for n in sys.modules if n.partition(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    yield page
    for name in ("matplotlib", "matplotlib.pyplot", "matplotlib.axes", "matplotlib.contours"):
        sys.modules.pop(name, None)


def shown(page):
    return [json.loads(text) for kind, text in page.sent if kind == "value"]


def test_matplotlib_is_a_stand_in_that_draws_as_the_book_does(plotting):
    text = "import matplotlib.pyplot as plt\nplt.style.use('slambook.book')\nfrom slambook.figures import picture\n"
    text += "fig, ax = plt.subplots()\nax.plot([1, 2], label='a')\nax.legend()\n"
    assert plotting.run(text + "picture(fig, alt='A line that goes up, and no more.')", "cell 1")
    (value,) = shown(plotting)
    assert value["text"] == "Picture: A line that goes up, and no more."
    assert value["html"].startswith('<div class="picture"><svg viewBox="0 0 417.6 252"')
    assert "stand-in" in sys.modules["matplotlib"].__version__


def test_open_figures_are_shown_once_at_the_end_of_their_cell(plotting):
    assert plotting.run("import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.title('up')\nplt.show()", "cell 1")
    assert [v["text"] for v in shown(plotting)] == ["A figure: up"]
    assert plotting.run("fig, ax = plt.subplots()\nax.bar([1], [2])\nax.set_title('bar')\nfig", "cell 2")
    assert [v["text"] for v in shown(plotting)][1:] == ["A figure: bar"]
    assert plotting.run("plt.figure()\n1", "cell 3")  # without axes there is nothing to show
    assert [v["text"] for v in shown(plotting)][2:] == ["1"]
    assert plotting.run("plt.plot([1]); plt.close()", "cell 4")
    assert len(shown(plotting)) == 3


@pytest.mark.parametrize(
    ("code", "lacks"),
    [
        ("plt.pie([1])", "the page's matplotlib is a small stand-in and has no pie in pyplot"),
        ("plt.subplots()[1].twinx()", "the page's matplotlib is a small stand-in and has no twinx in axes"),
        ("plt.gcf().colorbar()", "the page's matplotlib is a small stand-in and has no colorbar in a figure"),
        ("plt.subplots(2, sharex=True)", "the page's matplotlib is a small stand-in and has no sharex in subplots"),
        ("import matplotlib.patches", "the page's matplotlib is a small stand-in: it has matplotlib.pyplot, and no"),
        ("import matplotlib\nmatplotlib.use('agg')", "the page's matplotlib is a small stand-in and has no use"),
    ],
)
def test_what_the_stand_in_lacks_it_says(plotting, code, lacks):
    assert not plotting.run("import matplotlib.pyplot as plt\n" + code, "cell 1")
    assert lacks in failed(plotting)["text"]


def test_what_readers_type_first_is_there(plotting):
    calls = """hist([1, 2, 2]) | grid() | xlabel("x") | semilogx([1, 2]) | errorbar([1, 2], [1, 2], yerr=0.1) | legend()
    quiver([0], [0], [1], [1]) | imshow([[1, 2]]) | contour([[0, 1], [1, 2]]) | scatter([1], [2]) | xlim(1, 9)
    fill_between([1, 2], [0, 1]) | axhline(1) | axvspan(0, 1) | text(0, 0, "a") | annotate("b", (0, 0)) | axis("equal")
    barh(["a", "b"], [1, 2]) | step([1, 2], [1, 2]) | vlines([1], 0, 1) | loglog([1, 2]) | fill([0, 1], [1, 2])"""
    for call in calls.replace("\n", " | ").split(" | "):
        assert plotting.run(f"import matplotlib.pyplot as plt\nplt.{call.strip()};", "cell 1"), failed(plotting)["text"]
    assert all(value["text"].startswith("A figure") for value in shown(plotting))


def test_a_package_is_fetched_when_it_is_first_imported(tmp_path, monkeypatch):
    spec = importlib.util.spec_from_file_location("book_runner", ROOT / "book" / "live" / "runner.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr("late_one.py", "x = 3")
        archive.writestr("late_two.py", "y = 4")
    asked = []
    later = module.Later(
        lambda name: asked.append(name) or buffer.getvalue(), {"late_one": "a.zip", "late_two": "a.zip"}
    )
    monkeypatch.setattr(module, "PACKAGES", str(tmp_path))
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path, later])
    assert importlib.import_module("late_one").x == 3
    assert importlib.import_module("late_two").y == 4
    assert asked == ["a.zip"]
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module("never_heard_of")


# -- numerical results where nothing raises ----------------------------------------------------------------------------


def test_a_factorization_that_fails_silently_is_noticed(monkeypatch):
    """In WebAssembly a Cholesky factor of what is not positive is NaN, and the inverse of a singular matrix too."""
    from slamlib import belief
    from slamlib.evaluation import consistency
    from slamlib.kalman import linalg

    real = np.linalg.cholesky

    def silent(matrix):
        try:
            return real(matrix)
        except np.linalg.LinAlgError:
            return np.full_like(matrix, np.nan)

    monkeypatch.setattr(np.linalg, "cholesky", silent)
    monkeypatch.setattr(np.linalg, "inv", lambda m: np.full_like(m, np.nan))
    monkeypatch.setattr(np.linalg, "solve", lambda a, b: np.full_like(b, np.nan))
    bad = np.array([[1.0, 2.0], [2.0, 1.0]])
    with pytest.raises(SlamlibError):
        consistency.nees(np.ones(2), bad)
    with pytest.raises(SlamlibError):
        linalg.covariance(bad, 2, "test", "P")
    filter_ = belief.Belief()
    block = filter_.add(2, np.zeros(2), covariance=np.eye(2))
    with pytest.raises(SlamlibError):
        filter_.update([block], [np.eye(2)], np.ones(2), bad)
    np.testing.assert_array_equal(filter_.covariance(block), np.eye(2))


# -- the cells of the chapters -----------------------------------------------------------------------------------------


def chapters():
    if not (ROOT / "book").is_dir():
        return []
    from book.tools import layout

    return layout.lessons()


def code_cells(chapter, tag):
    cells = json.loads(chapter.read_text("utf-8"))["cells"]
    return ["".join(c["source"]) for c in cells if tag in c["metadata"].get("tags", [])]


def signature(source, name):
    """Name, arguments and length of the function that a cell has checked, or from which it makes what is checked."""
    functions = [n for n in ast.parse(source).body if isinstance(n, ast.FunctionDef)]
    function = next((f for f in functions if f.name == name), functions[-1])
    return function.name, [a.arg for a in function.args.args], len(function.body)


@pytest.mark.parametrize("chapter", chapters(), ids=lambda c: c.stem)
def test_every_checked_exercise_has_a_live_cell_with_its_signature_and_nothing_else(chapter):
    stubs = {m[1]: (m[2], s) for s in code_cells(chapter, "exercise") for m in CHECK.finditer(s)}
    solved = {m[1]: (m[2], s) for s in code_cells(chapter, "solution") for m in CHECK.finditer(s)}
    assert len(stubs) >= (3 if chapter.parent.name == "chapters" else 0)
    assert set(stubs) == set(solved)
    for number, (checked, source) in stubs.items():
        name, arguments, statements = signature(source, checked)
        assert (name, arguments) == signature(solved[number][1], checked)[:2]
        assert statements == 1
        assert f"def {name}({', '.join(arguments)}):\n    ...\n" in source


@pytest.mark.parametrize("chapter", chapters(), ids=lambda c: c.stem)
def test_a_chapter_runs_in_the_page_but_for_what_is_tagged_otherwise(chapter):
    cells = [c for c in json.loads(chapter.read_text("utf-8"))["cells"] if c["cell_type"] == "code"]
    tags = [set(c["metadata"].get("tags", [])) for c in cells]
    assert all(len(t & {"live", "not-live"}) == 1 for t in tags)
    assert sum("not-live" in t for t in tags) <= 3


def bound(code):
    """The names that a cell's own level binds, but for imports."""
    steps = list(dis.get_instructions(code))
    stored = [k for k, step in enumerate(steps) if step.opname == "STORE_NAME"]
    return {steps[k].argval for k in stored if not steps[k - 1].opname.startswith("IMPORT")}


def functions(code):
    """The code of the functions that a cell defines, by name."""
    return {inner.co_name: inner for inner in code.co_consts if hasattr(inner, "co_code")}


def looked_up(code):
    """The names that a function and those in it look up in the notebook."""
    own = {step.argval for step in dis.get_instructions(code) if step.opname == "LOAD_GLOBAL"}
    return own.union(*(looked_up(inner) for inner in functions(code).values()))


@pytest.mark.parametrize("chapter", chapters(), ids=lambda c: c.stem)
def test_what_a_slider_draws_from_is_still_there_when_all_cells_have_run(chapter):
    cells = json.loads(chapter.read_text("utf-8"))["cells"]
    sources = [re.sub("(?m)^%.*$", "", "".join(c["source"])) for c in cells if c["cell_type"] == "code"]
    cells = [compile(source, "cell", "exec") for source in sources]
    known = {}
    for k, (source, code) in enumerate(zip(sources, cells, strict=True)):
        known.update(functions(code))
        drawn = re.findall(r"(?m)^sweep\(\s*(\w+)", source)
        needed, waiting = set(), [(name, known[name]) for name in drawn]
        while waiting:
            new = looked_up(waiting.pop()[1]) - needed
            needed |= new
            waiting += [(name, known[name]) for name in new & known.keys()]
        assert needed & set().union(*map(bound, cells[k + 1 :])) == set(), source


@pytest.mark.parametrize("chapter", chapters(), ids=lambda c: c.stem)
def test_what_a_live_cell_uses_no_other_cell_has_defined(chapter):
    """The page does not run what is tagged not-live: a name that only such a cell binds is missing there."""
    cells = [compile(re.sub("(?m)^%.*$", "", s), "cell", "exec") for s in code_cells(chapter, "live")]
    steps = [step for code in cells for step in dis.get_instructions(code)]
    bound_somewhere = {step.argval for step in steps if step.opname == "STORE_NAME"} | set(dir(builtins))
    used = {step.argval for step in steps if step.opname == "LOAD_NAME"}.union(*map(looked_up, cells))
    assert used - bound_somewhere - {"__name__", "__annotations__", "get_ipython"} == set()


# -- archives, the ZIP -------------------------------------------------------------------------------------------------


@pytest.fixture
def tools(monkeypatch):
    """The book's tools as modules."""
    monkeypatch.syspath_prepend(str(ROOT))
    from book.tests.site import parity
    from book.tools import assets, build, layout, live

    return {"assets": assets, "build": build, "layout": layout, "live": live, "parity": parity}


def test_the_pages_opencv_undistorts_as_opencv_does():
    cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")
    rng = np.random.default_rng(4)
    matrix, turn = np.array([[260, 0, 158], [0, 258, 121], [0, 0, 1.0]]), np.linalg.qr(rng.standard_normal((3, 3)))[0]
    turn = np.eye(3) + 0.02 * (turn - turn.T)  # nearly a rotation
    for distortion in (rng.uniform(-0.05, 0.05, 8), [0.2624, -0.9531, -0.0054, 0.0026, 1.1633, 0, 0, 0]):
        given = matrix, np.array(distortion), turn, matrix, (320, 240), cv2.CV_32FC1
        maps, expected = opencv.initUndistortRectifyMap(*given), cv2.initUndistortRectifyMap(*given)
        assert np.abs(np.subtract(maps, expected)).max() < 1e-3
        image = rng.integers(0, 256, (240, 320)).astype(np.uint8)
        ours, theirs = (module.remap(image, *expected, module.INTER_LINEAR).astype(int) for module in (opencv, cv2))
        inside = (expected[0] > 0) & (expected[0] < 319) & (expected[1] > 0) & (expected[1] < 239)
        assert 0.8 < inside.mean() < 1  # so that the border is tried, too
        assert np.abs(ours - theirs).max() <= 1
        assert (ours != theirs).mean() < 1e-3
    assert opencv.CV_32FC1 == cv2.CV_32FC1
    assert opencv.IMREAD_UNCHANGED == cv2.IMREAD_UNCHANGED


def test_the_pages_opencv_reads_plain_grey_and_says_what_it_has_not():
    image = np.arange(6, dtype=np.uint8).reshape(2, 3) + 10  # 10 is the end of a line, too
    data = np.frombuffer(b"P5 3 2 255\n" + image.tobytes(), np.uint8)
    assert np.array_equal(opencv.imdecode(data, opencv.IMREAD_UNCHANGED), image)
    assert opencv.imdecode(np.frombuffer(b"\xff\xd8\xff", np.uint8), opencv.IMREAD_UNCHANGED) is None
    with pytest.raises(SlamlibError, match=r"no cv2\.ORB_create: download the notebook"):
        opencv.ORB_create()
    assert not hasattr(opencv, "matchTemplate")


def test_an_archive_with_another_checksum_is_refused_and_not_kept(tools, monkeypatch, tmp_path):
    assets = tools["assets"]
    monkeypatch.setattr(assets, "ASSETS", tmp_path)
    monkeypatch.setitem(assets.DOWNLOADS, "npm", lambda package: b"something else")
    with pytest.raises(assets.AssetError, match="the checksum is"):
        assets.archive("axe")
    assert list(tmp_path.iterdir()) == []


def test_without_a_network_the_message_says_what_is_missing(tools, monkeypatch, tmp_path):
    assets = tools["assets"]
    monkeypatch.setattr(assets, "ASSETS", tmp_path)
    monkeypatch.setattr(assets, "NPM", "http://127.0.0.1:9")
    with pytest.raises(assets.AssetError, match=r"axe-core-4.* cannot be downloaded.*is the network there"):
        assets.archive("axe")


def test_the_book_to_take_away_holds_the_site_once_and_its_script(tools, tmp_path):
    (tmp_path / "book").mkdir()
    (tmp_path / "index.html").write_text("hello", "utf-8")
    (tmp_path / "book" / "page.html").write_text("page", "utf-8")
    first = tools["build"].pack(tmp_path).read_bytes()
    again = tools["build"].pack(tmp_path)
    assert again.read_bytes() == first
    with zipfile.ZipFile(again) as archive:
        names = sorted(archive.namelist())
    inside = ["READ_ME.txt", "book/page.html", "index.html", "open_the_book.py"]
    assert names == [f"{tools['build'].FOLDER}/{n}" for n in inside]


def test_a_number_that_differs_is_found(tools):
    parity = tools["parity"]
    ours = {"numbers": {"a": [1.0, 2e6], "b": [1.0]}}
    assert parity.compare(ours, {"numbers": {"a": [1.0, 2e6], "b": [1.0]}})[1] == []
    assert "differs by" in parity.compare(ours, {"numbers": {"a": [1.0, 2e6 + 1e-4], "b": [1.0]}})[1][0]
    assert "not all of them finite" in parity.compare(ours, {"numbers": {"a": [1.0, float("nan")], "b": [1.0]}})[1][0]
    assert "one side only" in parity.compare(ours, {"numbers": {"a": [1.0, 2e6]}})[1][0]


def test_the_table_of_the_book_is_about_every_model(tools):
    from slamlib.codegen.__main__ import models

    named = {row[0] for row in tools["parity"].stored()}
    for path, own in models().items():
        module = str(path).removesuffix(".py").replace("/", ".").removeprefix("slamlib.")
        assert {f"{module}.{m.name}" for m in own} <= named


WITHOUT = """
import importlib, pkgutil, sys
from book.tools.live import NOT_STANDARD


def absent(name):
    return name.split(".")[0] in sys.stdlib_module_names and NOT_STANDARD.match(name.replace(".", "/") + ".py")


class Absent:
    def find_spec(self, name, path=None, target=None):
        if absent(name):
            raise ModuleNotFoundError(f"the page's Python has no {name}")


for name in filter(absent, list(sys.modules)):
    del sys.modules[name]
sys.meta_path.insert(0, Absent())
import slamlib

tried = [m.name for m in pkgutil.walk_packages(slamlib.__path__, "slamlib.") if ".tests" not in m.name]
for name in tried:
    importlib.import_module(name)
print(len(tried))
"""


def test_every_module_of_the_package_is_imported_by_the_pages_python_which_lacks_parts_of_the_library():
    done = subprocess.run([sys.executable, "-c", WITHOUT], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 100
