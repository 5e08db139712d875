"""Beside SciPy, on random and singular inputs: rotations, poses and their Jacobians, the Kalman filter, chi-square.

SciPy's matrix exponential and its derivative (expm, expm_frechet) know nothing of quaternions or angles; its Rotation
has other branches than ours; its densities say what conditioning is. Where a tolerance is looser than rounding, the
peer's own rounding is the reason, and named.
"""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import linalg, stats
from scipy.spatial.distance import mahalanobis
from scipy.spatial.transform import Rotation

from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.evaluation.alignment import align, align_trajectory
from slamlib.evaluation.consistency import band, nees, nees_in_range, nis
from slamlib.evaluation.trajectory import Trajectory
from slamlib.geometry import euler, plucker, pose, pose2, quaternion
from slamlib.geometry.pose import Pose
from slamlib.geometry.pose2 import Pose2
from slamlib.kalman.chi_square import chi2_cdf, chi2_quantile, chi2_sf
from slamlib.motions.constant_velocity import CONSTANT_VELOCITY
from slamlib.motions.odometry import ODOMETRY
from slamlib.motions.unicycle import UNICYCLE
from slamlib.slam.data_association.jcbb import jcbb
from slamlib.tests.peers import (
    NUMBERS,
    PLANAR,
    POSES,
    QUATERNIONS,
    SEEDS,
    covariance,
    directions,
    rigid,
    several,
    skew,
    step_of,
    turns,
    twisted,
    with_jacobians,
)

few, many = settings(max_examples=40, deadline=None), settings(max_examples=100, deadline=None)
ROUNDING = 1e-13  # of numbers up to ten, after some products
EXPM = 1e-11  # expm scales its argument down and squares the result again: each squaring doubles its rounding


def of_scipy(q):
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


def of_ours(rotation):
    return np.roll(rotation.as_quat(), 1, axis=-1)


def close(found, wanted, tolerance=ROUNDING):
    np.testing.assert_allclose(found, wanted, rtol=tolerance, atol=tolerance)


def close_but_for_sign(found, wanted, tolerance=ROUNDING):
    close(found * (1 if found @ wanted >= 0 else -1), wanted, tolerance)


def close_turns(found, wanted, tolerance=ROUNDING):
    """Two rotation vectors up to half a turn; there either sign is the same rotation."""
    half = np.linalg.norm(wanted) > np.pi - 1e-6
    (close_but_for_sign if half else close)(found, wanted, tolerance)


def matrix(point):
    """The matrix of a pose in space, or in the plane, by SciPy."""
    if len(point) == 3:
        return rigid(Rotation.from_rotvec([0, 0, point[2]]).as_matrix()[:2, :2], point[:2])
    return rigid(of_scipy(point[3:]).as_matrix(), point[:3])


# -- rotations ---------------------------------------------------------------------------------------------------------


@many
@given(p=QUATERNIONS, q=QUATERNIONS)
def test_quaternions(p, q):
    close(quaternion.rotation(q), of_scipy(q).as_matrix())
    both, J = with_jacobians(quaternion.product, p, q)
    close_but_for_sign(both, of_ours(of_scipy(p) * of_scipy(q)))
    close(quaternion.pi_matrix(p) @ q[1:], quaternion.left_matrix(p) @ [0, *q[1:]])
    close_but_for_sign(quaternion.left_matrix(p) @ q, both)
    close_but_for_sign(quaternion.right_matrix(q) @ p, both)
    for matrix_at, by in ((quaternion.left_matrix(p), J.right), (quaternion.right_matrix(q), J.left)):
        close(matrix_at, by)  # it is linear in each
    close_but_for_sign(quaternion.conjugate(q), of_ours(of_scipy(q).inv()))
    turn = of_scipy(q).as_matrix()
    close_but_for_sign(quaternion.from_rotation(turn, quaternion.best_pivot(turn)), of_ours(Rotation.from_matrix(turn)))
    found, J = with_jacobians(quaternion.from_rotation, turn, quaternion.best_pivot(turn))
    rates_there = np.stack([turn @ skew(axis) for axis in np.eye(3)], axis=-1)
    close(np.einsum("aij,ijk->ak", J.matrix, rates_there), quaternion.left_matrix(found)[:, 1:] / 2)
    close_turns(quaternion.logarithm(q), of_scipy(q).as_rotvec())
    close_turns(quaternion.minus(q, p), (of_scipy(p).inv() * of_scipy(q)).as_rotvec())


