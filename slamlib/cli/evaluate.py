"""Compare a trajectory with a reference: ATE and RPE as evo does, KITTI's metric, NEES where covariances are known."""

import argparse
from pathlib import Path

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.evaluation.comparison import evaluate
from slamlib.evaluation.trajectory import read_rows

EXAMPLES = """examples:
  slamlib evaluate path.txt groundtruth.txt
  slamlib evaluate path.txt groundtruth.txt --scale --plot errors.svg
  slamlib evaluate poses.txt sequences/04/poses.txt --times sequences/04/times.txt --json

Both files are of one moving frame, such as a camera; TUM, EuRoC or KITTI format. Times are matched to 0.02 s, or to
half of the path's own interval. Covariances are read from path.cov, which slamlib writes beside path.txt.
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib evaluate`."""
    parser.add_argument("path", help="the estimated trajectory")
    parser.add_argument("reference", help="the trajectory to compare with")
    parser.add_argument("--scale", action="store_true", help="align the scale too: the path of one camera has none")
    shared.reference_std(parser.add_argument)
    parser.add_argument("--times", metavar="FILE", help="one time [s] a row, for files in KITTI's format")
    parser.add_argument("--plot", metavar="FILE", help=shared.PLOT)
    shared.result(parser.add_argument)


def execute(given: argparse.Namespace) -> int:
    """Print the comparison, and draw it."""
    runner.check_files(given)
    times = read_rows(given.times)[0][:, 0] if given.times else None
    found = evaluate(given.path, given.reference, scale=given.scale, times=times, reference_std=given.reference_std)
    runner.export_plot(given, lambda: {Path(given.path).name: found.series})
    runner.print_result(given, found.summary, repr(found))
    return 0
