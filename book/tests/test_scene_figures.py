"""The figures on the page: NumPy alone, repeatable, described; the player's data, and its script in a browser."""

import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from slambook.figures import picture
from slambook.scene import SensorOptions, map_figure, player, sensor_figure
from slambook.scene.image_scene import OUTCOMES, regions
from slambook.scene.packing import KINDS
from slambook.scene.player import WEIGHT

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.rigs.setup import SensorSetup
from slamlib.tests import scenes

ROOT = Path(__file__).parents[2]
ALT = "A robot on a circle among points and segments, with ellipsoids."
RUN, TRUTHS = scenes.run(12)
WORLD = scenes.world()


@pytest.mark.parametrize("options", [{}, {"view": "top", "labels": False}, {"perspective": False, "legend": False}])
def test_a_map_is_the_same_svg_on_each_run_and_says_what_it_is(options):
    made = [map_figure(RUN[-1], world=WORLD, truth=TRUTHS[-1], path=RUN, **options) for _ in range(2)]
    first, second = (picture(fig, alt=ALT)._repr_html_() for fig in made)
    assert first == second
    root = ElementTree.fromstring(made[0].svg(ALT))
    assert root.attrib["aria-label"] == ALT
    words = {e.text for e in root.iter("text")}
    assert ("72" in words) == options.get("labels", True)
    assert ("new points" in words) == options.get("legend", True)
    assert "nan" not in first


