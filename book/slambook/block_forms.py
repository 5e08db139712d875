"""The block forms of Jacobians: a few named factors, such as rotations and cross products, that are equal to a block.

A Jacobian is cut where its argument and its value are put together of parts. Each block is searched among sums of two
products, at several random places at once, and what is found is tested at others.
"""

import contextlib
import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.geometry.quaternion import exponential, minus, rotation
from slamlib.manifolds import Array, Indices
from slamlib.models import Model

Part = tuple[str, int]  # its letter, and the number of its columns
SPLITS = {  # by module and argument, by the manifold, by the module of a landmark, or by the name of an argument
    "plane_range.measurement": "r1",
    "plane_range.unmeasured": r"\beta1",
    "plane_bearing.measurement": r"\beta1",
    "range and bearing": r"r1 \beta1",
    "anchor, azimuth and inverse distance": r"x_01 y_01 \psi1 \rho1",
    "plane_point": "x1 y1",
    "pose": "t3 q3",
    "pose and velocities": r"t3 q3 v3 \omega3",
    "framed point": r"t_03 q_03 u2 \rho1",
    "ahm_point": r"a3 m3 \rho1",
    "hmg_point": "m3 w1",
    "idp_point": r"a3 \alpha2 \rho1",
    "plk_line": "n3 v3",
    "apl_line": "a3 n3 v3",
    "hmg_line": "m_13 w_11 m_23 w_21",
    "ahm_line": r"a3 m_13 \rho_11 m_23 \rho_21",
    "idp_line": r"a3 \alpha_12 \rho_11 \alpha_22 \rho_21",
    "line": "n3 v3",
    "rays": "r_13 r_23",
    "control": r"u_t3 u_\theta3",
    "point": "h3 w1",
    "first": "p3 c1",
    "second": "q3 d1",
    "plane": "a3 b1",
}
NAMES = {"point": "p", "vector": "v", "ray": "r", "eye": "e", "landmark": "p", "abscissa": "s", "angles": r"\alpha"}
NAMES |= {"dt": r"\Delta t", "unmeasured": r"\rho", "number": r"\rho", "value": "p"}
PLACES, TESTS, ROUNDING = 4, 3, 1e-8


def parts(model: Model, name: str, size: int, manifold: Any) -> list[Part]:
    """What `size` numbers of an argument, or of the value, are; one part where nothing is known of them."""
    own = model.module.rsplit(".", 1)[-1]
    landmark = name == "landmark" or (name == "value" and model.name in ("from_frame", "constrain"))
    last = name if name != "value" else "point" if size == 4 else "line"
    for key in (f"{own}.{name}", str(manifold), own if landmark else "", last):
        found = [(text[:-1], int(text[-1])) for text in SPLITS.get(key, "").split()]
        if sum(count for _, count in found) == size and own not in ("quaternion", "euler", "euler_composition"):
            return found
    return [(NAMES.get(name, r"\text{" + name.replace("_", r"\_") + "}"), size)]


