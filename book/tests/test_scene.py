"""The map and the sensors' views before they are drawn: projections, outlines, roles, no code for single types."""

import ast
import re
from dataclasses import asdict, fields, replace
from pathlib import Path

import numpy as np
import pytest
import slambook.scene
from slambook.figures.colors import colors
from slambook.scene.figures import view_of
from slambook.scene.image_scene import AWAY, OUTCOMES, RING, beside, regions, sensor_scene
from slambook.scene.layers import Layer, strung
from slambook.scene.options import MapOptions, SensorOptions
from slambook.scene.roles import DARK, MAP, ROLES, THEMES, themed
from slambook.scene.scene import bounds, map_scene
from slambook.scene.view import NAMED, NEAR, OrbitView, rings

from slamlib.errors import SlamlibError, UnknownNameError
from slamlib.experiments.presets import preset
from slamlib.experiments.runs import Run
from slamlib.kalman.chi_square import chi2_quantile
from slamlib.landmarks import LINES, POINTS
from slamlib.motions import MOTIONS
from slamlib.plain_data.fields import read
from slamlib.records.snapshots import MapView
from slamlib.rigs.setup import SensorSetup
from slamlib.sensors import SENSORS
from slamlib.tests import scenes

PACKAGE = Path(slambook.scene.__file__).parent
CSS = PACKAGE.parents[1] / "book" / "_static" / "figures.css"


# -- the virtual camera ------------------------------------------------------------------------------------------------


def test_known_points_from_above_from_the_side_and_from_the_front():
    points = np.array([[1.0, 2.0, 3.0]])
    flat = {
        n: OrbitView(*NAMED[n][:2], 90.0, (0, 0, 0), 10.0, False).points(points)[0] for n in ("top", "side", "front")
    }
    assert flat["top"] == pytest.approx([0.1, 0.2])  # x to the right, y up, one unit at 10 m and 45 degrees
    assert flat["side"] == pytest.approx([0.1, 0.3])
    assert flat["front"] == pytest.approx([0.2, 0.3])


def test_perspective_shrinks_what_is_far_and_leaves_the_middle():
    view = OrbitView(-90.0, 0.0, 90.0, (0.0, 0.0, 0.0), 10.0)
    flat = view.points(np.array([[0, 0, 0], [1, 0, 0], [1, 10, 0], [1, -5, 0.0]]))
    assert flat[:, 0] == pytest.approx([0, 0.1, 1 / 20, 1 / 5])
    assert flat[:, 1] == pytest.approx(0)


@pytest.mark.parametrize("perspective", [True, False])
@pytest.mark.parametrize("aspect", [0.6, 1.5])
def test_a_fitted_view_shows_all_and_fills_the_picture(perspective, aspect):
    points = np.random.default_rng(3).uniform([-4, -2, 0], [8, 5, 3], (50, 3))
    view = OrbitView(37.0, 28.0, perspective=perspective).fitted(points, aspect)
    flat = view.points(points) / [aspect, 1]
    assert np.abs(flat).max() <= 1
    assert np.abs(flat).max() > 0.9
    across, up = flat.min(axis=0) + flat.max(axis=0)
    assert abs(across) < 0.1
    assert abs(up) < 0.1


def test_lines_end_where_they_pass_the_viewer():
    view = OrbitView(-90.0, 0.0, 90.0, (0.0, 0.0, 0.0), 10.0)
    flat = view.lines(np.array([[1, 5, 0], [1, -30, 0], [np.nan] * 3, [0, 0, 0], [0, 0, 1.0]]))
    assert flat[0] == pytest.approx([1 / 15, 0])
    assert flat[1] == pytest.approx([1 / (NEAR * 10), 0])  # cut, not turned inside out
    assert np.isnan(flat[2]).all()
    assert flat[-1] == pytest.approx([0, 0.1])
    assert np.isnan(view.points(np.array([[0, -30.0, 0]]))).all()


