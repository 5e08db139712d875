"""EKF-SLAM, derived: the package whose formulas the book derives, proves and generates.

Importing slamlib loads NumPy and nothing else; sympy and scipy are loaded by the parts that use them.
"""

import importlib
from types import ModuleType

from slamlib.errors import SlamlibError

__version__ = "0.1.0"
__all__ = ["SlamlibError", "__version__"]

_PARTS = (
    *("analytic", "belief", "checks", "codegen", "correction", "drawing", "errors", "evaluation", "exercises"),
    *("geometry", "implicit", "landmarks", "line_observation", "linalg", "model", "motions", "observation"),
    *("registry", "sensors", "spaces"),
)


def __getattr__(name: str) -> ModuleType:
    """Load a part of the package when it is first named, so that `import slamlib` stays quick."""
    if name in _PARTS:
        return importlib.import_module(f"slamlib.{name}")
    raise AttributeError(f"slamlib has no part {name!r}; it has {', '.join(_PARTS)}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_PARTS})
