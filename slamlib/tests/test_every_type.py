"""Every landmark, sensor and motion of the package, found by walking its folders, passes the package's own checks.

No type is named here. A sensor is checked with plausible values of its parameters: those of its own file, if that holds
a Calibration of it, else those of the table below.
"""

import importlib
import itertools
import pkgutil

import numpy as np
import pytest

import slamlib.sensors
from slamlib.checks import check_landmark, check_motion, check_pair, check_sensor
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import MOTIONS
from slamlib.observation.points import initialize
from slamlib.sensors import SENSORS, Calibration
from slamlib.tests.line_chains import check_chains

DEFAULTS = {  # by a parameter's name and by how many numbers its model takes
    ("intrinsics", 4): [320.0, 240.0, 400.0, 410.0],
    ("intrinsics", 5): [320.0, 240.0, 1.01, 0.003, -0.002],
    ("distortion", 8): [-0.2, 0.04, 0.001, 0.002],
    ("distortion", 1): [0.2],
    ("distortion", 2): [0.5, 0.7],  # of the extended unified camera, and of the double sphere
    ("distortion", 6): [1.2, -0.1, 0.02, 0.001, -0.002],
    ("lens", 11): [170.0, -3.0, 0.5],
    ("baseline", 1): [0.3],
}


def example(sensor):
    """A calibration of a sensor: the one in its own file, or one made of the table."""
    for info in pkgutil.iter_modules(slamlib.sensors.__path__):
        module = importlib.import_module(f"slamlib.sensors.{info.name}")
        for value in vars(module).values():
            if isinstance(value, Calibration) and value.sensor is sensor:
                return value
    sizes = {a.name: a.size for a in sensor.project.arguments}
    missing = [n for n in sensor.parameters if (n, sizes[n]) not in DEFAULTS]
    assert not missing, f"no plausible {missing}: put a Calibration of {sensor.name} into its file"
    root = np.diag(np.full(sensor.size, 0.5)) + 0.1  # full, not diagonal
    image = (640, 480) if sensor.pixels else None
    parameters = {n: DEFAULTS[n, sizes[n]] for n in sensor.parameters}
    return Calibration(sensor, root @ root.T, image=image, **parameters)


@pytest.mark.parametrize("name", [*POINTS, *LINES])
def test_every_landmark_passes_the_checks(name, capsys):
    check_landmark({**POINTS, **LINES}[name])
    assert "properties hold." in capsys.readouterr().out


@pytest.mark.parametrize("name", list(SENSORS))
def test_every_sensor_passes_the_checks(name, capsys):
    check_sensor(example(SENSORS[name]))
    assert "properties hold." in capsys.readouterr().out


@pytest.mark.parametrize("name", list(MOTIONS))
def test_every_motion_passes_the_checks(name, capsys):
    check_motion(MOTIONS[name])
    assert "properties hold." in capsys.readouterr().out


@pytest.mark.parametrize(("kind", "sensor"), list(itertools.product([*POINTS, *LINES], SENSORS)))
def test_every_pair_initializes_observes_and_updates(kind, sensor, capsys):
    check_pair({**POINTS, **LINES}[kind], example(SENSORS[sensor]))
    assert capsys.readouterr().out.endswith(("properties hold.\n", "the property holds.\n"))


@pytest.mark.parametrize(
    ("kind", "sensor"), list(itertools.product(LINES, [name for name, s in SENSORS.items() if s.project_line]))
)
def test_every_chain_of_lines_has_the_derivatives_of_its_formulas(kind, sensor):
    check_chains(LINES[kind], example(SENSORS[sensor]))


@pytest.mark.parametrize("name", list(SENSORS))
def test_an_image_bounds_pixels_and_is_refused_where_there_are_none(name):
    known = example(SENSORS[name])
    given = {"limits": known.limits, **known.given}
    if not known.sensor.pixels:
        assert known.image is None
        with pytest.raises(SlamlibError, match=rf"{name}: its measurements are no pixels.* limits .*pixels=True"):
            Calibration(known.sensor, known.noise, image=(640, 480), **given)
        return
    camera = Calibration(known.sensor, known.noise, image=(640, 480), **given)
    inner = np.full((4, camera.sensor.size), 10.0)
    inner[:, :2] = [[0.0, 0.0], [640.0, 480.0], [641.0, 10.0], [10.0, -1.0]]
    assert camera.inside(inner).tolist() == [True, True, False, False]


def test_the_folders_are_not_empty_and_every_type_has_partners():
    assert len(POINTS) >= 5
    assert len(SENSORS) >= 1
    for plane in (False, True):
        points = [kind for kind in POINTS.values() if kind.plane == plane]
        sensors = [example(sensor) for sensor in SENSORS.values() if sensor.plane == plane]
        exists = np.array([[check_pair(kind, sensor, silent=True) for sensor in sensors] for kind in points])
        assert exists.sum(0).min() >= len(points) - 1, "a sensor has partners among nearly all the points of its world"
        assert exists.any(1).all(), "every point is seen by some sensor"


def test_a_sensor_of_the_plane_and_a_point_in_space_make_no_landmark():
    for kind, sensor in itertools.product(POINTS.values(), SENSORS.values()):
        if kind.plane != sensor.plane:
            calibration = example(sensor)
            assert not check_pair(kind, calibration, silent=True)
            wanted = "measures no height" if sensor.plane else "lies on the floor"
            with pytest.raises(SlamlibError, match=wanted):
                initialize(kind, calibration, ORIGIN, ORIGIN, np.ones(sensor.size), *[np.ones(1)] * sensor.unmeasured)


def test_every_line_is_seen_by_the_sensors_with_images_of_lines_and_by_no_other():
    cameras = [sensor.project_line is not None for sensor in SENSORS.values()]
    assert len(LINES) >= 5
    assert any(cameras)
    for kind in LINES.values():
        assert [check_pair(kind, example(sensor), silent=True) for sensor in SENSORS.values()] == cameras
