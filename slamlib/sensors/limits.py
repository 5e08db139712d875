"""The limits of a calibration: known names, numbers that make sense."""

from typing import Any

import numpy as np

from slamlib.errors import SlamlibError, UnknownNameError


def check_limits(calibration: Any, *known: str) -> None:
    """Raise SlamlibError unless all limits are `known`, not negative, and `near` is below `far`."""
    name, limits = calibration.sensor.name, calibration.limits
    for limit, value in limits.items():
        if limit not in known:
            raise UnknownNameError.of(f"limit of {name}", limit, known)
        if np.ndim(value) or not value >= 0:
            raise SlamlibError(f"{name}: the limit {limit!r} should be a number, zero or more, got {value!r}")
    if limits.get("near", 0) >= limits.get("far", np.inf):
        raise SlamlibError(f"{name}: the limit 'near' ({limits['near']}) should be less than 'far' ({limits['far']})")
