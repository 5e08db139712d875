"""Checks of the measurement update: (3.1) to (3.14), (5.27), (5.31), (5.32), chapter 6."""

import timeit
from functools import partial
from math import inf

import numpy as np

from slambook.report import observation, updates
from slambook.report.filter import BatchUpdateFilter, Memory
from slambook.report.findings import AuditFigure, Findings, at_least, at_most, check, near, ran, statistics
from slambook.report.observation import by_vectors
from slambook.report.switches import equations
from slamlib.manifolds import Array


def _problem(landmarks: int, seen: int, seed: int, full: bool = False) -> tuple[Array, Array, list[int], Array, Array]:
    """A state, its covariance, which landmarks are seen where, and R."""
    rng = np.random.default_rng(seed)
    n = 6 + 3 * landmarks
    x = np.concatenate([rng.uniform(-0.3, 0.3, 6), rng.uniform(-8, 8, 3 * landmarks)])
    root = rng.standard_normal((n, n)) * np.where(np.arange(n) < 6, 0.02, 0.2)[:, None] / np.sqrt(n)
    noise = rng.standard_normal((3, 3)) * 0.05
    R = noise @ noise.T + 1e-4 * np.eye(3) if full else np.diag([0.0025, 0.002, 0.003])
    names = list(map(int, rng.permutation(landmarks)[:seen]))
    P = root @ root.T
    truth = x + root @ rng.standard_normal(n)
    relative = by_vectors(truth[:6], truth[6:].reshape(-1, 3)[names])
    z = relative + rng.standard_normal((seen, 3)) @ np.linalg.cholesky(R).T
    return x, P, names, z, R


