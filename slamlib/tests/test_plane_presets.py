"""The presets in the plane: consistent in three degrees of freedom, drawn from above, saved, compared.

`five_minutes` is the world of chapter slam_in_five_minutes, whose filter in plain NumPy is laid beside the package's.
"""

import json
from dataclasses import replace

import numpy as np
import pytest

from slamlib.cli import main
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.evaluation.consistency import band, nees_in_range
from slamlib.experiments.monte_carlo import monte_carlo
from slamlib.experiments.presets import PRESETS, Preset, preset
from slamlib.experiments.runs import Run
from slamlib.geometry.pose2 import Pose2
from slamlib.simulation import world

IN_THE_PLANE = [name for name in PRESETS if preset(name).rig.dof == (3,)]
RUNS = 25
# Of a set of runs a single step leaves this band once in a thousand sets; neighbouring steps are correlated.
RARELY = band(3, RUNS, 0.999)
FRAMES = {"plane": 120, "five_minutes": 80}  # a lap of each, with its loop closed


def test_there_are_two():
    assert IN_THE_PLANE == ["plane", "five_minutes"]


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("name", IN_THE_PLANE)
def test_nees_of_three_degrees_of_freedom_stays_in_its_band(name, seed):
    """25 runs, in two sets of seeds; the share of the frames inside the band of 95 % is printed, and asserted."""
    runs = monte_carlo(replace(preset(name), frames=FRAMES[name]), RUNS, seed=seed)
    found = runs.consistency()
    print(name, seed, found)
    assert found.dof == 3
    assert FRAMES[name] - 3 <= found.average.size < FRAMES[name]  # at first part of the pose is known exactly
    assert ((found.average > RARELY[0]) & (found.average < RARELY[1])).all(), found
    assert found.inside > 0.7
    assert 2.5 < found.average.mean() < 3.5
    assert np.median(runs.map_error) < 0.5  # [m]


def test_noise_that_the_filter_does_not_know_of_is_found():
    """The same runs, given to a filter that takes the turns for half as noisy."""
    p = replace(preset("five_minutes"), frames=80)
    (robot,) = p.rig.robots
    sure = replace(p, rig=replace(p.rig, robots=(replace(robot, control_std=(0.03, 0.0, 0.25)),)))
    nees = []
    for seed in range(RUNS):
        slam = sure.slam()
        for frame, truth in p.simulate(np.random.default_rng(seed)):
            control = replace(frame.controls[0], covariance=sure.rig.robots[0].noise)
            slam.step(replace(frame, controls=(control,)))
            error = Pose2.minus(truth.robots[0], slam.robot.mean)
        nees.append(nees_in_range(error, slam.robot.covariance, (2, 1))[0])
    assert np.mean(nees) > RARELY[1]


@pytest.mark.parametrize("name", IN_THE_PLANE)
def test_a_run_is_saved_and_goes_on_bit_for_bit(name, tmp_path):
    p = replace(preset(name), frames=30)
    whole, part = Run(p), Run(p)
    whole.finish()
    for step in part:
        if step.frame.number == 12:
            break
    part.save(tmp_path / "run.npz")
    part = Run.load(tmp_path / "run.npz")
    assert part.done == 12
    a, b = whole.result(), part.finish()
    assert np.array_equal(a.errors, b.errors)
    assert np.array_equal(whole.slam.belief.matrix, part.slam.belief.matrix)
    assert a.dof == (3,)
    assert np.isfinite(a.mean_nees[0])
    assert "of 3" in repr(a)


@pytest.mark.parametrize("name", ["plane", "five-minutes"])
def test_the_command_runs_it(name, capsys, tmp_path):
    assert main(["run", name, "--frames", "20", "--save", str(tmp_path / "run.npz")]) == 0
    assert "robot: NEES, 3 dof" in capsys.readouterr().out
    assert main(["run", "--resume", str(tmp_path / "run.npz"), "--frames", "25", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    (robot,) = found["robots"]
    assert (found["frames"], robot["nees_dof"]) == (25, 3)
    assert found["point_error_median"] < 0.3


def test_parametrizations_of_the_plane_are_compared_in_it(capsys):
    assert main(["compare", "planePnt", "planeIdpPnt", "--runs", "2", "--frames", "12"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("Preset plane: 2 runs of 12 frames.")
    assert "NEES of the pose: 3 degrees of freedom" in text
    assert [line.split()[0] for line in text.splitlines()[-2:]] == ["planePnt", "planeIdpPnt"]
    assert main(["compare", "planePnt", "--preset", "five_minutes", "--runs", "1", "--frames", "12", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)[0]["nees_dof"] == 3


@pytest.mark.parametrize("name", IN_THE_PLANE)
def test_its_map_is_seen_from_above(name):
    assert preset(name).slam().snapshot().plane
    assert not preset("points").slam().snapshot().plane


def test_the_lap_of_five_minutes_ends_where_it_began():
    p = preset("five_minutes")
    (robot,) = p.rig.robots
    still = replace(p, frames=80, rig=replace(p.rig, robots=(replace(robot, control_std=(0.0,) * 3),)))
    states = [truth.robots[0] for _, truth in still.simulate()]
    assert np.abs(Pose2.minus(states[-1], np.zeros(3))).max() < 1e-12
    assert np.ptp(states, axis=0)[:2] == pytest.approx(np.array([8.5, 8.5]), abs=0.5)


def test_legs_are_driven_in_turn_and_over_and_over():
    p = replace(preset("five_minutes"), legs={"robot": ((2, (1, 0, 0)), (1, (0, 0, 90)))})
    controls = [frame.controls[0].value for frame, _ in replace(p, frames=7).simulate()]
    turn = [0, 0, np.pi / 2]
    assert np.allclose(controls, [[1, 0, 0], [1, 0, 0], turn, [1, 0, 0], [1, 0, 0], turn, [1, 0, 0]])
    none = replace(p, legs=None, frames=2)
    assert not np.any([frame.controls[0].value for frame, _ in none.simulate()])
    assert Preset.from_dict(json.loads(json.dumps(p.to_dict()))) == p


def test_legs_of_any_name_come_back_from_a_starting_file(tmp_path, capsys):
    p = preset("five_minutes")
    named = replace(p, rig=replace(p.rig, robots=(replace(p.rig.robots[0], name="my rover"),)), legs=None)
    own = replace(named, legs={"my rover": p.legs["robot"]})
    own.save(tmp_path / "own.json")
    assert main(["preset", str(tmp_path / "own.json")]) == 0
    (tmp_path / "own.toml").write_text(capsys.readouterr().out)
    assert Preset.load(tmp_path / "own.toml") == own


def test_wrong_legs_are_named():
    p = preset("five_minutes")
    with pytest.raises(UnknownNameError, match="robot of the legs 'robt'; did you mean 'robot'"):
        replace(p, legs={"robt": ((1, (0, 0, 0)),)})
    with pytest.raises(SlamlibError, match="control"):
        replace(p, legs={"robot": ((1, (0, 0)),)})
    with pytest.raises(SlamlibError, match=r"legs\.robot\[0\]\[0\] should be above 0"):
        replace(p, legs={"robot": ((0, (0, 0, 0)),)})


def test_listed_points_lie_on_the_floor_unless_they_say_a_height():
    found = world("listed", points=[[1, 2], [3, 4, 5]]).points
    assert found.values.tolist() == [[1, 2, 0], [3, 4, 5]]
    assert found.ids.tolist() == [1, 2]
    assert len(world("listed").points) == 0
    with pytest.raises(SlamlibError, match=r"world listed\.points\[0\] should be a list of 2 or 3"):
        world("listed", points=[[1]])
