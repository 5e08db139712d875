"""Where pictures come from: every layout, in order and lazily; and every kind of bad input, named."""

import struct
import zipfile

import numpy as np
import pytest

from slamlib.datasets import formats
from slamlib.datasets.opening import open_rectified_pairs, reopen
from slamlib.datasets.pictures import TimedImage, read_image
from slamlib.datasets.sources import of_pictures, open_source
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.registry import Registry
from slamlib.tests.pictures import DATA

cv2 = pytest.importorskip("cv2", reason="OpenCV reads the images")
SIZE = (24, 32)


def shade(number):
    """A picture whose brightness encodes its number."""
    return np.full(SIZE, 10 * number + 5, np.uint8)


def put(path, image):
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), image)


def numbers(source):
    """The numbers of the pictures, by their brightness."""
    return [round((float(p.image.mean()) - 5) / 10) for p in source]


@pytest.fixture
def folder(tmp_path):
    """Twelve pictures whose names need the natural order, and what is no picture."""
    for i in range(12):
        put(tmp_path / "seq" / f"frame{i}.png", shade(i))
    (tmp_path / "seq" / "notes.txt").write_text("not an image")
    (tmp_path / "seq" / "._frame3.png").write_text("left by another system")
    return tmp_path / "seq"


def test_a_folder_in_natural_order(folder):
    source = open_source(folder, fps=20)
    assert (source.layout, len(source), source.interval) == ("folder", 12, 0.05)
    assert numbers(source) == list(range(12))
    pictures = list(source)
    assert [p.name for p in pictures[:3]] == ["frame0.png", "frame1.png", "frame2.png"]
    assert pictures[3].time == pytest.approx(0.15)
    assert (pictures[0].image.shape, pictures[0].image.dtype) == (SIZE, np.uint8)


def test_names_that_begin_with_a_minus_come_before_the_others(tmp_path):
    for i in (3, -1, 12, 0, -10, -2):
        put(tmp_path / f"{i}.png", shade(i + 10))
    assert [p.name for p in open_source(tmp_path, fps=20)][:4] == ["-10.png", "-2.png", "-1.png", "0.png"]
    for i in (3, 12, 0):
        (tmp_path / f"{i}.png").unlink()
    with pytest.raises(SlamlibError, match=r"-10\.png to -1\.png: a dash before each number, or a minus\?"):
        open_source(tmp_path)


def test_a_glob_and_one_image(folder):
    assert numbers(open_source(f"{folder}/frame1*.png")) == [1, 10, 11]
    assert numbers(open_source(folder / "frame7.png")) == [7]


def test_pictures_are_read_when_they_are_asked_for(folder):
    source = open_source(folder)
    (folder / "frame5.png").write_bytes(b"damaged")
    found = iter(source)
    assert [next(found).name for _ in range(5)][-1] == "frame4.png"
    with pytest.raises(SlamlibError, match=r"frame5\.png"):
        next(found)
    assert numbers(source.part(6)) == [6, 7, 8, 9, 10, 11]


def test_parts_and_opening_again(folder):
    source = open_source(folder, fps=10).part(1, 3)
    assert numbers(source) == [1, 4, 7, 10]
    assert source.interval == 0.1  # of the whole
    rest = source.part(2).part(count=1)
    assert numbers(rest) == [7]
    assert [p.time for p in rest] == [pytest.approx(0.7)]
    again = reopen(rest.recipe)
    assert (numbers(again), again.recipe) == ([7], rest.recipe)
    assert numbers(reopen(open_source(folder).recipe)) == list(range(12))
    for wrong in ({"start": -1}, {"every": 0}, {"count": 0}):
        with pytest.raises(SlamlibError, match="start is 0 or more"):
            source.part(**wrong)
    with pytest.raises(SlamlibError, match="none is left"):
        source.part(4)
    for i in range(6, 12):
        (folder / f"frame{i}.png").unlink()
    with pytest.raises(SlamlibError, match="had more when"):
        reopen(rest.recipe)


