"""Pictures over photographs: the image below, overlays that can be read on it, search regions, scores, patches."""

import base64
import gc
import json
import struct
import weakref
import zlib
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from slambook.scene import SensorOptions, Window, animate, player, sensor_figure, sensor_scene
from slambook.scene.figures import SHELL
from slambook.scene.image_scene import OUTCOMES
from slambook.scene.options import MapOptions
from slambook.scene.photographs import CELL, GAP, LEVELS, grey, patched, photograph, strip
from slambook.scene.player import WEIGHT, WEIGHT_OF_IMAGES
from slambook.scene.roles import DARK, MAP, OUTLINE, SENSOR, over_image
from slambook.scene.scene import bounds

from book.tests.test_scene import luminance
from book.tests.test_scene_figures import opened, page, part  # noqa: F401
from slamlib.errors import ShapeError, SlamlibError
from slamlib.tests import scenes

ALT = "A robot on a circle, and what its camera saw."
PLAIN = [scenes.with_segments(shown) for shown in scenes.run(4)[0]]
SEEN = [scenes.with_photograph(shown) for shown in PLAIN]


def unpacked(uri):
    """The bytes (rows, columns) of a grey PNG file in an address."""
    data = base64.b64decode(uri.removeprefix("data:image/png;base64,"))
    columns, rows = struct.unpack(">II", data[16:24])
    at, packed = 8, b""
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        packed += data[at + 8 : at + 8 + length] * (data[at + 4 : at + 8] == b"IDAT")
        at += 12 + length
    lines = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(rows, columns + 1)[:, 1:]
    return np.cumsum(lines, axis=0, dtype=np.uint8)  # each row is its change from the one above


def with_image(shown, image):
    view = shown.sensors[0]
    return replace(shown, sensors=(replace(view, scan=replace(view.scan, image=image)),))


# -- bytes -------------------------------------------------------------------------------------------------------------


def test_grey_images_of_any_type_become_bytes():
    image = scenes.photograph(width=8, height=6)
    assert grey(image) is image
    assert np.array_equal(grey(image / 255), image)
    assert np.array_equal(grey(image.astype(float)), image)
    assert np.array_equal(grey(image.astype(np.uint16) * 257), image)
    assert grey(np.array([[np.nan, 1.0]])).tolist() == [[0, 255]]
    for wrong in (np.zeros((4, 4, 3)), np.zeros((0, 4)), np.zeros(4)):
        with pytest.raises(ShapeError, match="the image of a scan is grey"):
            grey(wrong)


def test_a_small_photograph_lies_where_the_whole_one_lies():
    view = SEEN[0].sensors[0]
    whole, small = photograph(view), photograph(view, 200)
    assert whole.extent == (-0.5, 639.5, 479.5, -0.5)  # pixel 0 has its middle at 0
    assert small.pixels.shape == (120, 160)
    assert small.extent == whole.extent
    means = whole.pixels.reshape(120, 4, 160, 4).mean(axis=(1, 3))
    assert np.abs(small.pixels - means).max() <= 0.5 + 255 / (LEVELS - 1) / 2
    assert len(np.unique(small.pixels)) <= LEVELS
    assert np.array_equal(unpacked(small.uri), small.pixels)
    odd = photograph(with_image(SEEN[0], scenes.photograph(width=641, height=483)).sensors[0], 200)
    assert odd.pixels.shape == (120, 160)
    assert odd.extent == whole.extent  # a column and three rows are left over
    assert photograph(PLAIN[0].sensors[0]) is None
    assert photograph(replace(view, scan=None)) is None


