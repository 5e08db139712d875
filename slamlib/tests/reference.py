"""Numbers that the seeds' toolbox computed, to compare with: they lie beside the tests, in data/toolbox.

They are those of the toolbox under Octave: every recorded case of each function that a test reads, with all digits, and
two recorded runs, of which the controls, the measurements and the first frame have all digits, the other states twelve
and the variances nine. SLAMLIB_REFERENCE names another folder with files of the same form.
"""

import json
import os
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

FOLDER = Path(os.environ.get("SLAMLIB_REFERENCE") or Path(__file__).parent / "data" / "toolbox")
POSE = 7  # numbers of the robot's pose, with which a recorded state starts


def cases(family: str, function: str, *, columns: bool = False) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Inputs and outputs of a function's recorded calls; column vectors become one-dimensional unless `columns`."""
    entry = next(f for f in _read(family)["functions"] if f["name"] == function)
    return [tuple({k: _array(v, columns) for k, v in c[side].items()} for side in ("inputs", "outputs"))
            for c in entry["cases"]]  # fmt: skip


def recording(name: str) -> list[dict[str, Any]]:
    """The frames of a recorded run: controls, measurements, and what the toolbox made of them; arrays throughout."""
    frames = [_arrays(frame) for frame in _read(f"replay_{name}")["frames"]]
    for frame in frames:
        used = np.unique(np.concatenate([np.arange(1, POSE + 1), *(np.ravel(lm["range1"]) for lm in frame["lmks"])]))
        for landmark in frame["lmks"]:
            places = np.searchsorted(used, np.ravel(landmark["range1"]))
            landmark["x"] = np.ravel(frame["x_used"])[places]
    return frames


@cache
def _read(family: str) -> Any:
    return json.loads((FOLDER / f"{family}.json").read_text("utf-8"))


def _arrays(value: Any) -> Any:
    if isinstance(value, list):
        return [_arrays(v) for v in value]
    if isinstance(value, dict) and "data" not in value:
        return {k: _arrays(v) for k, v in value.items()}
    return np.array(value["data"], dtype=float).reshape(value["shape"]) if isinstance(value, dict) else value


def _array(value: Any, columns: bool) -> Any:
    if not isinstance(value, dict):
        return value
    array = np.array(value["data"], dtype=float).reshape(value["shape"])
    return array[:, 0] if array.shape[1] == 1 and not columns else array