def test_colour_becomes_grey_and_a_black_picture_is_valid(tmp_path):
    colour = np.zeros((*SIZE, 3), np.uint8)
    colour[..., 1] = 200  # green
    put(tmp_path / "1.png", colour)
    put(tmp_path / "2.png", np.dstack([colour, np.full(SIZE, 9, np.uint8)]))
    put(tmp_path / "3.png", np.zeros(SIZE, np.uint8))
    one, two, black = (p.image for p in open_source(tmp_path))
    assert one.mean() == pytest.approx(0.587 * 200, abs=1)
    assert np.array_equal(one, two)
    assert not black.any()
    halved = open_source(tmp_path).through(lambda image: image[::2], {"halved": True}, ORIGIN)
    assert [p.image.shape for p in halved] == [(12, 32)] * 3
    assert halved.part(1).recipe == {"halved": True, "frames": [1, 3, 1]}


def test_the_layout_of_tum(tmp_path):
    for i, name in enumerate(["b.png", "a.png", "c.png"]):  # in the order of the list, not of the names
        put(tmp_path / "rgb" / name, np.dstack([shade(i)] * 3))
    put(tmp_path / "depth" / "a.png", np.zeros(SIZE, np.uint16))
    rows = ["# color images", "1305031102.10 rgb/b.png", "1305031102.14 rgb/a.png", "1305031102.18 rgb/c.png"]
    (tmp_path / "rgb.txt").write_text("\n".join(rows))
    source = open_source(tmp_path)
    assert (source.layout, numbers(source)) == ("TUM RGB-D", [0, 1, 2])
    assert [p.time for p in source] == [1305031102.10, 1305031102.14, 1305031102.18]
    assert source.interval == pytest.approx(0.04, abs=1e-6)


def test_the_layout_of_euroc(tmp_path):
    for camera in range(2):
        there = tmp_path / "mav0" / f"cam{camera}"
        for i in range(3):
            put(there / "data" / f"{1403636579763555584 + 50000000 * i}.png", shade(i + 5 * camera))
        rows = [f"{1403636579763555584 + 50000000 * i},{1403636579763555584 + 50000000 * i}.png" for i in range(3)]
        (there / "data.csv").write_text("#timestamp [ns],filename\r\n" + "\r\n".join(rows) + "\r\n")
    for where in (tmp_path, tmp_path / "mav0", tmp_path / "mav0" / "cam0"):
        assert (open_source(where).layout, numbers(open_source(where))) == ("EuRoC", [0, 1, 2])
    right = open_source(tmp_path, camera=1)
    assert numbers(right) == [5, 6, 7]
    assert numbers(reopen(right.recipe)) == [5, 6, 7]
    assert [p.time for p in right][1] == pytest.approx(1403636579.813555584, abs=1e-6)
    with pytest.raises(SlamlibError, match="no camera 2; it has 0, 1"):
        open_source(tmp_path, camera=2)


def test_the_layout_of_kitti(tmp_path):
    for i in range(3):
        for camera in range(2):
            put(tmp_path / f"image_{camera}" / f"{i:06d}.png", shade(i + 5 * camera))
    assert open_source(tmp_path).interval == pytest.approx(0.1)
    (tmp_path / "times.txt").write_text("0.000000e+00\n1.036224e-01\n2.071898e-01\n")
    source = open_source(tmp_path)
    assert (source.layout, numbers(source)) == ("KITTI", [0, 1, 2])
    assert [p.time for p in source] == [0, 0.1036224, 0.2071898]
    assert numbers(open_source(tmp_path, camera=1)) == [5, 6, 7]
    with pytest.raises(SlamlibError, match=r"\(KITTI\) has no camera 2; it has 0, 1"):
        open_source(tmp_path, camera=2)
    put(tmp_path / "image_0" / "000003.png", shade(3))
    with pytest.raises(SlamlibError, match="3 times for 4 pictures"):
        open_source(tmp_path)


