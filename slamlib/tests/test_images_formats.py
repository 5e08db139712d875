"""Calibrations of BoofCV, camodocal, DSO, MRPT, KITTI's raw data, and ROS's pairs: as these tools write them."""

import re

import numpy as np
import pytest

from slamlib.datasets.calibrations import read_lens, read_pair
from slamlib.datasets.lens import Lens
from slamlib.errors import SlamlibError

yaml = pytest.importorskip("yaml", reason="PyYAML reads the calibrations in YAML")


def write(folder, text, name="calibration"):
    (folder / name).write_text(text)
    return folder / name


PINHOLE = {"fx": 262.3, "fy": 263.4, "cx": 156.2, "cy": 123.7, "width": 320, "height": 240, "skew": 0.0}
BENT = {"radial": [-0.36, 0.17], "t1": 1e-3, "t2": 2e-3}
BOOFCV = {"model": "pinhole_radial_tangential", "version": 0, "pinhole": PINHOLE, "radial_tangential": BENT}
TO_LEFT = {"rotation": [0, -1, 0, 1, 0, 0, 0, 0, 1], "x": 0.12, "y": 9e-4, "z": -9e-4}


def test_boofcv(tmp_path):
    lens = Lens((156.2, 123.7, 262.3, 263.4), (320, 240), distortion=(-0.36, 0.17, 1e-3, 2e-3, 0))
    assert read_lens(write(tmp_path, yaml.dump(BOOFCV))) == lens
    stereo = {"model": "stereo_camera", "left": BOOFCV, "right": BOOFCV, "rightToLeft": TO_LEFT}
    pair = read_pair([write(tmp_path, yaml.dump(stereo))])
    assert (pair.left.intrinsics, pair.right.distortion) == (lens.intrinsics, lens.distortion)
    np.testing.assert_allclose(pair.transform[:3, 3], [0.12, 9e-4, -9e-4])
    np.testing.assert_array_equal(pair.transform[:3, :3], np.reshape(TO_LEFT["rotation"], (3, 3)))
    omni = {**BOOFCV, "model": "omnidirectional_universal", "mirror_offset": 1.1}
    found = read_lens(write(tmp_path, yaml.dump(omni)))
    assert (found.model, found.distortion) == ("unified", (1.1, -0.36, 0.17, 1e-3, 2e-3, 0))
    for change, message in (
        ({"mirror_ofset": 1.1}, "mirror_ofset is not known"),
        ({"pinhole": {**PINHOLE, "skew": 2.0}}, "skewed by 2 px"),
        ({"model": "kannala_brandt"}, "unknown model of BoofCV 'kannala_brandt'"),
        ({"radial_tangential": {**BENT, "t3": 0.1}}, r"radial_tangential\.t3 is not known"),
        ({"radial_tangential": {**BENT, "radial": [0.1] * 4}}, "more than three"),
    ):
        with pytest.raises(SlamlibError, match=message):
            read_lens(write(tmp_path, yaml.dump({**BOOFCV, **change})))


CAMODOCAL = """%YAML:1.0
---
model_type: {}
camera_name: camera
image_width: 752
image_height: 480
{}"""
MIRROR = "mirror_parameters:\n   xi: 1.6\n"
BENDING = "distortion_parameters:\n   k1: -2.9e-01\n   k2:0.1\n   p1: 1.e-3\n   p2: 0\n"
PLANE = "projection_parameters:\n   {}: 461.6\n   {}: 460.3\n   {}: 363.0\n   {}: 248.1\n"


@pytest.mark.parametrize(
    ("kind", "text", "model", "distortion"),
    [
        ("PINHOLE", BENDING + PLANE.format("fx", "fy", "cx", "cy"), "radial-tangential", (-0.29, 0.1, 1e-3, 0)),
        ("MEI", MIRROR + BENDING + PLANE.format("gamma1", "gamma2", "u0", "v0"), "unified", (1.6, -0.29, 0.1, 1e-3, 0)),
        (
            "KANNALA_BRANDT",
            PLANE.format("mu", "mv", "u0", "v0") + "   k2: 0.1\n   k3: -0.2\n   k4: 0.3\n   k5: 0.4\n",
            "equidistant",
            (0.1, -0.2, 0.3, 0.4),
        ),
    ],
)
def test_camodocal(tmp_path, kind, text, model, distortion):
    text = CAMODOCAL.format(kind, text)
    assert read_lens(write(tmp_path, text)) == Lens((363, 248.1, 461.6, 460.3), (752, 480), model, distortion)
    for old, new, message in (
        (kind, "SCARAMUZZA", "unknown model_type of camodocal 'SCARAMUZZA'"),
        ("k2:", "r2:", "k2 is missing"),
        ("projection_parameters:\n", "projection_parameters:\n   k9: 1\n", "k9 is not known"),
        ("image_height", "image_hight", "image_height is missing: is 'image_hight' meant"),
    ):
        with pytest.raises(SlamlibError, match=message):
            read_lens(write(tmp_path, text.replace(old, new)))


