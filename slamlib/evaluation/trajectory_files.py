"""Files of trajectories as other tools write them: rows of numbers whose order a header states, or else the format.

Formats: TUM RGB-D (Sturm and others, 2012), times in seconds; EuRoC (Burri and others, 2016), whole nanoseconds, with
velocities and biases 17 columns, of VINS-Fusion 11; KITTI (Geiger and others, 2012), matrices 3 x 4 row by row;
TartanAir (Wang and others, 2020), whose axes are NED, x ahead and z down: poses are read as they are.

What does not say a pose is not a pose: rows of nan, which trackers write while they do not see the body, are left out,
rows that are there twice are used once, rows are put in the order of their times, and a note says so. What is damaged
is refused, by the number of its line.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from math import nan
from pathlib import Path

import numpy as np

from slamlib.errors import SlamlibError, entry
from slamlib.geometry.quaternion import best_pivot, from_rotation
from slamlib.manifolds import Array, Indices, Mask
from slamlib.plain_data.files import read_text
from slamlib.plain_data.rows import words as words_of

NANOSECOND = 1e-9
POSITION, QUATERNION = ("x", "y", "z"), ("qw", "qx", "qy", "qz")
MATRIX = tuple(f"r{row}{column}" for row in "123" for column in "123")


@dataclass(frozen=True)
class TrajectoryFormat:
    """The columns of a format's rows, in their order; how many columns there may be; the unit of its times [s]."""

    columns: tuple[str, ...]
    widths: tuple[int, ...]
    unit: float | None = None


FORMATS = {
    "tum": TrajectoryFormat(("t", *POSITION, "qx", "qy", "qz", "qw"), (8,)),
    "euroc": TrajectoryFormat(("t", *POSITION, *QUATERNION), (8, 11, 17), NANOSECOND),
    "kitti": TrajectoryFormat((*MATRIX[:3], "x", *MATRIX[3:6], "y", *MATRIX[6:], "z"), (12,)),
    "tartanair": TrajectoryFormat((*POSITION, "qx", "qy", "qz", "qw"), (7,)),
}
STATE_IT = f"state its format (option format, or reference-format: {', '.join(FORMATS)})"
NAME_COLUMNS = "name the columns in a first line such as time,x,y,z,qx,qy,qz,qw"
KNOWN = "TUM has 8, EuRoC 8, 11 or 17, KITTI 12, TartanAir 7"

UNITS = {  # of times, [s]
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds"), 1.0),
    **dict.fromkeys(("ms", "msec", "msecs", "millisecond", "milliseconds"), 1e-3),
    **dict.fromkeys(("us", "µs", "μs", "usec", "usecs", "microsecond", "microseconds"), 1e-6),
    **dict.fromkeys(("ns", "nsec", "nsecs", "nanosec", "nanosecond", "nanoseconds"), NANOSECOND),
}
UNIT_NAMES = {1.0: "seconds", 1e-3: "milliseconds", 1e-6: "microseconds", NANOSECOND: "nanoseconds"}
SECONDS_DIGITS = 10  # of the whole seconds since 1970
SINCE_1970 = 9e8, 5e9  # [s]: a time between 1998 and 2128 tells its unit
LARGEST = 1e30  # of any number: what is larger is damaged, and its square may be infinite
LONG_STEP = 1e6  # whole numbers with steps as long are nanoseconds: milliseconds or seconds would be an hour and more

# Words in the names of columns, of what is wanted and of what only looks like it.
TIME = {"t", "time", "times", "timestamp", "timestamps", "stamp", "ts"}
OF_POSITION = {"t", "p", "pos", "position", "pose", "trans", "translation", "point", "loc", "location"}
OF_QUATERNION = {"q", "quat", "quaternion", "orientation", "rot", "rotation", "ori"}
OF_OTHERS = {"v", "vel", "velocity", "std", "sigma", "stddev", "cov", "covariance", "var", "variance", "err", "error"}
LENGTHS = {"m", "meter", "meters", "metre", "metres"}
OTHER_LENGTHS = {
    *("mm", "cm", "dm", "km", "um", "µm", "μm", "in", "inch", "inches", "ft", "foot", "feet", "yd", "mi", "miles"),
    *(f"{size}met{end}" for size in ("milli", "centi", "deci", "kilo") for end in ("er", "ers", "re", "res")),
}


