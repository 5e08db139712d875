"""EKF-SLAM, derived: the package whose formulas the book derives, proves and generates.

    import slamlib as sl
    result = sl.Run(sl.presets.points()).finish()

or the command `slamlib run points`. The filter is `sl.Slam`; `slamlib.records` has its inputs and outputs,
`slamlib.rigs` what it is made of. The formulas are in `geometry`, `motions`, `sensors` and `landmarks`, the Kalman
algebra in `belief` and `kalman`.

The names below are loaded when they are first used, and NumPy with the first of them: `import slamlib` alone loads
neither.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from slamlib.errors import MissingNameError, SlamlibError

if TYPE_CHECKING:  # for completion and types; HOMES says the same when the program runs
    from slamlib.belief import Belief as Belief
    from slamlib.checks import check_jacobian as check_jacobian
    from slamlib.codegen.derive import derive as derive
    from slamlib.evaluation.comparison import evaluate as evaluate
    from slamlib.evaluation.consistency import band as band
    from slamlib.evaluation.consistency import nees as nees
    from slamlib.evaluation.consistency import nis as nis
    from slamlib.experiments import presets as presets
    from slamlib.experiments.runs import Run as Run
    from slamlib.experiments.runs import run as run
    from slamlib.geometry import quaternion as quaternion
    from slamlib.geometry.pose import Pose as Pose
    from slamlib.geometry.pose2 import Pose2 as Pose2
    from slamlib.kalman.chi_square import chi2_quantile as chi2_quantile
    from slamlib.kalman.chi_square import chi2_sf as chi2_sf
    from slamlib.landmarks import LINES as LINES
    from slamlib.landmarks import POINTS as POINTS
    from slamlib.models import model as model
    from slamlib.motions import MOTIONS as MOTIONS
    from slamlib.rigs.builders import bearing_only as bearing_only
    from slamlib.rigs.builders import brown_conrady as brown_conrady
    from slamlib.rigs.builders import camera as camera
    from slamlib.rigs.builders import davison as davison
    from slamlib.rigs.builders import depth_camera as depth_camera
    from slamlib.rigs.builders import double_sphere as double_sphere
    from slamlib.rigs.builders import extended_unified as extended_unified
    from slamlib.rigs.builders import fisheye as fisheye
    from slamlib.rigs.builders import omnidirectional as omnidirectional
    from slamlib.rigs.builders import range_bearing as range_bearing
    from slamlib.rigs.builders import range_only as range_only
    from slamlib.rigs.builders import relative_position as relative_position
    from slamlib.rigs.builders import robot as robot
    from slamlib.rigs.builders import stereo as stereo
    from slamlib.rigs.builders import unified as unified
    from slamlib.rigs.setup import Rig as Rig
    from slamlib.rigs.setup import RobotSetup as RobotSetup
    from slamlib.rigs.setup import SensorSetup as SensorSetup
    from slamlib.sensors import SENSORS as SENSORS
    from slamlib.slam import Options as Options
    from slamlib.slam import Slam as Slam

__version__ = "0.1.0"
__all__ = ["SlamlibError", "__version__"]

HOMES = {  # of each name the module that has it, or that is it
    "Belief": "belief",
    "LINES": "landmarks",
    "MOTIONS": "motions",
    "Options": "slam",
    "POINTS": "landmarks",
    "Pose": "geometry.pose",
    "Pose2": "geometry.pose2",
    "Rig": "rigs.setup",
    "RobotSetup": "rigs.setup",
    "Run": "experiments.runs",
    "SENSORS": "sensors",
    "SensorSetup": "rigs.setup",
    "Slam": "slam",
    "band": "evaluation.consistency",
    "bearing_only": "rigs.builders",
    "brown_conrady": "rigs.builders",
    "camera": "rigs.builders",
    "check_jacobian": "checks",
    "chi2_quantile": "kalman.chi_square",
    "chi2_sf": "kalman.chi_square",
    "davison": "rigs.builders",
    "depth_camera": "rigs.builders",
    "derive": "codegen",
    "double_sphere": "rigs.builders",
    "evaluate": "evaluation.comparison",
    "extended_unified": "rigs.builders",
    "fisheye": "rigs.builders",
    "model": "models",
    "nees": "evaluation.consistency",
    "nis": "evaluation.consistency",
    "omnidirectional": "rigs.builders",
    "presets": "experiments.presets",
    "quaternion": "geometry.quaternion",
    "range_bearing": "rigs.builders",
    "range_only": "rigs.builders",
    "relative_position": "rigs.builders",
    "robot": "rigs.builders",
    "run": "experiments.runs",
    "stereo": "rigs.builders",
    "unified": "rigs.builders",
}


def __getattr__(name: str) -> Any:
    """Load a name when it is first used; raises MissingNameError, an AttributeError, where it cannot be had."""
    if name.startswith("_"):  # what Python itself looks up
        raise MissingNameError(f"slamlib has no {name}")
    if name not in HOMES:
        raise MissingNameError.of("name in slamlib", name, HOMES)
    try:
        module = import_module(f"slamlib.{HOMES[name]}")
    except ModuleNotFoundError as error:
        raise MissingNameError(f"slamlib.{name} needs {error.name}: pip install 'slamlib[derive]'") from error
    globals()[name] = found = module if module.__name__.endswith(f".{name}") else getattr(module, name)
    return found


def __dir__() -> list[str]:
    """What a completion shows, loaded or not."""
    return sorted({*__all__, *HOMES})
