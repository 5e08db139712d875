"""Models of lenses: OpenCV's pixels, the inverses of the papers, and images without distortion through each of them."""

import numpy as np
import pytest

from slamlib.datasets.lens import Lens
from slamlib.datasets.lens_models import DIVISION, DOUBLE_SPHERE, EXTENDED, FISHEYE, FOV, MODELS, THIN_PRISM, UNIFIED
from slamlib.datasets.rectification import undistortion
from slamlib.errors import SlamlibError
from slamlib.rigs.setup import SensorSetup

cv2 = pytest.importorskip("cv2", reason="OpenCV is compared with, and undistorts")
SIZE = (320, 240)
LENSES = {
    "thin prism": Lens(
        (160, 120, 250, 252), SIZE, distortion=(-0.2, 0.05, 0.001, 0.002, 0, 0, 0, 0, 0.01, 0, -0.01, 0)
    ),
    "tilt": Lens((160, 120, 250, 252), SIZE, distortion=(-0.2, 0.05, 0.001, 0.002, *[0] * 8, 0.03, -0.02)),
    FISHEYE: Lens((160, 120, 150, 151), SIZE, FISHEYE, (-0.02, 0.01, -0.003, 0.001)),
    THIN_PRISM: Lens((160, 120, 150, 151), SIZE, THIN_PRISM, (-0.02, 0.01, 0.002, -0.001, 0.003, 0.001, 0.01, -0.01)),
    FOV: Lens((160, 120, 180, 181), SIZE, FOV, (0.9,)),
    UNIFIED: Lens((160, 120, 400, 401), SIZE, UNIFIED, (1.2, -0.1, 0.02, 0.001, -0.002)),
    DOUBLE_SPHERE: Lens((160, 120, 130, 131), SIZE, DOUBLE_SPHERE, (-0.2, 0.55)),
    EXTENDED: Lens((160, 120, 160, 161), SIZE, EXTENDED, (0.6, 1.1)),
    DIVISION: Lens((160, 120, 200, 201), SIZE, DIVISION, (-0.3,)),
}


def towards(width, count=500):
    """Rays in front of the camera, of any length, (count, 3)."""
    rng = np.random.default_rng(3)
    rays = np.concatenate([rng.uniform(-width, width, (count, 2)), np.ones((count, 1))], axis=1)
    return np.concatenate([rays * rng.uniform(0.5, 4, (count, 1)), [[0, 0, 1.0]]])


@pytest.mark.parametrize("count", [0, 4, 5, 8, 12, 14])
def test_opencv_has_the_same_pixels(count):
    k = 0.05 * np.random.default_rng(count).standard_normal(count)
    lens, rays = Lens((160, 120, 250, 252), distortion=tuple(k)), towards(0.6)
    there, _ = cv2.projectPoints(rays[:, None], np.zeros(3), np.zeros(3), lens.matrix, k)
    np.testing.assert_allclose(lens.pixels(rays), there[:, 0], atol=1e-9)
    assert np.isnan(lens.pixels(-rays)).all()


def test_opencvs_fisheye_has_the_same_pixels():
    lens, rays = LENSES[FISHEYE], towards(3)
    there, _ = cv2.fisheye.projectPoints(
        rays[:, None], np.zeros(3), np.zeros(3), lens.matrix, np.array(lens.distortion)
    )
    np.testing.assert_allclose(lens.pixels(rays), there[:, 0], atol=1e-9)


def double_sphere(m, xi, alpha):
    """The inverse in Usenko and others (2018), equations 46 to 50."""
    r2 = (m**2).sum(-1)
    z = (1 - alpha**2 * r2) / (alpha * np.sqrt(1 - (2 * alpha - 1) * r2) + 1 - alpha)
    scale = (z * xi + np.sqrt(z**2 + (1 - xi**2) * r2)) / (z**2 + r2)
    return np.column_stack([scale[:, None] * m, scale * z - xi])


def extended_unified(m, alpha, beta):
    """The inverse in Usenko and others (2018), equations 38 to 40."""
    r2 = (m**2).sum(-1)
    z = (1 - beta * alpha**2 * r2) / (alpha * np.sqrt(1 - (2 * alpha - 1) * beta * r2) + 1 - alpha)
    return np.column_stack([m, z])


def unified(m, xi):
    """The inverse in Mei and Rives (2007), without distortion."""
    r2 = (m**2).sum(-1)
    scale = (xi + np.sqrt(1 + (1 - xi**2) * r2)) / (r2 + 1)
    return np.column_stack([scale[:, None] * m, scale - xi])


def fov(m, omega):
    """The inverse in Devernay and Faugeras (2001)."""
    r = np.linalg.norm(m, axis=1)
    return np.column_stack(
        [m * np.tan(r * omega)[:, None] / (2 * np.tan(omega / 2) * np.maximum(r, 1e-12)[:, None]), r * 0 + 1]
    )


def division(m, k):
    """The model of Fitzgibbon (2001)."""
    return np.column_stack([m, 1 + k * (m**2).sum(-1)])


