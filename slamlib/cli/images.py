"""Runs on images: the arguments that those of one camera and of two share, execution, and the report."""

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr
from dataclasses import fields
from io import StringIO
from itertools import islice
from typing import Any

import numpy as np

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.cli.runner import EXIT_ERROR, Job, RunEnd
from slamlib.errors import SlamlibError, entry
from slamlib.evaluation.comparison import ComparisonOptions, compared, sigmas_at_end
from slamlib.evaluation.pose_errors import KEPT
from slamlib.evaluation.trajectory import Trajectory, read_trajectory, write_tum
from slamlib.experiments.progress import progress
from slamlib.landmarks import POINTS
from slamlib.vision.considered import Errors, Singles, single_errors
from slamlib.vision.opening import load
from slamlib.vision.results import summary, summary_warnings, table
from slamlib.vision.sequence_run import ImageStep, SequenceKind, SequenceRun
from slamlib.vision.two_views import direction_error

Add = Callable[..., object]  # add_argument of a group
JUDGED, ENOUGH = 30, 0.7  # frames, and the least share of inliers among the matches of a good run
NO_MATCH = "no match in {}: prediction only; the run stops after {} such frames in a row (reported once)"
NOTHING = "nothing was matched in any {}: are they blank, dark, without texture, or not of one sequence?"
MAX_DIRECTION_ERROR = 60.0  # degrees, between the motions by a path and by two views: above, it may be reversed
REVERSED = (
    "the path may be reversed (near points estimated as far, and the motion as its opposite): from picture {1} to {2} "
    "it goes {0:.0f} degrees off the way that these two tell. Start at another picture, or give more information: a "
    "target (--scale FILE), another --velocity"
)
FEW = "only {:.0%} of the matches are inliers: the path is poorly known, or the calibration is of another camera"