@many
@given(q=QUATERNIONS, v=turns())
def test_rotation_vectors(q, v):
    close_but_for_sign(quaternion.exponential(v), of_ours(Rotation.from_rotvec(v)))
    close(quaternion.rotation(quaternion.exponential(v)), linalg.expm(skew(v)), EXPM)
    close_but_for_sign(quaternion.plus(q, v), of_ours(of_scipy(q) * Rotation.from_rotvec(v)))


def rates(v):
    """Derivatives (3, 3, 3) of the rotation matrix of v by its three numbers."""
    return np.array([linalg.expm_frechet(skew(v), skew(axis), compute_expm=False) for axis in np.eye(3)])


@many
@given(v=turns())
def test_the_derivatives_of_the_exponential_are_those_of_expm(v):
    """dR/dv by our chain of two models, and by the Frechet derivative of the exponential of matrices."""
    q, J = with_jacobians(quaternion.exponential, v)
    _, stored = quaternion.rotation.storage_jac(q)
    close(stored.q @ J.vector, np.moveaxis(rates(v), 0, -1), EXPM)
    if np.linalg.norm(v) < np.pi - 1e-6:  # where the logarithm is its inverse
        close(quaternion.logarithm.jac(q)[1].q @ J.vector, np.eye(3))


@many
@given(q=QUATERNIONS, p=QUATERNIONS, v=turns())
def test_the_derivatives_of_steps_are_those_of_matrices(q, p, v):
    """Of a rotation by a turn about its own axes; of where a step leads; of a difference by a turn of either side."""
    R, none = of_scipy(q).as_matrix(), np.zeros((3, 1))
    close(quaternion.rotation.jac(q)[1].q, np.stack([R @ skew(axis) for axis in np.eye(3)], axis=-1))
    value, J = with_jacobians(quaternion.plus, q, v)
    close(quaternion.rotation.storage_jac(value)[1].q @ J.step, np.moveaxis(R @ rates(v), 0, -1), EXPM)
    difference, J = with_jacobians(quaternion.minus, q, p)
    if np.linalg.norm(difference) < np.pi - 1e-3:  # at half a turn it jumps
        turned, about_own = linalg.expm(skew(difference)), np.hstack([none, np.eye(3)]).T / 2
        right = step_of(rigid(turned, np.zeros(3)), np.pad(rates(difference), ((0, 0), (0, 1), (0, 1))))[3:]
        close(J.q @ quaternion.left_matrix(q) @ about_own @ right, np.eye(3), EXPM)
        close(J.origin @ quaternion.left_matrix(p) @ about_own @ turned @ right, -np.eye(3), EXPM)


ANGLES = st.one_of(st.floats(-np.pi, np.pi), st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-9, np.pi]))


@many
@given(angles=several(ANGLES, 3))
def test_euler_angles(angles):
    wanted = Rotation.from_euler("ZYX", angles[::-1])
    value, J = with_jacobians(euler.to_rotation, angles)
    close(value, wanted.as_matrix())
    close_but_for_sign(euler.to_quaternion(angles), of_ours(wanted))
    close(euler.to_rotation(euler.from_rotation(value)), wanted.as_matrix())
    close(euler.to_rotation(euler.from_quaternion(of_ours(wanted))), wanted.as_matrix())
    if abs(np.cos(angles[1])) > 1e-3:  # nearer to the vertical, SciPy divides what it rounds by this cosine
        close(np.sin(euler.from_rotation(value) - wanted.as_euler("ZYX")[::-1]), np.zeros(3), 1e-12)
    about_x, about_y, about_z = (
        Rotation.from_rotvec(a * v).as_matrix() for a, v in zip(angles, np.eye(3), strict=True)
    )
    x, y, z = (skew(axis) for axis in np.eye(3))
    wanted = [about_z @ about_y @ about_x @ x, about_z @ about_y @ y @ about_x, about_z @ z @ about_y @ about_x]
    close(J.angles, np.stack(wanted, axis=-1))
    about_own = step_of(rigid(value, np.zeros(3)), np.pad(np.array(wanted), ((0, 0), (0, 1), (0, 1))))[3:]
    q, J = euler.to_quaternion.jac(angles)
    close(J.angles, about_own)
    if np.cos(angles[1]) > 1e-3:  # the angles that come back are these
        close(euler.from_quaternion_jac(q)[1] @ about_own, np.eye(3), 1e-9)
        back = euler.from_rotation_jac(value)[1]
        close(np.einsum("aij,kij->ak", back, np.array(wanted)), np.eye(3), 1e-9)


