"""Rooms: textured quadrangles, and the world of points, segments and faces that they are."""

import functools
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from slambook.rendering.textures import Texture
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, finite, read_only_copy
from slamlib.records.inputs import World
from slamlib.simulation.worlds import numbered

SAME = 1e-6  # [m]: corners that are nearer to one another are one


@dataclass(frozen=True, eq=False)
class TexturedQuad:
    """A parallelogram: the texture's upper left corner lies at `corner`, its rows go along edge_u, its columns edge_v.

    corner, edge_u, edge_v (3,) [m]; seen with edge_u to the right and edge_v down, the picture is upright. light: what
    the texture's grey values are multiplied by. outlined: whether its edges and corners are part of the room's world.
    """

    corner: Array
    edge_u: Array
    edge_v: Array
    texture: Texture
    light: float = 1.0
    outlined: bool = True

    def __post_init__(self) -> None:
        for name in ("corner", "edge_u", "edge_v"):
            object.__setattr__(self, name, read_only_copy(finite(getattr(self, name), (3,), "TexturedQuad", name)))
        if not np.linalg.norm(np.cross(self.edge_u, self.edge_v)) > SAME**2:
            raise SlamlibError("TexturedQuad: edge_u and edge_v span no area")
        if not 0 <= self.light <= 1:
            raise SlamlibError(f"TexturedQuad: light is between 0 and 1, got {self.light}")

    @property
    def corners(self) -> Array:
        """The four corners (4, 3) [m], one after the other round the border."""
        return self.corner + np.stack([0 * self.edge_u, self.edge_u, self.edge_u + self.edge_v, self.edge_v])


class Room:
    """Textured quads; `world` is what there is to see of them for a filter of points and lines."""

    quads: tuple[TexturedQuad, ...]

    def __init__(self, quads: Iterable[TexturedQuad]) -> None:
        self.quads = tuple(quads)
        if not self.quads:
            raise SlamlibError("a room has at least one quad")

    @functools.cached_property
    def world(self) -> World:
        """Corners as points, edges as segments, of the quads that are outlined; all quads as opaque triangles."""
        corners = np.stack([q.corners for q in self.quads])
        faces = corners[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3)
        seen = corners[[q.outlined for q in self.quads]]
        edges = np.stack([seen, np.roll(seen, -1, 1)], 2).reshape(-1, 2, 3)
        return numbered(_unique(seen.reshape(-1, 3)), _unique(_sorted(edges).reshape(-1, 6)), faces)


def _unique(rows: Array) -> Array:
    """The rows without repetitions, in the order of their first appearance."""
    _, first = np.unique(np.rint(rows / SAME).astype(np.int64), axis=0, return_index=True)
    return rows[np.sort(first)]


def _sorted(edges: Array) -> Array:
    """Edges (n, 2, 3) with their smaller end first, so that the edge that two quads share is one."""
    first, second = (np.rint(edges[:, i] / SAME) for i in (0, 1))
    differs = np.argmax(first != second, 1)[:, None]
    swap = (np.take_along_axis(first, differs, 1) > np.take_along_axis(second, differs, 1))[:, 0]
    return np.where(swap[:, None, None], edges[:, ::-1], edges)