def _updated(
    make: type[Memory], x: Array, P: Array, names: list[int], z: Array, R: Array, *errors: str
) -> tuple[Array, Array]:
    filter = make(x[None].copy(), P[None].copy(), list(range((len(x) - 6) // 3)), equations(*errors))
    filter.update(z[None], names, R)
    return filter.x[0], filter.P[0]


def _whole(x: Array, P: Array, names: list[int], z: Array, R: Array) -> tuple[Array, Array]:
    """(3.10) to (3.14) with whole matrices."""
    return updates.naive(updates.observe(x, P, np.array(names), z, np.broadcast_to(np.diag(R), z.shape)))()


def _mistakes(full: bool, *errors: str) -> tuple[Array, Array]:
    """Of 300 problems: size of the error relative to the correct update, and smallest eigenvalue of P."""
    off, least = [], []
    for seed in range(300):
        problem = _problem(6, 4, seed, full)
        right, (x, P) = _updated(BatchUpdateFilter, *problem), _updated(Memory, *problem, *errors)
        off.append(np.linalg.norm(x - right[0]) / np.linalg.norm(right[0] - problem[0]))
        least.append(np.linalg.eigvalsh(P)[0])
    return np.array(off), np.array(least)


@check("E16", "(5.31)-(5.32)", "every scalar step from the prediction", "innovation, gain and covariance run along")
def running() -> Findings:
    right, stale, least = _mistakes(False)[0], _mistakes(False, "E16")[0], _mistakes(False, "E16 literal")[1]
    run, wild, ok = ran("gentle", "E16"), ran("gentle", "E16 literal"), ran("gentle")
    finite = wild.claimed[np.isfinite(wild.claimed)]
    size = np.abs(finite).max() if finite.size == wild.claimed.size else inf
    low, high = np.quantile(stale, (0.05, 0.95))
    yield at_most("corrected minus batch, relative, worst of 300", right.max(), 1e-8)
    yield at_least("old innovation: state off, median of 300", float(np.median(stale)), 0.3)
    yield at_least("everything old: share of indefinite P", float((least < 0).mean()), 0.9)
    yield at_least("old innovation: error of the position, gentle [m]", run.position, 1)
    yield at_least("old innovation: error of the attitude [deg]", run.rotation, 45)
    yield at_least("everything old: variance, largest, size", size, 1e20)
    yield f"{statistics(('old innovation', run), ('right', ok))}; of 300 problems 5 to 95 %: {low:.0%} to {high:.0%}"


@check("E17", "(5.27)-(5.32)", "scalar steps with R_jj", "only for diagonal R; otherwise whiten first")
def whitening() -> Findings:
    white, diagonal = _mistakes(True)[0], _mistakes(True, "E17")[0]
    run, right = ran("rig", "E17"), ran("rig")
    low, high = np.quantile(diagonal, (0.05, 0.95))
    yield at_most("whitened minus batch, relative, worst of 300", white.max(), 1e-8)
    yield at_least("R_jj: state off, median of 300", float(np.median(diagonal)), 0.05)
    yield at_least("stereo: error of the position over the right one", run.position / right.position, 2)
    yield at_least("stereo: error of the attitude over the right one", run.rotation / right.rotation, 2)
    yield near("stereo, whitened: NEES/6", right.ratio, 1.0, 0.25)
    yield f"{statistics(('stereo', run), ('right', right))}; of 300 problems 5 to 95 %: {low:.1%} to {high:.0%}"


@check(
    "E24", "3.1.1", "S is the 'Kalman innovation'; F twice since the covariance is 'quadratic'", "cov of y; cov of Fx"
)
def linear() -> Findings:
    off = 0.0
    for seed in range(100):
        rng = np.random.default_rng(seed)
        a, H, b = rng.standard_normal((4, 4)), rng.standard_normal((2, 4)), rng.standard_normal((2, 2))
        P, R = a @ a.T, b @ b.T + np.eye(2)
        found = observation.batch(np.zeros(4), P, np.ones(2), H, R)[1]
        off = max(off, float(np.abs(found - np.linalg.inv(np.linalg.inv(P) + H.T @ np.linalg.inv(R) @ H)).max()))
    yield at_most("(3.5), (3.7) minus least squares, 100 problems", off, 1e-9)
    yield at_least("single precision, 300 corrections: least over largest eigenvalue", _single(), -1e-5)
    yield "read: 3.1.1, 'what we call the Kalman innovation' of (3.4), 'because the covariance is a quadratic matrix'"


def _single() -> float:
    rng = np.random.default_rng(24)
    P: Array = np.diag(np.array([1e4, 1e2, 1, 1e-2], dtype=np.float32))
    for _ in range(300):
        H = rng.standard_normal((2, 4)).astype(np.float32)
        S = H @ P @ H.T + np.eye(2, dtype=np.float32)
        P = (np.eye(4, dtype=np.float32) - P @ H.T @ np.linalg.inv(S) @ H) @ P
    values = np.linalg.eigvalsh((P + P.T) / 2)
    return float(values[0] / values[-1])


@check(
    "E25",
    "6",
    "number by number 'the average landmark error is smaller'",
    "equal in exact arithmetic; only time differs",
)
def speed() -> Findings:
    problem = _problem(100, 20, 25)
    (x, P), (xb, Pb) = _updated(Memory, *problem), _whole(*problem)
    times = {(L, m): _seconds(L, m) for L, m in ((100, 20), (300, 40), (100, 100))}
    told = ", ".join(f"L={L}, m={m}: {1e3 * a:.0f} / {1e3 * b:.0f}" for (L, m), (a, b) in times.items())
    one, whole = times[100, 20]
    n, k = 306, 60  # rows of the state, and numbers measured
    counted = (2 * k * n * n + k * k * n + k**3 + n * k * k + n**3) / (k * (n * n + 11 * n))
    machine = "in NumPy a loop of Python stands against a library's products"
    moved = np.abs(xb - problem[0]).max()
    yield at_most("state, scalar minus whole matrices, relative", np.abs(x - xb).max() / moved, 1e-9)
    yield at_most("covariance, the same", np.abs(P - Pb).max() / np.abs(problem[1]).max(), 1e-9)
    yield near("multiplications, whole matrices over scalar, L = 100, m = 20", counted, 7.27, 0.05)
    yield AuditFigure("time, scalar over whole matrices, L = 100, m = 20", one / whole, -inf, inf, machine)
    yield f"times of this machine [ms], scalar / whole matrices: {told}"


def _seconds(landmarks: int, seen: int) -> list[float]:
    problem = _problem(landmarks, seen, 25)
    ways = partial(_updated, Memory, *problem), partial(_whole, *problem)
    return [min(timeit.repeat(way, number=1, repeat=3)) for way in ways]
