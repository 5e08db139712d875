"""When pictures were taken: as a list says it, or their names, or their numbers; and in which unit.

A median interval above 10 s or below 0.1 ms is no film's, and the seconds since 1970 have ten digits in this century:
by the two of them a unit is recognized. What is not stated is guessed, and each guess is said in a sentence, which
the command prints.
"""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from statistics import median

import numpy as np

from slamlib.datasets.pictures import SIGN
from slamlib.errors import SlamlibError
from slamlib.evaluation.trajectory_files import UNIT_NAMES
from slamlib.plain_data.files import read_text
from slamlib.plain_data.rows import words as words_of

UNITS = {name: unit for unit, name in UNIT_NAMES.items()}
FILM = 1e-4, 10.0  # [s], intervals of a film
USUAL = 2e-3, 2.0  # [s], of most films: as wide as the ratio of two units, so that at most one of them fits
EPOCH = 1e9, 1e10  # [s] since 1970: from 2001 on
LAPSE = 3600.0  # [s]: pictures of this century are at most as far apart
FPS = 30.0  # pictures a second, where nothing else is known
EVEN = 0.8  # the least share of steps that are not far from the median, of pictures that are evenly apart
_NUMBER = re.compile(SIGN + r"\d+(?:\.\d+)?")
# ROS's tools also write seconds_nanoseconds, padded: the same as with a point.
_PADDED = re.compile(r"(?<!\d)(\d{10})[_-](\d{9}|\d{6})(?!\d)")
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")


@dataclass(frozen=True)
class Times:
    """Times [s] of pictures in their order; interval [s]: typical, between two neighbours.

    stated: whether a list or the names give them; else they follow from numbers. guess: what was guessed, in a
    sentence, or "". unclear: why the names tell neither order nor times, or ""; then a list is needed.
    """

    values: tuple[float, ...]
    interval: float
    stated: bool
    guess: str = ""
    unclear: str = ""


def of_list(values: Sequence[float], names: Sequence[str], listing: Path, unit: str = "seconds") -> Times:
    """Times that a list states, in its format's unit, or in the one that is recognized.

    Raises SlamlibError for times that do not grow, and where no unit makes them a film's.
    """
    times = [UNITS[unit] * value for value in values]
    wrong = np.flatnonzero(~(np.diff(times) > 0) | ~np.isfinite(times[1:]))
    if len(wrong):
        i, j = wrong[0], wrong[0] + 1
        raise SlamlibError(
            f"{listing}: times must grow, but {names[i]} is of {times[i]} s and {names[j]} of {times[j]} s "
            f"({len(wrong)} such places): sort the rows, and leave out what is there twice"
        )
    if len(times) < 2:
        return Times(tuple(times), 1 / FPS, True)
    found = _unit(values, unit)
    if found is None:
        raise SlamlibError(
            f"{listing}: a picture every {_median(times):.3g} s, if its times are {unit}; in none of "
            f"{', '.join(UNITS)} is that a film's interval, {FILM[0]:g} to {FILM[1]:g} s: write them in seconds"
        )
    times = [UNITS[found] * value for value in values]
    interval, said = _median(times), ""
    if found != unit:
        said = f"its times are taken for {found}, not {unit}: "
    if said or not USUAL[0] <= interval <= USUAL[1]:
        said = f"{listing.name}: {said}a picture every {interval:.3g} s"
    return Times(tuple(times), interval, True, said)


def of_names(names: Sequence[str], fps: float | None = None, usual: float = FPS) -> tuple[list[int], Times]:
    """The order of pictures by the one number that changes in their names (in natural order), and their times.

    A number is a time if it has decimals, or is one since 1970, or is too far from the next for a frame's; else it
    counts frames, so that a gap takes its time. fps: pictures per second, by which times are not sought; usual: if it
    is not given and names tell no times.
    """
    order, column, rate = list(range(len(names))), _column(names), fps or usual
    assumed = f"no file or name gives times: {rate:g} pictures a second are assumed (--fps N, or --times FILE), "
    assumed *= fps is None and len(names) > 1
    if column is None:
        return order, _by_place(len(names), rate, assumed)
    if any("." in word for word in column):
        values, unclear = _decimals(column, names)
    else:
        values, unclear = [float(word) for word in column], ""
    if all(word.startswith("-") for word in column):
        unclear = (
            f"{names[0]} to {names[-1]}: a dash before each number, or a minus? Their order is not known: give their "
            "times with --times FILE, a row for each: time and name"
        )
    unit = _unit_of_names(column, sorted(values)) if values else None
    if unclear or unit is None:
        is_counted = not unclear and all(word.lstrip("-").isdigit() for word in column)
        times = _by_number([int(word) for word in column], rate, assumed) if is_counted else None
        return order, times or _by_place(len(names), rate, assumed, unclear)
    order.sort(key=values.__getitem__)
    if fps is not None:
        return order, _by_place(len(names), rate)
    seconds = [UNITS[unit] * values[i] for i in order]
    interval = _median(seconds)
    guess = f"the names of the pictures are taken for their times in {unit}: a picture every {interval:.3g} s"
    return order, Times(tuple(seconds), interval, True, guess)


