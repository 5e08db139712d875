"""Outlier rejection: which of a frame's matches are accepted, before each is gated by itself. Chapter data_association.

A method yields groups of predictions, one after another: the filter updates by a group before it asks for the next,
so that a later group is chosen after the earlier update. A match that is not yielded is an outlier, as if the gate
had rejected it, with the nis for which it was rejected.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from slamlib.belief import Belief
from slamlib.entities import RigSensor
from slamlib.entities.landmark import group_by_kind
from slamlib.entities.state import KindRows
from slamlib.manifolds import Array, Mask
from slamlib.observation.family import viewpoint
from slamlib.slam.data_association.gates import gate, innovation_squares, mahalanobis_squared
from slamlib.slam.data_association.jcbb import jcbb
from slamlib.slam.data_association.joint_innovation import JointInnovation, hypothesis_innovations, joint_innovation
from slamlib.slam.measurement_update import UpdateOptions
from slamlib.slam.prediction import LANDMARK_KIND, Predictions, innovations

Groups = Iterator[Predictions]
OutlierRejection = Callable[[Belief, RigSensor, Predictions, UpdateOptions], Groups]

# Standard deviations of the measurement noise: a match within this of a hypothesis's prediction supports it. Low on
# purpose (Civera et al. 2010): 86 % of the true matches of two numbers without other errors, and few wrong ones.
LOW_INNOVATION = 2.0
# Matches that must agree, the one of the hypothesis among them: two wrong ones agree by chance now and then.
MIN_SUPPORT = 3


def individual(belief: Belief, sensor: RigSensor, predictions: Predictions, options: UpdateOptions) -> Groups:
    """All of them, in one group: the gate judges each alone."""
    yield predictions


def joint_compatibility(belief: Belief, sensor: RigSensor, predictions: Predictions, options: UpdateOptions) -> Groups:
    """The largest jointly compatible set: z' S^-1 z of the whole set passes the gate for all its degrees of freedom.

    Neira and Tardos (2001). What fails its own gate is rejected before. The nis of a rejected match is what it would
    add to the square of those accepted.
    """
    if len(predictions) < 2 or _fit_the_noise(sensor, predictions, options):
        yield predictions
        return
    found = joint_innovation(belief, sensor, predictions)
    keep = _jointly_compatible(found, _individual_squares(found, options)[1], options)
    refused = _selected(predictions, ~keep)
    for prediction, nis in zip(refused, _added_squares(found, keep).tolist() if refused else (), strict=True):
        prediction.nis = nis
    yield _selected(predictions, keep)


def _fit_the_noise(sensor: RigSensor, predictions: Predictions, options: UpdateOptions) -> bool:
    """Whether each and all pass by the noise alone: z' S^-1 z <= z' R^-1 z, as S is R and more. Eq. (da-noise).

    Then, as in most frames, no joint covariance is needed.
    """
    total, dof = 0.0, 0
    for group in group_by_kind(predictions, LANDMARK_KIND):
        z, _, R = innovations(sensor, group)[1]
        try:
            with np.errstate(divide="ignore", invalid="ignore"):
                squares = mahalanobis_squared(z, R).tolist()
        except np.linalg.LinAlgError:
            return False  # what is measured without noise fits none
        limit = gate(options.gate, z.shape[1])
        if not all(0 <= square < limit for square in squares):
            return False
        total, dof = total + sum(squares), dof + z.size
    return total < gate(options.gate, dof)


def _jointly_compatible(found: JointInnovation, candidates: Mask, options: UpdateOptions) -> Mask:
    """Mask of the largest jointly compatible set among the candidates."""
    rows, keep = np.flatnonzero(candidates), np.zeros(len(candidates), dtype=bool)
    if len(rows):
        S = found.S[rows][:, :, rows]
        keep[rows] = jcbb(found.z[rows], S, found.dof[rows], partial(gate, options.gate))
    return keep


def one_point_ransac(belief: Belief, sensor: RigSensor, predictions: Predictions, options: UpdateOptions) -> Groups:
    """First those that agree with the update by one of them; then, of the others, those that pass the gate.

    Civera, Grasa, Davison and Montiel (2010): a filter has a prior, so that a single match makes a hypothesis. Each of
    the few that pass the gate is tried (they draw at random, to try fewer). The hypothesis with the largest support
    wins, and among equals the one that its supporters fit best. Where fewer than MIN_SUPPORT agree, one point
    constrains the motion too little, and the map is updated by the largest jointly compatible set first.
    """
    if len(predictions) < 2:
        yield predictions
        return
    found = joint_innovation(belief, sensor, predictions)
    squares, candidates = _individual_squares(found, options)
    support = _largest_support(sensor, predictions, found, candidates)
    if support.sum() < min(MIN_SUPPORT, candidates.sum()):
        support = _jointly_compatible(found, candidates, options)
    for prediction, nis in zip(predictions, squares.tolist(), strict=True):
        prediction.nis = nis  # kept by those that go out of view
    yield _selected(predictions, support)
    yield from _rescue_high_innovation(belief, sensor, _selected(predictions, ~support), options)


def _largest_support(sensor: RigSensor, predictions: Predictions, found: JointInnovation, candidates: Mask) -> Mask:
    """Mask of the candidates that agree with the best hypothesis."""
    hypothetical = hypothesis_innovations(sensor, predictions, found)
    squares = mahalanobis_squared(hypothetical, np.broadcast_to(found.R, (len(predictions), *found.R.shape)))
    agree = squares < LOW_INNOVATION**2  # out of view is nan, and does not agree
    agree |= np.eye(len(predictions), dtype=bool)
    agree &= candidates & candidates[:, None]
    misfit = np.where(agree, squares, 0).sum(1)
    return agree[np.lexsort((misfit, -agree.sum(1)))[0]]


def _rescue_high_innovation(
    belief: Belief, sensor: RigSensor, predictions: Predictions, options: UpdateOptions
) -> Groups:
    """Those that pass the gate at the belief's present means, with the predictions made there."""
    inside: Predictions = []
    shown = {prediction.landmark: prediction for prediction in predictions}
    for group in group_by_kind(predictions, LANDMARK_KIND):
        there = KindRows.of([prediction.landmark for prediction in group])
        expected = group[0].family.predict_batch(viewpoint(sensor), there, options)
        if not expected.landmarks:
            continue
        anew = [replace(shown[landmark], batch=expected, row=i) for i, landmark in enumerate(expected.landmarks)]
        found = innovations(sensor, anew)[1]
        for prediction, nis in zip(anew, innovation_squares(belief, expected, found), strict=True):
            shown[prediction.landmark].nis = nis
            if nis < gate(options.gate, found.z.shape[1]):
                inside.append(prediction)
    if inside:
        yield inside
    for prediction in inside:  # a prediction keeps showing what was predicted before any update
        before = shown[prediction.landmark]
        before.nis, before.inlier = prediction.nis, prediction.inlier


