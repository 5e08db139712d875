"""Execution of a run on images: progress bar, video or window, and saving when it is interrupted."""

import argparse
import json
import signal
import sys
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from slamlib.cli.arguments import aligned_rows, check_video
from slamlib.data.snapshots import Snapshot
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import read_trajectory, write_tum
from slamlib.experiments.progress import progress
from slamlib.vision.results import compared, summary, table
from slamlib.vision.sequence_run import SequenceRun

EXIT_ERROR, EXIT_INTERRUPTED = 2, 130
JUDGED, ENOUGH = 30, 0.85  # frames, and the least share of inliers among the matches of a good run
NO_MATCH = "no match in {}: prediction only; the run stops after {} such frames in a row (reported once)"
REVERSED = (
    "only {:.0%} of the matches are inliers: the path may be reversed (near points estimated as far, and the motion as "
    "its opposite), which one camera can hardly detect if it already moves in the first image. Start where it is at "
    "rest, or give more information: a target (--scale FILE), another --velocity"
)


def execute_run(run: SequenceRun, given: argparse.Namespace, command: str) -> int:
    """Run to the end, or until something stops it, and print the result; return the exit status.

    The results are written and saved in both cases. command: the one that resumes it, such as "run images"; a stopped
    run without --save is saved as slamlib-images.npz then. Raises SlamlibError if nothing was run.
    """
    reference = read_trajectory(given.reference, np.array(run.source.times)) if given.reference else None
    for path in filter(None, (given.trajectory, given.save)):
        if not Path(path).absolute().parent.is_dir() or Path(path).is_dir():
            raise SlamlibError(f"{path} cannot be written: its folder does not exist, or it is a folder itself")
    check_video(given.video)
    ended = RunEnd()
    shown, fps = _shown(run, given, ended), 1 / (run.source.interval * run.source.frames.step)
    try:
        if given.video:
            from slambook.scene import animate

            animate((snapshot for snapshot in shown if snapshot is not None), given.video, fps=fps)
        else:
            deque(shown, maxlen=0)
    except Exception as error:
        if not run.is_intact or not given.video:
            raise
        ended.by(f"the video cannot be written: {error}")
    if not run.history:
        raise SlamlibError(ended.why or "nothing has been run")
    if given.trajectory:
        write_tum(given.trajectory, run.trajectory())
    if ended.why or given.save:
        _keep(run, given.save, ended.why, command)
    s: dict[str, Any] = {"source": run.source.where, "layout": run.source.layout, **summary(run.result())}
    s |= {"metric": run.metric, "stopped": ended.why, "reference": None}
    try:
        if reference is not None:
            s["reference"] = compared(run.trajectory(), reference, run.source.interval, run.metric)
    except SlamlibError as error:  # the run is valid without the reference
        ended.status = EXIT_ERROR
        print(f"slamlib: {given.reference}: {error}", file=sys.stderr)
    rows = [("source", f"{s['source']} ({s['layout']})"), *table(s)]
    print(json.dumps(s, indent=2) if given.json else aligned_rows(rows))
    inliers = s["inlier_share"]
    if not run.metric and s["frames"] >= JUDGED and inliers is not None and inliers < ENOUGH:
        print(f"slamlib: {REVERSED.format(inliers)}", file=sys.stderr)
    return ended.status


@dataclass
class RunEnd:
    """How a run ended: the exit status, and why it stopped early, or None."""

    status: int = 0
    why: str | None = None

    def by(self, why: str, status: int = EXIT_ERROR) -> None:
        """Record a reason for stopping; the first status is kept."""
        self.status, self.why = self.status or status, why if self.why is None else f"{self.why}\n{why}"


def _keep(run: SequenceRun, chosen: str | None, stopped: str | None, command: str) -> None:
    path = chosen or f"slamlib-{command.split()[-1]}.npz"
    if not run.is_intact:
        print(f"slamlib: {stopped}; the frame was interrupted, and the run cannot be saved", file=sys.stderr)
        return
    run.save(path)
    if stopped:
        done = f"after {len(run.history)} {run.kind.item}s; resume with: slamlib {command} --resume {path}"
        print(f"slamlib: {stopped}\nslamlib: saved {done}", file=sys.stderr)


def _shown(run: SequenceRun, given: argparse.Namespace, ended: RunEnd) -> Iterator[Snapshot | None]:
    """Run step by step; yield snapshots if a window or a video needs them. Errors end the run and are recorded."""
    window, warned = None, False
    if given.live:
        from slambook.scene import Window

        window = Window(run.snapshot(), show=True)
    try:
        with _interrupts() as asked:
            for step in progress(run, len(run), run.source.where.rpartition("/")[2]):
                if run.tracking_loss.frames and not warned:
                    warned = True
                    print(f"\nslamlib: {NO_MATCH.format(step.picture.name, run.patience)}", file=sys.stderr)
                snapshot = run.snapshot() if window is not None or given.video else None
                if window is not None and snapshot is not None:
                    window.update(snapshot)
                yield snapshot
                if asked:
                    raise KeyboardInterrupt
    except KeyboardInterrupt:
        ended.by("interrupted", EXIT_INTERRUPTED)
    except SlamlibError as error:
        ended.by(str(error))


@contextmanager
def _interrupts() -> Iterator[list[int]]:
    """Record Ctrl-C in the list, to be handled at the end of the frame: within one the run cannot be saved."""
    asked: list[int] = []
    try:
        before = signal.signal(signal.SIGINT, lambda number, _: asked.append(number))
    except ValueError:  # not in the main thread, which alone receives Ctrl-C
        yield asked
        return
    try:
        yield asked
    finally:
        signal.signal(signal.SIGINT, before)
