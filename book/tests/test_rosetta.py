"""The page Rosetta says of every name of the toolbox and the report where it lives; what it says is true."""

import dataclasses
import importlib.util
import inspect
import re
from collections import Counter

import numpy as np
import pytest

from book.tools import layout, rosetta
from slamlib.errors import SlamlibError
from slamlib.kalman.chi_square import chi2_cdf
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import CONSTANT_VELOCITY, ODOMETRY
from slamlib.observation.lines import initialize_line, observe_line
from slamlib.sensors import SENSORS
from slamlib.tests.test_every_type import example

IDENTITY = np.array([0.0, 0, 0, 1, 0, 0, 0])

ROWS = rosetta.rows()
KINDS = {"function", "field", "option", "type", "structure", "section", "idea"}
TYPES = {ODOMETRY.name: ODOMETRY, CONSTANT_VELOCITY.name: CONSTANT_VELOCITY, **SENSORS, **POINTS, **LINES}
OWN = {"stereo", "relativePosition", "rangeBearing", "fisheye", "davison"}  # sensors that the toolbox does not have
OWN |= {"brownConrady", "unified", "extendedUnified", "doubleSphere"}
OWN |= {name for name, kind in {**SENSORS, **POINTS}.items() if kind.plane}  # nor anything of the plane