def test_the_layout_of_kitti_s_raw_recordings(tmp_path):
    for camera in range(2):
        for i in range(3):
            put(tmp_path / f"image_{camera:02}" / "data" / f"{i:010}.png", shade(i + 5 * camera))
        rows = ["2011-09-26 13:02:25.964389445", "2011-09-26 13:02:26.068011778", "2011-09-26 13:02:26.171634111"]
        (tmp_path / f"image_{camera:02}" / "timestamps.txt").write_text("\n".join(rows) + "\n")
    source = open_source(tmp_path)
    assert (source.layout, numbers(source), source.guess) == ("KITTI raw", [0, 1, 2], "")
    assert [p.time for p in source] == pytest.approx([1317042145.964389445 + 0.103622333 * i for i in range(3)])
    assert numbers(open_source(tmp_path, camera=1)) == [5, 6, 7]
    (tmp_path / "image_00" / "timestamps.txt").write_text("1\n2\n3\n")
    with pytest.raises(SlamlibError, match="dates and times such as"):
        open_source(tmp_path)
    (tmp_path / "image_00" / "timestamps.txt").write_text(rows[0])
    with pytest.raises(SlamlibError, match="1 times for 3 pictures"):
        open_source(tmp_path)


def test_the_layouts_of_tartanair_and_icl_nuim(tmp_path):
    for i in range(3):
        put(tmp_path / "tartan" / "image_left" / f"{i:06}_left.png", shade(i))
        put(tmp_path / "tartan" / "image_right" / f"{i:06}_right.png", shade(i + 5))
        put(tmp_path / "icl" / "rgb" / f"{i}.png", shade(i))
        put(tmp_path / "icl" / "depth" / f"{i}.png", deep(16))
    source = open_source(tmp_path / "tartan")
    assert (source.layout, numbers(source), source.interval) == ("TartanAir", [0, 1, 2], 0.1)
    assert numbers(open_source(tmp_path / "tartan", camera=1)) == [5, 6, 7]
    source = open_source(tmp_path / "icl")
    assert (source.layout, numbers(source), source.interval) == ("ICL-NUIM", [0, 1, 2], 1 / 30)


def test_euroc_without_its_list_and_with_times_in_seconds(tmp_path):
    for i in range(3):
        put(tmp_path / "mav0" / "cam0" / "data" / f"{1403636579763555584 + 50000000 * i}.png", shade(i))
    source = open_source(tmp_path)
    assert (source.layout, numbers(source), source.has_times) == ("EuRoC", [0, 1, 2], True)
    assert source.interval == pytest.approx(0.05)
    rows = [f"{(1403636579763555584 + 50000000 * i) / 1e9},{1403636579763555584 + 50000000 * i}.png" for i in range(3)]
    (tmp_path / "mav0" / "cam0" / "data.csv").write_text("timestamp,filename\n" + "\n".join(rows))
    listed = open_source(tmp_path)
    assert listed.times == pytest.approx(source.times)
    assert listed.guess == "data.csv: its times are taken for seconds, not nanoseconds: a picture every 0.05 s"


def test_a_list_of_files_and_one_with_times(folder):
    rows = [f"seq/frame{i}.png" for i in (3, 1, 11)]
    (folder.parent / "list.txt").write_text("# chosen\n" + "\n".join(rows), "utf-16")
    source = open_source(folder.parent / "list.txt", fps=10)
    assert (source.layout, numbers(source), source.has_times) == ("list", [3, 1, 11], False)
    (folder.parent / "times.csv").write_text("".join(f"{0.1 * i},{row}\n" for i, row in enumerate(rows)))
    source = open_source(folder.parent / "times.csv")
    assert (numbers(source), source.has_times, source.interval) == ([3, 1, 11], True, pytest.approx(0.1))
    (folder.parent / "list.txt").write_text("\n".join([*rows, "seq/frame77.png"]))
    with pytest.raises(SlamlibError, match=r"list.txt lists 1 files that are not there, .*frame77"):
        open_source(folder.parent / "list.txt")


