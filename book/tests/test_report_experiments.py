"""Page report_experiments' runs of the report's filter: their results are right, and the file stores them."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from slambook.report import correlations, fastslam, limits, memory, planar, planar_runs, speed, updates
from slambook.report.filter import OF_THE_UPDATE, BatchUpdateFilter, Memory
from slambook.report.planar_ekf import PlanarEkf
from slambook.report.runs import monte_carlo
from slambook.report.scenes import SCENES
from slambook.report.switches import SWITCHES

from book.experiments import mrpt
from book.experiments import report_experiments as tool
from book.experiments import stored as results
from book.tests.stored_results import comes_out_again
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.evaluation.consistency import band, nees

RENEW = "run `make report-experiments` and `python -m book.tools.notebooks run book/sources/report_experiments.ipynb`"
SURE = 0.999  # of the bands that a test asserts
REFUSED = {"E09", "E13", "E18"}  # errors of which the shapes do not fit


# The methods of an update.


@pytest.mark.parametrize(("landmarks", "seen"), [(1, 1), (6, 4), (30, 12), (30, 30)])
def test_all_ways_give_the_same(landmarks, seen):
    given = updates.problem(np.random.default_rng(landmarks), landmarks, seen)
    before = given.x.copy(), given.P.copy()
    x, P = updates.naive(given)()
    for name, way in updates.WAYS.items():
        y, Q = way(given)()
        np.testing.assert_allclose(y, x, rtol=0, atol=1e-12 * np.abs(x - given.x).max() * len(x), err_msg=name)
        np.testing.assert_allclose(Q, P, rtol=0, atol=1e-12 * np.abs(given.P).max(), err_msg=name)
    np.testing.assert_array_equal(given.x, before[0])
    np.testing.assert_array_equal(given.P, before[1])


class Counted:
    """An exact number that counts multiplications and divisions; arrays take it for an object."""

    count = 0

    def __init__(self, value):
        self.value = value.value if isinstance(value, Counted) else Fraction(value)

    def __eq__(self, other):
        return self.value == Counted(other).value

    def __add__(self, other):
        return NotImplemented if isinstance(other, np.ndarray) else Counted(self.value + Counted(other).value)

    def __sub__(self, other):
        return NotImplemented if isinstance(other, np.ndarray) else Counted(self.value - Counted(other).value)

    def __rsub__(self, other):
        return Counted(Counted(other).value - self.value)

    def __mul__(self, other):
        if isinstance(other, np.ndarray):
            return NotImplemented
        Counted.count += 1
        return Counted(self.value * Counted(other).value)

    def __truediv__(self, other):
        Counted.count += 1
        return Counted(self.value / Counted(other).value)

    __hash__, __radd__, __rmul__ = None, __add__, __mul__


def exact(array):
    """The array's numbers, rounded to a few binary digits, as exact ones."""
    rounded = np.round(np.asarray(array, dtype=float) * 64).astype(int)
    return np.array([Counted(Fraction(int(v), 64)) for v in rounded.ravel()], dtype=object).reshape(rounded.shape)


def inverse(matrix):
    """Gauss and Jordan's, for exact numbers: k^3 multiplications and divisions."""
    n = len(matrix)
    a = matrix.copy()
    for i in range(n):
        pivot = a[i, i]
        a[i, i] = Counted(1)
        a[i] = a[i] / pivot
        for j in range(n):
            if j != i:
                factor = a[j, i]
                a[j, i] = Counted(0)
                a[j] = a[j] - factor * a[i]
    return a


def exact_problem():
    given = updates.problem(np.random.default_rng(3), 3, 2)
    root = exact(np.random.default_rng(4).standard_normal((15, 15)))
    return updates.Problem(
        exact(given.x), root @ root.T, given.places, exact(given.H), exact(given.difference), exact(given.variances + 1)
    )


def test_in_exact_arithmetic_both_ways_are_equal_and_their_multiplications_are_as_many_as_stated():
    given = exact_problem()
    said = updates.multiplications(3, 2)
    Counted.count = 0
    x, P = updates.naive(given, inverse)()
    whole, Counted.count = Counted.count, 0
    y, Q = updates.scalar(given)()
    assert all(x == y)
    assert (P == Q).all()
    assert whole == said["whole matrices"]
    assert Counted.count == said["number by number"]


