"""The command `slamlib`: runs experiments, compares parametrizations, lists the available components."""

import argparse
import sys
from collections.abc import Sequence
from typing import Any

from slamlib.cli import compare, listing, run
from slamlib.cli.images import ImagesCommand, PairsCommand
from slamlib.errors import SlamlibError

COMMANDS: dict[str, Any] = {
    "run": run, "run images": ImagesCommand(), "run stereo-images": PairsCommand(), "compare": compare, "list": listing
}  # fmt: skip


def parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    top = argparse.ArgumentParser(prog="slamlib", description="EKF-SLAM, derived: run the book's filter.")
    commands = top.add_subparsers(dest="command", required=True, metavar="{" + ",".join(COMMANDS) + "}")
    for name, made in COMMANDS.items():
        line = (made.__doc__ or "").strip().splitlines()[0]
        command = commands.add_parser(name, help=line, description=line)
        made.arguments(command)
        command.set_defaults(execute=made.execute)
    return top


def main(words: Sequence[str] | None = None) -> int:
    """Run the command; return the exit status: 0, 2 for an error of the user, 130 if interrupted."""
    given = parser().parse_args(_joined(sys.argv[1:] if words is None else words))
    try:
        status: int = given.execute(given)
    except SlamlibError as error:
        print(f"slamlib: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        sys.stderr.close()
        return 1
    return status


def _joined(words: Sequence[str]) -> list[str]:
    """The words, with those of a two-word command such as "run images" joined."""
    first = " ".join(words[:2])
    return [first, *words[2:]] if first in COMMANDS else list(words)
