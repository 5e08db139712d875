"""What the front end keeps of a landmark: how it looked, from a few distances."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from slamlib.manifolds import Array


@dataclass(frozen=True, eq=False)
class View:
    """Descriptor (32,), patch (s, s) round the left pixel, its margin of one included, and disparity [px]."""

    descriptor: Array
    patch: Array
    disparity: float

    def zoom(self, disparity: float) -> float:
        """How much larger or smaller it looks at another disparity, 1 or more: its distance changed by as much."""
        ratio = disparity / self.disparity
        return max(ratio, 1 / ratio) if ratio > 0 else np.inf


@dataclass(frozen=True, eq=False)
class Views:
    """All views of a landmark, the first one first. The first is never given up, so that a chain does not drift."""

    all: tuple[View, ...]

    def nearest(self, disparity: float) -> View:
        """The one whose distance is most like that of a disparity [px]; of equals the oldest."""
        return min(self.all, key=lambda view: view.zoom(disparity))

    def with_view(self, view: View, most: int) -> "Views":
        """With one more; of more than `most`, the oldest but the first goes."""
        first, rest = self.all[:1], (*self.all[1:], view)
        return Views(first + rest[-(most - 1) :] if most > 1 else first)

    def pack(self) -> Any:
        """Plain data, for JSON: nothing is lost."""
        return [[v.descriptor.tolist(), v.patch.tolist(), v.disparity] for v in self.all]

    @classmethod
    def unpack(cls, packed: Any) -> "Views":
        """What `pack` packed."""
        return cls(tuple(View(np.array(d, np.uint8), np.array(p, float), float(z)) for d, p, z in packed))
