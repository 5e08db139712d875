"""What the audit finds for each number of the list of errata: figures with their tolerances, or what was read."""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from math import inf

import numpy as np

from slambook.report.filter import OF_THE_UPDATE, BatchUpdateFilter, Memory
from slambook.report.runs import DOF, Outcome, monte_carlo
from slambook.report.scenes import SCENES
from slambook.report.switches import SWITCHES, equations
from slamlib.evaluation.consistency import band

RUNS, SEED = 20, 0


@dataclass(frozen=True)
class AuditFigure:
    """One number: what it is, its value, the limits it must lie in, and a remark on how it is meant."""

    what: str
    measured: float
    low: float
    high: float
    remark: str = ""

    @property
    def holds(self) -> bool:
        """True if the figure lies within its limits."""
        return self.low <= self.measured <= self.high

    @property
    def tolerance(self) -> str:
        """The limits in words."""
        if self.high == inf:
            return "not judged" if self.low == -inf else f"at least {self.low:.4g}"
        return f"at most {self.high:.2g}" if self.low == -inf else f"{self.low:.4g} to {self.high:.4g}"


def near(what: str, measured: float, expected: float, tolerance: float, *, remark: str = "") -> AuditFigure:
    """A figure that must come out within the tolerance."""
    return AuditFigure(what, float(measured), float(expected - tolerance), float(expected + tolerance), remark)


def at_least(what: str, measured: float, least: float) -> AuditFigure:
    """An effect that must be this large."""
    return AuditFigure(what, float(measured), float(least), inf)


def at_most(what: str, measured: float, most: float) -> AuditFigure:
    """Something that must vanish, up to rounding."""
    return AuditFigure(what, float(measured), -inf, float(most))


Findings = Iterator[AuditFigure | str]  # figures; and words: the statistics of its runs, or what was read and where


@dataclass(frozen=True)
class AuditFinding:
    """Result of a check: its figures, the remarks beside them, and the time taken."""

    check: "AuditCheck"
    figures: list[AuditFigure]
    note: str
    seconds: float

    @property
    def holds(self) -> bool:
        """True unless a figure is outside its limits."""
        return all(f.holds for f in self.figures)

    @property
    def verdict(self) -> str:
        """FAILED, read (no figures), or computed."""
        if not self.holds:
            return "FAILED"
        return "computed" if self.figures else "read"


@dataclass(frozen=True)
class AuditCheck:
    """One number of the list: what the report states and where, what is right, and the function that checks it."""

    number: str
    where: str
    says: str
    right: str
    find: Callable[[], Findings]

    def run(self) -> AuditFinding:
        """Run the check."""
        began = time.perf_counter()
        found = list(self.find())
        figures = [part for part in found if isinstance(part, AuditFigure)]
        note = "; ".join(part for part in found if isinstance(part, str))
        return AuditFinding(self, figures, note, time.perf_counter() - began)


CHECKS: dict[str, AuditCheck] = {}


def check(number: str, where: str, says: str, right: str) -> Callable[[Callable[[], Findings]], Callable[[], Findings]]:
    """Put a function into the table of checks."""

    def register(find: Callable[[], Findings]) -> Callable[[], Findings]:
        CHECKS[number] = AuditCheck(number, where, says, right, find)
        return find

    return register


@cache
def ran(scene: str, *errors: str) -> Outcome:
    """The runs of a scene by name with these errors, made once.

    Number by number only where an error is one of the update's: elsewhere one update a picture is the same (E25).
    """
    make = Memory if any(OF_THE_UPDATE & {*SWITCHES[name].wrong} for name in errors) else BatchUpdateFilter
    return monte_carlo(SCENES[scene](), *errors, runs=RUNS, seed=SEED, make=make)


def statistics(*outcomes: tuple[str, Outcome]) -> str:
    """Description of runs, and the share of their steps inside the band."""
    low, high = band(DOF, RUNS)
    shares = ", ".join(f"{name} {o.inside:.0%}" for name, o in outcomes)
    return f"{RUNS} runs, {DOF} dof, 95 % band [{low:.2f}, {high:.2f}]; steps inside: {shares}"


def refused(error: str) -> float:
    """1.0 if the step cannot be computed as printed, because the shapes do not fit."""
    filter = Memory(np.zeros((1, 6)), np.zeros((1, 6, 6)), use=equations(error))
    seen = np.random.default_rng(9).uniform(1, 5, (1, 4, 3))
    try:
        filter.initialize(seen, [0, 1, 2, 3], np.eye(3))
        filter.predict(np.zeros((1, 6)), np.eye(6))
        filter.update(seen, [0, 1, 2, 3], np.eye(3))
        filter.initialize(seen[:, :1], [4], np.eye(3))
    except ValueError:
        return 1.0
    return 0.0
