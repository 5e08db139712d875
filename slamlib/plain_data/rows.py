"""Rows of words in plain text: what separates them, and the decimal comma, which no separator is."""

import re

from slamlib.errors import SlamlibError

_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(?:[eE][-+]?\d+)?")


def decimal_comma(text: str) -> str | None:
    """The first number of a row that is written with a decimal comma, as "0,5 1,5" or "0,5;1,5"; None without.

    A comma with a blank beside it separates, and so do those of a row that nothing else separates.
    """
    pieces = re.split(r"[;\s]+", text.strip())
    if len(pieces) < 2 or re.search(r",\s|\s,", text):
        return None
    return next((piece for piece in pieces if _DECIMAL_COMMA.fullmatch(piece)), None)


def words(text: str, where: str) -> list[str]:
    """The words of a row, between commas, semicolons or blanks; a separator at its end is none.

    where: the row, for messages. Raises SlamlibError for a decimal comma.
    """
    if found := decimal_comma(text):
        raise SlamlibError(f"{where}: {with_a_point(found)}")
    found_words = re.split(r"\s*[,;]\s*|\s+", text.strip())
    return found_words[:-1] if len(found_words) > 1 and not found_words[-1] else found_words


def with_a_point(number: str) -> str:
    """What to do about a number with a decimal comma."""
    return f"{number} has a decimal comma: write numbers with points, as {number.replace(',', '.')}"
