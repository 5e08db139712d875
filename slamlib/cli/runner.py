"""What a command does while a run on pictures works: a bar, a film or a window, and a stop that loses nothing."""

import argparse
import json
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from slamlib.cli.arguments import aligned_rows
from slamlib.cli.trajectory_report import read_reference, reference_rows
from slamlib.data.snapshots import Snapshot
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory import write_tum
from slamlib.experiments.progress import progress
from slamlib.vision.results import compared, summary, table
from slamlib.vision.sequence_run import ImageStep, SequenceRun

EXIT_ERROR, EXIT_INTERRUPTED = 2, 130
JUDGED, ENOUGH = 30, 0.85  # frames, and the share of the matches that is believed in a run that goes well
REVERSED = (
    "only {:.0%} of the matches are inliers: the path may be reversed (near taken for far, and the motion for its "
    "opposite), which one camera can hardly tell when it is moving already in the first picture. Begin where it is at "
    "rest, or say more: a target (--scale FILE), another --velocity"
)


def outputs(add: Callable[..., Any]) -> None:
    """Arguments that say what becomes of a run."""
    add("--trajectory", metavar="FILE", help="write the camera's path in TUM format, for evo")
    add("--reference", metavar="FILE", help="compare with a path of the same camera, in TUM, EuRoC or KITTI format")
    add("--video", metavar="PATH", help="a film: .mp4, .webm, .gif, or a folder for numbered PNG files")
    add("--live", action="store_true", help="show the run in a window")
    add("--save", metavar="PATH", help="write the run to a file; an interrupted one goes there")
    add("--resume", metavar="PATH", help="go on with a saved run instead of beginning one")
    add("--json", action="store_true", help="print the result as JSON")


def execute_run(run: SequenceRun, given: argparse.Namespace, command: str) -> int:
    """Run it to its end, or until something stops it, and say what came of it; the exit status.

    What was done is written and saved in both cases. command: the one that goes on with it, "run images"; what stopped
    and has no name is slamlib-images.npz then. Raises SlamlibError if nothing was run.
    """
    reference = read_reference(given.reference, run)
    _check_places(given)
    ended = RunEnd()
    try:
        _consume(_shown(run, given, ended), given.video, 1 / (run.source.interval * run.source.frames.step))
    except Exception as error:
        if not run.is_intact or not given.video:
            raise
        ended.by(f"the film cannot be written: {error}")
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
    except SlamlibError as error:  # the run is good, whatever the reference
        ended.status = EXIT_ERROR
        print(f"slamlib: {given.reference}: {error}", file=sys.stderr)
    rows = [("source", f"{s['source']} ({s['layout']})"), *table(s), *reference_rows(s["reference"])]
    print(json.dumps(s, indent=2) if given.json else aligned_rows(rows))
    inliers = s["inlier_share"]
    if not run.metric and s["frames"] >= JUDGED and inliers is not None and inliers < ENOUGH:
        print(f"slamlib: {REVERSED.format(inliers)}", file=sys.stderr)
    return ended.status


@dataclass
class RunEnd:
    """How a run ended: the exit status, and why it stopped before its end, or None."""

    status: int = 0
    why: str | None = None

    def by(self, why: str, status: int = EXIT_ERROR) -> None:
        """Something stopped it; the first status stays."""
        self.status, self.why = self.status or status, why if self.why is None else f"{self.why}\n{why}"


def _check_places(given: argparse.Namespace) -> None:
    """Raise SlamlibError for what could not be written after the run: better before it."""
    for path in filter(None, (given.trajectory, given.save)):
        if not Path(path).absolute().parent.is_dir() or Path(path).is_dir():
            raise SlamlibError(f"{path} cannot be written: its folder is not there, or it is a folder itself")
    if given.video:
        from slambook.scene.video import ready

        ready(given.video)


def _keep(run: SequenceRun, chosen: str | None, stopped: str | None, command: str) -> None:
    path = chosen or f"slamlib-{command.split()[-1]}.npz"
    if not run.is_intact:
        print(f"slamlib: {stopped}; the frame was broken off, and the run cannot be saved", file=sys.stderr)
        return
    run.save(path)
    if stopped:
        done = f"after {len(run.history)} {run.kind.item}s; go on with: slamlib {command} --resume {path}"
        print(f"slamlib: {stopped}\nslamlib: saved {done}", file=sys.stderr)


def _shown(run: SequenceRun, given: argparse.Namespace, ended: RunEnd) -> Iterator[Snapshot | None]:
    """Step by step; snapshots are made if somebody looks at them. What stops the run ends them, and is told."""
    window, warned = None, False
    if given.live:
        from slambook.scene import Window

        window = Window(run.snapshot(), show=True)
    try:
        with _interrupts() as asked:
            for step in progress(run, len(run), run.source.where.rpartition("/")[2]):
                warned = warned or _warn(run, step)
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


def _warn(run: SequenceRun, step: ImageStep) -> bool:
    if not run.tracking_loss.frames:
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


def _consume(snapshots: Iterator[Snapshot | None], video: str | None, fps: float) -> None:
    if video is None:
        for _ in snapshots:
            pass
        return
    from slambook.scene import animate

    animate((snapshot for snapshot in snapshots if snapshot is not None), video, fps=fps)