FRAME = ["x", "t", "q", "R", "Rt", "Pi", "Pc"]
QUICK_START = ["1, download", "2, install", "3, rename", "4, path", "5, run", "6, edit userData", "7, step by step"]
QUICK_START += ["8, help pages", "9, video", "10, guidelines", "11, points", "12, lines", "13, omnidirectional camera"]
QUICK_START += ["14, several sensors", "15, several robots", "quick start of April 2009"]
NAMES = [  # of the seeds, those together that one place of them describes
    ["odometry"],
    ["constVel"],
    ["pinHole"],
    ["omniCam"],
    ["eucPnt"],
    ["hmgPnt"],
    ["ahmPnt"],
    ["idpPnt"],
    ["fhmPnt"],
    ["plkLin"],
    ["aplLin"],
    ["hmgLin"],
    ["ahmLin"],
    ["idpLin"],
    ["which pairs exist"],
    [f"Rob.{f}" for f in ("rob", "id", "name", "type", "sensors", "motion")],
    ["Rob.con.u", "Rob.con.uStd", "Rob.con.U"],
    [f"Rob.frame.{f}" for f in [*FRAME, "P", "r"]],
    ["Rob.vel.x", "Rob.vel.P", "Rob.vel.r"],
    ["Rob.state.x", "Rob.state.P", "Rob.state.size", "Rob.state.r"],
    [*(f"frame.{f}" for f in FRAME), "updateFrame"],
    ["frame.it", "frame.iq"],
    ["splitFrame"],
    [f"Sen.{f}" for f in ("sen", "id", "name", "type", "robot")],
    ["Sen.frameInMap"],
    [f"Sen.frame.{f}" for f in [*FRAME, "P", "r"]],
    [f"Sen.par.{f}" for f in ("k", "d", "c", "imSize", "pixErr", "pixCov")],
    [f"Sen.state.{f}" for f in ("x", "P", "size", "r")],
    [f"Sen.imGrid.{f}" for f in ("imSize", "numCells", "skipOuter", "usedCell", "xticks", "yticks")],
    ["5, fact 4"],
    ["Raw.type"],
    ["Raw.data.points.coord", "Raw.data.points.app"],
    ["Raw.data.segments.coord", "Raw.data.segments.app"],
    ["Raw.data.img"],
    [f"Lmk.{f}" for f in ("lmk", "id", "type", "sig", "used")],
    [f"Lmk.state.{f}" for f in ("r", "x", "P", "size")],
    ["Lmk.par.endp.t", "Lmk.par.endp.e"],
    ["Lmk.nSearch", "Lmk.nMatch", "Lmk.nInlier"],
    ["Lmk.nom.n", "Lmk.nom.N"],
    ["Lmk.sig.patch", "Lmk.sig.pose0"],
    ["Map.used", "Map.x", "Map.P"],
    ["deleteLmk", "reparametrizeLmk"],
    [f"Obs.{f}" for f in ("sen", "lmk", "sid", "lid", "stype", "ltype")],
    ["Obs.meas.y", "Obs.meas.R"],
    ["Obs.nom.n", "Obs.nom.N"],
    ["Obs.exp.e", "Obs.exp.E", "Obs.exp.um"],
    ["Obs.inn.z", "Obs.inn.Z", "Obs.inn.iZ", "Obs.inn.MD2"],
    ["Obs.app.pred", "Obs.app.curr", "Obs.app.sc"],
    ["Obs.par.endp.e", "Obs.par.endp.E"],
    ["Obs.vis", "Obs.measured", "Obs.matched", "Obs.updated"],
    [f"Obs.Jac.{a}_{b}" for a in "EZ" for b in "rsl"],
    ["Tim.dt", "Tim.firstFrame", "Tim.lastFrame"],
    ["Opt.map.numLmks", "Opt.map.lmkSize"],
    ["Opt.correct.reprojectLmks"],
    ["Opt.correct.reparametrize"],
    ["Opt.correct.nUpdates"],
    ["Opt.correct.MD2th"],
    ["Opt.correct.linTestIdp"],
    [f"Opt.correct.lines.{o}" for o in ("innType", "extPolicy", "extSwitch")],
    ["Opt.correct.appScTh"],
    ["Opt.init.nbrInits"],
    ["Opt.init.initType"],
    ["Opt.init.featQualityTh"],
    [f"Opt.init.{t}.nonObs{m}" for t in ("idpPnt", "plkLin", "hmgPnt", "idpLin") for m in ("Mean", "Std")],
    ["Opt.obs.lines.minLength"],
    [f"SimRob.{f}" for f in ("rob", "id", "name", "type", "motion", "sensors")]
    + [f"SimRob.frame.{f}" for f in FRAME]
    + ["SimRob.vel.x", "SimRob.con.u", "SimRob.con.uStd", "SimRob.con.U"],
    [f"SimSen.{f}" for f in ("sen", "id", "name", "type", "robot")]
    + [f"SimSen.frame.{f}" for f in FRAME]
    + [f"SimSen.par.{f}" for f in ("k", "d", "c", "imSize")],
    [f"SimLmk.{a}.{b}" for a in ("points", "segments") for b in ("id", "coord")],
    [f"SimLmk.lims.{a}{b}" for a in "xyz" for b in ("Min", "Max")]
    + [f"SimLmk.dims.{a}" for a in "lwh"]
    + [f"SimLmk.center.{a}Mean" for a in "xyz"],
    [*(f"SimOpt.random.{f}" for f in ("newSeed", "fixedSeed", "seed")), "SimOpt.obs"],
    ["SimObs"],
    [f"MapFig.{f}" for f in ("fig", "axes", "ground", "Rob.patch", "Rob.ellipse", "Sen")]
    + [f"MapFig.Lmk.{f}" for f in ("drawn", "mean", "ellipse", "label")]
    + ["MapFig.simRob", "MapFig.simSen", "MapFig.simLmk"],
    [f"SenFig.{f}" for f in ("fig", "axes", "raw.points", "raw.segments", "drawn", "measure", "mean")]
    + ["SenFig.ellipse", "SenFig.label"],
    ["FigOpt.renderer", "FigOpt.rendPeriod", "FigOpt.createVideo"],
    [f"FigOpt.map.{f}" for f in ("proj", "view", "orbit", "size", "showSimLmk", "showEllip")],
    [f"FigOpt.map.colors.{f}" for f in ("border", "axes", "bckgnd", "simLmk", "simu", "est", "ground", "label")]
    + [f"FigOpt.map.colors.{a}.{b}" for a in ("defPnt", "othPnt", "defLin") for b in ("mean", "ellip")],
    ["FigOpt.sensor.size", "FigOpt.sensor.showEllip"]
    + [f"FigOpt.sensor.colors.{f}" for f in ("border", "axes", "bckgnd", "raw", "label")]
    + [f"FigOpt.sensor.colors.{a}.{b}" for a in ("defPnt", "othPnt") for b in ("updated", "predicted")]
    + [f"FigOpt.sensor.colors.{a}.{b}" for a in ("defLin", "othLin") for b in ("meas", "mean", "ellip")],
    ["FigOpt.map.colors.defPnt.mean", "FigOpt.map.colors.othPnt.mean"],
    ["slamtb", "universalSLAM"],
    ["userData", "userDataPnt", "userDataLin"],
    ["createSlamStructures"],
    ["createSimStructures"],
    ["createGraphicsStructures"],
    ["motion", "correctKnownLmks", "initNewLmk"],
    ["simMotion"],
    ["simObservation", "motion", "correctKnownLmks", "observeKnownLmks", "initNewLmk"],
    ["drawMapFig", "drawSenFig", "createMapFig", "createSenFig"],
    ["reparametrizeLmk", "initLmkParams", "updateLmkParams", "matchFeature"],
    ["correctKnownLmks", "smartDeleteLmk"],
    [
        *("DataManagement", "DetectionMatching", "EKF", "FrameTransforms", "Graphics", "Kinematics", "Lines"),
        *("Math", "Observations", "Points", "Simulation", "Slam", "help DirectoryName"),
    ],
    [
        *("frame", "quaternion", "updateFrame", "splitFrame", "q2R", "q2qc", "q2Pi", "pi2pc"),
        *("toFrame", "fromFrame", "fromFrameIdp"),
    ],
    ["constVel", "odo3"],
    [
        *("project", "distort", "pixellise", "pinHole", "invPinHole", "pinHoleIdp", "invPinHoleIdp"),
        *("projEucPntIntoPinHoleOnRob", "projIdpPntIntoPinHoleOnRob", "retroProjIdpPntFromPinHoleOnRob"),
    ],
    ["idp2euc", "py2vec", "hmg2euc"],
    ["retroProjPlkEndPnts", "updatePlkLinEndPnts", "trimHmgLin", "normvec"],
    [
        *("drawEucPnt", "drawPnt", "drawEllipse", "drawLabel", "drawSeg", "drawObsPnt", "drawObsLin"),
        *("cov2elli", "cov3elli", "drawGauss3dPnt", "drawEuclmk", "drawIdplmk", "drawHmglmk"),
    ],
    ["harris_strongest", "pix2patch", "zncc", "ssd", "census", "imresize2", "patchResize", "imtransform"],
    ["EKF", "predictBlockEkf", "correctBlockEkf", "innovation"],
    *([name] for name in QUICK_START),
    *([f"5, fact {i}"] for i in range(1, 7)),
    ["5.1, lazy procedure", "Opt.init.initType"],
    ["5.2, step 1"],
    ["5.2, step 2"],
    ["5.2, step 3", "simObservation"],
    ["5.2, step 4", "initNewLmk"],
    ["5.2, step 5", "correctKnownLmks"],
    ["5.2, step 6", "createMapFig", "createSenFig"],
    ["5.2, step 7", "drawMapFig", "drawSenFig"],
    ["5.3, direct model", "toFrame", "projectToSensor", "observationModel"],
    ["5.3.1, from scratch", "5.3.2, by adapting", "idp2euc"],
    ["s, non-measurable depth"],
    ["5.4, inverse model", "invObsModel", "retroProjectFromSensor", "fromFrame"]
    + [f"IDP_{x}" for x in ("rf", "sf", "sk", "sc", "u", "n")],
    ["5.5, reparametrization", "hmg2euc", "reparametrizeLmk"],
    ["5.6, outside the map", "initLmkParams", "updateLmkParams"],
    ["5.7.1, handles"],
    ["5.7.2, create and draw"],
    ["6, points and lines"],
]
BOTH = {"constVel", "pinHole", "omniCam"}  # names of a type and of a function: once as each