def test_crossing():
    row = speed.Timing(0, 0, 100, {"a": 1.0, "b": 2.0}, {}, 0)
    rows = [row, replace(row, size=400, seconds={"a": 8.0, "b": 4.0}), replace(row, size=900)]
    first, second = speed.crossing(rows, "a", "b")
    assert first == pytest.approx(200)
    assert 400 < second < 900
    assert speed.crossing(rows[:1] * 2, "a", "b") == []


def test_timings_have_what_they_say():
    (row,) = speed.timings(np.random.default_rng(0), [(10, 4)], repeats=1)
    assert (row.size, row.landmarks, row.seen) == (36, 10, 4)
    assert set(row.seconds) == set(row.multiplications) == set(updates.WAYS)
    assert row.apart < 1e-11


def test_chapter_6_maps_92_of_100_and_every_way_makes_the_same_map():
    found = speed.mapping(np.random.default_rng(6), steps=8)
    assert {m.mapped for m in found} == {92}
    assert max(m.apart for m in found) < 1e-11
    assert found[2].multiplications < found[0].multiplications / 3
    assert sum(planned(speed.hundred(np.random.default_rng(6)))) == 92


def planned(scene):
    return np.any([scene.sees(speed.by_vectors(pose, scene.points)) for pose in scene.path()], axis=0)


def test_what_is_linearised_anew_changes_little_where_little_bends():
    found = speed.accuracy(np.random.default_rng(6), runs=10, steps=20)
    gain, error = found.gain
    assert abs(gain) < 0.02
    assert error < 0.02


# One update for many runs side by side.


@pytest.mark.parametrize("errors", [[], *([name] for name in SWITCHES if name not in REFUSED)], ids=" ".join)
def test_together_is_number_by_number_unless_the_update_has_an_error(errors):
    """What `ran` takes to be no error of the update is none, and what it takes to be one is one; E11 is of words."""
    scene = replace(SCENES["rig"](), controls=SCENES["rig"]().controls[:5])
    one, other = (monte_carlo(scene, *errors, runs=2, seed=3, make=make) for make in (Memory, BatchUpdateFilter))
    same = errors == ["E11"] or not OF_THE_UPDATE & {field for name in errors for field in SWITCHES[name].wrong}
    assert np.allclose(other.last.x, one.last.x, rtol=0, atol=1e-11) == same
    assert np.allclose(other.last.P, one.last.P, rtol=0, atol=1e-12) == same


# Memory.


@pytest.fixture(scope="module")
def remembered():
    return {r.name: r for r in memory.compare(np.random.default_rng(22), runs=40)}


def test_with_everything_or_a_window_the_filter_knows_its_error_at_each_step(remembered):
    low, high = band(memory.DOF, 40, SURE)
    for name in ("everything", "window 1", "window 5", "window 20", "two pictures, P kept, second look"):
        found = remembered[name].consistency
        print(found)
        assert ((found.average > low) & (found.average < high)).all(), name


def test_two_pictures_as_printed_claim_the_same_whatever_happens(remembered):
    printed = remembered["two pictures, as printed"]
    assert printed.claimed[-1] / printed.claimed[10] == pytest.approx(1, abs=0.2)
    assert printed.position[-1] > 2 * printed.position[10]
    assert printed.consistency.average[-1] > 100


def test_only_what_remembers_the_beginning_closes_the_loop(remembered):
    whole = remembered["everything"]
    for name, found in remembered.items():
        if name != "everything":
            assert found.position[57] > 1.5 * whole.position[57], name
    assert whole.position[57] < whole.position[45]


def test_the_window_deletes_what_it_should(remembered):
    seen = [len(np.flatnonzero(memory.ring(np.random.default_rng(22)).sees(r))) for r in _relative()]
    np.testing.assert_array_equal(remembered["window 1"].landmarks, seen[1:])
    assert (np.diff(remembered["everything"].landmarks) >= 0).all()
    assert (remembered["window 5"].landmarks >= remembered["window 1"].landmarks).all()
    assert (remembered["window 20"].landmarks >= remembered["window 5"].landmarks).all()


def _relative():
    scene = memory.ring(np.random.default_rng(22))
    return [speed.by_vectors(pose, scene.points) for pose in scene.path()]


