"""Photographs and a real sequence to try the image machinery on; tests skip where they are missing."""

import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest

DATA = Path(os.environ.get("SLAMLIB_DATA") or "no-data")  # real sequences, which are not shipped
CUBE = DATA / "mono_visp_cube" / "frames"
# Two cameras in Kalibr's form, without their extrinsics.
KALIBR = """cam0:
  camera_model: pinhole
  distortion_coeffs: [-0.01, 0.02, -0.01, 0.003]
  distortion_model: equidistant
  intrinsics: [380.0, 381.0, 320.0, 240.0]
  resolution: [640, 480]
cam1:
  camera_model: pinhole
  distortion_coeffs: []
  distortion_model: none
  intrinsics: [390.0, 391.0, 321.0, 241.0]
  resolution: [640, 480]
"""
NAMES = ("camera", "coins", "gravel", "astronaut", "chelsea")


@cache
def photograph(name: str) -> np.ndarray:
    """One of scikit-image's pictures, grey (240, 320) of uint8: every other pixel of an average of four."""
    data = pytest.importorskip("skimage.data", reason="scikit-image, whose photographs are used, is not installed")
    image = np.asarray(getattr(data, name)(), dtype=float)
    image = image @ [0.299, 0.587, 0.114] if image.ndim == 3 else image
    rows, columns = (min(n // 2, m) for n, m in zip(image.shape, (240, 320), strict=True))
    image = image[: 2 * rows, : 2 * columns].reshape(rows, 2, columns, 2).mean((1, 3))
    return np.rint(image).astype(np.uint8)


@cache
def cube(number: int) -> np.ndarray:
    """A frame of the real sequence, (288, 384) of uint8."""
    file = CUBE / f"image.{number:04d}.pgm"
    if not file.is_file():
        pytest.skip("the real sequence (mono_visp_cube) is not at hand")
    kind, size, _, pixels = file.read_bytes().split(b"\n", 3)
    assert kind == b"P5"
    width, height = map(int, size.split())
    return np.frombuffer(pixels, np.uint8).reshape(height, width)


def smooth(u: np.ndarray, v: np.ndarray, seed: int = 0, shortest: float = 5.0) -> np.ndarray:
    """An image that is known between the pixels too: grey levels at (u, v), a sum of waves of `shortest` px or more."""
    rng = np.random.default_rng(seed)
    turn, phase = rng.uniform(0, 2 * np.pi, (2, 30))
    k = 2 * np.pi / (shortest * rng.uniform(1, 4, 30))
    waves = np.cos(np.multiply.outer(u, k * np.cos(turn)) + np.multiply.outer(v, k * np.sin(turn)) + phase)
    return 128 + 15 * waves.sum(-1)


def grid(height: int, width: int) -> tuple[np.ndarray, np.ndarray]:
    """The pixels u and v of an image, (h, w) each."""
    v, u = np.mgrid[:height, :width].astype(float)
    return u, v


def windows(monkeypatch):
    """Snapshots that are shown, in a list: no window opens."""
    shown = []

    class Window:
        def __init__(self, snapshot, *, world, show):
            assert show

        def update(self, snapshot, truth):
            shown.append(snapshot)

    monkeypatch.setattr("slambook.scene.drawing.Window", Window)
    return shown
