"""Every command is stopped at random moments, by Ctrl-C and by SIGTERM: it goes on as if it had not been."""

import codecs
import json
import os
import shutil
import signal
import subprocess
import sys
from contextlib import contextmanager

import numpy as np
import pytest
from slambook import rendering

from slamlib.cli import main
from slamlib.errors import SlamlibError
from slamlib.experiments.runs import Run
from slamlib.plain_data.files import atomic_write, check_writable, write_whole
from slamlib.vision.opening import IMAGES, PAIRS, load

STOPS, FEW = 20, 3  # at most; at least, where a resumed run is quicker than the one whose calls were counted


def called(words, at=None, number=signal.SIGINT):
    """Call the command; send it a signal at call number `at` of a function. Return its status and the calls made."""
    calls = 0

    def count(*_):
        nonlocal calls
        calls += 1
        if calls == at:
            os.kill(os.getpid(), number)

    before = signal.signal(signal.SIGTERM, signal.SIG_IGN), signal.signal(signal.SIGINT, signal.default_int_handler)
    sys.setprofile(count)
    try:
        status = main(words)
    except KeyboardInterrupt:  # after the command's end
        status = 0
    finally:
        sys.setprofile(None)
        signal.signal(signal.SIGTERM, before[0])
        signal.signal(signal.SIGINT, before[1])
    return status, calls


def stopped(words, calls, capsys):
    """Call the command, stop it at random calls, resume it each time, to the end.

    calls: of the whole command, with everything imported; a stop comes after 4 to 20 % of them, at times before the
    first frame is done. Return how often it was stopped, and the last words.
    """
    rng = np.random.default_rng(7)
    for count in range(STOPS):
        number = (signal.SIGINT, signal.SIGTERM)[count % 2]
        status, _ = called(words, int(rng.uniform(0.04, 0.2) * calls), number)
        told = capsys.readouterr().err
        if status == 0:
            return count, words
        assert status == 128 + number
        assert "Traceback" not in told
        if "resume with: slamlib " in told:
            words = told.rpartition("resume with: slamlib ")[2].splitlines()[0].split()
    assert main(words) == 0
    return STOPS, words


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A folder of rendered stereo pairs, in KITTI's layout."""
    lens = {"intrinsics": (79.5, 59.5, 130.0, 130.0), "distortion": (0.0,)}
    way = rendering.path("sideways")
    rig = rendering.rig_along_path(way, baseline=0.12, image=(160.0, 120.0), parameters=lens)
    rng = np.random.default_rng(1)
    film = rendering.film(rendering.default_room(), rig, way, frames=12, dt=0.06, rng=rng)
    return str(rendering.save_film(tmp_path_factory.mktemp("room") / "kitti", film))


def test_a_simulated_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    call = ["run", "points", "--frames", "40"]
    assert main([*call, "--save", "first.npz"]) == 0
    status, calls = called([*call, "--save", "whole.npz"])
    assert status == 0
    count, words = stopped([*call, "--save", "cut.npz"], calls, capsys)
    assert count >= FEW
    assert words == ["run", "--resume", "cut.npz", "--save", "cut.npz"]
    same(Run.load("whole.npz"), Run.load("cut.npz"), lambda run: run.result().errors)


@pytest.mark.parametrize("kind", [IMAGES, PAIRS], ids=lambda kind: kind.name)
def test_a_run_on_images(kind, room, tmp_path, monkeypatch, capsys):
    pytest.importorskip("cv2", reason="OpenCV reads the pictures")
    monkeypatch.chdir(tmp_path)
    call = ["run", kind.name, "--source", room, "--calibration", f"{room}/calibration.json"]
    assert main([*call, "--save", "first.npz"]) == 0
    status, calls = called([*call, "--save", "whole.npz"])
    assert status == 0
    count, _ = stopped([*call, "--save", "cut.npz"], calls, capsys)
    assert count >= FEW
    same(load("whole.npz", kind), load("cut.npz", kind), lambda run: run.trajectory().poses)


def same(one, two, path):
    """The runs are the same to the bit, but for the times."""
    assert one.done == two.done
    assert np.array_equal(path(one), path(two), equal_nan=True)
    assert np.array_equal(one.slam.belief.matrix, two.slam.belief.matrix)
    assert [lm.id for lm in one.slam.landmarks] == [lm.id for lm in two.slam.landmarks]


def test_frames_that_have_changed_are_noticed(room, tmp_path, monkeypatch, capsys):
    cv2 = pytest.importorskip("cv2", reason="OpenCV reads the pictures")
    monkeypatch.chdir(tmp_path)
    shutil.copytree(room, "kitti")
    call = ["--source", "kitti", "--calibration", "kitti/calibration.json", "--frames", "3", "--save", "run.npz"]
    assert main(["run", "images", *call]) == 0
    images = sorted((tmp_path / "kitti" / "image_0").iterdir())
    resumed = ["run", "images", "--resume", "run.npz", "--frames", "5"]
    assert main(resumed) == 0
    pixels = cv2.imread(str(images[2]), cv2.IMREAD_UNCHANGED)
    pixels[0, 0] ^= 1
    cv2.imwrite(str(images[2]), pixels)
    assert main(resumed) == 2
    assert f"{images[2].name} now with other pixels" in capsys.readouterr().err