def of_file(path: str | Path, names: Sequence[str]) -> tuple[list[int], Times]:
    """The order and the times of pictures from a file: a row for each, a time alone or with the picture's name.

    Raises SlamlibError for another number of rows, and for pictures without a time.
    """
    rows = _rows(path)
    if all(len(words) == 1 for _, words in rows):
        if len(rows) != len(names):
            raise SlamlibError(f"{path} has {len(rows)} times, and there are {len(names)} pictures")
        return list(range(len(names))), of_list([_time(path, i, word) for i, (word,) in rows], names, Path(path))
    known = {key: i for i, name in enumerate(names) for key in (name, Path(name).stem)}
    columns = range(max(len(words) for _, words in rows))
    at = max(columns, key=lambda k: sum(Path(words[k]).name in known for _, words in rows if k < len(words)))
    times = {
        known[Path(words[at]).name]: _time(path, i, next((word for k, word in enumerate(words) if k != at), ""))
        for i, words in rows
        if at < len(words) and Path(words[at]).name in known
    }
    missing = [name for i, name in enumerate(names) if i not in times]
    if missing:
        raise SlamlibError(
            f"{path} has {len(rows)} rows, and no time for {len(missing)} of the {len(names)} pictures, such as "
            f"{missing[0]}: a row is a time alone, or a time and the name of its picture"
        )
    order = sorted(times, key=times.__getitem__)
    return order, of_list([times[i] for i in order], [names[i] for i in order], Path(path))


def table(path: Path, columns: int) -> list[tuple[float, list[str]]]:
    """The rows of a list: time, and the words after it. Raises SlamlibError, naming the line."""
    rows = _rows(path)
    for i, words in rows:
        if len(words) < columns:
            raise SlamlibError(f"{path}, line {i}: {columns} columns are wanted, got {' '.join(words)!r}")
    return [(_time(path, i, words[0]), words[1:]) for i, words in rows]


def _rows(path: str | Path) -> list[tuple[int, list[str]]]:
    """Numbers and words of a list's lines, with blanks or commas between the words; # starts a comment.

    A first row without any digit, before others, has the names of columns. Raises SlamlibError for a list of nothing.
    """
    lines = [(i, line.strip()) for i, line in enumerate(read_text(path).splitlines(), 1)]
    rows = [(i, words_of(line, f"{path}, line {i}")) for i, line in lines if line and not line.startswith("#")]
    if not rows:
        raise SlamlibError(f"{path} lists no picture")
    return rows[1:] if len(rows) > 1 and not re.search(r"\d", " ".join(rows[0][1])) else rows


def _time(path: str | Path, line: int, word: str) -> float:
    try:
        return float(word)
    except ValueError:
        raise SlamlibError(f"{path}, line {line}: {word!r} is no time") from None


def _median(times: Sequence[float]) -> float:
    return float(np.median(np.diff(times)))


def _units(interval: float, least: float, most: float) -> list[str]:
    return [name for name, unit in UNITS.items() if least <= unit * interval <= most]


def _unit(values: Sequence[float], stated: str | None) -> str | None:
    """The unit of growing times: one that makes them a film's of this century, or the stated one, or a usual film's."""
    films, usual, lapse = (_units(_median(values), *limits) for limits in (FILM, USUAL, (FILM[0], LAPSE)))
    today = [name for name in lapse if EPOCH[0] <= UNITS[name] * abs(values[0]) < EPOCH[1]]
    both = [name for name in films if name in today]
    if both:
        return both[0]
    return stated if stated in films + today else next(iter(today + usual), None)


