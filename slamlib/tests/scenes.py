"""Snapshots made by hand for the tests of the pictures: a robot on a circle among points and segments."""

from dataclasses import replace

import numpy as np

from slamlib.geometry.quaternion import exponential
from slamlib.landmarks.euc_point import EUC_POINT
from slamlib.observation.points import observe
from slamlib.records.inputs import Features, Scan, Truth, World
from slamlib.records.snapshots import MapView, MeasurementView, RobotView, SensorView, Snapshot
from slamlib.rigs.setup import SensorSetup


def measurements(ids: np.ndarray, *columns, **more) -> MeasurementView:
    """Measurements of a sensor; fields that not every one has are nan or None unless given."""
    n = len(ids)
    none = {"endpoints": np.full((n, 2, 2), np.nan), "endpoint_covariances": np.full((n, 2, 2, 2), np.nan)}
    none |= {"scores": np.full(n, np.nan), "predicted_patch": (None,) * n, "found_patch": (None,) * n}
    return MeasurementView(ids, *columns, **{**none, **more})


NO_LOOKS = measurements(
    np.zeros(0, np.int64),
    (),
    np.zeros((0, 4)),
    np.zeros((0, 2, 2)),
    np.zeros((0, 4)),
    *[np.zeros(0, bool)] * 3,
    np.zeros(0),
)


def world(segments: bool = True) -> World:
    """Two storeys of points around a square, and a frame of segments in its middle."""
    side = np.linspace(-6, 6, 7)
    ring = [(x, y) for x in side for y in side if max(abs(x), abs(y)) > 3.5]
    points = np.array([(x, y, z) for z in (0.0, 1.0) for x, y in ring])
    corners = np.array([[-2, -2], [2, -2], [2, 2], [-2, 2]], float)
    lines = [[*a, z, *b, z] for z in (0.0, 2.0) for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)]
    lines += [[*a, 0.0, *a, 2.0] for a in corners]
    ids = np.arange(1, len(points) + 1)
    if not segments:
        return World({"points": Features(ids, points)})
    return World(
        {"points": Features(ids, points), "segments": Features(len(ids) + 1 + np.arange(len(lines)), np.array(lines))}
    )


def truth(number: int, setup: SensorSetup | None = None) -> Truth:
    """The robot after so many frames on a circle of radius 5 m, and its sensor's extrinsics."""
    turn = np.radians(-90 + 0.9 * number)
    position = 5.1 * np.array([np.cos(turn), np.sin(turn), 0.0])
    pose = np.concatenate([position, exponential(np.array([0, 0, turn + np.pi / 2]))])
    return Truth((pose,), ((setup or SensorSetup(position=(0, 0, 0.6))).extrinsics,), (pose,))


def random_covariances(rng: np.random.Generator, count: int, std: float) -> np.ndarray:
    root = std * rng.normal(size=(count, 3, 3))
    return root @ np.swapaxes(root, 1, 2)


def snapshot(number: int = 40, seed: int = 1, setup: SensorSetup | None = None) -> Snapshot:
    """A snapshot with every outcome in it; the newest points are known as directions only."""
    rng = np.random.default_rng(seed)
    setup, real, all_there = setup or SensorSetup(position=(0, 0, 0.6)), truth(number, setup), world()
    pose = real.robots[0].copy()
    pose[:3] += 0.05 * rng.normal(size=3)
    P = np.diag([0.05, 0.03, 0.02, 0.01, 0.01, 0.02]) ** 2
    robot = RobotView("robot", pose, P, pose, P)
    count = len(all_there.points)
    converged = np.arange(count) % 3 > 0
    shapes = random_covariances(rng, count, 0.06)
    means = all_there.points.values + 0.1 * rng.normal(size=(count, 3))
    ray = (means[0] - pose[:3]) / np.linalg.norm(means[0] - pose[:3])
    means[0], shapes[0] = pose[:3] + 80 * ray, 1e4 * np.outer(ray, ray) + 1e-2 * np.eye(3)
    points = MapView(all_there.points.ids, ("x",) * count, means, shapes, converged)
    endpoints = all_there.segments.values.reshape(-1, 2, 3) + 0.03 * rng.normal(size=(len(all_there.segments), 2, 3))
    spread = random_covariances(rng, 2 * len(endpoints), 0.04).reshape(-1, 2, 3, 3)
    lines = MapView(
        all_there.segments.ids, ("y",) * len(endpoints), endpoints, spread, np.arange(len(endpoints)) % 3 > 0
    )
    sensor, predictions = setup.calibration, NO_LOOKS
    seen = observe(EUC_POINT, sensor, pose, setup.extrinsics, means)
    some = np.flatnonzero(seen.visible)
    predictions = _looks(rng, points, some, seen.value[some], 60.0 if setup.image else 0.01)
    scan = Scan({"points": Features(predictions.ids[predictions.matched], predictions.measured[predictions.matched])})
    image = None if setup.image is None else np.array(setup.image)
    view = SensorView(
        setup.name, 0, setup.extrinsics, np.zeros((6, 6)), image, scan, {"points": predictions, "segments": NO_LOOKS}
    )
    return Snapshot(number, 0.1 * number, (robot,), (view,), {"points": points, "segments": lines}, 6 + 3 * count)


