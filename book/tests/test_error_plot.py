"""Errors over time as a picture: the NEES is of as many degrees of freedom as the robot's pose has."""

from dataclasses import replace

import pytest
from slambook.scene import error_plot

from slamlib.evaluation.consistency import band
from slamlib.experiments.presets import preset
from slamlib.experiments.runs import Run
from slamlib.motions import MOTIONS
from slamlib.tests import test_plane_motions

pytest.importorskip("matplotlib")


def series(p):
    return Run(replace(p, frames=5)).finish().series()


@pytest.mark.parametrize(("robots", "dofs"), [(["plane"], [3]), (["space"], [6]), (["space", "plane"], [3, 6])])
def test_the_band_is_that_of_the_robots_degrees_of_freedom(robots, dofs, tmp_path, monkeypatch):
    drawn, presets = [], {"plane": test_plane_motions.preset(MOTIONS["unicycle"]), "space": preset("points")}
    monkeypatch.setattr(error_plot, "band", lambda dof: drawn.append(dof) or band(dof))
    errors = {name: next(iter(series(presets[name]).values())) for name in robots}
    error_plot.write(tmp_path / "errors.svg", errors)
    assert drawn == dofs
    picture = (tmp_path / "errors.svg").read_text()
    assert f"<!-- NEES, {' and '.join(map(str, dofs))} dof -->" in picture
    assert picture.count("<!-- 95 % of a consistent filter") == len(dofs)


def test_without_nees_there_is_no_band(tmp_path, monkeypatch):
    monkeypatch.setattr(error_plot, "band", None)
    (errors,) = series(preset("points")).values()
    known = {name: values for name, values in errors.items() if not name.startswith("nees")}
    error_plot.write(tmp_path / "errors.svg", {"path": known})
    assert "NEES" not in (tmp_path / "errors.svg").read_text()
