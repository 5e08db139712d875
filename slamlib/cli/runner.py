"""Execution of a run, simulated or on images: files checked first, a bar, a window or video; saved where it stops."""

import argparse
import json
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import tee
from math import isfinite
from pathlib import Path
from types import FrameType
from typing import Generic, Protocol, TypeVar

from slamlib.cli.drawing import ErrorSeries, drawing
from slamlib.datasets.pictures import is_image_name
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import beside
from slamlib.experiments.progress import progress
from slamlib.plain_data.files import check_writable, write_whole
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

EXIT_ERROR = 2
STOPPED: dict[int, str] = {signal.SIGINT: "interrupted", signal.SIGTERM: "terminated"}
FILES = ("save", "trajectory", "map", "plot", "json")  # options whose value is a file that is written
SOURCES = ("source", "left", "right")  # options whose value is where pictures are
# What a resumed run of any command may be told: how far it goes, what it is compared with, and what is made of it.
CONTINUED = (
    "resume",
    "overwrite",
    "video",
    "live",
    "frames",
    "patience",
    "reference",
    "reference_format",
    "reference_std",
    *FILES,
)
Shown = tuple[Snapshot, Truth | None]
S = TypeVar("S")  # a step of a run
StepOut = TypeVar("StepOut", covariant=True)
R = TypeVar("R")


class StepwiseRun(Protocol[StepOut]):
    """A run that goes on step by step, and can be saved between two of them."""

    is_intact: bool  # False within a step, where nothing can be saved

    @property
    def done(self) -> int:
        """Number of steps made."""

    def __len__(self) -> int:
        """Number of remaining steps."""

    def __iter__(self) -> Iterator[StepOut]:
        """Make the remaining steps, one at a time."""

    def save(self, path: str) -> None:
        """Write all of it to one file. Raises SlamlibError within a step."""


@dataclass(frozen=True)
class Job(Generic[S]):
    """A run, and what its execution needs to know of it.

    label: on the progress bar. command: resumes it. file: where it is saved if it stops and no other file is given.
    shown(step): what a window or a video shows; None: at the start. each(step): called after each step. fps: of a
    video. world: shown as the truth.
    """

    run: StepwiseRun[S]
    label: str
    command: str
    file: str
    shown: Callable[[S | None], Shown]
    item: str = "frame"
    fps: float = 10.0
    world: World | None = None
    each: Callable[[S], None] = lambda step: None


@dataclass
class RunEnd:
    """How a run ended: the exit status, and why it stopped early, or None."""

    status: int = 0
    why: str | None = None

    def by(self, why: str, status: int = EXIT_ERROR) -> None:
        """Record a reason for stopping; the first status is kept."""
        self.status, self.why = self.status or status, why if self.why is None else f"{self.why}\n{why}"


def check_files(given: argparse.Namespace) -> None:
    """Raise SlamlibError, before the run, for a file that could not be written after it; make the folders."""
    files = [(name, path) for name in FILES if (path := getattr(given, name, None)) not in (None, "-")]
    files += [(name, str(beside(path))) for name, path in files if name == "trajectory"]  # its covariances
    _check_apart(given, files)
    for name, path in files:
        if name == "map":
            drawing().check_map(path)
        elif name == "plot":
            drawing().check_plot(path)
        if Path(path).is_file() and not given.overwrite and path != getattr(given, "resume", None):
            raise SlamlibError(f"--{name}: {path} exists: choose another name, or replace it with --overwrite")
        check_writable(path)
    if getattr(given, "video", None):
        drawing().check_video(given.video, overwrite=given.overwrite)
        check_writable(Path(given.video).parent / ".video")


def _check_apart(given: argparse.Namespace, files: list[tuple[str, str]]) -> None:
    """Raise SlamlibError where two outputs would be one file, or one within the other's folder, or one is an input."""
    videos = [("video", given.video)] if getattr(given, "video", None) else []
    written = [(name, path, Path(path).resolve()) for name, path in files + videos]
    for row, (name, path, place) in enumerate(written):
        for other, _, taken in written[:row]:
            if place == taken or place in taken.parents or taken in place.parents:
                what = f"--{other}" if name != other else f"--{other} itself, for these would be its covariances"
                raise SlamlibError(
                    f"--{name}: {path} is also where something else goes, by {what}: choose another name"
                )
    for name, path, place in written:
        for option, value in vars(given).items():
            is_output = option in (*FILES, "video") or (name, option) == ("save", "resume")
            words = [] if is_output else value if isinstance(value, list) else [value]
            if any(_reads(option, word, place) for word in words):
                raise SlamlibError(f"--{name}: {path} is read by the command ({option}): choose another name")


def _reads(option: str, value: object, place: Path) -> bool:
    """Whether what is at a place is what an option names: a file, the folder of pictures, or a picture in it."""
    if not isinstance(value, str):
        return False
    try:
        named = Path(value).expanduser().resolve()
        if option not in SOURCES or named.is_file():
            return place == named and named.is_file()
        folder = named if named.is_dir() else named.parent  # of a glob
        is_picture = is_image_name(place) and place.is_file() and folder in place.parents
        return is_picture or place in (folder, *folder.parents)
    except (OSError, RuntimeError, ValueError):  # too long for a name, for instance
        return False


