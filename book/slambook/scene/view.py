"""The virtual camera that looks at the map: from points, lines and ellipsoids in space to the sheet.

On the sheet x points to the right, y up, and the height of the picture is 2.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from slambook.scene.layers import Flat, Layer, strung
from slamlib.manifolds import Array, Mask

FIELD = 40.0  # degrees: field of view of the named views, from top to bottom
NEAR = 0.05  # of the distance: what is nearer to the viewer is not drawn
TURN = np.linspace(0, 2 * np.pi, 37)
CIRCLE = np.stack([np.cos(TURN), np.sin(TURN)])
CENTRINGS = 4  # steps in which the middle of a perspective picture is found
BEHIND = 180.0
# Azimuth and elevation [deg] of the viewer, and whether they are counted from a robot that is followed.
NAMED = {
    "top": (-90.0, 90.0, False),
    "side": (-90.0, 0.0, False),
    "front": (0.0, 0.0, False),
    "view": (-60.0, 35.0, False),
    "normal": (BEHIND, 30.0, True),
}


@dataclass(frozen=True)
class OrbitView:
    """Where the viewer is: azimuth from the x axis and elevation above the ground [deg], at a distance [m] of target.

    field [deg]: from the bottom to the top of the picture. perspective: False for parallel rays, at the same scale
    for what is as far away as the target.
    """

    azimuth: float = -60.0
    elevation: float = 35.0
    field: float = FIELD
    target: tuple[float, ...] = (0.0, 0.0, 0.0)
    distance: float = 20.0
    perspective: bool = True

    @property
    def focal(self) -> float:
        """Length on the sheet of one metre at one metre from the viewer."""
        return float(1 / np.tan(np.radians(self.field) / 2))

    def moved(self, azimuth: float, elevation: float, factor: float = 1.0) -> "OrbitView":
        """The view after the viewer has turned by so many degrees, up to the zenith, and gone away by a factor."""
        raised = float(np.clip(self.elevation + elevation, -90, 90))
        return replace(self, azimuth=self.azimuth + azimuth, elevation=raised, distance=factor * self.distance)

    def fitted(self, points: Array, aspect: float) -> "OrbitView":
        """As near as it can be with all points (N, 3) in a picture of this width over height, in its middle."""
        view = self._near(points, aspect)
        for _ in range(CENTRINGS):
            flat = view.points(points)
            across, up = (flat.min(axis=0) + flat.max(axis=0)) / 2 * view.distance / view.focal
            moved = np.asarray(view.target) + across * view._rows[0] + up * view._rows[1]
            view = replace(view, target=tuple(float(v) for v in moved))._near(points, aspect)
        return view

    def _near(self, points: Array, aspect: float) -> "OrbitView":
        across, up, near = self._rows @ (points - np.asarray(self.target)).T
        reach = np.maximum(np.abs(across) / aspect, np.abs(up)) * self.focal
        needed = reach + near if self.perspective else reach
        return replace(self, distance=float(max(1.02 * needed.max(initial=0.0), 1e-6)))

    @cached_property
    def _rows(self) -> Array:
        """The unit vectors to the right, up, and towards the viewer."""
        e, a = np.radians([self.elevation, self.azimuth])
        towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return np.stack([right, np.cross(towards, right), towards])

    def seen(self, points: Array) -> Array:
        """Points (..., 3) as the viewer sees them: to the right, up, and how far away along the axis of the view."""
        turned = (np.asarray(points) - np.asarray(self.target)) @ self._rows.T
        return np.stack([turned[..., 0], turned[..., 1], self.distance - turned[..., 2]], axis=-1)

    def _sheet(self, seen: Array) -> Array:
        depth = seen[..., 2] if self.perspective else np.full(seen.shape[:-1], self.distance)
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.focal * seen[..., :2] / depth[..., None]

    def points(self, points: Array) -> Array:
        """Positions (N, 2) on the sheet of points (N, 3); nan for those behind the viewer."""
        seen = self.seen(points)
        return np.where(self._ahead(seen)[:, None], self._sheet(seen), np.nan)

    def _ahead(self, seen: Array) -> Mask:
        return seen[..., 2] >= NEAR * self.distance if self.perspective else np.isfinite(seen[..., 2])

    def lines(self, lines: Array) -> Array:
        """Polylines (N, 3) with rows of nan, on the sheet (M, 2), cut where they pass the viewer."""
        seen = self.seen(lines)
        ahead = self._ahead(seen)
        crossing = np.flatnonzero(ahead[1:] != ahead[:-1])
        crossing = crossing[np.isfinite(seen[crossing, 2] + seen[crossing + 1, 2])]
        a, b = seen[crossing], seen[crossing + 1]
        share = (NEAR * self.distance - a[:, 2]) / (b[:, 2] - a[:, 2])
        cuts = a + share[:, None] * (b - a)
        order = np.argsort(np.concatenate([np.arange(len(seen)), crossing + 0.5]), kind="stable")
        flat = np.concatenate([np.where(ahead[:, None], self._sheet(seen), np.nan), self._sheet(cuts)])
        return flat[order]

    def outlines(self, means: Array, shapes: Array) -> Array:
        """Outlines (M, 2), with rows of nan, of the ellipsoids of one sigma with means (K, 3) and shapes (K, 3, 3).

        They are exact, in perspective too. Of an ellipsoid that reaches to the viewer the longest axis is drawn.
        """
        good = np.isfinite(means).all(-1) & np.isfinite(shapes).all((-2, -1))
        rows = self._rows * np.array([[1.0], [1.0], [-1.0]])
        centre, spread = self.seen(means[good]), rows @ shapes[good] @ rows.T
        if self.perspective:  # mask of those that lie before the viewer as a whole
            whole = centre[:, 2] - np.sqrt(spread[:, 2, 2].clip(0)) > NEAR * self.distance
        else:
            whole = np.ones(len(centre), dtype=bool)
        rings = self._rings(centre[whole], spread[whole])
        axes = _longest(means[good][~whole], shapes[good][~whole])
        return strung([*rings, *([self.lines(strung(axes, 3))] if len(axes) else [])], 2)

    def _rings(self, centre: Array, spread: Array) -> Array:
        """Outlines (K, n, 2) of ellipsoids as they are seen.

        The tangent planes n . x = h of an ellipsoid satisfy n' P n = (n . c - h)^2, those through the viewer have
        h = 0, and they meet the sheet in the tangents of the outline: the ellipse of mean m and covariance S below.
        """
        if self.perspective:
            weight = (centre[:, 2] ** 2 - spread[:, 2, 2])[:, None]
            middle = (centre[:, :2] * centre[:, 2:] - spread[:, :2, 2]) / weight
            outer = centre[:, :2, None] * centre[:, None, :2]
            flat = (spread[:, :2, :2] - outer) / weight[:, :, None] + middle[:, :, None] * middle[:, None, :]
            scale = self.focal
        else:
            middle, flat, scale = centre[:, :2], spread[:, :2, :2], self.focal / self.distance
        return scale * (middle[:, None, :] + rings(flat))

    def flat(self, layers: tuple[Layer, ...]) -> tuple[Flat, ...]:
        """A scene on the sheet; marks that are far away come first."""
        found = []
        for layer in layers:
            lines = self.lines(layer.lines) if len(layer.lines) else layer.lines[:, :2]
            far = np.argsort(-self.seen(layer.marks)[:, 2], kind="stable")
            places = self.points(layer.places)
            shown = np.all(np.isfinite(places), axis=-1)
            words = tuple(w for w, s in zip(layer.words, shown, strict=True) if s)
            shells, marks = self.outlines(layer.means, layer.shapes), self.points(layer.marks)[far]
            found.append(Flat(layer.role, lines, shells, marks, places[shown], words))
        return tuple(found)


def rings(covariances: Array) -> Array:
    """Ellipses (K, n, 2) of one sigma around zero."""
    values, vectors = np.linalg.eigh(covariances)
    return np.swapaxes((vectors * np.sqrt(values.clip(0))[:, None, :]) @ CIRCLE, 1, 2)


def _longest(means: Array, shapes: Array) -> Array:
    """The longest axes (K, 2, 3) of ellipsoids."""
    values, vectors = np.linalg.eigh(shapes)
    half = vectors[:, :, -1] * np.sqrt(values[:, -1:].clip(0))
    return np.stack([means - half, means + half], axis=1)
