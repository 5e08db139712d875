"""`import slamlib as sl`: every name is there when it is used, and nothing is loaded before."""

import ast
import inspect
import re
import subprocess
import sys
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

import slamlib as sl
from slamlib.errors import MissingNameError

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


def test_importing_it_loads_numpy_at_most():
    loaded = alone("import sys, slamlib; print(*(m for m in sys.modules if m.startswith('slamlib')))").split()
    assert {*loaded} == {"slamlib", "slamlib.errors"}
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
