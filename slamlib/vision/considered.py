"""The calibration's parameters as considered ones: what their errors may have done to a path. Eq. (se-considered).

A filter takes its calibration for exact, and an error of it is in every picture. The run is repeated with each number
one standard deviation off, and how far the path moves joins its covariances (Trajectory.considering). The gains stay as
they are. No derivative is needed, whatever the sensor.
"""

from typing import Any

import numpy as np

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.vision.sequence_run import SequenceRun

OFFSET = "offset"  # of the disparities: a setting of the stereo front end
Errors = dict[str, tuple[float, ...]]  # of a calibration's parameters, by name
Singles = dict[str, Errors]  # by a label, one number alone


def single_errors(stds: Errors, run: SequenceRun) -> Singles:
    """The standard deviation of each number alone, by a label.

    stds: by a parameter of the run's calibration, one for all of its numbers or one for each; OFFSET [px] too, of
    pairs. Raises SlamlibError for others.
    """
    sizes = {name: len(numbers) for name, numbers in run.slam.sensors[0].calibration.given.items()}
    if hasattr(getattr(run.slam.front_ends[0], "settings", None), OFFSET):
        sizes[OFFSET] = 1
    found = {}
    for name, given in stds.items():
        if name not in sizes:
            raise UnknownNameError.of("parameter of this calibration", name, sizes)
        if len(given) not in (1, sizes[name]):
            raise SlamlibError(f"{name} has {sizes[name]} numbers: as many standard deviations are wanted, or one")
        for i, row in enumerate(np.diag(np.broadcast_to(given, sizes[name]))):
            if row.any():
                found[f"{name}[{i}]"] = {name: tuple(row.tolist())}
    return found


def erroneous(camera: dict[str, Any], errors: Errors) -> dict[str, Any]:
    """A camera (plain data of a SensorSetup) whose parameters are larger by the errors; OFFSET is none of them."""
    parameters = dict(camera["parameters"])
    for name in parameters.keys() & errors.keys():
        parameters[name] = tuple(np.add(parameters[name], errors[name]).tolist())
    return {**camera, "parameters": parameters}
