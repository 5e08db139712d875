"""From where a landmark's ray, or line, is counted is a convention: how its other numbers follow when that moves.

A point as an anchor and a ray is the same point with the anchor elsewhere and the ray turned after it. No measurement
tells these states apart, and what is gained on an anchor is gained on the robot that stood there: further columns of
N, some for each landmark. Chapter observability, "A symmetry of each landmark's own".
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from slamlib.entities import State
from slamlib.geometry.pose import ORIGIN
from slamlib.kalman.linalg import Following, left_inverse
from slamlib.landmarks.parametrization import LineLandmark, PointLandmark
from slamlib.manifolds import Array, Indices


@dataclass(frozen=True, eq=False)
class AnchoredRows:
    """Landmarks of one kind: rows (k, a) of their anchors, rows (k, b) of all else, and F (k, b, a).

    F: the change of all else by a shift of the anchor [m, and rad of a frame's] that leaves the landmark where it is.
    """

    anchors: Indices
    rest: Indices
    F: Array

    def following(self, before: "AnchoredRows") -> Following:
        """What the rest follows by more than it did: where the errors of the means before are taken to these means."""
        return self.anchors, self.rest, self.F - before.F

    def turned(self, turned: Sequence[Following]) -> "AnchoredRows":
        """The same of errors that each landmark's own I + G has multiplied: (I + G) (I, F) spans what (I, F) did."""
        own = {int(at[0, 0]): G for at, _, G in turned}[int(self.anchors[0, 0])]
        a = self.anchors.shape[1]
        S = np.concatenate([np.broadcast_to(np.eye(a), (len(self.F), a, a)), self.F], axis=1)
        S = S + own @ S
        return AnchoredRows(self.anchors, self.rest, S[:, a:] @ left_inverse(S[:, :a]))


def anchored_rows(state: State) -> list[AnchoredRows]:
    """Of each kind with an anchor; the order is that of the state's kinds, the same as long as no landmark changes."""
    found = []
    for group in state.kinds():
        kind, rows = group.kind, group.rows
        if a := getattr(kind, "anchor", 0):  # another family's landmarks may have no such field
            found.append(AnchoredRows(rows[:, :a], rows[:, a:], follows(kind, group.means())))
    return found


def follows(kind: PointLandmark | LineLandmark, states: Array) -> Array:
    """F (k, b, a) of states (k, size): the derivative by the anchor of the numbers that keep the landmark in its place.

    From J_a + J_b F = 0 along all that is seen. A homogeneous result may also be scaled, where the rest has too few
    numbers to keep it as it is.
    """
    there, J = kind.to_frame.jac(ORIGIN, states)
    size, a, b = there.shape[-1], kind.anchor, kind.manifold.dof - kind.anchor
    seen = np.concatenate([J.landmark[..., a:], there[..., None]], axis=-1)[..., :size]
    return -(left_inverse(seen) @ J.landmark[..., :a])[..., :b, :]