def test_a_zip_is_read_where_it_is(folder):
    with zipfile.ZipFile(folder.parent / "a.zip", "w") as archive:
        for path in sorted(folder.iterdir()):
            archive.write(path, f"film/left/{path.name}")
    for where in ("a.zip", "a.zip/film/left"):
        source = open_source(folder.parent / where)
        assert (source.layout, numbers(source)) == ("ZIP archive", list(range(12)))
        assert [p.name for p in source.part(9, 2)] == ["frame9.png", "frame11.png"]
        assert numbers(reopen(source.recipe)) == list(range(12))
    with pytest.raises(SlamlibError, match="no image in this archive"):
        open_source(folder.parent / "a.zip" / "right")
    with zipfile.ZipFile(folder.parent / "a.zip", "a") as archive:
        archive.write(folder / "frame0.png", "film/right/frame0.png")
    with pytest.raises(
        SlamlibError, match=r"images in 2 folders \(film/left, film/right\): name one, as in .*a.zip/film"
    ):
        open_source(folder.parent / "a.zip")
    data = bytearray((folder.parent / "a.zip").read_bytes())
    data[200:260] = bytes(60)
    (folder.parent / "b.zip").write_bytes(data)
    with pytest.raises(SlamlibError, match=r"b.zip/film/left/frame0.png cannot be read"):
        list(open_source(folder.parent / "b.zip/film/left"))
    (folder.parent / "b.zip").write_text("none")
    with pytest.raises(SlamlibError, match="is no ZIP archive"):
        open_source(folder.parent / "b.zip")


def test_brackets_of_a_folder_are_its_own(folder):
    for name in ("run [1]", "run 1"):
        put(folder.parent / name / "deeper" / "2.png", shade(len(name)))
    assert numbers(open_source(f"{folder.parent}/run [1]/*/*.png")) == [7]
    assert numbers(open_source(f"{folder.parent}/run [12]/**/[0-9].png")) == [5]


def test_the_folder_of_its_owner(folder, monkeypatch):
    monkeypatch.setenv("HOME", str(folder.parent))
    monkeypatch.setenv("USERPROFILE", str(folder.parent))
    assert open_source("~/seq").where == str(folder)


def test_times_from_a_file(folder):
    (folder.parent / "times.txt").write_text("\n".join(f"{0.5 * i}" for i in range(12)))
    source = open_source(folder, times=folder.parent / "times.txt")
    assert (source.times, source.interval, source.guess) == (tuple(0.5 * i for i in range(12)), 0.5, "")
    rows = [f"{0.5 * k},frame{i}.png" for k, i in enumerate([3, 0, 11, 7, 1, 2, 4, 5, 6, 8, 9, 10])]
    (folder.parent / "named.csv").write_text("\n".join(rows))
    part = open_source(folder, times=folder.parent / "named.csv").part(1, 2)
    assert numbers(part) == [0, 7, 2, 5, 8, 10]
    assert [p.time for p in part] == [0.5, 1.5, 2.5, 3.5, 4.5, 5.5]
    (folder.parent / "named.csv").unlink()  # a recipe remembers
    again = reopen(part.recipe)
    assert [(p.name, p.time) for p in again] == [(p.name, p.time) for p in part]
    (folder / "frame12.png").write_bytes((folder / "frame0.png").read_bytes())
    with pytest.raises(SlamlibError, match="has 13 pictures, and 12 times are given"):
        reopen(part.recipe)


def test_an_order_that_names_do_not_tell_needs_a_list(tmp_path):
    for i, name in enumerate(["7.5", "7.25", "9.9"]):
        put(tmp_path / "a" / f"{name}.png", shade(i))
    with pytest.raises(SlamlibError, match=r"7\.5\.png and 7\.25\.png: decimal seconds, or"):
        open_source(tmp_path / "a")
    (tmp_path / "times.txt").write_text("0.0 7.5.png\n0.1 7.25.png\n0.2 9.9.png\n")
    assert numbers(open_source(tmp_path / "a", times=tmp_path / "times.txt")) == [0, 1, 2]


def film(path, count, codec="MJPG"):
    """A video of shades; skips where this OpenCV cannot write one."""
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*codec), 12.5, SIZE[::-1])
    if not writer.isOpened():
        pytest.skip("this OpenCV writes no videos")
    for i in range(count):
        writer.write(np.dstack([shade(i)] * 3))
    writer.release()
    return path