@dataclass
class Place:
    """A model's Jacobians at random arguments, with the vectors, rotations and numbers that have names there."""

    jacobians: Any
    rows: list[Part]
    vectors: dict[str, Array]
    turns: dict[str, Array]
    numbers: dict[str, float]
    given: dict[str, Array]

    @classmethod
    def random(cls, model: Model, rng: np.random.Generator) -> "Place":
        """Somewhere; raises SlamlibError where the model is not defined."""
        given = {
            a.name: a.manifold.random(rng) if a.manifold and a.is_manifold else rng.uniform(0.3, 1.2, a.shape)
            for a in model.arguments
        }
        value, jacobians = model.jac(**given)
        size = np.shape(jacobians[0])[0] if np.ndim(value) == 1 else np.size(value)
        rows = parts(model, "value", size, model.result and model.result.manifold)
        place = cls(jacobians, rows, {}, {"": np.eye(3)}, {"": 1.0}, given)
        poses = [a.name for a in model.arguments if str(a.manifold) == "pose"]
        for a in model.arguments:
            mark = f"_{1 + poses.index(a.name)}" if a.name in poses and len(poses) > 1 else ""
            place.name(parts(model, a.name, int(np.prod(a.tangent)), a.manifold), np.ravel(given[a.name]), mark)
        if np.ndim(value) == 1:
            place.name(place.rows, value, "'")
        if r"\omega" in place.vectors and r"\Delta t" in place.numbers:
            place.rotated(place.numbers[r"\Delta t"] * place.vectors[r"\omega"])
        if {"a", "t"} <= place.vectors.keys():
            place.vectors["(a - t)"] = place.vectors["a"] - place.vectors["t"]
        return place

    def name(self, found: list[Part], array: Array, mark: str) -> None:
        """Give the parts of an argument or of the value their names."""
        start, stored = 0, array.size > sum(count for _, count in found)
        for letter, count in found:
            turn = letter.startswith("q") and stored
            one = array[start : start + count + turn]
            start += count + turn
            if turn:
                self.turn("C" + letter[1:] + mark, rotation(one / np.linalg.norm(one)))
            elif count == 3:
                self.vectors[letter + mark] = one
            elif count == 1:
                self.numbers[letter + mark] = float(one[0])
            if letter == r"u_\theta" and not stored:
                self.rotated(one)

    def turn(self, name: str, matrix: Array) -> None:
        """A rotation, and the one back."""
        self.turns |= {name: matrix, name + r"^\top": matrix.T}

    def rotated(self, vector: Array) -> None:
        """C_u, the rotation by a vector, and its right Jacobian J_r."""
        step = 1e-6 * np.eye(3)
        there = exponential(vector)
        columns = [(minus(exponential(vector + s), there) - minus(exponential(vector - s), there)) / 2e-6 for s in step]
        self.turn("C_u", rotation(there))
        self.turns["J_r"] = np.array(columns).T

    def matrices(self, shape: tuple[int, int]) -> dict[str, Array]:
        """What a block of a shape may be, up to a factor."""
        found: dict[str, Array] = {}
        if shape == (3, 3):
            found = {name or "I": turn for name, turn in self.turns.items()}
            for (a, A), (v, x) in itertools.product(self.turns.items(), self.vectors.items()):
                found[rf"{a} [{v}]_\times"] = A @ cross(x)
                found |= {rf"[{v}]_\times {a}": cross(x) @ A} if a else {}
                found |= {rf"[{v}]_\times {a} [{u}]_\times": cross(x) @ A @ cross(y) for u, y in self.vectors.items()}
            found |= {
                rf"{v} {u}^\top": np.outer(x, y) for v, x in self.vectors.items() for u, y in self.vectors.items()
            }
        elif sorted(shape) == [1, 3]:
            columns = dict(self.vectors)
            pairs = itertools.combinations(self.vectors.items(), 2)
            columns |= {rf"({v} \times {u})": np.cross(x, y) for (v, x), (u, y) in pairs}
            for (a, A), (v, x) in itertools.product(self.turns.items(), columns.items()):
                name = f"{a} {v}".strip()
                found[name if shape[1] == 1 else rf"({name})^\top" if a else rf"{name}^\top"] = (A @ x).reshape(shape)
        elif shape[0] == shape[1]:
            found = {"I" if shape[0] > 1 else "1": np.eye(shape[0])}
        return found

    def factors(self) -> dict[str, float]:
        """The numbers by which these may be multiplied, without their signs."""
        found = {"": 1.0}
        for name, number in self.numbers.items():
            if name:
                found |= {name: number, rf"\tfrac1{{{name}}}": 1 / number, rf"\tfrac1{{{name}^2}}": 1 / number**2}
        for name, vector in self.vectors.items():
            found[rf"\lVert {name}\rVert"] = float(np.linalg.norm(vector))
        return found


def cross(v: Array) -> Array:
    """The matrix (3, 3) of the cross product with a vector (3,)."""
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


@dataclass(frozen=True)
class Sum:
    """A block as a sum: of each term its sign, its factor and its matrix, by their names."""

    terms: tuple[tuple[int, str, str], ...] = ()

    def at(self, place: Place, shape: tuple[int, int]) -> Array:
        """Its numbers at a place."""
        factors, matrices = place.factors(), place.matrices(shape)
        return np.add.reduce([np.zeros(shape), *(sign * factors[f] * matrices[m] for sign, f, m in self.terms)])

    def __str__(self) -> str:
        words = [("-" if s < 0 else "+", f if m == "1" and f else f"{f}\\, {m}" if f else m) for s, f, m in self.terms]
        return " ".join(f"{s} {w}" for s, w in words).removeprefix("+ ") or "0"


