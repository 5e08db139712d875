"""`import slamlib as sl`: every name is there when it is used, and nothing is loaded before."""

import ast
import doctest
import importlib.util
import inspect
import re
import subprocess
import sys
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

import slamlib as sl
from slamlib.errors import MissingNameError, ShapeError, SlamlibError, UnknownNameError
from slamlib.evaluation.trajectory import Trajectory, write_tum

PACKAGE = Path(sl.__file__).parent


def alone(program: str) -> str:
    """What a Python of its own prints."""
    call = [sys.executable, "-c", program]
    return subprocess.run(call, capture_output=True, text=True, check=True, cwd=PACKAGE.parent).stdout


@pytest.mark.parametrize("name", sl.HOMES)
def test_a_name_is_what_its_module_has_whatever_was_imported_before(name):
    module = import_module(f"slamlib.{sl.HOMES[name]}")
    assert getattr(sl, name) is getattr(module, name, module)
    assert name in vars(sl)  # from its first use on it costs nothing
    assert (inspect.getdoc(getattr(sl, name)) or "").strip()
    # A submodule of this name would take its place as soon as anybody imports it.
    assert not (PACKAGE / f"{name}.py").exists()
    assert not (PACKAGE / name).exists()


@pytest.mark.parametrize("name", sl.HOMES)
def test_a_name_has_an_example_that_runs(name):
    """`help(sl.NAME)` shows one, in the docstring of the name itself or, of a value, of its class."""
    if name == "derive" and importlib.util.find_spec("sympy") is None:
        pytest.skip("derive needs SymPy")
    found = getattr(sl, name)
    example = doctest.DocTestParser().get_doctest(inspect.getdoc(found) or "", {}, f"sl.{name}", None, 0)
    code = "".join(line.source for line in example.examples)
    assert re.search(rf"\bsl\.{name}\b", code), f"the docstring of sl.{name} has no example with it"
    said: list[str] = []
    assert doctest.DocTestRunner(verbose=False).run(example, out=said.append).failed == 0, "".join(said)


def test_importing_it_loads_no_numpy_and_its_names_load_numpy_and_nothing_else():
    loaded = alone("import sys, slamlib; print(*sys.modules)").split()
    assert {m for m in loaded if m.startswith(("slamlib", "numpy"))} == {"slamlib", "slamlib.errors"}
    light = alone(
        "import sys, slamlib as sl\n"
        "for name in sl.HOMES: name == 'derive' or getattr(sl, name)\n"
        "print(*{m.split('.')[0] for m in sys.modules})"
    ).split()
    assert "numpy" in light
    assert not {"sympy", "scipy", "matplotlib", "IPython", "cv2", "skimage", "joblib", "yaml"} & {*light}


def test_completion_and_types_know_the_names_that_a_program_finds():
    assert set(dir(sl)) == {*sl.HOMES, "SlamlibError", "__version__"}
    for statement in ast.parse((PACKAGE / "__init__.py").read_text("utf-8")).body:
        if isinstance(statement, ast.If):
            typed = {a.asname: f"{s.module}" for s in statement.body if isinstance(s, ast.ImportFrom) for a in s.names}
    assert typed.keys() == sl.HOMES.keys()
    for name, module in typed.items():
        home = f"slamlib.{sl.HOMES[name]}"
        assert f"{module}.{name}" in (home, f"{home}.{name}", f"{home}.{name}.{name}")


def test_what_is_not_there_says_what_is_near_and_what_is_missing():
    with pytest.raises(MissingNameError, match="did you mean 'check_jacobian'"):
        _ = sl.check_jacobain
    assert not hasattr(sl, "__wrapped__")
    said = alone(
        "import sys; sys.modules['sympy'] = None\n"
        "import slamlib as sl\n"
        "assert not hasattr(sl, 'derive')\n"
        "try: sl.derive\n"
        "except sl.SlamlibError as error: print(error)"
    )
    assert "slamlib.derive needs sympy: pip install 'slamlib[derive]'" in said


def test_the_first_lines_of_the_package_run():
    result = sl.Run(replace(sl.presets.points(), frames=3)).finish()
    assert len(result.nees) == 3


def test_what_a_cell_shows_is_short_and_says_something():
    """Of plain data the call without its defaults, which makes the same again."""
    run = sl.Run(replace(sl.presets.points(), frames=3))
    camera = "camera (pinHole)"
    assert repr(run.slam) == f"Slam: robot; {camera}; no landmarks yet; 6 degrees of freedom after frame 0"
    result = run.finish()
    landmarks = len(run.slam.landmarks)
    assert repr(run.slam).startswith(f"Slam: robot; {camera}; {landmarks} ahmPnt; {run.slam.belief.size} degrees")
    assert repr(run.slam.belief) == f"Belief: {run.slam.belief.size} degrees of freedom in {landmarks + 1} blocks"
    assert re.fullmatch(
        rf"Result of points: 3 frames, {landmarks} landmarks; robot: at the end [\d.e-]+ m from the truth "
        r"\(sigma [\d.e-]+ m\), mean NEES [\d.]+ of 6",
        repr(result),
    )
    assert repr(run.preset.rig) == f"Rig: robots robot (odometry); sensors {camera}"
    assert repr(run.preset) == (
        "Preset points: 3 frames of 0.1 s in thickCloister; "
        f"Rig: robots robot (odometry); sensors {camera}; Options(points='ahmPnt')"
    )
    for plain in (sl.Options(), sl.Options(points="eucPnt", gate=0.9), run.preset.rig.robots[0], sl.SensorSetup()):
        assert eval(repr(plain), vars(sl) | {name: getattr(sl, name) for name in sl.HOMES}) == plain
    assert repr(sl.Options(gate=0.9)) == "Options(gate=0.9)"