@pytest.mark.parametrize("names", NAMES, ids=lambda names: names[0])
def test_every_name_of_the_seeds_is_there_once(names):
    count = Counter(r.name for r in ROWS)
    assert {n: count[n] for n in names} == {n: 2 if n in BOTH else 1 for n in names}


def test_nothing_is_listed_twice():
    assert [n for n, k in Counter((r.name, r.kind) for r in ROWS).items() if k > 1] == []
    assert {r.name for r in ROWS if r.name in BOTH and r.kind == "type"} == BOTH
    assert {r.kind for r in ROWS} == KINDS
    groups = [r.group for r in ROWS]
    assert len(set(groups)) == sum(a != b for a, b in zip(groups, ["", *groups], strict=False))


def find(path):
    """What a dotted path names: module, attribute, field of a data class, or argument; raises LookupError."""
    first, *others = path.split(".")
    found = importlib.import_module(first)
    for name in others:
        found = _member(found, name, path)
    return found


def _member(owner, name, path):
    if hasattr(owner, name):
        return getattr(owner, name)
    if hasattr(owner, "__path__") and importlib.util.find_spec(f"{owner.__name__}.{name}"):
        return importlib.import_module(f"{owner.__name__}.{name}")
    if dataclasses.is_dataclass(owner) and name in (fields := {f.name: f for f in dataclasses.fields(owner)}):
        return fields[name]
    arguments = getattr(owner, "parameters", None) or (inspect.signature(owner).parameters if callable(owner) else ())
    if name in arguments:
        return name
    raise LookupError(f"there is no {path}: {owner!r} has no {name!r}")


