"""Properties that every model must have: values, Jacobians, batches, single precision."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from slamlib.checks.judge import Case, Judge
from slamlib.errors import SingularPointError
from slamlib.geometry.pose import ORIGIN, Pose
from slamlib.manifolds import Array, Manifold, Product
from slamlib.models import Formula, Jacobians
from slamlib.models.numerical import central_difference, complex_step
from slamlib.registry import Moved, TypeDescription

_STEP = 1e-6  # of central differences
Place = Sequence[Array]  # one array for each argument
VALUE = "the generated value is the definition's"
JACOBIAN = "the Jacobian is the derivative, by complex step"
DIFFERENCE = "the Jacobian is the derivative, by central differences"
DEFINED = "is defined at ordinary places"
INTERFACE = "the definitions take and return what they should"
BATCH = "a batch is a loop"
SINGLE = "works in float32, within its precision"
GENERATOR = "the Jacobian of `moved` is its derivative, where nothing has moved yet"
BY_STATE = "the Jacobian of `moved` by the state is its derivative"


def interface(judge: Judge, owner: TypeDescription, takes: Mapping[str, Mapping[str, int | None]]) -> bool:
    """The owner's definitions take arguments of these names and sizes (None: of any), in this order."""
    for definition, wanted in takes.items():
        found = {a.name: a.size if wanted.get(a.name) else None for a in getattr(owner, definition).arguments}
        told, should = (", ".join(n + f" ({size})" * bool(size) for n, size in x.items()) for x in (found, wanted))
        judge.at(f"{owner.name}.{definition}").require(INTERFACE, told == should, f"takes {told}; should take {should}")
    return not judge.findings


def model_properties(
    judge: Judge,
    model: Formula,
    name: str,
    places: Sequence[Place],
    nasty: Iterable[Place] = (),
    *,
    chain: bool = False,
) -> None:
    """At ordinary arguments the model must be defined; in degenerate cases it may raise SingularPointError.

    chain: of several models, which computes in double precision, and whose Jacobians may be small in all entries.
    """
    for i, place in enumerate([*places, *nasty]):
        case = judge.at(name, **named(model, place))
        try:
            value, jacobians = model.jac(*place)
        except SingularPointError as error:
            if i < len(places):
                case.fail(DEFINED, str(error).split(", at")[0])
            continue
        if i < len(places):
            case.hold(DEFINED)
        derivatives(case, model, place, value, jacobians, chain=chain)
    if not judge.lacks(DEFINED, definition=name):
        _batch(judge, model, name, places)
        if not chain:
            _single(judge, model, name, places)


def named(model: Formula, place: Place) -> dict[str, Array]:
    """The arguments as a dictionary, for messages."""
    return dict(zip(model.parameters, place, strict=True))


def derivatives(
    case: Case, model: Any, place: Place, value: Array, jacobians: Jacobians, *, chain: bool = False
) -> None:
    """The value is the definition's, if there is one, and each Jacobian the numerical derivative, where that is finite.

    chain: with steps as large as the argument, and beside the Jacobian's largest entry also where that is below one, as
    is a derivative w.r.t. a pixel. A complex step rounds as the value does: beyond 1e6 a row's tolerance grows with it.
    """
    written, own = hasattr(model, "definition"), np.fmax(1e-9, 1e-15 * np.abs(value))
    with np.errstate(all="ignore"):
        if written and np.isfinite(expected := model.definition(*place)).all():
            case.compare(VALUE, value, expected)
        for index, argument in enumerate(model.arguments):
            if written:
                numerical, what = complex_step(model, place, index), JACOBIAN
                limit = own.reshape(-1, *[1] * (numerical.ndim - 1)) if own.shape == numerical.shape[:1] else own.max()
            else:
                step = 1e-6 * (max(1.0, float(np.abs(place[index]).max())) if chain else 1.0)
                numerical, what, limit = central_difference(model, place, index, step), DIFFERENCE, 1e-5
            if np.isfinite(numerical).all():
                size = s if chain and (s := np.abs(numerical).max()) > 1e-9 else 1.0
                case.compare(what, getattr(jacobians, argument.name) / size, numerical / size, argument.name, limit)


def moved_derivatives(case: Case, moved: Moved, manifold: Manifold, motion: Array, state: Array) -> None:
    """The Jacobians of moved(motion, state) by the motion, where that is none, and by the state are its derivatives."""

    def change(dof: int, of: Callable[[Array], Array]) -> Array:
        pairs = [(of(step), of(-step)) for step in _STEP * np.eye(dof)]
        return np.array([manifold.minus(a, b) for a, b in pairs]).T / (2 * _STEP)

    by_motion = change(Pose.dof, lambda step: moved(Pose.plus(ORIGIN, step), state))
    case.compare(GENERATOR, moved.jac_where(ORIGIN, state), by_motion, "motion", 1e-6)
    by_state = change(manifold.dof, lambda step: moved(motion, manifold.plus(state, step)))
    case.compare(BY_STATE, moved.jac(motion, state)[1][1], by_state, "state", 1e-6)


def _batch(judge: Judge, model: Formula, name: str, places: Sequence[Place]) -> None:
    """All arguments as one batch of two rows, and one first argument with many others."""
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
            continue  # one first argument with another's others may be undefined
        case = judge.at(name, **named(model, loop[0]))
        for k, argument in enumerate(("", *model.parameters)):
            wanted, found = np.stack([[v, *j][k] for v, j in single]), np.asarray([value, *jacobians][k])
            flat = found.reshape(wanted.shape) if found.size == wanted.size else found
            case.compare(BATCH, flat, wanted, argument)


def _single(judge: Judge, model: Formula, name: str, places: Sequence[Place]) -> None:
    for place in places:
        rounded = [np.asarray(a, dtype=np.float32) for a in place]
        exact = [_onto(a.manifold, r.astype(float)) for a, r in zip(model.arguments, rounded, strict=True)]
        case = judge.at(name, **named(model, place))
        try:
            value, jacobians = model.jac(*(r[None] for r in rounded))
            wanted, by = model.jac(*exact)
        except SingularPointError as error:
            case.fail(SINGLE, str(error))
            continue
        for k, argument in enumerate(("", *model.parameters)):
            found = np.asarray([value, *jacobians][k]).reshape(np.shape([wanted, *by][k]))
            case.compare(SINGLE, found, [wanted, *by][k], argument, 5e-5)


def _onto(manifold: Manifold | None, value: Array) -> Array:
    """A value rounded to single precision, put back onto its space: the rounded quaternion of unit length."""
    if isinstance(manifold, Product):
        return np.concatenate(list(map(_onto, manifold.parts, manifold.split(value))))
    return value / np.linalg.norm(value) if manifold is not None and manifold.dof < manifold.size else value
