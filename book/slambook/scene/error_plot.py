"""Errors over time as a picture: position, orientation, NEES; with what the filter claims, where it is known."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from slambook.scene.parts import extra
from slamlib.data.files import atomic_write
from slamlib.errors import SlamlibError, entry
from slamlib.evaluation.consistency import band
from slamlib.experiments.runs import Result
from slamlib.manifolds import Array

DOF = 6
ENDINGS = {".svg": None, ".png": None, ".pdf": None}
PANELS = {"position": "position error [m]", "orientation": "orientation error [°]", "nees": "NEES, 6 dof"}
Series = Mapping[str, Mapping[str, Any]]


def check(path: str | os.PathLike[str]) -> None:
    """Raise SlamlibError for a path whose ending is of no format, and without matplotlib."""
    entry("ending of a plot", Path(path).suffix.lower(), ENDINGS)
    extra("matplotlib.figure", "a plot")


def series_of(result: Result) -> Series:
    """By robot the errors of a simulated run, their standard deviations, and NEES."""
    times = result.preset.dt * np.arange(1, len(result.nees) + 1)
    found = {}
    for i, setup in enumerate(result.preset.rig.robots):
        found[setup.name] = {"times": times, "nees": result.nees[:, i]}
        for ending, values in (("", result.errors), ("_sigma", result.sigmas)):
            found[setup.name]["position" + ending] = np.linalg.norm(values[:, i, :3], axis=1)
            found[setup.name]["orientation" + ending] = np.degrees(np.linalg.norm(values[:, i, 3:], axis=1))
    return found


def write(path: str | os.PathLike[str], errors: Series | Result) -> None:
    """Draw errors over time, one panel for each kind that is known, and write them atomically.

    errors: of a simulated run; or for each name, of a path for instance, arrays (n,): times [s], position, and perhaps
    orientation [degrees], position_sigma, orientation_sigma, nees (6 degrees of freedom). Raises SlamlibError.
    """
    check(path)
    series = series_of(errors) if isinstance(errors, Result) else errors
    figure = extra("matplotlib.figure", "a plot")
    style = extra("matplotlib.style", "a plot")
    known = [name for name in PANELS if any(name in each for each in series.values())]
    if not known:
        raise SlamlibError("there are no errors to draw")
    with style.context("slambook.book"):
        fig = figure.Figure(figsize=(8, 1 + 2.2 * len(known)), layout="constrained")
        for ax, name in zip(np.atleast_1d(fig.subplots(len(known), sharex=True)), known, strict=True):
            for number, (label, each) in enumerate(series.items()):
                _draw(ax, name, label if name == known[0] else None, each, is_first=number == 0)
            ax.set_ylabel(PANELS[name])
            if ax.get_legend_handles_labels()[0]:
                ax.legend()
        ax.set_xlabel("time [s]")
    with atomic_write(path) as partial:
        fig.savefig(partial, dpi=150)


def _draw(ax: Any, name: str, label: str | None, each: Mapping[str, Array], is_first: bool) -> None:
    """One kind of error of one robot or path: a line; and what is likely: three deviations, or the NEES's 95 %."""
    if name not in each:
        return
    (line,) = ax.plot(each["times"], each[name], label=label, linewidth=1.2)
    if name == "nees" and is_first:
        ax.axhspan(*band(DOF), color="#898989", alpha=0.25, linewidth=0, label="95 % of a consistent filter")
        ax.set_yscale("log")
    elif f"{name}_sigma" in each:
        said = "3 standard deviations" if is_first else None
        ax.plot(each["times"], 3 * each[f"{name}_sigma"], "--", color=line.get_color(), linewidth=1, label=said)
