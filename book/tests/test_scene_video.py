"""The figures in matplotlib: frames drawn anew, keys, videos written whole. Skipped without the extra `draw`."""

import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from slambook.scene import Window, animate, video
from slambook.scene.parts import extra

from slamlib.errors import SlamlibError
from slamlib.tests import scenes

ROOT = Path(__file__).parents[2]
RUN, TRUTHS = scenes.run(4)
WORLD = scenes.world()


def test_without_the_extra_the_error_says_how_to_get_it(tmp_path):
    program = (
        "import sys\n"
        "sys.modules['matplotlib'] = sys.modules['matplotlib.figure'] = sys.modules['cv2'] = None\n"
        "from slambook.scene import animate\n"
        "from slamlib.tests import scenes\n"
        f"animate(scenes.run(2)[0], {str(tmp_path / 'a.gif')!r})"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=ROOT)
    assert "matplotlib is needed for a film" in run.stderr
    assert "pip install 'slamlib[draw]'" in run.stderr
    assert not list(tmp_path.iterdir())
    with pytest.raises(SlamlibError, match=r"nothing_of_that_name is needed for a video, .* 'slamlib\[draw\]'"):
        extra("nothing_of_that_name.part", "a video")


@pytest.fixture
def matplotlib():
    return pytest.importorskip("matplotlib", reason="windows and videos are drawn by matplotlib (extra `draw`)")


def test_a_frame_leaves_nothing_of_the_one_before(matplotlib):
    window = Window(RUN[0], world=WORLD)
    window.update(RUN[0], TRUTHS[0])
    children = [len(axes.get_children()) for axes in window.figure.axes]
    first = window.pixels()
    for shown, real in zip(RUN[1:], TRUTHS[1:], strict=True):
        window.update(shown, real)
    assert (window.pixels() != first).any()
    window.update(RUN[0], TRUTHS[0])
    assert [len(axes.get_children()) for axes in window.figure.axes] == children


def test_what_is_updated_looks_as_if_it_were_made_anew(matplotlib):
    """Restoring what stays and drawing the frame over it gives the picture that a new figure gives."""
    updated = Window(RUN[0], world=WORLD)
    for shown, real in zip(RUN, TRUTHS, strict=True):
        updated.update(shown, real)
    anew = Window(RUN[-1], world=WORLD)
    anew.path, anew.true_path = RUN[:-1], TRUTHS[:-1]
    anew.update(RUN[-1], TRUTHS[-1])
    anew.figure.canvas.draw()
    assert np.array_equal(updated.pixels(), anew.pixels())


def test_a_window_keeps_the_places_of_its_parts_in_the_style_of_the_book(matplotlib):
    with matplotlib.style.context("slambook.book"):  # which lays figures out by itself
        assert Window(RUN[0], sensors=()).pixels().shape[-1] == 3


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_window_in_both_themes_with_two_sensors_and_with_none(matplotlib, theme, tmp_path):
    two = Window(RUN[0], world=WORLD, sensors=(0, "camera"), theme=theme, size=(6.4, 3.6))
    none = Window(RUN[0], sensors=(), theme=theme, size=(3.2, 3.2), view="top", labels=False)
    for window, count in ((two, 3), (none, 1)):
        window.update(scenes.with_segments(RUN[1]), TRUTHS[1])
        assert len(window.figure.axes) == count
        paper = window.pixels()[0, 0]
        assert (paper.mean() > 250) == (theme == "light")
        for ending in ("pdf", "svg", "png"):
            window.save(tmp_path / f"a.{ending}")
        saved = (tmp_path / "a.png").read_bytes()
        assert saved.startswith(b"\x89PNG")
        assert len(saved) > 3000  # the frame is saved too


def test_keys_turn_and_zoom_the_map(matplotlib):
    from matplotlib.backend_bases import KeyEvent

    window = Window(RUN[0], world=WORLD, size=(4.8, 2.7))
    window._key(
        KeyEvent("key_press_event", window.figure.canvas, "shift+left")
    )  # nothing is shown yet: nothing happens
    window.update(RUN[0])
    seen = [window.pixels()]
    for key in ("shift+left", "shift+up", "+", "left"):
        window.figure.canvas.callbacks.process(
            "key_press_event", KeyEvent("key_press_event", window.figure.canvas, key)
        )
        seen.append(window.pixels())
    changed = [bool((a != b).any()) for a, b in pairwise(seen)]
    assert changed == [True, True, True, False]


def test_a_window_where_there_is_no_screen_is_an_error_that_says_so(matplotlib, monkeypatch):
    from matplotlib import pyplot

    pyplot.switch_backend("agg")
    with pytest.raises(SlamlibError, match=r"opens no window here \(its backend is agg\).*leave show out"):
        Window(RUN[0], show=True)
    assert not pyplot.get_fignums()


def test_a_window_waits_for_a_key(matplotlib):
    window = Window(RUN[0], size=(1.6, 0.9))
    asked = []
    window.figure.waitforbuttonpress = asked.append
    window.wait()
    assert asked == [0]


