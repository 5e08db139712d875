"""What README, *Using slamlib* and *Your own data* tell to type works, with just the packages that they name.

In a fenced block a comment that begins with names in brackets, as in `# [images,draw]`, names the extras that a command
needs; one without needs NumPy alone. A command that says in its comment that it takes minutes is shortened to two
frames. `<!-- not run: why -->` above a block excuses it from being run. Everything else that the command `slamlib` is
told, is told to it here; pictures and paths of the reader's own are a few rendered ones. Of what is not run (make, pip,
JupyterLab, and commands inside a sentence) the arguments are checked.
"""

import ast
import importlib.util
import json
import os
import re
import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import slamlib
from book.tests.bare import extras
from book.tools import layout
from slamlib import cli

APPENDICES = layout.BOOK / "appendices"
PAGES = [
    *(layout.ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")),
    *(layout.ROOT / "slamlib").glob("README.md"),
    *(APPENDICES / name for name in ("using_slamlib.md", "your_own_data.ipynb")),
]
BLOCK = re.compile(r"^(?:<!-- not run: (?P<why>.+?) -->\n+)?```(?P<kind>sh|python)\n(?P<text>.*?)^```$", re.M | re.S)
COMMENT = re.compile(r"(?:^|\s\s+)#\s*(?:\[(?P<extras>[\w,]+)\])?(?P<words>.*)$")
INLINE = re.compile(r"`((?:slamlib|make|pip|python -m|pytest|pre-commit|dask) [^`\n]+)`")
LONG = re.compile(r"\b(?:minutes?|hours?)\b")
LENS = {"intrinsics": (79.5, 59.5, 130.0, 130.0), "distortion": (0.0,)}
CAMERA = """image_width: 160
image_height: 120
camera_matrix:
  rows: 3
  cols: 3
  data: [130.0, 0.0, 79.5, 0.0, 130.0, 59.5, 0.0, 0.0, 1.0]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.0, 0.0, 0.0, 0.0, 0.0]
"""
# What a snippet leaves to its reader to define.
OF_THE_READER = {"gain": "def gain(P, Q, R):\n    return (P + Q) / (P + Q + R)\n\n"}


@dataclass(frozen=True)
class Command:
    """A command without its comment, and what the comment says: the extras, and whether it takes minutes."""

    text: str
    extras: tuple[str, ...] = ()
    long: bool = False

    @classmethod
    def of(cls, line: str) -> "Command":
        """The command of a line."""
        comment = COMMENT.search(line)
        if comment is None:
            return cls(line.strip())
        names = tuple((comment["extras"] or "").split(","))
        known = names if set(names) <= set(extras()) else ()  # or it is a unit, such as [m]
        return cls(line[: comment.start()].strip(), known, LONG.search(comment["words"]) is not None)

    @property
    def words(self) -> list[str]:
        """The words, without variables before them and the file into which the output goes."""
        words = shlex.split(self.text.partition(" > ")[0])
        return words[next(i for i, word in enumerate(words) if "=" not in word) :]

    @property
    def short(self) -> str:
        """The command as it is run."""
        less = " --frames 2" + " --runs 2" * (self.words[1] == "compare")
        return self.text + less * self.long


@dataclass(frozen=True)
class Block:
    """A fenced block of a page: shell or Python, and why it is not run, if it is not."""

    page: str
    kind: str
    text: str
    why: str | None

    def __str__(self) -> str:
        first = Command.of(self.text.partition("\n")[0]).text
        return f"{self.page}: {first}"

    @property
    def commands(self) -> list[Command]:
        """Its commands."""
        lines = re.sub(r"\\\n\s*", "", self.text).splitlines()
        return [command for command in map(Command.of, lines) if command.text]

    @property
    def run(self) -> list[Command]:
        """Those that are run."""
        return [c for c in self.commands if c.words[0] == "slamlib"] if self.kind == "sh" and not self.why else []

    @property
    def snippet(self) -> Command:
        """A block of Python as one command."""
        named = next((c for c in map(Command.of, self.text.splitlines()) if c.extras), Command(""))
        return Command(self.text, named.extras)


def prose(page: Path) -> str:
    """The text of a page."""
    text = page.read_text("utf-8")
    if page.suffix != ".ipynb":
        return text
    return "\n\n".join("".join(c["source"]) for c in json.loads(text)["cells"] if c["cell_type"] == "markdown")


def blocks(page: Path) -> list[Block]:
    """The fenced blocks of a page."""
    return [Block(page.name, m["kind"], m["text"], m["why"]) for m in BLOCK.finditer(prose(page))]


def inline(page: Path) -> list[Command]:
    """The commands inside its sentences."""
    return [Command(text) for text in INLINE.findall(BLOCK.sub("", prose(page)))]


BLOCKS = [block for page in PAGES for block in blocks(page)]
FIRST = {command: block for block in reversed(BLOCKS) for command in block.run}  # each once, if it stands on two pages
SHELL = [(b, own) for b in BLOCKS if (own := [command for command in b.run if FIRST[command] is b])]
PYTHON = {ast.unparse(ast.parse(b.text)): b for b in BLOCKS if b.kind == "python" and not b.why}  # each once, again
ALL = {c.text: c for block in BLOCKS if block.kind == "sh" for c in block.commands}
ALL |= {c.text: c for page in PAGES for c in inline(page) if c.text not in ALL}
NEEDY = {(cli._joined(c.words[1:])[0], c.extras): c for _, own in SHELL for c in own if c.extras}


# -- the arguments -----------------------------------------------------------------------------------------------------


def _slamlib(words: list[str]) -> None:
    """The command's own parser takes the arguments, with SystemExit if it does not; a name alone is one that it has."""
    if " ".join(words) not in {*cli.COMMANDS, "--version", "--help"}:
        cli.parser().parse_args(cli._joined(words))


def _make(words: list[str]) -> None:
    text = (layout.ROOT / "Makefile").read_text("utf-8")
    for word in words:
        name, equals, _ = word.partition("=")
        assert (f"$({name})" in text or f"or $({name})," in text) if equals else re.search(rf"^{name}:", text, re.M), (
            word
        )


def _pip(words: list[str]) -> None:
    """An extra of pyproject.toml, the wheel as it is called now, a package of the lock."""
    locked = set(re.findall(r"^([\w.-]+)==", (layout.ROOT / "requirements.txt").read_text("utf-8"), re.M))
    assert words[0] == "install"
    for word in words[1:]:
        name, bracket, names = word.rstrip("]").partition("[")
        assert set(names.split(",") if bracket else ()) <= set(extras()), word
        own = {".", "slamlib", f"slamlib-{slamlib.__version__}-py3-none-any.whl"}
        assert name in own | locked, word


def _python(words: list[str]) -> None:
    """The module is there, and knows the options."""
    assert words[0] == "-m"
    found = importlib.util.find_spec(words[1])
    assert found is not None
    assert found.origin is not None, words[1]
    known = set(re.findall(r'"(--[\w-]+)"', Path(found.origin).read_text("utf-8")))
    assert {word for word in words[2:] if word.startswith("--")} <= known, words
    _files(words[2:])


def _files(words: list[str]) -> None:
    """Files of the repository are there."""
    for word in words:
        assert not word.startswith("book/") or (layout.ROOT / word).exists(), word


def _jupyter(words: list[str]) -> None:
    assert words[0] == "lab"
    assert all((layout.BOOK / "chapters" / word).is_file() for word in words[1:])


def _pre_commit(words: list[str]) -> None:
    assert words == ["install"]
    assert (layout.ROOT / ".pre-commit-config.yaml").is_file()


def _dask(words: list[str]) -> None:
    assert words[0] in ("scheduler", "worker")


CHECKS = {
    "slamlib": _slamlib,
    "make": _make,
    "pip": _pip,
    "python": _python,
    "pytest": _files,
    "jupyter": _jupyter,
    "dask": _dask,
    "pre-commit": _pre_commit,
}


@pytest.mark.parametrize("command", ALL.values(), ids=ALL.keys())
def test_the_arguments_are_those_that_the_program_takes(command):
    program, *words = command.words
    assert program in CHECKS, "say here how its arguments are checked"
    CHECKS[program](words)


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("slamlib run points --landmrk idpPnt", SystemExit),
        ("slamlib rum points", SystemExit),
        ("slamlib run images --source 'frames/*.png' --fps fast", SystemExit),
        ("make bok", AssertionError),
        ("make chapter NAM=points", AssertionError),
        ("pip install '.[picture]'", AssertionError),
        ("pip install slamlib-0.0.9-py3-none-any.whl", AssertionError),
        ("python -m book.tools.no_such_tool", AssertionError),
        ("python -m book.experiments.audit --stor", AssertionError),
        ("pytest book/tests/test_nothing.py -q", AssertionError),
        ("git push", KeyError),
    ],
)
def test_a_wrong_argument_is_found(line, error, capsys):
    program, *words = Command.of(line).words
    with pytest.raises(error):
        CHECKS[program](words)