def export_map(given: argparse.Namespace, snapshot: Callable[[], Snapshot]) -> None:
    """Write the map of a snapshot where --map says so."""
    if given.map:
        drawing().write_map(given.map, snapshot())


def export_plot(given: argparse.Namespace, series: Callable[[], ErrorSeries]) -> None:
    """Draw errors over time where --plot says so."""
    if given.plot:
        drawing().write_plot(given.plot, series())


def print_result(given: argparse.Namespace, result: object, text: str) -> None:
    """Print the result, as text or as JSON; --json FILE writes it, too."""
    data = json.dumps(_in_json(result), indent=2, allow_nan=False)
    print(data if given.json == "-" else text)
    if given.json not in (None, "-"):
        write_whole(given.json, data + "\n")


def _in_json(value: object) -> object:
    """Plain data with null for what JSON has no number for: nan and infinity."""
    if isinstance(value, dict):
        return {name: _in_json(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_in_json(part) for part in value]
    return None if isinstance(value, float) and not isfinite(value) else value


def new_or_resumed(
    given: argparse.Namespace,
    new: Callable[[argparse.Namespace], R],
    load: Callable[[str], R],
    places: tuple[str, ...] = (),
) -> R:
    """A new run, or the one that --resume names. Raises SlamlibError for an option that only a new one can take.

    places: options that say where the input of a resumed run is now.
    """
    if not given.resume:
        return new(given)
    for name, value in vars(given).items():
        if name not in (*CONTINUED, *places, "command") and value != given.parser.get_default(name):
            flag = "the preset's name" if name == "preset" else "--" + name.replace("_", "-")
            raise SlamlibError(f"--resume continues the run of its file as it was begun: leave {flag} out")
    return load(given.resume)


def execute(job: Job[S], given: argparse.Namespace) -> RunEnd:
    """Run to the end, or until something stops it; save it then, or where --save says so.

    Raises SlamlibError if nothing was run.
    """
    asked: list[int] = []  # Ctrl-C and SIGTERM wait for the end of the frame: within one no run can be saved
    with signals(lambda number, _: asked.append(number), *STOPPED):
        ended, before = RunEnd(), job.run.done
        steps = _steps(job, given, ended, asked)
        try:
            if given.video:
                if before:
                    print(f"slamlib: the video begins at {job.item} {before + 1}, the run's next one", file=sys.stderr)
                pairs = (pair for pair in steps if pair is not None)
                shown, truths = (pairs, None) if job.world is None else tee(pairs)
                drawing().write_video(
                    (snapshot for snapshot, _ in shown),
                    given.video,
                    truths=(truth for _, truth in truths if truth is not None) if truths else (),
                    world=job.world,
                    fps=job.fps,
                    overwrite=given.overwrite,
                )
            else:
                deque(steps, maxlen=0)
        except Exception as error:
            if not job.run.is_intact or not given.video or (job.run.done == before and not ended.why):
                raise
            ended.by(f"the video cannot be written: {error}")
        if job.run.done == before and ended.why:
            raise SlamlibError(ended.why)
        if ended.why or given.save:
            _keep(job, given, ended)
    return ended


def _keep(job: Job[S], given: argparse.Namespace, ended: RunEnd) -> None:
    """Save the run; errors are reported, and make the exit status one of an error."""
    path = given.save or given.resume or _free(job.file)
    if ended.why:
        print(f"slamlib: {ended.why}", file=sys.stderr)
    try:
        job.run.save(path)
    except SlamlibError as error:
        ended.status = EXIT_ERROR
        print(f"slamlib: the run is not saved: {error}", file=sys.stderr)
        return
    if ended.why:
        done = f"saved after {job.run.done} {job.item}{'s' * (job.run.done != 1)}"
        words = f"slamlib {job.command} --resume {path}" + f" --save {path}" * bool(given.save)
        print(f"slamlib: {done}; resume with: {words}", file=sys.stderr)


def _free(path: str) -> str:
    """The path, or with a number where there is a file already."""
    name, number = Path(path), 1
    while name.exists():
        number += 1
        name = Path(path).with_stem(f"{Path(path).stem}-{number}")
    return str(name)


def _steps(job: Job[S], given: argparse.Namespace, ended: RunEnd, asked: list[int]) -> Iterator[Shown | None]:
    """Run step by step; yield what a video shows, if there is one. Errors end the run and are recorded."""
    window = None
    if given.live:
        window = drawing().open_window(job.shown(None)[0], world=job.world)
    try:
        for step in progress(job.run, len(job.run), job.label):
            job.each(step)
            shown = job.shown(step) if window or given.video else None
            if window and shown:
                window.update(*shown)
            yield shown
            if asked:
                ended.by(STOPPED[asked[0]], 128 + asked[0])
                return
    except SlamlibError as error:
        ended.by(str(error))


@contextmanager
def signals(handler: Callable[[int, FrameType | None], None], *numbers: int) -> Iterator[None]:
    """Within the block these signals are the handler's; outside of the main thread, which alone gets them, nothing."""
    is_main = threading.current_thread() is threading.main_thread()
    before = {number: signal.signal(number, handler) for number in numbers if is_main}
    try:
        yield
    finally:
        for number, own in before.items():
            signal.signal(number, own)
