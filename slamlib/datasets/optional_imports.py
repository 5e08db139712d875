"""Packages that only work on real images needs: imported when they are used, since slamlib runs on NumPy alone."""

import importlib
from typing import Any

from slamlib.errors import SlamlibError

INSTALL = "pip install 'slamlib[images]'"


def opencv(purpose: str) -> Any:
    """OpenCV; raises SlamlibError that says what for ("to read images") and how to install it."""
    return _extra("cv2", "OpenCV", purpose)


def skimage(module: str, purpose: str) -> Any:
    """A module of scikit-image, as "skimage.data"; raises SlamlibError likewise."""
    return _extra(module, "scikit-image", purpose)


def _extra(module: str, package: str, purpose: str) -> Any:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise SlamlibError(f"{package} is needed {purpose}, and cannot be imported ({error}): {INSTALL}") from None
