"""What is left of the errors beside a motion of the world turns with it: the filter "rest carried" of the experiment.

Chapter observability, "Told from outside"; the derivation stands in `book.experiments.absolute_measurements`.
"""

from dataclasses import replace

import numpy as np
import pytest

from book.experiments import absolute_measurements
from book.experiments.absolute_measurements import by_state, rest_carried
from slamlib.checks.jacobian import check_jacobian
from slamlib.geometry.pose import exponential
from slamlib.landmarks import LINES, POINTS
from slamlib.slam import transport
from slamlib.slam.transport import generators, left_inverse, told
from slamlib.tests.test_absolute_measurements import shown, told_its_pose
from slamlib.tests.test_transport import run, with_landmark

IN_SPACE = [name for name in (*POINTS, *LINES) if not name.startswith("plane")]


@pytest.mark.parametrize("name", IN_SPACE)
def test_the_derivative_of_a_moved_state_by_the_state_is_that_of_differences(name):
    slam = run(with_landmark(name, error="world", convert=False), 4)
    g = exponential(np.array([0.3, -0.2, 0.1, 0.2, -0.1, 0.5]))
    for kind, block in (
        (slam.robots[0].motion, slam.robots[0].block),
        *((x.kind, x.block) for x in slam.landmarks[:2]),
    ):
        manifold, x = block.manifold, block.mean
        there = kind.moved(g, x)
        check_jacobian(
            lambda d, f=kind.moved, m=manifold, x=x, y=there: m.minus(f(g, m.plus(x, d)), y),
            by_state(kind, g, x),
            np.zeros(block.dof),
        )


def uncertainty_of_what_is_seen(name, by_robot, monkeypatch):
    """Covariances of all predicted measurements before and after the world is turned by 0.46 rad, by this treatment."""
    slam = run(with_landmark(name, error="world", convert=False), 6)
    monkeypatch.setitem(transport.TRANSPORTS, "world", replace(transport.TRANSPORTS["world"], by_robot=by_robot))
    N, blocks, rows = generators(slam.state), dict(enumerate(slam.belief.blocks)), slam.robots[0].columns
    beside = np.eye(len(N))
    beside[:, rows] -= N @ left_inverse(N[rows])
    rest = beside @ slam.belief.matrix @ beside.T
    slam.belief.overwrite(blocks, {i: b.mean for i, b in blocks.items()}, rest + 0.3 * N @ N.T)
    before, was = [p.S for p in slam.project(0)], shown(slam)
    told_its_pose(slam, 0, [0.3, -0.2, 0.1, 0.2, -0.1, 0.4], 1e-3)
    np.testing.assert_allclose(shown(slam), was, rtol=1e-7, atol=1e-8)
    after = [p.S for p in slam.project(0)]
    assert len(after) == len(before) >= 2
    return before, after


# Ends of these are counted from a place by the origin, and so are others of the same line once the world has moved.
OTHER_ENDS = {"plkLin", "aplLin"}


@pytest.mark.parametrize("name", [name for name in IN_SPACE if name not in OTHER_ENDS])
def test_a_turn_of_the_world_leaves_how_sure_the_filter_is_of_what_is_seen(name, monkeypatch):
    """The map as the robot sees it has not changed, and neither has its covariance: exactly, whatever the turn."""
    for old, new in zip(*uncertainty_of_what_is_seen(name, rest_carried, monkeypatch), strict=True):
        np.testing.assert_allclose(new, old, rtol=1e-6, atol=1e-9 * np.abs(old).max())


@pytest.mark.parametrize("name", ["hmgPnt", "eucPnt"])
def test_control_with_the_rest_as_it_was_depths_point_where_they_did(name, monkeypatch):
    before, after = uncertainty_of_what_is_seen(name, told, monkeypatch)
    assert max(np.abs(new - old).max() / np.abs(old).max() for old, new in zip(before, after, strict=True)) > 0.1


@pytest.mark.parametrize(("convert", "most"), [(True, 0.8), (False, 1.1)], ids=["converted", "as they are"])
def test_a_run_that_turns_its_map_by_27_degrees_late(convert, most):
    """The NEES with the rest carried, as a share of slamlib's; points that are not converted have no axes."""
    base = absolute_measurements.of_type("idpPnt")
    p = replace(base, frames=20, options=replace(base.options, convert=convert))
    found = [absolute_measurements.one_run(p, name, 5, 0.3, 5013)[1] for name in (absolute_measurements.REST, "world")]
    assert found[0] < most * found[1]
