"""What a sensor measures of the landmarks of each family: the chain rule once, and one value for each family."""

from typing import Any

from slamlib.errors import UnknownNameError
from slamlib.modeling.registry import Registry
from slamlib.observation.family import Family

__all__ = ["FAMILIES", "Family", "family_of", "parametrization"]

FAMILIES = Registry(__name__, Family, "family")


def family_of(kind: Any) -> Family:
    """The family of a parametrization. Raises UnknownNameError."""
    for family in FAMILIES.values():
        if isinstance(kind, family.kinds):
            found: Family = family
            return found
    raise UnknownNameError.of("family of landmarks like", getattr(kind, "name", kind), FAMILIES)


def parametrization(name: str) -> Any:
    """The parametrization of a name, of whatever family: 'ahmPnt', 'plkLin', ... Raises UnknownNameError."""
    known = {kind: value for family in FAMILIES.values() for kind, value in family.parametrizations.items()}
    if name not in known:
        raise UnknownNameError.of("landmark", name, known)
    return known[name]