def test_a_comment_is_read():
    known = Command.of(
        "SLAMLIB_DATA=~/data slamlib run a --plot 'b #1.svg' > c.txt  # [images,draw] a film; two minutes"
    )
    assert known.extras == ("images", "draw")
    assert known.long
    assert known.words == ["slamlib", "run", "a", "--plot", "b #1.svg"]
    assert Command.of("make quick  # NumPy alone") == Command("make quick")
    assert Command.of("print(x)  # [m] truth minus estimate") == Command("print(x)")


def test_the_table_of_extras_is_that_of_the_package():
    rows = re.findall(r"^\| `(\w+)` \|", prose(APPENDICES / "using_slamlib.md"), re.M)
    assert sorted(rows) == sorted(extras())


# -- running -----------------------------------------------------------------------------------------------------------

runs = pytest.mark.skipif(os.name == "nt", reason="the pages' commands are a POSIX shell's; on Windows use WSL")


@pytest.mark.parametrize(
    ("named", "packages"),
    [((), "numpy"), (("experiments",), "numpy joblib"), (("images",), "numpy scipy cv2"), (("fast",), "numpy scipy")],
)
def test_an_environment_has_what_is_named_and_nothing_else(named, packages, bare):
    look = "print(*(n for n in 'numpy scipy sympy joblib cv2 matplotlib IPython pytest'.split() if find_spec(n)))"
    end = bare.run(bare.python, "-c", f"from importlib.util import find_spec; {look}", extras_named=named)
    assert end.stdout.split() == packages.split(), end.stderr


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    """What a reader brings: a film of one camera and of two, calibrations, and a path with its reference."""
    pytest.importorskip("cv2", reason="the commands on pictures need OpenCV")
    from slambook import rendering

    from slamlib.evaluation.trajectory import Trajectory, read_trajectory, write_tum

    folder = tmp_path_factory.mktemp("own")
    way = rendering.path("sideways")
    rig = rendering.rig_along_path(way, baseline=0.12, image=(160.0, 120.0), parameters=LENS)
    film = rendering.film(rendering.default_room(), rig, way, frames=8, dt=1 / 30, rng=np.random.default_rng(1))
    street = rendering.save_film(folder / "sequences" / "04", film)
    for name, camera in (("frames", 0), ("left", 0), ("right", 1)):
        shutil.copytree(street / f"image_{camera}", folder / name)
    (folder / "camera.yaml").write_text(CAMERA)
    (folder / "pair.json").write_text(json.dumps({"intrinsics": LENS["intrinsics"], "baseline": 0.12}))
    (folder / "poses").mkdir()
    for name in ("poses/04.txt", "groundtruth.txt"):
        shutil.copy(street / "groundtruth_0.txt", folder / name)
    truth = read_trajectory(folder / "groundtruth.txt")
    poses = truth.poses.copy()
    poses[:, :3] = 2 * poses[:, :3] + 1e-3 * np.random.default_rng(2).standard_normal((len(poses), 3))
    write_tum(folder / "path.txt", Trajectory(truth.times, poses))
    return folder