def _individual_squares(found: JointInnovation, options: UpdateOptions) -> tuple[Array, Mask]:
    """Square (n,) of each single innovation, and the mask (n,) of those that pass the gate."""
    rows = np.arange(len(found.z))
    squares = mahalanobis_squared(found.z, found.S[rows, :, rows])
    limits = {size: gate(options.gate, size) for size in set(found.dof.tolist())}
    return squares, squares < np.array([limits[size] for size in found.dof.tolist()])


def _added_squares(found: JointInnovation, keep: Mask) -> Array:
    """What each innovation outside `keep` would add to the joint square of those in it."""
    n, d = found.z.shape
    count, kept = int((~keep).sum()), np.repeat(keep, d)
    S, z = found.S.reshape(n * d, n * d), found.z.ravel()
    across = S[kept][:, ~kept]
    gain = np.linalg.solve(S[kept][:, kept], across).T
    left = (S[~kept][:, ~kept] - gain @ across).reshape(count, d, count, d)
    rows = np.arange(count)
    return mahalanobis_squared((z[~kept] - gain @ z[kept]).reshape(count, d), left[rows, :, rows])


def _selected(predictions: Predictions, mask: Mask) -> Predictions:
    return [prediction for prediction, is_one in zip(predictions, mask.tolist(), strict=True) if is_one]


OUTLIER_REJECTIONS: dict[str, OutlierRejection] = {
    "individual": individual,
    "joint": joint_compatibility,
    "one-point-ransac": one_point_ransac,
}
