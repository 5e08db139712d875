"""What the commands for pictures have in common: which of them, what becomes of a run, and what is said of it."""

import argparse
import json
import sys
from collections.abc import Callable
from typing import Any

from slamlib.cli import choices, comparing, working
from slamlib.errors import SlamlibError
from slamlib.vision.results import summary, table
from slamlib.vision.sequence_run import Stepping

JUDGED, ENOUGH = 30, 0.85  # frames, and the share of the matches that is believed in a run that goes well
REVERSED = (
    "only {:.0%} of the matches are believed: the path may be reversed (near taken for far, and the motion for its "
    "opposite), which one camera can hardly tell when it is moving already in the first picture. Begin where it is at "
    "rest, or say more: a target (--scale FILE), another --velocity"
)


def groups(parser: argparse.ArgumentParser, sees: Callable[[Any], None], works: Callable[[Any], None]) -> None:
    """The three groups of arguments of such a command, two of them its own."""
    sees(parser.add_argument_group("what it sees"))
    works(parser.add_argument_group("how the filter works"))
    outputs(parser.add_argument_group("what becomes of it"))


def which(group: Any, of: str) -> None:
    """Arguments that choose among pictures; of: what they are called."""
    group.add_argument("--fps", type=float, help=f"{of} a second, where no file says their times (default 30)")
    group.add_argument("--frames", type=choices.count, metavar="N", help=f"how many {of}")
    group.add_argument("--start", type=choices.from_zero, default=0, metavar="N", help="the first one (default 0)")
    group.add_argument("--every", type=choices.count, default=1, metavar="N", help="only each so many-th")


def outputs(group: Any) -> None:
    """Arguments that say what becomes of a run."""
    group.add_argument("--trajectory", metavar="FILE", help="write the camera's path in TUM format, for evo")
    group.add_argument(
        "--reference", metavar="FILE", help="compare with a path of the same camera, in TUM, EuRoC or KITTI format"
    )
    group.add_argument("--video", metavar="PATH", help="a film: .mp4, .webm, .gif, or a folder for numbered PNG files")
    group.add_argument("--live", action="store_true", help="show the run in a window")
    group.add_argument("--save", metavar="PATH", help="write the run to a file; an interrupted one goes there")
    group.add_argument("--resume", metavar="PATH", help="go on with a saved run instead of beginning one")
    group.add_argument("--json", action="store_true", help="print the result as JSON")


def carry_out(run: Stepping, given: argparse.Namespace, command: str) -> int:
    """Run it to its end and say what came of it; the exit status. Raises SlamlibError if nothing was run."""
    reference = comparing.read_reference(given.reference, run)
    outcome = working.work(run, given, command)
    if not run.history:
        raise SlamlibError(outcome.stopped or "nothing has been run")
    s: dict[str, Any] = {"source": run.source.where, "layout": run.source.layout, **summary(run.result())}
    s["metric"] = run.metric
    s["stopped"], s["reference"] = outcome.stopped, None
    try:
        if reference is not None:
            s["reference"] = comparing.compared(run, reference)
            s["reference"] |= {"parts": comparing.parts(run, reference)} if run.metric else {}
    except SlamlibError as error:  # the run is good, whatever the reference
        outcome.status = working.MISTAKE
        print(f"slamlib: {given.reference}: {error}", file=sys.stderr)
    print(json.dumps(s, indent=2) if given.json else _text(s))
    if _may_be_reversed(run, s):
        print(f"slamlib: {REVERSED.format(s['believed_share'])}", file=sys.stderr)
    return outcome.status


def _may_be_reversed(run: Stepping, s: dict[str, Any]) -> bool:
    """Whether a path with a free scale is as little at one with its pictures as one that runs backwards."""
    believed = s["believed_share"]
    return not run.metric and s["frames"] >= JUDGED and believed is not None and believed < ENOUGH


def _text(s: dict[str, Any]) -> str:
    rows = [("source", f"{s['source']} ({s['layout']})"), *table(s), *comparing.table(s["reference"])]
    width = max(len(name) for name, _ in rows)
    return "\n".join(f"{name:{width}}  {value}" for name, value in rows)
