"""Command-line options shared by several commands, and the preset they select."""

import argparse
import json
from collections.abc import Callable
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.evaluation.trajectory_files import FORMATS
from slamlib.experiments.presets import Preset, preset
from slamlib.landmarks import LINES, POINTS
from slamlib.plain_data.fields import read_fields
from slamlib.slam import Options

OPTION = "any option of `slamlib list options`, such as gate=0.999 or inverse_distance=1,0.5"
PLOT = "draw the errors over time, with their standard deviations and NEES: .svg, .png or .pdf"


def add(parser: argparse.ArgumentParser) -> None:
    """Add the options that change a preset."""
    parser.add_argument("--frames", type=count, help="number of frames")
    parser.add_argument("--seed", type=int, help="seed of all random numbers")
    parser.add_argument("--batch", action="store_true", help="update with all landmarks in one batch, not one by one")
    parser.add_argument("--calibrate", action="store_true", help="estimate the extrinsics of all sensors but the first")
    parser.add_argument("--noise-in", choices=("control", "truth"), help="what the motion noise is added to")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help=OPTION)


def at_least(least: int) -> Callable[[str], int]:
    """An argparse type: an integer, `least` or more."""

    def whole(text: str) -> int:
        value = int(text)
        if value < least:
            raise argparse.ArgumentTypeError(f"an integer, {least} or more, is expected, not {text}")
        return value

    return whole


count = at_least(1)


def number(text: str) -> float:
    """An argparse type: a finite number, 0 or more."""
    value = float(text)
    if not 0 <= value < inf:
        raise argparse.ArgumentTypeError(f"a number, 0 or more, is expected, not {text}")
    return value


def outputs(add: Callable[..., object]) -> None:
    """Add the output options of a run of any kind."""
    add("--live", action="store_true", help="show the run in a window")
    add("--video", metavar="PATH", help="write a video: .mp4, .webm, .gif, or a folder for numbered PNG files")
    add("--map", metavar="FILE", help="write the map at the end: .ply (for viewers of point clouds), .json or .csv")
    add("--plot", metavar="FILE", help=PLOT)
    add("--save", metavar="PATH", help="save the run to a file, also if it is interrupted")
    add("--resume", metavar="PATH", help="continue a saved run instead of starting a new one")
    result(add)


def reference_format(add: Callable[..., object]) -> None:
    """Add the option that says in what format a reference is."""
    add("--reference-format", choices=FORMATS, help="format of the reference, where its file does not tell it")


def reference_std(add: Callable[..., object]) -> None:
    """Add the option that says how well a reference is known."""
    known = "std of the reference's own poses, as its maker states them; added to the path's own (default 0 0)"
    add("--reference-std", nargs=2, type=number, metavar=("M", "DEG"), default=(0.0, 0.0), help=known)


def result(add: Callable[..., object]) -> None:
    """Add the options that say in what form the result is given."""
    add("--overwrite", action="store_true", help="replace files that exist")
    add("--json", nargs="?", const="-", type=_json, metavar="FILE.json", help="print the result as JSON, or write it")


def _json(text: str) -> str:
    """An argparse type: the name of a JSON file."""
    if text != "-" and not text.endswith(".json"):
        raise argparse.ArgumentTypeError(f"a file ending in .json is expected, not {text}; to print, put --json last")
    return text


def base(name: str) -> Preset:
    """The preset of a name, or of a JSON or TOML file. Raises SlamlibError with the choices."""
    if Path(name).suffix in (".json", ".toml"):
        return Preset.load(name)
    return preset(name)


def changed(chosen: Preset, given: argparse.Namespace) -> Preset:
    """The preset with the changes given on the command line."""
    names = {"frames": given.frames, "seed": given.seed, "noise_in": given.noise_in}
    options: dict[str, Any] = assignments(given.option)
    if given.batch:
        options["reproject"] = False
    chosen = replace(chosen, options=replace(chosen.options, **options))
    if given.calibrate:
        first, *others = chosen.rig.sensors
        if not others:
            raise SlamlibError(
                "--calibrate keeps the first sensor's extrinsics and estimates those of the others, and this rig has "
                "one sensor: try `slamlib run stereo --calibrate`, or a preset whose sensor has 'estimated': true"
            )
        loose: dict[str, Any] = {"estimated": True, "position_std": (0.02,), "orientation_std": (1.5,)}
        sensors = (first, *(s if s.estimated else replace(s, **loose) for s in others))
        chosen = replace(chosen, rig=replace(chosen.rig, sensors=sensors))
    return replace(chosen, **{name: value for name, value in names.items() if value is not None})


def with_landmark(chosen: Preset, name: str) -> Preset:
    """The preset with this parametrization for the new landmarks of its family."""
    if name not in POINTS and name not in LINES:
        raise UnknownNameError.of("landmark", name, [*POINTS, *LINES])
    family = "points" if name in POINTS else "lines"
    if getattr(chosen.options, family) is None:
        raise SlamlibError(f"the preset {chosen.name!r} has no {family}, so {name} cannot be used in it")
    change: dict[str, Any] = {family: name}
    return replace(chosen, options=replace(chosen.options, **change))


def assignments(texts: list[str], kind: type = Options, flag: str = "--option") -> dict[str, Any]:
    """Values by name from texts "NAME=VALUE": fields of the options, or of another dataclass. Raises SlamlibError."""
    return read_fields(kind, dict(_assignment(text, flag) for text in texts), flag.strip("-"))


def numbers_by_name(texts: list[str], flag: str) -> dict[str, tuple[float, ...]]:
    """Numbers from zero on by name, from texts "NAME=NUMBER[,NUMBER...]". Raises SlamlibError."""
    found = {}
    for name, value in (_assignment(text, flag) for text in texts):
        many = value if isinstance(value, list) else [value]
        if not all(isinstance(one, int | float) and 0 <= one < inf for one in many):
            raise SlamlibError(f"{flag} takes NAME=NUMBER, or several from zero on with commas, got {name}={value}")
        found[name] = tuple(map(float, many))
    return found


def _assignment(text: str, flag: str) -> tuple[str, Any]:
    """The name and the value of NAME=VALUE; the value is JSON, a word, or numbers separated by commas."""
    name, equals, value = text.partition("=")
    if not equals:
        raise SlamlibError(f"{flag} takes NAME=VALUE, got {text!r}")
    words = {"true": True, "false": False, "none": None}
    if value.lower() in words:
        return name, words[value.lower()]
    for written in (value, f"[{value}]") if "," in value else (value,):
        try:
            return name, json.loads(written)
        except json.JSONDecodeError:
            continue
    return name, value


def aligned_rows(rows: list[tuple[str, str]]) -> str:
    """The rows (name, value) as text, the values aligned in one column."""
    width = max(len(name) for name, _ in rows)
    return "\n".join(f"{name:{width}}  {value}" for name, value in rows)
