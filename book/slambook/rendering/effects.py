"""What a camera makes of the light: its lens's blur and dark corners, its exposure, its noise, whole grey values."""

from dataclasses import dataclass, fields

import numpy as np

from slamlib.errors import SlamlibError
from slamlib.manifolds import Array, Image

WIDEST = 0.7  # [px]: the largest blur that three numbers hold


@dataclass(frozen=True)
class Effects:
    """noise: standard deviation of a pixel [grey values]. gain: that of the exposure's logarithm, whose
    correlation time is gain_time [s]. vignetting: the share of light that is lost in the image's corners. blur [px]:
    standard deviation of the spot that the lens makes of a point. exposure [s]: how long the shutter is open, half of
    it before the frame's time and half after; the picture is the mean of `exposures` pictures.
    """

    noise: float = 2.0
    gain: float = 0.05
    gain_time: float = 1.0
    vignetting: float = 0.2
    blur: float = 0.4
    exposure: float = 0.0
    exposures: int = 4

    def __post_init__(self) -> None:
        for name in (f.name for f in fields(self)):
            if not 0 <= getattr(self, name) < np.inf:
                raise SlamlibError(f"Effects: {name} is a number, zero or more, got {getattr(self, name)}")
        if not (self.gain_time > 0 and int(self.exposures) == self.exposures >= 1):
            raise SlamlibError("Effects: gain_time is above zero, and exposures a whole number, 1 or more")
        if self.vignetting >= 1 or self.blur > WIDEST:
            raise SlamlibError(f"Effects: vignetting is below one, and blur at most {WIDEST} px")

    @property
    def moments(self) -> Array:
        """When the pictures of one exposure are taken, from the frame's time [s]; one alone if nothing is exposed."""
        count = int(self.exposures) if self.exposure else 1
        return ((np.arange(count) + 0.5) / count - 0.5) * self.exposure


# Light as it is, in whole grey values.
NO_EFFECTS = Effects(noise=0.0, gain=0.0, vignetting=0.0, blur=0.0)


class Chip:
    """A camera's lens and chip: from light (h, w), 0 to 255, to pictures (h, w) of whole grey values, uint8.

    Its gain is a stationary Gauss-Markov process, so that frames are like the ones before. Noise and gain have a
    generator each.
    """

    def __init__(
        self, effects: Effects, size: tuple[int, int], noise: np.random.Generator, gain: np.random.Generator
    ) -> None:
        self.effects, self.noise, self.rng = effects, noise, gain
        self.level = float(gain.standard_normal())
        self.falloff = falloff(size, effects.vignetting)

    def expose(self, light: Array, dt: float) -> Array:
        """The picture of this light, dt [s] after the one before."""
        kept = np.exp(-dt / self.effects.gain_time)
        self.level = float(kept * self.level + np.sqrt(1 - kept**2) * self.rng.standard_normal())
        values = blurred(light, self.effects.blur) * self.falloff * np.exp(self.effects.gain * self.level)
        values = values + self.effects.noise * self.noise.standard_normal(light.shape)
        return np.clip(np.rint(values), 0, 255).astype(np.uint8)


def falloff(size: tuple[int, int], lost: float) -> Array:
    """The share of light (h, w) that a lens lets through: 1 in the middle, 1 - lost in the corners.

    Between them it falls with the square of the radius.
    """
    v, u = (np.linspace(-1, 1, n) if n > 1 else np.zeros(1) for n in size)
    return 1 - lost * (u**2 + v[:, None] ** 2) / 2


def blurred(image: Image, std: float) -> Array:
    """The image (h, w), mixed with its neighbours along each axis by a kernel of three numbers, of variance std**2."""
    side = std**2 / 2
    for axis in (0, 1) if side else ():
        wide = np.pad(image, [(1, 1) if i == axis else (0, 0) for i in (0, 1)], mode="edge")
        before, after = (np.take(wide, np.arange(image.shape[axis]) + shift, axis) for shift in (0, 2))
        image = (1 - 2 * side) * image + side * (before + after)
    return image
