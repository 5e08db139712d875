"""Active search for straight edges: across their predictions; and new ones from a detector. Chapter monocular.

An edge looks the same all along it (the aperture problem), so two numbers are estimated: the displacements of the two
endpoints of the predicted segment across it. Their covariance follows from that of the innovation, and the search
region is an ellipse in the plane of these two numbers, as that of a point is one in the image.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import compress

import numpy as np
from numpy.typing import ArrayLike

from slamlib.entities import RigSensor
from slamlib.errors import SlamlibError
from slamlib.landmarks.segments import length
from slamlib.manifolds import Array, Image, Mask
from slamlib.observation.lines import distort_segments, undistort_segments
from slamlib.sensors.sensor import Calibration
from slamlib.slam.data_association.front_end import FrontEndInput, Usable
from slamlib.slam.data_association.gates import gate
from slamlib.slam.prediction import PredictedMeasurement, Predictions
from slamlib.vision.edges import PROFILE, STEP, Edge, EdgeStrip, axes, edge_strip, fitted, line, refined, segments_of
from slamlib.vision.image_front_end import ImageFrontEnd

SAME = 1.0  # [px]: two fits closer than this are of the same edge
TWINS = 1.5  # [px]: two landmarks whose edges are closer than this are the same
DIFFERENCE_STEP = 1e-3  # [px]: step of the numerical derivative of the innovation w.r.t. an endpoint
FLANK = 2.0  # [px]: lines closer than this are of the same edge


@dataclass(frozen=True, eq=False)
class EdgeLook:
    """Signature of an edge: mean grey values across it (17,), half a pixel apart, and their slope in it [1/px]."""

    profile: Array
    slope: float


@dataclass(frozen=True)
class SegmentSettings:
    """Settings of the search for edges.

    minimum_length [px], and least slope [1/px], of a new edge. support: least visible share of an edge;
    min_new_support: the same of a new one. straightness: largest rms [px] of an edge's points about it. min_separation:
    least distance [px] of a new edge from every predicted one. max_in_view: with so many in view, none is initialized.
    threshold: least ZNCC of the grey values across. min_slope_ratio: least share of its first slope.
    max_second_ratio: a match is ambiguous if another edge of the region has more than this share of its ZNCC.
    probability: that a region contains the true edge, if the filter is consistent. largest: half the width [px] of the
    widest region; most: lines that are tried in it. beyond [px]: how far an edge is searched past its endpoints.
    max_backoff: most frames for which a missed edge is skipped.
    """

    minimum_length: float = 30.0
    slope: float = 6.0
    support: float = 0.5
    min_new_support: float = 0.8
    straightness: float = 0.4
    min_separation: float = 6.0
    max_in_view: int = 10
    threshold: float = 0.9
    min_slope_ratio: float = 0.5
    max_second_ratio: float = 0.95
    probability: float = 0.99
    largest: float = 40.0
    most: int = 4000
    beyond: float = 4.0
    max_backoff: int = 16


class SegmentSearch(ImageFrontEnd[EdgeLook, SegmentSettings]):
    """A front end for the segments of one camera with an image."""

    size, signature_type = 4, EdgeLook

    def __init__(self, calibration: Calibration, settings: SegmentSettings | None = None) -> None:
        """Raise SlamlibError for a sensor without an image, or without a projection of lines."""
        if calibration.image is None or calibration.sensor.project_line is None:
            raise SlamlibError(f"SegmentSearch: {calibration.sensor.name} has no image of straight lines")
        super().__init__(calibration, settings or SegmentSettings())

    def searchable(self, inputs: FrontEndInput) -> Predictions:
        """The predictions whose region is narrow enough to distinguish edges, and that are not in search backoff."""
        s, limit = self.settings, gate(self.settings.probability, 2)
        regions = across_covariances(inputs.predictions, inputs.sensor)
        half = np.sqrt(limit * np.diagonal(regions, axis1=1, axis2=2).max(-1, initial=0))
        count = np.pi * limit * np.sqrt(np.linalg.det(regions)) / STEP**2
        return self.ready(compress(inputs.predictions, (half <= s.largest) & (count <= s.most)))

    def find(self, inputs: FrontEndInput, predictions: Predictions) -> Iterable[tuple[int, Array]]:
        """Row and segment (4,) of each landmark that is found; of two on one edge, the one with the higher score."""
        image, regions = np.asarray(inputs.scan.image, dtype=float), across_covariances(predictions, inputs.sensor)
        expected = self.undistorted([prediction.value for prediction in predictions])
        found = [
            (row, self.find_edge(image, prediction, ideal, region))
            for row, (prediction, ideal, region) in enumerate(zip(predictions, expected, regions, strict=True))
        ]
        edges = [(row, edge) for row, edge in found if edge is not None]
        kept: list[tuple[int, Edge]] = []
        for row, edge in sorted(edges, key=lambda item: -predictions[item[0]].score):
            others = np.array([other.ideal for _, other in kept]).reshape(-1, 4)
            if not side_by_side(edge.ideal, others, TWINS).any():
                kept.append((row, edge))
        return [(row, edge.segment) for row, edge in kept]

    def find_edge(self, image: Image, prediction: PredictedMeasurement, ideal: Array, region: Array) -> Edge | None:
        """The edge of the region that matches the landmark; None if there is none, or if it is ambiguous."""
        s, limit = self.settings, gate(self.settings.probability, 2)
        half = np.sqrt(limit * np.diag(region).max()) + PROFILE[-1] + 2
        piece = edge_strip(image, self.calibration, ideal, half, s.beyond)
        near = steep_lines(piece, lines_of(region, limit))
        edges = [e for offsets in near if (e := fitted(piece, self.calibration, offsets, 1.0)) is not None]
        profile = prediction.landmark.signature.profile
        steep = s.min_slope_ratio * prediction.landmark.signature.slope
        likes = [(e.likeness(profile), i) for i, e in enumerate(edges) if e.good(s.support, s.straightness, steep)]
        if not likes:
            return None
        prediction.score, best = max(likes)
        away = [np.abs(e.offsets - edges[best].offsets).mean() > SAME for e in edges]
        rivals = [like for like, i in likes if away[i]]
        least = max(s.threshold, max(rivals, default=0.0) / s.max_second_ratio)
        return edges[best] if prediction.score >= least else None

    def undistorted(self, segments: ArrayLike) -> Array:
        """Segments (n, 4) [px] without the lens distortion."""
        return undistort_segments(self.calibration, np.reshape(segments, (-1, 4)))[0]

    def new_landmarks(self, inputs: FrontEndInput, usable: Usable, count: int) -> Iterator[tuple[Array, EdgeLook]]:
        """Segment and EdgeLook of up to `count` new edges, the longest that match no prediction."""
        s, image = self.settings, np.asarray(inputs.scan.image)
        count = min(count, s.max_in_view - len(inputs.predictions))
        if count <= 0:
            return
        taken = self.undistorted([prediction.value for prediction in inputs.predictions])
        segments = segments_of(image, s.minimum_length)
        for segment, ideal in zip(segments, self.undistorted(segments), strict=True):
            if side_by_side(ideal, taken, s.min_separation).any():
                continue
            edge = refined(image, self.calibration, segment)
            if edge is None or not edge.good(s.min_new_support, s.straightness, s.slope):
                continue
            if usable(edge.segment[None])[0]:
                taken, count = np.concatenate([taken, ideal[None]]), count - 1
                yield edge.segment, EdgeLook(edge.profile, edge.slope)
                if not count:
                    return


def across_covariances(predictions: Predictions, sensor: RigSensor) -> Array:
    """Covariances (n, 2, 2) [px^2] of the displacements across of predicted endpoints, from those of the innovations.

    An innovation z is linear in small displacements a of the endpoints, z = J a, so cov(a) = J^-1 S J^-T.
    """
    found = np.zeros((len(predictions), 2, 2))
    for expected in {id(prediction.batch): prediction.batch for prediction in predictions}.values():
        rows = [i for i, prediction in enumerate(predictions) if prediction.batch is expected]
        own, ideal = [predictions[i].row for i in rows], undistort_segments(sensor.calibration, expected.value)[0]
        right = axes(ideal[own])[1]
        none = np.zeros_like(right)
        moved = [ideal[own] + DIFFERENCE_STEP * np.concatenate(m, axis=-1) for m in ((right, none), (none, right))]
        measured = distort_segments(sensor.calibration, np.concatenate(moved))
        z = predictions[rows[0]].family.batch_innovation(sensor, expected.take(own + own), measured).z
        inverse = np.linalg.inv(z.reshape(2, len(own), 2).transpose(1, 2, 0) / DIFFERENCE_STEP)
        found[rows] = inverse @ np.array([predictions[i].S for i in rows]) @ inverse.swapaxes(-1, -2)
    return found


def side_by_side(one: Array, others: Array, apart: float) -> Mask:
    """Mask (n,) of the ideal segments (n, 4) on the line of one (4,), nearer to it than apart [px], and
    overlapping with it along the line."""
    forward, right = axes(one)
    endpoints = others.reshape(-1, 2, 2) - one[:2]
    along, across = endpoints @ forward, endpoints @ right
    beside = (along.max(-1) > 0) & (along.min(-1) < length(one))
    return np.asarray(beside & (np.abs(across).max(-1) < apart))


def lines_of(region: Array, limit: float) -> Array:
    """Offsets (n, 2) [px] of lines, STEP apart: those nearest to some line with a' C^-1 a <= limit.

    region: C (2, 2). A displacement by r changes the root of a' C^-1 a by at most |r| times the root of C^-1's largest
    eigenvalue; so some more are taken at the tips of a thin ellipse. There is always one.
    """
    half = np.sqrt(limit * np.diag(region)) + STEP / 2
    steps = [STEP * np.arange(-np.floor(h / STEP), np.floor(h / STEP) + 1) for h in half]
    a = np.stack(np.meshgrid(*steps, indexing="ij"), -1).reshape(-1, 2)
    inverse = np.linalg.inv(region)
    root = np.sqrt(np.maximum(np.einsum("ni,ij,nj->n", a, inverse, a), 0))
    return a[root <= np.sqrt(limit) + STEP / np.sqrt(2) * np.sqrt(np.linalg.eigvalsh(inverse)[-1])]


def steep_lines(s: EdgeStrip, offsets: Array, most: int = 4) -> Array:
    """Of lines with offsets (n, 2), those (k, 2) with the steepest rise of the grey value: local maxima, best first."""
    slope = np.nan_to_num(s.slope)
    index = np.rint((line(offsets, s.share) - s.across[0]) / STEP).astype(int)
    rises = slope[np.clip(index, 0, len(slope) - 1), np.arange(len(s.along))].mean(1)
    found, left = list[Array](), rises.copy()
    while len(found) < most and left.max() > rises.max() / 2 > 0:
        best = offsets[left.argmax()]
        found.append(best)
        left[np.abs(offsets - best).mean(1) < FLANK] = 0
    return np.array(found).reshape(-1, 2)
