"""Checks of the chapter: the omnidirectional camera."""

import itertools
from typing import Any

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, given, holds, same
from slamlib.manifolds import Array

FISHEYES = [np.array(k) for k in ([0.0] * 4, [0.0035, 0.0007, -0.0021, 0.0002], [0.05, 0, 0, 0], [-0.05, 0, 0, 0])]


def _direction(angle: float, azimuth: float) -> Array:
    return np.array([np.sin(angle) * np.cos(azimuth), np.sin(angle) * np.sin(azimuth), np.cos(angle)])


def _two(found: Any) -> Array:
    """The candidate's two numbers; nan and infinity pass, for the property to name."""
    numbers = np.asarray(found)
    fits = numbers.shape == (2,) and numbers.dtype.kind in "fiu"
    return numbers.astype(float) if fits else array_of(found, (2,), "the point")


def _told(numbers: Array) -> str:
    return "(" + ", ".join(f"{number:.6g}" for number in numbers) + ")"


def _image(candidate: Candidate, point: Array, lens: tuple[Any, ...], expected: Any, what: str) -> None:
    """The image point by a lens, its focal length first, in units of that; a rejection names the point and the lens."""
    focal, *k = lens
    given(f"the point {_told(point)}, f = {focal:.6g}{''.join(f', k = {_told(each)}' for each in k)}, in units of f")
    found = _two(candidate(point, *lens)) / focal
    holds(np.isfinite(found).all(), what, f"found {found.tolist()}")
    same(found, expected, what)


@exercise("omnidirectional.1", "the stereographic lens", seed=91)
def stereographic(candidate: Candidate, rng: Rng) -> None:
    """Radius and azimuth at all angles, far and near; the axis; a circle on the sphere is a circle in the image."""
    near, what = 0.5 * _direction(1.0, 0.7), "a point farther along its ray is seen in the same place"
    given(f"the point {_told(near)} and eight times it, f = 300, in units of f")
    images = [_two(candidate(scale * near, 300.0)) / 300 for scale in (1, 8)]
    holds(np.isfinite(images).all(), what, f"found {np.array(images).tolist()}")
    same(images[1], images[0], what)
    for degrees in (20.0, 89.0, 90.0, 1e-7, 91.0, 150.0):
        f, angle, azimuth = rng.uniform(100, 500), np.radians(degrees), rng.uniform(-np.pi, np.pi)
        point = rng.uniform(0.1, 9) * _direction(angle, azimuth)
        what = "the radius is 2 f tan(phi/2)" if degrees <= 90 else "the radius is right behind the image plane too"
        given(f"the point {_told(point)}, f = {f:.6g}, in units of f")
        found = _two(candidate(point, f)) / f
        holds(np.isfinite(found).all(), what, f"found {found.tolist()}")
        same(np.hypot(*found), 2 * np.tan(angle / 2), what)
        turned = np.array([[np.cos(azimuth), np.sin(azimuth)], [-np.sin(azimuth), np.cos(azimuth)]]) @ found
        same(turned, [np.hypot(*found), 0], "the azimuth is kept")
    _image(candidate, np.array([0.0, 0, 2]), (300.0,), np.zeros(2), "the optical axis is seen at the centre")
    q, _ = np.linalg.qr(rng.standard_normal((3, 3)))
    ring = [_direction(0.5, turn) @ q.T for turn in 2 * np.pi * np.arange(12) / 12]
    given(f"twelve directions 0.5 rad from {_told(q[:, 2])}, f = 1")
    image = np.array([array_of(candidate(p, 1.0), (2,), "the image point") for p in ring])
    design = np.column_stack([image, np.ones(12)])
    squares = (image**2).sum(1)
    left = squares - design @ np.linalg.lstsq(design, squares, rcond=None)[0]
    same(left / squares.max(), np.zeros(12), "a circle on the sphere is imaged as a circle")