def test_an_unknown_way_to_remember():
    with pytest.raises(UnknownNameError, match="window 5"):
        memory.compare(np.random.default_rng(0), 1, 2, ["window 6"])


# Correlations.


def test_correlations_are_those_of_the_filter():
    found = correlations.experiment(np.random.default_rng(7), runs=1000)
    for name, compared in found.items():
        dof = len(compared.claimed)
        low, high = band(dof, compared.runs, SURE)
        assert low < compared.nees < high, name
        for row in correlations.table(compared):
            assert row.difference < 2 * row.sampling, (name, row)
            assert row.z < 2, (name, row)
    assert max(row.correlation for row in correlations.table(found["SLAM"])) > 0.3
    assert sum(row.pairs for row in correlations.table(found["SLAM"])) == 36 * 35 // 2


def test_correlations_that_are_not_those_of_the_filter_show():
    """The test above would notice: correlations of the map left out, as in E18."""
    found = correlations.experiment(np.random.default_rng(7), runs=1000)["SLAM"]
    wrong = replace(found, claimed=np.eye(len(found.claimed)))
    assert max(row.difference / row.sampling for row in correlations.table(wrong)) > 5


# The limit of a map.


@pytest.mark.parametrize(("start", "motion"), [(0.5, 0.1), (0.0, 0.1), (0.3, 0.0), (0.2, 0.5)])
def test_landmarks_tend_to_the_bound_and_to_one_error(start, motion):
    found = limits.repeated_observations(4000, start=start, motion=motion)
    np.testing.assert_allclose(found.absolute[-1], found.bound, rtol=5e-3)
    assert (found.absolute[-1] > found.bound).all()
    assert found.correlation[-1].min() > 0.98
    assert (np.diff(found.absolute[:, 0]) <= 1e-12).all()


def test_without_an_error_of_the_robot_nothing_is_common():
    found = limits.repeated_observations(50, start=0, motion=0)
    np.testing.assert_allclose(found.correlation, 0, atol=1e-9)
    np.testing.assert_allclose(found.absolute[-1], 0.2 / np.sqrt(50), rtol=1e-9)


def test_the_relative_map_does_not_know_where_the_start_is():
    here, there = (limits.repeated_observations(60, start=start) for start in (0.1, 3.0))
    np.testing.assert_allclose(here.relative, there.relative, rtol=1e-9)
    everything = limits.repeated_observations(400)
    np.testing.assert_allclose(everything.relative[-1], np.sqrt(2 / 400) * 0.2, rtol=0.01)


def test_given_the_path_landmarks_have_nothing_in_common():
    whole, given_last, given_path = common(12, 5, 0.5, 0.1, 0.2)
    assert given_path < 1e-12
    assert 0.05 < given_last < whole
    last = limits.repeated_observations(12, motion=0.1)
    assert whole == pytest.approx(last.correlation[-1].max(), rel=1e-9)


def common(scans, landmarks, start, motion, noise):
    """Largest correlation between two landmarks: of the map, given the robot's last position, and given its path.

    In the information matrix of all poses and landmarks, the sum of what odometry and scans add, no entry stands
    between two landmarks: given the path they are independent, which FastSLAM uses.
    """
    n = scans + landmarks  # poses, then landmarks
    rows = [np.eye(n)[0] / start]
    rows += [(np.eye(n)[k + 1] - np.eye(n)[k]) / motion for k in range(scans - 1)]
    rows += [(np.eye(n)[scans + i] - np.eye(n)[k]) / noise for k in range(scans) for i in range(landmarks)]
    information = np.array(rows).T @ np.array(rows)
    keep = np.r_[: scans - 1, scans:n]  # condition on a pose: delete its row and column
    last = np.linalg.inv(information[np.ix_(keep, keep)])[scans - 1 :, scans - 1 :]
    whole, path = np.linalg.inv(information)[scans:, scans:], np.linalg.inv(information[scans:, scans:])
    return [np.abs(normalised(P) - np.eye(landmarks)).max() for P in (whole, last, path)]


@pytest.mark.parametrize("few", [{"landmarks": 1}, {"observations": 0}])
def test_a_corridor_that_cannot_be(few):
    with pytest.raises(SlamlibError, match="two landmarks or more, and one scan or more"):
        limits.repeated_observations(**few)


# FastSLAM.


