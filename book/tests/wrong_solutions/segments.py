"""Wrong solutions of chapter segments."""

import numpy as np

from book.tests.wrong_solutions import wrong
from slamlib.geometry import quaternion
from slamlib.landmarks.segments import frustum


@wrong("segments.1", "the sign")
def other_way(k1, height, length):
    return k1 * height * length**2 / 4


@wrong("segments.1", "the whole length for its half")
def whole_length(k1, height, length):
    return -k1 * height * length**2


@wrong("segments.1", "the middle's own displacement")
def displacement(k1, height, length):
    return k1 * height**3


@wrong("segments.1", "half the length squared at only one end: twice too small")
def one_end(k1, height, length):
    return -k1 * height * length**2 / 8


@wrong("segments.1", "a distance, without its sign")
def no_sign(k1, height, length):
    return abs(k1 * height) * length**2 / 4


@wrong("segments.1", "the chord left where it was")
def ideal_chord(k1, height, length):
    return k1 * height * height**2


@wrong("segments.1", "the length forgotten in the square")
def of_the_height(k1, height, length):
    return -k1 * height**2 * length / 4


@wrong("segments.2", "as they were")
def unchanged(line, abscissas, pose):
    return 1.0 * abscissas


@wrong("segments.2", "v taken for a unit vector")
def not_a_unit(line, abscissas, pose):
    return abscissas - pose[:3] @ line[3:]


@wrong("segments.2", "the other way round")
def other_sign(line, abscissas, pose):
    return abscissas + pose[:3] @ line[3:] / np.linalg.norm(line[3:])


@wrong("segments.2", "v turned into the new frame, t not")
def turned_direction(line, abscissas, pose):
    return abscissas - pose[:3] @ quaternion.rotation(pose[3:]).T @ line[3:] / np.linalg.norm(line[3:])


@wrong("segments.2", "the distance of the origins")
def distance(line, abscissas, pose):
    return abscissas - np.linalg.norm(pose[:3])


@wrong("segments.2", "divided by v . v")
def squared(line, abscissas, pose):
    return abscissas - pose[:3] @ line[3:] / (line[3:] @ line[3:])


def _inside(point, intrinsics, image):
    pixel = intrinsics[:2] + intrinsics[2:] * point[:2] / point[2]
    return bool(point[2] > 0 and (pixel >= 0).all() and (pixel <= image).all())


@wrong("segments.3", "as published: the endpoints, else the midpoint")
def ends_or_middle(first, second, intrinsics, image):
    return any(_inside(p, intrinsics, np.array(image)) for p in (first, second, (first + second) / 2))


@wrong("segments.3", "only outside if both endpoints are outside of the same side")
def no_side_says_no(first, second, intrinsics, image):
    A = frustum(intrinsics, image)
    return not ((A @ first < 0) & (A @ second < 0)).any()


@wrong("segments.3", "projects first and clips the pixels")
def divides_first(first, second, intrinsics, image):
    ends = [intrinsics[:2] + intrinsics[2:] * p[:2] / p[2] for p in (first, second)]
    points = ends[0] + np.linspace(0, 1, 2001)[:, None] * (ends[1] - ends[0])
    return bool(((points >= 0) & (points <= image)).all(-1).any())


@wrong("segments.3", "one of the endpoints is in the image")
def an_end(first, second, intrinsics, image):
    return _inside(first, intrinsics, np.array(image)) or _inside(second, intrinsics, np.array(image))


@wrong("segments.3", "clips the infinite line")
def infinite(first, second, intrinsics, image):
    start, end = frustum(intrinsics, image) @ first, frustum(intrinsics, image) @ second
    with np.errstate(all="ignore"):
        at = start / (start - end)
    enters = end > start
    return bool(at[enters].max(initial=-np.inf) <= at[~enters].min(initial=np.inf))


@wrong("segments.3", "gives up if an end is behind the camera")
def both_in_front(first, second, intrinsics, image):
    return bool(min(first[2], second[2]) > 0 and near_plane(first, second, intrinsics, image, least=0))


@wrong("segments.3", "the box around both pixels meets the image")
def box(first, second, intrinsics, image):
    ends = np.array([intrinsics[:2] + intrinsics[2:] * p[:2] / p[2] for p in (first, second)])
    in_front = max(first[2], second[2]) > 0
    return bool(in_front and (ends.max(0) >= 0).all() and (ends.min(0) <= image).all())


@wrong("segments.3", "height and width exchanged")
def exchanged(first, second, intrinsics, image):
    return near_plane(first, second, intrinsics, image[::-1], least=0)


def _sampled(first, second, intrinsics, image, n):
    points = first + np.linspace(0, 1, n)[:, None] * (second - first)
    return any(_inside(p, intrinsics, np.array(image)) for p in points)


@wrong("segments.3", "fifty samples of the segment: a short part in view falls between two of them")
def samples(first, second, intrinsics, image):
    return _sampled(first, second, intrinsics, image, 50)


@wrong("segments.3", "fifty-one samples: the middle is one of them")
def samples_and_middle(first, second, intrinsics, image):
    return _sampled(first, second, intrinsics, image, 51)


@wrong("segments.3", "a thousand and one samples")
def many_samples(first, second, intrinsics, image):
    return _sampled(first, second, intrinsics, image, 1001)


@wrong("segments.3", "clips at a depth of ten centimetres, and what is nearer is lost")
def near_plane(first, second, intrinsics, image, least=0.1):
    planes, offsets = np.array([*frustum(intrinsics, image), [0, 0, 1]]), np.array([0, 0, 0, 0, least])
    start, end = planes @ first - offsets, planes @ second - offsets
    with np.errstate(all="ignore"):
        at = start / (start - end)
    enter, leave = at[start < 0].max(initial=0), at[(start >= 0) & (end < 0)].min(initial=1)
    return bool(enter <= leave and not ((start < 0) & (end < 0)).any())


@wrong("segments.3", "takes the middle of the image for the principal point")
def middle(first, second, intrinsics, image):
    return near_plane(first, second, [*np.array(image) / 2, *intrinsics[2:]], image, least=0)
