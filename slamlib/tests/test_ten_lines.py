"""The filter in ten lines: made of robots and sensors, fed with controls and measurements, read by numbers."""

import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import slamlib as sl
from slamlib.errors import ShapeError, SlamlibError, UnknownNameError
from slamlib.records.inputs import Control, Frame

EXAMPLE = Path(sl.__file__).parents[1] / "examples" / "camera.py"


def test_the_example_with_a_camera_ends_as_the_run_does(capsys):
    if not EXAMPLE.is_file():
        pytest.skip("the examples are not beside the package")
    own, run = runpy.run_path(str(EXAMPLE))["slam"], sl.Run(sl.presets.points())
    run.finish()
    P = run.slam.belief.matrix
    assert own.landmarks[0].first_seen == 1
    assert [(lm.id, lm.kind.name) for lm in own.landmarks] == [(lm.id, lm.kind.name) for lm in run.slam.landmarks]
    # the builder's standard deviations go to degrees and back: 1e-16 of each
    assert np.abs(own.robot.mean - run.slam.robot.mean).max() < 1e-9 * own.robot.std.min()
    np.testing.assert_allclose(own.belief.matrix, P, rtol=0, atol=1e-9 * np.abs(P).max())
    said = capsys.readouterr().out
    assert said.startswith("robot: position (")
    assert f"Map of {len(own.landmarks)} landmarks" in said


def tracker():
    return sl.Slam(sl.robot(noise=0.01), sl.relative_position(noise=0.1), options=sl.Options(points="eucPnt"))


SEEN = {7: (2.0, 0.0, 1.0), 3: (4.0, 1.0, 0.0)}


def test_a_step_takes_what_a_frame_holds():
    p = replace(sl.presets.points(), frames=6)
    by_frames, by_numbers = p.slam(), sl.Slam(*p.rig.robots, *p.rig.sensors, options=p.options)
    for frame, _ in p.simulate():
        by_frames.step(frame)
        points = frame.scans[0].points
        seen = dict(zip(points.ids.tolist(), points.values, strict=True))
        by_numbers.step(frame.controls[0], seen, dt=frame.dt)
    assert np.array_equal(by_frames.belief.matrix, by_numbers.belief.matrix)
    assert (by_numbers.number, by_numbers.time) == (6, by_frames.time)
    assert by_numbers.rig == p.rig


def test_a_control_without_its_noise_has_that_of_the_setup():
    u = (0.1, 0, 0, 0, 0, 0.02)
    plain, said = tracker(), tracker()
    plain.step(u, SEEN)
    said.step(Control(np.array(u), 1e-4 * np.eye(6)), SEEN)
    assert np.array_equal(plain.belief.matrix, said.belief.matrix)
    assert plain.robot.covariance[:3, :3] == pytest.approx(1e-4 * np.eye(3))


def test_segments_are_told_from_points_by_their_numbers():
    slam = sl.Slam(sl.robot(), sl.camera([320, 240, 320, 320]), options=sl.Options(lines="idpLin"))
    slam.step(None, {1: (100.0, 200.0), 2: (100.0, 200.0, 300.0, 220.0)})
    assert {lm.id: type(lm.kind).__name__ for lm in slam.landmarks} == {1: "PointLandmark", 2: "LineLandmark"}
    assert slam.map[2].mean.shape == slam.map[2].std.shape == (2, 3)


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        (((0.1, 0), SEEN), ShapeError, r"step: control should have shape \(6,\)"),
        ((None, {7: (1.0, 2.0)}), ShapeError, r"measures 3 numbers \(points\) of a landmark, and of 7 got \(2,\)"),
        ((None, {7: [(1.0, 2.0, 3.0)]}), ShapeError, r"and of 7 got \(1, 3\)"),
        ((None, {7: (1.0, 2.0, np.nan)}), SlamlibError, "nan"),
        ((None, {7.5: (1.0, 2.0, 3.0)}), SlamlibError, "ids are integers or strings, not 7.5"),
    ],
)
def test_what_does_not_fit_changes_nothing(arguments, error, words):
    slam = tracker()
    slam.step(None, SEEN)
    before = slam.belief.snapshot()
    with pytest.raises(error, match=words):
        slam.step(*arguments)
    with pytest.raises(SlamlibError, match="dt is a time above zero"):
        slam.step(None, SEEN, dt=0.0)
    with pytest.raises(SlamlibError, match="holds all that was seen"):
        slam.step(Frame(2, 0.1, (None,), (slam.scans[0],)), SEEN)
    assert slam.number == 1
    assert np.array_equal(slam.belief.matrix, before.covariance)


def test_options_are_given_by_name():
    with pytest.raises(SlamlibError, match=r"made of robots and sensors, not of Options; options are given by name"):
        sl.Slam(sl.robot(), sl.relative_position(noise=0.1), sl.Options())


def test_several_robots_or_sensors_need_frames():
    laser = sl.relative_position(noise=0.1)
    slam = sl.Slam(sl.robot(), laser, replace(laser, name="other"))
    with pytest.raises(SlamlibError, match="one robot with one sensor; give a Frame"):
        slam.step(None, SEEN)


def test_each_sensor_may_have_landmarks_of_its_own_type(tmp_path):
    camera = sl.camera([320, 240, 320, 320], landmark="hmgPnt")
    with pytest.raises(UnknownNameError, match="did you mean 'hmgPnt'"):
        sl.Slam(sl.robot(), replace(camera, landmark="hmgPmt"))
    slam = sl.Slam(sl.robot(), camera)
    slam.step(None, {1: (100.0, 200.0)})
    assert slam.landmarks[0].kind.name == "hmgPnt"
    slam.save(tmp_path / "own.npz")
    again = sl.Slam.load(tmp_path / "own.npz")
    assert again.rig == slam.rig
    assert again.sensors[0].landmark == "hmgPnt"


def test_robot_and_map_are_read_by_numbers():
    slam = tracker()
    slam.step((0.5, 0, 0, 0, 0, np.pi / 2), SEEN)
    shown = slam.snapshot()
    assert list(slam.map) == [lm.id for lm in slam.landmarks] == [3, 7]
    for i, number in enumerate(shown.points.ids.tolist()):
        assert np.array_equal(slam.map[number].mean, shown.points.geometry[i])
        assert slam.map[number].std == pytest.approx(np.sqrt(shown.points.covariance[i].diagonal()))
    assert slam.map[7].mean == pytest.approx([0.5, 2, 1])
    assert repr(slam.map).splitlines()[0] == "Map of 2 landmarks, in metres:"
    assert "  7 eucPnt    0.500   2.000   1.000   std" in repr(slam.map)
    assert slam.map._repr_html_().count("<tr>") == 3
    assert np.array_equal(slam.robot.mean, slam.robots[0].block.mean)
    position, angles = repr(slam.robot).split("; ")
    assert position == "robot: position (0.500, 0.000, 0.000) m, std (0.01, 0.01, 0.01)"
    assert angles == "roll, pitch, yaw (0.0, 0.0, 90.0) deg, std (0.52, 0.52, 0.57)"


def test_a_loaded_filter_knows_what_its_landmarks_were_initialized_by(tmp_path):
    p = replace(sl.presets.points_and_lines(), frames=3)
    slam = p.slam()
    for frame, _ in p.simulate():
        slam.step(frame)
    slam.save(tmp_path / "slam.npz")
    again = sl.Slam.load(tmp_path / "slam.npz")
    assert {len(lm.first_measured) for lm in slam.landmarks} == {2, 4}
    for own, other in zip(slam.landmarks, again.landmarks, strict=True):
        assert np.array_equal(own.first_measured, other.first_measured)