# -- poses -------------------------------------------------------------------------------------------------------------


def check_group(module, a, b, point):
    """Composition, inverse and change of frames, with each Jacobian, beside matrices and their product rule."""
    A, B = matrix(a), matrix(b)
    along_a, along_b, there = directions(A), directions(B), np.append(point, 1.0)
    value, J = with_jacobians(module.compose, a, b)
    close(matrix(value), A @ B)
    close(J.outer, step_of(A @ B, along_a @ B))
    close(J.inner, step_of(A @ B, A @ along_b))
    back = linalg.inv(A)
    value, J = with_jacobians(module.inverse, a)
    close(matrix(value), back)
    close(J.pose, step_of(back, -back @ along_a @ back))
    value, J = with_jacobians(module.from_frame, a, point)
    close(value, (A @ there)[:-1])
    close(J.pose, (along_a @ there).T[:-1])
    close(J.point, A[:-1, :-1])
    value, J = with_jacobians(module.to_frame, a, point)
    close(value, (back @ there)[:-1])
    close(J.pose, (-back @ along_a @ back @ there).T[:-1])
    close(J.point, back[:-1, :-1])


@many
@given(a=POSES, b=POSES, point=several(NUMBERS, 3))
def test_poses_in_space(a, b, point):
    check_group(pose, a, b, point)
    A, B = matrix(a), matrix(b)
    back = linalg.inv(A)
    value, J = with_jacobians(pose.relative, a, b)
    close(matrix(value), back @ B)
    close(J.origin, step_of(back @ B, -back @ directions(A) @ back @ B))
    close(J.pose, step_of(back @ B, back @ directions(B)))
    step = Pose.minus(b, a)
    close(step[:3], b[:3] - a[:3])
    close_turns(step[3:], (of_scipy(a[3:]).inv() * of_scipy(b[3:])).as_rotvec())


@many
@given(a=PLANAR, b=PLANAR, point=several(NUMBERS, 2))
def test_poses_in_the_plane(a, b, point):
    check_group(pose2, a, b, point)
    twist = step_of(np.eye(3), matrix(a) @ directions(np.eye(3)) @ linalg.inv(matrix(a)))
    close(pose2.adjoint(a), twist)
    difference = Rotation.from_rotvec([0, 0, a[2] - b[2]]).as_rotvec()[2]
    (close if abs(difference) < np.pi - 1e-6 else close_but_for_sign)(Pose2.minus(a, b)[2:], np.array([difference]))


@many
@given(twist=PLANAR)
def test_the_exponential_of_a_twist_in_the_plane(twist):
    value, J = with_jacobians(pose2.exponential, twist)
    close(matrix(value), linalg.expm(twisted(twist)), EXPM)
    rates = np.array([linalg.expm_frechet(twisted(twist), twisted(e), compute_expm=False) for e in np.eye(3)])
    close(J.twist, step_of(matrix(value), rates), EXPM)


