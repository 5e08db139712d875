"""Print a preset as TOML, a starting file for experiments of one's own."""

import argparse
import json
from collections.abc import Iterator
from typing import Any

from slamlib.cli.arguments import base

EXAMPLES = """examples:
  slamlib preset points > mine.toml
  slamlib run mine.toml
"""


def arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `slamlib preset`."""
    parser.add_argument("preset", help="a name of `slamlib list presets`, or a JSON or TOML file")


def execute(given: argparse.Namespace) -> int:
    """Print the preset."""
    print("\n".join(toml(base(given.preset).to_dict())))
    return 0


def toml(table: dict[str, Any], path: str = "") -> Iterator[str]:
    """The lines of a table of plain data; tables in it, and lists of them, have headers of their own."""
    below = {name: value for name, value in table.items() if isinstance(_first(value), dict)}
    yield from (f"{_key(name)} = {_inline(value)}" for name, value in table.items() if name not in below)
    for name, value in below.items():
        for each in (value,) if isinstance(value, dict) else value:
            header = f"[{path}{name}]" if isinstance(value, dict) else f"[[{path}{name}]]"
            yield from ("", header, *toml(each, f"{path}{name}."))


def _key(name: str) -> str:
    """A name as a key; one that a person chose may have blanks."""
    return name if name.isidentifier() else json.dumps(name)


def _first(value: object) -> object:
    return value[0] if isinstance(value, tuple) and value else value


def _inline(value: object) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name} = {_inline(v)}" for name, v in value.items()) + "}"
    if isinstance(value, tuple):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return repr(value) if isinstance(value, float) else json.dumps(value)