def test_derivatives_of_the_plane():
    rng, e = np.random.default_rng(1), 1e-6
    pose, u, m = rng.normal(0, 1, 3), rng.normal(0, 1, 3), rng.normal(0, 5, (1, 2))
    F, G = planar.moved_by(pose, u)
    for i in range(3):
        d = e * np.eye(3)[i]
        np.testing.assert_allclose(F[:, i], (planar.moved(pose + d, u) - planar.moved(pose - d, u)) / 2 / e, atol=1e-8)
        np.testing.assert_allclose(G[:, i], (planar.moved(pose, u + d) - planar.moved(pose, u - d)) / 2 / e, atol=1e-8)
    for i in range(2):
        d = e * np.eye(2)[i]
        found = (planar.seen(pose, m + d) - planar.seen(pose, m - d))[0] / 2 / e
        np.testing.assert_allclose(planar.seen_by_point(pose, m)[0, :, i], found, atol=1e-8)
    np.testing.assert_allclose(planar.placed(pose, planar.seen(pose, m)), m, atol=1e-12)


def test_systematic_draws_each_particle_its_share_of_times():
    rng = np.random.default_rng(2)
    weights = rng.dirichlet(np.full(20, 0.5))
    counts = np.array([np.bincount(fastslam.systematic(weights, rng), minlength=20) for _ in range(4000)])
    assert (np.abs(counts - 20 * weights) < 1 + 1e-9).all()
    np.testing.assert_allclose(counts.mean(0), 20 * weights, atol=5 * 0.5 / np.sqrt(4000))
    assert (np.diff(fastslam.systematic(weights, rng)) >= 0).all()


def quiet(steps):
    """A drive with so little noise that nothing bends."""
    data = planar.drive(np.random.default_rng(4), steps)
    rng, motion, scan = np.random.default_rng(5), planar.MOTION / 20, planar.LOOK / 20
    truth = [
        planar.PlanarScan(v.names, planar.seen(p, data.points[v.names]))
        for p, v in zip(data.truth, data.scans, strict=True)
    ]
    scans = [planar.PlanarScan(v.names, v.z + scan * rng.standard_normal(v.z.shape)) for v in truth]
    true = np.array([0.8, 0, 2 * np.pi / planar.LAP])
    odometry = true + motion * rng.standard_normal((steps, 3))
    return replace(data, odometry=odometry, scans=scans, motion_std=motion, look_std=scan)


def test_where_nothing_bends_many_particles_are_the_kalman_filter():
    """Weights, landmarks' filters and drawing all enter: a wrong one shows."""
    data, n = quiet(3), 40000
    ekf, particles = PlanarEkf(data), fastslam.FastSlam(data, n, np.random.default_rng(6))
    for u, scan in zip(data.odometry, data.scans[1:], strict=True):
        ekf.step(u, scan)
        particles.step(u, scan)
    (x, P), (y, Q) = ekf.pose(), particles.pose()
    effective = particles.effective[-1] / 8  # some are copies of each other
    assert nees(y - x, P) < 40 / effective
    np.testing.assert_allclose(Q / np.sqrt(np.outer(P.diagonal(), P.diagonal())), normalised(P), atol=0.08)
    maps, others = ekf.map(), particles.map()
    assert set(maps) == set(others)
    for name, (m, C) in maps.items():
        assert nees(others[name][0] - m, C) < 0.02
        np.testing.assert_allclose(np.sqrt(others[name][1].diagonal()), np.sqrt(C.diagonal()), rtol=0.08)


def normalised(P):
    return P / np.sqrt(np.outer(P.diagonal(), P.diagonal()))


def test_a_path_known_exactly_leaves_a_kalman_filter_for_each_landmark():
    data = replace(planar.drive(np.random.default_rng(8), 6), motion_std=np.zeros(3))
    data = replace(data, odometry=np.tile([0.8, 0, 2 * np.pi / planar.LAP], (6, 1)))
    ekf, particles = PlanarEkf(data), fastslam.FastSlam(data, 3, np.random.default_rng(0))
    for u, scan in zip(data.odometry, data.scans[1:], strict=True):
        ekf.step(u, scan)
        particles.step(u, scan)
    np.testing.assert_allclose(particles.weights, 1 / 3)
    for name, (m, C) in ekf.map().items():
        np.testing.assert_allclose(particles.map()[name][0], m, atol=1e-10)
        np.testing.assert_allclose(particles.map()[name][1], C, atol=1e-12)


