"""Select: which of the predicted measurements are worth making, as each costs a search and an update."""

from collections import defaultdict
from collections.abc import Callable

import numpy as np

from slamlib.kalman import linalg
from slamlib.manifolds import Array, Indices
from slamlib.slam.data_association.front_end import FrontEnd, FrontEndInput
from slamlib.slam.prediction import Predictions, expected_covariances


def by_information(S: Array, count: int) -> Indices:
    """The `count` rows whose innovation covariance (n, d, d) has the largest determinant, largest first.

    A measurement lowers the entropy of the state by log(det S / det R) / 2: with one R for all, the most uncertain
    prediction is the most informative. Davison (2005); the toolbox leaves R out. Ties: the earlier row.
    """
    return np.argsort(-linalg.log_determinants(S), kind="stable")[:count]


SELECTIONS: dict[str, Callable[[Array, int], Indices]] = {
    "information": by_information,
    "order": lambda S, count: np.arange(len(S))[:count],
}


def select(inputs: FrontEndInput, front_end: FrontEnd, rule: str, count: int) -> Predictions:
    """The `count` most informative of the predictions that can be searched for, by the rule of this name.

    Most informative first; counts the search in each landmark's history.
    """
    sizes: dict[int, Predictions] = defaultdict(list)
    for prediction in front_end.searchable(inputs):
        sizes[prediction.batch.S.shape[-1]].append(prediction)
    # Determinants of different sizes cannot be compared: each size of measurement has the whole budget for itself.
    chosen: Predictions = []
    for group in sizes.values():
        chosen += [group[i] for i in SELECTIONS[rule](expected_covariances(group), count).tolist()]
    for prediction in chosen:
        prediction.chosen = True
        prediction.landmark.searched += 1
    return chosen