def exists(place):
    """True if a target, "chapter NAME" or a dotted path, exists."""
    if match := rosetta.CHAPTER.fullmatch(place):
        return (layout.BOOK / "chapters" / f"{match[1]}.ipynb").is_file()
    try:
        find(place)
    except LookupError:
        return False
    return True


@pytest.mark.parametrize(
    "row", [r for r in ROWS if not r.target.startswith("not ")], ids=lambda r: f"{r.kind}-{r.name}"
)
def test_every_place_exists(row):
    assert [p for p in row.places if not exists(p)] == []


def test_what_exists_is_not_called_not_yet(capsys):
    waiting = [r for r in ROWS if r.target.startswith(rosetta.NOT_YET)]
    with capsys.disabled():
        print(f"\nRosetta: {len(waiting)} of {len(ROWS)} names of the toolbox are not yet in slamlib")
        for place, count in Counter(r.target.removeprefix(rosetta.NOT_YET) for r in waiting).items():
            print(f"  {place}: {', '.join(r.name for r in waiting if place in r.places)} ({count})")
    assert {r.name: p for r in waiting for p in r.places if exists(p)} == {}
    assert [r.name for r in waiting if r.kind == "type" and r.name in TYPES] == []


def test_a_type_leads_to_the_value_of_its_name():
    rows = {r.name: r for r in ROWS if r.kind == "type" and r.name != "frame"}
    assert set(TYPES) - OWN <= set(rows)
    for name, row in rows.items():
        if not row.target.startswith(rosetta.NOT_YET):
            assert find(row.target) is TYPES[name]


def test_the_reasons_are_reasons():
    for row in ROWS:
        if row.target.startswith(rosetta.NOT_NEEDED):
            assert len(row.target.removeprefix(rosetta.NOT_NEEDED).split()) > 1
        else:
            assert all(re.fullmatch(r"chapter \w+|(slamlib|slambook)(\.\w+)+", p) for p in row.places), row.target


def test_the_page_follows_from_the_table():
    assert rosetta.PAGE.read_text("utf-8") == rosetta.text(), "run python -m book.tools.rosetta"


@pytest.mark.parametrize(
    "path", ["slamlib.nothing", "slamlib.belief.Belief.nothing", "slamlib.belief.Belief.add.nothing"]
)
def test_what_is_not_there_is_not_found(path):
    assert not exists(path)
    with pytest.raises(LookupError, match=re.escape(path)):
        find(path)


def test_the_shares_that_the_page_gives_for_the_toolbox_gate():
    words, shares = rosetta.PAGE.read_text("utf-8"), [f"{100 * chi2_cdf(9, dof):.1f} %" for dof in (2, 3)]
    assert f"holds {shares[0]} of two-dimensional innovations and {shares[1]} of three-dimensional ones" in words


@pytest.mark.parametrize("name", [name for name, sensor in SENSORS.items() if not sensor.plane])
def test_the_table_of_pairs_is_what_happens(name):
    """A sensor measures lines, or refuses them by name, as the table says. (Points: test_observation.)"""
    table = rosetta.text().split("## Which pairs exist\n")[1].split("\n## ")[0].splitlines()
    head = next(line for line in table if line.startswith("| landmark")).split(" | ")
    column = head.index(f"`{name}`") if f"`{name}`" in head else len(head) - 1
    for kind in LINES.values():
        cell = next(line for line in table if f"`{kind.name}`" in line).rstrip(" |").split(" | ")[column]
        calibration = example(SENSORS[name])
        if cell == "no":
            with pytest.raises(SlamlibError, match=f"{name} .*{kind.name}"):
                observe_line(kind, calibration, IDENTITY, IDENTITY, np.ones(kind.manifold.size))
            with pytest.raises(SlamlibError, match=f"{name} .*{kind.name}"):
                initialize_line(kind, calibration, IDENTITY, IDENTITY, np.ones(4), np.ones(2))
            continue
        rays = np.array([0.3, 0.0, 0.9, 0.0, 0.3, 0.9]) / np.sqrt(0.9)
        landmark = kind.from_frame(IDENTITY, rays, np.array([0.2, 0.3]))
        assert observe_line(kind, calibration, IDENTITY, IDENTITY, landmark).value.shape == (3,)