@dataclass(frozen=True, eq=False)
class TextRows:
    """Rows of words of a text, with the numbers of their lines; the lines that may be a header; are there commas?"""

    path: str | Path
    words: list[list[str]]
    lines: list[int]
    comments: list[str]
    header: str | None
    commas: bool

    def numbers(self, columns: Sequence[int]) -> Array:
        """The numbers (n, k) of some columns, perhaps nan. Raises SlamlibError, which names the line."""
        found = [
            [_number(row[c], f"{self.path}, line {line}, column {c + 1}") for c in columns]
            for row, line in zip(self.words, self.lines, strict=True)
        ]
        return np.array(found).reshape(len(found), len(columns))


def _number(word: str, where: str) -> float:
    try:
        value = float(word.replace("_", "?"))  # "1_0" is ten for Python alone
    except ValueError:
        problem = f"{word!r} is no number" if word else "there is nothing between two separators"
        raise SlamlibError(f"{where}: {problem}: repair the row, or remove it") from None
    if abs(value) > LARGEST:
        raise SlamlibError(f"{where}: {word} is not finite, or too large: repair the row, or remove it")
    return value


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def text_rows(path: str | Path) -> TextRows:
    """The rows of a text, as long as each other; blank lines and comments (#, %) are none. Raises SlamlibError."""
    words: list[list[str]] = []
    lines, comments, header, commas = [], [], None, False
    for number, line in enumerate(read_text(path).splitlines(), 1):
        text = line.partition("#")[0].strip()
        if not text or text.startswith("%"):
            if not words:
                comments.append(line.strip().lstrip("#%"))
            continue
        row = words_of(text, f"{path}, line {number}")
        if not words and not any(map(_is_number, row)):
            header = text
            continue
        commas |= "," in text or ";" in text
        words.append(row)
        lines.append(number)
    if not words:
        raise SlamlibError(f"{path} is no trajectory: there is no row of numbers in it")
    counts = [len(row) for row in words]
    usual = max(counts, key=counts.count)
    for count, number in zip(counts, lines, strict=True):
        if count != usual:
            raise SlamlibError(f"{path}, line {number} has {count} columns, other rows {usual}: repair or remove it")
    return TextRows(path, words, lines, comments, header, commas)


@dataclass(frozen=True, eq=False)
class PoseTable:
    """The poses (n, 7) of a file, nan where a row says none; times (n,) [s], or None; the lines; notes on reading."""

    path: str | Path
    poses: Array
    times: Array | None
    lines: list[int]
    notes: tuple[str, ...] = ()

    def timed(self, times: Array | None = None) -> tuple[Array, Array, tuple[str, ...]]:
        """The times (k,), increasing, and poses (k, 7) of rows that have one, and the notes; see the module.

        times (n,): of rows that have none. Raises SlamlibError.
        """
        count = len(self.poses)
        if self.times is None and (times is None or len(times) != count):
            why = "give them (option times)" if times is None else f"{len(times)} are given, and as many are wanted"
            raise SlamlibError(f"{self.path} has {count} poses, but no times: {why}")
        known = self.times if self.times is not None else np.asarray(times)
        notes, rows = list(self.notes), np.flatnonzero(np.isfinite(self.poses).all(1))
        if left := count - len(rows):
            first = self.lines[int(np.argmin(np.isfinite(self.poses).all(1)))]
            notes.append(f"{self.path}: {left} of {count} rows have nan for a pose, first line {first}: left out")
        if not len(rows):
            raise SlamlibError(f"{self.path} is no trajectory: nan is in each of its {count} rows")
        order = rows[np.argsort(known[rows], kind="stable")]
        if (order != rows).any():
            early = self.lines[int(rows[1:][np.diff(known[rows]) < 0][0])]
            notes.append(f"{self.path}: line {early} is earlier than the row before it: the rows are sorted by time")
        same = np.flatnonzero(np.diff(known[order]) == 0)
        for a, b in zip(order[same], order[same + 1], strict=True):
            if (self.poses[a] != self.poses[b]).any():
                raise SlamlibError(
                    f"{self.path}: lines {self.lines[a]} and {self.lines[b]} have one time, {known[a]:.9f} s, and two "
                    "poses: keep one of them, or write the times with more digits"
                )
        if len(same):
            first = self.lines[int(order[same[0] + 1])]
            notes.append(f"{self.path}: {len(same)} rows are there twice, first line {first}: used once")
        order = np.delete(order, same + 1)
        return known[order], self.poses[order], tuple(notes)


