"""The right-invariant EKF and the filters beside it: Jacobians by differences, the group, equalities, consistency."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from slambook.error_coordinates import Fej2Ekf, FirstEstimatesEkf, IteratedEkf, OrdinaryEkf, TransportEkf
from slambook.invariant_ekf import (
    GENERATORS,
    RANGE_BEARING,
    RANGE_YAW_PITCH,
    RELATIVE_POSITION,
    InvariantEkf,
    exponential,
    levers,
    logarithm,
    squared_errors,
)
from slambook.report.planar import SCANNERS, drive
from slambook.report.planar_invariant import PlanarFilter

from book.experiments import error_coordinates as tool
from slamlib.evaluation.consistency import band, share_inside
from slamlib.manifolds import Array
from slamlib.rigs.setup import Rig

SENSORS = [(2, RANGE_BEARING), (2, RELATIVE_POSITION), (3, RANGE_YAW_PITCH), (3, RELATIVE_POSITION)]
TURNS = {2: 1, 3: 3}
SMALL = 1e-6


def drawn(kind: type[InvariantEkf], d: int, sensor: object = RELATIVE_POSITION, seed: int = 1) -> InvariantEkf:
    """A filter anywhere, unsure of everything, with three landmarks in front of the robot."""
    rng, m = np.random.default_rng(seed), TURNS[d]
    root = 0.1 * rng.standard_normal((m + d, m + d))
    R = exponential(rng.standard_normal(m), d)[0]
    filter = kind(R, rng.standard_normal(d), root @ root.T, sensor, np.diag(0.1 + rng.random(d)))
    filter.predict(np.eye(d), np.zeros(d), np.zeros((m + d, m + d)))  # first estimates begin with a prediction
    for i in (7, 3, 8):
        filter.initialize(i, sensor.project(np.r_[4.0, rng.standard_normal(d - 1)])[0])
    root = 0.1 * rng.standard_normal(filter.P.shape)
    filter.P = root @ root.T
    return filter


def moved(filter: InvariantEkf, error: Array) -> InvariantEkf:
    """A copy whose state is away from this filter's by this error, of the kind whose covariance it keeps."""
    k = filter.m + filter.d
    other = type(filter)(filter.R, filter.x[0], filter.P[:k, :k], filter.sensor, filter.noise)
    other.x, other.rows, other.P = filter.x, dict(filter.rows), filter.P
    other.retract(error)
    return other


def error_of(truth: InvariantEkf, filter: InvariantEkf) -> Array:
    """Error of the kind whose covariance the filter keeps."""
    E = truth.R @ filter.R.T
    phi = logarithm(E)
    if isinstance(filter, OrdinaryEkf):
        return np.concatenate([phi, (truth.x - filter.x).ravel()])
    shifts = np.linalg.solve(exponential(phi, filter.d)[1], (truth.x - filter.x @ E.T).T).T
    return np.concatenate([phi, shifts.ravel()])


def differences(function, size: int) -> Array:
    """Jacobian at zero, (k, size), by central differences."""
    steps = SMALL * np.eye(size)
    return np.stack([(function(step) - function(-step)) / (2 * SMALL) for step in steps], axis=-1)


# The group.


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("angle", [0.0, 1e-5, 0.7, 2.5])
def test_the_exponential_is_the_series_of_the_matrix(d, angle):
    rng = np.random.default_rng(3)
    phi = rng.standard_normal(TURNS[d])
    phi *= angle / np.linalg.norm(phi)
    shift = rng.standard_normal(d)
    xi = np.zeros((d + 1, d + 1))
    xi[:d, :d], xi[:d, d] = np.tensordot(phi, GENERATORS[d], 1), shift
    series = term = np.eye(d + 1)
    for k in range(1, 40):
        term = term @ xi / k
        series = series + term
    E, V = exponential(phi, d)
    np.testing.assert_allclose(E, series[:d, :d], atol=1e-14)
    np.testing.assert_allclose(V @ shift, series[:d, d], atol=1e-14)
    np.testing.assert_allclose(logarithm(E), phi, atol=1e-14)


def product(A, X):
    """The product of two elements, (rotation, positions)."""
    return A[0] @ X[0], X[1] @ A[0].T + A[1]


