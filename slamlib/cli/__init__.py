"""The command `slamlib`: runs experiments, compares parametrizations, lists the available components."""

import argparse
import os
import signal
import sys
import warnings
from collections.abc import Sequence
from typing import Protocol, TextIO

# Matrices are small here, and NumPy's and SciPy's copies of BLAS wait for each other's threads: one is faster by far.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

from slamlib import __version__
from slamlib.cli import compare, datasets, evaluate, listing, run, starting
from slamlib.cli.runner import STOPPED, signals
from slamlib.cli.sequences import ImagesCommand, PairsCommand
from slamlib.errors import SlamlibError


class Command(Protocol):
    """A module, or an object, of one command; its docstring starts with the help text."""

    EXAMPLES: str

    def arguments(self, parser: argparse.ArgumentParser) -> None:
        """Add the arguments of the command."""

    def execute(self, given: argparse.Namespace) -> int:
        """Run the command; return the exit status."""


COMMANDS: dict[str, Command] = {
    "run": run, "run images": ImagesCommand(), "run stereo-images": PairsCommand(), "compare": compare,
    "evaluate": evaluate, "list": listing, "preset": starting, "datasets": datasets,
}  # fmt: skip


def parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    top = argparse.ArgumentParser(prog="slamlib", description="EKF-SLAM, derived: run the book's filter.")
    top.add_argument("--version", action="version", version=f"slamlib {__version__}")
    commands = top.add_subparsers(dest="command", required=True, metavar="{" + ",".join(COMMANDS) + "}")
    for name, made in COMMANDS.items():
        line = (made.__doc__ or "").strip().splitlines()[0]
        command = commands.add_parser(
            name,
            help=line,
            description=line,
            epilog=made.EXAMPLES,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        made.arguments(command)
        command.set_defaults(execute=made.execute, parser=command)  # which knows the defaults
    return top


def main(words: Sequence[str] | None = None) -> int:
    """Run the command; return the exit status: 0, 2 for an error of the user, 130 if interrupted, 143 if terminated.

    It is 1 for an error of slamlib's own, whose traceback Python's development mode (-X dev) shows.
    """
    try:
        # What is not finite is refused, by its name.
        with signals(_stop, signal.SIGTERM), np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.showwarning = _say
            given = parser().parse_args(_joined(_at_home(sys.argv[1:] if words is None else words)))
            status: int = given.execute(given)
        sys.stdout.flush()
    except BrokenPipeError:
        sys.stderr.close()
        return 1
    except (SlamlibError, OSError) as error:  # a full disk behind the standard output, for instance
        print(f"slamlib: {getattr(error, 'strerror', None) or error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as stop:
        number = next(iter((stop.__cause__ or stop).args), signal.SIGINT)  # a codec raises its own from it
        print(f"slamlib: {STOPPED[number]}", file=sys.stderr)
        return 128 + number
    except Exception as error:
        if sys.flags.dev_mode:
            raise
        said = " ".join(f"{type(error).__name__}: {error}".split())
        print(f"slamlib: a fault of slamlib's own, {said}; to report it: python -X dev -m slamlib ...", file=sys.stderr)
        return 1
    return status


def _say(
    message: Warning | str,
    category: type,
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    """A warning is one line, without its place in the code."""
    print(f"slamlib: {message}", file=sys.stderr)


def _stop(number: int, frame: object) -> None:
    """SIGTERM, as Ctrl-C, raises KeyboardInterrupt, so that unfinished files are removed."""
    raise KeyboardInterrupt(number)


def _at_home(words: Sequence[str]) -> list[str]:
    """The words, with ~ at the start of a path replaced: a shell leaves it in quotes, and after an option's =."""
    found = []
    for word in words:
        option, equals, value = word.partition("=") if word.startswith("--") else ("", "", word)
        found.append(f"{option}{equals}{os.path.expanduser(value)}")
    return found


def _joined(words: Sequence[str]) -> list[str]:
    """The words, with those of a two-word command such as "run images" joined."""
    first = " ".join(words[:2])
    return [first, *words[2:]] if first in COMMANDS else list(words)
