"""For those who teach with the book: the notebooks without their solutions, and the tables of the instructor's notes.

`make instructor` packs the notebooks with exercises, their data and the packages' wheel, as _build/ekf-slam-course.zip.
`python -m book.tools.instructor --notes` writes the tables of book/appendices/instructors_notes.md again, from the
chapters' own cells; a test says when they are not current.
"""

import json
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from slambook.exercises import load_all

from book.tools import landing, layout, live, wheel

ZIP = layout.BUILD / "ekf-slam-course.zip"
NOTES = layout.BOOK / "appendices" / "instructors_notes.md"
SOLUTION = re.compile(r"```\{solution-(?:start\} (\S+)|end\})\n[^`]*```(?:\n|$)")
CHECK = re.compile(r"\bcheck\(\s*\"([\w.]+)\"")
EXERCISE = re.compile(r"```\{exercise\}\n:label: (\S+)\n\*\*(.+?)\*\*\s*(.*?)\n```", re.DOTALL)
READ_ME = """# EKF-SLAM, derived: the notebooks of the course, without solutions

    python -m pip install {wheel} matplotlib scipy sympy ipywidgets opencv-python-headless scikit-image jupyterlab
    jupyter lab chapters

Exercises say what to write, and their checks test properties of it: no answer is stored in the packages either.
"""
COURSE = [  # a week's subject, and its chapters
    ("What SLAM is; Gaussians", "slam_in_five_minutes gaussians"),
    ("The Kalman filter", "kalman_filter"),
    ("Is a filter consistent?", "consistency"),
    ("How to trust a Jacobian; linearization", "proving_a_jacobian extended_kalman_filter"),
    ("Rotations, frames, motion", "frames_and_quaternions motion_models"),
    ("Cameras and other sensors", "pinhole depth_stereo_range"),
    ("Points in space", "points"),
    ("The map as one Gaussian", "stochastic_map initialization"),
    ("EKF-SLAM whole", "ekf_slam"),
    ("Data association", "data_association"),
    ("What cannot be known", "observability"),
    ("Searching and matching in images", "active_search"),
    ("Visual odometry", "visual_odometry"),
    ("One camera, or a project: a model of one's own", "monocular your_own_model"),
]
WORDS = {"a": 1, "an": 1, "one": 1, "two": 2, "three": 3, "five": 5, "forty": 40, "a quarter": 15, "a half": 30}


def minutes(text: str) -> int:
    """A time as the chapters say it, such as "two and a quarter hours", in minutes; raises ValueError."""
    counted = re.findall(r"(\w+)(?= minutes| more)", text)
    if counted:
        return sum(int(word) if word.isdigit() else WORDS[word] for word in counted)
    found = re.fullmatch(r"(\w+)(?: hours?)?(?: and (a \w+)(?: hours?)?)?", text)
    if found is None:
        raise ValueError(f"{text!r} is no time")
    return 60 * WORDS[found[1]] + (WORDS[found[2]] if found[2] else 0)


def cells(page: Path) -> list[dict[str, Any]]:
    """The cells of a notebook."""
    return list(json.loads(page.read_text("utf-8"))["cells"])


