"""What one sensor's measurement update selects and gates, and what it leaves in the landmarks' histories."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.belief import Belief
from slamlib.errors import CovarianceError
from slamlib.experiments.presets import preset
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.records.inputs import RobotMeasurement
from slamlib.slam.measurement_update import update_by_robot
from slamlib.tests.test_seams import compass, gps


def stepped(name, frames=8, **options):
    """The filter after some frames of a preset, and its landmarks' histories before the last one."""
    p = preset(name)
    p = replace(p, frames=frames, options=replace(p.options, **options))
    slam, before = p.slam(), {}
    for frame, _ in p.simulate():
        before = {lm: (lm.searched, lm.matched, lm.inliers) for lm in slam.landmarks}
        slam.step(frame)
    return slam, before


def test_as_many_are_searched_for_as_the_options_say_the_most_uncertain_ones():
    slam, before = stepped("points", updates=3)
    shown = slam.predictions[0]
    chosen = [prediction for prediction in shown if prediction.chosen]
    assert len(shown) > 6
    assert len(chosen) == 3
    others = [np.linalg.det(prediction.S) for prediction in shown if not prediction.chosen]
    assert min(np.linalg.det(prediction.S) for prediction in chosen) > max(others)
    for prediction in shown:
        searched, matched, inliers = before[prediction.landmark]
        lm = prediction.landmark
        assert lm.searched - searched == prediction.chosen
        assert lm.matched - matched == prediction.matched
        assert lm.inliers - inliers == prediction.inlier
        assert np.isnan(prediction.measured).all() == np.isnan(prediction.nis) == (not prediction.matched)


@pytest.mark.parametrize("measure", [compass, gps])
def test_the_gate_of_a_robot_s_measurement_is_of_its_own_degrees_of_freedom(measure):
    """Just inside the gate it is used, just outside not; 2 and 3 numbers, not the 6 of the pose."""
    p = preset("points")
    for share in (0.99, 1.01):
        unsure = replace(p.rig.robots[0], position_std=(0.3,), orientation_std=(2.0,))
        slam = replace(p, rig=replace(p.rig, robots=(unsure,))).slam()
        robot, P = slam.robots[0], slam.belief.matrix.copy()
        value, (J,) = measure.jac(robot.pose)
        R = 0.01 * np.eye(len(value))
        weight = np.linalg.inv(J @ P @ J.T + R)[0, 0]
        off = np.zeros(len(value))
        off[0] = np.sqrt(share * chi2_quantile(p.options.gate, len(value)) / weight)
        measured = RobotMeasurement("own", measure, value + off, R)
        found = update_by_robot(slam.belief, robot, measured, None, p.options)
        assert found.nis == pytest.approx(off @ off * weight)
        assert found.inlier == (share < 1)
        assert np.array_equal(slam.belief.matrix, P) == (share > 1)


def test_a_robot_s_measurement_updates_that_robot_and_the_others_by_their_correlation():
    """The second of two robots: the textbook's update by a Jacobian over all rows, zero but for that robot's."""
    p = replace(preset("two_robots"), frames=4)
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    second, P, blocks = slam.robots[1], slam.belief.matrix.copy(), slam.belief.blocks
    means, place = [block.mean.copy() for block in blocks], second.block.start
    value, (J,) = gps.jac(second.pose)
    H, R, z = np.zeros((3, len(P))), 1e-4 * np.eye(3), np.array([0.01, -0.02, 0.03])
    H[:, place : place + 6] = J
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    measured = RobotMeasurement("gps", gps, value + z, R)
    found = update_by_robot(slam.belief, second, measured, None, replace(p.options, gate=1.0))
    assert found.inlier
    assert found.nis == pytest.approx(z @ np.linalg.solve(S, z))
    assert np.allclose(found.covariance, S, rtol=1e-9, atol=0)
    for block, mean in zip(blocks, means, strict=True):
        step = (K @ z)[block.slice]
        assert np.allclose(block.manifold.minus(block.mean, mean), step, atol=1e-6 * np.abs(step).max() + 1e-12)
    assert np.allclose(slam.belief.matrix, P - K @ H @ P, atol=1e-9 * np.abs(P).max())


def test_what_lies_exactly_on_the_gate_is_refused_by_belief_and_prediction_alike():
    belief, slam = Belief(), stepped("points")[0]
    belief.add(1, np.zeros(1), np.full((1, 1), 3.0))
    one = slam.predictions[0][0]
    inliers = one.landmark.inliers
    with belief.sequential_update() as sequence:
        nis = sequence.update(np.arange(1), np.ones((1, 1)), np.full(1, 6.0), np.ones((1, 1)), 9.0).nis
    assert nis == 9.0  # 6 * 6 / (3 + 1)
    one.apply_gate(nis, 9.0)
    assert belief.matrix == 3.0
    assert not one.inlier
    assert one.landmark.inliers == inliers
    one.apply_gate(np.nextafter(nis, 0), 9.0)
    assert one.inlier
    assert one.landmark.inliers == inliers + 1


def test_a_sequence_takes_no_negative_noise_and_changes_nothing():
    belief = Belief()
    belief.add(1, [0.0], [[2.0]])
    negative = pytest.raises(CovarianceError, match=r"R has the negative variance -0\.5")
    with belief.sequential_update() as sequence, negative:
        sequence.update(np.array([0]), np.eye(1), np.array([1.0]), np.array([[-0.5]]))
    assert belief.matrix.tolist() == [[2]]


@pytest.mark.parametrize(
    ("P", "words"),
    [([[1, 2], [0, 1]], "not symmetric"), ([[1, 0], [0, -1e-3]], r"variance -0\.001 at index 1")],
)
def test_a_stored_covariance_that_is_none_is_refused(P, words):
    belief = Belief()
    place = belief.add(2, [0.0, 0], np.eye(2))
    with pytest.raises(CovarianceError, match=words):
        belief.overwrite({0: place}, {0: np.zeros(2)}, np.array(P, dtype=float))
    assert (belief.matrix == np.eye(2)).all()