def test_a_strip_shows_both_patches_of_each_match_on_one_scale():
    predictions = SEEN[0].sensors[0].points
    rows = patched(predictions)
    assert rows == np.flatnonzero(predictions.matched).tolist()
    sheet = strip(predictions, rows, 3)
    assert sheet.shape == (3 * CELL, 2 * CELL, 4)
    side = CELL - GAP
    values = np.concatenate(
        [np.ravel(predictions.predicted_patch[rows[1]]), np.ravel(predictions.found_patch[rows[1]])]
    )
    for patch, across in ((predictions.predicted_patch[rows[1]], 0), (predictions.found_patch[rows[1]], CELL)):
        cell = sheet[CELL : CELL + side, across : across + side]
        assert (cell[..., 3] == 255).all()
        wanted = 255 * (patch - values.min()) / np.ptp(values)
        assert cell[0, 0, 0] == pytest.approx(wanted[0, 0], abs=1)
        assert cell[-1, -1, 0] == pytest.approx(wanted[-1, -1], abs=1)
    assert not sheet[CELL - GAP : CELL, :, 3].any()
    assert not patched(PLAIN[0].sensors[0].points)
    one = replace(
        predictions,
        found_patch=(None,) * len(predictions.ids),
        predicted_patch=(np.full((3, 5), 7.0),) * len(predictions.ids),
    )
    assert not strip(one, patched(one), 2)[:, CELL:, 3].any()  # nothing is known of what was found


# -- roles -------------------------------------------------------------------------------------------------------------


def test_overlays_can_be_read_on_black_on_white_and_on_grey():
    """The colour differs enough from its own outline, which lies around it: then what lies around that is no matter."""
    for name, role in SENSOR.items():
        light, dark = luminance(over_image(role).color), luminance(OUTLINE)
        assert (light + 0.05) / (dark + 0.05) > 4.5, name


def test_matched_missed_and_rejected_regions_are_told_apart_by_more_than_colour():
    four = [SENSOR[name] for name in OUTCOMES]
    assert len({role.linestyle for role in four}) == 4
    assert len({role.color for role in four}) == 4
    predictions = SEEN[0].sensors[0].points
    masks = np.array([holds(predictions) for holds in OUTCOMES.values()])
    assert (masks.sum(axis=0) == 1).all()
    assert masks.any(axis=1).all()
    layers = {layer.role: layer for layer in sensor_scene(SEEN[0])}
    for name, mask in zip(OUTCOMES, masks, strict=True):
        points = int(np.isnan(layers[name].shells).all(axis=1).sum()) + 1
        endpoints = np.isfinite(SEEN[0].sensors[0].segments.endpoints[OUTCOMES[name](SEEN[0].sensors[0].segments)])
        assert points == mask.sum() + endpoints.all(axis=-1).sum()


def test_scores_are_written_where_they_are_known():
    view = SEEN[0].sensors[0]
    layer = {layer.role: layer for layer in sensor_scene(SEEN[0])}["score"]
    known = np.isfinite(view.points.scores)
    assert layer.words == tuple(f"{s:.2f}" for s in view.points.scores[known])
    wanted = np.where(view.points.matched[:, None], view.points.measured, view.points.expected)[known]
    assert layer.places == pytest.approx(wanted)
    assert not {layer.role: layer for layer in sensor_scene(PLAIN[0])}["score"].words
    assert "score" not in {layer.role for layer in sensor_scene(SEEN[0], options=SensorOptions(scores=False))}
    lines = replace(
        view, predictions={**view.predictions, "segments": replace(view.segments, scores=np.array([0.5, np.nan, 0.25]))}
    )
    words = {layer.role: layer for layer in sensor_scene(replace(SEEN[0], sensors=(lines,)))}["score"]
    assert words.words[-2:] == ("0.50", "0.25")
    assert words.places[-1] == pytest.approx(view.segments.measured[2].reshape(2, 2).mean(axis=0))


@pytest.mark.parametrize("wrong", [0, -5, 2.5])
def test_a_wrong_width_is_named(wrong):
    with pytest.raises(SlamlibError, match="image_width should be"):
        SensorOptions(image_width=wrong)


# -- the figure and the player -----------------------------------------------------------------------------------------


def image_in(svg):
    return [e for e in ElementTree.fromstring(svg).iter() if e.tag.endswith("image")]


