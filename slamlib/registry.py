"""Types are values found by walking a folder: a new landmark, sensor or motion is one new file."""

import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, Field, fields
from functools import cached_property
from types import ModuleType
from typing import Any, NamedTuple, Protocol

from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Array, Manifold
from slamlib.models import Formula, Jacobians, Model
from slamlib.models.in_memory import Generated


class Wanted(NamedTuple):
    """What a part of a type must have, by which it is known, and what it should be, in words."""

    attribute: str
    words: str


MODEL = Wanted("jac", "a function under @model(...)")
TUPLE = Wanted("__iter__", "a tuple; see its help")
BY_TYPE: dict[Any, Wanted] = {  # of a field's declared type
    Formula: MODEL,
    Model: MODEL,
    Model | None: MODEL,
    Manifold: Wanted("dof", "a manifold, such as as_manifold(7)"),
}
BY_NAME = {  # of fields whose declared type says less
    "moved": Wanted("jac_where", "a function under @model(motion=Pose, ...), or Parts(...)"),
    "check": Wanted("__call__", "a function; see its help"),
    "limits": TUPLE,
    "angles": TUPLE,
}


class Moved(Protocol):
    """moved(motion, state), how a state moves with the world: a Model, or Parts of several."""

    def __call__(self, motion: Array, state: Array, /) -> Array: ...

    def jac_where(self, motion: Array, state: Array, /) -> Array: ...

    def entries_where(self, motion: Array, /) -> Generated: ...

    def jac(self, motion: Array, state: Array, /) -> tuple[Array, Jacobians]: ...

    def __hash__(self) -> int: ...


class TypeDescription:
    """A dataclass that describes a type, of a landmark, a sensor or a motion: no part of it may be missing or wrong."""

    name: str

    def __post_init__(self) -> None:
        """Raise SlamlibError that names all parts which are missing or wrong, and what they should be."""
        parts = [(part, getattr(self, part.name)) for part in fields(self)]  # type: ignore[arg-type]
        required = [(part, value) for part, value in parts if part.default is MISSING or value is not None]
        lacking = [f"\n  {part.name}: {words}" for part, value in required if (words := _lacking(part, value))]
        if lacking:
            raise SlamlibError(f"{type(self).__name__} {self.name!r} is unfinished; it lacks{''.join(lacking)}")


def _lacking(part: Field[Any], value: object) -> str | None:
    """What a part of a type should be, if its value is missing or something else."""
    wanted = BY_NAME.get(part.name) or BY_TYPE.get(part.type)
    if wanted is None:
        return "see its help" if value is None else None
    return None if hasattr(value, wanted.attribute) else wanted.words


def modules_of(package: str) -> Iterator[ModuleType]:
    """The modules in a package's folder, imported one after the other, in the order of their names."""
    for info in pkgutil.iter_modules(importlib.import_module(package).__path__):
        yield importlib.import_module(f"{package}.{info.name}")


class Registry(Mapping[str, Any]):
    """The values of one kind among the modules of a package, by their names; the folder is walked at first use.

    POINTS and LINES have the parametrizations of landmarks, SENSORS the types of sensors, MOTIONS the motion models. A
    type of one's own is added with `add`. Raises UnknownNameError for a name that is not there, with the nearest one.

        >>> import slamlib as sl
        >>> sorted(sl.MOTIONS)[:2], sl.MOTIONS["constVel"].manifold.dof
        (['constVel', 'odometry'], 12)
        >>> sl.POINTS["idpPnt"].manifold.size, sl.LINES["plkLin"].manifold.size, sl.SENSORS["stereo"].parameters
        (6, 6, ('intrinsics', 'baseline'))
    """

    def __init__(self, package: str, kind: type, what: str) -> None:
        self.package, self.kind, self.what = package, kind, what

    @cached_property
    def _values(self) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for module in modules_of(self.package):
            for value in vars(module).values():
                if isinstance(value, self.kind):
                    name = value.name  # type: ignore[attr-defined]
                    if found.setdefault(name, value) is not value:
                        raise SlamlibError(f"two {self.what}s are called {name!r}: give each a name of its own")
        return found

    def add(self, value: Any) -> None:
        """Add a value of one's own, which no file holds; one that has its name makes room."""
        self._values[value.name] = value

    def __getitem__(self, name: str) -> Any:
        return entry(self.what, name, self._values)

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def get(self, name: str, default: Any = None) -> Any:
        """The value of this name, or `default`."""
        return self._values.get(name, default)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)
