"""The room that is always there: walls with posters, boxes to walk round, and a window to a far hall."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from slambook.rendering import drawing
from slambook.rendering.quads import Room, TexturedQuad
from slambook.rendering.textures import Texture, photograph
from slamlib.errors import UnknownNameError
from slamlib.manifolds import Array

LENGTH, WIDTH, HEIGHT = 6.0, 5.0, 2.6  # [m], along x, y, z; the floor's middle is (0, 0, 0)
WINDOW = (-0.55, 0.75, 0.85, 1.95)  # y, Y, z, Z [m], in the wall x = 3
FAR = 16.0  # x [m] of the hall's end, behind the window
GAP = 0.004  # [m] between a poster and its wall


@dataclass(frozen=True)
class RoomStyle:
    """The textures of a room by use: one each for the walls, floor and ceiling, and several to hang up and to box."""

    floor: Texture
    ceiling: Texture
    walls: tuple[Texture, ...]
    pictures: tuple[Texture, ...]
    boxes: tuple[Texture, ...]


def _drawn_look(rng: np.random.Generator) -> RoomStyle:
    return RoomStyle(
        drawing.terrazzo(rng),
        drawing.blank(rng),
        tuple(drawing.plaster(rng, shapes=n) for n in (240, 240, 50, 240)),
        tuple(drawing.poster(rng) for _ in range(10)),
        tuple(drawing.poster(rng, (256, 256), 160) for _ in range(5)),
    )


def _photographic_look(rng: np.random.Generator) -> RoomStyle:
    """The photographs; walls stay drawn but one, since a photograph of plaster is not among them."""
    names = ("astronaut", "coffee", "motorcycle_left", "camera", "chelsea", "page", "coins", "ihc", "moon", "astronaut")
    return RoomStyle(
        photograph("gravel"),
        drawing.blank(rng),
        (drawing.plaster(rng), photograph("brick"), drawing.plaster(rng, shapes=50), drawing.plaster(rng)),
        tuple(map(photograph, names)),
        tuple(map(photograph, ("brick", "coffee", "grass", "motorcycle_left", "coins"))),
    )


ROOM_STYLES: dict[str, Callable[[np.random.Generator], RoomStyle]] = {
    "drawn": _drawn_look,
    "photographs": _photographic_look,
}


def default_room(textures: str = "drawn", seed: int = 1) -> Room:
    """A room of 6 x 5 x 2.6 m about (0, 0, 0) on the floor, of some fifty quads. seed: of the drawn textures.

    textures: "drawn", which needs NumPy alone, or "photographs", which scikit-image ships. Raises SlamlibError.
    """
    if textures not in ROOM_STYLES:
        raise UnknownNameError.of("textures", textures, ROOM_STYLES)
    return _furnished(textures, seed)


@lru_cache(maxsize=2)  # it takes seconds to draw, and a room is not changed
def _furnished(textures: str, seed: int) -> Room:
    style = ROOM_STYLES[textures](np.random.default_rng(seed))
    return Room([*_shell(style), *_hall(style), *_pictures(style), *_furniture(style)])


def _wall(
    texture: Texture, left: tuple[float, float], right: tuple[float, float], z: float, top: float
) -> TexturedQuad:
    """Upright, from left to right (x, y) as one sees it, from z up to Z [m]."""
    along = np.array([right[0] - left[0], right[1] - left[1], 0.0])
    return TexturedQuad(np.array([*left, top]), along, np.array([0, 0, z - top]), texture)


def _level(texture: Texture, x: float, X: float, y: float, Y: float, z: float) -> TexturedQuad:
    """Horizontal, its picture upright for a viewer who faces along x."""
    return TexturedQuad(np.array([X, Y, z]), np.array([0, y - Y, 0]), np.array([x - X, 0, 0]), texture)


def _part(quad: TexturedQuad, u: float, U: float, v: float, V: float, light: float = 1.0) -> TexturedQuad:
    """A part of a quad, with that part of its texture; shares of its edges."""
    height, width = quad.texture.image.shape
    rows, columns = (slice(round(a * n), round(b * n)) for a, b, n in ((v, V, height), (u, U, width)))
    corner = quad.corner + u * quad.edge_u + v * quad.edge_v
    texture = Texture(quad.texture.image[rows, columns])
    return TexturedQuad(corner, (U - u) * quad.edge_u, (V - v) * quad.edge_v, texture, light, outlined=False)


def _shell(style: RoomStyle) -> list[TexturedQuad]:
    """Floor, ceiling, three whole walls, and the wall x = 3 in four parts round the window."""
    x, y = LENGTH / 2, WIDTH / 2
    front, left, back, right = style.walls
    ahead = _wall(front, (x, y), (x, -y), 0, HEIGHT)
    edges = (y - WINDOW[1]) / WIDTH, (y - WINDOW[0]) / WIDTH, 1 - WINDOW[3] / HEIGHT, 1 - WINDOW[2] / HEIGHT
    u, U, v, V = edges
    round_window = [(0, u, 0, 1), (U, 1, 0, 1), (u, U, 0, v), (u, U, V, 1)]
    whole = [
        (_level(style.floor, -x, x, -y, y, 0), 0.9),
        (_level(style.ceiling, -x, x, -y, y, HEIGHT), 1.0),
        (_wall(left, (-x, y), (x, y), 0, HEIGHT), 0.85),
        (_wall(back, (-x, -y), (-x, y), 0, HEIGHT), 0.8),
        (_wall(right, (x, -y), (-x, -y), 0, HEIGHT), 0.95),
    ]
    return [_part(ahead, *p, light=0.9) for p in round_window] + [
        replace(q, light=light, outlined=False) for q, light in whole
    ]


def _hall(style: RoomStyle) -> list[TexturedQuad]:
    """What is seen through the window: a hall that ends far away, with pictures at its end."""
    x, y, Y, top = LENGTH / 2, -4.0, 4.0, 4.0
    parts = [
        (_wall(style.boxes[2], (FAR, Y), (FAR, y), 0, top), 0.75),
        (_wall(style.walls[1], (x, Y), (FAR, Y), 0, top), 0.6),
        (_wall(style.walls[2], (FAR, y), (x, y), 0, top), 0.7),
        (_level(style.floor, x, FAR, y, Y, 0), 0.6),
        (_level(style.ceiling, x, FAR, y, Y, top), 0.7),
    ]
    hung = [_wall(style.pictures[i], (FAR - 0.1, a), (FAR - 0.1, a - 1.8), 0.6, 2.4) for i, a in ((6, 3.2), (8, -0.6))]
    return [replace(q, light=light, outlined=False) for q, light in parts] + [replace(q, light=0.9) for q in hung]


def _pictures(style: RoomStyle) -> list[TexturedQuad]:
    """Posters of several sizes on the four walls; the wall x = -3 has one only, and is the poor one."""
    x, y, p = LENGTH / 2 - GAP, WIDTH / 2 - GAP, style.pictures
    return [
        _wall(p[0], (x, 2.3), (x, 1.3), 0.9, 1.9),
        _wall(p[1], (x, 1.2), (x, 0.85), 1.35, 1.75),
        _wall(p[2], (x, -0.65), (x, -1.45), 1.1, 1.9),
        _wall(p[3], (x, -1.55), (x, -2.3), 0.7, 1.45),
        _wall(p[4], (x, -1.6), (x, -2.2), 1.6, 2.2),
        _wall(p[5], (-2.6, y), (-1.5, y), 1.0, 1.8),
        _wall(p[6], (-1.0, y), (0.2, y), 0.8, 2.0),
        _wall(p[7], (1.0, y), (2.4, y), 0.9, 2.1),
        _wall(p[8], (2.5, -y), (1.4, -y), 0.9, 2.0),
        _wall(p[9], (0.7, -y), (-0.3, -y), 1.0, 2.1),
        _wall(p[1], (-1.2, -y), (-2.4, -y), 0.8, 1.7),
        _wall(p[3], (-x, -0.4), (-x, 0.6), 1.0, 2.0),
    ]


def _furniture(style: RoomStyle) -> list[TexturedQuad]:
    """Boxes on the floor: two before the wall x = 3, one in the middle of the room, one in a corner."""
    b = style.boxes
    return [
        *_box((2.3, -1.2), (0.5, 0.7), 0.0, 0.75, 0.2, (b[0], b[1])),
        *_box((2.5, 1.6), (0.6, 0.6), 0.0, 0.6, -0.3, (b[2], b[3])),
        *_box((-1.6, 1.6), (0.8, 0.5), 0.0, 1.0, 0.5, (b[4], b[0])),
        *_box((-2.3, -1.7), (0.6, 0.6), 0.0, 0.8, 0.1, (b[1], b[4])),
    ]


def _box(
    center: tuple[float, float],
    size: tuple[float, float],
    z: float,
    top: float,
    turn: float,
    textures: tuple[Texture, Texture],
) -> list[TexturedQuad]:
    """Four sides and a top, turned about the vertical by `turn` [rad]; the textures take turns."""
    c, s = np.cos(turn), np.sin(turn)
    half = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.array(size) / 2
    corners: Array = half @ np.array([[c, s], [-s, c]]) + np.array(center)
    ends = [(tuple(corners[i - 3]), tuple(corners[i])) for i in range(4)]
    sides = [_wall(textures[i % 2], *ends[i], z, top) for i in range(4)]
    edges = np.zeros((2, 3))
    edges[:, :2] = corners[[3, 1]] - corners[0]
    lid = TexturedQuad(np.array([*corners[0], top]), edges[0], edges[1], textures[0])
    lit = zip(sides, (1.0, 0.75, 0.6, 0.85), strict=True)
    return [*(replace(side, light=light) for side, light in lit), lid]
