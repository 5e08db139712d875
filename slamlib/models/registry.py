"""Types are values found by walking a folder: a new landmark, sensor or motion is one new file."""

import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, fields
from functools import cached_property
from types import ModuleType
from typing import Any

from slamlib.errors import SlamlibError, entry
from slamlib.manifolds import Manifold
from slamlib.models.formula import Formula, Model

ANY = "__class__", "see its help"
PARTS: Any = {  # by type or name: what it must have, and what it should be
    **dict.fromkeys((Formula, Model, Model | None), ("jac", "a function under @model(...)")),
    Manifold: ("dof", "a manifold, such as as_manifold(7)"),
    "moved": ("jac_where", "a function under @model(motion=Pose, ...), or Parts(...)"),
    "check": ("__call__", "a function; see its help"),
    **dict.fromkeys(("limits", "angles"), ("__iter__", "a tuple; see its help")),
}


class TypeDescription:
    """A dataclass that describes a type, of a landmark, a sensor or a motion: no part of it may be missing or wrong."""

    def __post_init__(self) -> None:
        """Raise SlamlibError that names all parts which are missing or wrong, and what they should be."""
        asked = [f for f in fields(self) if f.default is MISSING or getattr(self, f.name) is not None]  # type: ignore[arg-type]
        parts = [(getattr(self, f.name), f.name, *(PARTS.get(f.name) or PARTS.get(f.type, ANY))) for f in asked]
        lacking = [f"\n  {name}: {what}" for v, name, call, what in parts if v is None or not hasattr(v, call)]
        if lacking:
            raise SlamlibError(f"{type(self).__name__} {self.name!r} is unfinished; it lacks{''.join(lacking)}")  # type: ignore[attr-defined]


def modules_of(package: str) -> Iterator[ModuleType]:
    """The modules in a package's folder, imported one after the other, in the order of their names."""
    for info in pkgutil.iter_modules(importlib.import_module(package).__path__):
        yield importlib.import_module(f"{package}.{info.name}")


class Registry(Mapping[str, Any]):
    """The values of one kind among the modules of a package, by their names; the folder is walked at first use."""

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
