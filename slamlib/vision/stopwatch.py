"""Seconds spent, by what they were spent on."""

import time
from collections.abc import Iterator
from contextlib import contextmanager


class Stopwatch(dict[str, float]):
    """A dictionary of seconds by part, to which `timed` adds."""

    def __init__(self, *parts: str) -> None:
        super().__init__(dict.fromkeys(parts, 0.0))

    @contextmanager
    def timed(self, part: str) -> Iterator[None]:
        """Count the time of a `with` block to a part."""
        began = time.perf_counter()
        yield
        self[part] += time.perf_counter() - began