def test_the_figure_holds_a_small_image_and_bright_overlays():
    svg = sensor_figure(SEEN[0]).svg(ALT)
    (image,) = image_in(svg)
    assert unpacked(image.attrib["href"]).shape == (240, 320)
    assert len(svg) < 120_000
    assert not image_in(sensor_figure(SEEN[0], image=False).svg(ALT))
    (narrow,) = image_in(sensor_figure(SEEN[0], image_width=100).svg(ALT))
    assert unpacked(narrow.attrib["href"]).shape[1] <= 100
    words = [e.text for e in ElementTree.fromstring(svg).iter("text")]
    assert {"not found", "used", "rejected", "expected", "0.95"} <= set(words)
    paths = [e.attrib.get("style", "") for e in ElementTree.fromstring(svg).iter() if e.tag.endswith("path")]
    bright = [p for p in paths if f"stroke:{DARK.blue}" in p]
    assert bright  # what lies over the image
    assert any("--figure-blue" in p for p in paths)  # the key beside it, in the page's colour
    assert any(f"stroke:{OUTLINE}" in p for p in paths)
    assert DARK.blue not in sensor_figure(PLAIN[0]).svg(ALT)


def test_a_figure_of_points_alone_has_a_key_of_what_became_of_them():
    words = {e.text for e in ElementTree.fromstring(sensor_figure(scenes.snapshot()).svg(ALT)).iter("text")}
    assert {"used", "rejected", "expected"} <= words


def looks_in(made):
    return [frame["measurements"] for frame in made.data["frames"]]


def test_the_player_has_images_only_if_they_are_asked_for():
    without = player(SEEN, alt=ALT, sensor=0)
    assert "data:image" not in without._repr_html_()
    assert "over" not in without.data["sensor"]
    assert [word for *_, word in looks_in(without)[0]["scores"]].count("0.95") > 3
    made = player(SEEN, alt=ALT, sensor=0, images=True)
    for frame, shown in zip(looks_in(made), SEEN, strict=True):
        small = photograph(shown.sensors[0], 200)
        assert np.array_equal(unpacked(frame["image"]), small.pixels)
        assert tuple(frame["extent"]) == small.extent
    none = player(PLAIN, alt=ALT, sensor=0, images=True)
    assert "data:image" not in none._repr_html_()


def test_the_player_s_segments_have_their_ends_and_whether_they_converged():
    for frame, shown in zip(looks_in(player(PLAIN, alt=ALT, sensor=0)), PLAIN, strict=True):
        predictions = shown.sensors[0].segments
        known = dict(zip(shown.segments.ids, shown.segments.converged, strict=True))
        for row, number, endpoints, endpoint_covariances in zip(
            frame["segments"], predictions.ids, predictions.endpoints, predictions.endpoint_covariances, strict=True
        ):
            assert row[:3] == [number, row[1], int(known[number])]
            seen = np.isfinite(endpoints).all(axis=1)
            assert np.array([e[:2] for e in row[9]]) == pytest.approx(endpoints[seen], abs=0.051)
            for (_, _, a, b, c), P in zip(row[9], endpoint_covariances[seen], strict=True):
                root = np.array([[a, 0], [b, c]])
                assert root @ root.T / 9.2103 == pytest.approx(P, rel=0.02, abs=0.5)


def test_a_long_run_with_images_stays_within_its_weight():
    run = [with_image(scenes.snapshot(i), scenes.photograph(i)) for i in range(60)]
    made = player(run, alt=ALT, sensor=0, images=True, sensor_options=SensorOptions(image_width=320))
    weight = len(json.dumps(made.data["frames"], separators=(",", ":")))
    assert weight <= WEIGHT + WEIGHT_OF_IMAGES
    assert 10 < len(made.data["frames"]) < 60


