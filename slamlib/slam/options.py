"""The filter's options: plain data, checked when it is made, written to and read from JSON."""

from dataclasses import dataclass
from typing import Annotated

from slamlib.observation import FAMILIES
from slamlib.observation.points import PointOptions
from slamlib.observation.segments import LineOptions
from slamlib.plain_data.fields import Count, OneOf, check
from slamlib.slam.data_association.consensus import OUTLIER_REJECTIONS
from slamlib.slam.data_association.selection import SELECTIONS
from slamlib.slam.map_management import UpkeepOptions
from slamlib.slam.measurement_update import UpdateOptions
from slamlib.slam.transport import TRANSPORTS


@dataclass(frozen=True, repr=False)
class Options(UpkeepOptions, UpdateOptions, LineOptions, PointOptions):
    """All options of the filter. The names in parentheses are those of the toolbox.

    Each is declared beside what it rules: in slam/map_management.py, slam/measurement_update.py, and of the families in
    observation/; those of `Slam` itself are here.

    points, lines: parametrization of new landmarks, or None for none of them (init.initType). Of points in space a
        sensor in the plane makes planePnt, or planeIdpPnt if it measures bearings alone. others: the same for other
        families of landmarks, by the family's name (slamlib.observation.FAMILIES).
    capacity: largest number of landmarks, or None for no limit (map.numLmks).
    pruning: how the map stays within the capacity: None refuses new landmarks; "least-recently-seen" prunes the one
        not seen for longest; "least-reliable" the one with the smallest share of searches that gave an inlier.
    error: whose covariance the filter keeps: "local", the error of each block by itself, as in every EKF; "world", the
        right-invariant error; "anchors", as "world", with the anchors of landmarks, which stand by convention; or
        "first-estimates", as "local", with all Jacobians of a block at one point. But for "local" they gain no
        information on the motion of the world, which no measurement has.
    window: a landmark that was not seen for more frames than this is deleted; None: no such limit.
    updates: most landmarks by which one sensor updates the map in one frame (correct.nUpdates).
    selection: "information": those whose innovation covariance has the largest determinant; "order": the oldest.
    reproject: one landmark after another, each predicted anew at the current mean; False: all in one batch, with
        Jacobians at the predicted mean (correct.reprojectLmks).
    second_order: "variance" adds to the noise of each measurement the variance of what its linearization leaves out,
        such as products of the errors of a landmark and of extrinsics that are estimated; None: nothing is added.
    gate: probability with which a true measurement passes, for the innovation's own degrees of freedom (MD2th); 1: all.
    outlier_rejection: which matches of a frame are accepted: "individual": each that passes its own gate; "joint": the
        largest jointly compatible set; "one-point-ransac": those consistent with the update by one of them.
    convert, convert_below: whether, and below which linearity index, points become Euclidean ones (reparametrize,
        linTestIdp).
    max_new_first, max_new: new landmarks of one sensor in its first frame, and in every other (init.nbrInits).
    inverse_distance: mean and standard deviation [1/m] of the prior for what a bearing does not measure
        (init.idpPnt.nonObs*). With the toolbox's (0.01, 0.5), near infinity, the filter is overconfident at first.
    line_priors: by the name of a parametrization, prior means and standard deviations of the two numbers that a segment
        does not measure (init.plkLin.nonObs*); lines not listed take inverse_distance for both endpoints.
    innovation: of lines, which pin-hole cameras alone observe: "ortDst" distances of the measured endpoints, "rhoThe"
        distance and angle, "angles" of their rays with the plane of the line (correct.lines.innType).
    extend, extend_switch: how the endpoints of lines follow the measured ones (correct.lines.extPolicy, extSwitch).
    minimum_length: [px] of a segment (obs.lines.minLength). margin: share of the image's width in which no point is
        initialized, at every border.
    min_searches, min_matched_ratio, min_inlier_ratio: a landmark that was searched for at least `min_searches` times is
        deleted if less than `min_matched_ratio` of the searches found it, or if less than `min_inlier_ratio` of the
        matches passed the gate.

    >>> import slamlib as sl
    >>> options = sl.Options(points="ahmPnt", gate=0.95)
    >>> options, options.updates
    (Options(points='ahmPnt', gate=0.95), 10)
    """

    error: Annotated[str, OneOf(TRANSPORTS)] = "local"
    updates: Count = 10
    selection: Annotated[str, OneOf(SELECTIONS)] = "information"
    reproject: bool = True
    outlier_rejection: Annotated[str, OneOf(OUTLIER_REJECTIONS)] = "individual"
    max_new_first: Count = 10
    max_new: Count = 1
    others: dict[Annotated[str, OneOf(FAMILIES)], str] | None = None

    @property
    def carried(self) -> bool:
        """Whether the covariance is kept of errors that move with the world."""
        return TRANSPORTS[self.error].carries

    def __post_init__(self) -> None:
        check(self)
        for family, kind in (self.others or {}).items():
            OneOf(FAMILIES[family].parametrizations).check(kind, f"parametrization of {family}")