@pytest.mark.parametrize("perspective", [True, False])
def test_the_outline_of_an_ellipsoid_is_that_of_its_points(perspective):
    """Points of the surface lie inside the outline and reach it in every direction, in perspective too."""
    rng = np.random.default_rng(1)
    root, mean = rng.normal(size=(3, 3)), np.array([1.5, -1.0, 0.5])
    sphere = rng.normal(size=(400_000, 3))
    surface = mean + sphere / np.linalg.norm(sphere, axis=1, keepdims=True) @ root.T
    view = OrbitView(25.0, 40.0, 50.0, (0.3, 0.1, 0.2), 7.0, perspective)
    flat = view.points(surface)
    outline = view.outlines(mean[None], (root @ root.T)[None])
    for angle in np.arange(0, 2 * np.pi, 0.3):
        way = np.array([np.cos(angle), np.sin(angle)])
        sampled, drawn = (flat @ way).max(), (outline @ way).max()
        assert drawn == pytest.approx(sampled, abs=0.006 * np.ptp(flat))
    middle = (outline[:-1]).mean(axis=0)
    if perspective:  # the outline's middle is not where the middle is seen
        assert np.abs(view.points(mean[None])[0] - middle).max() > 1e-3


def test_an_ellipsoid_that_reaches_to_the_viewer_is_its_longest_axis():
    view = OrbitView(-90.0, 0.0, 90.0, (0.0, 0.0, 0.0), 10.0)
    shape = np.diag([0.01, 400.0, 0.01])
    flat = view.outlines(np.array([[1.0, 5.0, 0.0]]), shape[None])
    finite = flat[np.isfinite(flat).all(axis=1)]
    assert finite[:, 1] == pytest.approx(0, abs=1e-12)
    assert sorted(finite[:, 0]) == pytest.approx([1 / 35, 2.0])
    assert not len(view.outlines(np.full((1, 3), np.nan), np.full((1, 3, 3), np.nan)))


def test_a_map_in_the_plane_is_seen_from_above_and_any_other_from_aside():
    flat, shown = preset("plane").slam().snapshot(), scenes.snapshot()
    for snapshot, elevation in ((flat, 90.0), (shown, 35.0)):
        corners = bounds(snapshot, preset("plane").world, None, (), MapOptions())
        assert view_of(MapOptions(), snapshot, corners, 1.4).elevation == elevation
        assert view_of(MapOptions(view="side"), snapshot, corners, 1.4).elevation == 0
    run = Run(replace(preset("plane"), frames=3))
    truths = [step.truth for step in run]
    snapshot, world = run.slam.snapshot(), run.preset.world
    drawn = {layer.role: layer for layer in map_scene(snapshot, world=world, truth=truths[-1], true_path=truths)}
    assert np.nanmax(np.abs(drawn["truth"].lines[:3, 2])) == 0  # the true path lies on the floor
    north = drawn["label"].places[:, 1] - snapshot.points.geometry[:, 1]
    assert (north > 0).all()
    assert np.array_equal(drawn["label"].places[:, 2], snapshot.points.geometry[:, 2])
    view = view_of(MapOptions(), snapshot, bounds(snapshot, world, None, (), MapOptions()), 1.4)
    whole = world.points.values + np.array([0, 0.3, 0])  # with the room for their numbers
    assert np.abs(view.points(whole) / [1.4, 1]).max() < 1


def test_the_views_that_follow_and_orbit():
    shown = scenes.snapshot(40)
    corners = bounds(shown, scenes.world(), None, (), MapOptions())
    behind = view_of(MapOptions(view="normal"), shown, corners, 1.4)
    ahead = behind.points(scenes.snapshot(44).robots[0].pose[None, :3])[0]
    assert behind.points(shown.robots[0].pose[None, :3])[0] == pytest.approx([0, 0], abs=1e-9)
    assert ahead[1] > 0.01  # it drives away from the viewer, up the picture
    still, turned = (view_of(MapOptions(orbit=(o, 0.5)), shown, corners, 1.4) for o in (0.0, 1.5))
    assert turned.azimuth - still.azimuth == pytest.approx(40 * 1.5)
    assert view_of(MapOptions(orbit=(0, 10.0)), shown, corners, 1.4).elevation == 90
    custom = view_of(MapOptions(view=(10, 20, 30, 40.0)), shown, corners, 1.4)
    assert (custom.azimuth, custom.elevation, custom.field, custom.distance) == (10, 20, 30, 40)


# -- the map -----------------------------------------------------------------------------------------------------------