@pytest.mark.parametrize(
    ("model", "inverse", "k"),
    [
        (DOUBLE_SPHERE, double_sphere, (-0.2, 0.55)),
        (DOUBLE_SPHERE, double_sphere, (0.3, 0.4)),
        (EXTENDED, extended_unified, (0.6, 1.1)),
        (UNIFIED, unified, (1.2,)),
        (UNIFIED, unified, (0.7,)),
        (FOV, fov, (0.9,)),
        (DIVISION, division, (-0.3,)),
        (DIVISION, division, (0.02,)),
    ],
)
def test_the_inverses_of_the_papers_return_the_rays(model, inverse, k):
    rays = towards(1.5)
    back = inverse(Lens((0, 0, 1, 1), model=model, distortion=k).pixels(rays), *k)
    np.testing.assert_allclose(np.cross(back, rays), 0, atol=1e-9)
    assert (np.einsum("ij,ij->i", back, rays) > 0).all()


def test_without_coefficients_every_model_is_a_pinhole_or_the_fisheye():
    rays = towards(0.5)
    for name, model in MODELS.items():
        found = Lens((1, 2, 30, 40), model=name, distortion=(0.0,) * model.coefficients)
        plane = rays[:, :2] / rays[:, 2:]
        if name in (FISHEYE, THIN_PRISM):
            r = np.maximum(np.linalg.norm(plane, axis=1, keepdims=True), 1e-12)
            plane = plane * np.arctan(r) / r
        np.testing.assert_allclose(found.pixels(rays), plane * [30, 40] + [1, 2], atol=1e-9)


def test_thin_prisms_and_fisheyes_add_up():
    """A thin-prism fisheye is the fisheye, and OpenCV's tangential and thin-prism terms on its image."""
    lens, rays = LENSES[THIN_PRISM], towards(0.8)
    k1, k2, p1, p2, k3, k4, s_x, s_y = lens.distortion
    fisheye = Lens((0, 0, 1, 1), model=FISHEYE).pixels(rays)
    t2 = (fisheye**2).sum(-1, keepdims=True)
    bent = Lens((0, 0, 1, 1), distortion=(k1, k2, p1, p2, k3, 0, 0, 0, s_x, 0, s_y, 0))
    expected = bent.pixels(np.column_stack([fisheye, np.ones(len(rays))])) + k4 * t2**4 * fisheye
    np.testing.assert_allclose(lens.pixels(rays), expected * [150, 151] + [160, 120], atol=1e-9)


@pytest.mark.parametrize("name", LENSES)
def test_images_without_distortion_are_a_pinholes(name):
    """Spots where the lens has its image of a ray are moved to where the new pin-hole has it."""
    lens = LENSES[name]
    undistort, setup = undistortion(lens, SIZE)
    assert undistort(np.full(SIZE[::-1], 200, np.uint8)).min() == 200  # nowhere what the lens did not see
    camera, rays = SensorSetup(**setup).calibration, towards(0.45, 60)
    old = lens.pixels(rays)
    new = camera.project(np.column_stack([rays, np.ones(len(rays))]))
    seen = ((old > 20) & (old < np.array(SIZE) - 20) & (new > 20) & (new < np.array(SIZE) - 20)).all(1)
    assert seen.sum() > 10
    assert np.abs(old - new).max() > 1
    v, u = np.mgrid[: SIZE[1], : SIZE[0]]
    for place, wanted in list(zip(old[seen], new[seen], strict=True))[:8]:
        spot = 250 * np.exp(-((u - place[0]) ** 2 + (v - place[1]) ** 2) / 18)
        found = undistort(spot.round().astype(np.uint8)).astype(float)
        centre = np.array([(found * u).sum(), (found * v).sum()]) / found.sum()
        np.testing.assert_allclose(centre, wanted, atol=0.3)


@pytest.mark.parametrize(
    ("model", "k", "said"),
    [
        (UNIFIED, (-0.1,), "xi is from 0 to 20, got -0.1"),
        (UNIFIED, (376.0, 0.1), "xi is from 0 to 20, got 376"),
        (DOUBLE_SPHERE, (0.55, -0.2), "alpha is from 0 to 1, got -0.2"),
        (DOUBLE_SPHERE, (1.5, 0.2), "xi is from -1 to 1, got 1.5"),
        (EXTENDED, (1.1, 0.6), "alpha is from 0 to 1, got 1.1"),
        (EXTENDED, (0.6, -1.1), "beta is from 0 to inf, got -1.1"),
        (FOV, (-0.9,), "omega is from 0 to 3.14, got -0.9"),
    ],
)
def test_coefficients_that_no_lens_has_are_refused_before_pictures_are_undistorted(model, k, said):
    with pytest.raises(SlamlibError, match=f"{said}: are the numbers in another order"):
        Lens((320, 240, 300, 300), (640, 480), model, k)


@pytest.mark.parametrize("name", ["thin prism", "tilt", THIN_PRISM, FOV, DIVISION])
def test_lenses_that_the_filter_lacks_ask_for_undistort(name):
    with pytest.raises(SlamlibError, match="--undistort"):
        LENSES[name].setup()
    assert not LENSES[name].is_pinhole
    assert not Lens((160, 120, 150, 151), model=FISHEYE, distortion=(0.0,)).is_pinhole