@pytest.mark.parametrize("images", [True, False])
def test_the_script_shows_the_image_and_the_ellipses_of_the_frame(page, images):  # noqa: F811
    faults = opened(page, player(SEEN, alt=ALT, sensor=0, images=images))
    part(page, "labels").dispatch_event("input")
    second = "document.querySelector('.player-stage svg + svg')"
    before = page.evaluate(f"() => {second}.innerHTML")
    box = page.evaluate(f"() => {{ const r = {second}.getBoundingClientRect(); return [r.width, r.height] }}")
    if images:
        read = f"() => {{ const i = {second}.querySelector('image'); const r = i.getBoundingClientRect();"
        read += " return [i.getAttribute('href'), r.width, r.height, i === i.parentNode.firstChild] }"
        href, width, height, is_below = page.evaluate(read)
        assert np.array_equal(unpacked(href), photograph(SEEN[-1].sensors[0], 200).pixels)
        assert [width, height] == pytest.approx(box, rel=0.05)
        assert is_below
        part(page, "back").click()
        assert page.evaluate(read)[0] != href
    else:
        part(page, "back").click()
        assert not page.evaluate(f"() => {second}.querySelectorAll('image').length")
    assert page.evaluate(f"() => {second}.innerHTML") != before
    words = page.evaluate(f"() => [...{second}.querySelectorAll('text')].map((e) => e.textContent)")
    assert "0.95" in words
    assert "NaN" not in page.evaluate(f"() => {second}.innerHTML")
    assert not faults


# -- windows and films -------------------------------------------------------------------------------------------------


@pytest.fixture
def matplotlib():
    return pytest.importorskip("matplotlib", reason="windows and videos are drawn by matplotlib (extra `draw`)")


def shown_in(window, view):
    """The part of the window's picture that the image takes (rows, columns, 3)."""
    box = view.axes.get_window_extent()
    high = window.pixels().shape[0]
    x0, x1 = round(box.x0), round(box.x1)
    return window.pixels()[high - round(box.y1) : high - round(box.y0), x0:x1]


def test_the_image_lies_below_and_is_that_of_the_frame(matplotlib):
    bare = SensorOptions(ellipses=False, labels=False, raw=False, scores=False, patches=False, legend=False)
    run = [with_image(shown, scenes.photograph(i)) for i, shown in enumerate(scenes.run(3)[0])]
    run = [
        replace(
            s, sensors=(replace(s.sensors[0], predictions={**s.sensors[0].predictions, "points": scenes.NO_LOOKS}),)
        )
        for s in run
    ]
    window = Window(run[0], sensor_options=bare)
    for shown in run:
        window.update(shown)
        image = grey(shown.sensors[0].scan.image)
        (made,) = window.views[0].axes.images
        assert np.array_equal(made.get_array(), image)
        found = shown_in(window, window.views[0])[3:-3, 3:-3].astype(float)
        rows, columns = (np.linspace(4, n - 5, k).astype(int) for n, k in zip(image.shape, found.shape, strict=False))
        assert np.abs(found[..., 0] - found[..., 1]).max() == 0  # grey
        wanted = image[np.ix_(rows, columns)].astype(float)
        smooth = columns > 200  # where the pattern is not too fine for the screen
        assert np.abs(found[:, smooth, 0] - wanted[:, smooth]).mean() < 15
    window.update(replace(run[0], sensors=(replace(run[0].sensors[0], scan=None),)))
    assert not window.views[0].axes.images
    assert shown_in(window, window.views[0])[3:-3, 3:-3].min() > 250


def test_a_frame_over_a_photograph_has_bright_lines_with_dark_outlines(matplotlib):
    """On white, the outline is there; on black, the line is: pixels of a rendered frame."""
    quiet = SensorOptions(labels=False, raw=False, scores=False, patches=False, legend=False)
    for level in (0, 255):
        shown = with_image(PLAIN[0], np.full((480, 640), level, np.uint8))
        window = Window(shown, sensor_options=quiet, size=(12.8, 7.2))
        window.update(shown)
        pixels = shown_in(window, window.views[0])[3:-3, 3:-3].reshape(-1, 3).astype(int)
        blue = np.array([int(DARK.blue[i : i + 2], 16) for i in (1, 3, 5)])
        assert (np.abs(pixels - blue).max(axis=1) < 40).sum() > 100
        outline = (pixels.max(axis=1) < 60).sum() if level else len(pixels)
        assert outline > 300
    before = Window(PLAIN[0])
    before.update(PLAIN[0])
    used = {line.get_color() for line in before.views[0].axes.lines}
    assert SENSOR["updated"].color in used  # without an image: the page's colours
    assert DARK.blue not in used


