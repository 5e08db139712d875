"""The anchors' columns of N: no measurement tells them, and a filter that carries them along gains nothing on them."""

from dataclasses import replace
from unittest.mock import patch

import numpy as np
import pytest
from slambook.anchors import ANCHORS, anchors_carried, shifts, with_anchors
from slambook.filters_compared import WITH_ANCHORS, poses

from slamlib.experiments.presets import preset
from slamlib.geometry.pose import Pose
from slamlib.landmarks import LINES, POINTS
from slamlib.slam.transport import TRANSPORTS, Transport


def with_landmark(name, **options):
    """Seven frames of the preset of a parametrization, one batch update a frame."""
    family = "points" if name in POINTS else "lines"
    p = preset(family)
    return replace(p, frames=7, options=replace(p.options, reproject=False, convert=False, **{family: name}, **options))


def predictions(slam):
    return slam.project()


@pytest.mark.parametrize("name", ANCHORS)
def test_an_anchor_may_stand_anywhere(name):
    """The landmark, as a homogeneous point or a Plücker line in any frame, changes by its scale at most."""
    kind, rng = {**POINTS, **LINES}[name], np.random.default_rng(1)
    for pose in Pose.random(rng), Pose.random(rng):
        slam = with_landmark(name).slam()
        for frame, _ in with_landmark(name).simulate():
            slam.step(frame)
        states = np.array([landmark.block.mean for landmark in slam.landmarks])
        there, J = kind.to_frame.jac(pose, states)
        change = J.landmark @ shifts(kind, states)
        unit = there / np.linalg.norm(there, axis=-1, keepdims=True)
        across = change - unit[..., None] * (unit[:, None] @ change)
        assert np.abs(across).max() < 1e-9 * np.abs(J.landmark).max()


@pytest.mark.parametrize("name", ANCHORS)
def test_no_measurement_tells_where_an_anchor_stands(name):
    p = with_landmark(name)
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    N, rows = with_anchors(slam.state, slam.sensors[0])
    assert N.shape == (slam.belief.size, 6 + ANCHORS[name] * len(slam.landmarks))
    assert np.linalg.matrix_rank(N[rows]) == N.shape[1]
    for prediction in predictions(slam):
        found = prediction.family.batch_innovation(
            slam.sensors[0], prediction.batch.take([prediction.row]), prediction.value[None] + 1e-3
        )
        H, own = found.H[0], N[prediction.batch.columns[prediction.row]]
        assert np.abs(H @ own).max() < 1e-9 * np.abs(H).max() * np.abs(own).max()


@pytest.mark.parametrize("name", ANCHORS)
def test_an_update_gains_nothing_on_where_an_anchor_stands(name):
    """Of two filters one is unsure of the world's motion and of each anchor; it stays exactly as unsure.

    Lines are not put back on their constraint, which is done as seen from where the robot is: that leaves 2e-5 of it.
    """
    far, kind = {}, {**POINTS, **LINES}[name]
    free = replace(kind, constrain=None) if name in LINES else kind
    with patch.dict(TRANSPORTS, {WITH_ANCHORS: Transport(anchors_carried)}):
        for error in ("world", WITH_ANCHORS):
            p = with_landmark(name, error=error)
            *frames, last = [frame for frame, _ in p.simulate()]
            sure, unsure = p.slam(), p.slam()
            for slam in (sure, unsure):
                for frame in frames:
                    slam.step(frame)
                slam.predict(last.controls, last.dt)
                for landmark in slam.landmarks:
                    landmark.kind = free
            N, _ = with_anchors(unsure.state, unsure.sensors[0])
            blocks = dict(enumerate(unsure.belief.blocks))
            means = {i: block.mean for i, block in blocks.items()}
            unsure.belief.overwrite(blocks, means, unsure.belief.matrix + N @ N.T)
            for slam in (sure, unsure):
                slam.predictions[0] = predictions(slam)
                slam._update(0, last.scans[0])
            assert not np.allclose(sure.robots[0].pose, means[0][:7], atol=1e-6)
            N, _ = with_anchors(sure.state, sure.sensors[0])
            difference = unsure.belief.matrix - sure.belief.matrix
            far[error] = np.linalg.norm(difference - N @ N.T) / np.linalg.norm(N @ N.T)
    assert far[WITH_ANCHORS] < 1e-9, far
    assert far["world"] > 1e-6, far


def test_a_run_by_this_filter_is_like_the_others_and_leaves_no_option_behind():
    p = replace(with_landmark("idpPnt"), noise_in="truth")
    _, one, P = poses(p, 1, "world")
    _, other, Q = poses(p, 1, WITH_ANCHORS)
    assert WITH_ANCHORS not in TRANSPORTS
    assert not np.array_equal(one, other)
    np.testing.assert_allclose(one, other, atol=0.01)
    np.testing.assert_allclose(np.trace(P[-1, 0]), np.trace(Q[-1, 0]), rtol=0.2)
