"""What is found out about a candidate: which properties hold, and for those that do not where and by how much."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong: the property, the definition and its argument, the place, what was found there."""

    what: str
    definition: str
    argument: str
    where: str
    how_much: str
    error: float

    def __str__(self) -> str:
        argument = f", argument '{self.argument}'" if self.argument else ""
        place = f"\n      at {self.where}" if self.where else ""
        return f"{self.definition}{argument}: {self.what}\n      {self.how_much}{place}"


class CheckError(SlamlibError):
    """Properties that a landmark or a sensor lacks; .findings has them one by one, each at its worst place."""

    def __init__(self, name: str, findings: list[Finding]) -> None:
        self.findings = findings
        count = "one property does" if len(findings) == 1 else f"{len(findings)} properties do"
        super().__init__("\n  ".join([f"{name}: {count} not hold.", *map(str, findings)]))

    def _render_traceback_(self) -> list[str]:
        """What IPython shows: what is wrong, not how the checks are built."""
        return f"CheckError: {self}".splitlines()


class Judge:
    """Collects the properties that hold, with the number of places, and those that do not, each at its worst."""

    def __init__(self, name: str, seed: int = 0) -> None:
        self.name, self.rng = name, np.random.default_rng(seed)
        self.places: dict[str, int] = {}
        self.findings: dict[tuple[str, str, str], Finding] = {}

    def compare(
        self,
        what: str,
        definition: str,
        found: Any,
        wanted: Any,
        where: Mapping[str, Array],
        *,
        argument: str = "",
        tolerance: float = 1e-9,
    ) -> bool:
        """Two arrays agree, to `tolerance` of the largest wanted entry, absolutely where that is below one."""
        found, wanted = np.asarray(found), np.asarray(wanted)
        if found.shape != wanted.shape:
            how = f"has shape {found.shape}, should have {wanted.shape}"
            return self.fail(what, definition, how, where, argument=argument, error=np.inf)
        scale = max(1.0, float(np.max(np.abs(wanted), initial=0)))
        errors = np.abs(found - wanted) / scale
        errors = np.where(np.isfinite(errors), errors, np.inf)
        worst = float(errors.max(initial=0))
        if worst <= tolerance:
            return self.hold(what)
        entry = np.unravel_index(int(np.argmax(errors)), errors.shape)
        at = f"entry {[int(i) for i in entry]} is" if entry else "is"
        how = f"{at} {found[entry]:.6g}, should be {wanted[entry]:.6g}"
        return self.fail(what, definition, how, where, argument=argument, error=worst)

    def require(
        self, what: str, definition: str, condition: Any, how: str, where: Mapping[str, Array], *, argument: str = ""
    ) -> bool:
        """A condition holds; `how` says what is wrong if not."""
        if condition:
            return self.hold(what)
        return self.fail(what, definition, how, where, argument=argument, error=np.inf)

    def hold(self, what: str) -> bool:
        """Note a place where a property holds."""
        self.places[what] = self.places.get(what, 0) + 1
        return True

    def fail(
        self,
        what: str,
        definition: str,
        how: str,
        where: Mapping[str, Array],
        *,
        argument: str = "",
        error: float = np.inf,
    ) -> bool:
        """Note a place where a property does not hold; the worst is kept."""
        key = (what, definition, argument)
        if key not in self.findings or self.findings[key].error < error:
            self.findings[key] = Finding(what, definition, argument, shown(where), how, error)
        return False

    def conclude(self, silent: bool) -> None:
        """Print what holds; raise CheckError if anything does not."""
        failed = {what for what, *_ in self.findings}
        if not silent:
            for what, places in self.places.items():
                if what not in failed:
                    print(f"  holds: {what} ({places} comparisons)" if places > 1 else f"  holds: {what}")
        if self.findings:
            raise CheckError(self.name, list(self.findings.values()))
        if not silent:
            print(
                f"{self.name}:", f"all {n} properties hold." if (n := len(self.places)) > 1 else "the property holds."
            )


def shown(where: Mapping[str, Array]) -> str:
    """A place in words: 'pose = [0 0 0 1 0 0 0], point = [...]'."""
    parts = []
    for name, value in where.items():
        numbers = [f"{x:.4g}" for x in np.asarray(value, dtype=float).ravel()]
        parts.append(f"{name} = [{' '.join(numbers)}]")
    return ", ".join(parts)
