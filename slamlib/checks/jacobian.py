"""A check of a Jacobian written by hand: its wrong entries, their two values, and the slip where it can be told."""

import inspect
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slamlib.checks.judge import Judge
from slamlib.checks.models import DIFFERENCE, JACOBIAN
from slamlib.errors import NonFiniteError, ShapeError
from slamlib.manifolds import Array
from slamlib.models.numerical import complex_differences, differences

Mask = NDArray[np.bool_]
Written = ArrayLike | tuple[ArrayLike | None, ...]  # one Jacobian, or one for each argument
SHOWN = 4  # wrong entries that a message names
SLIPS = {  # what wrong entries are, as a multiple of what they should be
    -1.0: "has the wrong sign",
    0.0: "is missing",
    2.0: "is twice too large",
    0.5: "lacks a factor of 2",
    np.pi / 180: "is off by pi/180: degrees and radians",
    180 / np.pi: "is off by 180/pi: degrees and radians",
}


def check_jacobian(
    f: Callable[..., ArrayLike], J: Written | Callable[..., Written], *place: object, silent: bool = False
) -> None:
    """Check the Jacobian of a plain function at one place, by the complex step where the function allows it.

        check_jacobian(f, J, x, p)

    J is the derivative of f(x, p) w.r.t. x: an array (value, x), or a function J(x, p) that returns it. A tuple has
    one for each argument, in their order; None is not checked. What is not checked need not be numbers. Where f takes
    no complex numbers, or does more with them than powers (a norm, `abs`, an arctangent of two), central differences
    are taken, which see an error of 1e-5 of the row's largest entry. Where an angle jumps by a whole turn, at +-pi, its
    derivative is that on either side.

    Prints what holds, unless `silent`. Raises CheckError, which names the wrong entries; ShapeError or NonFiniteError
    for a place at which nothing can be checked.

        >>> import numpy as np
        >>> import slamlib as sl
        >>> def product(x):
        ...     return np.array([x[0] * x[1]])
        >>> sl.check_jacobian(product, lambda x: np.array([[x[1], x[0]]]), np.array([2.0, 3.0]))
          holds: the Jacobian is the derivative, by complex step
        product: the property holds.
    """
    name = getattr(f, "__name__", "f")
    value = np.asarray(f(*place), dtype=float)
    if not np.isfinite(value).all():
        raise NonFiniteError(f"{name} is {value} here: check its Jacobian where the value is finite")
    given = J(*place) if callable(J) else J
    given = given if isinstance(given, tuple) else (given,)
    if len(given) > len(place):
        raise ShapeError(f"{name} was given {len(place)} arguments, and J has {len(given)} Jacobians: one for each")
    judge, arguments = Judge(name), named(f, place)
    where = {n: array for n, a in arguments.items() if (array := np.asarray(a)).dtype.kind in "fiub"}
    for i, (argument, found) in enumerate(zip(arguments, given)):  # noqa: B905 - later arguments may have none
        if found is None:
            continue
        wanted, what, tolerance = derivative(f, place, i, value)
        found = np.asarray(found, dtype=float)
        case = judge.at(name, **where)
        if found.shape != wanted.shape:
            how = f"has shape {found.shape}, should have {wanted.shape}, the value's and then the argument's"
            case.fail(what, how + "; transposed, it would fit" * (found.shape[::-1] == wanted.shape), argument)
        elif not (wrong := ~(np.abs(found - wanted) <= tolerance)).any():
            case.hold(what)
        else:
            errors = np.abs(found - wanted) / tolerance
            case.fail(what, told(found, wanted, wrong, tolerance), argument, float(np.nanmax(errors, initial=1.0)))
    judge.conclude(silent)


def named(f: Callable[..., ArrayLike], place: tuple[object, ...]) -> dict[str, object]:
    """The arguments by the names that the function gives them."""
    try:
        names = list(inspect.signature(f).bind(*place).arguments)
    except (TypeError, ValueError):  # a built-in function
        names = []
    return dict(
        zip(names if len(names) == len(place) else [f"argument {i}" for i in range(len(place))], place, strict=True)
    )


def derivative(
    f: Callable[..., ArrayLike], place: tuple[object, ...], index: int, value: Array
) -> tuple[Array, str, Array]:
    """The Jacobian w.r.t. one argument, how it was found, and how far each entry may be off."""
    at = np.asarray(place[index], dtype=float)

    def moved(x: Array) -> Array:
        there = [*place[:index], x.reshape(at.shape), *place[index + 1 :]]
        return np.asarray(f(*there)).reshape(-1)

    flat = at.reshape(-1)
    steps = 6e-6 * np.maximum(1.0, np.abs(flat))
    rough = differences(moved, flat, step=steps)
    turns = rough * steps / np.pi
    if (whole := np.abs(np.abs(turns) - 1) < 1e-3).any():  # an angle jumps by one at +-pi, all of it on one side
        ahead = np.stack([moved(flat + e) - value.reshape(-1) for e in np.diag(steps)], axis=-1) / (2 * np.pi)
        rough -= np.where(whole & (np.abs(ahead - np.round(ahead)) < 1e-3), np.sign(turns) * np.pi / steps, 0.0)
    row = np.abs(rough).max(axis=-1, initial=0.0, keepdims=True)
    limit = 1e-5 * row + 1e-14 * np.maximum(1.0, np.abs(value.reshape(-1, 1))) / steps  # truncated, and rounded
    exact, what, best = complex_differences(moved, flat), DIFFERENCE, rough
    if exact is not None and (np.abs(exact - rough) <= limit).all():
        what, best, limit = JACOBIAN, exact, 1e-9 * np.abs(exact) + 1e-12 * row
    shape = value.shape + at.shape
    return best.reshape(shape), what, np.broadcast_to(limit + 1e-300, rough.shape).reshape(shape)


def told(found: Array, wanted: Array, wrong: Mask, tolerance: Array) -> str:
    """The worst entries with their two values, and what they have in common."""
    places = sorted(zip(*np.nonzero(wrong), strict=True), key=lambda at: -abs(found[at] - wanted[at]) / tolerance[at])
    lines = [f"entry {[int(i) for i in at]} is {found[at]:.6g}, should be {wanted[at]:.6g}" for at in places[:SHOWN]]
    if len(places) > SHOWN:
        lines.append(f"and {len(places) - SHOWN} more")
    if slip := slipped(found, wanted, wrong, tolerance):
        lines.append(slip)
    return "\n      ".join(lines)


def slipped(found: Array, wanted: Array, wrong: Mask, tolerance: Array) -> str:
    """What has happened to the wrong entries, if it is one thing."""
    if found.ndim == 2 and found.shape == found.shape[::-1] and (np.abs(found.T - wanted) <= tolerance).all():
        return "this is the transpose"
    if (wanted[wrong] == 0).any() or not np.isfinite(found[wrong]).all():
        return ""
    ratios = found[wrong] / wanted[wrong]
    ratio, some = ratios.mean(), "it" if wrong.sum() == 1 else "each of them"
    if np.ptp(ratios) > 1e-4 * max(1.0, abs(ratio)):
        return ""
    near = [slip for factor, slip in SLIPS.items() if abs(ratio - factor) <= 1e-4 * max(abs(factor), 1e-2)]
    return f"{some} {near[0] if near else f'is {ratio:.4g} times what it should be'}"
