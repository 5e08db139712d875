"""Which trades of robot and extrinsics a prediction keeps, by whose step; the steps of the proof in chapter many."""

import numpy as np
import pytest
from slambook.trade_carried import TradeCarried, after_step, correction, estimated_step, pose_of

from book.experiments import predictions
from slamlib.geometry.pose import ORIGIN, Pose, compose
from slamlib.motions import ODOMETRY
from slamlib.slam.unobservable import trade


@pytest.fixture
def rng():
    return np.random.default_rng(55)


def predicted(slam, control):
    """N of the trade before a step and after it, and the step's F, for a robot in the first six rows."""
    (robot,), (sensor,) = slam.robots, slam.sensors
    before = trade(slam.belief.size, sensor, sensor.block)
    end, J = ODOMETRY.step.jac(robot.block.mean, control, 0.1)
    F = np.eye(slam.belief.size)
    F[:6, :6] = J.state
    robot.block.mean = end
    return before, trade(slam.belief.size, sensor, sensor.block), F


def test_a_prediction_keeps_a_trade_that_commutes_with_its_step_and_no_other(rng):
    """F N(x) - N(x') = E(end) (Ad(U)^-1 - I) in the robot's rows, and nothing in those of the extrinsics."""
    slam = TradeCarried(predictions.RIG, options=predictions.options("world"))
    for _ in range(10):
        slam.robots[0].block.mean = Pose.random(rng)
        control = 0.3 * rng.standard_normal(6)
        before, after, F = predicted(slam, control)
        end, step = slam.robots[0].block.mean, pose_of(control)
        missed = F @ before - after
        np.testing.assert_allclose(missed[:6], after_step(end, step) - after_step(end, ORIGIN), atol=1e-12)
        np.testing.assert_allclose(missed[6:12], 0, atol=1e-12)


def test_a_prediction_with_the_correction_carries_trades_as_the_other_step_does(rng):
    slam = TradeCarried(predictions.RIG, options=predictions.options("world"))
    for _ in range(10):
        slam.robots[0].block.mean = Pose.random(rng)
        told, made = 0.3 * rng.standard_normal((2, 6))
        before, after, F = predicted(slam, told)
        end, extrinsics = slam.robots[0].block.mean, slam.sensors[0].block.mean
        corrected = F.copy()
        corrected[:6, 6:12] = correction(end, extrinsics, pose_of(told), pose_of(made))
        np.testing.assert_allclose((corrected @ before)[:6], after_step(end, pose_of(made)), atol=1e-12)
        corrected[:6, 6:12] = correction(end, extrinsics, pose_of(told), None)
        np.testing.assert_allclose(corrected @ before, after, atol=1e-12)


def test_straight_steps_in_three_directions_keep_trades_that_span_all_six():
    """Which the proof needs: each keeps the shifts and the turn about its own direction."""
    kept = []
    for direction in np.eye(3):
        step = pose_of(0.05 * np.concatenate([direction, np.zeros(3)]))
        commutator = after_step(step, step) - after_step(step, ORIGIN)
        _, s, V = np.linalg.svd(commutator)
        kept.append(V[s < 1e-12])
        assert len(kept[-1]) == 4
    assert np.linalg.matrix_rank(np.concatenate(kept)) == 6


def test_steps_near_one_that_turns_keep_trades_that_span_all_six():
    """Each keeps the shift along its axis and the turn about it, and axes that are near span all twists."""
    kept = []
    for change in 0.01 * np.eye(6):
        step = pose_of(np.array([0.1, 0, 0, 0, 0, 0.05]) + change)
        _, s, V = np.linalg.svd(after_step(step, step) - after_step(step, ORIGIN))
        kept.append(V[s < 1e-12])
        assert len(kept[-1]) == 2
        for twist in (Pose.plus(ORIGIN, 1e-6 * a) for a in kept[-1]):
            np.testing.assert_allclose(compose(step, twist), compose(twist, step), atol=1e-10)
    assert np.linalg.matrix_rank(np.concatenate(kept)) == 6


def test_twists_of_the_frame_before_a_step_displace_the_pose_after_it(rng):
    """compose(start exp(twist), step) by differences."""
    start, step = Pose.random(rng), pose_of(0.3 * rng.standard_normal(6))
    h, found = 1e-6, []
    for twist in np.eye(6):
        ends = [compose(compose(start, Pose.plus(ORIGIN, s * h * twist)), step) for s in (1, -1)]
        found.append(Pose.minus(ends[0], ends[1]) / (2 * h))
    np.testing.assert_allclose(after_step(compose(start, step), step), np.transpose(found), atol=1e-8)


def test_by_the_step_told_it_is_the_filter_itself():
    heard = predictions.frames(predictions.STRAIGHT[:12], 1)
    plain = predictions.filtered(heard, "world")
    told = predictions.carried(heard, lambda i: heard[i].controls[0].value)
    np.testing.assert_allclose(told, plain, rtol=1e-9)


def test_the_next_picture_knows_the_step_better():
    """By half of the variance that it could have told, at least, of the step's noise across the road."""
    heard = predictions.frames(predictions.STRAIGHT, 3)
    errors = predictions.carried_twice(heard)[1]
    told = np.array([frame.controls[0].value for frame in heard]) - predictions.STRAIGHT
    assert 0.4 < (errors[:, 1:3] ** 2).mean() / (told[:, 1:3] ** 2).mean() < 0.7


def test_an_update_that_tells_nothing_leaves_the_step_as_told():
    heard = predictions.frames(predictions.STRAIGHT[:3], 1)
    slam = TradeCarried(predictions.RIG, options=predictions.options("world"))
    for frame in heard:
        departure = slam.robots[0].block.mean
        slam.step(frame, update=False)
        control = frame.controls[0]
        np.testing.assert_array_equal(estimated_step(departure, control, slam.predicted, slam.belief), control.value)