def without_solutions(page: Path) -> str:
    """A notebook without the cells and the paragraphs of its solutions."""
    notebook, inside = json.loads(page.read_text("utf-8")), False
    kept = []
    for cell in notebook["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            pieces, place = [], 0
            for mark in SOLUTION.finditer(text):
                pieces += [] if inside else [text[place : mark.start()]]
                inside, place = mark[1] is not None, mark.end()
            text = "".join(pieces) + ("" if inside else text[place:])
            if text.strip():
                kept.append({**cell, "source": text.strip("\n").splitlines(keepends=True)})
        elif not inside:
            kept.append(cell)
    if inside:
        raise ValueError(f"{page.name}: a solution does not end")
    return json.dumps({**notebook, "cells": kept}, indent=1, ensure_ascii=False) + "\n"


def export() -> Path:
    """Pack the course; where it is."""
    pages = layout.lessons()
    content = {page.relative_to(layout.BOOK).as_posix(): without_solutions(page).encode() for page in pages}
    for file in layout.BOOK.glob("*/data/*"):
        content[file.relative_to(layout.BOOK).as_posix()] = file.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        made = wheel.build(Path(folder))
        content[made.name] = made.read_bytes()
    content["README.md"] = READ_ME.format(wheel=made.name).encode()
    layout.write_whole(ZIP, live.zipped({f"{ZIP.stem}/{name}": data for name, data in content.items()}, level=6))
    return ZIP


def exercises(page: Path) -> Iterator[tuple[str, str, str, bool, int]]:
    """Of each exercise: label, kind, what it trains, whether code judges it, and minutes."""
    texts: dict[str, tuple[str, str]] = {}  # by label: kind, and words
    checks: dict[str, list[str]] = {}
    lines: dict[str, int] = {}
    asked = solved = ""  # the exercise, and the solution, that a cell is of
    for cell in cells(page):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            for asked, kind, words in EXERCISE.findall(source):
                texts[asked] = kind.rstrip("."), re.sub(r"\s+", " ", words)
                checks[asked] = CHECK.findall(words)
            for mark in SOLUTION.finditer(source):
                solved = mark[1] or ""
        elif solved:
            own = [line for line in source.splitlines() if line.strip() and not line.startswith(("import ", "from "))]
            lines[solved] = lines.get(solved, 0) + len(own)
        elif "exercise" in cell["metadata"].get("tags", []):
            checks[asked] += CHECK.findall(source)
    known = load_all()
    for label, (kind, words) in texts.items():
        what = known[checks[label][0]][0] if checks[label] else re.split(r"(?<=[.?!])\s", words, maxsplit=1)[0]
        yield label, kind, what, bool(checks[label]), _estimate(words, lines.get(label, 0))


def _estimate(words: str, lines: int) -> int:
    """Ten minutes to think, one for fifty words of the text, two for each line of the solution; in fives."""
    return 5 * round((10 + len(words.split()) / 50 + 2 * lines) / 5)


def tables() -> dict[str, str]:
    """The tables of the notes, by their names."""
    told = landing.chapters()
    week = ["| Week | Subject | Read | Hours of reading |", "|---|---|---|---|"]
    for number, (subject, names) in enumerate(COURSE, start=1):
        hours = sum(minutes(told[name]["time"]) for name in names.split()) / 60
        read = ", ".join(f"{{doc}}`../chapters/{name}`" for name in names.split())
        week.append(f"| {number} | {subject} | {read} | {hours:.1f} |")
    train = ["| Exercise | Kind | What it trains | Checked | Minutes |", "|---|---|---|---|---|"]
    for page in layout.pages():
        if page not in layout.lessons():
            continue
        folder = page.parent.name
        train.append(f"| {{doc}}`../{folder}/{page.stem}` | | | | |")
        for label, kind, what, checked, time in exercises(page):
            train.append(f"| {{numref}}`{label}` | {kind} | {what} | {'yes' if checked else ''} | {time} |")
    return {"the course": "\n".join(week), "the exercises": "\n".join(train)}


def current() -> str:
    """The page of notes with tables as they should be."""
    text = NOTES.read_text("utf-8")
    for name, table in tables().items():
        before, mark, rest = text.partition(f"<!-- {name} -->\n")
        if not mark:
            raise ValueError(f"{NOTES.name} has no place for {name}")
        text = f"{before}{mark}\n{table}\n\n<!-- so far -->" + rest.partition("<!-- so far -->")[2]
    return text


def main() -> int:
    """Write the archive, or with --notes the tables."""
    if sys.argv[1:] == ["--notes"]:
        layout.write_whole(NOTES, current().encode())
        print(NOTES)
    else:
        print(f"the notebooks without solutions: {export()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