def _unit_of_names(column: Sequence[str], values: Sequence[float]) -> str | None:
    """The unit of the numbers in names, if they are times; values: growing. None if they count frames."""
    if len(values) < 2 or any(one >= other for one, other in pairwise(values)):
        return None
    is_today = any(EPOCH[0] <= unit * values[0] < EPOCH[1] for unit in UNITS.values())
    if any("." in word for word in column):
        parts = [word.split(".") for word in column]
        counts = sorted(int(part[-1]) for part in parts)
        is_count = len({part[0] for part in parts}) == 1 and counts[-1] - counts[0] == len(counts) - 1
        if is_count and not is_today:  # as in shot1.0001, shot1.0002
            return None
        return _unit(values, "seconds")
    if is_today or _median(values) > FILM[1] * FPS:
        return _unit(values, None)
    return None


def _column(names: Sequence[str]) -> list[str] | None:
    """The number that alone changes from name to name, or that alone is a time since 1970; None without one."""
    stems = [_PADDED.sub(r"\1.\2", name.rpartition(".")[0] or name) for name in names]
    if all(len(_DECIMAL_COMMA.findall(stem)) == 1 for stem in stems):
        stems = [_DECIMAL_COMMA.sub(".", stem) for stem in stems]
    if len(stems) < 2 or len({tuple(_NUMBER.split(stem)) for stem in stems}) > 1:
        return None
    changing = [column for column in zip(*map(_NUMBER.findall, stems), strict=True) if len(set(column)) > 1]
    if len(changing) > 1:
        digits = (10, 13, 16, 19)
        changing = [column for column in changing if all(len(word.partition(".")[0]) in digits for word in column)]
    return list(changing[0]) if len(changing) == 1 else None


def _decimals(column: Sequence[str], names: Sequence[str]) -> tuple[list[float], str]:
    """The values of decimal numbers, and why they are not clear, or "".

    Python's str() of seconds drops zeros at the end, "0.5"; others write nanoseconds after the point, and no zeros
    before them, "0.500000000" and "0.33" for 33 ns. By one of the two the pictures are evenly apart.
    """
    plain, fractions = [float(word) for word in column], [word.partition(".")[2] for word in column]
    if len(set(map(len, fractions))) == 1 or any(len(f) > 1 and f[0] == "0" for f in fractions):
        return plain, ""
    digits = next((n for n in (3, 6, 9) if n >= max(map(len, fractions))), max(map(len, fractions)))
    unpadded = [int(w.partition(".")[0]) + int(f or 0) / 10**digits for w, f in zip(column, fractions, strict=True)]
    one, other = _evenness(plain), _evenness(unpadded)
    if max(one, other) < EVEN or one == other:
        short, long = (names[fractions.index(pick(fractions, key=len))] for pick in (min, max))
        return plain, (
            f"{short} and {long}: decimal seconds, or seconds and a count of nanoseconds? By "
            f"{'neither' if max(one, other) < EVEN else 'both'} are the pictures evenly apart, so that their order is "
            "not known: give their times with --times FILE, a row for each: time and name"
        )
    return (plain if one > other else unpadded), ""


def _evenness(values: Sequence[float]) -> float:
    """The share of steps between sorted values that are within a half of their median."""
    steps = np.diff(sorted(values))
    return float(np.mean(np.abs(steps - np.median(steps)) < 0.5 * np.median(steps)))


def _by_place(count: int, rate: float, assumed: str = "", unclear: str = "") -> Times:
    guess = f"{assumed}one every {1 / rate:.3g} s" if assumed else ""
    return Times(tuple(number / rate for number in range(count)), 1 / rate, False, guess, unclear)


def _by_number(numbers: list[int], rate: float, assumed: str) -> Times | None:
    """Times of frames with these numbers, from the first one on; a step that all have in common is that of one frame.

    None unless the numbers grow.
    """
    steps = [after - before for before, after in pairwise(numbers)]
    if min(steps) <= 0:
        return None
    common = math.gcd(*steps)
    places = [(number - numbers[0]) // common for number in numbers]
    interval = median(steps) / common * (1 / rate)
    told = "the numbers in the names have gaps, which take their time: " if max(steps) > common else ""
    told += f"the numbers in the names go by {common}: " if common > 1 else ""
    guess = f"{assumed}{told}one every {interval:.3g} s" if assumed or told else ""
    return Times(tuple(place / rate for place in places), interval, False, guess)