def test_what_a_notebook_shows_as_a_table_has_a_row_for_each_robot_and_sensor_and_no_markup_of_a_name():
    rig = sl.Rig((sl.RobotSetup(name="<b>"),), (sl.SensorSetup(position=(0, 0, 0.6)),))
    shown = rig._repr_html_()
    assert "<b>" not in shown
    assert shown.count("<tr>") == 3
    assert "<tr><th>&lt;b&gt;</th><td>odometry</td><td></td><td>0, 0, 0</td><td>0, 0, 0</td></tr>" in shown
    camera = "<td>pinHole</td><td>&lt;b&gt;</td><td>0, 0, 0.6</td><td>-90, 0, -90</td>"
    assert f"<tr><th>camera</th>{camera}</tr>" in shown
    result = sl.run("two_robots", frames=3)
    rows = re.findall(r"<tr><th>(first|second)</th>((?:<td>[^<]*</td>){7})</tr>", result._repr_html_())
    assert [name for name, _ in rows] == ["first", "second"]
    for i, (_, cells) in enumerate(rows):
        error, sigma, *_, nees, invariant, dof = (float(cell) for cell in re.findall(r"<td>([^<]*)</td>", cells))
        wanted = [np.linalg.norm(each[-1, i, :3]) for each in (result.errors, result.sigmas)]
        means = result.nees[:, i].mean(), result.nees_invariant[:, i].mean()
        assert [error, sigma, nees, invariant, dof] == pytest.approx([*wanted, *means, 6], rel=5e-3)


def test_a_run_is_the_preset_with_the_fields_that_change():
    wanted = sl.Run(replace(sl.presets.points(), frames=3, seed=5)).finish()
    found = sl.run("points", frames=3, seed=5)
    assert np.array_equal(found.errors, wanted.errors)
    assert np.array_equal(sl.run(sl.presets.points(), frames=3, seed=5).errors, wanted.errors)
    options = sl.Options(points="hmgPnt", gate=0.9)
    assert sl.run("points", frames=1, options=options).preset.options == options
    # of a dictionary the other options stay the preset's own, which differ from the defaults
    assert sl.run("lines", frames=1, options={"gate": 0.9}).preset.options == replace(
        sl.presets.lines().options, gate=0.9
    )
    with pytest.raises(UnknownNameError, match="did you mean 'points'"):
        sl.run("pionts")
    with pytest.raises(UnknownNameError, match="field of a preset 'frame'; did you mean 'frames'"):
        sl.run("points", frame=3)
    with pytest.raises(UnknownNameError, match="did you mean 'gate'"):
        sl.run("points", options={"gates": 0.9})
    with pytest.raises(SlamlibError, match="frames should be above 0"):
        sl.run("points", frames=0)


def test_an_evaluation_takes_poses_trajectories_and_files(tmp_path):
    rng, times = np.random.default_rng(3), 0.1 * np.arange(20)
    turned = np.concatenate([np.cos(times), 0 * times, 0 * times, np.sin(times)]).reshape(4, -1).T
    truth = np.concatenate([np.stack([np.cos(3 * times), np.sin(3 * times), times], 1), turned], 1)
    estimate = truth.copy()
    estimate[:, :3] = 2 * (truth[:, :3] + 0.01 * rng.standard_normal((20, 3)))
    paths = Trajectory(times, estimate), Trajectory(times, truth)
    found = sl.evaluate(estimate, truth, times=times, scale=True)
    assert found.summary["scale"] == pytest.approx(0.5, abs=0.02)
    assert 0.005 < found.summary["ate"] < 0.03
    assert sl.evaluate(estimate, truth, times=times).summary["ate"] > 0.3  # the scale is not aligned unless asked for
    assert sl.evaluate(*paths, scale=True).summary == found.summary
    names = [tmp_path / name for name in ("path.txt", "truth.txt")]
    for name, path in zip(names, paths, strict=True):
        write_tum(name, path)
    assert sl.evaluate(*names, scale=True).summary["ate"] == pytest.approx(found.summary["ate"], rel=1e-6)
    assert repr(found).startswith("aligned with reference  20 poses, scale ")
    assert len(found.series["position"]) == 20
    with pytest.raises(ShapeError, match=r"poses should have shape \(n, 7\)"):
        sl.evaluate(estimate[:, :3], truth)
