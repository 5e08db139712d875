"""List presets, parametrizations, sensors, motions, worlds, and options."""

import argparse
from collections.abc import Callable, Mapping
from dataclasses import fields

from slamlib.experiments.presets import PRESETS
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import MOTIONS
from slamlib.sensors import SENSORS
from slamlib.simulation import WORLDS
from slamlib.slam import Options


def _first_lines(functions: Mapping[str, Callable[..., object]]) -> list[str]:
    return [f"{name:18} {(f.__doc__ or '').splitlines()[0]}" for name, f in functions.items()]


def _options() -> list[str]:
    text = Options.__doc__ or ""
    return [line.removeprefix("    ") for line in text.splitlines()[2:]] + [
        "",
        *(f"{f.name} = {getattr(Options(), f.name)!r}" for f in fields(Options)),
    ]


LISTS: dict[str, Callable[[], list[str]]] = {
    "presets": lambda: _first_lines(PRESETS),
    "points": lambda: sorted(POINTS),
    "lines": lambda: sorted(LINES),
    "sensors": lambda: sorted(SENSORS),
    "motions": lambda: sorted(MOTIONS),
    "worlds": lambda: _first_lines(WORLDS),
    "options": _options,
}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib list`."""
    parser.add_argument("what", nargs="?", choices=LISTS, help="one of these lists (default: all but the options)")


def execute(given: argparse.Namespace) -> int:
    """Print the chosen lists."""
    chosen = [given.what] if given.what else [name for name in LISTS if name != "options"]
    for name in chosen:
        print(f"{name}:")
        print("\n".join(f"  {line}".rstrip() for line in LISTS[name]()))
    return 0
