"""Simulated sensors: what a sensor of any type delivers of a world, through the models that the filter uses as well."""

import numpy as np

from slamlib.data.records import Features, Scan, World
from slamlib.data.setup import SensorSetup
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import Pose, compose
from slamlib.kalman.linalg import frozen
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.landmarks.segments import clip, frustum, length, trim
from slamlib.manifolds import Array, Indices
from slamlib.simulation.faults import Clutter, Faults, swapped
from slamlib.simulation.occlusion import hidden, longest_seen
from slamlib.simulation.robots import drawn, root
from slamlib.simulation.streams import Streams


class SimulatedSensor:
    """A sensor as it really is. The true mount of an estimated one is drawn round the mean that the filter is told.

    Noise is drawn for all features of the world in each frame, seen or not: so it depends on the seed alone, and runs
    that differ in their faults, their paths or their filters meet the same noise.
    """

    def __init__(self, setup: SensorSetup, world: World, faults: Faults, shortest: float, streams: Streams) -> None:
        self.robot, self.world, self.faults, self.shortest = setup.robot, world, faults, shortest
        self.calibration, self.streams = setup.calibration, streams
        self.mount = frozen(drawn(Pose, setup.mount, setup.covariance, streams["mount"]))
        self.space = self.calibration.sensor.space
        self.root = root(self.calibration.noise)
        self.clutter = Clutter(self.calibration, _reach(world)) if faults.outlier else None
        self.planes = self._frustum(setup.name)

    def scan(self, robot: Array) -> Scan:
        """What it delivers when its robot is at a pose (7,)."""
        camera = compose(robot, self.mount)
        return Scan(self._points(camera), self._segments(camera))

    def _points(self, camera: Array) -> Features:
        points, size = self.world.points, len(self.root)
        noise = self.streams["points"].standard_normal((len(points), size)) @ self.root
        if not len(points):
            return Features.none(size)
        inside = EUC_POINT.to_frame(camera, points.values)
        seen = self.calibration.visible(inside) & ~hidden(points.values, self.world.faces, camera[:3])
        values = self.space.plus(self.calibration.project(inside[seen]), noise[seen])
        delivered = self.calibration.inside(values)
        return self._faulty(points.ids[seen][delivered], values[delivered], 1)

    def _segments(self, camera: Array) -> Features:
        """Cut at the image's border in the ideal image; then the lens, then noise at the ends that are left.

        The toolbox adds the noise before it cuts, at ends that may lie far outside: what is left of it at the border is
        a mean of the two ends' noise, which is smaller than the filter is told. The last cut here moves an end by the
        noise only, along its own segment, which leaves its distance from the line as it was to the first order.
        """
        segments, size = self.world.segments, len(self.root)
        if self.planes is None or not len(segments):
            return Features.none(4)
        noise = self.streams["segments"].standard_normal((len(segments), 2, size)) @ self.root
        ends, seen = longest_seen(segments.values.reshape(-1, 2, 3), self.world.faces, camera[:3])
        inside = EUC_POINT.to_frame(camera, ends)
        *cut, within = clip(inside[:, 0], inside[:, 1], self.planes)
        points = np.concatenate([np.stack(cut, 1), np.ones((len(ends), 2, 1))], -1)
        seen = seen & within & self.calibration.visible(points).all(-1)
        exact = self.calibration.project(points[seen]).reshape(-1, 4)
        measured = trim(exact + noise[seen].reshape(-1, 4), tuple(self.calibration.image), minimum_length=0)
        found = measured.seen & (length(exact) >= self.shortest)
        pixels = np.clip(measured.pixels[found], 0, np.tile(self.calibration.image, 2))  # the cut's own rounding
        return self._faulty(segments.ids[seen][found], pixels, 2)

    def _faulty(self, ids: Indices, values: Array, parts: int) -> Features:
        """The same features with faults; an outlier is made of so many parts (the two ends of a segment)."""
        rng, faults = self.streams["faults"], self.faults
        miss, replace = rng.random((2, len(ids)))
        if self.clutter is not None:
            values = values.copy()
            for row in np.flatnonzero(replace < faults.outlier):
                values[row] = np.concatenate([self.clutter.draw(rng) for _ in range(parts)])
        found = miss >= faults.miss
        return Features(swapped(ids[found], faults.swap, rng), values[found])

    def _frustum(self, name: str) -> Array | None:
        """The planes that bound what it sees of segments, or None if it sees none."""
        calibration = self.calibration
        if calibration.sensor.project_line is None:
            return None
        if calibration.image is None and len(self.world.segments):
            raise SlamlibError(f"{name}: segments are cut at the border of the image; give the setup an image")
        return None if calibration.image is None else frustum(calibration.given["intrinsics"], calibration.image)


def _reach(world: World) -> float:
    """The size of the world [m], from corner to corner, at least 1."""
    places = np.concatenate([world.points.values, world.segments.values.reshape(-1, 3)])
    return max(1.0, float(np.linalg.norm(np.ptp(places, axis=0)))) if len(places) else 1.0
