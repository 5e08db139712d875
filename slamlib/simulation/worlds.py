"""Simulated worlds: the toolbox's cloisters and house, and worlds of any size for measuring how cost grows.

`world(name, ...)` finds them by name in WORLDS, a dict: add your own with `WORLDS["mine"] = function`.
"""

import inspect
from collections.abc import Callable
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike

from slamlib.errors import ShapeError, SlamlibError, entry
from slamlib.manifolds import Array, numbers
from slamlib.observation import FAMILIES
from slamlib.plain_data.fields import Count, Finite, Length, Positive, Range, read_fields
from slamlib.records.inputs import Features, World

QUARTER = np.array([[0.0, 1.0], [-1.0, 0.0]])  # rows times this: a quarter turn to the left


def numbered(points: ArrayLike = (), segments: ArrayLike = (), faces: ArrayLike = ()) -> World:
    """Make a world of points (n, 3), segments (k, 6) and faces (f, 3, 3) [m]: ids 1 to n, then n + 1 and on."""
    points, segments, faces = _rows(points, 3), _rows(segments, 6), _rows(faces, 3, 3)
    ids = 1 + np.arange(len(points) + len(segments))
    features = {"points": Features(ids[: len(points)], points), "segments": Features(ids[len(points) :], segments)}
    return World(features, faces)


def _rows(values: ArrayLike, *shape: int) -> Array:
    rows = numbers(values, "world", "values")
    return rows if rows.size else np.zeros((0, *shape))


def check_world(world: World, function: str) -> None:
    """Raise UnknownNameError for an unknown family, ShapeError for things of another size than the family's."""
    for name, things in world.features.items():
        size = entry("family of landmarks", name, FAMILIES).world_size
        if things.values.shape[1] != size:
            raise ShapeError(f"{function}: {name} of a world have {size} numbers each, got {things.values.shape[1]}")


def join(*worlds: World) -> World:
    """Join worlds into one, with new ids: points 1 to N, segments N + 1 and on, each in the order of the worlds."""
    features, end = {}, 1
    for name, family in FAMILIES.items():
        nothing = np.zeros((0, family.world_size))
        values = np.concatenate([nothing, *(w.features[name].values for w in worlds if name in w.features)])
        features[name] = Features(end + np.arange(len(values)), values)
        end += len(values)
    return World(features, np.concatenate([w.faces for w in (World(), *worlds)]))


Steps = Annotated[int, Range(ge=4, le=10_000)]
Number = Annotated[int, Range(ge=1, le=1_000_000)]
Place = Annotated[tuple[Finite, ...], Length((2, 3))]


def cloister(x: Finite = -6, X: Finite = 6, y: Finite = -6, Y: Finite = 6, n: Steps = 9) -> World:
    """Points on the floor z = 0, along the two walls of a square walk between x, X and y, Y [m]; n - 1 steps a side."""
    return numbered(np.column_stack([_walk(x, X, y, Y, n), np.zeros(8 * n - 20)]))


def thick_cloister(x: Finite = -6, X: Finite = 6, y: Finite = -6, Y: Finite = 6, h: Finite = 1, n: Steps = 9) -> World:
    """Two cloisters, one on the floor and one at the height h [m]; n = 7 gives the 72 points of the toolbox's demo."""
    floor = _walk(x, X, y, Y, n)
    return numbered(np.concatenate([np.column_stack([floor, np.full(len(floor), z)]) for z in (0.0, h)]))


def _walk(x: float, X: float, y: float, Y: float, n: int) -> Array:
    """The pattern (8 n - 20, 2): the northern side's outer and inner wall, and the same after each quarter turn."""
    reach = (n - 1) / 2
    outer, inner = np.arange(1 - reach, reach), np.arange(1 - reach, reach - 1)
    side = np.concatenate([np.column_stack([a, np.full(len(a), d)]) for a, d in ((outer, reach), (inner, reach - 1))])
    turns = [side]
    for _ in range(3):
        turns.append(turns[-1] @ QUARTER)
    return np.array([x + X, y + Y]) / 2 + np.concatenate(turns) * np.array([X - x, Y - y]) / (n - 1)