def search(blocks: list[Array], places: list[Place]) -> Sum | None:
    """The shortest sum of at most two terms that a block is at all places; None if there is none."""
    if all(np.abs(block).max() < ROUNDING for block in blocks):
        return Sum()
    shape = blocks[0].shape
    tables = [place.matrices(shape) for place in places]
    names = list(tables[0])
    rows = [np.array([matrix.ravel() for matrix in table.values()]) for table in tables]
    wanted = [block.ravel() for block in blocks]
    factors = [place.factors() for place in places]

    def named(coefficients: Array) -> tuple[int, str] | None:
        for sign, factor in itertools.product((1, -1), factors[0]):
            if np.abs(sign * np.array([table[factor] for table in factors]) - coefficients).max() < ROUNDING * (
                1 + np.abs(coefficients).max()
            ):
                return sign, factor
        return None

    def sums(indices: tuple[Indices, ...], coefficients: list[Array]) -> Iterator[Sum]:
        close = np.ones(len(indices[0]), dtype=bool)
        for k, b in enumerate(wanted):
            made = np.add.reduce([coefficients[k][:, [i]] * rows[k][index] for i, index in enumerate(indices)])
            close &= np.abs(made - b).max(1) < ROUNDING * (1 + np.abs(b).max())
        for n in np.flatnonzero(close):
            found = [named(np.array([c[n, i] for c in coefficients])) for i in range(len(indices))]
            if all(one is not None for one in found):
                yield Sum(tuple((*one, names[index[n]]) for one, index in zip(found, indices, strict=True) if one))

    squares = [np.maximum((r * r).sum(1), ROUNDING) for r in rows] if names else []
    alone = [((r @ b) / s)[:, None] for r, b, s in zip(rows, wanted, squares, strict=True)] if names else []
    found = list(sums((np.arange(len(names)),), alone)) if names else []
    if not found and len(names) > 1:
        first, second = np.triu_indices(len(names), 1)
        both = []
        for r, b, s in zip(rows, wanted, squares, strict=True):
            product, p = (r @ r.T)[first, second], r @ b
            area = np.maximum(s[first] * s[second] - product**2, ROUNDING)
            one, other = p[first] * s[second] - p[second] * product, p[second] * s[first] - p[first] * product
            both.append(np.stack([one / area, other / area], axis=1))
        found = list(sums((first, second), both))
    return min(found, key=lambda one: len(str(one)), default=None)


def places_of(model: Model) -> list[Place]:
    """Random places, those of the search first; raises SlamlibError where the model is defined at too few."""
    places: list[Place] = []
    rng = np.random.default_rng(len(model.name))
    for _ in range(20 * (PLACES + TESTS)):
        with contextlib.suppress(SlamlibError):
            places.append(Place.random(model, rng))
        if len(places) == PLACES + TESTS:
            return places
    raise SlamlibError(f"{model.module}.{model.name} is not defined at random places")


def block_form(model: Model, name: str) -> list[list[Sum | None]]:
    """The blocks of the Jacobian with respect to an argument; None for those that have no short form."""
    places, index = places_of(model), model.parameters.index(name)
    columns = parts(model, name, int(np.prod(model.arguments[index].tangent)), model.arguments[index].manifold)
    numbers = [np.reshape(place.jacobians[index], (-1, sum(c for _, c in columns))) for place in places]
    return forms(numbers, places[0].rows, columns, places)


def forms(numbers: list[Array], rows: list[Part], columns: list[Part], places: list[Place]) -> list[list[Sum | None]]:
    """The blocks of a matrix, known at each place; None for those that have no short form."""

    def form(top: int, left: int, height: int, width: int) -> Sum | None:
        blocks = [one[top : top + height, left : left + width] for one in numbers]
        found = search(blocks[:PLACES], places[:PLACES])
        tests = zip(blocks[PLACES:], places[PLACES:], strict=True)
        close = found and all(np.allclose(found.at(p, b.shape), b, rtol=0, atol=100 * ROUNDING) for b, p in tests)
        return found if close else None

    tops, lefts = ([(sum(c for _, c in cut[:i]), n) for i, (_, n) in enumerate(cut)] for cut in (rows, columns))
    return [[form(top, left, height, width) for left, width in lefts] for top, height in tops]
