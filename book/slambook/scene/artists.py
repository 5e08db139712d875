"""Layers as matplotlib's artists: made once, and given new contents with every frame."""

from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from slambook.figures.colors import colors
from slambook.scene.figures import SHELL
from slambook.scene.layers import Flat
from slambook.scene.roles import HALO, OUTLINE, Role, over_image, themed
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array

ABOVE = 0.025  # of the figure's height: from the top of axes to their key


def extra(module: str, purpose: str) -> Any:
    """A module of the extra `draw`; raises SlamlibError that says how to get it."""
    try:
        return import_module(module)
    except ImportError as error:
        raise SlamlibError(f'{purpose} needs {module.split(".")[0]}: pip install "slamlib[draw]"') from error


class Artists:
    """What matplotlib draws of one role: two collections of lines, one of marks, and a store of words."""

    def __init__(self, axes: Any, role: Role, theme: str, depth: int, legend: bool) -> None:
        collections = extra("matplotlib.collections", "a window")
        color = themed(role.color, theme)
        look = {"colors": color, "linestyles": role.linestyle, "alpha": role.alpha, "zorder": depth, "animated": True}
        self.lines, self.shells = (
            axes.add_collection(collections.LineCollection([], linewidths=width, **look), autolim=False)
            for width in (role.width, SHELL * role.width)
        )
        filled = {"facecolors": "none", "edgecolors": color} if role.hollow else {"color": color}
        place = np.zeros((0, 2))
        self.marks = axes.scatter(
            *place.T, s=role.size**2, marker=role.marker or ".", linewidths=1, zorder=depth, animated=True, **filled
        )
        self.axes, self.role, self.color, self.depth = axes, role, color, depth
        self.words: list[Any] = []
        self.effects: list[Any] = []  # outlines of words
        if legend and role.label:
            (self.lines if role.marker in ("", ".") else self.marks).set_label(role.label)

    def lift(self) -> None:
        """From now on lie over a photograph: bright, with a dark outline."""
        self.color = over_image(self.role).color
        effects = extra("matplotlib.patheffects", "a window")
        widths = {self.lines: self.role.width, self.shells: SHELL * self.role.width, self.marks: 1.0}
        for artist, width in widths.items():
            artist.set_edgecolor(self.color)
            artist.set_path_effects([effects.withStroke(linewidth=width + 2 * HALO, foreground=OUTLINE)])
        if not self.role.hollow:
            self.marks.set_facecolor(self.color)
        self.effects = [effects.withStroke(linewidth=2 * HALO, foreground=OUTLINE)]
        for text in self.words:
            text.set(color=self.color, path_effects=self.effects)

    def update(self, layer: Flat) -> None:
        """Show another layer of this role."""
        self.lines.set_segments(_parted(layer.lines))
        self.shells.set_segments(_parted(layer.shells))
        self.marks.set_offsets(layer.marks)
        while len(self.words) < len(layer.words):
            self.words.append(self._word())
        for i, text in enumerate(self.words):
            text.set_visible(i < len(layer.words))
            if i < len(layer.words):
                text.xy = tuple(layer.places[i])
                text.set_text(layer.words[i])

    def _word(self) -> Any:
        look = {"color": self.color, "fontsize": self.role.size, "ha": "center", "va": "center"}
        placed = {"textcoords": "offset points", "zorder": self.depth, "clip_on": True, "animated": True}
        placed["path_effects"] = self.effects
        return self.axes.annotate("", (0, 0), (0, self.role.raised), **placed, **look)

    def draw(self) -> None:
        """Draw all on what the axes' canvas shows now."""
        for artist in (self.lines, self.shells, self.marks, *self.words):
            self.axes.draw_artist(artist)


def _parted(lines: Array) -> list[Array]:
    """The runs of a line (N, 2) between its rows of nan."""
    good = np.isfinite(lines).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(int)))
    return [lines[a:b] for a, b in zip(edges[::2], edges[1::2], strict=True)]


class Sheet:
    """Axes with the artists of all roles; layers that are not given are emptied."""

    def __init__(self, axes: Any, roles: dict[str, Role], theme: str, legend: bool) -> None:
        self.axes = axes
        self.artists = {n: Artists(axes, role, theme, 2 + i, legend) for i, (n, role) in enumerate(roles.items())}
        if legend:
            ink = themed(colors.text, theme)
            place = axes.get_position(original=True)  # an image may fill a part of it only
            look = {"bbox_to_anchor": (place.x0, place.y1 + ABOVE), "bbox_transform": axes.figure.transFigure}
            axes.legend(labelcolor=ink, loc="lower left", ncols=4, fontsize=8, frameon=False, **look)

    def update(self, layers: Sequence[Flat]) -> None:
        """Show these layers."""
        found = {layer.role: layer for layer in layers}
        for role, artists in self.artists.items():
            artists.update(found.get(role, Flat(role)))

    def draw(self) -> None:
        """Draw all on what the canvas shows now."""
        for artists in self.artists.values():
            artists.draw()