@pytest.mark.parametrize(
    ("row", "model", "coefficients"),
    [
        ("Pinhole 0.5 0.6 0.4 0.45 0", "radial-tangential", (0,)),
        ("0.5 0.6 0.4 0.45 0", "radial-tangential", (0,)),
        ("FOV 0.5 0.6 0.4 0.45 0.93", "fov", (0.93,)),
        ("0.5 0.6 0.4 0.45 0.93", "fov", (0.93,)),
        ("ATAN 0.5 0.6 0.4 0.45 0.93", "fov", (0.93,)),
        ("RadTan 0.5 0.6 0.4 0.45 -0.2 0.1 1e-3 0", "radial-tangential", (-0.2, 0.1, 1e-3, 0)),
        ("0.5 0.6 0.4 0.45 -0.2 0.1 1e-3 0", "radial-tangential", (-0.2, 0.1, 1e-3, 0)),
        ("EquiDistant 0.5 0.6 0.4 0.45 -0.2 0.1 1e-3 0", "equidistant", (-0.2, 0.1, 1e-3, 0)),
        ("KannalaBrandt 0.5 0.6 0.4 0.45 -0.2 0.1 1e-3 0", "equidistant", (-0.2, 0.1, 1e-3, 0)),
    ],
)
@pytest.mark.parametrize("output", ["crop", "full", "none", "0.6 0.6 0.5 0.5 0"])
def test_dso(tmp_path, row, model, coefficients, output):
    """Relative to the size, its pixels have their centres at halves; in pixels they are as slamlib's."""
    rest = f"\n1280 1024\n{output}\n1280 1024\n"
    expected = Lens((511.5, 460.3, 640, 614.4), (1280, 1024), model, coefficients)
    found = read_lens(write(tmp_path, row + rest))
    np.testing.assert_allclose(found.intrinsics, expected.intrinsics)
    assert (found.image, found.model, found.distortion) == (expected.image, model, coefficients)
    in_pixels = row.replace("0.5 0.6 0.4 0.45", "640 614.4 511.5 460.3", 1)
    np.testing.assert_allclose(read_lens(write(tmp_path, in_pixels + rest)).intrinsics, expected.intrinsics)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("FOV 0.3 0.4 0.5 0.5\n640 480\ncrop\n640 480\n", "parameters of FOV are 5 numbers, got '0.3 0.4 0.5 0.5'"),
        ("FOV 0.3 0.4 0.5 0.5 x\n640 480\ncrop\n640 480\n", "parameters of FOV are 5 numbers"),
        ("Pinhole 500 500 320 240 0\n640 480\nnone\n640 480\n0.12\n", "there is another one: '0.12'"),
        ("Pinhole 500 500 320 240 0.9\n640 480\nnone\n640 480\n", "a Pinhole has no distortion"),
        ("Pinhole 500 500 320 240 0\n640\nnone\n640 480\n", "width and height are 2 numbers"),
    ],
)
def test_what_dso_would_not_read_either(tmp_path, text, message):
    with pytest.raises(SlamlibError, match=message):
        read_lens(write(tmp_path, text))


MRPT = """# Stereo camera calibration report
[CAMERA_PARAMS_LEFT]
resolution = [1024 768]
cx         = 523.098
cy         = 402.599
fx         = 839.161  // +/- 0.1
fy         = 841.168
dist       = [-3.747584e-001 2.468493e-001 0.000000e+000 1.000000e-003 -1.281381e-001]  // [K1 K2 T1 T2 K3]

[CAMERA_PARAMS_RIGHT]
resolution = [1024 768]
cx         = 511.173
cy         = 388.440
fx         = 836.761
fy         = 838.133
dist       = [-3.606276e-001 2.116929e-001 0.000000e+000 0.000000e+000 -9.216787e-002]

[CAMERA_PARAMS_LEFT2RIGHT_POSE]
translation_only     = [1.193203e-001 -3.361637e-004 3.729054e-004]
rotation_matrix_only = [0.99975 -0.0062 -0.0031 ;0.0062 0.99998 0.00065 ;0.0031 -0.00067 0.999995 ]
pose_quaternion      = [0.119320 -0.000336 0.000373 0.999994 -0.000329 -0.001567 0.003142]
[CALIB_METAINFO]
number_good_cheesboards = 40
"""


