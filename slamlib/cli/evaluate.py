"""Compare a trajectory with a reference: ATE and RPE as evo does, KITTI's metric, NEES where covariances are known."""

import argparse
import sys
from pathlib import Path

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.evaluation.alignment import ALIGNMENTS
from slamlib.evaluation.comparison import evaluate, rows
from slamlib.evaluation.motion_pairs import ALONG
from slamlib.evaluation.pose_errors import ERRORS
from slamlib.evaluation.trajectory_files import FORMATS

EXAMPLES = """examples:
  slamlib evaluate path.txt groundtruth.txt
  slamlib evaluate path.txt groundtruth.txt --scale --plot errors.svg
  slamlib evaluate path.txt groundtruth.txt --offset auto --delta 1 --delta-unit m --all-pairs
  slamlib evaluate poses.txt sequences/04/poses.txt --times sequences/04/times.txt --json

Both files are of one moving frame, such as a camera. Their columns are those that a header names, such as
time,x,y,z,qx,qy,qz,qw, or those of TUM, EuRoC, KITTI or TartanAir. Each pose is paired with the nearest in time, at
most half of the denser file's interval away, or 0.02 s. Covariances are read from path.txt.cov, which slamlib writes
beside path.txt. Results are those of evo_ape -a (with --scale: -as) and evo_rpe.
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib evaluate`."""
    add = parser.add_argument
    add("path", help="the estimated trajectory")
    add("reference", help="the trajectory to compare with")
    add("--scale", action="store_true", help="align the scale too: the path of one camera has none")
    add("--align", choices=ALIGNMENTS, default="all", help="by the motion that fits best (all, the default), the first "
        "pose with the first (origin), the scale alone, or not at all (none)")  # fmt: skip
    add("--align-first", type=shared.count, metavar="N", help="align only the first N pairs of poses with each other")
    add("--tolerance", type=shared.number, metavar="S", help="largest distance in time of a pair [s]")
    add("--offset", type=_offset, default=0.0, metavar="S", help="added to the times of the path [s]; auto: where its "
        "speeds or angular rates correlate most with the reference's")  # fmt: skip
    add("--delta", type=shared.number, default=1.0, metavar="N", help="length of the motions whose errors are the RPE "
        "(default 1)")  # fmt: skip
    add("--delta-unit", choices=ALONG, default="frames", help="its unit (default frames)")
    add("--all-pairs", action="store_true", help="RPE of the motions from every pose, not of one after another")
    shared.reference_std(add)
    add("--covariance-error", choices=ERRORS, default="linear", help="what the path's covariances are of, which the "
        "file does not tell, and so of which error NEES is: linear (the default), or invariant, as in a filter "
        "with the option error=world; for small errors it is the same")  # fmt: skip
    add("--format", choices=FORMATS, help="format of the path, where its file does not tell it")
    shared.reference_format(add)
    add("--times", metavar="FILE", help="one time [s] a row, for files that have none (KITTI, TartanAir)")
    add("--plot", metavar="FILE", help=shared.PLOT)
    shared.result(add)


def _offset(text: str) -> float | str:
    """An argparse type: a number, or auto."""
    if text == "auto":
        return text
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"a number of seconds, or auto, is expected, not {text}") from None


def execute(given: argparse.Namespace) -> int:
    """Print the comparison, and draw it."""
    runner.check_files(given)
    found = evaluate(
        given.path, given.reference, scale=given.scale, times=given.times, reference_std=given.reference_std,
        format=given.format, reference_format=given.reference_format, align=given.align, align_first=given.align_first,
        tolerance=given.tolerance, offset=given.offset, delta=given.delta, delta_unit=given.delta_unit,
        all_pairs=given.all_pairs, covariance_error=given.covariance_error,
    )  # fmt: skip
    runner.export_plot(given, lambda: {Path(given.path).name: found.series})
    runner.print_result(given, found.summary, shared.aligned_rows(rows(found.summary)))
    for note in found.summary["notes"]:
        print(f"slamlib: {note}", file=sys.stderr)
    return 0