def read_poses(path: str | Path, form: str | None = None) -> PoseTable:
    """Read the poses of a file: its header states the columns, or `form` its format, or its numbers do.

    Raises SlamlibError where more than one order is possible, and for rows that are damaged, by their lines.
    """
    rows = text_rows(path)
    stated = None if form else _stated(rows)
    columns, unit = stated or _of_format(rows, form)
    values = dict(zip(columns, rows.numbers(list(columns.values())).T, strict=True))
    notes: list[str] = []
    times = None
    if "t" in values:
        times = values["t"]
        if len(bad := np.flatnonzero(np.isnan(times))):
            raise SlamlibError(f"{path}, line {rows.lines[bad[0]]}: the time is nan: repair the row, or remove it")
        factor = unit or _unit(times)
        if unit is None and factor != 1:
            notes.append(f"{path}: its times are {UNIT_NAMES[factor]}, by their size")
        times = times if factor == 1 else factor * times
    elif stated:
        notes.append(f"{path}: its header names no time")
    if not form and not stated and unit is None and (rows.commas if times is not None else "qw" in columns):
        kind, time = ("TUM", "time, ") if times is not None else ("TartanAir", "")
        notes.append(f"{path} has no header: its columns are taken for {time}x, y, z, qx, qy, qz, qw, as {kind}'s are")
    place = np.stack([values[name] for name in POSITION], axis=1)
    turned = _from_matrices(rows, values) if MATRIX[0] in values else _from_quaternions(rows, values, columns)
    return PoseTable(path, np.concatenate([place, turned], axis=1), times, rows.lines, tuple(notes))


def read_times(path: str | Path) -> tuple[Array, tuple[str, ...]]:
    """The times (n,) [s], increasing, that stand first in the rows of a file, and notes. Raises SlamlibError."""
    rows = text_rows(path)
    _check_that_times_are_first(rows)
    times = rows.numbers([0])[:, 0]
    if len(bad := np.flatnonzero(~(np.diff(times) > 0))):
        raise SlamlibError(f"{path}, line {rows.lines[bad[0] + 1]}: times must grow from row to row")
    factor = _unit(times)
    if factor == 1:
        return times, ()
    return factor * times, (f"{path}: its times are {UNIT_NAMES[factor]}, by their size",)


def _check_that_times_are_first(rows: TextRows) -> None:
    """Raise SlamlibError for two columns that may be one with decimal commas, and for a first one that counts rows."""
    if len(rows.words[0]) < 2 or rows.header is not None:
        return
    first, second, *others = zip(*rows.words, strict=True)
    if rows.commas and not others and all(map(str.isdecimal, (*first, *second))) and len(first[0]) <= SECONDS_DIGITS:
        raise SlamlibError(
            f"{rows.path}, line {rows.lines[0]}: is {first[0]},{second[0]} one number with a decimal comma, or are "
            "there two columns? Write times with points, and nothing else"
        )
    steps = np.diff([[float(word) if _is_number(word) else nan for word in column] for column in (first, second)])
    if steps.size and (steps[0] == 1).all() and (steps[1] > 0).all():
        raise SlamlibError(f"{rows.path}: its first column counts rows: leave it out, so that times stand first")


def _unit(times: Array) -> float:
    """The unit [s] of times, by their size: of those since 1970, and of whole numbers with steps that are too long."""
    middle, low, high = float(np.median(times)), *SINCE_1970
    since = [unit for unit in (NANOSECOND, 1e-6, 1e-3) if low < unit * middle < high]
    steps = np.abs(np.diff(times))
    is_long = len(steps) > 0 and float(np.median(steps)) >= LONG_STEP and bool((times == np.round(times)).all())
    return next(iter(since), NANOSECOND if is_long else 1.0)


def _of_format(rows: TextRows, form: str | None) -> tuple[dict[str, int], float | None]:
    """The columns by name, and the unit of the times, of a format: the one that is given, or that the numbers tell."""
    width = len(rows.words[0])
    chosen = entry("format", form, FORMATS) if form else _told_by_numbers(rows, width)
    if chosen is None or width not in chosen.widths:
        what = f"{form} has {' or '.join(map(str, chosen.widths))}" if chosen else f"{KNOWN}: {NAME_COLUMNS}"
        raise SlamlibError(f"{rows.path} is no trajectory of a known format: rows of {width} numbers, and {what}")
    return {name: place for place, name in enumerate(chosen.columns)}, chosen.unit