class ImageCommand:
    """A command that runs on images of one kind; a subclass's docstring starts with its help text.

    options(what, how): add the arguments of the input, and of the filter, each to its group. new_run(given, errors):
    the run specified by the arguments, with its calibration's parameters larger by the errors, if there are any.
    places: the options that say where the pictures are, in a resumed run too.
    """

    kind: SequenceKind
    places: tuple[str, ...]
    EXAMPLES: str
    options: Callable[[Add, Add], None]
    new_run: Callable[..., SequenceRun]

    def arguments(self, parser: argparse.ArgumentParser) -> None:
        """Add the arguments of the command."""
        group = parser.add_argument_group
        self.options(group("input options").add_argument, group("filter options").add_argument)
        add = group("output options").add_argument
        add("--trajectory", metavar="FILE", help="write the camera's trajectory in TUM format, for evo; beside it its "
            "covariances, which `slamlib evaluate` reads too, in a file named as it is and .cov")  # fmt: skip
        add("--reference", metavar="FILE", help="compare with a trajectory of this camera (columns of a header, or of "
            "TUM, EuRoC, KITTI or TartanAir); NEES is of the error whose covariance the filter keeps: invariant with "
            "the option error=world, where the linear one's stands beside, else linear")  # fmt: skip
        shared.reference_format(add)
        shared.reference_std(add)
        add("--calibration-std", action="append", default=[], metavar="NAME=STD",
            help="std of a parameter of the calibration, one number or one for each of its own, such as "
                 "intrinsics=1,1,2,2; of pairs also offset, of the disparities [px]: the run is repeated with each of "
                 "them, and what they do to the path is in its covariances")  # fmt: skip
        shared.outputs(add)

    def execute(self, given: argparse.Namespace) -> int:
        """Run; a run that stops early, by an error or by Ctrl-C, is saved, and can be resumed."""
        runner.check_files(given)
        if (given.plot or any(given.reference_std)) and not given.reference:
            raise SlamlibError("--plot and --reference-std are about errors: they need --reference FILE, a trajectory")
        run = runner.new_or_resumed(given, self.new_run, lambda path: self._load(given, path), self.places)
        run.patience = given.patience or run.patience
        if not run.has_map and (given.video or given.live or given.map):
            raise SlamlibError("--video, --live and --map need the filter's map: with --odometry-only there is none")
        if not given.resume:
            for note in filter(None, (*run.source.notes, run.source.guess)):
                print(f"slamlib: {note}", file=sys.stderr)
        errors = single_errors(shared.numbers_by_name(given.calibration_std, "--calibration-std"), run)
        source, warned = run.source, False
        times = np.array(source.times)
        form = given.reference_format
        reference = read_trajectory(given.reference, times, form=form, covariances=False) if given.reference else None

        def warn(step: ImageStep) -> None:
            nonlocal warned
            if run.tracking_loss.frames and not warned:
                warned = True
                print(f"\nslamlib: {NO_MATCH.format(step.picture.name, run.patience)}", file=sys.stderr)

        kind, fps = self.kind, 1 / (source.interval * source.frames.step)
        job = Job(
            run, source.where.rpartition("/")[2], f"run {kind.name}", f"slamlib-{kind.name}.npz",
            lambda step: (run.snapshot(), None), kind.item, fps, each=warn,
        )  # fmt: skip
        return self._report(run, given, runner.execute(job, given), reference, errors)

    def _load(self, given: argparse.Namespace, path: str) -> SequenceRun:
        places = tuple(place for name in self.places if (place := getattr(given, name)) is not None)
        if len(places) == 1 and len(self.places) > 1 and given.source is None:
            raise SlamlibError("both --left and --right are needed, where the pictures are elsewhere now")
        return load(path, self.kind, frames=given.frames, places=places)

    def _report(
        self, run: SequenceRun, given: argparse.Namespace, ended: RunEnd, reference: Trajectory | None, errors: Singles
    ) -> int:
        """Write the trajectory, print the result; return the exit status."""
        s: dict[str, Any] = {"source": run.source.where, "layout": run.source.layout, **summary(run.result())}
        s |= {"metric": run.metric, "stopped": ended.why, "reference": None, "calibration": None}
        path = claimed = run.trajectory()
        try:
            if errors and ended.why:
                raise SlamlibError("the run did not come to its end")
            for label, error in errors.items():
                path = path.considering(self._again(given, run.done, label, error))
            if errors:
                s["calibration"] = {"errors": errors, "without": sigmas_at_end(claimed), "with": sigmas_at_end(path)}
        except (SlamlibError, KeyboardInterrupt) as error:  # the run is valid without
            path, ended.status = claimed, EXIT_ERROR
            print(f"slamlib: the calibration is taken for exact: {str(error) or 'interrupted'}", file=sys.stderr)
        if given.trajectory:
            write_tum(given.trajectory, path)
        runner.export_map(given, run.snapshot)
        how = ComparisonOptions(covariance_error=KEPT[run.slam.options.carried])
        try:
            if reference is not None:
                s["reference"], series = compared(path, reference, run.metric, given.reference_std, how)
                runner.export_plot(given, lambda: {"camera": series})
                if s["calibration"] and s["reference"]["nees"]:
                    without, _ = compared(claimed, reference, run.metric, given.reference_std, how)
                    s["calibration"]["without"]["nees"] = without["nees"]["median"]
        except SlamlibError as error:  # the run is valid without the reference
            ended.status = EXIT_ERROR
            print(f"slamlib: {given.reference}: {error}", file=sys.stderr)
        if s["frames"] > 1 and s["frames_without_match"] == s["frames"] - 1:
            ended.status = EXIT_ERROR
            print(f"slamlib: {NOTHING.format(self.kind.item)}", file=sys.stderr)
        rows = [("source", f"{s['source']} ({s['layout']})"), *table(s)]
        runner.print_result(given, s, shared.aligned_rows(rows))
        for warning in [*summary_warnings(s), *([] if run.metric else _image_warnings(run, s["inlier_share"]))]:
            print(f"slamlib: {warning}", file=sys.stderr)
        return ended.status

    def _again(self, given: argparse.Namespace, done: int, label: str, errors: Errors) -> Trajectory:
        """The path of the run with errors in its calibration; what the first one has said is not said again."""
        with redirect_stderr(StringIO()):
            run = self.new_run(given, errors)
        for _ in progress(islice(run, done), done, f"{label} one std off"):
            pass
        return run.trajectory()

    def _which(self, add: Add) -> None:
        """Add the arguments that select images."""
        of = f"{self.kind.item}s"
        known = "if no list gives their times (default: as names or the video tell, or 30)"
        add("--fps", type=shared.number, help=f"{of} per second, {known}")
        add("--times", metavar="FILE", help=f"times of all {of}, a row each: a time, or a time and the picture's name")
        add("--frames", type=shared.count, metavar="N", help=f"number of {of}")
        add("--start", type=shared.at_least(0), default=0, metavar="N", help="number of the first one (default 0)")
        add("--every", type=shared.count, default=1, metavar="N", help="use every N-th only (default 1)")

    def _impulses(self, add: Add, before: str, default: str) -> None:
        """Add the arguments of the constant-velocity motion."""
        for name, own, what in (
            ("impulse", self.kind.impulse, f"changes of velocity from one {self.kind.item} to the next"),
            ("velocity", self.kind.velocity, "velocities at the start, whose mean is zero"),
        ):
            add(f"--{name}", nargs=2, type=shared.number, metavar=("M/S", "DEG/S"),
                help=f"{before}std of {what} (default {default.format(*own)})")  # fmt: skip

    def _search(self, add: Add, settings: type, of: str) -> None:
        """Add the arguments of the filter's options, and of the search for features."""
        names, points = ", ".join(f.name for f in fields(settings)), self.kind.options.points
        add("--landmark", default=points, help=f"parametrization of points (default {points})")
        add("--option", action="append", default=[], metavar="NAME=VALUE", help=shared.OPTION)
        add("--search", action="append", default=[], metavar="NAME=VALUE", help=f"setting of {of}: {names}")
        lost = f"stop after N {self.kind.item}s without a match (default 30)"
        add("--patience", type=shared.count, metavar="N", help=lost)


def _image_warnings(run: SequenceRun, inliers: float | None) -> Iterator[str]:
    """What the images of a run with free scale say of it: warnings, in sentences."""
    if run.done >= JUDGED and inliers is not None and inliers < ENOUGH:
        yield FEW.format(inliers)
    found = direction_error(run.source, run.slam.sensors[0].calibration, np.array(run.path))
    if found is not None and found[0] > MAX_DIRECTION_ERROR:
        yield REVERSED.format(*found)


def given_options(given: argparse.Namespace, what: str, *names: str) -> dict[str, Any]:
    """The filter's options given on the command line. Raises SlamlibError, which calls the parametrization `what`."""
    entry(what, given.landmark, POINTS)
    named = {"points": given.landmark, **{name: getattr(given, name) for name in names}}
    return {**{name: value for name, value in named.items() if value is not None}, **shared.assignments(given.option)}
