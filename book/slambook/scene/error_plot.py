"""Errors over time as a picture: position, orientation, NEES; with what the filter claims, where it is known."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from slambook.scene.parts import extra
from slamlib.errors import SlamlibError
from slamlib.evaluation.consistency import band
from slamlib.manifolds import Array
from slamlib.plain_data.fields import OneOf
from slamlib.plain_data.files import atomic_write

ENDINGS = (".svg", ".png", ".pdf")
PANELS = {"position": "position error [m]", "orientation": "orientation error [°]", "nees": "NEES, {} dof"}
Series = Mapping[str, Mapping[str, Any]]


def check(path: str | Path) -> None:
    """Raise SlamlibError for a path whose ending is of no format, and without matplotlib."""
    OneOf(ENDINGS).check(Path(path).suffix.lower(), "ending of a plot")
    extra("matplotlib.figure", "a plot")


def write(path: str | Path, series: Series) -> None:
    """Draw errors over time, one panel for each kind that is known, and write them atomically.

    series: for each name, a robot's or a path's, arrays (n,): times [s], position, and perhaps orientation [degrees],
    position_sigma, orientation_sigma; nees, and its degrees of freedom, nees_dof. Raises SlamlibError.
    """
    check(path)
    figure, style = (extra(f"matplotlib.{module}", "a plot") for module in ("figure", "style"))
    known = [name for name in PANELS if any(name in each for each in series.values())]
    dofs = sorted({int(dof) for each in series.values() for dof in each.get("nees_dof", ())})
    if not known:
        raise SlamlibError("there are no errors to draw")
    with style.context("slambook.book"):
        fig = figure.Figure(figsize=(8, 1 + 2.2 * len(known)), layout="constrained")
        for ax, name in zip(np.atleast_1d(fig.subplots(len(known), sharex=True)), known, strict=True):
            for number, (label, each) in enumerate(series.items()):
                _draw(ax, name, label if name == known[0] else None, each, is_first=number == 0)
            if name == "nees":
                _likely(ax, dofs)
            ax.set_ylabel(PANELS[name].format(" and ".join(map(str, dofs))))
            if ax.get_legend_handles_labels()[0]:
                ax.legend()
        ax.set_xlabel("time [s]")
    with atomic_write(path) as partial:
        fig.savefig(partial, dpi=150)


def _draw(ax: Any, name: str, label: str | None, each: Mapping[str, Array], is_first: bool) -> None:
    """One kind of error of one robot or path: a line; and three deviations, where they are known."""
    if name not in each:
        return
    (line,) = ax.plot(each["times"], each[name], label=label, linewidth=1.2)
    if f"{name}_sigma" in each:
        said = "3 standard deviations" if is_first else None
        ax.plot(each["times"], 3 * each[f"{name}_sigma"], "--", color=line.get_color(), linewidth=1, label=said)


def _likely(ax: Any, dofs: list[int]) -> None:
    """The NEES's 95 % of each number of degrees of freedom."""
    for dof in dofs:
        of = f", {dof} dof" if len(dofs) > 1 else ""
        ax.axhspan(*band(dof), color="#898989", alpha=0.25, linewidth=0, label=f"95 % of a consistent filter{of}")
    ax.set_yscale("log")
