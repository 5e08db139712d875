"""What one sensor's measurement update selects and gates, and what it leaves in the landmarks' histories."""

from dataclasses import replace

import numpy as np
import pytest

from slamlib.data.records import RobotMeasurement
from slamlib.experiments.presets import preset
from slamlib.kalman.chi_square import chi2_quantile
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
