"""Make the report's experiments' measurements of a chessboard anew, from OpenCV's own sample pictures.

The pictures are left01.jpg, right01.jpg and so on of the samples that come with OpenCV (Apache 2.0); with Debian:
`apt-get download opencv-doc && dpkg -x opencv-doc_*.deb .`, then usr/share/doc/opencv-doc/examples/data. The pairs of
odd numbers calibrate the two cameras, those of even numbers are measured.
"""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from book.tools.layout import ROOT
from slamlib.datasets.pictures import opencv
from slamlib.errors import SlamlibError
from slamlib.manifolds import Array
from slamlib.plain_data.files import write_whole

cv2: Any = opencv("to measure a chessboard")
STORED = ROOT / "book" / "chapters" / "data" / "stereo_board.csv"
COLUMNS, ROWS, SQUARE = 9, 6, 25.0  # inner corners; [mm]
SIZE = (640, 480)
NUMBERS = [n for n in range(1, 15) if n != 10]  # there is no pair 10


def corners_of(file: Path) -> Array:
    """Inner corners (54, 2) [px] of the board in a picture, to a fraction of a pixel. Raises SlamlibError."""
    image = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
    if image is None:
        raise SlamlibError(f"{file} is no picture: give the folder of OpenCV's samples (see --help)")
    found, corners = cv2.findChessboardCorners(image, (COLUMNS, ROWS))
    if not found:
        raise SlamlibError(f"{file}: no chessboard of {COLUMNS} by {ROWS} inner corners is found")
    stop = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
    return np.asarray(cv2.cornerSubPix(image, corners, (5, 5), (-1, -1), stop)).reshape(-1, 2)


def pair(folder: Path, number: int) -> tuple[Array, Array]:
    """The corners of a pair, in the same order in both pictures."""
    left, right = (corners_of(folder / f"{side}{number:02d}.jpg") for side in ("left", "right"))
    same_way = (left[-1] - left[0]) @ (right[-1] - right[0]) > 0
    return left, right if same_way else right[::-1].copy()


def calibrated(pairs: Sequence[tuple[Array, Array]]) -> tuple[float, Any, Any]:
    """Residual [px], and for each camera its lens and what turns it into one of a rectified pair: (K, d, R, P)."""
    board = np.zeros((COLUMNS * ROWS, 3), np.float32)
    board[:, :2] = np.mgrid[:COLUMNS, :ROWS].T.reshape(-1, 2) * SQUARE
    boards, seen = [board] * len(pairs), [[p[i][:, None] for p in pairs] for i in (0, 1)]
    lenses = [cv2.calibrateCamera(boards, s, SIZE, None, None)[1:3] for s in seen]
    residual, K1, d1, K2, d2, R, t, *_ = cv2.stereoCalibrate(
        boards, *seen, *lenses[0], *lenses[1], SIZE, flags=cv2.CALIB_USE_INTRINSIC_GUESS
    )
    R1, R2, P1, P2, *_ = cv2.stereoRectify(K1, d1, K2, d2, SIZE, R, t, flags=cv2.CALIB_ZERO_DISPARITY, alpha=0)
    return residual, (K1, d1, R1, P1), (K2, d2, R2, P2)


def table(folder: Path) -> str:
    """The whole file, first line and all."""
    pairs = {n: pair(folder, n) for n in NUMBERS}
    residual, *cameras = calibrated([pairs[n] for n in NUMBERS if n % 2])
    lines = []
    for number in (n for n in NUMBERS if n % 2 == 0):
        left, right = (
            cv2.undistortPoints(seen[:, None], K, d, R=R, P=P).reshape(-1, 2)
            for seen, (K, d, R, P) in zip(pairs[number], cameras, strict=True)
        )
        lines += [f"{number},{p[0]:.2f},{p[1]:.2f},{p[0] - q[0]:.2f}" for p, q in zip(left, right, strict=True)]
    P1, P2 = cameras[0][3], cameras[1][3]
    head = (
        f"# Inner corners of a chessboard ({COLUMNS} x {ROWS}, row by row, squares of {SQUARE:.0f} mm) in 6 stereo "
        f"pairs of {SIZE[0]} x {SIZE[1]} pixels, left02.jpg and right02.jpg to 14 of OpenCV's samples (Apache 2.0, "
        "opencv.org), located with OpenCV's findChessboardCorners and cornerSubPix; lens distortion removed and "
        "rectified with a stereo calibration from the seven pairs of odd numbers (residual "
        f"{residual:.2f} px, no distortion left): focal length {P1[0, 0]:.2f} px, centre ({P1[0, 2]:.2f}, "
        f"{P1[1, 2]:.2f}), baseline {-P2[0, 3] / P2[0, 0] / 1000:.5f} m. "
        "u, v: of the left picture; disparity: left u less right u [px]."
    )
    return "\n".join([head, "image,u,v,disparity", *lines]) + "\n"


def main(arguments: list[str] | None = None) -> int:
    """Compare the stored measurements with new ones, or store these."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="of left01.jpg, right01.jpg, ...")
    parser.add_argument("--store", action="store_true", help=f"write {STORED.relative_to(ROOT)}")
    given = parser.parse_args(arguments)
    try:
        text = table(given.folder)
    except SlamlibError as error:
        print(error, file=sys.stderr)
        return 2
    if given.store:
        write_whole(STORED, text)
        return 0
    new, old = (np.loadtxt(t.splitlines(), delimiter=",", skiprows=2) for t in (text, STORED.read_text("utf-8")))
    print(f"{len(new)} corners, at most {np.abs(new - old).max():.2f} px from the stored ones")
    print(text.splitlines()[0])
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
