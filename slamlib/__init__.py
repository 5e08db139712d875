"""EKF-SLAM, derived: the package whose formulas the book derives, proves and generates.

To start: `Run(presets.points()).finish()`, with `from slamlib.experiments import presets` and `from
slamlib.experiments.runs import Run`; or the command `slamlib run points`. The filter is `slamlib.slam.Slam`; `data`
has its inputs, its outputs and its setup. The formulas are in `geometry`, `motions`, `sensors` and `landmarks`, the
Kalman algebra in `belief` and `kalman`.

Importing slamlib loads NumPy and nothing else; sympy and scipy are loaded by the parts that use them.
"""

from slamlib.errors import SlamlibError

__version__ = "0.1.0"
__all__ = ["SlamlibError", "__version__"]
