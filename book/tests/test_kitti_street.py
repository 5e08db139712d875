"""KITTI's street is found as it is offered, and as an excerpt; where it is not, what is wanted is said."""

import numpy as np
import pytest
from slambook import kitti_street

from book.experiments import street
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import inverse, relative

FOCAL, BASELINE, DISPARITY = 100.0, 0.5, 4  # px, m, px
LENS = f"{FOCAL} 0 80 {{}} 0 {FOCAL} 60 0 0 0 1 0"
LEFT, RIGHT = LENS.format(0), LENS.format(-FOCAL * BASELINE)
OFFERED = ("sequences/06/image_0", "sequences/06/image_1", "sequences/06/calib.txt", "poses/06.txt")
EXCERPT = ("image_l", "image_r", "calib.txt", "poses.txt")
COLOURED = "\n".join(f"P{i}: 900 0 80 {-i} 0 900 60 0 0 0 1 0" for i in (2, 3))


def made_up(root, place, names, calibration, count):
    """A folder of pairs, four pixels apart and brighter from pair to pair, and a straight path of a metre a pair."""
    cv2 = pytest.importorskip("cv2", reason="OpenCV writes and reads the pictures")
    left, right, calib, poses = (root / place / name for name in names)
    wide = np.random.default_rng(1).integers(0, 100, (120, 160 + DISPARITY)).astype(np.uint8)
    wide = cv2.GaussianBlur(wide, (0, 0), 1.5) * np.uint8(2)
    for folder in (left, right, poses.parent):
        folder.mkdir(parents=True, exist_ok=True)
    for i in range(count):
        for folder, picture in ((left, wide[:, :-DISPARITY]), (right, wide[:, DISPARITY:])):
            cv2.imwrite(str(folder / f"{i:06d}.png"), picture + np.uint8(i % 50))
    (left.parent / "times.txt").write_text("".join(f"{0.104 * i:.6e}\n" for i in range(count)))
    calib.write_text(calibration)
    poses.write_text("".join(f"1 0 0 0 0 1 0 0 0 0 1 {i}\n" for i in range(count)))


@pytest.fixture(params=["as it is offered", "an excerpt"])
def root(request, tmp_path):
    if request.param == "an excerpt":
        made_up(tmp_path, "stereo_kitti_a", EXCERPT, f"{LEFT}\n{RIGHT}\n", kitti_street.PAIRS)
    else:
        calibration = f"P0: {LEFT}\nP1: {RIGHT}\n{COLOURED}\n"
        made_up(tmp_path, "dataset", OFFERED, calibration, kitti_street.PAIRS + 4)
    return tmp_path


def test_the_pairs_their_camera_and_the_path_are_those_of_the_first_frames(root, monkeypatch):
    monkeypatch.setattr(kitti_street, "DATA", root)
    source, camera, truth = street.street()
    assert len(source) == len(truth) == kitti_street.PAIRS == 51
    assert camera["parameters"]["baseline"] == pytest.approx([BASELINE])
    assert truth.distances[-1] == 50
    assert truth.times == pytest.approx(np.arange(51) / 10)
    assert relative(truth.poses[0], truth.poses[-1])[2] == 50  # ahead
    assert inverse(truth.poses[0])[:3] == pytest.approx(0)


def test_plain_odometry_has_the_same_pairs(root):
    calibration, images, truth = kitti_street.pairs(root=root)
    assert (len(images), images[0].shape, len(truth)) == (51, (2, 120, 160), 51)
    assert np.mean(images[50]) - np.mean(images[0]) == pytest.approx(0, abs=1e-9)  # 50 is as bright as 0, and 49 is not
    assert np.mean(images[49]) - np.mean(images[0]) == pytest.approx(49)
    assert calibration.given["baseline"] == pytest.approx([BASELINE])
    assert np.diag(calibration.noise) == pytest.approx(0.2**2)
    left, right = images[0].astype(float)
    assert (left[:, DISPARITY:] == right[:, :-DISPARITY]).all()  # what is at u on the left is at u - d on the right


def test_a_sequence_without_its_last_pair_or_its_path_is_not_the_street(root):
    assert kitti_street.found(root) is not None
    (there,) = (file for file in root.rglob("*.txt") if file.name in {"06.txt", "poses.txt"})
    there.unlink()
    assert kitti_street.found(root) is None


def test_where_it_is_not_at_hand_the_command_says_what_is_wanted(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(kitti_street, "DATA", tmp_path)
    monkeypatch.setattr("sys.argv", ["street"])
    assert street.main() == 2
    said = capsys.readouterr().err
    for what in ("frames 0 to 50 of sequence 06", "SLAMLIB_DATA", "slamlib datasets kitti-odometry"):
        assert what in said
    assert all(f"dataset/{name}" in said for name in OFFERED)
    with pytest.raises(SlamlibError, match="sequence 06"):
        kitti_street.pairs(root=tmp_path)