@many
@given(v=turns(), d=several(NUMBERS, 3), a=POSES)
def test_the_exponential_of_a_twist_in_space(v, d, a):
    """With the derivatives of expm; the logarithm undoes it up to half a turn, and so do its derivatives."""
    twist = np.append(d, v)
    value, J = with_jacobians(pose.exponential, twist)
    close(matrix(value), linalg.expm(twisted(twist)), EXPM)
    along = np.array([linalg.expm_frechet(twisted(twist), twisted(e), compute_expm=False) for e in np.eye(6)])
    close(J.twist, step_of(matrix(value), along), EXPM)
    if np.linalg.norm(v) < np.pi - 1e-6:
        found, J_log = with_jacobians(pose.logarithm, value)
        close(found, twist, 1e-12)
        close(J_log.pose @ J.twist, np.eye(6), 1e-9)
    moved = np.array([matrix(a) @ twisted(e) @ linalg.inv(matrix(a)) for e in np.eye(6)])
    turn, shift = moved[:, [2, 0, 1], [1, 2, 0]].T, moved[:, :3, 3].T
    close(pose.adjoint(a), np.vstack([shift, turn]), 1e-12)


@many
@given(a=PLANAR, speed=NUMBERS, rate=NUMBERS, dt=st.sampled_from([0.0, 1e-9, 0.1, 2.0]))
def test_a_unicycle_drives_along_the_exponential(a, speed, rate, dt):
    value = UNICYCLE.step(a, np.array([speed, rate]), dt)
    close(matrix(value), matrix(a) @ linalg.expm(dt * twisted([speed, 0, rate])), EXPM)


@many
@given(a=POSES, velocities=several(NUMBERS, 6), dt=st.sampled_from([0.0, 1e-9, 0.1, 2.0]))
def test_motions_in_space(a, velocities, dt):
    """The exponential of the whole linear system of constant velocities, and of its rotation."""
    moved = CONSTANT_VELOCITY.step(np.concatenate([a, velocities]), np.arange(6.0), dt)
    system = np.zeros((6, 6))
    system[:3, 3:] = np.eye(3)
    close(np.concatenate([moved[:3], velocities[:3]]), linalg.expm(dt * system) @ [*a[:3], *velocities[:3]])
    turned = of_scipy(a[3:]).as_matrix() @ linalg.expm(dt * skew(velocities[3:]))
    close(of_scipy(moved[3:7]).as_matrix(), turned, EXPM)
    close(moved[7:], velocities + np.arange(6.0))
    stepped = matrix(a) @ rigid(linalg.expm(skew(velocities[3:])), velocities[:3])
    close(matrix(ODOMETRY.step(a, velocities, dt)), stepped, EXPM)


def dual(line):
    """The matrix p q' - q p' (4, 4) of the line (n, v) through homogeneous points p, q: [n] and -v, with n = p x q."""
    return np.block([[-skew(line[:3]), -line[3:, None]], [line[None, 3:], np.zeros((1, 1))]])


def of_dual(matrices):
    """The lines (6, k) of such matrices (k, 4, 4)."""
    return np.array([matrices[:, i, j] for i, j in ((1, 2), (2, 0), (0, 1), (3, 0), (3, 1), (3, 2))])


UNITS = np.array([dual(line) for line in np.eye(6)])


@many
@given(a=POSES, p=several(NUMBERS, 3), q=several(NUMBERS, 3), far=st.sampled_from([0.0, 1.0, 2.0]), b=NUMBERS)
def test_lines_are_matrices_of_their_points(a, p, q, far, b):
    """Of two points, of a motion, of a plane that meets it. far: of the second point; 0 puts it at infinity."""
    first, second, plane, A = np.append(p, 1.0), np.append(q, far), np.array([*q[::-1], b]), matrix(a)
    line, J = with_jacobians(plucker.join, first, second)
    close(dual(line), np.outer(first, second) - np.outer(second, first), 1e-12)
    along_first = np.array([np.outer(e, second) - np.outer(second, e) for e in np.eye(4)])
    along_second = np.array([np.outer(first, e) - np.outer(e, first) for e in np.eye(4)])
    close(J.first, of_dual(along_first))
    close(J.second, of_dual(along_second))
    point, J = with_jacobians(plucker.meet, line, plane)
    close(point, dual(line) @ plane, 1e-12)
    close(J.plane, dual(line))
    close(J.line, (UNITS @ plane).T)
    for module, T, rate in (
        (plucker.from_frame, A, directions(A)),
        (plucker.to_frame, linalg.inv(A), -linalg.inv(A) @ directions(A) @ linalg.inv(A)),
    ):
        value, J = with_jacobians(module, a, line)
        close(dual(value), T @ dual(line) @ T.T, 1e-12)
        half = rate @ dual(line) @ T.T
        close(J.pose, of_dual(half - half.swapaxes(1, 2)), 1e-12)
        close(J.line, of_dual(T @ UNITS @ T.T), 1e-12)


