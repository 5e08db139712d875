"""Smoothing against GTSAM: the same graphs, built of its own factors, have the same optimum and covariances."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from slambook.smoothing import Smoother

from slamlib.experiments.presets import preset
from slamlib.geometry.quaternion import rotation

gtsam = pytest.importorskip("gtsam", reason="gtsam is fetched by `python -m book.tools.oracles`")
REAL = Path(os.environ.get("SLAMLIB_DATA") or "no-data") / "landmarks_victoria_park"


def pose3(pose):
    return gtsam.Pose3(gtsam.Rot3(rotation(pose[3:])), pose[:3])


def optimized(graph, initial):
    """GTSAM's optimum, to the last digits that it reaches."""
    parameters = gtsam.GaussNewtonParams()
    parameters.setRelativeErrorTol(1e-15)
    parameters.setAbsoluteErrorTol(1e-15)
    parameters.setLinearSolverType("MULTIFRONTAL_QR")  # what is all but exact needs the digits
    return gtsam.GaussNewtonOptimizer(graph, initial, parameters).optimize()


def odometry_factor(before, after, control, noise):
    """The noise in a control (dx, rotation vector): R1'(p2 - p1) - dx and log(R1'R2) - r; tangents rotate first."""

    def error(this, values, jacobians):
        one, two = (values.atPose3(key) for key in (before, after))
        R, d = one.rotation().between(two.rotation()), one.rotation().unrotate(two.translation() - one.translation())
        turn = gtsam.Rot3.Logmap(R)
        if jacobians is not None:
            right = gtsam.Rot3.LogmapDerivative(turn)
            skew = np.array([[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]])
            jacobians[0] = np.block([[skew, -np.eye(3)], [-right @ R.matrix().T, np.zeros((3, 3))]])
            jacobians[1] = np.block([[np.zeros((3, 3)), R.matrix()], [right, np.zeros((3, 3))]])
        return np.concatenate([d, turn]) - control

    return gtsam.CustomFactor(gtsam.noiseModel.Gaussian.Covariance(noise), [before, after], error)


def test_camera_and_odometry_as_gtsam_has_them():
    """One camera, whose measurements are GTSAM's own projection factors of Euclidean points."""
    p = preset("points")
    p = replace(p, frames=60, options=replace(p.options, points="idpPnt"))
    slam, frames = p.slam(), []
    smoother = Smoother(slam)
    for frame, _ in p.simulate():
        slam.step(frame)
        smoother.record(frame)
        frames.append(frame)
    found = smoother.solve()
    matches = smoother._usable([m for m in smoother._matches if m.inlier])
    assert {m.landmark for m in matches} == {lm for lm in slam.landmarks if lm.id in found.landmarks}

    graph, initial = gtsam.NonlinearFactorGraph(), gtsam.Values()
    graph.add(gtsam.PriorFactorPose3(0, pose3(slam.rig.robots[0].state), gtsam.noiseModel.Isotropic.Sigma(6, 1e-6)))
    for i, (frame, before) in enumerate(zip(frames, smoother._states[0], strict=False)):
        control = frame.controls[0]
        graph.add(odometry_factor(i, i + 1, control.value, control.covariance))
        initial.insert(i, pose3(before))
    initial.insert(len(frames), pose3(smoother._states[0][-1]))
    camera = slam.sensors[0]
    u0, v0, au, av = camera.calibration.given["intrinsics"]
    K, extrinsics = gtsam.Cal3_S2(au, av, 0, u0, v0), pose3(camera.extrinsics)
    pixels = gtsam.noiseModel.Gaussian.Covariance(camera.calibration.noise)
    for m in matches:
        key = gtsam.symbol("l", m.landmark.id)
        graph.add(gtsam.GenericProjectionFactorCal3_S2(m.measured, pixels, m.item, key, K, extrinsics))
    for number in found.landmarks:
        initial.insert(gtsam.symbol("l", number), found.point(number)[0] + 0.01)
    best = optimized(graph, initial)
    assert abs(2 * graph.error(best) - found.costs[-1]) < 1e-6

    marginals = gtsam.Marginals(graph, best)
    for i in (1, 20, 60):
        theirs, ours = best.atPose3(i), found.states[0][i]
        R = theirs.rotation().matrix()
        np.testing.assert_allclose(theirs.translation(), ours[:3], atol=1e-6)
        np.testing.assert_allclose(R, rotation(ours[3:]), atol=1e-6)
        T = np.block([[np.zeros((3, 3)), R], [np.eye(3), np.zeros((3, 3))]])
        covariance = T @ marginals.marginalCovariance(i) @ T.T
        mine = found.covariance(i - 1)
        assert np.abs(covariance - mine).max() < 1e-6 * np.abs(mine).max()
    for number in list(found.landmarks)[::5]:
        key, (position, P) = gtsam.symbol("l", number), found.point(number)
        np.testing.assert_allclose(best.atPoint3(key), position, atol=1e-6 * np.linalg.norm(position))
        np.testing.assert_allclose(marginals.marginalCovariance(key), P, atol=1e-5 * np.abs(P).max())