def written(text):
    """The files that commands write."""
    return re.findall(r"(?:--(?:video|map|plot|trajectory|json|svg)|>) (\w+\.\w+)", text)


@pytest.fixture
def desk(own, tmp_path):
    """desk(text): a reader's folder with all that is the reader's own, but for what the commands of the text write."""
    (tmp_path / "data").mkdir()

    def laid(text):
        folder = Path(shutil.copytree(own, tmp_path / "desk"))
        for file in written(text):
            (folder / file).unlink(missing_ok=True)
        return folder

    return laid


def typed(bare, folder, line, extras_named=()):
    """How a line ends that is typed in a reader's folder."""
    cache = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")  # matplotlib's list of fonts, for instance
    home = {"HOME": str(folder.parent), "XDG_CACHE_HOME": cache, "OPENBLAS_NUM_THREADS": "1"}
    return bare.run("bash", "-c", line, extras_named=extras_named, cwd=folder, **home)


@runs
@pytest.mark.parametrize("commands", [own for _, own in SHELL], ids=[str(block) for block, _ in SHELL])
def test_commands_run_with_just_what_they_name(commands, bare, desk):
    folder = desk("\n".join(command.text for command in commands))
    for command in commands:
        end = typed(bare, folder, command.short, command.extras)
        assert end.returncode == 0, f"{command.short}\n{end.stdout}{end.stderr}"
        for file in written(command.text):
            assert (folder / file).stat().st_size, file


@runs
@pytest.mark.parametrize("command", NEEDY.values(), ids=lambda command: command.text)
def test_without_its_extra_a_command_stops_and_says_which(command, bare, desk):
    end = typed(bare, desk(command.text), command.short)
    assert end.returncode == 2
    assert set(re.findall(r"pip install '\S*\[(\w+)\]'", end.stderr)) & set(command.extras), end.stderr


@runs
@pytest.mark.parametrize("block", PYTHON.values(), ids=str)
def test_snippets_run_with_just_what_they_name(block, bare, tmp_path):
    given = [text for name, text in OF_THE_READER.items() if re.search(rf"\b{name}\)", block.text)]
    file = tmp_path / "snippet.py"
    file.write_text("".join(given) + block.text)
    end = bare.run(bare.python, file, extras_named=block.snippet.extras, cwd=tmp_path, OPENBLAS_NUM_THREADS="1")
    assert end.returncode == 0, end.stderr


def test_there_is_something_to_run():
    assert len(FIRST) > 15
    assert len(PYTHON) >= 3