# -- the Kalman filter -------------------------------------------------------------------------------------------------

RANKS = st.integers(0, 4)


def drawn(seed, rank, spread):
    """A prior of any rank in mixed units, and what is measured of it."""
    rng = np.random.default_rng(seed)
    n, m = 4, int(rng.integers(1, 4))
    units = 10.0 ** rng.uniform(-spread / 2, spread / 2, n)
    P = units[:, None] * covariance(rng, n, rank=rank) * units
    H = rng.standard_normal((m, n)) / units
    R = covariance(rng, m) + 0.1 * np.eye(m)
    return rng, units, units * rng.standard_normal(n), P, H, R, rng.standard_normal(m)


@many
@given(
    seed=SEEDS,
    rank=RANKS,
    spread=st.sampled_from([0.0, 6.0, 12.0]),
    by=st.sampled_from(["batch", "scalar", "rows", "sequence"]),
)
def test_an_update_is_the_solution_of_the_normal_equations(seed, rank, spread, by):
    """By each way to call it: mean, covariance, S and NIS, in units that differ by up to twelve powers of ten."""
    _, units, mean, P, H, R, z = drawn(seed, rank, spread)
    belief = Belief()
    block = belief.add(4, mean, P)
    if by == "rows":
        found = belief.update_rows(np.arange(4), H, z, R)
    elif by == "sequence":
        with belief.sequential_update() as sequence:
            found = sequence.update(np.arange(4), H, z, R)
    else:
        found = belief.update([block], [H], z, R, method=by)
    S = H @ P @ H.T + R
    K = linalg.solve(S, H @ P, assume_a="pos").T
    close(found.covariance, S, 1e-11)
    close(found.nis, z @ linalg.solve(S, z), 1e-11)
    close(found.nis, nis(z, S), 1e-11)
    close((block.mean - mean) / units, K @ z / units, 1e-11)
    left = np.eye(4) - K @ H
    close(belief.matrix / np.outer(units, units), (left @ P @ left.T + K @ R @ K.T) / np.outer(units, units), 1e-11)
    likelihood = -(found.nis + np.linalg.slogdet(2 * np.pi * found.covariance)[1]) / 2
    close(likelihood, stats.multivariate_normal(np.zeros(len(z)), S).logpdf(z), 1e-11)


@many
@given(seed=SEEDS, rank=RANKS)
def test_a_sequence_of_updates_is_that_of_all_stacked(seed, rank):
    rng, _, mean, P, H, R, y = drawn(seed, rank, 0.0)
    G, N, w = rng.standard_normal((2, 4)), covariance(rng, 2) + 0.1 * np.eye(2), rng.standard_normal(2)
    belief = Belief()
    block = belief.add(4, mean, P)
    with belief.sequential_update() as sequence:
        sequence.update(np.arange(4), H, y - H @ block.mean, R)
        last = sequence.update(np.arange(4), G, w - G @ block.mean, N)
    both, noise = np.vstack([H, G]), linalg.block_diag(R, N)
    S = both @ P @ both.T + noise
    gain = linalg.solve(S, both @ P, assume_a="pos").T
    close(block.mean, mean + gain @ (np.append(y, w) - both @ mean), 1e-9)
    left = np.eye(4) - gain @ both
    close(belief.matrix, left @ P @ left.T + gain @ noise @ gain.T, 1e-9)
    m = len(y)
    close(last.covariance, S[m:, m:] - S[m:, :m] @ linalg.solve(S[:m, :m], S[:m, m:]), 1e-9)


