"""Measurement models of landmarks: the chain rule of Jacobians, and one module for each family of landmarks."""

from slamlib.errors import entry
from slamlib.landmarks.parametrization import Parametrization
from slamlib.observation.family import Family
from slamlib.registry import Registry

__all__ = ["FAMILIES", "Family", "parametrization"]

FAMILIES = Registry(__name__, Family, "family")


def parametrization(name: str) -> Parametrization:
    """The parametrization of this name, of any family: 'ahmPnt', 'plkLin', ... Raises UnknownNameError."""
    known = {kind: value for family in FAMILIES.values() for kind, value in family.parametrizations.items()}
    return entry("landmark", name, known)
