"""One frame's measurement update beside the textbook's EKF: dense matrices of all rows, differences as Jacobians."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from slamlib.experiments.presets import preset
from slamlib.geometry.pose import Pose
from slamlib.geometry.quaternion import rotation
from slamlib.tests.compared import shaken

FOCAL, CENTRE, STD = 320.0, np.array([320.0, 240.0]), 1.0  # of the presets' camera, which does not distort


def projected(point, robot, extrinsics):
    """Pixel of a point (3,) in the world, for a camera on a robot."""
    in_robot = rotation(robot[3:]).T @ (point - robot[:3])
    x, y, z = rotation(extrinsics[3:]).T @ (in_robot - extrinsics[:3])
    return CENTRE + FOCAL * np.array([x, y]) / z


def point_residual(landmark, robot, extrinsics, measured):
    """Measured minus predicted pixel; landmark: anchor, direction, inverse distance."""
    return measured - projected(landmark[:3] + landmark[3:6] / landmark[6], robot, extrinsics)


def line_residual(landmark, robot, extrinsics, measured):
    """Distances [px] of the measured segment's two ends from the line; landmark: anchor, and direction and inverse
    distance of each end."""
    (u, v), (p, q) = (
        projected(landmark[:3] + end[:3] / end[3], robot, extrinsics) for end in (landmark[3:7], landmark[7:])
    )
    normal = np.array([q - v, u - p]) / np.hypot(p - u, q - v)
    return (measured.reshape(2, 2) - [u, v]) @ normal


RESIDUALS = {"points": point_residual, "lines": line_residual}
KINDS = {"points": {"points": "ahmPnt"}, "lines": {"lines": "ahmLin"}}


def differences(function, size, by=1e-6):
    """Central differences (m, size) of a function of `size` numbers, at zero."""
    return np.array([(function(by * e) - function(-by * e)) / (2 * by) for e in np.eye(size)]).T


def textbook(slam, residual, predictions, P, blocks, means):
    """Mean and covariance (N, N) after the update by these measurements together, at these means of all blocks.

    The sign of a line's distances is that of its normal, which no result depends on.
    """
    sensor = slam.sensors[0]
    places = {id(block): i for i, block in enumerate(blocks)}

    def z(step, noise):
        now = [b.manifold.plus(mean, step[b.slice]) for b, mean in zip(blocks, means, strict=True)]
        rows = noise.reshape(len(predictions), -1)
        return np.concatenate([
            residual(now[places[id(p.landmark.block)]], now[0], sensor.given_extrinsics, p.measured + row)
            for p, row in zip(predictions, rows, strict=True)
        ])  # fmt: skip

    N, M = len(P), sum(len(p.measured) for p in predictions)
    H = -differences(lambda step: z(step, np.zeros(M)), N)
    by_pixels = differences(lambda noise: z(np.zeros(N), noise), M)
    S = H @ P @ H.T + STD**2 * by_pixels @ by_pixels.T
    K = P @ H.T @ np.linalg.inv(S)
    step = K @ z(np.zeros(N), np.zeros(M))
    return [b.manifold.plus(m, step[b.slice]) for b, m in zip(blocks, means, strict=True)], (np.eye(N) - K @ H) @ P


@pytest.mark.parametrize("reproject", [True, False])
@pytest.mark.parametrize("family", KINDS)
def test_one_frame_updates_as_the_textbook_says(family, reproject):
    p = preset(family)
    options = replace(p.options, **KINDS[family], reproject=reproject, gate=1.0, convert=False, extend=False, updates=6)
    p = shaken(p, frames=12, options=replace(options, max_new_first=6))
    slam, (*frames, last) = p.slam(), [frame for frame, _ in p.simulate()]
    for frame in frames:
        slam.step(frame)
    slam.predict(last.controls, last.dt)
    blocks, P = slam.belief.blocks, slam.belief.matrix.copy()
    means = [block.mean.copy() for block in blocks]
    slam.predictions[0] = slam.project()
    chosen = sorted(slam.predictions[0], key=lambda one: -np.linalg.det(one.S))[:6]
    slam._update(0, last.scans[0])

    used = [one for one in chosen if one.matched]
    assert len(used) >= 5
    assert all(one.inlier for one in used)
    predicted = P
    for group in [[one] for one in used] if reproject else [used]:
        means, P = textbook(slam, RESIDUALS[family], group, P, blocks, means)
    assert np.abs(P - predicted).max() > 0.1 * np.abs(predicted).max()
    spread = np.sqrt(predicted.diagonal())
    for block, mean in zip(blocks, means, strict=True):
        assert np.abs(block.manifold.minus(block.mean, mean) / spread[block.slice]).max() < 1e-6
    assert np.abs((slam.belief.matrix - P) / np.outer(spread, spread)).max() < 1e-6


@pytest.mark.parametrize("family", KINDS)
def test_a_new_landmark_is_as_uncertain_as_the_textbook_says(family):
    """J P J' + J R J' + J Q J', of robot, measurement and prior, with differences as Jacobians."""
    p = preset(family)
    options = replace(p.options, **KINDS[family], inverse_distance=(0.2, 0.05))
    p = shaken(p, frames=1, options=replace(options, max_new_first=3))
    ((frame, _),) = p.simulate()
    slam = p.slam()
    slam.step(frame)
    sensor, robot, P = slam.sensors[0], slam.robots[0].block, slam.belief.matrix
    name = "points" if family == "points" else "segments"
    features = frame.scans[0].features[name]
    rows, mean = dict(zip(features.ids.tolist(), features.values, strict=True)), robot.mean
    assert len(slam.landmarks) == 3
    for landmark in slam.landmarks:
        y, kind, count = rows[landmark.id], landmark.kind, 1 if family == "points" else 2

        def made(step, noise, prior, y=y, kind=kind):
            robot.mean = Pose.plus(mean, step)
            both = {"ahmLin": (tuple(0.2 + prior), (0.05, 0.05))} if len(prior) == 2 else {}
            changed = replace(options, inverse_distance=(0.2 + prior[0], 0.05), line_priors=both)
            return slam.families[name].initialize(sensor, kind, y + noise, changed)[0]

        no_step, no_noise, no_prior = np.zeros(6), np.zeros(len(y)), np.zeros(count)
        by_robot = differences(partial(made, noise=no_noise, prior=no_prior), 6)
        by_pixels = differences(lambda noise, made=made, at=no_prior: made(np.zeros(6), noise, at), len(y))
        by_prior = differences(partial(made, no_step, no_noise), count)
        robot.mean = mean
        own = by_robot @ P[:6, :6] @ by_robot.T + STD**2 * by_pixels @ by_pixels.T + 0.05**2 * by_prior @ by_prior.T
        assert np.allclose(slam.belief.covariance(landmark.block), own, rtol=1e-6, atol=1e-9)
        assert np.allclose(slam.belief.covariance(landmark.block, robot), by_robot @ P[:6, :6], rtol=1e-6, atol=1e-9)