def test_a_video(tmp_path):
    path = film(tmp_path / "film.avi", 9)
    source = open_source(path)
    assert (source.layout, numbers(source)) == ("video", list(range(9)))
    assert source.interval == pytest.approx(0.08)
    pictures = list(source.part(2, 3))
    assert numbers(pictures) == [2, 5, 8]
    assert [p.time for p in pictures] == [pytest.approx(t) for t in (0.16, 0.40, 0.64)]
    assert pictures[1].name == "picture 5"
    assert numbers(source.part(2, 3).part(2)) == [8]
    assert open_source(path, fps=25).interval == 0.04


def test_a_film_is_turned_by_its_flag(tmp_path):
    path = film(tmp_path / "film.mp4", 3, "mp4v")
    data = bytearray(path.read_bytes())
    at = data.find(b"tkhd") + 44  # the matrix of the track's header, ISO/IEC 14496-12
    data[at : at + 36] = struct.pack(">9i", 0, 1 << 16, 0, -1 << 16, 0, 0, 0, 0, 1 << 30)
    path.write_bytes(data)
    source = open_source(path)
    assert source.notes == ("film.mp4 is turned by 90 degrees, as it says",)
    assert [p.image.shape for p in source] == [SIZE[::-1]] * 3


def test_a_film_with_a_varying_rate_has_its_own_times(tmp_path):
    path = film(tmp_path / "film.mp4", 9, "mp4v")
    assert open_source(path).times == tuple(i / 12.5 for i in range(9))
    data = path.read_bytes()
    at = data.find(b"stts") - 4  # durations of pictures, ISO/IEC 14496-12: one entry, of nine
    (duration,) = struct.unpack(">I", data[at + 20 : at + 24])
    table = (
        struct.pack(">II4sI", 40, 0, b"stts", 0)[:4]
        + b"stts"
        + struct.pack(">7I", 0, 3, 4, duration, 1, 5 * duration, 4)
    )
    table = struct.pack(">I4s8I", 40, b"stts", 0, 3, 4, duration, 1, 3 * duration, 4, duration // 2)
    data = bytearray(data[:at] + table + data[at + 24 :])
    for box in (b"moov", b"trak", b"mdia", b"minf", b"stbl"):
        start = data.find(box) - 4
        data[start : start + 4] = struct.pack(">I", struct.unpack(">I", data[start : start + 4])[0] + 16)
    path.write_bytes(data)
    source = open_source(path)
    assert [p.time for p in source] == pytest.approx([0, 0.08, 0.16, 0.24, 0.32, 0.56, 0.60, 0.64, 0.68])
    assert source.notes == ("film.mp4 has a varying rate: its own times are taken, a picture every 0.08 s",)
    assert [p.time for p in open_source(path, fps=10).part(4, 1, 3)] == [0.4, 0.5, 0.6]


def test_a_video_without_pictures_or_its_end(tmp_path):
    with pytest.raises(SlamlibError, match=r"without a single picture|cannot open it as a video"):
        open_source(film(tmp_path / "empty.avi", 0))
    whole = film(tmp_path / "whole.avi", 25)
    (tmp_path / "cut.avi").write_bytes(whole.read_bytes()[: int(0.6 * whole.stat().st_size)])
    with pytest.raises(SlamlibError, match=r"breaks off after \d+ of 25"):
        list(open_source(tmp_path / "cut.avi"))
    (tmp_path / "text.mp4").write_text("no video")
    with pytest.raises(SlamlibError, match="cannot open it as a video"):
        open_source(tmp_path / "text.mp4")


def test_pictures_in_memory():
    there = [TimedImage(str(i), 0.1 * i, shade(i)) for i in range(6)]
    assert numbers(of_pictures(there, 0.1).part(1, 2)) == [1, 3, 5]


def test_nothing_there(tmp_path):
    with pytest.raises(SlamlibError, match="there is nothing"):
        open_source(tmp_path / "absent")
    with pytest.raises(SlamlibError, match="there is nothing"):
        open_source(f"{tmp_path}/*.png")
    with pytest.raises(SlamlibError, match=r"no image in this folder$"):
        open_source(tmp_path)
    put(tmp_path / "left" / "1.png", shade(1))
    with pytest.raises(SlamlibError, match="folders left: is one of them meant"):
        open_source(tmp_path)
    with pytest.raises(SlamlibError, match="no camera 1; it has 0"):
        open_source(tmp_path / "left", camera=1)
    with pytest.raises(SlamlibError, match="above 0"):
        open_source(tmp_path / "left", fps=0)


@pytest.mark.parametrize("ending", ["png", "jpg", "pgm", "bmp", "tif", "webp"])
@pytest.mark.parametrize("share", [0.0, 0.5, 0.9])
def test_files_that_are_not_whole(tmp_path, ending, share):
    path = tmp_path / f"image.{ending}"
    put(path, np.random.default_rng(0).integers(0, 255, SIZE).astype(np.uint8))
    read_image(path)
    path.write_bytes(path.read_bytes()[: int(share * path.stat().st_size)])
    with pytest.raises(SlamlibError, match=path.name):
        list(open_source(tmp_path))


@pytest.mark.parametrize(("ending", "share"), [("jpg", 0.6), ("tif", 0.3), ("png", 0.5)])
def test_a_picture_with_a_damaged_part_is_refused_and_no_library_speaks(tmp_path, ending, share, capfd):
    path = tmp_path / f"image.{ending}"
    put(path, np.random.default_rng(0).integers(0, 255, SIZE).astype(np.uint8))
    data = bytearray(path.read_bytes())
    at = int(share * len(data))
    data[at : at + 12] = b"\xff" * 12
    path.write_bytes(data)
    with pytest.raises(SlamlibError, match=f"{path.name} cannot be read as an image"):
        read_image(path)
    assert capfd.readouterr().err == ""


def deep(bits, number=1, shape=SIZE):
    """A smooth picture of so many bits of sixteen, a bright patch on a dark ground."""
    v, u = np.mgrid[: shape[0], : shape[1]]
    wave = np.exp(-((u - 15 - number) ** 2 + (v - 11) ** 2) / 60)
    return np.rint((2**bits - 1) * wave).astype(np.uint16)


@pytest.mark.parametrize(("bits", "divisor"), [(8, 1), (10, 4), (12, 16), (14, 64), (16, 256)])
@pytest.mark.parametrize("ending", ["png", "pgm", "tif"])
def test_pictures_of_sixteen_bits_have_one_divisor(tmp_path, bits, divisor, ending):
    for i in range(20):
        put(tmp_path / f"{i}.{ending}", deep(bits, i) // (4 - i % 4))  # the fourth, eighth, ... are the brightest
    source = open_source(tmp_path)
    assert source.notes == (f"the pictures have 16 bits a value, {bits} in use: all are divided by {divisor}",)
    for i, picture in enumerate(source):
        assert np.array_equal(picture.image, deep(bits, i) // (4 - i % 4) // divisor)
        assert picture.image.dtype == np.uint8


@pytest.mark.parametrize("name", ["depth/1.png", "a/depth_1.png", "a/1_disp.png", "holes/1.png"])
def test_depth_images_are_refused(tmp_path, name):
    image = np.full(SIZE, 2000, np.uint16)
    if "holes" in name:
        image[::2, 2::4] = 0
    put(tmp_path / name, image)
    with pytest.raises(SlamlibError, match="is a depth image"):
        open_source((tmp_path / name).parent)
    (tmp_path / "depths").mkdir()  # a word within another is no sign
    put(tmp_path / "depths" / "display.png", np.full(SIZE, 2000, np.uint16))
    assert open_source(tmp_path / "depths").notes


def test_a_circle_before_a_black_ground_has_no_holes(tmp_path):
    v, u = np.mgrid[:100, :100]
    put(tmp_path / "1.png", np.where((u - 50) ** 2 + (v - 50) ** 2 < 40**2, 40000, 0).astype(np.uint16))
    assert "divided by 256" in open_source(tmp_path).notes[0]


def test_other_numbers_of_bits_and_sizes_that_change(tmp_path):
    put(tmp_path / "a" / "1.png", shade(1))
    put(tmp_path / "a" / "2.png", deep(16))
    with pytest.raises(SlamlibError, match=r"2\.png has 16 bits.*depth image"):
        list(open_source(tmp_path / "a"))
    put(tmp_path / "c" / "1.tif", np.ones(SIZE, np.float32))
    with pytest.raises(SlamlibError, match=r"1\.tif has 32 bits"):
        list(open_source(tmp_path / "c"))
    put(tmp_path / "b" / "1.png", shade(1))
    put(tmp_path / "b" / "2.png", shade(1)[:, :-2])
    with pytest.raises(SlamlibError, match=r"1\.png is 32x24, 2\.png is 30x24"):
        list(open_source(tmp_path / "b"))


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("1.0 a.png\n1.0 b.png\n", "times must grow, but a.png is of 1.0 s"),
        ("1.0 a.png\n0.5 b.png\n", "times must grow"),
        ("1.0 a.png\n2.0 c.png\n", "1 files that are not there"),
        ("1.0 a.png\n2.0\n", "line 2: 2 columns"),
        ("one a.png\n", "'one' is no time"),
        ("# nothing\n", "lists no picture"),
    ],
)
def test_lists_that_make_no_sense(tmp_path, rows, message):
    for name in ("a.png", "b.png"):
        put(tmp_path / name, shade(1))
    (tmp_path / "rgb.txt").write_text(rows)
    with pytest.raises(SlamlibError, match=message):
        open_source(tmp_path)


ANOTHER = """
from functools import partial
from slamlib.datasets.dataset import CalibrationReader, Dataset, listed
from slamlib.datasets.lens import Lens, placed
from slamlib.datasets.times import table

def cameras(where):
    return {n: where / f"list_{n}" for n in (0, 1) if (where / f"list_{n}").is_file()}

def opened(listing, fps):
    rows = table(listing, 2)
    return listed([listing.parent / name for _, (name,) in rows], [time for time, _ in rows], listing)

def read(path, text):
    f, baseline = map(float, text.split()[1:])
    return {i: partial(Lens, (16, 12, f, f), transform=placed((i * baseline, 0, 0))) for i in (0, 1)}

DATASET = Dataset("another", cameras, opened, calibrations=("camera.txt",))
READER = CalibrationReader("another", lambda text: text.startswith("another "), read)
"""


def test_another_data_set_is_one_written_file(tmp_path, monkeypatch):
    (tmp_path / "formats").mkdir()
    (tmp_path / "formats" / "another.py").write_text(ANOTHER)
    monkeypatch.setattr(formats, "__path__", [*formats.__path__, str(tmp_path / "formats")])
    for registry in (formats.DATASETS, formats.READERS):
        monkeypatch.setitem(vars(registry), "_values", Registry(formats.__name__, registry.kind, "")._values)
    for camera in range(2):
        for i in range(3):
            put(tmp_path / "there" / f"{camera}{i}.png", shade(i + 5 * camera))
        (tmp_path / "there" / f"list_{camera}").write_text("".join(f"{0.1 * i} {camera}{i}.png\n" for i in range(3)))
    (tmp_path / "there" / "camera.txt").write_text("another 100 0.25\n")
    source = open_source(tmp_path / "there", camera=1)
    assert (source.layout, numbers(source), source.interval) == ("another", [5, 6, 7], pytest.approx(0.1))
    pairs, setup, offset = open_rectified_pairs(str(tmp_path / "there"))
    assert (len(pairs), setup["parameters"]["baseline"], offset) == (3, (0.25,), 0.0)
    assert np.array_equal(next(iter(pairs)).image, np.stack([shade(0), shade(5)]))


def test_real_excerpts():
    if not (DATA / "mono_visp_cube").is_dir():
        pytest.skip("the excerpts of real sequences are not at hand")
    source = open_source(DATA / "mono_visp_cube" / "frames")
    assert len(source) == 80
    first = next(iter(source))
    assert (first.name, first.image.shape) == ("image.0000.pgm", (288, 384))
    assert len(open_source(f"{DATA}/stereo_kitti_a/image_l/*.png").part(0, 5)) == 11
