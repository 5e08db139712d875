"""The toolbox's recorded controls and measurements, fed to our filter: it does the same but for what we corrected.

Each correction is switched off in turn (toolbox_filter.py), until what remains is the rounding of
the record. `pytest -s` prints the table.
"""

from dataclasses import dataclass
from itertools import accumulate

import numpy as np
import pytest

from slamlib.experiments.presets import preset
from slamlib.records.inputs import Control, Features, Frame, Scan
from slamlib.slam import Options
from slamlib.slam.data_association import selection
from slamlib.tests import reference
from slamlib.tests.toolbox_filter import ToolboxFilter, by_determinant

NINE = 1 - np.exp(-9 / 2)  # the probability whose gate for two numbers is the toolbox's 9
RUNS = {
    "pnt_idpPnt_s1": ("points", Options(points="idpPnt", inverse_distance=(0.01, 0.5), gate=NINE)),
    "lin_idpLin_s1": (
        "lines",
        Options(points=None, lines="idpLin", max_new_first=1, inverse_distance=(0.1, 0.5), minimum_length=10.0,
                gate=NINE,
                extend=False),
    ),
}  # fmt: skip
APPLY = {
    "pnt_idpPnt_s1": ("selection", "at once", "index", "seven"),
    "lin_idpLin_s1": ("selection", "reset", "at once", "seven"),
}


@dataclass(frozen=True)
class Difference:
    """Ours beside the recorded one, frame by frame: the pose in its standard deviations and in m or rad, the map, the
    ratio of the standard deviations (less one), and whether landmarks, their types and their counters are the same."""

    sigmas: np.ndarray
    pose: np.ndarray
    map: np.ndarray
    spread: np.ndarray
    same: np.ndarray


def frame_of(recorded, noise):
    raw = recorded["raw"][0]
    features = {
        family: Features(np.atleast_1d(np.ravel(raw[f"{name}_ids"])).astype(int), np.asarray(raw[f"{name}_coord"]).T)
        for family, name in (("points", "pnt"), ("segments", "seg"))
    }
    return Frame(recorded["frame"], 0.1, (Control(np.ravel(recorded["u"]), noise),), (Scan(features),))


def to_tangent(q):
    """The rotation vector by the four numbers of a quaternion (3, 4)."""
    w, x, y, z = q
    return 2 * np.array([[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]])


def compare(slam, recorded):
    """One row of a Difference."""
    x, pose, P = np.ravel(recorded["x_used"]), slam.robots[0].pose, slam.belief.covariance(slam.robots[0].block)
    T = np.zeros((6, 7))
    T[:3, :3], T[3:, 3:] = np.eye(3), to_tangent(pose[3:])
    ours = P if len(P) == 6 else T @ P @ T.T
    sigma = np.sqrt(ours.diagonal())
    error = T @ (x[:7] / np.r_[1, 1, 1, [np.linalg.norm(x[3:7])] * 4] - pose)
    mine, theirs = {lm.id: lm for lm in slam.landmarks}, {lm["id"]: lm for lm in recorded["lmks"]}
    known = [(mine[i], lm) for i, lm in theirs.items() if i in mine]
    counters = all((a.searched, a.matched, a.inliers) == (b["nSearch"], b["nMatch"], b["nInlier"]) for a, b in known)
    alike = [(a, b) for a, b in known if a.block.dof == np.size(b["x"])]
    return (
        np.abs(error / sigma).max(),
        np.abs(error).max(),
        max(np.abs(a.block.mean - np.ravel(b["x"])).max() for a, b in alike),
        max(spread_of(slam, recorded, sigma[:3], alike)),
        set(mine) == set(theirs) and counters and len(alike) == len(known),
    )


def spread_of(slam, recorded, sigma, pairs):
    """How far the ratio of the recorded standard deviations, of position and landmarks, to ours is from one."""
    variances = np.ravel(recorded["P_diag"])
    yield np.abs(np.sqrt(variances[:3]) / sigma - 1).max()
    used = np.unique(np.concatenate([np.arange(1, 8), *(lm["range1"] for lm in recorded["lmks"])]))
    for ours, theirs in pairs:
        at = np.searchsorted(used, np.ravel(theirs["range1"]))
        own = slam.belief.covariance(ours.block).diagonal()
        yield np.abs(np.sqrt(variances[at] / own) - 1).max()


def replay(name, switches, monkeypatch):
    """Ours beside the recorded run, with these corrections switched off."""
    which, options = RUNS[name]
    choose = by_determinant if "selection" in switches else selection.by_information
    monkeypatch.setitem(selection.SELECTIONS, "information", choose)
    rig = preset(which).rig
    slam, rows = ToolboxFilter(rig, options, switches), []
    for recorded in reference.recording(name):
        slam.step(frame_of(recorded, rig.robots[0].noise))
        rows.append(compare(slam, recorded))
    return Difference(*map(np.array, zip(*rows, strict=True)))


def row(label, d):
    """One line of the table."""
    figures = f"{d.sigmas[1:].max():12.1e} {d.pose.max():9.1e} {d.map.max():9.1e} {d.spread.max():10.1e}"
    return f"{label:10} {figures}   {d.same.sum()} of {len(d.same)} frames"


@pytest.mark.parametrize("name", RUNS)
def test_the_recorded_run_is_ours_but_for_named_corrections(name, monkeypatch):
    stages = list(accumulate(([switch] for switch in APPLY[name]), initial=[]))
    found = [replay(name, stage, monkeypatch) for stage in stages]
    print(f"\n{name}: largest differences in 60 frames, our corrections switched off one after another")
    print(f"{'off too':10} {'pose [sigma]':>12} {'[m, rad]':>9} {'map':>9} {'sigmas':>10}   same landmarks, counters")
    for label, d in zip(["nothing", *APPLY[name]], found, strict=True):
        print(row(label, d))
    first, last = found[0], found[-1]
    assert first.pose[0] < 1e-14
    assert first.map[0] < 1e-14
    assert np.median(first.sigmas) < 1
    assert last.same.all()
    assert last.sigmas[1:].max() < 1e-8
    assert last.pose.max() < 1e-10
    assert last.spread.max() < 1e-8
