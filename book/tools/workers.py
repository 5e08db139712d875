"""Do one thing for each of many, side by side, each worker with something of its own, such as a browser."""

import os
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import AbstractContextManager
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")
Worker = Callable[[], AbstractContextManager[Callable[[Item], Result]]]
WORKERS = min(2, os.cpu_count() or 1)


def each(worker: Worker[Item, Result], items: Sequence[Item]) -> Iterator[Result]:
    """Results in the order of the items, as soon as they and all before them are there; raises the first failure.

    `worker()` is entered once by each worker, in its own thread, and gives what to do with an item. A worker that
    cannot begin, or end, is a failure too: nothing is left undone in silence.
    """
    promised: list[Future[Result]] = [Future() for _ in items]
    waiting = deque(zip(items, promised, strict=True))
    with ThreadPoolExecutor(max_workers=WORKERS) as pool:
        running = [pool.submit(_work, worker, waiting) for _ in range(min(WORKERS, len(items)))]
        try:
            for promise in promised:
                yield promise.result()
            for one in running:
                one.result()
        finally:
            waiting.clear()  # after a failure nobody begins anything new


def _work(worker: Worker[Item, Result], waiting: "deque[tuple[Item, Future[Result]]]") -> None:
    """Take items as long as there are some; a worker that breaks down fails all that nobody has begun."""
    try:
        with worker() as action:
            while task := _next(waiting):
                try:
                    task[1].set_result(action(task[0]))
                except Exception as error:
                    task[1].set_exception(error)
    except BaseException as error:
        while task := _next(waiting):
            task[1].set_exception(error)
        raise


def _next(waiting: "deque[tuple[Item, Future[Result]]]") -> "tuple[Item, Future[Result]] | None":
    try:
        return waiting.popleft()
    except IndexError:
        return None
