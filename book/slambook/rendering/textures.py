"""Textures: grey pictures with their mip-maps, each level half as large as the one below it.

A pixel that covers many texels must see their mean; a level of the pyramid holds the means of 2 x 2 texels of the level
below, so that a pixel looks up the level whose texels are about as large as itself (Williams, 1983).
"""

import functools
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from slamlib.errors import SlamlibError, UnknownNameError, optional
from slamlib.manifolds import Array, Image, numbers

LEVELS = 6  # at most
SMALLEST = 2  # texels across, of any level: bilinear interpolation needs two
GREY = np.array([299, 587, 114])  # thousandths of red, green and blue, ITU-R BT.601


@dataclass(frozen=True, eq=False)
class Texture:
    """A grey picture (h, w), 0 to 255, whose row 0 is its upper border; made of any array of such numbers."""

    image: Image

    def __post_init__(self) -> None:
        image = numbers(self.image, "Texture", "image").astype(np.float32)
        if image.ndim != 2 or min(image.shape) < SMALLEST:
            raise SlamlibError(f"Texture: a grey image has shape (h, w), at least 2 x 2, got {image.shape}")
        if not (image.min() >= 0 and image.max() <= 255):
            raise SlamlibError("Texture: grey values lie between 0 and 255")
        image.flags.writeable = False
        object.__setattr__(self, "image", image)

    @functools.cached_property
    def levels(self) -> tuple[Array, ...]:
        """The pyramid: level k has texels of 2**k of the picture's; the first is padded with its border to fit."""
        count = min(LEVELS, int(np.log2(min(self.image.shape) // SMALLEST)) + 1)
        rest = [-size % 2 ** (count - 1) for size in self.image.shape]
        levels = [np.pad(self.image, [(0, r) for r in rest], mode="edge")]
        for _ in range(count - 1):
            one = levels[-1]
            levels.append((one[::2, ::2] + one[1::2, ::2] + one[::2, 1::2] + one[1::2, 1::2]) / np.float32(4))
        return tuple(levels)


# Pictures inside scikit-image's wheel, without those that are small, empty, or compressed with loss: a JPEG is not
# decoded alike everywhere.
PHOTOGRAPHS = (
    "astronaut",
    "brick",
    "camera",
    "chelsea",
    "coffee",
    "coins",
    "grass",
    "gravel",
    "ihc",
    "moon",
    "motorcycle_left",
    "page",
)


@functools.cache
def photograph(name: str) -> Texture:
    """A picture that scikit-image ships, by name (PHOTOGRAPHS); nothing is downloaded. Raises SlamlibError."""
    if name not in PHOTOGRAPHS:
        raise UnknownNameError.of("photograph", name, PHOTOGRAPHS)
    package = optional("skimage", "for photographs as textures (the drawn ones need nothing)", "images")
    file = Path(package.__file__).parent / "data" / f"{name}.png"
    if not file.is_file():
        raise SlamlibError(f"this scikit-image has no {file.name} beside it: use the drawn textures")
    picture = np.asarray(optional("skimage.io", "to read photographs", "images").imread(file))
    return Texture(picture if picture.ndim == 2 else (picture[..., :3] @ GREY + 500) // 1000)
