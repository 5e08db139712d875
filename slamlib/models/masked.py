"""A formula over masked arrays: items in which something is masked are masked in the results, and are not computed."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.models.argument import Argument
from slamlib.models.kernel import common


def over_unmasked(
    run: Callable[[list[Array]], list[Array]], name: str, specs: Sequence[Argument], arguments: list[Array]
) -> list[Array]:
    """run(arguments) for the items of a batch in which nothing is masked; errors call the formula `name`.

    Raises SlamlibError where nothing is left.
    """
    axes = [tuple(range(a.ndim - len(s.shape), a.ndim)) for s, a in zip(specs, arguments, strict=True)]
    hidden = [np.ma.getmaskarray(a).any(axis) for a, axis in zip(arguments, axes, strict=True)]
    plain = [np.asarray(np.ma.getdata(a)) for a in arguments]
    if not any(np.any(mask) for mask in hidden):
        return run(plain)
    batch = common(name, list(specs), [np.shape(mask) for mask in hidden])
    keep = ~np.logical_or.reduce([np.broadcast_to(mask, batch) for mask in hidden])
    if not keep.any():
        raise SlamlibError(f"{name}: in each item something is masked: leave out what is not known")
    own = [a.shape[axis[0] :] if axis else () for a, axis in zip(plain, axes, strict=True)]
    rows = [np.broadcast_to(a, batch + shape)[keep] for a, shape in zip(plain, own, strict=True)]
    return [_spread(found, keep) for found in run(rows)]


def _spread(found: Array, keep: Any) -> Array:
    """Results (k, ...) of the items that are kept, in a masked array of all items."""
    whole: Any = np.ma.masked_all(keep.shape + found.shape[1:])
    whole[keep] = found
    return np.ma.asarray(whole)