def test_a_sensor_without_an_image_has_limits_that_hold_all(matplotlib):
    from slamlib.rigs.setup import SensorSetup

    prediction = {"type": "rangeBearing", "euler": (0, 0, 0), "image": None, "std": (0.1,), "parameters": {}}
    setup = SensorSetup(name="sonar", **prediction)
    window = Window(scenes.snapshot(setup=setup), size=(4.8, 2.7))
    for number in (0, 30):
        shown = scenes.snapshot(number, setup=setup)
        window.update(shown)
        (low, high), (bottom, top) = window.views[0].axes.get_xlim(), window.views[0].axes.get_ylim()
        expected = shown.sensors[0].points.expected
        assert low < expected[:, 0].min() <= expected[:, 0].max() < high
        assert bottom < expected[:, 1].min() <= expected[:, 1].max() < top


SMALL = {"world": WORLD, "truths": TRUTHS, "size": (3.2, 1.81)}


def test_a_folder_of_numbered_pictures(matplotlib, tmp_path):
    made = animate(RUN, tmp_path / "new" / "frames", every=2, orbit=(5, 0), **SMALL)
    assert [f.name for f in sorted(made.iterdir())] == ["0001.png", "0002.png"]
    assert (made / "0001.png").read_bytes() != (made / "0002.png").read_bytes()


def test_a_gif_has_all_frames(matplotlib, tmp_path):
    image = pytest.importorskip("PIL.Image", reason="GIF files are written by Pillow")
    made = animate(RUN, tmp_path / "a.gif", fps=20, **SMALL)
    with image.open(made) as found:
        assert (found.n_frames, found.size, found.info["duration"]) == (4, (320, 181), 50)


@pytest.mark.parametrize("name", ["a.mp4", "a.webm"])
def test_a_film_has_all_frames_of_even_size(matplotlib, tmp_path, name):
    cv2 = pytest.importorskip("cv2", reason="films are written by OpenCV (extra `draw`)")
    made = animate(RUN, tmp_path / name, fps=8, **SMALL)
    film = cv2.VideoCapture(str(made))
    frames = []
    while (found := film.read())[0]:
        frames.append(found[1])
    assert (len(frames), frames[0].shape, film.get(cv2.CAP_PROP_FPS)) == (4, (180, 320, 3), 8)
    window = Window(RUN[0], world=WORLD, size=(3.2, 1.81))
    window.update(RUN[0], TRUTHS[0])
    shown = window.pixels()[:180].astype(float)
    right, turned = (np.abs(frame - shown).mean() for frame in (frames[0][..., ::-1], frames[0]))
    assert right < 5  # the film is lossy
    assert right < 0.8 * turned  # red is not blue


@pytest.mark.parametrize("name", ["a.gif", "a.mp4", "a"])
def test_nothing_is_left_of_a_video_that_fails_and_nothing_is_overwritten(matplotlib, tmp_path, name, monkeypatch):
    if name.endswith("mp4"):
        pytest.importorskip("cv2", reason="films are written by OpenCV (extra `draw`)")
    animate(RUN[:1], tmp_path / name, size=(1.6, 0.9))
    with pytest.raises(
        SlamlibError, match=r"exists: choose another name, or replace it \(overwrite=True, or --overwrite\)"
    ):
        animate(RUN, tmp_path / name)
    before = sorted(tmp_path.rglob("*"))
    pixels = Window.pixels
    calls = []

    def failing(window):
        calls.append(1)
        if len(calls) == 3:
            raise RuntimeError("the disk is full")
        return pixels(window)

    monkeypatch.setattr(Window, "pixels", failing)
    with pytest.raises(RuntimeError, match="the disk is full"):
        animate(RUN, tmp_path / name, overwrite=True, size=(1.6, 0.9))
    assert sorted(tmp_path.rglob("*")) == before
    monkeypatch.undo()
    animate(RUN[:2], tmp_path / name, overwrite=True, size=(1.6, 0.9))
    assert not [f for f in tmp_path.rglob("*") if "partial" in f.name]


@pytest.mark.parametrize("name", ["notes.txt", "0000.png", "0003.png", "000001.png", "left/0001.png"])
def test_a_folder_is_replaced_only_if_it_is_a_film(matplotlib, tmp_path, name):
    film = animate(RUN[:1], tmp_path / "film", size=(1.6, 0.9))
    other = film / name
    other.parent.mkdir(exist_ok=True)
    other.write_bytes(b"somebody's")
    with pytest.raises(SlamlibError, match="film is a folder, and holds other things than a film's pictures"):
        animate(RUN[:1], film, overwrite=True, size=(1.6, 0.9))
    assert other.read_bytes() == b"somebody's"
    for nowhere in (".", "..", "/"):
        with pytest.raises(SlamlibError, match="is no name of a film"):
            animate(RUN[:1], nowhere, overwrite=True)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"path": "a.avi"}, r"unknown ending of a video's name '.avi'.*Known: \(a folder\), .gif, .mp4, .webm"),
        ({"snapshots": []}, "there is no snapshot to show"),
        ({"truths": TRUTHS[:1]}, "one truth a snapshot is wanted, got 1 for 4"),
        ({"fps": 0}, "fps is positive"),
        ({"every": 0}, "every is at least 1"),
        ({"views": "top"}, "did you mean 'view'"),
    ],
)
def test_wrong_arguments_are_named_before_anything_is_drawn(arguments, said, tmp_path):
    given = {"snapshots": RUN, **arguments}
    given["path"] = tmp_path / given.get("path", "a.gif")
    with pytest.raises(SlamlibError, match=said):
        animate(**given)
    assert not list(tmp_path.iterdir())
    assert set(video.WRITERS) == {"", ".gif", ".mp4", ".webm"}
