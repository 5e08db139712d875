"""The map in space: a snapshot, and if they are known the world and the truth, as layers of lines, marks and words.

There is no code for single types here: a landmark comes as a point or as two endpoints, with covariances.
"""

from collections.abc import Sequence

import numpy as np

from slambook.scene.layers import Layer, strung
from slambook.scene.options import MapOptions
from slamlib.geometry.pose import compose, from_frame
from slamlib.manifolds import Array, Image
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import MapView, Snapshot

Lines = tuple[tuple[tuple[float, float, float], ...], ...]
# Polylines in units of a robot's size. Of a robot, in its axes: front, left, up.
WEDGE: Lines = (
    ((1, 0, 0), (-0.6, 0.5, 0), (-0.6, -0.5, 0), (1, 0, 0), (-0.5, 0, 0.4), (-0.6, 0.5, 0)),
    ((-0.5, 0, 0.4), (-0.6, -0.5, 0)),
)
# Of a camera, in its axes: right, down, front; its image is one wide, and one high before its shape is known.
PYRAMID: Lines = (
    ((-0.4, -0.4, 0.6), (0.4, -0.4, 0.6), (0.4, 0.4, 0.6), (-0.4, 0.4, 0.6), (-0.4, -0.4, 0.6)),
    ((-0.4, -0.4, 0.6), (0, 0, 0), (0.4, -0.4, 0.6)),
    ((0.4, 0.4, 0.6), (0, 0, 0), (-0.4, 0.4, 0.6)),
)
# Of a sensor without an image: its axes.
CROSS: Lines = (((-0.3, 0, 0), (0.3, 0, 0)), ((0, -0.3, 0), (0, 0.3, 0)), ((0, 0, -0.3), (0, 0, 0.3)))
ABOVE = 0.5  # of a robot's size: how far labels are above what they name
WIDE = 0.04  # of the diagonal of all that there is: a robot's size
FAR = 5.0  # times as far away as half of the landmarks: what lies beyond may leave a picture without a world
GRID = 10  # squares of the ground along its longer side, about


def map_scene(
    snapshot: Snapshot,
    *,
    world: World | None = None,
    truth: Truth | None = None,
    path: Sequence[Snapshot] = (),
    true_path: Sequence[Truth] = (),
    options: MapOptions | None = None,
    corners: Array | None = None,
) -> tuple[Layer, ...]:
    """The layers of the map, those that lie below first.

    world: what there is to see. truth: the true state at this frame. path, true_path: all frames up to now, of which
    the robots' positions are drawn as lines. corners: as `bounds` returns them, if many frames are to have the same.
    """
    options = options or MapOptions()
    corners = bounds(snapshot, world, truth, path, options) if corners is None else corners
    size = size_of(corners, options)
    cones = (_sensor(snapshot.camera(i), view.image, size) for i, view in enumerate(snapshot.sensors))
    edges = world.segments.values.reshape(-1, 2, 3) if world is not None else ()
    layers = [
        *([_ground(corners)] if options.ground else []),
        *([Layer("world", strung(edges, 3), world.points.values)] if world is not None and options.world else []),
        _truth(snapshot, truth, true_path, size),
        *(layer for view in snapshot.landmarks.values() for layer in _landmarks(view, options)),
        Layer("sensor", strung([line for cone in cones for line in cone], 3)),
        _robots(snapshot, path, size, options),
        *([_labels(snapshot, size)] if options.labels else []),
    ]
    return tuple(layers)