def car_factor(before, after, control, covariance, dt, laser):
    """The noise in (speed, rate of turn) between two poses of the laser; and the arc goes nowhere aside."""
    here = gtsam.Pose2(*laser[:2], 0).inverse()

    def residual(one, two):
        ahead, aside, turn = gtsam.Pose2.Logmap(one.compose(here).between(two.compose(here)))
        return np.array([ahead / dt - control[0], turn / dt - control[1], aside])

    def error(this, values, jacobians):
        poses = [values.atPose2(key) for key in (before, after)]
        if jacobians is not None:
            for i in range(2):
                columns = []
                for step in 1e-4 * np.eye(3):  # a smaller one is lost in the digits of hundreds of metres
                    ends = [[p.retract(sign * step) if j == i else p for j, p in enumerate(poses)] for sign in (1, -1)]
                    columns.append((residual(*ends[0]) - residual(*ends[1])) / 2e-4)
                jacobians[i] = np.stack(columns, axis=1)
        return residual(*poses)

    P = np.diag([0, 0, 1e-10])
    P[:2, :2] = covariance
    return gtsam.CustomFactor(gtsam.noiseModel.Gaussian.Covariance(P), [before, after], error)


@pytest.mark.skipif(not REAL.is_dir(), reason="set SLAMLIB_DATA to the folder that holds landmarks_victoria_park")
def test_a_piece_of_victoria_park_as_gtsam_has_it():
    """Range and bearing of trees from a car, all in the plane."""
    victoria_park = pytest.importorskip("slambook.victoria_park")
    frames = [f for f in victoria_park.load(REAL).frames if f.controls[0].value[0] > 0.5][:200]
    slam = victoria_park.park_slam()
    smoother = Smoother(slam)
    for number, frame in enumerate(frames):
        slam.step(replace(frame, number=number + 1))
        smoother.record(replace(frame, number=number + 1))
    found = smoother.solve()
    laser, std = slam.sensors[0].extrinsics, np.sqrt(slam.sensors[0].calibration.noise.diagonal())
    graph, initial = gtsam.NonlinearFactorGraph(), gtsam.Values()
    graph.add(gtsam.PriorFactorPose2(0, gtsam.Pose2(*laser[:2], 0), gtsam.noiseModel.Isotropic.Sigma(3, 1e-6)))

    def planar(state):
        return gtsam.Pose2(*state).compose(gtsam.Pose2(*laser[:2], 0))

    for i, frame in enumerate(frames):
        control = frame.controls[0]
        graph.add(car_factor(i, i + 1, control.value, control.covariance, frame.dt, laser))
    for i, state in enumerate(found.states[0]):
        initial.insert(i, planar(state))
    noise = gtsam.noiseModel.Diagonal.Sigmas(std[::-1].copy())
    used = smoother._usable([m for m in smoother._matches if m.inlier])
    for m in used:
        distance, yaw = m.measured
        key = gtsam.symbol("t", m.landmark.id)
        graph.add(gtsam.BearingRangeFactor2D(m.item, key, gtsam.Rot2(yaw), distance, noise))
        if not initial.exists(key):
            initial.insert(key, initial.atPose2(m.item).transformFrom(distance * gtsam.Rot2(yaw).matrix()[:, 0]))
    best = optimized(graph, initial)
    ours, theirs = [planar(s) for s in found.states[0]], [best.atPose2(i) for i in range(len(frames) + 1)]
    off = np.array([a.localCoordinates(b) for a, b in zip(ours, theirs, strict=True)])
    assert np.abs(off).max() < 1e-6
    lever = rotation(found.poses[-1, 0, 3:]) @ laser[:3]
    J = np.array([[1, 0, -lever[1]], [0, 1, lever[0]], [0, 0, 1]])
    mine = J @ found.covariance()[np.ix_([0, 1, 5], [0, 1, 5])] @ J.T
    T = np.eye(3)
    T[:2, :2] = theirs[-1].rotation().matrix()
    whole = graph.linearize(best).jacobian()[0]  # the poses come first; its normal equations are too ill-conditioned
    unit = np.eye(whole.shape[1])[:, 3 * len(frames) :][:, :3]
    half = np.linalg.solve(np.linalg.qr(whole, mode="r").T, unit)
    covariance = T @ half.T @ half @ T.T
    assert np.abs(covariance - mine).max() < 1e-5 * np.abs(mine).max()
