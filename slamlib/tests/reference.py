"""Numbers of the seeds' toolbox to compare with, where they are at hand; tests that need them skip, and say so."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "reference"


def cases(family: str, function: str) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Inputs and outputs of a function's recorded calls; column vectors become one-dimensional."""
    entry = next(f for f in _read(family)["functions"] if f["name"] == function)
    return [
        ({k: _array(v) for k, v in c["inputs"].items()}, {k: _array(v) for k, v in c["outputs"].items()})
        for c in entry["cases"]
    ]


def recording(name: str) -> list[dict[str, Any]]:
    """The frames of a recorded run: controls, measurements, and what the toolbox made of them; arrays throughout."""
    return [_arrays(frame) for frame in _read(f"replay_{name}")["frames"]]


def _read(family: str) -> Any:
    file = FOLDER / f"{family}.json"
    if not file.is_file():
        pytest.skip(f"the reference numbers of the toolbox ({file.name}) are not at hand")
    return json.loads(file.read_text("utf-8"))


def _arrays(value: Any) -> Any:
    if isinstance(value, list):
        return [_arrays(v) for v in value]
    if isinstance(value, dict) and "data" not in value:
        return {k: _arrays(v) for k, v in value.items()}
    return np.array(value["data"], dtype=float).reshape(value["shape"]) if isinstance(value, dict) else value


def _array(value: Any) -> Any:
    if not isinstance(value, dict):
        return value
    array = np.array(value["data"], dtype=float).reshape(value["shape"])
    return array[:, 0] if array.shape[1] == 1 else array