def test_numpy_alone_draws_the_same_bytes_in_every_process():
    program = (
        "import sys\n"
        "for name in ('matplotlib', 'scipy', 'IPython', 'sympy', 'PIL', 'cv2'): sys.modules[name] = None\n"
        "import hashlib\n"
        "from slambook.scene import map_figure, player, sensor_figure\n"
        "from slamlib.tests import scenes\n"
        "run, truths = scenes.run(4)\n"
        "html = player(run, world=scenes.world(), truths=truths, alt='A robot among points.')._repr_html_()\n"
        "html += map_figure(run[-1]).svg('x') + sensor_figure(run[-1]).svg('y')\n"
        "print(hashlib.sha256(html.encode()).hexdigest())"
    )
    seen = set()
    for seed in ("0", "4711"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
        command = [sys.executable, "-c", program]
        run = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
        seen.add(run.stdout)
    assert len(seen) == 1


def test_a_camera_s_figure_has_its_image_s_axes_and_shows_the_image():
    shown = scenes.with_segments(RUN[-1])
    svg = sensor_figure(shown, "camera").svg(ALT)
    words = {e.text for e in ElementTree.fromstring(svg).iter("text")}
    assert {"u [px]", "v [px]", "used", "rejected", "expected", "not found", "delivered", "matched", "81"} <= words
    image = np.zeros((48, 64), np.uint8)
    view = shown.sensors[0]
    seen = replace(shown, sensors=(replace(view, scan=replace(view.scan, image=image)),))
    assert "data:image/png" in sensor_figure(seen).svg(ALT)
    assert "data:image/png" not in svg


def test_a_sensor_without_an_image_has_axes_of_its_own_numbers():
    prediction = {"type": "rangeBearing", "euler": (0, 0, 0), "image": None, "std": (0.1,), "parameters": {}}
    shown = scenes.snapshot(setup=SensorSetup(name="sonar", **prediction))
    words = {e.text for e in ElementTree.fromstring(sensor_figure(shown).svg(ALT)).iter("text")}
    assert {"measured number 0", "measured number 1"} <= words
    named = sensor_figure(shown, numbers=(1, 0), names=("bearing [rad]", "range [m]")).svg(ALT)
    assert {"bearing [rad]", "range [m]"} <= {e.text for e in ElementTree.fromstring(named).iter("text")}


def test_wrong_names_are_answered_with_the_right_ones():
    with pytest.raises(UnknownNameError, match="did you mean 'labels'"):
        map_figure(RUN[0], label=False)
    with pytest.raises(UnknownNameError, match="did you mean 'ellipses'"):
        sensor_figure(RUN[0], ellipse=False)
    with pytest.raises(SlamlibError, match="there is no sensor 3"):
        sensor_figure(RUN[0], 3)


# -- the player --------------------------------------------------------------------------------------------------------


class Parts(HTMLParser):
    """The texts of a figure's scripts by their classes, and the attributes of its elements."""

    def __init__(self, text):
        super().__init__()
        self.scripts, self.elements, self._open = {}, [], None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.elements.append((tag, attributes))
        self._open = attributes.get("class") if tag == "script" else None

    def handle_data(self, data):
        if self._open:
            self.scripts[self._open] = self.scripts.get(self._open, "") + data

    def handle_endtag(self, tag):
        self._open = None


def data_of(made):
    return json.loads(Parts(made._repr_html_()).scripts["player-data"])


def test_the_player_s_data_are_the_snapshots_to_a_unit_of_length():
    made = player(RUN, world=WORLD, truths=TRUTHS, alt=ALT, frames=len(RUN))
    data, unit, rows = data_of(made), 0.01, {}
    assert len(data["frames"]) == len(RUN)
    for frame, shown in zip(data["frames"], RUN, strict=True):
        rows = {k: v for k, v in rows.items() if k not in frame["gone"]} | frame["landmarks"]
        assert set(rows) == {f"p{i}" for i in shown.points.ids} | {f"s{i}" for i in shown.segments.ids}
        for i, number in enumerate(shown.points.ids):
            kind, *numbers = rows[f"p{number}"]
            assert KINDS[kind] == ("point" if shown.points.converged[i] else "new point")
            assert np.array(numbers[:3]) * unit == pytest.approx(shown.points.geometry[i], abs=0.5001 * unit)
            factor = np.zeros((3, 3))
            factor[np.tril_indices(3)] = np.array(numbers[3:]) * unit
            size = np.sqrt(np.trace(shown.points.covariance[i]))
            error = factor @ factor.T / 9 - shown.points.covariance[i]
            assert np.abs(error).max() < 2 * unit * (size + unit)
        for i, number in enumerate(shown.segments.ids):
            assert KINDS[rows[f"s{number}"][0]] == ("line" if shown.segments.converged[i] else "new line")
            endpoints = np.reshape(rows[f"s{number}"][1:], (2, 9))[:, :3] * unit
            assert endpoints == pytest.approx(shown.segments.geometry[i], abs=0.5001 * unit)
        assert np.array(frame["at"]) * unit == pytest.approx(shown.robots[0].pose[None, :3], abs=0.5001 * unit)


def test_landmarks_that_do_not_change_are_sent_once_and_those_that_go_are_named():
    first, second = scenes.snapshot(3), replace(scenes.snapshot(3), number=4)
    names = ("ids", "kinds", "geometry", "covariance", "converged")
    fewer = replace(second.points, **{n: getattr(second.points, n)[2:] for n in names})
    data = data_of(player([first, second, replace(second, landmarks={**second.landmarks, "points": fewer})], alt=ALT))
    assert not data["frames"][1]["landmarks"]
    assert not data["frames"][1]["gone"]
    assert data["frames"][2]["gone"] == ["p1", "p2"]


def test_the_player_s_measurements_are_the_snapshots_to_a_tenth_of_a_pixel():
    run = [scenes.with_segments(shown) for shown in RUN]
    data = data_of(player(run, alt=ALT, frames=len(RUN), sensor="camera"))
    assert data["sensor"]["limits"] == [0, 640, 480, 0]
    for frame, shown in zip(data["frames"], run, strict=True):
        predictions, rows = shown.sensors[0].points, frame["measurements"]["points"]
        assert [row[0] for row in rows] == predictions.ids.tolist()
        for i, (_, outcome, _, u, v, a, b, c, *measured) in enumerate(rows):
            assert list(OUTCOMES.values())[outcome](predictions)[i]
            assert [u, v] == pytest.approx(predictions.expected[i], abs=0.051)
            root = np.array([[a, 0], [b, c]])
            wanted = regions(shown.sensors[0], [0, 1], SensorOptions())[i]
            assert root @ root.T == pytest.approx(wanted, rel=0.05, abs=4)
            assert measured == (pytest.approx(predictions.measured[i], abs=0.051) if predictions.matched[i] else [])
        outcomes = [list(OUTCOMES)[row[1]] for row in frame["measurements"]["segments"]]
        assert outcomes == ["missed", "updated", "rejected"]
        assert len(frame["measurements"]["raw"]["segments"]) == 2


def test_a_long_run_stays_light():
    run = [scenes.snapshot(i, seed=i) for i in range(200)]
    made = player(run, alt=ALT, frames=200, sensor=0)
    html = made._repr_html_()
    assert 20 < len(made.data["frames"]) < 200
    assert len(json.dumps(made.data["frames"], separators=(",", ":"))) <= WEIGHT
    assert len(html) < 300_000
    assert made.data["frames"][-1]["said"].startswith("frame 199")


def test_the_figure_is_operable_and_described():
    made = player(RUN, alt=ALT, note=lambda shown: f"<{shown.number}>", view=(10, 20, 30))
    parts = Parts(made._repr_html_())
    assert repr(made) == f"Player of 12 frames: {ALT}"
    for tag, attributes in parts.elements:
        if tag == "button" or attributes.get("type") == "range":
            assert attributes["aria-label"]
    stage = next(a for _, a in parts.elements if a.get("data-player") == "stage")
    assert stage["tabindex"] == "0"
    assert "arrow keys" in stage["aria-label"]
    assert ALT in stage["aria-label"]
    assert list(data_of(made)["views"]) == ["custom", "top", "side", "front", "view", "normal"]
    assert "&lt;11&gt;" in made._repr_html_()
    assert "https:" not in made._repr_html_()
    assert "http:" not in re.sub(r"http://www\.w3\.org/2000/svg", "", made._repr_html_())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"snapshots": RUN[:1]}, "at least two frames"),
        ({"truths": TRUTHS[:3]}, "one truth a snapshot is wanted, got 3 for 12"),
        ({"alt": "A map."}, "alt should be a sentence"),
        ({"fps": 0}, "fps should be a positive number"),
        ({"speed": 2}, "unknown key of MapOptions 'speed'"),
    ],
)
def test_wrong_arguments_of_the_player_are_named(arguments, said):
    with pytest.raises(SlamlibError, match=said):
        player(**{"snapshots": RUN, "alt": ALT, **arguments})