def test_mrpt(tmp_path):
    path = write(tmp_path, MRPT)
    left = Lens((523.098, 402.599, 839.161, 841.168), (1024, 768),
                distortion=(-0.3747584, 0.2468493, 0, 1e-3, -0.1281381))  # fmt: skip
    pair = read_pair([path])
    assert (pair.left.intrinsics, pair.left.distortion) == (left.intrinsics, left.distortion)
    assert pair.right.intrinsics[0] == 511.173
    np.testing.assert_allclose(pair.transform[:3, 3], [0.11932, -0.000336, 0.000373], atol=1e-9)
    np.testing.assert_allclose(pair.transform[0, :3], [0.99998, -0.006283, -0.003137], atol=1e-5)
    alone = MRPT.partition("[CAMERA_PARAMS_RIGHT")[0].replace("_LEFT", "")
    assert read_lens(write(tmp_path, alone)) == left
    with pytest.raises(SlamlibError, match=r"CAMERA_PARAMS\.dst is not known.* did you mean 'dist'"):
        read_lens(write(tmp_path, alone.replace("dist ", "dst ")))
    with pytest.raises(SlamlibError, match="cy is missing"):
        read_lens(write(tmp_path, alone.replace("cy ", "c0 ")))


RAW = """calib_time: 09-Jan-2012 13:57:47
corner_dist: 9.950000e-02
S_00: 1.392e+03 5.12e+02
K_00: 9.842e+02 0 6.9e+02 0 9.808e+02 2.331e+02 0 0 1
D_00: -3.728e-01 2.037e-01 2.219e-03 1.383e-03 -7.233e-02
R_00: 1 0 0 0 1 0 0 0 1
T_00: 2.573e-16 -1.059e-16 1.614e-16
S_rect_00: 1.242e+03 3.75e+02
R_rect_00: 1 0 0 0 1 0 0 0 1
P_rect_00: 7.215377e+02 0 6.095593e+02 0 0 7.215377e+02 1.72854e+02 0 0 0 1 0
"""


def test_kittis_raw_data(tmp_path):
    """The pictures that are there are rectified: K, D, R and T are of others."""
    other = RAW[RAW.index("S_00") :].replace("_00", "_01").replace("6.095593e+02 0", "6.095593e+02 -3.875744e+02")
    path = write(tmp_path, RAW + other)
    pair = read_pair([path])
    assert (pair.left.image, pair.left.distortion) == ((1242, 375), ())
    assert pair.left.intrinsics == (609.5593, 172.854, 721.5377, 721.5377)
    assert pair.transform[0, 3] == pytest.approx(0.53715, abs=1e-5)
    with pytest.raises(SlamlibError, match="no camera 2, but 0, 1"):
        read_lens(path, 2)
    with pytest.raises(SlamlibError, match="Q_00 is not known"):
        read_lens(write(tmp_path, RAW.replace("K_00", "Q_00")))


ROS = """image_width: 640
image_height: 480
camera_name: left
camera_matrix:
  rows: 3
  cols: 3
  data: [500, 0, 320, 0, 500, 240, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.1, 0.2, 0, 0, 0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]
projection_matrix:
  rows: 3
  cols: 4
  data: [400, 0, 320, 0, 0, 400, 240, 0, 0, 0, 1, 0]
"""


def test_ros_calibrates_a_pair_in_two_files(tmp_path):
    """Its R turn both cameras to their common, rectified axes; its P of the right one has -fx times the baseline."""
    turn = np.array([[0.8, 0, -0.6], [0, 1, 0], [0.6, 0, 0.8]])
    right = ROS.replace("[1, 0, 0, 0, 1, 0, 0, 0, 1]", str(turn.ravel().tolist())).replace(
        "320, 0, 0, 400", "320, -60, 0, 400"
    )
    pair = read_pair([write(tmp_path, ROS, "left"), write(tmp_path, right, "right")])
    np.testing.assert_allclose(pair.transform[:3, 3], [0.15, 0, 0])
    np.testing.assert_allclose(turn @ pair.transform[:3, :3].T, np.eye(3), atol=1e-12)
    with pytest.raises(SlamlibError, match="both cameras have the same position"):
        read_pair([write(tmp_path, ROS)])
    assert read_lens(write(tmp_path, re.sub(r"rectification(.|\n)*", "", ROS))).transform is None
