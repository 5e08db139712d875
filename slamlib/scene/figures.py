"""The two figures on the page: NumPy alone draws them, as SVG."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slamlib.drawing import Figure, figure
from slamlib.geometry.pose import from_frame
from slamlib.records import Truth, World
from slamlib.scene.image_scene import sensor_scene, sensor_view
from slamlib.scene.layers import Flat
from slamlib.scene.options import MapOptions, SensorOptions, chosen
from slamlib.scene.roles import ROLES, Role
from slamlib.scene.scene import bounds, map_scene
from slamlib.scene.view import NAMED, View
from slamlib.snapshots import Snapshot
from slamlib.spaces import Array

SHELL = 0.7  # width of the outlines of uncertainty, in that of the lines of their role
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
    look = chosen(MapOptions(), options)
    corners = bounds(snapshot, world, truth, path, look)
    shown: dict[str, Any] = {"world": world, "truth": truth, "path": path, "true_path": true_path}
    layers = map_scene(snapshot, **shown, options=look, corners=corners)
    view = view_of(look, snapshot, corners, width / height)
    fig, ax = figure(width=width, height=height)
    ax.axis("off")
    ax.set(xlim=(-width / height, width / height), ylim=(-1, 1), aspect="equal")
    draw(ax, view.flat(layers), ROLES["map"], look.legend)
    return fig


def view_of(options: MapOptions, snapshot: Snapshot, corners: Array, aspect: float) -> View:
    """The view that the options ask for, after the orbit of so many frames as the snapshot has behind it."""
    middle = tuple(float(v) for v in corners.mean(axis=0))
    box = _turned(corners) if any(options.orbit) else np.stack(np.meshgrid(*corners.T), axis=-1).reshape(-1, 3)
    if isinstance(options.view, str):
        azimuth, elevation, follows = NAMED[options.view]
        view = View(azimuth, elevation, target=middle, perspective=options.perspective).fitted(box, aspect)
        view = following(view, snapshot.robots[0].pose) if follows else view
    else:
        azimuth, elevation, field, *distance = (float(v) for v in options.view)
        view = View(azimuth, elevation, field, middle, perspective=options.perspective)
        view = replace(view, distance=distance[0]) if distance else view.fitted(box, aspect)
    return view.orbited(*(snapshot.number * np.asarray(options.orbit)))


def _turned(corners: Array) -> Array:
    """The edges (N, 3) of what a box passes through when it turns about the vertical: they fit from all sides."""
    middle, half = corners.mean(axis=0), (corners[1] - corners[0]) / 2
    turn = np.radians(np.arange(0, 360, 15))
    ring = np.stack([np.cos(turn), np.sin(turn)], axis=1) * np.hypot(half[0], half[1])
    return np.concatenate([np.column_stack([middle[:2] + ring, np.full(len(ring), z)]) for z in corners[:, 2]])


def following(view: View, pose: Array) -> View:
    """A view whose azimuth is counted from where a robot (7,) heads, nearer, and centred on it."""
    x, y, _ = from_frame(pose, np.array([1.0, 0, 0])) - pose[:3]
    target = tuple(float(v) for v in pose[:3])
    azimuth = view.azimuth + float(np.degrees(np.arctan2(y, x)))
    return replace(view, azimuth=azimuth, target=target, distance=CLOSER * view.distance)


def sensor_figure(
    snapshot: Snapshot, sensor: int | str = 0, *, width: float = 5.8, height: float = 4.3, **options: Any
) -> Figure:
    """What a sensor saw, as a figure of so many inches; the other keywords are those of SensorOptions."""
    look = chosen(SensorOptions(), options)
    view = sensor_view(snapshot, sensor)
    layers = sensor_scene(snapshot, sensor, options=look)
    fig, ax = figure(width=width, height=height)
    names = look.names or tuple(f"measured number {n}" for n in look.numbers)
    if view.image is not None:
        names = look.names or ("u [px]", "v [px]")
        ax.set(xlim=(0, view.image[0]), ylim=(view.image[1], 0), aspect="equal")
        if view.scan is not None and view.scan.image is not None:
            ax.imshow(view.scan.image)
    ax.set(xlabel=names[0], ylabel=names[1])
    draw(ax, layers, ROLES["sensor"], look.legend)
    return fig


def draw(ax: Any, layers: Sequence[Flat], roles: dict[str, Role], legend: bool) -> None:
    """Put layers into axes, in their order, each with its role's look."""
    for layer in layers:
        role, label = roles[layer.role], roles[layer.role].label
        stroke = {"color": role.color, "ls": role.linestyle, "alpha": role.alpha}
        if len(layer.shells):
            ax.plot(*layer.shells.T, lw=SHELL * role.width, **stroke)
        if len(layer.lines):
            ax.plot(*layer.lines.T, lw=role.width, label="" if len(layer.marks) else label, **stroke)
        if len(layer.marks):
            face = "none" if role.hollow else role.color
            look = {"ls": "", "marker": role.marker, "ms": role.size, "color": role.color, "mfc": face}
            ax.plot(*layer.marks.T, label=label, **look)
        look = {"color": role.color, "fontsize": role.size, "ha": "center", "va": "center", "clip_on": True}
        for place, word in zip(layer.places, layer.words, strict=True):
            ax.annotate(word, place, (0, role.raised), textcoords="offset points", **look)
    if legend:
        ax.legend(loc="outside upper", ncols=4, fontsize=9)