def test_the_map_has_what_there_is_once_and_in_its_role():
    shown, world = scenes.snapshot(), scenes.world()
    layers = {layer.role: layer for layer in map_scene(shown, world=world, truth=scenes.truth(40))}
    assert list(layers) == [role for role in MAP if role in layers]  # in the order of drawing
    assert len(layers["world"].marks) == len(world.points)
    assert np.isfinite(layers["world"].lines).all(axis=1).sum() == 2 * len(world.segments)
    converged = shown.points.converged
    assert layers["point"].marks == pytest.approx(shown.points.geometry[converged])
    assert layers["new point"].marks == pytest.approx(shown.points.geometry[~converged])
    for role, some in (("line", shown.segments.converged), ("new line", ~shown.segments.converged)):
        assert some.any()
        assert len(layers[role].means) == 2 * some.sum()
        wanted = 9 * shown.segments.covariance[some].reshape(-1, 3, 3)  # three sigmas
        assert layers[role].shapes == pytest.approx(wanted)
        assert np.isfinite(layers[role].lines).all(axis=1).sum() == 2 * some.sum()
    assert layers["label"].words == tuple(map(str, [*shown.points.ids, *shown.segments.ids]))
    assert (layers["label"].places[:3, 2] > shown.points.geometry[:3, 2]).all()
    assert layers["robot"].means == pytest.approx(shown.robots[0].pose[None, :3])


def test_options_leave_things_out():
    shown, world = scenes.snapshot(), scenes.world()
    less = MapOptions(ellipsoids=False, labels=False, world=False, ground=False)
    layers = {layer.role: layer for layer in map_scene(shown, world=world, options=less)}
    assert not {"ground", "world", "label"} & set(layers)
    assert all(np.isnan(layer.shapes).all() for layer in layers.values())


def test_the_paths_are_lines_through_the_positions():
    snapshots, truths = scenes.run(5)
    layers = {x.role: x for x in map_scene(snapshots[-1], path=snapshots, true_path=truths, truth=truths[-1])}
    assert layers["robot"].lines[:5] == pytest.approx(np.array([s.robots[0].pose[:3] for s in snapshots]))
    assert layers["truth"].lines[:5] == pytest.approx(np.array([t.robots[0][:3] for t in truths]))


def test_landmarks_at_infinity_are_left_out_and_do_not_move_the_limits():
    shown = scenes.snapshot()
    geometry, covariance = shown.points.geometry.copy(), shown.points.covariance.copy()
    geometry[5], covariance[5] = np.nan, np.nan
    shown = replace(
        shown,
        landmarks={**shown.landmarks, "points": replace(shown.points, geometry=geometry, covariance=covariance)},
    )
    corners = bounds(shown, None, None, (), MapOptions())
    assert np.isfinite(corners).all()
    assert (np.abs(corners) < 8).all()  # nor does the point that is known as a direction only, 80 m away
    flat = OrbitView(distance=30.0).flat(map_scene(shown))
    assert str(shown.points.ids[5]) not in {word for layer in flat for word in layer.words}


@pytest.mark.parametrize("name", [*POINTS, *LINES])
def test_every_type_of_landmark_is_drawn_by_the_same_code(name):
    """A type reaches the pictures as a point or two endpoints; its name changes nothing."""
    shown = scenes.snapshot()
    family = "points" if name in POINTS else "segments"
    named = replace(getattr(shown, family), kinds=(name,) * len(getattr(shown, family).ids))
    before, after = (map_scene(s) for s in (shown, replace(shown, landmarks={**shown.landmarks, family: named})))
    for one, other in zip(before, after, strict=True):
        for field in fields(Layer):
            assert np.array_equal(
                getattr(one, field.name),
                getattr(other, field.name),
                equal_nan=field.name != "role" and field.name != "words",
            )


def test_no_type_is_named_in_the_drawing_and_nothing_of_the_filter_is_known():
    names = {*POINTS, *LINES, *SENSORS, *MOTIONS}
    allowed = {"plain_data", "records", "rigs", "errors", "evaluation", "experiments", "geometry", "manifolds"}
    distribution = "slamlib.kalman.chi_square"
    for file in PACKAGE.glob("*.py"):
        tree = ast.parse(file.read_text("utf-8"))
        assert not {n.value for n in ast.walk(tree) if isinstance(n, ast.Constant)} & names, file
        modules = {n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and n.module}
        assert {m.split(".")[1] for m in modules - {distribution} if m.startswith("slamlib.")} <= allowed, file


