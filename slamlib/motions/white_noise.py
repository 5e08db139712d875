"""Process noise of white noise on a derivative, for states (x, dx/dt, ...) of `order` numbers: random walks and higher.

Of one axis, or of several, whose numbers stand side by side: (x, y, z, and then their rates).
"""

import math

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import finite


def integrated(order, dt):
    """Covariance (order, order) after dt of white noise of density one on the derivative `order`. Eq. (mo-white)."""
    down = range(order - 1, -1, -1)
    return np.array([
        [dt ** (i + j + 1) / ((i + j + 1) * math.factorial(i) * math.factorial(j)) for j in down] for i in down
    ])  # fmt: skip


def reached(order, dt):
    """What a derivative `order` of one, held for dt, adds to each number of the state (order,). Eq. (mo-held)."""
    return np.array([dt ** (i + 1) / math.factorial(i + 1) for i in range(order - 1, -1, -1)])


def white_noise(order, dt, density):
    """Q (order k, order k) after dt [s] of white noise on the derivative `order`, 1 or more, of k axes. Eq. (mo-white).

    density (k,), or a number for one axis: the derivative's spectral density [its unit squared, per Hz]; with `order` 2
    and metres [m^2/s^3]. Two steps give what one of both times gives. Raises SlamlibError for bad arguments.
    """
    axes = _checked("white_noise", order, dt, density, "density")
    return np.kron(integrated(order, float(dt)), np.diag(axes))


def held_noise(order, dt, variance):
    """The same (order k, order k) of a derivative that is constant during a step of dt [s], and drawn anew in each.

    variance (k,), or a number for one axis: of that derivative [its unit squared]. Eq. (mo-held).
    """
    axes = _checked("held_noise", order, dt, variance, "variance")
    way = reached(order, float(dt))
    return np.kron(np.outer(way, way), np.diag(axes))


def _checked(function, order, dt, size, what):
    """The sizes (k,) of the noise of each axis; SlamlibError for what cannot be."""
    if isinstance(order, bool) or not isinstance(order, int | np.integer) or order < 1:
        raise SlamlibError(f"{function}: order should be 1 (of a random walk), 2, 3 or more, got {order!r}")
    if not finite(dt, (), function, "dt") >= 0:
        raise SlamlibError(f"{function}: dt should be a time of 0 s or more, got {dt!r}")
    axes = np.atleast_1d(finite(size, None, function, what))
    if axes.ndim != 1 or (axes < 0).any():
        raise SlamlibError(f"{function}: {what} should be a number, or one for each axis, none below 0; got {size!r}")
    return axes