@pytest.mark.parametrize("d", [2, 3])
def test_a_step_is_group_affine_and_more(d):
    """f(A X) = f(A) f(1)^-1 f(X), of which f(A X) = A f(X) is left: the error X X_hat^-1 does not change."""
    rng, m = np.random.default_rng(4), TURNS[d]
    filter = drawn(InvariantEkf, d)
    turn, shift = exponential(rng.standard_normal(m), d)[0], rng.standard_normal(d)

    def f(X):
        filter.R, filter.x = X
        filter.move(turn, shift)
        return filter.R, filter.x

    A, X = [(exponential(rng.standard_normal(m), d)[0], rng.standard_normal((4, d))) for _ in range(2)]
    R, x = f((np.eye(d), np.zeros((4, d))))
    with_inverse = product(product(f(A), (R.T, -x @ R)), f(X))
    for other in (with_inverse, product(A, f(X))):
        for found, wanted in zip(f(product(A, X)), other, strict=True):
            np.testing.assert_allclose(found, wanted, atol=1e-12)


# The models and their Jacobians.


@pytest.mark.parametrize(("d", "sensor"), SENSORS)
def test_a_sensor_has_its_jacobian_and_its_inverse(d, sensor):
    y = np.array([2.0, -1.5, 0.7])[:d]
    z, J = sensor.project(y)
    np.testing.assert_allclose(J, differences(lambda e: sensor.project(y + e)[0], d), atol=1e-8)
    np.testing.assert_allclose(sensor.locate(z), y, atol=1e-12)


@pytest.mark.parametrize("kind", [InvariantEkf, OrdinaryEkf])
@pytest.mark.parametrize(("d", "sensor"), SENSORS)
def test_jacobians_of_a_measurement(kind, d, sensor):
    filter = drawn(kind, d, sensor)
    for i in filter.rows:
        wanted = differences(lambda e, i=i: moved(filter, e).predicted(i)[0], len(filter.P))
        np.testing.assert_allclose(filter.predicted(i)[1], wanted, atol=1e-7)


@pytest.mark.parametrize("kind", [InvariantEkf, OrdinaryEkf])
@pytest.mark.parametrize("d", [2, 3])
def test_the_covariance_of_a_step(kind, d):
    """F and G by differences, of the errors that the filter keeps; the noise of turn and shift as `predict` has it."""
    rng, m = np.random.default_rng(5), TURNS[d]
    filter = drawn(kind, d)
    turn, shift = exponential(rng.standard_normal(m), d)[0], rng.standard_normal(d)
    after = moved(filter, np.zeros(len(filter.P)))
    after.move(turn, shift)

    def end(error):
        truth = moved(filter, error)
        truth.move(turn, shift)
        return error_of(truth, after)

    def noisy(noise):
        truth = moved(filter, np.zeros(len(filter.P)))
        truth.move(exponential(noise[:m], d)[0] @ turn, shift + noise[m:])
        return error_of(truth, after)

    F, G = differences(end, len(filter.P)), differences(noisy, m + d)
    root = rng.standard_normal((m + d, m + d))
    wanted = F @ filter.P @ F.T + G @ root @ root.T @ G.T
    filter.predict(turn, shift, root @ root.T)
    np.testing.assert_allclose(filter.P, wanted, atol=1e-7)
    if kind is InvariantEkf:
        np.testing.assert_allclose(F, np.eye(len(F)), atol=1e-9)


@pytest.mark.parametrize("kind", [InvariantEkf, OrdinaryEkf])
@pytest.mark.parametrize(("d", "sensor"), SENSORS)
def test_the_covariance_of_a_new_landmark(kind, d, sensor):
    filter = drawn(kind, d, sensor)
    size, z = len(filter.P), sensor.project(np.array([3.0, 0.4, -0.6])[:d])[0]

    def placed(errors):
        other = moved(filter, errors[:size])
        other.initialize(9, z + errors[size:])
        return other

    zero = placed(np.zeros(size + d))
    J = differences(lambda e: error_of(placed(e), zero), size + d)
    joint = np.block([[filter.P, np.zeros((size, d))], [np.zeros((d, size)), filter.noise]])
    np.testing.assert_allclose(zero.P, J @ joint @ J.T, atol=1e-6)