def runs_of(axes, role, width):
    """The polylines (n, 2) of a colour, dashes and width in a window's axes."""
    prediction = (role.color, role.linestyle, round(width, 6))
    lines = [a for a in axes.lines if (a.get_color(), a.get_linestyle(), round(a.get_linewidth(), 6)) == prediction]
    parts = []
    for line in lines:
        rows = line.get_xydata()
        gaps = np.flatnonzero(np.isnan(rows).any(axis=1))
        parts += [part[np.isfinite(part).all(axis=1)] for part in np.split(rows, gaps)]
    return [part for part in parts if len(part)]


def test_regions_in_a_window_are_as_many_as_the_predictions(matplotlib):
    window = Window(PLAIN[0])
    window.update(PLAIN[0])
    axes, view = window.views[0].axes, PLAIN[0].sensors[0]
    for name, holds in OUTCOMES.items():
        endpoints = np.isfinite(view.segments.endpoints[holds(view.segments)]).all(axis=-1).sum()
        found = runs_of(axes, SENSOR[name], SHELL * SENSOR[name].width)
        assert len(found) == holds(view.points).sum() + endpoints, name
        if name == "updated":
            row = np.flatnonzero(holds(view.points))[0]
            assert found[0][:-1].mean(axis=0) == pytest.approx(view.points.expected[row])
    lines = {name: len(runs_of(window.map.axes, MAP[name], MAP[name].width)) for name in ("new line", "line")}
    new = int((~PLAIN[0].segments.converged).sum())
    assert lines == {"new line": new, "line": len(PLAIN[0].segments.ids) - new}
    assert new > 0


def numbers_in(part):
    """The numbers of the rows of patches."""
    return [text.get_text() for text in part.axes.texts[1:]]


def test_a_strip_beside_the_image_shows_the_patches(matplotlib):
    window = Window(SEEN[0])
    assert window.views[0].patches is None
    window.update(SEEN[0])
    made, count = window.views[0].patches, window.views[0].rows
    children = len(window.figure.axes)
    view = SEEN[0].sensors[0]
    rows = patched(view.points)[:count]
    assert numbers_in(made) == [str(view.points.ids[i]) for i in rows]
    assert np.array_equal(made.axes.images[0].get_array(), strip(view.points, rows, count))
    image, beside = window.views[0].axes.get_window_extent(), made.axes.get_window_extent()
    assert beside.x0 >= image.x1
    assert beside.height == pytest.approx(image.height, rel=0.25)
    window.update(SEEN[1])
    window.update(PLAIN[1])  # nothing matched has a patch: the strip is empty
    assert window.views[0].patches is made
    assert len(window.figure.axes) == children
    assert not numbers_in(made)
    assert not np.asarray(made.axes.images[0].get_array()).any()
    off = Window(SEEN[0], sensor_options=SensorOptions(patches=False))
    off.update(SEEN[0])
    assert off.views[0].patches is None


def test_updating_over_a_photograph_gives_the_picture_that_a_new_window_gives(matplotlib):
    updated = Window(SEEN[0], world=scenes.world())
    for shown in SEEN:
        updated.update(shown)
    anew = Window(SEEN[-1], world=scenes.world())
    anew.path = SEEN[:-1]
    anew.update(SEEN[-1])
    assert np.array_equal(updated.pixels(), anew.pixels())


def test_all_frames_of_a_film_have_room_for_the_strip_from_the_first_on(matplotlib, tmp_path, monkeypatch):
    places = []
    update = Window.update

    def watched(window, *arguments):
        update(window, *arguments)
        places.append(tuple(window.views[0].axes.get_position().bounds))

    monkeypatch.setattr(Window, "update", watched)
    run = [with_image(scenes.snapshot(0), scenes.photograph()), *SEEN[1:]]  # in the first frame nothing is matched yet
    animate(run, tmp_path / "film", size=(6.4, 3.6))
    assert len(places) == 4
    assert len(set(places)) == 1