def _told_by_numbers(rows: TextRows, width: int) -> TrajectoryFormat | None:
    """The format of rows without a header. Raises SlamlibError where it may be TUM's or EuRoC's.

    Both have eight columns, but TUM seconds between blanks, EuRoC whole nanoseconds between commas. Other tools mix
    that: seconds are TUM's, whatever separates them (EuRoC's has none), as are other times with decimals between blanks
    (ORB-SLAM3 writes nanoseconds so).
    """
    fitting = [known for known in FORMATS.values() if width in known.widths]
    if FORMATS["euroc"] not in fitting:
        return next(iter(fitting), None)
    unit = _unit(rows.numbers([0])[:, 0])
    if FORMATS["tum"] not in fitting:
        return FORMATS["euroc"] if unit == NANOSECOND else None
    likeness = rows.commas + all(re.fullmatch(r"[-+]?\d+", row[0]) is not None for row in rows.words)
    if unit == 1 or likeness == 0 or (likeness == 1 and unit != NANOSECOND):
        return FORMATS["tum"]
    if likeness == 2 and unit == NANOSECOND:
        return FORMATS["euroc"]
    raise SlamlibError(
        f"{rows.path}: times in {UNIT_NAMES[unit]}, and no header: its quaternions may be w x y z, as EuRoC's are, or "
        f"x y z w, as TUM's: {STATE_IT}, or {NAME_COLUMNS}"
    )


def _stated(rows: TextRows) -> tuple[dict[str, int], float | None] | None:
    """The columns by name, and the unit of the times, that a header states; None where there is none.

    A header is a line without a number above the rows, or the last comment there that names coordinates, or as many
    columns as there are; words before them in a comment, such as a title, are no columns. Raises SlamlibError for a
    header that does not name one column for each number of a pose.
    """
    width = len(rows.words[0])
    for text in [rows.header] if rows.header is not None else reversed(rows.comments):
        names = _names(text)
        roles = [_role(name) for name in names]
        known = sum(role is not None for role in roles)
        counted = len(names) == width and (known > 0 or "," in text)
        if not (known >= 3 or counted or rows.header is not None):
            continue
        part = [role or ("", None) for role in roles[-width:]]
        columns = [role for role, _ in part]
        is_whole = len(names) == width or (len(names) > width and rows.header is None and not any(roles[:-width]))
        if is_whole and columns.count("t") <= 1 and all(columns.count(name) == 1 for name in (*POSITION, *QUATERNION)):
            units = [unit for role, unit in part if role == "t"]
            return {role: place for place, role in enumerate(columns) if role}, next(iter(units), None)
        raise SlamlibError(f"{rows.path}: {_unclear(names, roles, width)}: correct its names, or {STATE_IT}")
    return None


def _unclear(names: list[str], roles: list[tuple[str, float | None] | None], width: int) -> str:
    """What is wrong with a header."""
    found = [role[0] for role in roles if role]
    missing = [name for name in (*POSITION, *QUATERNION) if name not in found]
    unknown = [name for name, role in zip(names, roles, strict=True) if role is None]
    if missing:
        others = f"; not known: {', '.join(unknown[:8])}" if unknown else ""
        if any(set(re.split(r"[^a-zµμ]+", name.lower())) & OTHER_LENGTHS for name in unknown):
            others += " (positions are wanted in metres)"
        return f"its header has no name for {', '.join(missing)}{others}"
    twice = [name for name, role in zip(names, roles, strict=True) if role and found.count(role[0]) > 1]
    if twice:
        return f"its header has more than one name for the same: {', '.join(twice)}"
    return f"its header has {len(names)} names, and its rows have {width} columns"


def _names(header: str) -> list[str]:
    """The names of columns, each with its unit in brackets, if it has one."""
    text = re.sub(r"\s*[\[(]([^\])]*)[\])]", lambda unit: f"[{unit[1].replace(' ', '').replace(',', '')}]", header)
    names = re.split(r"[,;]" if re.search("[,;]", text) else r"\s+", text.strip())
    names = [name.strip().strip("\"'") for name in names]
    return names[:-1] if len(names) > 1 and not names[-1] else names