def _looks(
    rng: np.random.Generator, points: MapView, some: np.ndarray, expected: np.ndarray, variance: float
) -> MeasurementView:
    size, count = expected.shape[1], len(some)
    root = np.sqrt(variance) * rng.normal(size=(count, size, size))
    covariance = root @ np.swapaxes(root, 1, 2) + 0.1 * variance * np.eye(size)
    step = np.linalg.cholesky(covariance) @ rng.normal(size=(count, size, 1))
    matched = np.arange(count) % 4 > 0
    inlier = matched & (np.arange(count) % 5 > 0)
    measured = np.where(matched[:, None], expected + np.where(inlier, 1, 4)[:, None] * step[..., 0], np.nan)
    return measurements(
        points.ids[some], ("x",) * count, expected, covariance, measured, matched, matched, inlier, 2 * inlier
    )


def with_segments(shown: Snapshot) -> Snapshot:
    """The same with three segments in the sensor's image: one not found, one used, one rejected.

    One endpoint of the last is out of view. The numbers are those of a new line and of two that have converged.
    """
    expected = np.array([[100, 80, 300, 90], [340, 300, 360, 100], [420, 400, 620, 300]], float)
    measured = expected + np.array([[np.nan], [3.0], [30.0]])
    matched, inlier = np.array([False, True, True]), np.array([False, True, False])
    endpoints = expected.reshape(-1, 2, 2) + 2.0
    endpoints[2, 1] = np.nan
    endpoint_covariances = np.where(np.isnan(endpoints)[..., None], np.nan, np.array([[90.0, 30.0], [30.0, 40.0]]))
    number, chosen = shown.segments.ids[[0, 1, 2]], np.ones(3, bool)
    predictions = measurements(
        number,
        ("y",) * 3,
        expected,
        np.ones((3, 2, 2)),
        measured,
        chosen,
        matched,
        inlier,
        inlier,
        endpoints=endpoints,
        endpoint_covariances=endpoint_covariances,
    )
    view = shown.sensors[0]
    scan = Scan({**view.scan.features, "segments": Features(number[1:], measured[1:])})
    return replace(
        shown, sensors=(replace(view, predictions={**view.predictions, "segments": predictions}, scan=scan),)
    )


def photograph(number: int = 0, width: int = 640, height: int = 480) -> np.ndarray:
    """A grey image (height, width) with all that makes overlays hard to read: white, black, a fine pattern, noise."""
    v, u = np.mgrid[:height, :width]
    image = 255.0 * u / width
    image[:, : width // 4] = np.where(((u + v + number) // 4) % 2, 250, 10)[:, : width // 4]
    image[height // 2 :, width // 2 :] = 255 - image[height // 2 :, width // 2 :]
    noisy = image + np.random.default_rng(number).normal(0, 12, image.shape)
    return np.clip(noisy, 0, 255).astype(np.uint8)


def with_photograph(shown: Snapshot) -> Snapshot:
    """The same with the output of a front end on images: an image, scores, patches, some not found."""
    view, rng = shown.sensors[0], np.random.default_rng(shown.number)
    predictions, image = view.points, photograph(shown.number)
    count = len(predictions.ids)
    chosen = predictions.matched | (np.arange(count) % 8 == 0)
    scores = np.where(chosen, np.where(predictions.inlier, 0.95, 0.6), np.nan)
    patches = [rng.uniform(0, 255, (11, 11)).round() if m else None for m in predictions.matched]
    found = [None if p is None else (0.5 * p + 40).astype(np.uint8) for p in patches]
    seen = replace(predictions, chosen=chosen, scores=scores, predicted_patch=tuple(patches), found_patch=tuple(found))
    scan = Scan(view.scan.features, image)
    return replace(shown, sensors=(replace(view, predictions={**view.predictions, "points": seen}, scan=scan),))


def run(frames: int) -> tuple[list[Snapshot], list[Truth]]:
    """Snapshots and truths of the first frames."""
    return [snapshot(i) for i in range(frames)], [truth(i) for i in range(frames)]


__all__ = ["photograph", "run", "snapshot", "truth", "with_photograph", "with_segments", "world"]