# -- real images: no world, no truth -----------------------------------------------------------------------------------


def emptied(view):
    """A map without landmarks."""
    arrays = {n: getattr(view, n)[:0] for n in ("ids", "geometry", "covariance", "converged")}
    return replace(view, kinds=(), **arrays)


def real(number):
    """A frame of a camera alone: nothing in the map at first, and one landmark that is far off."""
    shown = with_image(scenes.snapshot(number), scenes.photograph(number))
    if number == 0:
        points, segments = (emptied(view) for view in (shown.points, shown.segments))
        view = replace(shown.sensors[0], predictions={**shown.sensors[0].predictions, "points": scenes.NO_LOOKS})
        return replace(shown, landmarks={"points": points, "segments": segments}, sensors=(view,))
    geometry, covariance = shown.points.geometry.copy(), shown.points.covariance.copy()
    geometry[7], covariance[7] = [900.0, 0, 0], np.eye(3)
    return replace(
        shown,
        landmarks={**shown.landmarks, "points": replace(shown.points, geometry=geometry, covariance=covariance)},
    )


@pytest.mark.parametrize("name", ["a.gif", "folder"])
def test_a_run_without_a_world_and_without_truth_is_filmed(matplotlib, tmp_path, name):
    if name.endswith("gif"):
        pytest.importorskip("PIL.Image", reason="GIF files are written by Pillow")
    made = animate([real(i) for i in range(3)], tmp_path / name, size=(3.2, 1.8))
    assert made.exists()


def test_without_a_world_one_wild_landmark_does_not_shrink_the_rest_and_limits_stay(matplotlib):
    assert np.abs(bounds(real(1), None, None, (), MapOptions())).max() < 10
    window, sizes = Window(real(0), size=(3.2, 1.8)), []
    for number in (0, 1, 2, 0):
        window.update(real(number))
        sizes.append(np.ptp(window.largest, axis=0))
    assert (np.diff(sizes, axis=0) >= 0).all()
    assert len(player([real(i) for i in range(3)], alt=ALT, sensor=0, images=True)._repr_html_()) > 10_000


def test_a_film_takes_snapshots_as_they_come_and_keeps_none(matplotlib, tmp_path, monkeypatch):
    """Of a run of thousands of images, the one that is shown is alive, and no other."""
    alive, most = weakref.WeakSet(), []

    def coming():
        for number in range(5):
            shown = real(number)
            alive.add(shown.sensors[0].scan)
            yield shown
            del shown
            gc.collect()
            most.append(len(alive))

    made = animate(coming(), tmp_path / "streamed", size=(3.2, 1.8), every=2)
    assert [f.name for f in sorted(made.iterdir())] == ["0001.png", "0002.png", "0003.png"]
    assert max(most) <= 3  # the one shown, the first, which the window was made with, and the next
    truths = (scenes.truth(i) for i in range(5))
    animate(coming(), tmp_path / "with truths", truths=truths, size=(3.2, 1.8))
    for count in (1, 7):
        some = (scenes.truth(i) for i in range(count))
        with pytest.raises(SlamlibError, match="one of the two ended before the other"):
            animate(coming(), tmp_path / "not as many", truths=some, size=(1.6, 0.9))
    with pytest.raises(SlamlibError, match="there is no snapshot to show"):
        animate(iter([]), tmp_path / "none")
    assert sorted(f.name for f in tmp_path.iterdir()) == ["streamed", "with truths"]


def test_a_film_of_a_list_and_of_an_iterator_have_the_same_last_path(matplotlib):
    window = Window(PLAIN[0], world=scenes.world())
    for shown in PLAIN:
        window.update(shown)
    assert [len(past.sensors) for past in window.path] == [0, 0, 0, 1]
    assert window.path[-1] is PLAIN[-1]
    track = runs_of(window.map.axes, MAP["robot"], MAP["robot"].width)[0]
    assert len(track) == len(PLAIN)