def _role(name: str) -> tuple[str, float | None] | None:
    """What a column of this name holds, t, x, y, z, qw, qx, qy or qz; of times the unit [s] that it states; or None.

    Such names are p_RS_R_x [m], q_RS_w [], tx, qw, pose.position.x, field.header.stamp, timestamp [ns].
    """
    bare, _, unit = name.lower().partition("[")
    words = [word for word in re.split(r"[^0-9a-zµμ]+", bare) if word]
    if len(words) > 1 and words[-1] in LENGTHS:
        words.pop()
    if not words or set(words) & OF_OTHERS:
        return None
    if axis := re.fullmatch("(.*)([xyzw])", words[-1]):
        of = {*words[:-1], axis[1]} - {""}
        if of & OF_QUATERNION:
            return f"q{axis[2]}", None
        is_position = axis[2] != "w" and (not of or of & OF_POSITION) and unit.strip("] ") not in OTHER_LENGTHS
        return (axis[2], None) if is_position else None
    if set(words) & TIME or (len(words) == 1 and words[0] in UNITS):
        return "t", next((UNITS[word] for word in [unit.strip("] "), *words] if word in UNITS), None)
    return None


def _from_quaternions(rows: TextRows, values: dict[str, Array], columns: dict[str, int]) -> Array:
    """The quaternions (n, 4), w first; they have length one, or are nan."""
    found = np.stack([values[name] for name in QUATERNION], axis=1)
    length = np.linalg.norm(found, axis=1)
    if len(bad := np.flatnonzero(np.abs(length - 1) > 0.01)):
        order = sorted(QUATERNION, key=lambda name: columns[name])
        row = ", ".join(f"{values[name][bad[0]]:g}" for name in order)
        raise SlamlibError(
            f"{rows.path}, line {rows.lines[bad[0]]}: its quaternion ({', '.join(order)}) = ({row}) has length "
            f"{length[bad[0]]:.4g} instead of one{_others(bad)}: repair the row, or remove it"
        )
    return found


def _from_matrices(rows: TextRows, values: dict[str, Array]) -> Array:
    """The quaternions (n, 4) of KITTI's matrices, or nan."""
    turns = np.stack([values[name] for name in MATRIX], axis=1).reshape(-1, 3, 3)
    known = np.isfinite(turns).all((1, 2))
    found = np.full((len(turns), 4), nan)
    if len(bad := np.flatnonzero(known & ~_are_rotations(turns))):
        first = int(bad[0])
        whole = [values[name][first] for name in FORMATS["kitti"].columns]
        what = _instead_of_a_rotation(turns[first], np.array(whole[:9]).reshape(3, 3))
        where = f"{rows.path}, line {rows.lines[first]}"
        raise SlamlibError(f"{where}: the 3 x 3 part of its matrix is no rotation{_others(bad)}: {what}")
    found[known] = from_rotation(turns[known], best_pivot(turns[known]))
    return found


def _are_rotations(matrices: Array) -> Mask:
    near = np.abs(matrices @ matrices.swapaxes(-1, -2) - np.eye(3)).max((-2, -1)) < 0.02
    return near & (np.linalg.det(np.where(np.isfinite(matrices), matrices, 0)) > 0)


def _instead_of_a_rotation(matrix: Array, nine: Array) -> str:
    """What a matrix is that should be a rotation; nine: the first nine numbers of its row."""
    det = float(np.linalg.det(matrix))
    size = abs(det) ** (1 / 3)
    if size > 0 and _are_rotations(np.sign(det) * matrix / size):
        mirrored = "; the sign is that of left-handed axes, which no rotation has: mirror one" if det < 0 else ""
        scale = f" (the scale is {size:.4g}: divide by it)" if abs(size - 1) > 0.005 else ""
        return f"its determinant is {det:.4g}{scale}{mirrored}"
    if _are_rotations(nine):
        return (
            "its first nine numbers are one, by rows or by columns: KITTI's rows are r11 r12 r13 x r21 r22 r23 y r31 "
            "r32 r33 z"
        )
    return f"its determinant is {det:.4g}, and its rows are not at right angles and of length one"


def _others(bad: Indices) -> str:
    return f" (and those of {len(bad) - 1} more)" if len(bad) > 1 else ""