@many
@given(seed=SEEDS)
def test_an_update_conditions_a_density(seed):
    """Bayes' rule at any state: log p(x | y) = log p(x) + log p(y | x) - log p(y), by SciPy's densities."""
    rng, _, mean, P, H, R, y = drawn(seed, 4, 0.0)
    P = P + 0.1 * np.eye(4)
    belief = Belief()
    block = belief.add(4, mean, P)
    result = belief.update([block], [H], y - H @ mean, R)
    density, x = stats.multivariate_normal, rng.standard_normal(4)
    prior, given_x = density(mean, P).logpdf(x), density(H @ x, R).logpdf(y)
    close(
        density(block.mean, belief.matrix).logpdf(x),
        prior + given_x - density(H @ mean, result.covariance).logpdf(y),
        1e-9,
    )


@few
@given(seed=SEEDS, rank=RANKS)
def test_a_prediction_and_a_later_measurement_beside_all_at_once(seed, rank):
    """Predict, correlate with another block, update: beside the joint Gaussian of all that was drawn."""
    rng, _, mean, P, H, R, z = drawn(seed, rank, 0.0)
    F, Q, G = rng.standard_normal((4, 4)), covariance(rng, 4), rng.standard_normal((2, 4))
    belief = Belief()
    block = belief.add(4, mean, P)
    other = belief.add(2, np.zeros(2), np.eye(2), given=[block], jacobians=[G])
    belief.predict(block, F @ mean, F, Q)
    # All of it is a linear function of x, the other's noise, the motion's noise
    sources = linalg.block_diag(P, np.eye(2), Q)
    ahead = np.block([[F, np.zeros((4, 2)), np.eye(4)], [G, np.eye(2), np.zeros((2, 4))]])
    joint = ahead @ sources @ ahead.T
    close(belief.matrix, joint, 1e-12)
    belief.update_all([LinearizedMeasurement([block], [H], z, R)])
    H = np.hstack([H, np.zeros((len(z), 2))])
    gain = linalg.solve(H @ joint @ H.T + R, H @ joint, assume_a="pos").T
    close(belief.matrix, joint - gain @ H @ joint, 1e-9)  # this form loses what the prior is larger
    close(other.mean, (gain @ z)[4:], 1e-11)


@settings(max_examples=10, deadline=None)
@given(seed=SEEDS)
def test_the_steady_state_solves_riccati_s_equation(seed):
    rng = np.random.default_rng(seed)
    F, H = rng.standard_normal((3, 3)) / 2, rng.standard_normal((2, 3))
    Q, R = covariance(rng, 3) + 0.1 * np.eye(3), covariance(rng, 2) + 0.1 * np.eye(2)
    belief = Belief()
    block = belief.add(3, np.zeros(3), np.eye(3))
    for _ in range(300):
        belief.update([block], [H], np.zeros(2), R)
        belief.predict(block, np.zeros(3), F, Q)
    close(belief.matrix, linalg.solve_discrete_are(F.T, H.T, Q, R), 1e-10)  # SciPy's, through eigenvalues


@few
@given(seed=SEEDS, rank=RANKS)
def test_a_belief_that_keeps_its_past_is_least_squares_over_all_of_it(seed, rank):
    """Each state a block, given the one before: in the end the smoothed path, by one whitened system of equations."""
    rng = np.random.default_rng(seed)
    count, n = 5, 3
    prior, mean = covariance(rng, n) + 0.1 * np.eye(n), rng.standard_normal(n)
    belief, rows, right = Belief(), [np.eye(n, n * count)], [mean]
    states, noises = [belief.add(n, mean, prior)], [prior]
    for k in range(count):
        if k:
            F, Q, u = rng.standard_normal((n, n)), covariance(rng, n) + 0.1 * np.eye(n), rng.standard_normal(n)
            states.append(belief.add(n, F @ states[-1].mean + u, Q, given=[states[-1]], jacobians=[F]))
            row = np.zeros((n, n * count))
            row[:, n * k : n * k + n], row[:, n * k - n : n * k] = np.eye(n), -F
            rows, right, noises = [*rows, row], [*right, u], [*noises, Q]
        if rank and k % rank == 0:  # not every state is measured
            H, R, y = rng.standard_normal((2, n)), covariance(rng, 2) + 0.1 * np.eye(2), rng.standard_normal(2)
            belief.update([states[k]], [H], y - H @ states[k].mean, R)
            row = np.zeros((2, n * count))
            row[:, n * k : n * k + n] = H
            rows, right, noises = [*rows, row], [*right, y], [*noises, R]
    white = [linalg.cholesky(noise, lower=True) for noise in noises]
    A = np.concatenate([linalg.solve_triangular(w, row, lower=True) for w, row in zip(white, rows, strict=True)])
    b = np.concatenate([linalg.solve_triangular(w, y, lower=True) for w, y in zip(white, right, strict=True)])
    close(np.concatenate([s.mean for s in states]), linalg.lstsq(A, b)[0], 1e-9)
    close(belief.matrix, linalg.inv(A.T @ A), 1e-9)


