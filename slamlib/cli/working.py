"""What a command does while a run on pictures works: a bar, a film or a window, and a stop that loses nothing."""

import argparse
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from slamlib.data.snapshots import Snapshot
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import write_tum
from slamlib.experiments.progress import progress
from slamlib.vision.sequence_run import ImageStep, Stepping

MISTAKE, INTERRUPTED = 2, 130


@dataclass
class Outcome:
    """How a run ended: the exit status, and why it stopped before its end, or None."""

    status: int = 0
    stopped: str | None = None


def work(run: Stepping, given: argparse.Namespace, command: str) -> Outcome:
    """Run it to its end, or until something stops it; what was done is written and saved in both cases.

    command: the one that goes on with it, "run images"; what stopped and has no name is slamlib-images.npz then.
    """
    _check_places(given)
    outcome = Outcome()
    try:
        _consume(_shown(run, given, outcome), given.video, 1 / (run.source.interval * run.source.frames.step))
    except Exception as error:
        if not run.whole or not given.video:
            raise
        why = f"the film cannot be written: {error}"
        outcome.status = outcome.status or MISTAKE
        outcome.stopped = why if outcome.stopped is None else f"{outcome.stopped}\n{why}"
    if run.history and given.trajectory:
        write_tum(given.trajectory, run.trajectory())
    if run.history and (outcome.stopped or given.save):
        _keep(run, given.save, outcome.stopped, command)
    return outcome


def _check_places(given: argparse.Namespace) -> None:
    """Raise SlamlibError for what could not be written after the run: better before it."""
    for path in filter(None, (given.trajectory, given.save)):
        if not Path(path).absolute().parent.is_dir() or Path(path).is_dir():
            raise SlamlibError(f"{path} cannot be written: its folder is not there, or it is a folder itself")
    if given.video:
        from slambook.scene.video import ready

        ready(given.video)


def _keep(run: Stepping, chosen: str | None, stopped: str | None, command: str) -> None:
    path = chosen or f"slamlib-{command.split()[-1]}.npz"
    if not run.whole:
        print(f"slamlib: {stopped}; the frame was broken off, and the run cannot be saved", file=sys.stderr)
        return
    run.save(path)
    if stopped:
        done = f"after {len(run.history)} {run.of}; go on with: slamlib {command} --resume {path}"
        print(f"slamlib: {stopped}\nslamlib: saved {done}", file=sys.stderr)


def _shown(run: Stepping, given: argparse.Namespace, outcome: Outcome) -> Iterator[Snapshot | None]:
    """Step by step; snapshots are made if somebody looks at them. What stops the run ends them, and is told."""
    window, warned = _window(run) if given.live else None, False
    try:
        with _interrupts() as asked:
            for step in progress(run, len(run), run.source.where.rpartition("/")[2]):
                warned = warned or _warn(run, step)
                snapshot = run.snapshot() if window is not None or given.video else None
                if window is not None:
                    window.update(snapshot)
                yield snapshot
                if asked:
                    raise KeyboardInterrupt
    except KeyboardInterrupt:
        outcome.status, outcome.stopped = INTERRUPTED, "interrupted"
    except SlamlibError as error:
        outcome.status, outcome.stopped = MISTAKE, str(error)


def _warn(run: Stepping, step: ImageStep) -> bool:
    if not run.gap.frames:
        return False
    what = f"no match in {step.picture.name}: the filter predicts, and stops after {run.patience} such frames in a row"
    print(f"\nslamlib: {what} (said once; they are counted)", file=sys.stderr)
    return True


@contextmanager
def _interrupts() -> Iterator[list[int]]:
    """Ctrl-C is taken note of in the list, for the end of the frame: the middle of one cannot be saved."""
    asked: list[int] = []
    try:
        before = signal.signal(signal.SIGINT, lambda number, _: asked.append(number))
    except ValueError:  # not in the main thread, where nobody presses Ctrl-C
        yield asked
        return
    try:
        yield asked
    finally:
        signal.signal(signal.SIGINT, before)


def _window(run: Stepping) -> Any:
    from slambook.scene import Window

    return Window(run.snapshot(), show=True)


def _consume(snapshots: Iterator[Snapshot | None], video: str | None, fps: float) -> None:
    if video is None:
        for _ in snapshots:
            pass
        return
    from slambook.scene import animate

    animate((snapshot for snapshot in snapshots if snapshot is not None), video, fps=fps)
