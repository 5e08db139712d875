"""Results of checks of a candidate: the properties that hold; for the others where they fail, and by how much."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Mask
from slamlib.models.numerical import scaled_differences


@dataclass(frozen=True)
class Finding:
    """One failure: the property, the definition and its argument, the arguments' values, and what was found there."""

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
    """Properties that a landmark or a sensor lacks; .findings has them one by one, each at its worst arguments."""

    def __init__(self, name: str, findings: list[Finding]) -> None:
        self.findings = findings
        count = "one property does" if len(findings) == 1 else f"{len(findings)} properties do"
        super().__init__("\n  ".join([f"{name}: {count} not hold.", *map(str, findings)]))

    def _render_traceback_(self) -> list[str]:
        """IPython's traceback: the message alone."""
        return f"CheckError: {self}".splitlines()


class Judge:
    """Collects the properties that hold, with the number of comparisons, and the worst failures of the others."""

    def __init__(self, name: str, seed: int = 0) -> None:
        self.name, self.rng = name, np.random.default_rng(seed)
        self.places: dict[str, int] = {}
        self.findings: dict[tuple[str, str, str], Finding] = {}

    def at(self, definition: str, **where: Array) -> "Case":
        """A definition with the values of its arguments, at which properties are checked."""
        return Case(self, definition, where)

    def lacks(self, *properties: str, definition: str = "") -> bool:
        """Whether one of the properties has been found not to hold, for one definition or for any."""
        return any(what in properties and definition in ("", of) for what, of, _ in self.findings)

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
            count = len(self.places)
            print(f"{self.name}:", f"all {count} properties hold." if count > 1 else "the property holds.")


@dataclass(frozen=True)
class Case:
    """A definition at values of its arguments; each method checks a property here, and returns whether it holds."""

    judge: Judge
    definition: str
    where: Mapping[str, Array]

    def hold(self, what: str) -> bool:
        """Record that a property holds here."""
        self.judge.places[what] = self.judge.places.get(what, 0) + 1
        return True

    def fail(self, what: str, how: str, argument: str = "", error: float = np.inf) -> bool:
        """Record that a property does not hold here; the worst failure is kept."""
        key = (what, self.definition, argument)
        if key not in self.judge.findings or self.judge.findings[key].error < error:
            rows = {n: " ".join(f"{x:.4g}" for x in np.asarray(v, float).ravel()) for n, v in self.where.items()}
            where = ", ".join(f"{name} = [{row}]" for name, row in rows.items())
            self.judge.findings[key] = Finding(what, self.definition, argument, where, how, error)
        return False

    def require(self, what: str, condition: bool | np.bool_ | Mask, how: str, argument: str = "") -> bool:
        """Check a condition; `how` describes the failure."""
        return self.hold(what) if condition else self.fail(what, how, argument)

    def compare(
        self, what: str, found: ArrayLike, wanted: ArrayLike, argument: str = "", tolerance: float | Array = 1e-9
    ) -> bool:
        """Check that two arrays agree, to `tolerance` of the largest wanted entry, absolutely if that is below one."""
        found, wanted = np.asarray(found), np.asarray(wanted)
        if found.shape != wanted.shape:
            return self.fail(what, f"has shape {found.shape}, should have {wanted.shape}", argument)
        errors = scaled_differences(found, wanted)
        if (errors <= tolerance).all():
            return self.hold(what)
        entry = np.unravel_index(int(np.argmax(errors / tolerance)), errors.shape)
        at = f"entry {[int(i) for i in entry]} is" if entry else "is"
        return self.fail(what, f"{at} {found[entry]:.6g}, should be {wanted[entry]:.6g}", argument, errors.max())