def bounds(
    snapshot: Snapshot, world: World | None, truth: Truth | None, path: Sequence[Snapshot], options: MapOptions
) -> Array:
    """The least and the greatest x, y, z (2, 3) of what a picture should show.

    That is the world and the robots; without a world the landmarks, as far as they are known to a fifth of their
    distance, for the others may be anywhere, and as far as they are not much farther away than most.
    """
    robots = [r.pose[:3] for s in (*path[:: max(len(path) // 50, 1)], snapshot) for r in s.robots]
    true = [pose[:3] for pose in truth.poses] if truth is not None else []
    seen = [_known(snapshot)] if world is None else [world.points.values, world.segments.values.reshape(-1, 3)]
    points = np.concatenate([np.reshape([*robots, *true], (-1, 3)), *seen])
    low, high = points.min(axis=0), points.max(axis=0)
    if options.limits is not None:
        low[:2], high[:2] = -options.limits, options.limits
    least = 0.05 * max(float((high - low).max()), 1.0)
    middle, half = (low + high) / 2, np.maximum((high - low) / 2, least)
    return np.stack([middle - half, middle + half])


def size_of(corners: Array, options: MapOptions) -> float:
    """How large a robot is drawn [m]."""
    return options.size or WIDE * float(np.linalg.norm(corners[1] - corners[0]))


def _known(snapshot: Snapshot) -> Array:
    """Points and endpoints (N, 3) that are known well; without those that lie much farther away than most."""
    views = snapshot.landmarks.values()  # of points, or of two endpoints each
    means = np.concatenate([np.reshape(view.geometry, (-1, 3)) for view in views])
    shapes = np.concatenate([np.reshape(view.covariance, (-1, 3, 3)) for view in views])
    spread = np.sqrt(np.trace(shapes, axis1=1, axis2=2))
    away = np.linalg.norm(means - snapshot.robots[0].pose[:3], axis=1)
    with np.errstate(invalid="ignore"):
        known = spread < 0.2 * away
    return means[known & (away < FAR * np.median(away[known]))] if known.any() else means[:0]


def ends_of(view: MapView) -> int:
    """1 for a family of points, 2 for one of segments, whatever its name."""
    return np.ndim(view.geometry) - 1


def _ground(corners: Array) -> Layer:
    """A square grid at the height of the lowest thing, with lines at whole steps."""
    (x0, y0, z), (x1, y1, _) = corners
    rough = max(x1 - x0, y1 - y0) / GRID
    step = min((m for m in np.outer([1, 2, 5], 10.0 ** np.arange(-6, 7)).ravel() if m >= rough), default=rough)
    x = step * np.arange(np.floor(x0 / step), np.ceil(x1 / step) + 1)
    y = step * np.arange(np.floor(y0 / step), np.ceil(y1 / step) + 1)
    lines = [[[v, y[0], z], [v, y[-1], z]] for v in x] + [[[x[0], v, z], [x[-1], v, z]] for v in y]
    return Layer("ground", lines=strung(np.array(lines), 3))


def _truth(snapshot: Snapshot, truth: Truth | None, path: Sequence[Truth], size: float) -> Layer:
    lines = list(_tracks([[pose[:3] for pose in t.poses] for t in path]))
    if truth is not None:
        lines += [line for pose in truth.poses for line in _placed(pose, WEDGE, size)]
        for view, extrinsics in zip(snapshot.sensors, truth.extrinsics, strict=True):
            lines += _sensor(compose(truth.poses[view.robot], extrinsics), view.image, size)
    return Layer("truth", lines=strung(lines, 3))


def _tracks(positions: Sequence[Sequence[Array]]) -> Array:
    """For each robot the line (T, 3) through its positions."""
    return np.swapaxes(np.array(positions, dtype=float), 0, 1) if len(positions) > 1 else np.zeros((0, 0, 3))


def _landmarks(view: MapView, options: MapOptions) -> list[Layer]:
    """The landmarks of a family, of points or of two endpoints each, that are new, and those that have converged."""
    found, role = [], ("point", "line")[ends_of(view) - 1]
    for name, some in ((f"new {role}", ~view.converged), (role, view.converged)):
        geometry = np.asarray(view.geometry)[some]
        means, shapes = np.reshape(geometry, (-1, 3)), np.reshape(np.asarray(view.covariance)[some], (-1, 3, 3))
        if not options.ellipsoids:
            shapes = np.full_like(shapes, np.nan)
        lines = strung(geometry, 3) if geometry.ndim == 3 else np.zeros((0, 3))
        marks = means if geometry.ndim == 2 else np.zeros((0, 3))
        found.append(Layer(name, lines, marks, means, options.sigmas**2 * shapes))
    return found


def _sensor(pose: Array, image: Image | None, size: float) -> list[Array]:
    """A pyramid with the shape of the image, or a cross."""
    if image is None:
        return _placed(pose, CROSS, size)
    return _placed(pose, PYRAMID, size * np.array([1.0, image[1] / image[0], 1.0]))


def _placed(pose: Array, lines: Lines, size: float | Array) -> list[Array]:
    """Polylines of a frame at this pose, in the world."""
    return [from_frame(pose, size * np.array(line, dtype=float)) for line in lines]


def _robots(snapshot: Snapshot, path: Sequence[Snapshot], size: float, options: MapOptions) -> Layer:
    tracks = _tracks([[r.pose[:3] for r in s.robots] for s in path])
    wedges = [line for robot in snapshot.robots for line in _placed(robot.pose, WEDGE, size)]
    means = np.array([robot.pose[:3] for robot in snapshot.robots])
    shapes = options.sigmas**2 * np.array([robot.pose_covariance[:3, :3] for robot in snapshot.robots])
    lines = strung([*tracks, *wedges], 3)
    return Layer("robot", lines=lines, means=means, shapes=shapes if options.ellipsoids else shapes * np.nan)


def above(snapshot: Snapshot, size: float) -> Array:
    """From what is named to its label (3,): upwards, or north in a map in the plane, which is seen from above."""
    return ABOVE * size * np.array([0, 1, 0] if snapshot.plane else [0, 0, 1])


def _labels(snapshot: Snapshot, size: float) -> Layer:
    """The numbers of the landmarks, above each point and above the middle of each segment."""
    places, words, raised = [], [], above(snapshot, size)
    for view in snapshot.landmarks.values():
        for number, geometry in zip(view.ids, view.geometry, strict=True):
            places.append(np.reshape(geometry, (-1, 3)).mean(axis=0) + raised)
            words.append(str(number))
    return Layer("label", places=np.reshape(places, (-1, 3)), words=tuple(words))