# What no measurement tells.


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("kind", [InvariantEkf, TransportEkf, OrdinaryEkf])
def test_nothing_is_learned_of_a_motion_of_the_world(kind, d):
    """Two filters, one unsure of the world's motion by N N': it stays so, exactly; in the ordinary one it does not."""
    sure, unsure = drawn(kind, d), drawn(kind, d)

    def motions(filter):
        """N (size, m + d) of the errors that the filter keeps."""
        N = np.tile(np.eye(d, TURNS[d] + d, TURNS[d]), (len(filter.x), 1))
        if kind is not InvariantEkf:
            N[:, : TURNS[d]] = levers(filter.x)
        return np.vstack([np.eye(TURNS[d], TURNS[d] + d), N])

    N = motions(sure)
    unsure.P = unsure.P + N @ N.T
    rng = np.random.default_rng(6)
    for _ in range(3):
        seen = {i: sure.predicted(i)[0] + 0.3 * rng.standard_normal(d) for i in sure.rows}
        turn, shift = exponential(0.3 * rng.standard_normal(TURNS[d]), d)[0], rng.standard_normal(d)
        for filter in (sure, unsure):
            filter.step(turn, shift, 0.01 * np.eye(TURNS[d] + d), seen)
    N = motions(sure)
    same = np.allclose(unsure.x, sure.x, atol=1e-9), np.allclose(unsure.P - sure.P, N @ N.T, atol=1e-8)
    assert same == ((True, True) if kind is not OrdinaryEkf else (False, False))


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("kind", [FirstEstimatesEkf, Fej2Ekf])
def test_first_estimates_are_blind_to_one_and_the_same_motion(kind, d):
    """As of the world's motion, N at the first estimates: it is carried by F and unknown to each H."""
    sure, unsure = drawn(kind, d), drawn(kind, d)
    N = motions_at_first(sure)
    unsure.P = unsure.P + N @ N.T
    rng = np.random.default_rng(6)
    for _ in range(4):
        seen = {i: sure.predicted(i)[0] + 0.3 * rng.standard_normal(d) for i in (*sure.rows,)}
        for filter in (sure, unsure):
            filter.step(np.eye(d), np.eye(d)[0] / 3, 0.01 * np.eye(TURNS[d] + d), seen)
    N = motions_at_first(sure)
    np.testing.assert_allclose(unsure.x, sure.x, atol=1e-8)
    np.testing.assert_allclose(unsure.P - sure.P, N @ N.T, atol=1e-7)


def motions_at_first(filter: FirstEstimatesEkf) -> Array:
    """N (size, m + d) at the first estimates."""
    points = np.stack([filter.robot()[1], *(filter.landmark(i) for i in filter.rows)])
    m, d = filter.m, filter.d
    rows = np.hstack([levers(points), np.tile(np.eye(d), (len(points), 1))])
    return np.vstack([np.eye(m, m + d), rows])


@pytest.mark.parametrize("d", [2, 3])
def test_the_corrected_first_estimates_feel_no_error_of_the_first(d):
    """No row that is left has another derivative with respect to the robot at the best estimates than at the first."""
    filter = drawn(Fej2Ekf, d)
    seen = {i: filter.predicted(i)[0] + 0.1 for i in filter.rows}
    plain = drawn(FirstEstimatesEkf, d)
    whole, rows = len(seen) * d, []
    for _ in range(2):
        best = drawn(OrdinaryEkf, d)
        best.R, best.x = filter.R, filter.x
        at_best = np.concatenate([best.predicted(i)[1] for i in seen])[:, : filter.m + d]
        root = np.linalg.cholesky(np.kron(np.eye(len(seen)), filter.noise))
        nu, H, noise = filter.linearized(seen)
        rows.append(len(nu))
        np.testing.assert_array_equal(noise, np.eye(len(nu)))
        # U' of the rows that are left, from their innovations with respect to each number of the measurements
        U = np.stack([filter.linearized(shifted(seen, k))[0] - nu for k in range(whole)], axis=-1)
        np.testing.assert_allclose(U @ at_best, H[:, : filter.m + d], atol=1e-9)
        np.testing.assert_allclose(U @ root @ root.T @ U.T, np.eye(len(nu)), atol=1e-9)
        filter.update(seen)
        plain.update(seen)
        if len(rows) == 1:
            np.testing.assert_allclose(filter.x, plain.x, atol=1e-12)  # the first estimates are the best
    assert rows[0] == whole > rows[1] > 0


