"""The second-order term of a predicted measurement: its derivatives, its variance, and what it is good for."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import UnknownNameError
from slamlib.evaluation.consistency import band, nees
from slamlib.experiments.presets import preset
from slamlib.geometry.pose import Pose, compose
from slamlib.kalman.linalg import principal_blocks
from slamlib.motions import MOTIONS
from slamlib.observation.second_order import second_derivatives, variance
from slamlib.slam import Options
from slamlib.slam.prediction import innovations
from slamlib.tests import test_plane_motions

CASES = {
    "extrinsics estimated": ("self_calibration", {"points": "ahmPnt"}),
    "angles": ("points", {"points": "idpPnt", "convert": False}),
    "homogeneous": ("points", {"points": "hmgPnt"}),
    "points and lines": ("points_and_lines", {}),
    "lines by angles": ("lines", {"lines": "plkLin", "innovation": "angles"}),
    "distance and angle": ("lines", {"lines": "aplLin", "innovation": "rhoThe"}),
}


def started(p, frames=3):
    """A filter after so many frames."""
    slam = p.slam()
    for frame, _ in replace(p, frames=frames).simulate():
        slam.step(frame)
    return slam


def with_options(name, **options):
    p = preset(name)
    return replace(p, options=replace(p.options, **options))


def in_the_plane():
    """A robot on the floor whose sensor's pose on it is estimated."""
    p = test_plane_motions.preset(MOTIONS["unicycle"])
    sensor = replace(p.rig.sensors[0], euler=(20, 10, 30), estimated=True, position_std=(0.1,), orientation_std=(1,))
    return replace(p, rig=replace(p.rig, sensors=(sensor,)))


def batches(slam):
    """Of each kind in view of the last sensor: its family, and the predicted batch."""
    sensor = len(slam.sensors) - 1
    found = {id(p.batch): (p.family, p.batch) for p in slam.project(sensor)}
    assert found
    return [(slam.sensors[sensor], *pair) for pair in found.values()]


def value_at(family, sensor, batch, step):
    """What is predicted (n, d) after a step (k,) of the rows of the covariance, by the models' values alone."""
    robot, kind = sensor.robot, batch.landmarks[0].kind
    of_robot, of_landmark = step[: len(robot.columns)], step[len(step) - kind.manifold.dof :]
    of_extrinsics = step[len(of_robot) : len(step) - len(of_landmark)]
    state = np.zeros(robot.motion.manifold.dof)
    state[: len(of_robot)] = of_robot
    pose = robot.motion.pose(robot.motion.manifold.plus(robot.block.mean, state))
    mounted = Pose.plus(sensor.extrinsics, of_extrinsics) if len(of_extrinsics) else sensor.extrinsics
    camera = compose(pose, mounted)
    found = []
    for landmark, measured in zip(batch.landmarks, batch.value, strict=True):
        there = kind.manifold.plus(landmark.block.mean, of_landmark)
        inner, _, J = family.observe(kind, sensor.calibration, camera, there)
        by = np.concatenate([J.camera, J.landmark], axis=-1)
        found.append(-family.residual(sensor, inner, by, measured, batch.options).z)
    return np.array(found)


@pytest.mark.parametrize("name", [*CASES, "plane"])
def test_second_derivatives_are_those_of_the_values(name):
    """Along random directions: the second difference of the values, in which no Jacobian appears."""
    slam = started(in_the_plane() if name == "plane" else with_options(CASES[name][0], **CASES[name][1]))
    rng, h = np.random.default_rng(4), 2e-4
    for sensor, family, batch in batches(slam):
        H2 = second_derivatives(family, sensor, batch, batch.value)
        assert np.array_equal(H2, H2.swapaxes(-1, -2))
        for _ in range(6):
            v = rng.standard_normal(batch.columns.shape[1])
            at = [value_at(family, sensor, batch, s * h * v) for s in (-2, -1, 0, 1, 2)]
            expected = (-at[0] + 16 * at[1] - 30 * at[2] + 16 * at[3] - at[4]) / (12 * h**2)
            found = np.einsum("ndij,i,j->nd", H2, v, v)
            np.testing.assert_allclose(found, expected, atol=3e-5 * np.abs(expected).max())


def test_the_variance_of_products_is_that_of_gaussians():
    """Of e1 e2: P11 P22 + P12^2; of e1^2 / 2: P11^2 / 2; and of both together, P11 P12."""
    P = np.array([[[2.0, 0.6, 0.1], [0.6, 0.5, 0.2], [0.1, 0.2, 1.0]]])
    H2 = np.zeros((1, 2, 3, 3))
    H2[0, 0, 0, 1] = H2[0, 0, 1, 0] = H2[0, 1, 0, 0] = 1
    expected = [[2.0 * 0.5 + 0.6**2, 2.0 * 0.6], [2.0 * 0.6, 2.0**2 / 2]]
    np.testing.assert_allclose(variance(H2, P)[0], expected, rtol=1e-14)


def test_it_is_noise_wherever_a_filter_asks_for_the_innovation():
    slam = started(with_options("self_calibration"))
    sensor, plain = slam.sensors[1], slam.project(1)
    slam.options = replace(slam.options, second_order="variance")
    pairs = list(zip(plain, slam.project(1), strict=True))
    assert len(pairs) > 5
    for before, after in pairs:
        P = principal_blocks(slam.belief.matrix, after.columns[None])
        batch = after.batch.take([after.row])
        added = variance(second_derivatives(after.family, sensor, batch, batch.value), P)[0]
        assert np.diag(added).min() > 0
        np.testing.assert_allclose(after.S - before.S, added, atol=1e-9 * np.abs(after.S).max())
        for p in (before, after):
            p.measured = p.value + 0.5
        one, anew = after.innovation(sensor), after.innovation_anew(sensor, slam.options)
        together = innovations(sensor, [after])[1]
        for found in (one.R, anew.R, together.R[0]):
            np.testing.assert_allclose(found - before.innovation(sensor).R, added, atol=1e-9)


def test_an_option_that_is_not_given_is_not_written():
    assert "second_order" not in Options().to_dict()
    given = Options(second_order="variance")
    assert Options.from_dict(given.to_dict()) == given
    with pytest.raises(UnknownNameError, match="second_order"):
        Options(second_order="variants")


@pytest.mark.parametrize("reproject", [True, False])
def test_two_unknown_factors_leave_the_extrinsics_consistent(reproject):
    """NEES of the extrinsics where inverse distances and they are both unknown, after two frames: 6 is right."""
    seeds, means = range(40), {}
    for name in (None, "variance"):
        p = replace(with_options("self_calibration", error="world", reproject=reproject, second_order=name), frames=2)
        found = []
        for seed in seeds:
            slam = p.slam()
            for frame, truth in p.simulate(np.random.default_rng([20, seed])):
                slam.step(frame)
                true = truth.extrinsics[1]
            block = slam.sensors[1].block
            found.append(nees(Pose.minus(true, block.mean), slam.belief.covariance(block)))
        means[name] = np.mean(found)
    low, high = band(6, len(seeds), 0.999)
    assert low < means["variance"] < high, means
    assert means[None] > 1.5 * high, means