def house(
    x: Finite = -2, y: Finite = -2, z: Finite = 0, length: Positive = 5, width: Positive = 5, height: Positive = 4
) -> World:
    """23 segments: walls, floor, gables, roof, a door and a window; at the corner (x, y, z) [m].

    Its walls and its roof are faces, door and window too: with occlusion, its far side is hidden.
    """
    ground = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    eaves = ground + np.array([0, 0, 0.65])
    ridge = np.array([[0, 0.5, 1], [1, 0.5, 1]])
    door = np.array([[0, 0.6, 0], [0, 0.8, 0], [0, 0.8, 0.5], [0, 0.6, 0.5]])
    window = np.array([[0, 0.2, 0.25], [0, 0.4, 0.25], [0, 0.4, 0.5], [0, 0.2, 0.5]])
    (a, b, c, d), (left, right) = eaves, ridge
    gables = [(a, left), (left, d), (b, right), (right, c)]
    lines = [*zip(ground, eaves, strict=True), *_ring(ground), *gables, (left, right), (a, b), (d, c)]
    lines += [*_ring(door), *_ring(window)]
    walls = [corner for p, q in zip(_ring(ground), _ring(eaves), strict=True) for corner in _quad(*p, *q[::-1])]
    faces = [*walls, (a, left, d), (b, right, c), *_quad(a, b, right, left), *_quad(d, c, right, left)]
    corner, size = np.array([x, y, z], dtype=float), np.array([length, width, height], dtype=float)
    return numbered(segments=(corner + size * np.array(lines)).reshape(-1, 6), faces=corner + size * np.array(faces))


def _ring(corners: Array) -> list[tuple[Array, Array]]:
    """The edges of a polygon."""
    return list(zip(corners, np.roll(corners, -1, 0), strict=True))


def _quad(a: Array, b: Array, c: Array, d: Array) -> list[tuple[Array, Array, Array]]:
    """Two triangles that make a quadrangle."""
    return [(a, b, c), (a, c, d)]


def gallery(n: Number = 1000, spacing: Positive = 1.6, distance: Positive = 4.0, h: Finite = 2.0) -> World:
    """n points on the outer wall of a circular walk about (0, 0), in columns of four up to the height h [m].

    The walk has the radius gallery_radius(n, spacing) [m], a column every `spacing` [m], its wall at `distance` [m].
    A camera that points outwards, with the euler angles (-90, 0, 180) on a robot that circles to the left, sees 15 to
    20 points at a time for any n from some hundreds on: the world for measuring what a larger map costs.
    """
    columns, wall = -(-n // 4), gallery_radius(n, spacing) + distance
    angles = 2 * np.pi / columns * (np.arange(columns)[:, None] + np.array([0, 0.5, 0, 0.5]))
    heights = np.broadcast_to(h * np.array([0, 1 / 3, 2 / 3, 1]), angles.shape)
    return numbered(np.stack([wall * np.cos(angles), wall * np.sin(angles), heights], -1).reshape(-1, 3)[:n])


def gallery_radius(n: int, spacing: float = 1.6) -> float:
    """Radius [m] of the walk along a gallery of n points."""
    if n < 4 or not spacing > 0:
        raise SlamlibError(f"gallery: n is 4 or more and spacing above zero, got n = {n}, spacing = {spacing}")
    return -(-n // 4) * spacing / (2 * np.pi)


def town(n: Number = 230, street: Positive = 6.0) -> World:
    """n segments: houses of 23 each in rows, with streets `street` [m] wide; the last house may be unfinished."""
    houses, pitch = -(-n // 23), 5 + street
    side = int(np.ceil(np.sqrt(houses)))
    whole = join(*(house(pitch * (i // side), pitch * (i % side)) for i in range(houses)))
    return numbered(segments=whole.segments.values[:n], faces=whole.faces)


def cloud(n: Number = 100, size: Positive = 10.0, h: Positive = 2.0, seed: Count = 1) -> World:
    """n points drawn uniformly, by this seed, in a box around (0, 0), `size` [m] wide and from the floor to h [m]."""
    rng = np.random.default_rng(seed)
    return numbered(rng.uniform([-size / 2, -size / 2, 0], [size / 2, size / 2, h], (n, 3)))


def listed(points: tuple[Place, ...] = ()) -> World:
    """Points of one's own, as they are listed: (x, y) on the floor, or (x, y, z) [m]."""
    return numbered([(*place, 0.0)[:3] for place in points])


WORLDS: dict[str, Callable[..., World]] = {
    "cloister": cloister,
    "thickCloister": thick_cloister,
    "house": house,
    "gallery": gallery,
    "town": town,
    "cloud": cloud,
    "listed": listed,
}


def world(name: str, **arguments: Any) -> World:
    """The world of this name, as the toolbox spells it: world("thickCloister", n=7). Raises SlamlibError."""
    function = entry("world", name, WORLDS)
    try:
        inspect.signature(function).bind(**arguments)
    except TypeError as error:
        raise SlamlibError(f"world {name}{inspect.signature(function)}: {error}") from None
    return function(**read_fields(function, arguments, f"world {name}"))
