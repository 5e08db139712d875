"""Checks of the chapter: the omnidirectional camera."""

import numpy as np

from slambook.exercises.kit import Candidate, Rng, array_of, cases, exercise, given, same
from slamlib.manifolds import Array


def _direction(angle: float, azimuth: float) -> Array:
    return np.array([np.sin(angle) * np.cos(azimuth), np.sin(angle) * np.sin(azimuth), np.cos(angle)])


@exercise("omnidirectional.1", "the stereographic lens", seed=91)
def stereographic(candidate: Candidate, rng: Rng) -> None:
    """Radius and azimuth at all angles, far and near; the axis; a circle on the sphere is a circle in the image."""
    for degrees in cases((1e-7, 20.0, 89.0, 90.0, 91.0, 150.0), "{:g} degrees, in units of f"):
        f, angle, azimuth = rng.uniform(100, 500), np.radians(degrees), rng.uniform(-np.pi, np.pi)
        found = array_of(candidate(rng.uniform(0.1, 9) * _direction(angle, azimuth), f), (2,), "the image point") / f
        what = "the radius is 2 f tan(phi/2)" if degrees <= 90 else "the radius is right behind the image plane too"
        same(np.hypot(*found), 2 * np.tan(angle / 2), what)
        turned = np.array([[np.cos(azimuth), np.sin(azimuth)], [-np.sin(azimuth), np.cos(azimuth)]]) @ found
        same(turned, [np.hypot(*found), 0], "the azimuth is kept")
    same(candidate(np.array([0.0, 0, 2]), 300.0), np.zeros(2), "the optical axis is seen at the centre")
    q, _ = np.linalg.qr(rng.standard_normal((3, 3)))
    ring = [_direction(0.5, turn) @ q.T for turn in 2 * np.pi * np.arange(12) / 12]
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
            given(f"radius {radius:.6g} px, b = {b}")
            same(candidate(radius, coefficients), angle, f"finds the angle of {name}", tolerance=1e-7)


@exercise("omnidirectional.3", "a fisheye that sees behind itself", seed=93)
def fisheye(candidate: Candidate, rng: Rng) -> None:
    """OpenCV's formula in front; continuous across z = 0; the azimuth is kept behind; the axis."""
    for k in (np.zeros(4), np.array([0.0035, 0.0007, -0.0021, 0.0002])):
        for _ in range(5):
            f, azimuth = rng.uniform(150, 400), rng.uniform(-np.pi, np.pi)
            scale = rng.uniform(0.2, 8)
            for degrees in cases((10.0, 60.0, 89.0, 90.0, 93.0, 120.0), "{:g} degrees, in units of f"):
                angle = np.radians(degrees)
                point = scale * _direction(angle, azimuth)
                what = "in front it is OpenCV's" if degrees < 90 else "it is right behind the plane z = 0"
                if degrees == 90:
                    point[2], what = 0, "it is right on the plane z = 0"
                found = array_of(candidate(point, f, k), (2,), "the image point") / f
                radius = angle * (1 + k @ angle ** np.array([2, 4, 6, 8]))
                same(found, radius * np.array([np.cos(azimuth), np.sin(azimuth)]), what)
        same(candidate(np.array([0.0, 0, 3]), 200.0, k), np.zeros(2), "the optical axis is seen at the centre")
