"""Every number E01 to E30 of the report's errata comes out again, and the chapter's file is what comes out."""

import json
import math

import numpy as np
import pytest
from slambook.report import SWITCHES, Memory, equations, motion, observation
from slambook.report.angles import rotation
from slambook.report.checks import CHECKS
from slambook.report.findings import RUNS, SEED, AuditCheck, AuditFigure, at_least, at_most, near, ran

from book.experiments import audit
from slamlib.belief import Belief, LinearizedMeasurement
from slamlib.errors import UnknownNameError
from slamlib.motions.euler_composition import compose

NUMBERS = [f"E{i:02d}" for i in range(1, 31)]
WILD = 1e3  # beyond this a run has diverged, and its figures are those of one machine
RENEW = "run `make audit ARGS=--store`"


@pytest.fixture(scope="module")
def stored():
    if not audit.FILE.is_file():
        pytest.skip(RENEW)
    return json.loads(audit.FILE.read_text("utf-8"))


def test_every_number_has_a_check():
    assert sorted(CHECKS) == NUMBERS


@pytest.mark.parametrize("number", NUMBERS)
def test_number(number, stored):
    row = CHECKS[number].run()
    assert row.holds, audit.text(row)
    kept = next(r for r in stored["rows"] if r["number"] == number)
    now = audit.plain(row)
    assert {k: now[k] for k in ("where", "says", "right", "verdict")} == {
        k: kept[k] for k in ("where", "says", "right", "verdict")
    }, RENEW
    for figure, before in zip(now["figures"], kept["figures"], strict=True):
        assert figure["what"] == before["what"], RENEW
        if _judged(figure) and _tame(figure["measured"]):
            np.testing.assert_allclose(figure["measured"], before["measured"], rtol=0.02, atol=1e-5, err_msg=RENEW)


def _judged(figure: dict) -> bool:
    """True unless a plain figure has no limits at all, as times of a machine have none."""
    return [figure["low"], figure["high"]] != ["-inf", "inf"]


def _tame(value: float | str) -> bool:
    return not isinstance(value, str) and abs(value) < WILD


def test_stored_runs_are_those_of_now(stored):
    assert {n: s["slip"] for n, s in stored["switches"].items()} == {n: s.slip for n, s in SWITCHES.items()}, RENEW
    assert (stored["runs"], stored["seed"]) == (RUNS, SEED), RENEW
    run = ran("gentle", "E19")  # which its number has made above
    np.testing.assert_allclose(audit.summary(run)["nees"], stored["scenes"]["gentle"]["E19"]["nees"], rtol=0.02)


def test_a_switch_changes_what_it_names_and_nothing_else():
    right = equations()
    for name, switch in SWITCHES.items():
        wrong = equations(name)
        changed = {f for f in vars(right) if getattr(wrong, f) is not getattr(right, f)}
        assert changed == set(switch.wrong) == set(switch.right)
        assert all(switch.right[f] is getattr(right, f) for f in changed)
    with pytest.raises(UnknownNameError, match="did you mean 'E04'"):
        equations("E4")


def test_all_switches_together_are_the_union():
    both = equations("E07", "E08")
    assert both.rows is SWITCHES["E07"].wrong["rows"]
    assert both.noise_rows is SWITCHES["E08"].wrong["noise_rows"]


def test_one_run_is_a_run_among_several():
    rng = np.random.default_rng(0)
    x, z = rng.uniform(-0.2, 0.2, (3, 6)), rng.uniform(1, 3, (3, 4, 3))
    U, R, u = 1e-4 * np.eye(6), 0.01 * np.eye(3), rng.uniform(-0.1, 0.1, (3, 6))

    def drive(part):
        filter = Memory(x[part].copy(), np.zeros((len(x[part]), 6, 6)))
        filter.initialize(z[part], [5, 3, 8, 1], R, first=True)
        filter.predict(u[part], U)
        filter.update(z[part][:, [2, 0]], [8, 5], R)
        return filter

    together, alone = drive(slice(0, 3)), drive(slice(1, 2))
    np.testing.assert_allclose(together.x[1], alone.x[0], atol=1e-12)
    np.testing.assert_allclose(together.P[1], alone.P[0], atol=1e-12)
    assert alone.names == [5, 3, 8, 1]


def test_the_corrected_filter_is_slamlibs_belief():
    rng = np.random.default_rng(1)
    x, u = np.array([0.1, 0.2, 0.3, 0.4, 0.2, -0.1]), np.array([0.3, 0.1, 0, 0.1, -0.02, 0.03])
    U, R = np.diag([1, 2, 3, 4, 5, 6]) * 1e-4, np.array([[4, 1, 2], [1, 5, 0], [2, 0, 6]]) * 1e-3
    root = 0.05 * rng.standard_normal((6, 6))
    filter = Memory(x[None].copy(), (root @ root.T)[None])
    belief = Belief()
    pose = belief.add(6, x, root @ root.T)
    points = []
    for z in rng.uniform(1, 4, (3, 3)):
        own = rotation(x[3:]) @ R @ rotation(x[3:]).T
        J = observation.placed_by_pose(x[None], z[None, None])[0, 0]
        points.append(belief.add(3, observation.placed(x, z[None])[0], own, given=[pose], jacobians=[J]))
        filter.initialize(z[None, None], [len(points)], R)
    new, J = compose.jac(x, u)
    belief.predict(pose, new, J.pose, J.control @ U @ J.control.T)
    filter.predict(motion.inverse(u)[None], U)
    np.testing.assert_allclose(filter.P[0], belief.matrix, atol=1e-14)
    seen = observation.by_vectors(new, np.array([points[2].mean, points[0].mean])) + 0.05
    H = observation.by_pose(new, np.array([points[2].mean, points[0].mean]))
    both = [
        LinearizedMeasurement([pose, p], [h, rotation(new[3:]).T], np.full(3, 0.05), R)
        for p, h in zip((points[2], points[0]), H, strict=True)
    ]
    belief.update_all(both)
    filter.update(seen[None], [3, 1], R)
    np.testing.assert_allclose(filter.P[0], belief.matrix, atol=1e-14)
    np.testing.assert_allclose(filter.x[0], np.concatenate([b.mean for b in belief.blocks]), atol=1e-13)


def test_limits():
    assert near("", 1.05, 1.0, 0.1).holds
    assert not near("", 1.2, 1.0, 0.1).holds
    assert at_least("", math.inf, 3).holds
    assert not at_most("", math.nan, 1).holds
    assert AuditFigure("", 7, -math.inf, math.inf).tolerance == "not judged"


def test_a_failure_is_the_exit_status(monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["audit", "--only", "E11", "E30"])
    assert audit.main() == 0
    assert "2 numbers, 1 computed, 1 read; all within their limits" in capsys.readouterr().out
    broken = AuditCheck("E11", "", "", "", lambda: iter([near("wrong", 2, 1, 0.1)]))
    monkeypatch.setitem(CHECKS, "E11", broken)
    assert audit.main() == 1
    assert "FAILED: E11" in capsys.readouterr().out


def test_json_and_unknown_numbers(monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["audit", "--only", "E11", "--json"])
    assert audit.main() == 0
    assert json.loads(capsys.readouterr().out)[0]["number"] == "E11"
    monkeypatch.setattr("sys.argv", ["audit", "--only", "E99"])
    with pytest.raises(SystemExit):
        audit.main()
    assert "unknown number of the list 'E99'" in capsys.readouterr().err