def shifted(seen: Mapping[int, Array], k: int) -> dict[int, Array]:
    """One number of all measurements larger by one."""
    d = len(next(iter(seen.values())))
    return {i: z + (np.arange(n * d, (n + 1) * d) == k) for n, (i, z) in enumerate(seen.items())}


# The iterated update.


@pytest.mark.parametrize("sensor", [RANGE_BEARING, RELATIVE_POSITION])
def test_the_iterated_update_ends_at_the_minimum_with_the_covariance_there(sensor):
    """Of the squares of prior and measurements; the ordinary update, as far from the measurements, does not."""
    gradients = {}
    for kind in (IteratedEkf, OrdinaryEkf):
        before, filter = drawn(kind, 2, sensor), drawn(kind, 2, sensor)
        before.P, filter.P, rng = 4 * before.P, 4 * filter.P, np.random.default_rng(7)
        seen = {i: filter.predicted(i)[0] + 0.6 * rng.standard_normal(2) for i in filter.rows}
        filter.update(seen)

        def cost(delta, before=before, seen=seen):
            other = moved(before, delta)
            nu = other.linearized(seen)[0].reshape(-1, 2)
            return delta @ np.linalg.solve(before.P, delta) + np.sum(nu @ np.linalg.inv(before.noise) * nu)

        there = error_of(filter, before)
        slope = differences(lambda e, cost=cost, there=there: np.array([cost(there + e)]), len(there))[0]
        gradients[kind] = np.abs(slope @ np.linalg.cholesky(before.P)).max()
        if kind is IteratedEkf:
            _, H, noise = moved(before, there).linearized(seen)
            information = np.linalg.inv(before.P) + H.T @ np.linalg.solve(noise, H)
            np.testing.assert_allclose(filter.P, np.linalg.inv(information), atol=1e-8)
    assert gradients[IteratedEkf] < 1e-3 < 1e-2 < gradients[OrdinaryEkf]


class Restless(IteratedEkf):
    """Notes how far one more step of the iteration would lead."""

    def update(self, seen: Mapping[int, Array]) -> None:
        before, P = moved(self, np.zeros(len(self.P))), self.P
        super().update(seen)
        delta, (nu, H, noise) = error_of(self, before), self.linearized(seen)
        again = P @ H.T @ np.linalg.solve(H @ P @ H.T + noise, nu + H @ delta)
        self.left = [*getattr(self, "left", []), np.abs(again - delta).max()]


def test_the_iteration_comes_to_rest_where_whole_steps_go_back_and_forth():
    """A lap by sonar, whose loop closes with a heading off by tens of degrees."""
    data = drive(np.random.default_rng(3), 60, **SCANNERS["coarse scanner"])
    slam = PlanarFilter(data, Restless)
    for u, scan in zip(data.odometry, data.scans[1:], strict=True):
        slam.step(u, scan)
    assert len(slam.filter.left) > 50
    assert max(slam.filter.left) < 1e-5  # with whole steps alone more than a metre


# Two filters, one of them slamlib's.


class ByTheGroup(TransportEkf):
    """The covariance as it is carried, the means by the exponential."""

    def retract(self, xi: Array) -> None:
        """delta_k is xi_k + phi^ x_k."""
        m = self.m
        InvariantEkf.retract(self, np.concatenate([xi[:m], xi[m:] - levers(self.x) @ xi[:m]]))


def track(kind: type[InvariantEkf], scale: float, name: str) -> InvariantEkf:
    """The last state of a run of 60 frames, all of whose noise is so many times what it is."""
    setting = tool.SETTINGS[name]
    filter = kind(*tool.start(setting))
    filter.noise = scale**2 * filter.noise
    rng = np.random.default_rng(8)
    pose = filter.R, filter.x[0]
    for number in range(60):
        turn, shift, U = tool.motion(setting, setting.controls[number], setting.rig.robots[0].noise)
        noise = scale * rng.multivariate_normal(np.zeros(len(U)), U)
        there = exponential(noise[: filter.m], filter.d)[0] @ turn, shift + noise[filter.m :]
        pose = pose[0] @ there[0], pose[1] + pose[0] @ there[1]
        seen = {}
        for i, point in enumerate(setting.places):
            y = pose[0].T @ (point - pose[1])
            noise = rng.standard_normal(filter.d) * np.sqrt(np.diag(filter.noise))
            if np.linalg.norm(y) < 4:
                seen[i] = filter.sensor.project(y)[0] + noise
        filter.step(turn, shift, scale**2 * U, seen)
    return filter


