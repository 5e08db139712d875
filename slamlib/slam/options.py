"""What a reader may choose about the filter: plain data, checked when it is made, written to and read from JSON."""

import math
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from slamlib.data.setup import tuples
from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.landmarks import LINES, POINTS
from slamlib.landmarks.linearity import THRESHOLD
from slamlib.observation import FAMILIES
from slamlib.observation.lines import READINGS
from slamlib.slam.data_association.consensus import CONSENSUS
from slamlib.slam.data_association.gates import CHOICES
from slamlib.slam.map_management import FULL

Prior = tuple[tuple[float, float], tuple[float, float]]
PLUCKER: Prior = ((0.1, 0.0), (0.25, 1.0))


@dataclass(frozen=True)
class Options:
    """All options of the filter. The names in parentheses are those of the toolbox.

    points, lines: parametrization of new landmarks, or None for none of them (init.initType). others: the same for
        other families of landmarks, by the family's name (slamlib.observation.FAMILIES).
    capacity: largest number of landmarks, or None for no limit (map.numLmks).
    full: what happens to new landmarks at the capacity: None refuses them; "unseen": the landmark that was not seen for
        longest makes room; "useless": the one that was looked for in vain the largest share of times does.
    window: a landmark that was not seen in more frames than this is forgotten; None: it is remembered for ever.
    updates: most landmarks that one sensor corrects in one frame (correct.nUpdates).
    choose: "information": those whose innovation covariance has the largest determinant; "order": the oldest.
    reproject: one landmark after another, each expected anew at the mean of that moment; False: all in one batch, with
        Jacobians at the predicted mean (correct.reprojectLmks).
    gate: probability with which a true measurement passes, for the innovation's own degrees of freedom (MD2th); 1: all.
    consensus: which matches of a frame are believed together: "each" is judged by the gate alone; "joint": the largest
        jointly compatible set; "one-point": those that agree with what one of them says of the camera.
    convert, convert_below: whether, and below which linearity index, points become Euclidean ones (reparametrize,
        linTestIdp).
    first, later: new landmarks of one sensor in its first frame, and in every other (init.nbrInits).
    inverse_distance: mean and standard deviation [1/m] of what a bearing does not tell (init.idpPnt.nonObs*).
    line_priors: by the name of a parametrization, means and standard deviations of the two numbers that a segment does
        not tell (init.plkLin.nonObs*); lines that are not named take inverse_distance for both ends.
    innovation: of lines: "ortDst" distances of the measured ends, "rhoThe" distance and angle, "angles" of their rays
        with the plane of the line, for any camera (correct.lines.innType).
    extend, extend_switch: how the ends of lines follow what is seen (correct.lines.extPolicy, extSwitch).
    minimum_length: [px] of a segment (obs.lines.minLength). margin: share of the image's width in which no point is
        initialized, at every border.
    search_first, keep_matched, keep_inliers: a landmark that was looked for at least `search_first` times goes if it
        was found in less than `keep_matched` of them, or if fewer than `keep_inliers` of those passed the gate.
    """

    points: str | None = "idpPnt"
    lines: str | None = None
    capacity: int | None = None
    full: str | None = None
    window: int | None = None
    updates: int = 10
    choose: str = "information"
    reproject: bool = True
    gate: float = 0.99
    consensus: str = "each"
    convert: bool = True
    convert_below: float = THRESHOLD
    first: int = 10
    later: int = 1
    inverse_distance: tuple[float, float] = (0.01, 0.5)
    line_priors: dict[str, Prior] = field(default_factory=lambda: {"plkLin": PLUCKER, "aplLin": PLUCKER})
    innovation: str = "ortDst"
    extend: bool = True
    extend_switch: float = 10.0
    minimum_length: float = 20.0
    margin: float = 0.04
    search_first: int = 10
    keep_matched: float = 0.1
    keep_inliers: float = 0.5
    others: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        _known("point landmark", self.points, POINTS, none=True)
        _known("line landmark", self.lines, LINES, none=True)
        _known("innovation", self.innovation, READINGS)
        _known("choose", self.choose, CHOICES)
        _known("consensus", self.consensus, CONSENSUS)
        _known("rule for a full map", self.full, FULL, none=True)
        for name in ("updates", "first", "later", "search_first"):
            self._ask(name, "a whole number, 0 or more", lambda v: isinstance(v, int) and v >= 0)
        for name in ("reproject", "convert", "extend"):
            self._ask(name, "True or False", lambda v: isinstance(v, bool))
        for name in ("capacity", "window"):
            self._ask(name, "a whole number above 0, or None", lambda v: v is None or (isinstance(v, int) and v > 0))
        self._ask("gate", "a probability above 0, up to 1", lambda v: 0 < v <= 1)
        for name in ("keep_matched", "keep_inliers"):
            self._ask(name, "a share between 0 and 1", lambda v: 0 <= v <= 1)
        self._ask("margin", "a share below a half", lambda v: 0 <= v < 0.5)
        for name in ("convert_below", "extend_switch", "minimum_length"):
            self._ask(name, "a number, 0 or more", lambda v: v >= 0)
        self._ask("inverse_distance", "(mean, std) with std > 0", lambda v: _numbers(v, 2) and v[1] > 0)
        for name in self.line_priors:
            _known("line landmark", name, LINES)
        for name, kind in self.others.items():
            _known("family of landmarks", name, FAMILIES)
            _known(f"parametrization of {name}", kind, FAMILIES[name].parametrizations)
        self._ask("line_priors", "((mean, mean), (std, std)) by name, std > 0", _are_priors)

    def parametrization_of(self, family: str) -> str | None:
        """The parametrization of new landmarks of a family, or None for none."""
        return {"points": self.points, "segments": self.lines, **self.others}.get(family)

    def line_prior(self, name: str) -> Prior:
        """Means and standard deviations of what a segment does not tell about a line of this parametrization."""
        mean, std = self.inverse_distance
        return self.line_priors.get(name, ((mean, mean), (std, std)))

    def _ask(self, name: str, wanted: str, holds: Any) -> None:
        value = getattr(self, name)
        try:
            fine = bool(holds(value))
        except (TypeError, ValueError):
            fine = False
        if not fine:
            raise SlamlibError(f"Options: {name} should be {wanted}, got {value!r}")

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON or TOML; what is None is left out."""
        plain = {name: value for name, value in asdict(self).items() if value is not None}
        return plain if self.others else {name: value for name, value in plain.items() if name != "others"}

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "Options":
        """The options of plain data; lists become tuples, and what is missing is None or its default."""
        names = [f.name for f in fields(cls)]
        for name in data:
            if name not in names:
                raise UnknownNameError.of("option", name, names)
        absent: dict[str, Any] = {n: None for n in ("points", "lines", "capacity") if n not in data}
        return cls(**tuples(data), **absent)


def _known(what: str, name: str | None, known: Any, none: bool = False) -> None:
    if not (none and name is None) and name not in known:
        raise UnknownNameError.of(what, name, known)


def _numbers(value: Any, count: int) -> bool:
    return len(value) == count and all(math.isfinite(v) for v in value)


def _are_priors(priors: dict[str, Any]) -> bool:
    return all(_numbers(means, 2) and _numbers(stds, 2) and min(stds) > 0 for means, stds in priors.values())
