"""What all checks of stored results share: how near a number that is computed again must be to the stored one."""

import math
from collections.abc import Iterator
from typing import Any

import pytest

from book.experiments import stored


def comes_out_again(found: Any, kept: Any, renew: str, *, digits: int = 4, places: int = 12, share: float = 0) -> None:
    """What is computed now is what is stored, else the test fails; renew: the words that say how to store it anew.

    Numbers may be apart by one unit of so many significant digits, or of so many decimal places, whichever is more:
    half of it is the rounding of the file, the rest is for other machines. share: of a number by which it may be off,
    where a machine decides more than that; a test that needs it says why. All else must be equal.
    """
    __tracebackhide__ = True
    apart = list(_apart(stored.plain(found, 15), kept, (digits, places, share), "at"))
    if apart:
        pytest.fail("\n".join([f"{len(apart)} differences from the stored file: {renew}", *apart[:10]]))


def _apart(found: Any, kept: Any, near: tuple[int, int, float], at: str) -> Iterator[str]:
    if isinstance(found, dict) and isinstance(kept, dict) and set(found) == set(kept):
        for name in kept:
            yield from _apart(found[name], kept[name], near, f"{at} {name!r}")
    elif isinstance(found, list) and isinstance(kept, list) and len(found) == len(kept):
        for i, pair in enumerate(zip(found, kept, strict=True)):
            yield from _apart(*pair, near, f"{at} [{i}]")
    elif _number(found) and _number(kept):
        digits, places, share = near
        unit = 10.0 ** (math.floor(math.log10(abs(kept))) + 1 - digits) if kept else 0.0
        allowed = max(unit, 10.0**-places, share * abs(kept))
        if not abs(found - kept) <= 1.001 * allowed:  # one unit of what is rounded may be a little more
            yield f"{at}: {found} now, {kept} stored"
    elif type(found) is not type(kept) or found != kept:
        yield f"{at}: {found!r} now, {kept!r} stored"


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
