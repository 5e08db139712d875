"""List presets, parametrizations, sensors, motions, worlds, and options."""

import argparse
import sys
from collections.abc import Callable, Mapping
from dataclasses import fields
from inspect import signature
from typing import Any

from slamlib.datasets.formats import READERS
from slamlib.experiments.presets import PRESETS
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import MOTIONS
from slamlib.sensors import SENSORS
from slamlib.simulation import WORLDS
from slamlib.slam import Options
from slamlib.vision.active_search import ActiveSearchSettings
from slamlib.vision.stereo.detect import StereoSettings

EXAMPLES = """examples:
  slamlib list points
  slamlib list options
"""


def _first_lines(things: Mapping[str, object]) -> list[str]:
    return [f"{name:18} {(thing.__doc__ or '').splitlines()[0]}" for name, thing in things.items()]


def _fields(kind: type) -> list[str]:
    """The meaning of each field, which the docstring of a dataclass has, and the defaults."""
    text = (kind.__doc__ or "").splitlines()[2:]
    default: Any = kind()
    defaults = [f"{f.name} = {getattr(default, f.name)!r}" for f in fields(default)]
    return [line.removeprefix("    ") for line in text] + ["", "defaults:", *defaults]


def _meanings(registry: Mapping[str, object], formula: str) -> list[str]:
    """The first line of the module of each type's formula."""
    modules = {name: sys.modules[getattr(value, formula).__module__] for name, value in sorted(registry.items())}
    return _first_lines(modules)


def _worlds() -> list[str]:
    """Their meanings, and the defaults of their arguments."""
    lines = zip(_first_lines(WORLDS), map(signature, WORLDS.values()), strict=True)
    return [
        f"{line} ({', '.join(f'{p.name}={p.default}' for p in found.parameters.values())})" for line, found in lines
    ]


LISTS: dict[str, Callable[[], list[str]]] = {
    "presets": lambda: _first_lines(PRESETS),
    "points": lambda: _meanings(POINTS, "to_frame"),
    "lines": lambda: _meanings(LINES, "to_frame"),
    "sensors": lambda: _meanings(SENSORS, "project"),
    "motions": lambda: _meanings(MOTIONS, "step"),
    "worlds": _worlds,
    "options": lambda: _fields(Options),
    "search": lambda: ["one camera:", *_fields(ActiveSearchSettings), "", "stereo pairs:", *_fields(StereoSettings)],
    "calibrations": lambda: _meanings(READERS, "fits"),
}
LONG = ("options", "search", "calibrations")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib list`."""
    parser.add_argument("what", nargs="?", choices=LISTS, help="one of these lists (default: the short ones)")


def execute(given: argparse.Namespace) -> int:
    """Print the chosen lists."""
    chosen = [given.what] if given.what else [name for name in LISTS if name not in LONG]
    for name in chosen:
        print(f"{name}:")
        print("\n".join(f"  {line}".rstrip() for line in LISTS[name]()))
    return 0
