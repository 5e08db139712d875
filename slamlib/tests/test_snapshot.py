"""A snapshot shows what the filter holds: predictions as they were made, and endpoints as uncertain as the map is."""

from dataclasses import replace

import numpy as np

from slamlib.experiments.presets import preset
from slamlib.slam.snapshot import endpoints_in_image


def run(name, frames):
    p = replace(preset(name), frames=frames)
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    return slam


def test_a_single_prediction_is_shown_as_it_was_made():
    slam = run("lines", 2)
    (one,) = slam.predictions[0]
    shown = slam.snapshot().sensors[0].segments
    assert shown.ids.tolist() == [one.landmark.id]
    assert np.array_equal(shown.expected, [one.value])
    assert np.array_equal(shown.covariance, [one.S])
    assert np.array_equal(shown.measured, [one.measured])


def test_endpoints_are_as_uncertain_in_the_image_as_robot_and_line_say():
    """H P H' with differences as Jacobians, over all rows of the covariance."""
    slam, by = run("lines", 12), 1e-6
    lines = [prediction.landmark for prediction in slam.predictions[0]]
    blocks, P = slam.belief.blocks, slam.belief.matrix
    means = [block.mean.copy() for block in blocks]

    def endpoints(step):
        for block, mean in zip(blocks, means, strict=True):
            block.mean = block.manifold.plus(mean, step[block.slice])
        return endpoints_in_image(slam.belief, slam.sensors[0], lines)[0]

    steps = by * np.eye(len(P))
    H = np.stack([(endpoints(step) - endpoints(-step)) / (2 * by) for step in steps], axis=-1)
    endpoints(np.zeros(len(P)))
    found = endpoints_in_image(slam.belief, slam.sensors[0], lines)[1]
    seen = np.isfinite(found).all((-2, -1))
    assert seen.sum() >= 4
    assert np.allclose(found[seen], (H @ P @ H.swapaxes(-1, -2))[seen], rtol=1e-5, atol=1e-6)
