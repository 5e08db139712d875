"""Many runs: independent of the number of workers, resumable, and consistent where they should be."""

import json
from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band
from slamlib.experiments import monte_carlo as monte_carlo_module
from slamlib.experiments.monte_carlo import FORMAT, NAMES, VERSION, monte_carlo, seeds
from slamlib.experiments.presets import Preset, preset
from slamlib.experiments.runs import Run
from slamlib.motions import MOTIONS, ODOMETRY
from slamlib.plain_data.files import read_archive, write_archive
from slamlib.rigs.setup import Rig
from slamlib.tests.interruptions import interrupted_after

SHORT = replace(preset("points"), frames=8)
SAME = [name for name in NAMES if name != "seconds"]


def equal(a, b):
    return all(np.array_equal(getattr(a, name), getattr(b, name), equal_nan=True) for name in SAME)


def test_any_number_of_workers_gives_the_same():
    pytest.importorskip("joblib", reason="several runs at once need joblib")
    assert equal(monte_carlo(SHORT, 3, seed=4), monte_carlo(SHORT, 3, seed=4, jobs=2))


def test_runs_are_independent_and_depend_on_the_seed():
    a, b = monte_carlo(SHORT, 3, seed=4), monte_carlo(SHORT, 3, seed=5)
    assert len(np.unique(np.concatenate([a.nees[:, -1], b.nees[:, -1]]))) == 6
    assert equal(a, monte_carlo(SHORT, 3, seed=4))


def test_finished_runs_are_kept_and_not_run_again(tmp_path, monkeypatch):
    first = monte_carlo(SHORT, 2, folder=tmp_path)
    more = monte_carlo(SHORT, 3, folder=tmp_path)
    assert np.array_equal(first.nees, more.nees[:2])
    assert len(list(tmp_path.iterdir())) == 3
    other = replace(SHORT, options=replace(SHORT.options, updates=3))
    assert not np.array_equal(monte_carlo(other, 2, folder=tmp_path).nees, first.nees)
    monkeypatch.setattr("slamlib.experiments.monte_carlo.Run", None)  # whatever would be run again would fail
    assert equal(monte_carlo(SHORT, 3, folder=tmp_path), more)


def test_a_finished_run_of_another_version_is_named_with_what_to_do(tmp_path):
    monte_carlo(SHORT, 1, folder=tmp_path)
    (file,) = tmp_path.iterdir()
    _, arrays = read_archive(file, FORMAT, VERSION)
    write_archive(file, FORMAT, VERSION - 1, {}, arrays)
    with pytest.raises(SlamlibError, match=f"has version {VERSION - 1}, .*remove it, and the run is made anew"):
        monte_carlo(SHORT, 1, folder=tmp_path)


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_interruption_keeps_what_is_finished(jobs, tmp_path, monkeypatch):
    """The caller writes each run as it comes: one of many is on its way when Ctrl-C ends them."""
    if jobs > 1:
        pytest.importorskip("joblib", reason="several runs at once need joblib")
    monkeypatch.setattr(monte_carlo_module, "write_archive", interrupted_after(monte_carlo_module.write_archive, 2))
    with pytest.raises(KeyboardInterrupt):
        monte_carlo(SHORT, 8, seed=4, jobs=jobs, folder=tmp_path)
    first = {file: file.stat().st_mtime_ns for file in tmp_path.iterdir()}
    assert len(first) == 2
    monkeypatch.undo()
    found = monte_carlo(SHORT, 8, seed=4, jobs=jobs, folder=tmp_path)
    assert equal(found, monte_carlo(SHORT, 8, seed=4))
    assert {file: file.stat().st_mtime_ns for file in first} == first
    assert len(list(tmp_path.iterdir())) == 8


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_run_that_fails_says_which_it_was(jobs):
    if jobs > 1:
        pytest.importorskip("joblib", reason="several runs at once need joblib")
    wrong = replace(SHORT, worlds=(("thickCloister", {"n": "seven"}),))  # made within the first run
    either = "|".join(map(str, seeds(4, 3)))
    with pytest.raises(SlamlibError, match=rf"^the run of seed ({either}) failed: .* whole number, got 'seven'"):
        monte_carlo(wrong, 3, seed=4, jobs=jobs)


