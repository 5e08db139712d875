"""The noise of a product of errors is what a linearization leaves out; and nothing where it leaves nothing out."""

from dataclasses import replace

import numpy as np
from slambook.filters_compared import with_products

from book.experiments import consistency
from slamlib.entities.state import KindRows
from slamlib.geometry.pose import Pose
from slamlib.observation.family import viewpoint
from slamlib.observation.points import observe


def _noises(case, frames):
    """The filter after some frames, and the second camera's predictions with the noise without and with products."""
    setup = replace(consistency.cases()[case], frames=frames)
    slam = setup.slam()
    for frame, _ in setup.simulate():
        slam.step(frame)
    sensor, family = slam.sensors[1], slam.families["points"]
    kind = next(landmark.kind for landmark in slam.landmarks if landmark.kind is not family.exact)
    group = [landmark for landmark in slam.landmarks if landmark.kind is kind]
    expected = family.predict_batch(viewpoint(sensor), KindRows.of(group), slam.options)
    both = [one.batch_innovation(sensor, expected, expected.value).R for one in (family, with_products(slam))]
    return slam, sensor, expected, both


def test_the_noise_is_that_of_the_product_of_inverse_distance_and_displacement():
    slam, sensor, expected, (without, with_them) = _noises("self_calibration", 1)
    rng = np.random.default_rng(15)
    for row in range(3):
        landmark, at = expected.landmarks[row], expected.columns[row][[6, 7, 8, -1]]
        C = slam.belief.matrix[np.ix_(at, at)]
        draws = 0.1 * rng.multivariate_normal(np.zeros(4), C, 4000)  # a tenth: the product, and little beyond it
        x = np.tile(landmark.block.mean, (4000, 1))
        near, moved = x.copy(), Pose.plus(sensor.extrinsics, np.pad(draws[:, :3], ((0, 0), (0, 3))))
        near[:, -1] += draws[:, 3]
        robot, still = sensor.robot.pose, sensor.extrinsics
        seen = [observe(landmark.kind, sensor.calibration, robot, *pair).value for pair in
                ((moved, near), (moved, x), (still, near), (still, x))]  # fmt: skip
        product = seen[0] - seen[1] - seen[2] + seen[3]
        wanted = np.trace(with_them[row] - without[row])
        assert wanted > 0.01  # [px^2], after one frame
        assert 0.7 < 1e4 * (product**2).sum(1).mean() / wanted < 1.4


def test_extrinsics_that_are_given_add_nothing():
    _, _, _, (without, with_them) = _noises("extrinsics x 0", 1)
    np.testing.assert_array_equal(with_them, without)