# -- the sensors' views ------------------------------------------------------------------------------------------------


def flat_of(shown, **options):
    return {layer.role: layer for layer in sensor_scene(shown, options=SensorOptions(**options))}


def test_what_became_of_each_expectation():
    shown = scenes.with_photograph(scenes.with_segments(scenes.snapshot()))
    view, layers = shown.sensors[0], flat_of(shown)
    predictions, segments = view.points, view.segments
    endpoints = np.isfinite(segments.endpoints).all(axis=-1)
    counts = {role: int(np.isnan(layers[role].shells).all(axis=1).sum()) + 1 for role in OUTCOMES}
    assert counts["updated"] == (predictions.matched & predictions.inlier).sum() + 2
    assert counts["rejected"] == (predictions.matched & ~predictions.inlier).sum() + 1  # one end is out of view
    assert counts["missed"] == (predictions.chosen & ~predictions.matched).sum() + 2
    assert counts["predicted_patch"] == (~predictions.chosen).sum()
    assert len(layers["raw"].marks) == len(view.scan.points)
    assert len(layers["measured"].marks) == predictions.matched.sum() + 2 * 2
    assert len(layers["point"].marks) + len(layers["new point"].marks) == len(predictions.ids) + endpoints.sum()
    for role in ("updated", "rejected", "missed"):
        assert layers[role].lines.shape == (2, 2)  # one segment each
    assert not len(layers["predicted_patch"].lines)


def test_the_ellipses_hold_the_share_of_the_gate():
    shown = scenes.snapshot()
    predictions = shown.sensors[0].points
    some = np.flatnonzero(predictions.matched & predictions.inlier)[0]
    ring = flat_of(shown, gate=0.9)["updated"].shells[:37] - predictions.expected[some]
    squared = np.einsum("ni,ij,nj->n", ring, np.linalg.inv(predictions.covariance[some]), ring)
    assert squared == pytest.approx(chi2_quantile(0.9, 2))


def test_a_region_smaller_than_a_mark_is_a_ring_around_it():
    shown = scenes.snapshot()
    view = shown.sensors[0]
    tiny = view.points.covariance.copy()
    tiny[0], tiny[1] = 0.01 * np.eye(2), np.diag([900.0, 0.01])  # the second is long and thin: it stays as it is
    view = replace(view, predictions={**view.predictions, "points": replace(view.points, covariance=tiny)})
    shapes = regions(view, [0, 1], SensorOptions())
    assert shapes[0] == pytest.approx((RING * 640) ** 2 * np.eye(2))
    assert shapes[1:] == pytest.approx(chi2_quantile(0.99, 2) * tiny[1:])
    assert regions(replace(view, image=None), [0, 1], SensorOptions()) == pytest.approx(chi2_quantile(0.99, 2) * tiny)


def test_labels_of_segments_stand_beside_them():
    segments = np.array([[[0, 100], [200, 100]], [[50, 0], [50, 80]], [[10, 10], [110, 110.0]]])
    away = beside(segments) - segments.mean(axis=1)
    along = segments[:, 1] - segments[:, 0]
    assert np.linalg.norm(away, axis=1) == pytest.approx(AWAY)
    assert np.einsum("ni,ni->n", away, along) == pytest.approx(0, abs=1e-9)
    assert away[0] == pytest.approx([0, -AWAY])  # above, where v grows downwards


def test_a_sensor_without_pixels_shows_the_numbers_that_one_asks_for():
    setup = SensorSetup(
        name="sonar", type="rangeBearing", euler=(0, 0, 0), image=None, std=(0.1, 0.01, 0.01), parameters={}
    )
    shown = scenes.snapshot(setup=setup)
    predictions = shown.sensors[0].points
    layers = flat_of(shown, numbers=(1, 2))
    assert len(predictions.ids) > 10
    assert sorted(np.concatenate([layers["point"].marks, layers["new point"].marks])[:, 1]) == pytest.approx(
        sorted(predictions.expected[:, 2])
    )
    with pytest.raises(SlamlibError, match=r"sonar measures 3 numbers, counted from 0: numbers \[0, 3\]"):
        flat_of(shown, numbers=(0, 3))