# -- consistency -------------------------------------------------------------------------------------------------------

DOF = st.one_of(st.integers(1, 12), st.floats(0.3, 1e4), st.sampled_from([1e5, 1e6]))
PROBABILITY = st.one_of(st.floats(-300, -0.01).map(lambda e: 10.0**e), st.floats(1e-3, 1 - 1e-15))


@settings(max_examples=300, deadline=None)
@given(dof=DOF, p=PROBABILITY, x=st.floats(0, 4))
def test_chi_square_and_its_tails(dof, p, x):
    """Of a million degrees of freedom SciPy's tails have eight digits: rounding grows with what the density cancels."""
    of = stats.chi2(dof)
    place = x * dof
    digits = {"rtol": max(1e-10, 1e-14 * dof), "atol": 1e-300}
    np.testing.assert_allclose(chi2_cdf(place, dof), of.cdf(place), **digits)
    np.testing.assert_allclose(chi2_sf(place, dof), of.sf(place), **digits)
    if of.ppf(p) > 1e-290:
        np.testing.assert_allclose(chi2_quantile(p, dof), of.ppf(p), rtol=1e-10)
    np.testing.assert_allclose(chi2_quantile(p, dof, upper=True), of.isf(p), rtol=1e-10)


@many
@given(dof=st.integers(1, 12), runs=st.integers(1, 200), probability=st.floats(0.01, 1 - 1e-9))
def test_bands(dof, runs, probability):
    low, high = band(dof, runs, probability)
    wanted = stats.chi2(dof * runs).interval(probability)
    np.testing.assert_allclose([low, high], np.array(wanted) / runs, rtol=1e-7)  # SciPy's tail is 1 - p, rounded


@many
@given(seed=SEEDS, n=st.integers(1, 6), rank=st.integers(1, 6), spread=st.sampled_from([0.0, 12.0]))
def test_nees_is_the_square_of_mahalanobis_distance(seed, n, rank, spread):
    rng = np.random.default_rng(seed)
    units = 10.0 ** rng.uniform(-spread / 2, spread / 2, n)
    P, e = covariance(rng, n) + 0.1 * np.eye(n), rng.standard_normal(n)
    wanted = mahalanobis(e, np.zeros(n), linalg.inv(P)) ** 2
    np.testing.assert_allclose(nees(units * e, units[:, None] * P * units), wanted, rtol=1e-11)
    low = covariance(rng, n, rank=min(rank, n))
    square, dof = nees_in_range(e, low)
    kept = linalg.eigvalsh(low) > 1e-12 * linalg.eigvalsh(low)[-1]
    assert dof == kept.sum()
    pseudo = linalg.pinvh(low, rtol=1e-12)
    np.testing.assert_allclose(square, e @ pseudo @ e, rtol=1e-6)  # both divide by the least eigenvalue that is kept


@many
@given(seed=SEEDS, rank=st.integers(1, 4), unit=st.sampled_from([1e-5, 1.0, 1e5]))
def test_nees_of_two_units_in_the_range_of_a_covariance(seed, rank, unit):
    """Each unit is scaled by its largest standard deviation; the rest is the pseudo-inverse."""
    rng, units = np.random.default_rng(seed), np.array([1.0, 1.0, unit, unit])
    P, e = units[:, None] * covariance(rng, 4, rank=rank) * units, units * rng.standard_normal(4)
    scale = np.sqrt(np.repeat([P.diagonal()[:2].max(), P.diagonal()[2:].max()], 2))
    scaled = P / np.outer(scale, scale)
    values = linalg.eigvalsh(scaled)
    square, dof = nees_in_range(e, P, (2, 2))
    assert dof == (values > 1e-12 * values[-1]).sum() == rank
    np.testing.assert_allclose(square, e / scale @ linalg.pinvh(scaled, rtol=1e-12) @ (e / scale), rtol=1e-6)


