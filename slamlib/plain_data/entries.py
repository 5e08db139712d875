"""What a file holds, by name: each value is asked for, and a number that nobody has asked for is refused.

A tool's names are compared as people write them: camera_matrix, cameraMatrix and Camera_Matrix are one name.
"""

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from fnmatch import fnmatchcase
from sys import float_info
from typing import Any

from slamlib.errors import SlamlibError
from slamlib.plain_data.parsing import parsed, value_of

Numbers = tuple[float, ...]


def alike(name: str) -> str:
    """A name as it is compared: in small letters, without blanks, dashes, dots and underscores."""
    return re.sub(r"[\s_.-]", "", name).lower()


def named_values(text: str) -> dict[str, Any]:
    """The named values that a text holds; none if it is of another kind, or has errors."""
    try:
        found = parsed(text)
    except SlamlibError:
        return {}
    return found if isinstance(found, dict) else {}


class Entries:
    """The named values of plain data; where: what they belong to, for messages.

    Each method takes all the names that its value may have, the usual one first. All raise SlamlibError.
    """

    def __init__(self, data: Any, where: str = "") -> None:
        if not isinstance(data, dict):
            raise SlamlibError(f"{where or 'the file'} should have values by name, got {_shown(data)}")
        self.data, self._prefix = data, f"{where}." if where else ""
        self._asked: dict[str, str] = {}
        self._inner: list[Entries] = []

    def __contains__(self, name: str) -> bool:
        return any(alike(key) == alike(name) for key in self.data)

    def value(self, *names: str) -> Any:
        """The value of the names, as it is; None without. Refuses two of the names with different values."""
        return self._found(*names)[1]

    def _found(self, *names: str) -> tuple[str, Any]:
        """The name that is there, with its path, and its value; the usual name and None without."""
        self._asked |= {alike(name): name for name in reversed(names)}
        wanted = {alike(name) for name in names}
        found = {key: value for key, value in self.data.items() if alike(key) in wanted and value is not None}
        name, first = next(iter(found.items()), (names[0], None))
        if any(value is not first and value != first for value in found.values()):
            raise SlamlibError(f"{self._prefix}{' and '.join(found)} differ, and are names of one thing: delete one")
        return f"{self._prefix}{name}", first

    def numbers(self, *names: str, count: int | None = None, needed: bool = True) -> Numbers:
        """The numbers of a list, of its lists, or of a matrix with rows, cols and data; () if it is not needed."""
        name, value = self._found(*names)
        if value is None:
            if needed:
                raise SlamlibError(self._missing(names[0]))
            return ()
        found = tuple(_flat(value, name))
        if count is not None and len(found) != count:
            raise SlamlibError(f"{name} has {count} numbers, got {len(found)}")
        return found

    def number(self, *names: str, default: float | None = None) -> float:
        """One number; the default, if there is one, where it is missing."""
        if default is not None and self.value(*names) is None:
            return default
        return self.numbers(*names, count=1)[0]

    def word(self, *names: str, default: str = "") -> str:
        """A word as it is compared, or the default."""
        value = self.value(*names)
        return alike(default if value is None else str(value))

    def inside(self, *names: str) -> "Entries":
        """The named values in a value; none without."""
        value = self.value(*names)
        self._inner.append(Entries({} if value is None else value, f"{self._prefix}{names[0]}"))
        return self._inner[-1]

    def close(self, unused: Iterable[str]) -> None:
        """Refuse what holds numbers and nobody has asked for; unused: patterns of names, as compared, that may stay."""
        patterns = tuple(unused)
        for name in _left(self.data, patterns, self._asked):
            near = get_close_matches(alike(name), self._asked, n=1)
            hint = f"; did you mean {self._asked[near[0]]!r}?" if near else "."
            raise SlamlibError(
                f"{self._prefix}{name} is not known, and holds numbers{hint} Rename it if it belongs to the lens, and "
                "delete it if it does not"
            )
        for entries in self._inner:
            entries.close(patterns)

    def _missing(self, name: str) -> str:
        """The message on a name that is not there, with the nearest one that is."""
        there = [key for key in self.data if alike(key) not in self._asked]
        near = get_close_matches(name, there, n=1)
        hint = f"is {near[0]!r} meant for it?" if near else f"there is {', '.join(map(str, self.data)) or 'nothing'}"
        return f"{self._prefix}{name} is missing: {hint}"


def _flat(value: Any, name: str) -> Iterator[float]:
    """All numbers of nested lists, row by row. Raises SlamlibError for anything else."""
    if isinstance(value, dict) and "data" in value:
        value = value["data"]
    if isinstance(value, list | tuple):
        for inner in value:
            yield from _flat(inner, name)
    elif isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= float_info.max:
        yield float(value)
    else:
        raise SlamlibError(f"{name} should be of finite numbers, got {_shown(value)}")


def _left(data: dict[str, Any], unused: tuple[str, ...], asked: dict[str, str]) -> Iterator[str]:
    """Paths of names that hold numbers, and neither were asked for nor may stay."""
    for name, value in data.items():
        if alike(name) in asked or any(fnmatchcase(alike(name), pattern) for pattern in unused):
            continue
        if isinstance(value, dict) and "data" not in value:  # with it, it is a matrix
            yield from (f"{name}.{inner}" for inner in _left(value, unused, {}))
        elif _holds_numbers(value):
            yield name


def _holds_numbers(value: Any) -> bool:
    """Whether there is a number, or True, in a value; words that are numbers count as these."""
    if isinstance(value, list | tuple):
        return any(map(_holds_numbers, value))
    if isinstance(value, dict):
        return any(map(_holds_numbers, value.values()))
    if isinstance(value, str):
        words = re.split(r"[\s,;\[\]()]+", value.strip("[]() "))
        return all(isinstance(value_of(word), int | float) for word in words)
    return isinstance(value, int | float) and value is not False


def _shown(value: Any) -> str:
    """A value, shortened, for a message."""
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
