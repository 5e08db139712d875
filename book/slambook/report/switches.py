"""The errors of the report, each a value in a table: which equation of the filter it replaces, and by what."""

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slambook.report import angles, motion, observation
from slamlib.errors import UnknownNameError
from slamlib.manifolds import Array

Wrong = Mapping[str, Callable[..., Any]]  # functions by field of Equations


def first(value: Any, *others: Any) -> Any:
    """The first of the available arguments."""
    return value


def second(value: Any, other: Any) -> Any:
    """The second of two available arguments."""
    return other


@dataclass(frozen=True)
class Equations:
    """The filter's equations, one field each; the defaults are the corrected ones."""

    control: Callable[..., Any] = motion.inverse  # section 5.2.2: of PnP's answer
    which_control: Callable[..., Any] = first  # (3.8): of the step's number
    turn: Callable[..., Any] = angles.composed  # (5.6)
    extract: Callable[..., Any] = angles.extracted  # (5.15)-(5.18)
    motion_at: Callable[..., Any] = first  # (3.15): F at the state before the motion; the other is the predicted one
    rows: Callable[..., Any] = motion.exact_by_pose  # (5.20), rows 4-6
    noise_rows: Callable[..., Any] = motion.exact_by_control  # (5.21), rows 4-6
    noise_place: Callable[..., Any] = (
        first  # (5.22): Q as it is, of the pose's rows alone; the other is the state's size
    )
    pose_block: Callable[..., Any] = operator.add  # (5.23): F P F' and Q
    relative: Callable[..., Any] = observation.by_vectors  # (5.25)
    observation_at: Callable[..., Any] = second  # (3.15): H at the predicted state; the other is the one before
    noise: Callable[..., Any] = lambda sigmas: np.diag(sigmas**2)  # (5.26): variances
    variance: Callable[..., Any] = observation.scalar_variance  # (5.27)
    columns: Callable[..., Any] = second  # (5.28), (5.29): those of its landmark; the other is the observation's number
    white: Callable[..., Any] = observation.whitened  # (5.27)
    # (5.31): z - h(x) after the updates so far, which moved the state
    innovation: Callable[..., Any] = lambda difference, h, moved: difference - (h * moved).sum(-1)
    prior: Callable[..., Any] = first  # (5.30), (5.32): P after the updates so far; the other is the predicted one
    new_row: Callable[..., Any] = lambda J, P: J @ P[..., :6, :]  # (5.34): J times the pose's row, for every block
    new_corner: Callable[..., Any] = first  # (5.35): landmarks initialized in one picture share the pose's error
    start: Callable[..., Any] = first  # section 5.1.2: (5.35) for the landmarks of the first picture as well
    memory: Callable[..., Any] = lambda *memory: memory  # section 5.4: nothing is deleted from x, P and numbers
    odometry: Callable[..., Any] = second  # section 5.2.3: matches that the update does not use; the other: its own


@dataclass(frozen=True)
class Switch:
    """One error: the equation's number, what is wrong there in a few words, and the wrong functions by field."""

    equation: str
    slip: str
    wrong: Wrong

    @property
    def right(self) -> dict[str, Callable[..., Any]]:
        """The corrected functions of the same fields."""
        return {name: getattr(Equations(), name) for name in self.wrong}


def _pose_alone(x: Array, P: Array, names: Any = None) -> tuple[Array, Array, list[int]]:
    """Delete the map; with P the pose keeps its covariance, which is right if only two pictures are kept."""
    return x[..., :6].copy(), P[..., :6, :6].copy(), []


_ADDED: Wrong = {
    "turn": angles.added,
    "rows": motion.identity,
    "noise_rows": motion.identity,
}  # sums have these derivatives
_MUTE: Wrong = {
    "new_row": lambda J, P: np.zeros((*J.shape[:-1], P.shape[-1])),
    "new_corner": observation.each_alone,
}
_RESET: Wrong = {"memory": lambda x, P, _: _pose_alone(x, np.zeros_like(P))}
_LITERAL: Wrong = {"innovation": first, "prior": second}

SWITCHES: dict[str, Switch] = {
    "E01": Switch("(3.15)", "H at the old state", {"observation_at": first}),
    "E02": Switch("5.2.4", "F at the new state", {"motion_at": second}),
    "E03": Switch("(3.15)", "the control of the step before", {"which_control": lambda index: max(index - 1, 0)}),
    "E04": Switch("(5.11)-(5.13)", "angles added, and a sum's derivatives", _ADDED),
    "E04 mean": Switch("(5.11)-(5.13)", "angles added in the mean alone", {"turn": angles.added}),
    "E05": Switch("(5.15), (5.18)", "yaw and roll exchanged", {"extract": angles.as_printed}),
    "E06": Switch("(5.15)-(5.18)", "no word on pitch 90 degrees", {"extract": angles.without_branch}),
    "E07": Switch("(5.20)", "identity for the derivative by the angles", {"rows": motion.identity}),
    "E08": Switch("(5.21)", "identity for the derivative by the control's angles", {"noise_rows": motion.identity}),
    "E09": Switch("(5.22)", "Q added to the whole state", {"noise_place": lambda Q, size: np.zeros((size, size)) + Q}),
    "E10": Switch("(5.23)", "Q missing", {"pose_block": first}),
    "E11": Switch("(5.24), (5.25)", "landmark as a 4x4 matrix", {"relative": observation.by_matrices}),
    "E12": Switch("(5.26)", "deviations for variances", {"noise": lambda sigmas: np.diag(sigmas[[0, 1, 1]])}),
    "E13": Switch("(5.27)", "last factor by the landmark", {"variance": observation.last_factor_by_point}),
    "E15": Switch("(5.28)", "blocks drawn on the diagonal", {"columns": first}),
    "E16": Switch("(5.31)", "innovation of the prediction at every step", {"innovation": first}),
    "E16 literal": Switch("(5.31), (5.32)", "everything of the prediction at every step", _LITERAL),
    "E17": Switch("(5.27)", "diagonal of R only", {"white": observation.diagonal_only}),
    "E18": Switch("(5.34)", "product that does not conform", {"new_row": lambda J, P: J @ P[..., 6:9, 9:12]}),
    "E18 dropped": Switch("(5.34)", "nothing between new and old", _MUTE),
    "E19": Switch("5.1.2", "first landmarks with covariance zero", {"start": np.zeros_like}),
    "E20": Switch("5.2.2", "PnP's answer as the control", {"control": first}),
    "E21": Switch("5.2.3", "the same matches for control and correction", {"odometry": first}),
    "E22": Switch("5.4", "everything reset but the pose's mean", _RESET),
    "E22 kept": Switch("5.4", "the map reset, the pose's covariance kept", {"memory": _pose_alone}),
}


def equations(*errors: str) -> Equations:
    """The corrected equations, with these errors turned on; raises UnknownNameError."""
    wrong: Wrong = {}
    for name in errors:
        if name not in SWITCHES:
            raise UnknownNameError.of("error of the report", name, SWITCHES)
        wrong = {**wrong, **SWITCHES[name].wrong}
    return replace(Equations(), **wrong)
