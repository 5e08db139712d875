"""One update of the covariance, by the strategies found in books and code: how many times longer each takes.

A robot (6) and points (3 each) make n states; m points are seen, two numbers each. All strategies give the same
covariance (the benchmark checks it). Times are CPU times of one run with one BLAS thread, the least of many
repetitions; only their ratios mean anything elsewhere.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy loads: two threads only wait for each other here

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any
from unittest import mock

import numpy as np

from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.kalman import linalg

SIZES = ((100, 10), (300, 20), (600, 20), (1200, 20))


@dataclass(frozen=True)
class Problem:
    """A covariance P (n, n), and for each point seen: touched rows, Jacobian w.r.t. them (2, 9), noise (2, 2)."""

    P: Any
    touched: list[Any]
    jacobians: list[Any]
    R: Any

    @classmethod
    def random(cls, n: int, m: int) -> "Problem":
        """Points that were all seen from uncertain poses, so that everything is correlated."""
        rng = np.random.default_rng(n)
        root = rng.standard_normal((n, 6))
        touched = [np.r_[0:6, 6 + 3 * i : 9 + 3 * i] for i in range(m)]
        jacobians = [rng.standard_normal((2, 9)) for _ in range(m)]
        return cls(root @ root.T + np.eye(n), touched, jacobians, np.eye(2))

    def dense(self) -> Any:
        """The Jacobian of all points w.r.t. all states, with its zeros."""
        H = np.zeros((2 * len(self.touched), len(self.P)))
        for i, (touched, J) in enumerate(zip(self.touched, self.jacobians, strict=True)):
            H[2 * i : 2 * i + 2, touched] = J
        return H

    def belief(self) -> tuple[Belief, list[LinearizedMeasurement]]:
        """The same as a belief and its measurements."""
        belief, n = Belief(), len(self.P)
        cuts = [0, *range(6, n, 3), n]
        parts = [slice(a, b) for a, b in pairwise(cuts) if b > a]
        for at in parts:
            belief.add(at.stop - at.start, np.zeros(at.stop - at.start), 1)
        belief._P[...] = self.P  # a benchmark may set what a filter would reach after many steps
        blocks = belief.blocks
        seen = [
            LinearizedMeasurement([blocks[0], blocks[i + 1]], [J[:, :6], J[:, 6:]], np.zeros(2), self.R)
            for i, J in enumerate(self.jacobians)
        ]
        return belief, seen


def dense(problem: Problem) -> Callable[[], Any]:
    """(I - K H) P with full matrices, as in most teaching code."""
    P, H, R = problem.P, problem.dense(), np.eye(2 * len(problem.touched))

    def update() -> Any:
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        return (np.eye(len(P)) - K @ H) @ P

    return update


def one_by_one(problem: Problem) -> Callable[[], Any]:
    """One point after another, each with its touched rows and its own gain."""

    def update() -> Any:
        P = problem.P.copy()
        for touched, J in zip(problem.touched, problem.jacobians, strict=True):
            HP = J @ P[touched]
            P -= HP.T @ np.linalg.solve(HP[:, touched] @ J.T + problem.R, HP)
        return P

    return update


def scalar(problem: Problem) -> Callable[[], Any]:
    """One number after another: no matrix is inverted."""

    def update() -> Any:
        P = problem.P.copy()
        for touched, J in zip(problem.touched, problem.jacobians, strict=True):
            for h in J:
                hP = h @ P[touched]
                P -= np.outer(hP, hP / (hP[touched] @ h + 1))
        return P

    return update


def ours(problem: Problem) -> Callable[[], Any]:
    """The algebra of slamlib: touched rows, Cholesky, P -= W'W."""
    columns = np.unique(np.concatenate(problem.touched))
    H, R = problem.dense()[:, columns], np.eye(2 * len(problem.touched))

    def update() -> Any:
        P = problem.P.copy()
        HP = H @ P[columns]
        W = linalg.solve_lower(linalg.cholesky(HP[:, columns] @ H.T + R, "benchmark", "S"), HP)
        linalg.subtract_square(P, W)
        return P

    return update


def whole(problem: Problem) -> Callable[[], Any]:
    """Belief.update_all: with checks of every argument, stacking, and the means."""
    belief, seen = problem.belief()

    def update() -> Any:
        belief._P[...] = problem.P
        belief.update_all(seen)
        return belief.matrix

    return update


STRATEGIES: dict[str, Callable[[Problem], Callable[[], Any]]] = {
    "dense (I - K H) P": dense,
    "one point after another": one_by_one,
    "one number after another": scalar,
    "slamlib's algebra": ours,
    "Belief.update_all, whole": whole,
}


def quickest(function: Callable[[], Any], seconds: float) -> float:
    """Least CPU time of a call [s], over as many calls as fit, at least three."""
    times: list[float] = []
    end = time.process_time() + seconds
    while len(times) < 3 or time.process_time() < end:
        start = time.process_time_ns()
        function()
        times.append((time.process_time_ns() - start) / 1e9)
    return min(times)


def table(sizes: tuple[tuple[int, int], ...] = SIZES, seconds: float = 0.5) -> dict[str, list[float]]:
    """Seconds of each strategy at each size, with NumPy alone and with SciPy's BLAS where that makes a difference."""
    rows: dict[str, list[float]] = {}
    for n, m in sizes:
        problem = Problem.random(n, m)
        copying = quickest(problem.P.copy, seconds / 5)  # each strategy starts with a copy, which is not timed
        expected = dense(problem)()
        for name, strategy in STRATEGIES.items():
            for library in ("NumPy", "SciPy") if strategy in (ours, whole) else ("NumPy",):
                with mock.patch.object(linalg, "_scipy", linalg._scipy if library == "SciPy" else lambda *_: None):
                    update = strategy(problem)
                    assert np.allclose(update(), expected, rtol=0, atol=1e-8 * np.abs(problem.P).max())
                    least = quickest(update, seconds)
                label = f"{name}, {library}" if strategy in (ours, whole) else name
                rows.setdefault(label, []).append(least - (0 if strategy is dense else copying))
    return rows


def report(rows: dict[str, list[float]], sizes: tuple[tuple[int, int], ...] = SIZES) -> str:
    """The table as text: milliseconds of slamlib's algebra with NumPy, and how many times longer the others take."""
    base = "slamlib's algebra, NumPy"
    lines = ["states/points seen".ljust(34) + "".join(f"{f'{n}/{m}':>12}" for n, m in sizes)]
    for name, seconds in rows.items():
        cells = [f"{t / b:.2f} x" for t, b in zip(seconds, rows[base], strict=True)]
        if name == base:
            cells = [f"{t * 1e3:.3f} ms" for t in seconds]
        lines.append(name.ljust(34) + "".join(f"{cell:>12}" for cell in cells))
    return "\n".join(lines)


def size(text: str) -> tuple[int, int]:
    """States and points seen, from a text such as 300/20."""
    n, m = map(int, text.split("/"))
    if not 6 + 3 * m <= n:
        raise argparse.ArgumentTypeError(f"{m} points and a robot need {6 + 3 * m} states, not {n}")
    return n, m


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=0.5, help="CPU time spent on each figure (default 0.5)")
    parser.add_argument("--sizes", type=size, nargs="+", default=SIZES, help="states/points seen, such as 300/20")
    options = parser.parse_args()
    print(report(table(tuple(options.sizes), options.seconds), options.sizes))


if __name__ == "__main__":
    main()
