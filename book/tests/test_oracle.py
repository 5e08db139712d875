"""The oracle has the true null space: what it does not know of the world's place at the start, it never learns."""

from dataclasses import replace

import numpy as np
import pytest
from slambook import filters_compared
from slambook.filters_compared import ALL_DATA, FILTERS, Verdict, run
from slambook.oracle import Oracle, nearest

from book.experiments import consistency
from slamlib.entities.generator import generator
from slamlib.errors import SlamlibError
from slamlib.experiments.presets import preset
from slamlib.geometry.pose import ORIGIN, Pose, from_frame
from slamlib.landmarks import LINES, POINTS


@pytest.fixture
def rng():
    return np.random.default_rng(24)


IN_SPACE = [kind for kind in POINTS.values() if not kind.plane]


@pytest.mark.parametrize("kind", [*IN_SPACE, *LINES.values()], ids=lambda kind: kind.name)
def test_the_true_landmark_is_found_in_its_own_parametrization(kind, rng):
    for _ in range(20):
        pose, across = Pose.random(rng), rng.uniform(-0.4, 0.4, 2)
        rays = np.column_stack([across + np.array([[0, 0], [0.3, 0.1]]), np.ones(2)])
        feature = np.array([from_frame(pose, ray * distance) for ray, distance in zip(rays, (4.0, 5.0), strict=True)])
        rays = rays + 0.003 * rng.standard_normal((2, 3)) * [1, 1, 0]
        rays /= np.linalg.norm(rays, axis=1)[:, None]
        if kind.name in POINTS:
            feature, arguments, stds = feature[0], [np.append(rays[0], 0.3)], [np.array([0.003, 0.003, 0.003, 0.2])]
        else:
            prior = np.array([0.3, 0.3]) if kind.name not in ("plkLin", "aplLin") else np.array([0.2, 0.1])
            feature, arguments, stds = feature.ravel(), [rays.ravel(), prior], [np.full(6, 0.003), np.full(2, 0.3)]
        start, J = kind.from_frame.jac(pose, *arguments)
        noise = sum(by @ np.diag(std**2) @ by.T for by, std in zip(J[1:], stds, strict=True))
        found = nearest(kind, start, noise, feature)
        value, true = kind.to_frame(ORIGIN, found), np.append(feature, 1.0)
        if kind.name in LINES:  # Pluecker coordinates
            true = np.concatenate([np.cross(feature[:3], feature[3:]), feature[3:] - feature[:3]])
        off = value - (value @ true) / (true @ true) * true
        assert np.linalg.norm(off) < 1e-9 * np.linalg.norm(value)


@pytest.mark.parametrize("case", ["idpPnt", "hmgPnt", "ahmPnt", "plkLin", "aplLin", "idpLin", "two_robots"])
def test_two_oracles_that_differ_by_what_cannot_be_known_do_so_for_ever(case, rng):
    setup = replace(consistency.cases()[case], frames=20)
    always = {"convert_below": np.inf, "extend": False}  # else decisions, which depend on the covariance, may differ
    setup = replace(setup, options=replace(setup.options, **always))
    exact, unsure = setup.slam(), setup.slam()
    before = _null(unsure, [robot.block.mean for robot in unsure.robots])
    turned = 0.1 * before @ rng.standard_normal((6, 6))  # the same motion of the world for all robots
    unsure.belief._P[:] = turned @ turned.T
    M = np.linalg.inv(before[:6]) @ turned[:6]
    oracles = [Oracle(slam, setup.world) for slam in (exact, unsure)]
    for frame, truth in setup.simulate():
        for slam, oracle in zip((exact, unsure), oracles, strict=True):
            oracle.truth = truth
            slam.step(frame)
    for a, b in zip(exact.belief.blocks, unsure.belief.blocks, strict=True):
        np.testing.assert_allclose(a.mean, b.mean, atol=1e-7)
    after = _null(unsure, [oracles[1].at(block) for block in unsure.belief.blocks]) @ M
    gained = unsure.belief.matrix - exact.belief.matrix - after @ after.T
    assert np.abs(gained).max() < 1e-7 * np.abs(after @ after.T).max()
    assert len(unsure.landmarks) > 3


def _null(slam, points):
    """N (size, 6) at these points, one for each block: robots first, then landmarks."""
    kinds = [*(robot.motion for robot in slam.robots), *(landmark.kind for landmark in slam.landmarks)]
    return np.concatenate([generator(kind, point) for kind, point in zip(kinds, points, strict=True)])


def test_extrinsics_that_are_estimated_are_refused():
    setup = preset("self_calibration")
    with pytest.raises(SlamlibError, match="estimated extrinsics"):
        Oracle(setup.slam(), setup.world)


def test_a_verdict_counts_runs_steps_and_failures(rng):
    nees = rng.chisquare(6, (200, 50, 2))
    nees[:10] = 40
    found = Verdict.of(nees).numbers()
    assert found["failed"] == 0.05
    assert found["mean"] == pytest.approx(6 + 0.05 * 34, abs=0.15)
    assert found["median"] == pytest.approx(6, abs=0.1)
    assert found["inside"] < 0.05
    right = Verdict.of(nees[10:]).numbers()
    assert right["inside"] > 0.85
    assert right["error"] == pytest.approx(np.sqrt(12 / 100 / 190), rel=0.2)


def test_runs_that_are_added_later_count_as_if_made_at_once(rng):
    nees = rng.chisquare(6, (30, 50, 2))
    joined = Verdict.of(nees[:20]).joined(Verdict.of(nees[20:]))
    assert joined.numbers() == pytest.approx(Verdict.of(nees).numbers(), rel=1e-12)
    np.testing.assert_allclose(joined.average, nees.mean(0), rtol=1e-12)


def test_the_filters_of_one_seed_have_the_same_data():
    setup = replace(consistency.cases()["idpPnt"], frames=3)
    rows = {name: run(setup, 5, name) for name in FILTERS}
    assert np.ptp([row["nees"][0, 0] for row in rows.values()]) < 1e-9 * rows["local"]["nees"][0, 0]


def test_all_data_at_once_are_judged_at_the_same_frames():
    setup = replace(consistency.cases()["idpPnt"], frames=8)
    found, filtered = run(setup, 5, ALL_DATA), run(setup, 5, "local")
    assert found["nees"].shape == filtered["nees"].shape
    assert found["nees"].max() < 36  # 6 dof, one in 300,000
    assert not np.allclose(found["nees"], filtered["nees"], rtol=0.01)


def test_a_path_that_is_too_small_is_too_near_and_else_right(monkeypatch):
    setup = consistency.cases()["idpPnt"]
    true = np.tile(ORIGIN, (4, 1, 1))
    true[:, 0, :3] = setup.rig.robots[0].state[:3] + np.arange(1.0, 5.0)[:, None] * [0.6, 0.8, 0.0]
    small = true.copy()
    small[:, 0, :3] -= 0.01 * np.arange(1.0, 5.0)[:, None] * [0.6, 0.8, 0.0]
    P = np.tile(0.02**2 * np.eye(6), (4, 1, 1, 1))
    monkeypatch.setattr(filters_compared, "poses", lambda *_: (true, small, P))
    found = run(setup, 0, "local")
    np.testing.assert_allclose(found["scale"], [(0.01 * k, 0.02) for k in range(1, 5)], atol=1e-12)
    np.testing.assert_allclose(found["rest"], 0, atol=1e-12)
    np.testing.assert_allclose(found["position"], [0.01, 0.02, 0.03, 0.04], atol=1e-12)
