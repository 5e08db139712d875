"""The route of one frame through the filter: which function is called when, in which file, and at which step.

`python -m slambook.route` traces two frames with one landmark in the map and prints them: one that updates and converts
it, and one that deletes it and initializes another. Chapter ekf_slam. Left out is what every step uses: generated code,
the call of a model, and manifolds.
"""

import argparse
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from pathlib import Path
from types import FrameType
from typing import Any

import slamlib
from slamlib.experiments.presets import preset

ROOT = Path(slamlib.__file__).parent
LEFT_OUT = ("generated/", "models/", "manifolds.py", "analytic.py")
# The step that begins where one of these functions is called, in the order of chapter ekf_slam.
STEPS = {
    "predict": "Slam.predict",
    "project": "Slam.project",
    "select": "select",
    "match": "match",
    "gate": "gate",
    "update": "SequentialUpdate.apply",
    "convert": "convert",
    "delete": "Slam._delete",
    "initialize": "Slam._initialize",
}


@dataclass(frozen=True)
class Call:
    """One call of a function of slamlib."""

    file: str
    function: str


@dataclass(frozen=True)
class Route:
    """All calls of one frame, in their order."""

    calls: tuple[Call, ...]

    @property
    def files(self) -> list[str]:
        """The files, in the order in which they are first entered."""
        return list(dict.fromkeys(call.file for call in self.calls))

    @property
    def changes(self) -> int:
        """How often a call is in another file than the one before it."""
        return sum(1 for _ in groupby(call.file for call in self.calls)) - 1

    @property
    def steps(self) -> list[str]:
        """The steps, in the order in which they begin; one that begins twice is there twice."""
        return [name for name, _ in self.by_step()][1:]

    def by_step(self) -> Iterator[tuple[str, list[Call]]]:
        """Each step, and the calls from its beginning to that of the next one."""
        names, found = {function: name for name, function in STEPS.items()}, [("check", list[Call]())]
        for call in self.calls:
            if call.function in names:
                found.append((names[call.function], []))
            found[-1][1].append(call)
        yield from found

    def __str__(self) -> str:
        head = f"{len(self.calls)} calls, {len(self.files)} files, {self.changes} changes of file"
        return "\n".join([head, *(f"  {name:10} {_line(calls)}" for name, calls in self.by_step())])


def _line(calls: list[Call]) -> str:
    """The files of a step with the number of calls in each, in the order in which they are first entered."""
    files = [call.file for call in calls]
    return f"{len(calls):3}  " + ", ".join(f"{file} {files.count(file)}" for file in dict.fromkeys(files))


def traced(function: Callable[[], Any]) -> Route:
    """The route through slamlib of one call of a function."""
    calls: list[Call] = []

    def note(frame: FrameType, event: str, _: Any) -> None:
        code = frame.f_code
        if event == "call" and code.co_filename.startswith(str(ROOT)) and not code.co_name.startswith("<"):
            file = Path(code.co_filename).relative_to(ROOT).as_posix()
            if not file.startswith(LEFT_OUT):
                calls.append(Call(file, code.co_qualname))

    sys.setprofile(note)
    try:
        function()
    finally:
        sys.setprofile(None)
    return Route(tuple(calls))


def routes() -> dict[str, Route]:
    """The two frames: what they do, and their routes."""
    _both()  # what is computed once, as the gate's limit, is there
    return _both()


def _both() -> dict[str, Route]:
    p = preset("points")
    options = replace(p.options, points="idpPnt", max_new_first=1, max_new=0, convert_below=1e9)
    frames = [frame for frame, _ in replace(p, frames=3).simulate()]
    slam, found = replace(p, options=options).slam(), {}
    slam.step(frames[0])
    found["updates and converts a landmark"] = traced(lambda: slam.step(frames[1]))
    assert slam.landmarks[0].kind.name == "eucPnt"
    slam.options, old = replace(options, max_new=1, min_searches=0, min_inlier_ratio=1.0), slam.landmarks[0]
    old.matched += 1  # a match that was no inlier
    found["deletes it and initializes another"] = traced(lambda: slam.step(frames[2]))
    assert old not in slam.landmarks
    assert len(slam.landmarks) == 1
    return found


def main() -> None:
    """Print the routes."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    for what, route in routes().items():
        print(f"A frame that {what}: {route}\n")


if __name__ == "__main__":
    main()
