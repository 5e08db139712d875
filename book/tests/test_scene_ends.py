"""The endpoints of predicted segments in the image, with their covariances; and which lines have converged."""

from dataclasses import replace

import numpy as np
import pytest
from slambook.scene import SensorOptions, map_scene, sensor_scene

from slamlib.experiments.presets import preset
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.landmarks import LINES
from slamlib.observation.segments import CONVERGED_RATIO, endpoints_converged
from slamlib.rigs.setup import Rig
from slamlib.slam import snapshot
from slamlib.slam.snapshot import endpoints_in_image
from slamlib.tests import scenes


def stepped(frames, kind="idpLin", estimated=False, family="lines"):
    """The filter after some frames of a preset with lines, and its last snapshot."""
    chosen = preset(family)
    sensors = chosen.rig.sensors
    if estimated:
        sensors = tuple(replace(s, estimated=True, position_std=(0.02,), orientation_std=(1.0,)) for s in sensors)
    options = replace(chosen.options, lines=kind, max_new_first=6)
    chosen = replace(chosen, options=options, rig=Rig(chosen.rig.robots, sensors))
    slam = chosen.slam()
    for (frame, _), _ in zip(chosen.simulate(), range(frames), strict=False):
        slam.step(frame)
    return slam, slam.snapshot()


def projected(sensor, pose, extrinsics, landmark, mean):
    """The two endpoints in the image (2, 2) of a line with this mean, one after the other, by the definitions alone."""
    found = []
    for abscissa in landmark.abscissas:
        h = landmark.kind.point_at(mean, abscissa)
        point = from_world(extrinsics, from_world(pose, h))
        found.append(sensor.calibration.project(point))
    return np.array(found)


def from_world(pose, h):
    w, x, y, z = pose[3:]
    R = np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
    return np.append(R.T @ (h[:3] - h[3] * pose[:3]), h[3])


def propagated(slam, sensor, landmark, step=1e-6):
    """H P H' (2, 2, 2) with central differences along every direction of robot, extrinsics and line."""
    parts = {"robot": sensor.robot.block, "extrinsics": sensor.block, "line": landmark.block}
    parts = {name: block for name, block in parts.items() if block is not None}
    means = {"robot": sensor.robot.block.mean, "extrinsics": sensor.extrinsics, "line": landmark.block.mean}
    used = {name: 6 if name != "line" else block.dof for name, block in parts.items()}  # of a robot's state, its pose
    rows = np.concatenate([np.arange(block.start, block.start + used[name]) for name, block in parts.items()])
    columns = []
    for name, block in parts.items():
        for i in range(used[name]):
            endpoints = []
            for sign in (1, -1):
                moved = dict(means)
                moved[name] = block.manifold.plus(means[name], sign * step * np.eye(block.dof)[i])
                endpoints.append(projected(sensor, moved["robot"][:7], moved["extrinsics"], landmark, moved["line"]))
            columns.append((endpoints[0] - endpoints[1]) / (2 * step))
    H = np.moveaxis(np.array(columns), 0, -1)
    P = slam.belief.matrix[np.ix_(rows, rows)]
    return np.array([J @ P @ J.T for J in H])


@pytest.mark.parametrize("estimated", [False, True])
@pytest.mark.parametrize("kind", list(LINES))
def test_the_covariance_of_an_endpoint_is_that_of_robot_extrinsics_and_line_together(kind, estimated):
    slam, shown = stepped(6, kind, estimated)
    sensor, predictions = slam.sensors[0], shown.sensors[0].segments
    lines, checked = {lm.id: lm for lm in slam.landmarks}, 0
    for number, endpoints, endpoint_covariances in zip(
        predictions.ids, predictions.endpoints, predictions.endpoint_covariances, strict=True
    ):
        seen = np.isfinite(endpoints).all(axis=1)
        landmark = lines[number]
        pixels = projected(sensor, sensor.robot.pose, sensor.extrinsics, landmark, landmark.block.mean)
        assert endpoints[seen] == pytest.approx(pixels[seen], abs=1e-8)
        wanted = propagated(slam, sensor, landmark)[seen]
        assert endpoint_covariances[seen] == pytest.approx(wanted, rel=1e-4, abs=1e-5 * np.abs(wanted).max(initial=0))
        checked += seen.sum()
    assert checked >= 6


