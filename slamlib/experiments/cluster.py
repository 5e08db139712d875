"""Runs on a Dask cluster: each is a task, and what it finds comes back as soon as it is there; workers write no file.

Tasks are handed to Dask itself. joblib's Dask backend was tried first: it keeps an argument of more than 1 kB on one
worker, with whose death all other runs are cancelled; and a run that Dask has given up is cancelled for no reason that
it states.
"""

import logging
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from math import inf
from pkgutil import resolve_name
from queue import Empty, SimpleQueue
from typing import Any, TypeVar

from slamlib import __version__
from slamlib.errors import SlamlibError, optional

T = TypeVar("T")


def on_cluster(function: Callable[[int], T], seeds: Sequence[int], scheduler: object, wait: float) -> Iterator[T]:
    """Yield function(seed) of each seed, as they finish, from the workers of a Dask scheduler.

    scheduler: its address, or a Dask cluster. wait [s]: at most, for the scheduler, for a first worker, and for another
    one if all have gone. A run whose worker dies is made by another one. When the generator is closed, the runs that
    have not started are taken back. Raises SlamlibError.
    """
    distributed = optional("distributed", "for runs on a Dask cluster", "cluster")
    if not 0 < wait < inf:
        raise SlamlibError(f"the time to wait for a cluster is a number of seconds above 0, got {wait}")
    with _connected(distributed, scheduler, wait) as client:
        _wait_for_worker(client, scheduler, wait)
        _check_workers(client)
        done: SimpleQueue[Any] = SimpleQueue()
        task = partial(_call, __version__, function)  # scattered, it could be lost with the worker that keeps it
        left = dict(zip(client.map(task, seeds, pure=False), seeds, strict=True))
        for future in left:
            future.add_done_callback(done.put)
        while left:
            try:
                future = done.get(timeout=wait)
            except Empty:
                _wait_for_worker(client, scheduler, wait)
                continue
            try:
                found = future.result(timeout=wait)
            except TimeoutError:
                if future.status == "error":  # its own
                    raise
                _wait_for_worker(client, scheduler, wait)
                future.add_done_callback(done.put)  # its worker died with the result, and it is made again
                continue
            except distributed.KilledWorker as error:
                raise SlamlibError(
                    f"the run of seed {left[future]} was given up: {error.allowed_failures + 1} workers died of it, "
                    "one after the other (often of too little memory: their logs say more)"
                ) from None
            except distributed.CancelledError:
                raise SlamlibError(f"the Dask scheduler {scheduler} has gone, and the runs with it") from None
            except SlamlibError:
                raise
            except Exception:
                _check_workers(client)  # one that came later may have no slamlib
                raise
            del left[future]
            yield found


@contextmanager
def _connected(distributed: Any, scheduler: object, wait: float) -> Iterator[Any]:
    """A client of the scheduler; closed, it takes its tasks back. What it would log is said by errors."""
    try:
        distributed.comm.get_address_host_port(getattr(scheduler, "scheduler_address", scheduler), strict=True)
    except ValueError as error:  # which a client would raise too late to be closed
        raise SlamlibError(f"{scheduler} is no address of a Dask scheduler, such as tcp://host:8786: {error}") from None
    log = logging.getLogger("distributed.client")
    level = log.level
    log.setLevel(logging.CRITICAL)
    try:
        try:
            client = distributed.Client(scheduler, timeout=wait, set_as_default=False)
        except OSError as error:
            raise SlamlibError(
                f"no Dask scheduler answers at {scheduler} within {wait:g} s: start one there with 'dask scheduler', "
                f"or wait longer ({error})"
            ) from None
        with client:
            yield client
    finally:
        log.setLevel(level)


def _wait_for_worker(client: Any, scheduler: object, wait: float) -> None:
    """Raise SlamlibError if there is no worker, and none comes in time."""
    try:
        client.wait_for_workers(1, timeout=wait)
    except TimeoutError:
        raise SlamlibError(
            f"the Dask scheduler {scheduler} has no worker, and none came within {wait:g} s: start some with 'dask "
            f"worker {scheduler} --nthreads 1', or wait longer"
        ) from None


def _check_workers(client: Any) -> None:
    """Raise SlamlibError for a worker that has no slamlib, or another version of it."""
    for address, found in client.run(resolve_name, "slamlib:__version__", on_error="return").items():
        if found != __version__ and not isinstance(found, OSError):  # which is that of a worker that is leaving
            raise _differs(f"the worker {address}", found)


def _call(version: str, function: Callable[[int], T], seed: int) -> T:
    """Call the function on a worker, which may have come after those that were checked."""
    if version != __version__:
        raise _differs("a worker", __version__)
    return function(seed)


def _differs(worker: str, found: object) -> SlamlibError:
    return SlamlibError(
        f"{worker} has another slamlib than the caller's {__version__} ({found}): install the same wheel on every "
        "worker's machine, with its extra cluster, and start the workers again"
    )