def test_an_error_that_nobody_foresaw_says_in_which_run_it_was(monkeypatch):
    monkeypatch.setattr(Run, "finish", lambda self: 1 / 0)
    with pytest.raises(ZeroDivisionError) as caught:
        monte_carlo(SHORT, 3, seed=4)
    assert caught.value.__notes__ == [f"in the run of seed {seeds(4, 3)[0]}"]


def test_where_runs_are_made_is_said_once():
    with pytest.raises(SlamlibError, match="give one"):
        monte_carlo(SHORT, 3, jobs=2, scheduler="tcp://127.0.0.1:8786")


def test_no_runs_are_refused():
    with pytest.raises(SlamlibError, match="at least one run"):
        monte_carlo(SHORT, 0)


def first_part(kind):
    """Twenty runs of the first fifty frames."""
    p = replace(preset("points"), frames=50)
    return monte_carlo(replace(p, options=replace(p.options, points=kind, reproject=False)), 20)


# Neighbouring steps are correlated: a set of runs that starts high stays high, and few of its steps may be inside a
# 95 % band (seed 7: 14 %, seeds 8 and 9: 100 %). What is asked for is a band that a single step leaves once in a
# thousand sets, at every step; the share inside the 95 % band is printed.
RARELY = band(6, 20, 0.999)


@pytest.mark.parametrize("kind", ["idpPnt", "ahmPnt", "fhmPnt"])
def test_points_are_consistent_in_the_first_part_of_the_round(kind):
    runs = first_part(kind)
    found = runs.consistency()
    print(kind, found)
    assert runs.map_error.max() < 0.2  # [m]; without updates 2, and consistent as well: with large covariances
    assert ((found.average > RARELY[0]) & (found.average < RARELY[1])).all(), found


def test_what_is_known_to_be_inconsistent_is_found_so():
    """hmgPnt's unobservable direction depends on its estimate (chapter toolbox_tour)."""
    found = first_part("hmgPnt").consistency()
    assert found.average[10:].max() > RARELY[1], found


def test_small_noise_is_consistent_throughout():
    """Where errors are small the filter is linear: NEES inside its band over the whole round."""
    p = preset("points")
    robot = replace(p.rig.robots[0], control_std=tuple(v / 100 for v in p.rig.robots[0].control_std))
    camera = replace(p.rig.sensors[0], std=(0.05,))
    options = replace(p.options, reproject=False, inverse_distance=(0.2, 0.2))
    runs = monte_carlo(replace(p, rig=Rig((robot,), (camera,)), options=options, frames=100), 20)
    found = runs.consistency()
    assert runs.map_error.max() < 0.002  # [m]
    assert ((found.average > RARELY[0]) & (found.average < RARELY[1])).all(), found


def test_a_motion_of_ones_own_may_be_a_value_and_in_a_folder_must_be_known_by_its_name(tmp_path, monkeypatch):
    monkeypatch.setattr(MOTIONS, "_values", dict(MOTIONS))
    own = replace(ODOMETRY, name="own")
    given = replace(SHORT, rig=replace(SHORT.rig, robots=(replace(SHORT.rig.robots[0], motion=own),)))
    assert equal(monte_carlo(given, 2, seed=4), monte_carlo(SHORT, 2, seed=4))
    for wrong in (own, replace(ODOMETRY, angles=())):
        unknown = replace(given, rig=replace(given.rig, robots=(replace(given.rig.robots[0], motion=wrong),)))
        with pytest.raises(SlamlibError, match=f"'{wrong.name}' is another one.*MOTIONS.add"):
            monte_carlo(unknown, 2, folder=tmp_path)
    MOTIONS.add(own)
    assert equal(monte_carlo(given, 2, seed=4, folder=tmp_path), monte_carlo(given, 2, seed=4))
    assert Preset.from_dict(json.loads(json.dumps(given.to_dict()))).slam().robots[0].motion is own
