"""Setups of robots and sensors: what is not given fits the type of the sensor, and plain data comes back as it was."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.rigs.setup import IMAGE, PARAMETERS, Rig, RobotSetup, SensorSetup
from slamlib.sensors import SENSORS


@pytest.mark.parametrize("name", SENSORS)
def test_what_is_not_given_fits_the_type(name):
    setup, kind = SensorSetup(type=name), SENSORS[name]
    assert (setup.image == IMAGE) == kind.pixels
    try:
        assert setup.calibration.sensor is kind
    except SlamlibError as error:  # a number that no lens of this type has by default
        assert re.match(f"{name}: (the calibration lacks intrinsics|distortion is )", str(error))
        assert not set(kind.parameters) <= set(PARAMETERS) or "distortion is" in str(error)


@pytest.mark.parametrize("name", [n for n, s in SENSORS.items() if s.pixels])
def test_a_camera_without_a_border_stays_one(name):
    open_one = SensorSetup(type=name, image=None)
    assert open_one.image is None
    assert replace(open_one, name="other").image is None


def test_an_image_is_refused_where_nothing_is_measured_in_pixels():
    with pytest.raises(SlamlibError, match="rangeBearing: its measurements are no pixels"):
        _ = SensorSetup(type="rangeBearing", image=(640.0, 480.0)).calibration


def test_a_type_that_is_not_there_is_reported_at_once():
    with pytest.raises(UnknownNameError, match="pinHole"):
        SensorSetup(type="pinhole")


@pytest.mark.parametrize("image", [None, (320.0, 240.0)])
def test_a_rig_comes_back_from_its_plain_data(image):
    sensors = (SensorSetup("a", image=image), SensorSetup("b", type="relativePosition", std=(0.1,)), SensorSetup("c"))
    rig = Rig((RobotSetup(),), sensors)
    again = Rig.from_dict(json.loads(json.dumps(rig.to_dict())))
    assert again == rig
    assert [s.image for s in again.sensors] == [image, None, IMAGE]
    assert np.array_equal(again.sensors[2].calibration.image, IMAGE)