@few
@given(seed=SEEDS)
def test_the_largest_compatible_set_by_squares_of_all_stacked(seed):
    """Every subset's z' S^-1 z from its own stacked matrix, beside SciPy's quantile; JCBB marginalizes instead."""
    rng = np.random.default_rng(seed)
    n, d = 6, 2
    S = covariance(rng, n * d, rank=3) * 9 + np.eye(n * d)  # strongly correlated, as by one pose
    z = linalg.cholesky(S, lower=True) @ rng.standard_normal(n * d)
    z[: 2 * int(rng.integers(0, 4))] += rng.normal(0, 5)  # up to three outliers
    fits = []
    for mask in np.ndindex((2,) * n):
        kept = np.repeat(np.array(mask, dtype=bool), d)
        if kept.any():
            square = mahalanobis(z[kept], np.zeros(kept.sum()), linalg.inv(S[np.ix_(kept, kept)])) ** 2
            if square < stats.chi2.ppf(0.95, kept.sum()):
                fits.append((-sum(mask), square, mask))
    found = jcbb(z.reshape(n, d), S.reshape(n, d, n, d), np.full(n, d), lambda dof: chi2_quantile(0.95, dof), 10**9)
    assert found.astype(int).tolist() == (list(min(fits)[2]) if fits else [0] * n)


# -- trajectories ------------------------------------------------------------------------------------------------------


@few
@given(seed=SEEDS, flat=st.booleans(), mirrored=st.booleans(), scale=st.booleans())
def test_alignment(seed, flat, mirrored, scale):
    """Rotation.align_vectors solves the same problem of Wahba; a plane and a mirror image are its corners."""
    rng = np.random.default_rng(seed)
    x = rng.standard_normal((12, 3)) * [1, 1, 0 if flat else 1]
    turn = Rotation.random(rng=rng)
    y = turn.apply(rng.uniform(0.2, 5) * x * [1, 1, -1 if mirrored else 1]) + rng.normal(0, 0.3, (12, 3))
    found = align(x, y, scale=scale)
    R, residual = Rotation.align_vectors(y - y.mean(0), x - x.mean(0))
    close(found.rotation, R.as_matrix(), 1e-9)  # SciPy's residual is a difference of squares
    turned = R.apply(x - x.mean(0))
    s = linalg.lstsq(turned.reshape(-1, 1), (y - y.mean(0)).ravel())[0].item() if scale else 1.0
    close(found.scale, s, 1e-11)
    close(found.translation, y.mean(0) - found.scale * R.apply(x.mean(0)), 1e-9)
    if not scale:
        close(np.linalg.norm(found(x) - y), residual, 1e-7)


@few
@given(seed=SEEDS)
def test_alignment_by_orientations_is_their_mean(seed):
    """In one place the rotation is the mean of those between the orientations, Rotation.mean."""
    rng = np.random.default_rng(seed)
    of_reference, of_estimate = Rotation.random(9, rng=rng), Rotation.random(9, rng=rng)
    of_estimate = (
        Rotation.from_rotvec(rng.standard_normal(3))
        * of_reference
        * Rotation.from_rotvec(0.3 * rng.standard_normal((9, 3)))
        if seed % 2
        else of_estimate
    )
    place, times = np.tile(rng.standard_normal(3), (9, 1)), np.arange(9.0)
    estimate, reference = (Trajectory(times, np.hstack([place, of_ours(r)])) for r in (of_estimate, of_reference))
    found = align_trajectory(estimate, reference, scale=False)
    assert found.rotation_from == "orientations"
    mean = (of_reference * of_estimate.inv()).mean()
    close(found.similarity.rotation, mean.as_matrix(), 1e-9)
    close(found.orientation, (of_reference.inv() * mean * of_estimate).magnitude(), 1e-9)