# -- in a browser ------------------------------------------------------------------------------------------------------

PLACES = """() => {
  const middle = ({x, y, width, height}) => [x + width / 2, y + height / 2];
  const words = [...document.querySelectorAll('.player-stage text')].filter((e) => e.textContent);
  return Object.fromEntries(words.map((e) => [e.textContent, middle(e.getBoundingClientRect())]));
}"""
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@pytest.fixture(scope="module")
def page():
    playwright = pytest.importorskip("playwright.sync_api", reason="the player is driven by playwright")
    if CHROMIUM is None:
        pytest.skip("no Chromium found (apt-get install chromium): the player was not driven")
    with playwright.sync_playwright() as tool:
        browser = tool.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        yield browser.new_page(viewport={"width": 390, "height": 800})
        browser.close()


def opened(page, made):
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    # as innerHTML, which is how the page's own Python shows a result: no script runs by itself
    page.set_content("<!doctype html><html lang=en><meta charset=utf-8><title>Map</title><body><main></main></body>")
    page.evaluate("html => { document.querySelector('main').innerHTML = html }", made._repr_html_())
    return faults


def part(page, name):
    return page.locator(f"[data-player={name}]")


def test_the_script_draws_what_python_drew(page):
    """The first touch replaces the still picture by the script's: labels, marks and lines do not move."""
    faults = opened(page, player(RUN, world=WORLD, truths=TRUTHS, alt=ALT, frames=len(RUN)))
    before = page.evaluate(PLACES)
    part(page, "labels").dispatch_event("input")
    after = page.evaluate(PLACES)
    assert len(before) > 60
    for word, place in before.items():
        assert np.abs(np.array(place) - after[word]).max() < 1.5, word
    assert not faults


@pytest.mark.parametrize("pixels", [True, False])
def test_the_script_draws_what_a_sensor_saw_as_python_drew_it(page, pixels):
    prediction = {"type": "rangeBearing", "euler": (0, 0, 0), "image": None, "std": (0.1,), "parameters": {}}
    setup = None if pixels else SensorSetup(name="sonar", **prediction)
    run = [scenes.snapshot(i, setup=setup) for i in range(3)]
    run = [scenes.with_segments(shown) for shown in run] if pixels else run
    made = player(
        run, alt=ALT, sensor=0, labels=True, sensor_options=SensorOptions(numbers=(1, 0)) if not pixels else None
    )
    faults = opened(page, made)
    second = PLACES.replace(".player-stage text", ".player-stage svg + svg text")
    before = page.evaluate(second)
    part(page, "labels").dispatch_event("input")
    after = page.evaluate(second)
    assert len(before) > 5
    for word, place in before.items():
        assert np.abs(np.array(place) - after[word]).max() < 1.5, word
    part(page, "back").click()
    assert page.evaluate(second) != after
    assert not faults


def test_keys_and_buttons_play_step_turn_and_zoom(page):
    faults = opened(page, player(RUN, world=WORLD, truths=TRUTHS, alt=ALT, frames=len(RUN), fps=50))
    drawn = "() => document.querySelector('.player-stage svg').innerHTML"
    pictures = [page.evaluate(drawn)]
    for name in ("back", "on", "nearer", "farther"):
        part(page, name).click()
        pictures.append(page.evaluate(drawn))
    part(page, "stage").focus()
    for key in ("ArrowLeft", "ArrowUp", "+", ","):
        page.keyboard.press(key)
        pictures.append(page.evaluate(drawn))
    assert len(set(pictures)) >= len(pictures) - 2  # there and back again is the same picture
    assert part(page, "said").inner_text().startswith("frame 10,")
    part(page, "view").select_option("top")
    part(page, "frame").fill("0")
    assert part(page, "frame").get_attribute("aria-valuetext").startswith("frame 0,")
    part(page, "play").click()
    page.wait_for_function("() => document.querySelector('[data-player=frame]').value === '11'")
    assert part(page, "play").inner_text() == "Play"
    part(page, "orbit").click()
    assert part(page, "orbit").get_attribute("aria-pressed") == "true"
    assert "NaN" not in page.evaluate(drawn)
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 390
    assert not faults