def test_ends_are_nan_for_points_and_for_what_is_not_there_or_not_in_view():
    slam, shown = stepped(4, "ahmLin", family="points_and_lines")
    predictions = shown.sensors[0].points
    assert len(predictions.ids) > 3
    assert predictions.endpoints.shape == (len(predictions.ids), 2, 2)
    assert predictions.endpoint_covariances.shape == (len(predictions.ids), 2, 2, 2)
    assert np.isnan(predictions.endpoints).all()
    assert np.isnan(predictions.endpoint_covariances).all()
    sensor = next(s for s, view in zip(slam.sensors, shown.sensors, strict=True) if len(view.segments.ids))
    lines = [lm for lm in slam.landmarks if lm.abscissas is not None]
    lines[0].abscissas = np.array([lines[0].abscissas[0], 1e4])
    slam.prune(lines[1])
    endpoints, endpoint_covariances = endpoints_in_image(slam.belief, sensor, lines)
    assert np.isnan(endpoints[0, 1]).all()
    assert np.isnan(endpoints[1]).all()
    assert np.isfinite(endpoint_covariances[np.isfinite(endpoints).all(-1)]).all()
    assert np.isfinite(endpoints[0, 0]).all()


def test_ends_are_a_picture_s_matter_and_cost_a_step_nothing(monkeypatch):
    slam, _ = stepped(2)
    frames = preset("lines").simulate()

    def forbidden(*arguments):
        raise AssertionError("in the step of the filter")

    monkeypatch.setattr(snapshot, "endpoints_in_image", forbidden)
    slam.step(next(iter(frames))[0])
    with pytest.raises(AssertionError, match="in the step"):
        slam.snapshot()


# -- new lines ---------------------------------------------------------------------------------------------------------


def test_a_line_has_converged_when_its_ends_are_known_to_a_share_of_its_length():
    geometry = np.tile(np.array([[0.0, 0, 0], [0, 2, 0]]), (4, 1, 1))
    covariance = np.tile(1e-6 * np.eye(3), (4, 2, 1, 1))
    covariance[1, 1, 2, 2] = (0.99 * CONVERGED_RATIO * 2) ** 2
    covariance[2, 0, 0, 0] = (1.01 * CONVERGED_RATIO * 2) ** 2
    geometry[3, 1], covariance[3, 1] = np.nan, np.nan
    assert endpoints_converged(geometry, covariance).tolist() == [True, True, False, False]
    assert endpoints_converged(np.zeros((0, 2, 3)), np.zeros((0, 2, 3, 3))).shape == (0,)


@pytest.mark.parametrize("kind", ["idpLin", "plkLin"])
def test_lines_are_new_when_initialized_and_are_drawn_so(kind):
    _, first = stepped(1, kind)
    assert len(first.segments.ids) == 6
    assert not first.segments.converged.any()
    _, later = stepped(60, kind)
    assert later.segments.converged.mean() > 0.5
    layers = {layer.role: layer for layer in map_scene(first)}
    assert len(layers["new line"].means) == 12
    assert not len(layers["line"].means)
    drawn = {layer.role: layer for layer in map_scene(later)}
    assert len(drawn["line"].means) == 2 * later.segments.converged.sum()
    both = {layer.role: layer for layer in sensor_scene(later)}
    predictions = later.sensors[0].segments
    known = dict(zip(later.segments.ids, later.segments.converged, strict=True))
    shown = np.isfinite(predictions.endpoints).all(-1).sum(1)
    assert len(both["point"].marks) == sum(n for i, n in zip(predictions.ids, shown, strict=True) if known.get(i))
    assert len(both["point"].marks) + len(both["new point"].marks) == shown.sum()


def test_ellipses_stand_at_the_ends_and_hold_the_share_of_the_gate():
    shown = scenes.with_segments(scenes.snapshot())
    only = replace(
        shown,
        sensors=(replace(shown.sensors[0], predictions={**shown.sensors[0].predictions, "points": scenes.NO_LOOKS}),),
    )
    layers = {layer.role: layer for layer in sensor_scene(only, options=SensorOptions(gate=0.9))}
    predictions = only.sensors[0].segments
    rings = layers["updated"].shells.reshape(-1)
    rings = rings[np.isfinite(rings)].reshape(2, -1, 2)
    assert rings[:, :-1].mean(axis=1) == pytest.approx(predictions.endpoints[1])
    for ring, spread in zip(
        rings - predictions.endpoints[1][:, None], predictions.endpoint_covariances[1], strict=True
    ):
        assert np.einsum("ni,ij,nj->n", ring, np.linalg.inv(spread), ring) == pytest.approx(chi2_quantile(0.9, 2))
    assert np.isnan(layers["rejected"].shells).sum() == 0  # one ring: the other end is out of view
    without = {layer.role: layer for layer in sensor_scene(only, options=SensorOptions(ellipses=False))}
    assert not len(without["updated"].shells)