def test_a_comparison(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    call = ["compare", "ahmPnt", "idpPnt", "--runs", "10", "--frames", "6", "--json", "--folder"]
    assert main([*call, "first"]) == 0
    capsys.readouterr()
    status, calls = called([*call, "whole"])
    assert status == 0
    wanted = json.loads(capsys.readouterr().out)
    count, _ = stopped([*call, "cut"], calls, capsys)
    assert count >= FEW
    capsys.readouterr()
    assert main([*call, "cut"]) == 0
    found = json.loads(capsys.readouterr().out)
    for row in (*wanted, *found):
        del row["milliseconds_per_frame"]
    assert found == wanted
    assert sorted(os.listdir("cut")) == sorted(os.listdir("whole"))


@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_a_stop_within_a_codec(number, status, monkeypatch, capsys):
    """Until Python 3.12 a codec wraps what is raised in it, as in one that reads the names within an archive."""
    stopping = codecs.CodecInfo(None, lambda *_: os.kill(os.getpid(), number), name="stopping")
    find = {"stopping": stopping}.get
    codecs.register(find)
    try:
        monkeypatch.setattr("slamlib.cli.parser", lambda: b"-".decode("stopping"))
        assert called([])[0] == status
    finally:
        codecs.unregister(find)
    assert capsys.readouterr().err.startswith("slamlib: ")


def test_a_stop_within_an_archive_is_a_stop(tmp_path):
    """A ZIP file that is left with an open entry refuses to be closed, and its ValueError would hide the stop."""

    @contextmanager
    def unclosable():
        try:
            yield
        finally:
            raise ValueError("an open writing handle")

    def write(error):
        with atomic_write(tmp_path / "a.zip") as partial, unclosable():
            partial.write_text("half")
            raise error

    with pytest.raises(KeyboardInterrupt):
        write(KeyboardInterrupt())
    with pytest.raises(ValueError, match="open writing handle"):
        write(RuntimeError())
    assert not list(tmp_path.iterdir())


def test_a_stopped_run_without_a_name_gets_a_new_one(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "slamlib-points-1.npz").write_text("mine")
    status, _ = called(["run", "points", "--frames", "10"], 50_000)
    assert status == 130
    assert "slamlib run --resume slamlib-points-1-2.npz" in capsys.readouterr().err
    assert (tmp_path / "slamlib-points-1.npz").read_text() == "mine"


LIMITED = """
import resource, sys
resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))
from slamlib.cli import main
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.parametrize("name", ["run.npz", "run.mp4", "run.gif", "run"])
def test_a_full_disk(name, tmp_path):
    """Stood in for by a limit of the size of files: one line says so, the old file stays, nothing else is left."""
    if name != "run.npz":
        pytest.importorskip("matplotlib", reason="films need matplotlib")
        pytest.importorskip("cv2", reason="films need OpenCV")
    (tmp_path / "run.npz").write_text("old")
    option = ["--overwrite", "--save", name] if name == "run.npz" else ["--video", name]
    call = [sys.executable, "-c", LIMITED, "run", "points", "--frames", "6", *option]
    ended = subprocess.run(call, cwd=tmp_path, capture_output=True, text=True)
    assert ended.returncode == 2
    assert "Traceback" not in ended.stderr
    assert "cannot be written" in ended.stderr
    left = sorted(file.name for file in tmp_path.iterdir() if not file.name.startswith("slamlib-points"))
    assert left == ["run.npz"]
    assert (tmp_path / "run.npz").read_text() == "old"


def test_a_full_disk_behind_the_output():
    if not os.path.exists("/dev/full"):
        pytest.skip("this system has no /dev/full")
    with open("/dev/full", "w") as full:
        call = [sys.executable, "-m", "slamlib", "list", "points"]
        ended = subprocess.run(call, stdout=full, stderr=subprocess.PIPE, text=True)
    assert ended.returncode == 2
    assert ended.stderr == "slamlib: No space left on device\n"


def test_what_a_killed_process_left_is_removed(tmp_path):
    text = "import sys, os, signal; from slamlib.plain_data.files import atomic_write\n"
    text += "with atomic_write(sys.argv[1]) as p: p.write_text('half'); os.kill(os.getpid(), signal.SIGKILL)"
    target = tmp_path / "a [b].npz"
    target.write_text("old")
    subprocess.run([sys.executable, "-c", text, str(target)])
    assert len(list(tmp_path.iterdir())) == 2
    assert target.read_text() == "old"
    other = tmp_path / f".a [b].{os.getppid()}.partial.npz"  # of a process that still writes
    other.write_text("half")
    write_whole(target, "new")
    assert sorted(tmp_path.iterdir()) == [other, target]
    assert target.read_text() == "new"


def test_files_that_cannot_be_written_are_said_before_the_run(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("slamlib.slam.filter.Slam.step", None)  # no frame may be run
    (tmp_path / "file").write_text("")
    for path, message in ((tmp_path, "it is a folder"), (tmp_path / "file", "replace it with --overwrite")):
        assert main(["run", "points", "--save", str(path)]) == 2
        assert message in capsys.readouterr().err
    for path in (tmp_path / "file" / "run.npz", "/proc/run.npz"):
        with pytest.raises(SlamlibError, match="cannot be written"):
            check_writable(path)
    check_writable(tmp_path / "new" / "folder" / "run.npz")
    assert (tmp_path / "new" / "folder").is_dir()
