"""List public recordings with address, size and licence, whether they are on this machine, and where to put them."""

import argparse

from slamlib.cli import arguments as shared
from slamlib.cli import runner
from slamlib.datasets.public import VARIABLE, data_folder, public_recordings
from slamlib.errors import entry

EXAMPLES = f"""examples:
  slamlib datasets
  {VARIABLE}=~/data slamlib datasets tum-fr1-xyz
  slamlib datasets --folder ~/data --json

Nothing is fetched. Each recording has a folder of its own below one that {VARIABLE}, or --folder, names.
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib datasets`."""
    parser.add_argument("names", nargs="*", metavar="NAME", help="these alone (default: all)")
    parser.add_argument("--folder", help=f"where the recordings are (default: that of {VARIABLE})")
    shared.result(parser.add_argument)


def execute(given: argparse.Namespace) -> int:
    """Print the list."""
    runner.check_files(given)
    root = data_folder(given.folder)
    chosen = {name: entry("recording", name, public_recordings()) for name in given.names or public_recordings()}
    found, text = {}, []
    for name, recording in chosen.items():
        here, put = recording.found(root), next(iter(recording.places))
        there = ", ".join(map(str, here)) or f"not here; put it in {root or f'${VARIABLE}'}/{put}"
        rows = [("address", recording.address), ("size", recording.size or "unknown"), ("licence", recording.licence)]
        text += [f"{name}: {recording.what}", *(f"  {key:8} {value}" for key, value in [*rows, ("found", there)])]
        found[name] = {**vars(recording), "folder": put, "found": [str(folder) for folder in here]}
    runner.print_result(given, found, "\n".join(text))
    return 0
