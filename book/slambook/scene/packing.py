"""The frames of a run as little data: whole numbers of one unit of length, and of each frame what has changed."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from slambook.figures.paths import pieces
from slambook.scene.figures import asked_view, view_of
from slambook.scene.layers import Layer, lower
from slambook.scene.options import MapOptions
from slambook.scene.scene import above, bounds, ends_of, map_scene, size_of
from slambook.scene.view import NAMED
from slamlib.geometry.pose import from_frame
from slamlib.manifolds import Array
from slamlib.records.inputs import Truth, World
from slamlib.records.snapshots import Snapshot

KINDS = ("new point", "point", "new line", "line")
FINE = 1500  # units of length, at least, along the diagonal of what is shown
MOST = 10**7  # units: what is farther away is put there
STILL = ("ground", "world")  # layers that are the same in all frames
PAD = 3.0  # points around the axes of a figure


def packed(
    snapshots: Sequence[Snapshot],
    world: World | None,
    truths: Sequence[Truth],
    count: int,
    options: MapOptions,
    aspect: float,
) -> dict[str, Any]:
    """Everything that the script needs, of `count` snapshots evenly spread; `shown` has these snapshots."""
    corners = bounds(snapshots[-1], world, truths[-1] if truths else None, snapshots, options)
    unit = 10.0 ** np.floor(np.log10(np.linalg.norm(corners[1] - corners[0]) / FINE))
    pack = Packing(world, options, corners, float(unit))
    places = np.unique(np.linspace(0, len(snapshots) - 1, count).round().astype(int))
    before: dict[str, list[int]] = {}
    frames = []
    for i in places:
        frame, before = pack.frame(snapshots[i], truths[i] if truths else None, before)
        frames.append(frame)
    layers = {layer.role: layer for layer in pack.layers(snapshots[-1], None)}
    still = {
        role: {"lines": pack.polylines(layers[role].lines), "marks": pack.whole(layers[role].marks)}
        for role in STILL
        if role in layers
    }
    return {
        "pad": PAD,
        "perspective": options.perspective,
        "above": pack.whole(above(snapshots[-1], size_of(corners, options))),
        "kinds": KINDS,
        "views": pack.views(snapshots[-1], aspect),
        "still": still,
        "frames": frames,
        "shown": [snapshots[i] for i in places],
    }


class Packing:
    """Lengths as whole numbers of a unit [m]."""

    def __init__(self, world: World | None, options: MapOptions, corners: Array, unit: float) -> None:
        self.world, self.options, self.corners, self.unit = world, options, corners, unit

    def whole(self, values: Any) -> Any:
        """Lengths [m] as integers, in lists of the same shape."""
        return np.clip(np.rint(np.asarray(values) / self.unit), -MOST, MOST).astype(int).tolist()

    def layers(self, snapshot: Snapshot, truth: Truth | None) -> tuple[Layer, ...]:
        """The scene with the same ground and sizes in all frames."""
        return map_scene(snapshot, world=self.world, truth=truth, options=self.options, corners=self.corners)

    def polylines(self, lines: Array) -> list[Any]:
        """Polylines with rows of nan between as a list of lists."""
        return [self.whole(piece.T) for piece in pieces(lines.T)]

    def frame(
        self, snapshot: Snapshot, truth: Truth | None, before: dict[str, list[int]]
    ) -> tuple[dict[str, Any], dict[str, list[int]]]:
        """One frame, given the landmarks of the one before, and its own landmarks."""
        layers = {layer.role: layer for layer in self.layers(snapshot, truth)}
        rows = self.landmarks(snapshot)
        robots = layers["robot"]
        ahead = from_frame(snapshot.robots[0].pose, np.array([1.0, 0, 0])) - snapshot.robots[0].pose[:3]
        frame = {
            "said": f"frame {snapshot.number}, {snapshot.time:.1f} s, {len(rows)} landmarks",
            "heading": round(float(np.degrees(np.arctan2(ahead[1], ahead[0]))), 1),
            "at": self.whole([r.pose[:3] for r in snapshot.robots]),
            "true": self.whole([pose[:3] for pose in truth.poses]) if truth is not None else [],
            "lines": {role: self.polylines(layers[role].lines) for role in ("truth", "sensor", "robot")},
            "balls": [self.ball(*ball) for ball in zip(robots.means, robots.shapes, strict=True)],
            "landmarks": {i: row for i, row in rows.items() if before.get(i) != row},
            "gone": [i for i in before if i not in rows],
        }
        return frame, rows

    def landmarks(self, snapshot: Snapshot) -> dict[str, list[int]]:
        """Of each landmark its kind, and of its point or each endpoint three coordinates and six of its factor."""
        found = {}
        for view in snapshot.landmarks.values():
            family = ends_of(view) - 1
            shapes = self.options.sigmas**2 * self.options.ellipsoids * np.asarray(view.covariance)
            for i, number in enumerate(view.ids):
                means = np.reshape(view.geometry[i], (-1, 3))
                if np.isfinite(means).all():
                    balls = zip(means, np.reshape(shapes[i], (-1, 3, 3)), strict=True)
                    numbers = [n for ball in balls for n in self.ball(*ball)]
                    found["ps"[family] + str(number)] = [2 * family + bool(view.converged[i]), *numbers]
        return found

    def ball(self, mean: Array, shape: Array) -> list[int]:
        """Mean and lower triangular factor of an ellipsoid; zero for one that is not drawn."""
        return [*self.whole(mean), *self.whole(lower(np.where(np.isfinite(shape), shape, 0)))]

    def views(self, last: Snapshot, aspect: float) -> dict[str, Any]:
        """The named views by their names, first the one that the reader asked for."""
        asked, found = asked_view(self.options, last), dict[str, Any]()
        for name in [asked, *(n for n in NAMED if n != asked)]:
            view = view_of(replace(self.options, view=name, orbit=(0.0, 0.0)), last, self.corners, aspect)
            azimuth, _, follows = NAMED[name] if isinstance(name, str) else (view.azimuth, 0, False)
            found[name if isinstance(name, str) else "custom"] = {
                "azimuth": azimuth,
                "elevation": view.elevation,
                "field": view.field,
                "distance": self.whole(view.distance),
                "target": self.whole(view.target),
                "follows": follows,
            }
        return found
