"""The two figures on the page: NumPy alone draws them, as SVG."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slambook.figures import Figure, figure
from slambook.scene.image_scene import sensor_scene, sensor_view
from slambook.scene.layers import Flat
from slambook.scene.options import MapOptions, SensorOptions
from slambook.scene.photographs import Photograph, photograph
from slambook.scene.roles import HALO, OUTLINE, ROLES, Role, over_image
from slambook.scene.scene import above, bounds, map_scene, size_of
from slambook.scene.view import NAMED, OrbitView
from slamlib.geometry.pose import from_frame
from slamlib.manifolds import Array
from slamlib.plain_data.fields import read
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

SHELL = 0.7  # width of the outlines of uncertainty, in that of the lines of their role
WIDE = 320  # pixels: the widest image that a figure holds, if nobody asks for another
KEY: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0, 1), "ncols": 2, "fontsize": 9}
CLIPPED: Mapping[str, Any] = {"clip_on": True}
CLOSER = 0.5  # how near the view that follows a robot is, in the distance from which all is seen


def map_figure(
    snapshot: Snapshot,
    *,
    world: World | None = None,
    truth: Truth | None = None,
    path: Sequence[Snapshot] = (),
    true_path: Sequence[Truth] = (),
    width: float = 5.8,
    height: float = 4.0,
    **options: Any,
) -> Figure:
    """The map of a snapshot as a figure of so many inches; the other keywords are those of MapOptions.

    world, truth: what is known of reality, drawn in grey. path, true_path: the snapshots and the truths up to now.
    """
    look = read(MapOptions, options)
    corners = bounds(snapshot, world, truth, path, look)
    shown: dict[str, Any] = {"world": world, "truth": truth, "path": path, "true_path": true_path}
    layers = map_scene(snapshot, **shown, options=look, corners=corners)
    view = view_of(look, snapshot, corners, width / height)
    fig, ax = figure(width=width, height=height)
    ax.axis("off")
    ax.set(xlim=(-width / height, width / height), ylim=(-1, 1), aspect="equal")
    draw(ax, view.flat(layers), ROLES["map"])
    if look.legend:
        ax.legend(**KEY)
    return fig


def asked_view(options: MapOptions, snapshot: Snapshot) -> str | tuple[float, ...]:
    """The view that the options ask for, or that suits the map."""
    return options.view or ("top" if snapshot.plane else "view")


def view_of(options: MapOptions, snapshot: Snapshot, corners: Array, aspect: float) -> OrbitView:
    """The view that the options ask for, after the orbit of so many frames as the snapshot has behind it."""
    if snapshot.plane:  # room for the numbers of what lies farthest north
        corners = np.stack([corners[0], corners[1] + 2 * above(snapshot, size_of(corners, options))])
    middle = tuple(float(v) for v in corners.mean(axis=0))
    box = np.stack(np.meshgrid(*corners.T), axis=-1).reshape(-1, 3)
    if any(options.orbit):  # what the box passes through when it turns about the vertical: it fits from all sides
        half, turn = (corners[1] - corners[0]) / 2, np.radians(np.arange(0, 360, 15))
        ring = middle[:2] + np.stack([np.cos(turn), np.sin(turn)], axis=1) * np.hypot(half[0], half[1])
        box = np.concatenate([np.column_stack([ring, np.full(len(ring), z)]) for z in corners[:, 2]])
    asked = asked_view(options, snapshot)
    if isinstance(asked, str):
        azimuth, elevation, follows = NAMED[asked]
        view = OrbitView(azimuth, elevation, target=middle, perspective=options.perspective).fitted(box, aspect)
        view = following(view, snapshot.robots[0].pose) if follows else view
    else:
        azimuth, elevation, field, *distance = (float(v) for v in asked)
        view = OrbitView(azimuth, elevation, field, middle, perspective=options.perspective)
        view = replace(view, distance=distance[0]) if distance else view.fitted(box, aspect)
    return view.moved(*(snapshot.number * np.asarray(options.orbit)))


def following(view: OrbitView, pose: Array) -> OrbitView:
    """A view whose azimuth is counted from where a robot (7,) heads, nearer, and centred on it."""
    x, y, _ = from_frame(pose, np.array([1.0, 0, 0])) - pose[:3]
    target = tuple(float(v) for v in pose[:3])
    azimuth = view.azimuth + float(np.degrees(np.arctan2(y, x)))
    return replace(view, azimuth=azimuth, target=target, distance=CLOSER * view.distance)


def sensor_figure(
    snapshot: Snapshot, sensor: int | str = 0, *, width: float = 5.8, height: float = 4.3, **options: Any
) -> Figure:
    """What a sensor saw, as a figure of so many inches; the other keywords are those of SensorOptions."""
    look = read(SensorOptions, options)
    view = sensor_view(snapshot, sensor)
    layers = sensor_scene(snapshot, sensor, options=look)
    fig, ax = figure(width=width, height=height)
    names = look.names or tuple(f"measured number {n}" for n in look.numbers)
    photo = None
    if view.image is not None:
        names = look.names or ("u [px]", "v [px]")
        ax.set(xlim=(0, view.image[0]), ylim=(view.image[1], 0), aspect="equal")
        photo = photograph(view, look.image_width or WIDE) if look.image else None
    draw(ax, layers, ROLES["sensor"], photo)
    ax.set(xlabel=names[0], ylabel=names[1])
    if look.legend:
        ax.legend(**KEY)
    return fig


def draw(
    ax: Any,
    layers: Sequence[Flat],
    roles: dict[str, Role],
    photo: Photograph | None = None,
    words: Mapping[str, Any] = CLIPPED,
) -> None:
    """Put layers into axes, the page's or matplotlib's, in their order, each with its role's style.

    Over a photograph everything is bright, with dark outlines; a key beside it keeps the page's colours. words: how
    they are clipped, and if the axes are matplotlib's the path_effects that outline them; else they lie on dark copies.
    """
    if photo is not None:
        ax.imshow(photo.pixels, extent=photo.extent, cmap="gray", vmin=0, vmax=255, interpolation="bilinear")
    for layer in layers:
        (_put if photo is None else _put_over)(ax, layer, roles[layer.role], words)


def _put_over(ax: Any, layer: Flat, own: Role, words: Mapping[str, Any]) -> None:
    role = replace(over_image(own), label="")
    dark = replace(role, color=OUTLINE, width=role.width + 2 * HALO, linestyle="-", hollow=True)
    _put(ax, Flat(layer.role, lines=layer.lines, marks=layer.marks), dark, words, edge=1 + 2 * HALO)
    _put(ax, Flat(layer.role, lines=layer.shells), replace(dark, width=SHELL * role.width + 2 * HALO), words)
    around = () if "path_effects" in words else ((-HALO, 0), (HALO, 0), (0, -HALO), (0, HALO))
    for right, up in around:
        _words(ax, layer, replace(role, color=OUTLINE), words, right, up)
    _put(ax, layer, role, words)
    if own.label:  # what has the label is nowhere, and in the page's colours
        parts = {name: getattr(layer, name)[:1] * np.nan for name in ("lines", "shells", "marks")}
        _put(ax, Flat(layer.role, **parts), own, words)


def _put(ax: Any, layer: Flat, role: Role, words: Mapping[str, Any], edge: float = 1.0) -> None:
    """One layer; edge: width of the outlines of its marks [pt]."""
    stroke = {"color": role.color, "ls": role.linestyle, "alpha": role.alpha}
    marked, lined = len(layer.marks) > 0, len(layer.lines) > 0
    if len(layer.shells):
        ax.plot(*layer.shells.T, lw=SHELL * role.width, label="" if marked or lined else role.label, **stroke)
    if lined:
        ax.plot(*layer.lines.T, lw=role.width, label="" if marked else role.label, **stroke)
    if marked:
        face = "none" if role.hollow else role.color
        look = {"ls": "", "marker": role.marker, "ms": role.size, "color": role.color, "mfc": face, "mew": edge}
        ax.plot(*layer.marks.T, label=role.label, **look)
    _words(ax, layer, role, words)


def _words(ax: Any, layer: Flat, role: Role, more: Mapping[str, Any], right: float = 0.0, up: float = 0.0) -> None:
    look = {"color": role.color, "fontsize": role.size, "ha": "center", "va": "center", **more}
    for place, word in zip(layer.places, layer.words, strict=True):
        ax.annotate(word, place, (right, role.raised + up), textcoords="offset points", **look)