@exercise("omnidirectional.2", "the angle at a radius")
def angle_of(candidate: Candidate) -> None:
    """There and back for lenses that bend inwards, outwards, and stop growing; up to the fold."""
    lenses = {
        "an equidistant lens": [300.0, 0, 0],
        "a lens that bends inwards": [300.0, -1000, 0],
        "a lens that bends outwards": [300.0, 60, 5],
        "a lens with two places where it could stop": [447.0, -70, 4],
        "a lens that bends outwards, then inwards": [300.0, 60, -20],
    }
    for name, b in cases(lenses.items()):
        coefficients = np.array(b)
        squares = np.roots([5 * b[2], 3 * b[1], b[0]])
        stops = squares[(np.abs(squares.imag) < 1e-9) & (squares.real > 0)].real
        end = np.sqrt(stops.min()) if len(stops) else 3.0
        for angle in (share * end for share in (0.0, 1e-6, 0.3, 0.7, 0.95, 0.999)):
            radius = coefficients @ angle ** np.array([1, 3, 5])
            what = f"finds the angle of {name}"
            given(f"radius {radius:.6g} px, b = {b}")
            found = np.asarray(candidate(radius, coefficients))
            holds(found.shape == (), what, f"one number is asked for, found shape {found.shape}")
            holds(np.isfinite(found), what, f"found {found}")
            same(found, angle, what, tolerance=1e-7)


@exercise("omnidirectional.3", "a fisheye that sees behind itself", seed=93)
def fisheye(candidate: Candidate, rng: Rng) -> None:
    """OpenCV's formula in front; continuous across z = 0; the azimuth is kept behind; the axis."""
    for k in FISHEYES[:2]:
        for _ in range(5):
            f, azimuth = rng.uniform(150, 400), rng.uniform(-np.pi, np.pi)
            scale = rng.uniform(0.2, 8)
            for degrees in (10.0, 60.0, 89.0, 93.0, 120.0, 90.0):
                angle = np.radians(degrees)
                point = scale * _direction(angle, azimuth)
                what = "in front it is OpenCV's" if degrees < 90 else "it is right behind the plane z = 0"
                if degrees == 90:
                    point[2], what = 0, "it is right on the plane z = 0"
                radius = angle * (1 + k @ angle ** np.array([2, 4, 6, 8]))
                _image(candidate, point, (f, k), radius * np.array([np.cos(azimuth), np.sin(azimuth)]), what)
        _image(candidate, np.array([0.0, 0, 3]), (200.0, k), np.zeros(2), "the optical axis is seen at the centre")


@exercise("omnidirectional.5", "a limit for the angle", seed=95)
def undistorted(candidate: Candidate, rng: Rng) -> None:
    """Where the ray of an image point meets the plane z = 1, up to 90 degrees; beyond, and beyond the image, nan."""
    for k, degrees in itertools.product(FISHEYES, (0.0, 1e-6, 20.0, 60.0, 80.0, 85.0, 88.0)):
        q, ray = _seen_at(degrees, k, rng)
        what = "the ray is found up to 90 degrees" if degrees else "the centre stays the centre"
        found = _two(candidate(q, k))
        holds(np.isfinite(found).all(), what, f"found {found.tolist()}")
        same(found, ray, what, tolerance=1e-6)
    for k, degrees in itertools.product(FISHEYES, (91.0, 100.0, 125.0)):
        q, _ = _seen_at(degrees, k, rng)
        found = _two(candidate(q, k))
        holds(np.isnan(found).all(), "beyond 90 degrees there is no point", f"found {found.tolist()}")
    q, k = np.array([0.0, 1.9]), FISHEYES[3]
    given(f"q = {_told(q)}, k = {_told(k)}, whose largest radius is 1.72")
    found = _two(candidate(q, k))
    holds(np.isnan(found).all(), "what no direction has as its image has no point", f"found {found.tolist()}")


def _seen_at(degrees: float, k: Array, rng: Rng) -> tuple[Array, Array]:
    """The image point (2,) of a direction, in focal lengths, and where its ray meets the plane z = 1."""
    angle, azimuth = np.radians(degrees), rng.uniform(-np.pi, np.pi)
    way = np.array([np.cos(azimuth), np.sin(azimuth)])
    q = angle * (1 + k @ angle ** np.array([2, 4, 6, 8])) * way
    given(f"q = {_told(q)}, seen {degrees:g} degrees off the axis, k = {_told(k)}")
    return q, np.tan(angle) * way
