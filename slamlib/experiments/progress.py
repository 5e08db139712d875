"""A progress bar for long work: on a terminal only, so that logs and pipes stay clean."""

import sys
import time
from collections.abc import Iterable, Iterator
from typing import TextIO, TypeVar

T = TypeVar("T")
WIDTH, EVERY = 30, 0.1  # characters of the bar; seconds between two drawings


def progress(items: Iterable[T], total: int, label: str, stream: TextIO | None = None) -> Iterator[T]:
    """Yield the items with a bar of how many of `total` are done, how fast, and the remaining time."""
    out = sys.stderr if stream is None else stream
    if not out.isatty():
        yield from items
        return
    began = drawn = time.monotonic()
    done = 0
    try:
        for item in items:
            yield item
            done += 1
            now = time.monotonic()
            if now - drawn >= EVERY:
                drawn = now
                _draw(out, label, done, total, now - began)
    finally:
        _draw(out, label, done, total, time.monotonic() - began)
        out.write("\n")


def _draw(out: TextIO, label: str, done: int, total: int, seconds: float) -> None:
    share = min(done / total, 1.0) if total else 1.0
    bar = "#" * round(share * WIDTH)
    rate = done / seconds if seconds > 0 else 0.0
    left = f", {(total - done) / rate:.0f} s left" if rate and done < total else ""
    out.write(f"\r{label} [{bar:-<{WIDTH}}] {done}/{total}, {rate:.0f}/s{left}   ")
    out.flush()
