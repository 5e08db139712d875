"""EKF-SLAM, derived: the package whose formulas the book derives, proves and generates.

To begin: `slamlib.runs.Run(slamlib.presets.points()).finish()`, or the command `slamlib run points`. The filter is
`slamlib.slam.Slam`; what it is built of is in `slamlib.rig`, what it takes in `records`, what it shows in `snapshots`.
The formulas are in `geometry`, `motions`, `sensors` and `landmarks`, the Kalman algebra in `belief`.

Importing slamlib loads NumPy and nothing else; sympy and scipy are loaded by the parts that use them.
"""

import importlib
from types import ModuleType

from slamlib.errors import SlamlibError

__version__ = "0.1.0"
__all__ = ["SlamlibError", "__version__"]

_PARTS = (
    *("analytic", "association", "belief", "blocks", "checks", "cli", "codegen"),
    *("correction", "digest", "drawing", "errors", "evaluation", "exercises", "experiments", "files"),
    *("geometry", "implicit", "kernel", "landmarks", "linalg", "line_observation", "model"),
    *("motions", "observation", "presets", "progress", "records", "registry", "rig"),
    *("runs", "scene", "sensors", "series", "shortened", "simulation", "slam"),
    *("snapshots", "spaces", "tangle"),
)


def __getattr__(name: str) -> ModuleType:
    """Load a part of the package when it is first named, so that `import slamlib` stays quick."""
    if name in _PARTS:
        return importlib.import_module(f"slamlib.{name}")
    raise AttributeError(f"slamlib has no part {name!r}; it has {', '.join(_PARTS)}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_PARTS})
