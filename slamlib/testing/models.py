"""Properties that every model must have: values, Jacobians, batches, single precision."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from slamlib.errors import SingularPointError
from slamlib.manifolds import Array
from slamlib.modeling.numerical import central_difference, complex_step
from slamlib.testing.judge import Judge

Place = Sequence[Array]  # one array for each argument
VALUE = "the generated value is the definition's"
JACOBIAN = "the Jacobian is the derivative, by complex step"
DIFFERENCE = "the Jacobian is the derivative, by central differences"
DEFINED = "is defined at ordinary places"
BATCH = "a batch is a loop"
SINGLE = "works in float32, within its precision"


def model_properties(judge: Judge, model: Any, name: str, places: Sequence[Place], nasty: Iterable[Place] = ()) -> None:
    """At ordinary places the model must be defined; at nasty ones it may refuse, with SingularPointError."""
    for i, place in enumerate([*places, *nasty]):
        where = named(model, place)
        try:
            value, jacobians = model.jac(*place)
        except SingularPointError as error:
            if i < len(places):
                judge.fail(DEFINED, name, str(error).split(", at")[0], where)
            continue
        if i < len(places):
            judge.hold(DEFINED)
        _derivatives(judge, model, name, place, value, jacobians)
    if DEFINED not in {what for what, definition, _ in judge.findings if definition == name}:
        _batch(judge, model, name, places)
        _single(judge, model, name, places)


def named(model: Any, place: Place) -> dict[str, Array]:
    """The place as a dictionary, for messages."""
    return dict(zip(model.parameters, place, strict=True))


def _derivatives(judge: Judge, model: Any, name: str, place: Place, value: Array, jacobians: Any) -> None:
    where, written = named(model, place), hasattr(model, "definition")
    with np.errstate(all="ignore"):
        if written and np.isfinite(expected := model.definition(*place)).all():
            judge.compare(VALUE, name, value, expected, where)
        for index, argument in enumerate(model.arguments):
            numerical = (complex_step if written else central_difference)(model, place, index)
            if np.isfinite(numerical).all():
                what, tolerance = (JACOBIAN, 1e-9) if written else (DIFFERENCE, 1e-5)
                judge.compare(
                    what, name, jacobians[index], numerical, where, argument=argument.name, tolerance=tolerance
                )


def _batch(judge: Judge, model: Any, name: str, places: Sequence[Place]) -> None:
    """All places at once in two rows, and one first argument against many others."""
    places = list(places[: len(places) // 2 * 2])
    stacked = [np.stack([np.asarray(p[i]) for p in places]) for i in range(len(places[0]))]
    cases = [([a.reshape(2, -1, *a.shape[1:]) for a in stacked], places)]
    if len(stacked) > 1:
        cases.append(([stacked[0][0], *stacked[1:]], [[places[0][0], *p[1:]] for p in places]))
    for arguments, loop in cases:
        try:
            single = [model.jac(*p) for p in loop]
            value, jacobians = model.jac(*arguments)
        except SingularPointError:
            continue  # one first argument with another's rest may be no place at all
        for k, argument in enumerate(("", *model.parameters)):
            wanted = np.stack([[v, *j][k] for v, j in single])
            found = np.asarray([value, *jacobians][k])
            flat = found.reshape(wanted.shape) if found.size == wanted.size else found
            judge.compare(BATCH, name, flat, wanted, named(model, loop[0]), argument=argument)


def _single(judge: Judge, model: Any, name: str, places: Sequence[Place]) -> None:
    for place in places:
        rounded = [np.asarray(a, dtype=np.float32) for a in place]
        exact = [_onto(argument, r.astype(float)) for argument, r in zip(model.arguments, rounded, strict=True)]
        where = named(model, place)
        try:
            value, jacobians = model.jac(*(r[None] for r in rounded))
            wanted, by = model.jac(*exact)
        except SingularPointError as error:
            judge.fail(SINGLE, name, str(error), where)
            continue
        for k, argument in enumerate(("", *model.parameters)):
            found = np.asarray([value, *jacobians][k]).reshape(np.shape([wanted, *by][k]))
            judge.compare(SINGLE, name, found, [wanted, *by][k], where, argument=argument, tolerance=5e-5)


def _onto(argument: Any, value: Array) -> Array:
    """A value rounded to single precision, put back onto its space: the rounded quaternion of unit length."""
    for start, part in _parts(argument.manifold) if argument.manifold is not None else ():
        if part.dof < part.size:
            piece = slice(start, start + part.size)
            value[piece] /= np.linalg.norm(value[piece])
    return value


def _parts(manifold: Any, start: int = 0) -> Iterable[tuple[int, Any]]:
    for part in getattr(manifold, "parts", ()):
        yield from _parts(part, start)
        start += part.size
    if not hasattr(manifold, "parts"):
        yield start, manifold
