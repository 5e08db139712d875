"""The ids of landmarks: integers of any size, or strings; and arrays of them, in memory and in archives.

In memory they are of 64-bit integers where these hold them, else of Python's own integers and strings: NumPy would turn
a larger integer into a float, and one beside a string into a string, silently.
"""

import json
from collections.abc import Iterable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slamlib.errors import SlamlibError
from slamlib.manifolds import read_only

Id: TypeAlias = int | str
Ids: TypeAlias = NDArray[Any]


def ids_of(values: ArrayLike | Iterable[Id], what: str) -> Ids:
    """A read-only array (n,) of ids; errors call them `what`. Raises SlamlibError for anything but integers or strings.

    A masked array's masked ids are refused: which landmark is meant is not known.
    """
    if isinstance(values, np.ndarray) and values.dtype.kind == "i" and values.ndim == 1 and type(values) is np.ndarray:
        return read_only(np.array(values, np.int64))  # nearly always
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():
        raise SlamlibError(f"{what} hold masked ones: leave out what is not known")
    given = values.tolist() if isinstance(values, np.ndarray) else list(values) if np.iterable(values) else [values]
    if (isinstance(values, np.ndarray) and values.ndim != 1) or not np.iterable(values) or isinstance(values, str):
        raise SlamlibError(f"{what} are a list of integers or strings, not {type(values).__name__} of {values!r}")
    return array_of([_id(value, what) for value in given], what)


def _id(value: Any, what: str) -> Id:
    if isinstance(value, str):
        return str(value)
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        return int(value)
    advice = "ids.astype(int) makes them integers" if isinstance(value, float | np.floating) else "name things by them"
    raise SlamlibError(f"{what} are integers or strings, not {value} ({type(value).__name__}): {advice}")


def array_of(given: list[Id], what: str = "ids") -> Ids:
    """A read-only array (n,) of ids, which are of one kind."""
    if len({isinstance(value, str) for value in given}) > 1:
        raise SlamlibError(f"{what} are integers or strings, not some of each: make all of them strings")
    whole = _as_integers(given)
    if whole is not None:
        return read_only(whole)
    found = np.empty(len(given), dtype=object)
    found[:] = given
    return read_only(found)


def _as_integers(given: list[Id]) -> NDArray[Any] | None:
    """Ids as 64-bit integers; None where these do not hold them. "7" is a string: NumPy would make a number of it."""
    if any(isinstance(value, str) for value in given):
        return None
    try:
        return np.array(given, np.int64)
    except OverflowError:
        return None


def joined(parts: Iterable[Ids]) -> list[Id]:
    """The ids of several arrays, one after the other."""
    return [value for part in parts for value in part.tolist()]


def packed(given: Iterable[Id]) -> NDArray[Any]:
    """Ids as an array for an archive: of 64-bit integers, or of their JSON."""
    values = list(given)
    whole = _as_integers(values)
    return np.array([json.dumps(value) for value in values]) if whole is None else whole


def unpacked(array: NDArray[Any]) -> Ids:
    """The ids that `packed` made an array of."""
    return array if array.dtype.kind == "i" else array_of([json.loads(value) for value in array.tolist()])
