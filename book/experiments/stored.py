"""Longer runs of the chapters, stored as one small file of named parts each: made again, rounded, written."""

import argparse
import json
import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from book.tools import layout


def plain(value: Any, digits: int = 4) -> Any:
    """Plain data with numbers rounded to so many digits; what is not finite is written as words, as JSON knows none."""
    if isinstance(value, dict):
        return {name: plain(part, digits) for name, part in value.items()}
    if isinstance(value, list | tuple | np.ndarray):
        return [plain(part, digits) for part in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.{digits}g}") if math.isfinite(value) else str(value)
    return int(value) if isinstance(value, np.integer) else value


def kept(file: Path) -> Any:
    """The parts that a file has; none if there is no file."""
    return json.loads(file.read_text("utf-8")) if file.is_file() else {}


def main(file: Path, parts: Mapping[str, Callable[[], Any]], description: str | None, resumable: bool = False) -> None:
    """Make the parts, and write them as JSON, a name to a line, when all of it is done.

    Those that are not asked for, and those whose result is None as their data are not at hand, stay. resumable: each is
    written when it is done, and not made again unless it is asked for.
    """
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", choices=parts, help="make these parts alone again")
    wanted = parser.parse_args().only or [name for name in parts if not (resumable and name in kept(file))]
    for names in [[name] for name in wanted] if resumable else [wanted]:
        made = {name: parts[name]() for name in names}
        found = kept(file) | {name: value for name, value in made.items() if value is not None}
        rows = ",\n".join(f"{json.dumps(name)}: {json.dumps(found[name])}" for name in parts if name in found)
        layout.write_whole(file, f"{{{rows}}}\n".encode())
        print(f"wrote {file.relative_to(layout.ROOT)}: {len(rows) / 1024:.0f} kB", flush=True)