@pytest.mark.parametrize("name", ["plane, 0.1 m, 1 deg", "space, 0.1 m, 1 deg"])
def test_with_the_exponential_the_transport_is_the_invariant_filter(name):
    """The one difference between the two is the second order of a sum in the place of the exponential."""
    one, other = track(InvariantEkf, 1, name), track(ByTheGroup, 1, name)
    np.testing.assert_allclose(other.x, one.x, atol=1e-9)
    np.testing.assert_allclose(other.invariant(), one.P, atol=1e-9 * np.abs(one.P).max())
    assert np.abs(track(TransportEkf, 1, name).x - one.x).max() > 1e-4


@pytest.mark.parametrize("name", ["plane, 0.1 m, 1 deg", "space, 0.1 m, 1 deg"])
def test_the_two_agree_to_first_order(name):
    """With noise ten times smaller the covariances differ, for their size, a hundred times less; the EKF's but ten."""
    apart = {}
    for kind in (TransportEkf, OrdinaryEkf):
        for scale in (1e-2, 1e-3):
            P = track(InvariantEkf, scale, name).linear()
            sigmas = np.sqrt(np.diag(P))
            apart[kind, scale] = np.abs((track(kind, scale, name).linear() - P) / np.outer(sigmas, sigmas)).max()
    assert 50 < apart[TransportEkf, 1e-2] / apart[TransportEkf, 1e-3] < 200
    assert 5 < apart[OrdinaryEkf, 1e-2] / apart[OrdinaryEkf, 1e-3] < 20


@pytest.mark.parametrize("name", ["plane, 0.1 m, 1 deg", "space, 0.1 m, 1 deg"])
def test_slamlib_carries_as_this_transport_does(name):
    """With noise that is another one along and about each axis."""
    setting = tool.SETTINGS[name]
    (robot,), d = setting.rig.robots, setting.d
    stds = (0.05, 0.02, 0.04)[:d] + (0.5, 2.0, 1.0)[-TURNS[d] :]
    setting = replace(setting, rig=Rig((replace(robot, control_std=stds),), setting.rig.sensors))
    record = list(tool.record(setting, 3))[:60]
    filter, slam = TransportEkf(*tool.start(setting)), tool.slamlib(setting, "world")
    for frame, _ in record:
        tool.step(filter, setting, frame)
        slam.step(frame)
    assert len(slam.landmarks) == len(filter.rows) > 3
    ids = list(filter.rows)
    points = {landmark.id: landmark for landmark in slam.landmarks}
    np.testing.assert_allclose([points[i].block.mean for i in ids], filter.x[1:], atol=1e-8)
    for i in ids:
        at = points[i].block.slice
        np.testing.assert_allclose(
            slam.belief.matrix[at, at], filter.P[filter.columns(i), filter.columns(i)], rtol=1e-6
        )


# Consistency.


class WithoutTheMap(InvariantEkf):
    """A mistake: the noise of a turn does not reach the landmarks."""

    def predict(self, turn: Array, shift: Array, U: Array) -> None:
        before, k = self.P, self.m + self.d
        super().predict(turn, shift, U)
        robot = self.P[:k, :k]
        self.P = before.copy()
        self.P[:k, :k] = robot


@pytest.mark.parametrize(("kind", "inside"), [(InvariantEkf, True), (WithoutTheMap, False)])
def test_nees_stays_in_its_band(kind, inside):
    """40 runs of two laps in the plane, with a sensor of 0.1 m and 1 degree."""
    setting = tool.SETTINGS["plane, 0.1 m, 1 deg"]
    nees = []
    for seed in range(40):
        filter, own = kind(*tool.start(setting)), []
        for frame, truth in tool.record(setting, seed):
            tool.step(filter, setting, frame)
            own.append(squared_errors(filter, *tool.pose(truth.robots[0])) if frame.number > tool.SKIPPED else (3, 3))
        nees.append(own)
    for average in np.mean(nees, axis=0).T:
        assert (share_inside(average, band(3, 40)) > 0.8) == inside
        assert (2.4 < average.mean() < 3.6) == inside