@pytest.mark.parametrize(("particles", "share"), [(0, 0.5), (5, 2.0)])
def test_what_no_filter_can_be_made_of(particles, share):
    with pytest.raises(SlamlibError, match="one particle or more, and a share of 0 to 1"):
        fastslam.FastSlam(planar.drive(np.random.default_rng(1), 2), particles, np.random.default_rng(0), share)


def test_ancestors_are_counted_back():
    data = planar.drive(np.random.default_rng(1), 4)
    filter = fastslam.FastSlam(data, 4, np.random.default_rng(0))
    filter.parents = [np.arange(4), np.array([0, 0, 1, 3]), np.array([0, 1, 1, 2])]
    np.testing.assert_array_equal(filter.ancestors(), [2, 3, 4])


@pytest.fixture(scope="module")
def contest():
    return planar_runs.compare(np.random.default_rng(22), runs=20, particles=(0, 10, 300))


def test_the_kalman_filter_of_the_plane_knows_its_error_at_each_step(contest):
    low, high = band(3, 20, SURE)
    found = contest[0].consistency
    print(found)
    assert ((found.average > low) & (found.average < high)).all()


def test_particles_lose_their_history(contest):
    ekf, few, many = contest
    assert few.position[-1] > many.position[-1] > ekf.position[-1]
    assert few.map_error > many.map_error > ekf.map_error
    assert many.ancestors[0] < 3
    assert many.ancestors[-1] == 300
    assert many.consistency.inside < ekf.consistency.inside
    assert few.typical > many.typical > 2
    assert ekf.typical == pytest.approx(1, abs=0.3)


def test_one_contestant_does_not_depend_on_the_others():
    alone = planar_runs.compare(np.random.default_rng(2), 2, 5, (10,))[0]
    beside = planar_runs.compare(np.random.default_rng(2), 2, 5, (0, 10))[1]
    np.testing.assert_array_equal(alone.nees, beside.nees)


# The extra row.


@pytest.mark.skipif(not mrpt.available(), reason="MRPT (libmrpt-bayes-dev) or g++ is not installed")
def test_mrpts_number_by_number_has_an_old_innovation_within_a_landmark():
    given = updates.problem(np.random.default_rng(1), 12, 5)
    x, P = updates.naive(given)()
    with mrpt.compiled() as program:
        found = mrpt.run_update(program, given, 1)
    for method in found.values():
        np.testing.assert_allclose(method.state[1], P, atol=1e-12)
    np.testing.assert_allclose(found["naive"].state[0], x, atol=1e-12)
    np.testing.assert_allclose(found["davison"].state[0], stale(given), atol=1e-12)
    assert np.abs(found["davison"].state[0] - x).max() > 1e-3


def stale(given):
    """Number by number, each landmark's three with the innovation before the first of them."""
    x, P = given.x.copy(), given.P.copy()
    for i in range(len(given.places)):
        at = given.columns(i)
        left = given.difference[i] - given.H[i] @ (x[at] - given.x[at])
        for h, innovation, variance in zip(given.H[i], left, given.variances[i], strict=True):
            Ph = P[:, at] @ h
            K = Ph / (Ph[at] @ h + variance)
            x += K * innovation
            P -= np.outer(K, Ph)
    return x


# The stored file.


@pytest.fixture(scope="module")
def stored():
    return results.kept(tool.FILE)


def test_form_of_the_stored_experiments_is_of_these_sizes(stored):
    assert stored["digest"] == tool.digest(), RENEW
    assert set(stored) >= {*tool.EXPERIMENTS, "light", "machine"}


@pytest.mark.parametrize("name", tool.EXPERIMENTS)
def test_the_light_run_comes_out_again(stored, name):
    found = tool.EXPERIMENTS[name](**tool.LIGHT[name])
    comes_out_again(found, stored["light"][name], RENEW, places=9)  # rounding errors are rounding errors


def test_a_finished_part_is_not_run_again(tmp_path, monkeypatch):
    monkeypatch.setattr(tool, "FOLDER", tmp_path)
    assert tool.kept("light", lambda: {"a": 1}) == {"a": 1}
    assert tool.kept("light", lambda: pytest.fail("run again")) == {"a": 1}