def test_an_empty_frame_has_empty_layers():
    shown = scenes.snapshot()
    none = MapView(np.zeros(0, int), (), np.zeros((0, 3)), np.zeros((0, 3, 3)), np.zeros(0, bool))
    lines = MapView(np.zeros(0, int), (), np.zeros((0, 2, 3)), np.zeros((0, 2, 3, 3)), np.zeros(0, bool))
    view = replace(shown.sensors[0], scan=None, predictions={**shown.sensors[0].predictions, "points": scenes.NO_LOOKS})
    shown = replace(shown, landmarks={"points": none, "segments": lines}, sensors=(view,))
    assert all(not len(layer.marks) and not len(layer.words) for layer in sensor_scene(shown))
    flat = OrbitView(distance=20.0).flat(map_scene(shown))
    assert not any(len(layer.words) for layer in flat)


# -- roles and options -------------------------------------------------------------------------------------------------


def luminance(color):
    levels = np.array([int(color[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(levels <= 0.04045, levels / 12.92, ((levels + 0.055) / 1.055) ** 2.4) @ [0.2126, 0.7152, 0.0722]


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize(("figure", "name"), [(f, n) for f, roles in ROLES.items() for n in roles if n != "ground"])
def test_every_role_is_seen_on_a_light_and_on_a_dark_page(theme, figure, name):
    role = ROLES[figure][name]
    low, high = sorted(luminance(themed(c, theme)) for c in (role.color, colors.paper))
    wanted = 4.5 if "label" in name else 3.0
    assert (high + 0.05) / (low + 0.05) >= wanted


@pytest.mark.parametrize("roles", ROLES.values(), ids=ROLES)
def test_roles_differ_in_more_than_colour_or_have_colours_that_are_told_apart(roles):
    predictions = [(r.color, r.linestyle, r.marker, r.hollow) for n, r in roles.items() if r.label]
    assert len(set(predictions)) == len(predictions)
    assert {r.color for r in roles.values()} <= set(asdict(colors).values())


def test_the_dark_palette_is_the_page_s():
    if not CSS.is_file():
        pytest.skip("the book is not beside the package")
    text = CSS.read_text("utf-8")
    dark = text[text.index('html[data-theme="dark"]') :]
    assert asdict(DARK) == dict(re.findall(r"--figure-(\w+): (#\w{6})", dark))
    assert themed("#123456", "dark") == "#123456"
    with pytest.raises(UnknownNameError, match="theme"):
        themed(colors.blue, "sepia")


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"view": "above"}, "unknown MapOptions.view 'above'"),
        ({"view": (1, 2)}, r"view should be \(azimuth"),
        ({"view": (1, 2, 200)}, "field of view"),
        ({"orbit": (1,)}, "orbit should be 2 values"),
        ({"limits": -3}, "limits should be above 0"),
        ({"sigmas": 0}, "sigmas should be above 0"),
        ({"colour": 1}, "unknown key of MapOptions 'colour'"),
    ],
)
def test_wrong_options_of_the_map_are_named(wrong, said):
    with pytest.raises(SlamlibError, match=said):
        read(MapOptions, wrong)


@pytest.mark.parametrize(
    ("wrong", "said"), [({"gate": 1.0}, "gate"), ({"numbers": (0, -1)}, "numbers"), ({"x": 1}, "x")]
)
def test_wrong_options_of_a_sensor_are_named(wrong, said):
    with pytest.raises(SlamlibError, match=said):
        read(SensorOptions, wrong)
    with pytest.raises(SlamlibError, match="there is no sensor 'radar'; there are camera"):
        sensor_scene(scenes.snapshot(), "radar")


def test_polylines_are_strung_with_gaps():
    assert strung([], 2).shape == (0, 2)
    assert (
        np.isnan(strung([np.zeros((2, 2)), np.ones((3, 2))], 2)).all(axis=1).tolist()
        == [False] * 2 + [True] + [False] * 3
    )
    covariance = np.array([[[4.0, 1.0], [1.0, 2.0]]])
    ring = rings(covariance)[0]
    assert np.einsum("ni,ij,nj->n", ring, np.linalg.inv(covariance[0]), ring) == pytest.approx(1)
