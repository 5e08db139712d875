"""Figures with handles: what Python draws is the start that the page's script goes on from, and formulas are slamlib's.

`book/tests/site/test_drag.py` does the same to the figures of the built pages.
"""

import shutil

import matplotlib.pyplot as plt
import numpy as np
import pytest
from slambook.figures import drag, ellipse, figure

from book.live.standin import pyplot as stand_in
from book.tools import browser, layout
from slamlib import Belief, nees
from slamlib.errors import SlamlibError
from slamlib.geometry.pose import ORIGIN
from slamlib.landmarks.fhm_point import FHM_POINT
from slamlib.sensors import Calibration
from slamlib.sensors.pinhole import project
from slamlib.sensors.relative_position import converted
from slamlib.sensors.stereo import STEREO

STATIC = layout.BOOK / "_static"
ALT = "An ellipse with its half-axes, and a point outside of it."
NUMBERS = {"xx": 1.2, "xy": -0.9, "yy": 1.4, "rho": -0.9 / np.sqrt(1.2 * 1.4), "D2": 0.0}
SAYS = "P = ({xx:.2f}, {xy:.2f}; {yy:.1f}), \u03c1 = {rho:.3f}\nD² = {D2:.2f}"
DRAWN = """html => [...new DOMParser().parseFromString(html, 'text/html').querySelectorAll('figure.drag')].map(f => ({
  said: f.querySelector('.sweep-note').textContent, lines: Object.fromEntries([...f.querySelectorAll('[data-part]')]
    .map(g => [g.dataset.part, g.querySelector('path')?.getAttribute('d')])) }))"""
FAR = """([i, lines]) => {  // how far a vertex of the script is from the line of Python, at most, of each part
  const far = {};
  for (const group of document.querySelectorAll('figure.drag')[i].querySelectorAll('[data-part]')) {
    const name = group.dataset.part;
    if (group.hasAttribute('transform')) far[name] =
      Math.max(...group.getAttribute('transform').match(/-?[\\d.]+/g).map(Math.abs));
    else {
      const now = group.querySelector('path'), old = now.cloneNode();
      old.setAttribute('d', lines[name]);
      const step = old.getTotalLength() / 4000;
      const line = Array.from({ length: 4001 }, (_, i) => old.getPointAtLength(i * step));
      const points = now.getAttribute('d').slice(1).replace('z', '').split('L').map(p => p.split(' ').map(Number));
      const nearest = ([x, y]) => Math.min(...line.map(p => Math.hypot(p.x - x, p.y - y)));
      far[name] = Math.max(...points.map(nearest));
    }
  }
  return far; }"""
HELD = "() => [...document.querySelectorAll('figure.drag')].every(figure => figure.dataset.held === 'yes')"


def goes_on(page, html):
    """Assert that the scripts have begun with what stands in the page: lines to 0.1 points, words to the letter."""
    for i, before in enumerate(page.evaluate(DRAWN, html)):
        far = page.evaluate(FAR, [i, before["lines"]])
        assert set(far) == set(before["lines"])
        assert max(far.values()) < 0.1, far
        assert page.locator("figure.drag .sweep-note").nth(i).text_content() == before["said"]


@pytest.fixture(autouse=True)
def _the_book_s_look():
    with plt.style.context("slambook.book"):
        yield
    plt.close("all")


def held(plt=plt, turned=(1.0, 0.4), across=0.5, point=(1.5, -1.2), sigmas=1.5):
    """The ellipse with everything that its script moves."""
    mean, axis = np.array([0.3, -0.2]), np.array(turned)
    side = across * np.array([-axis[1], axis[0]]) / np.hypot(*axis)
    P = np.outer(axis, axis) + np.outer(side, side)
    D2 = float(nees(np.array(point) - mean, P))
    fig, ax = plt.subplots()
    corners = np.array([[-1, 1, 1, -1, -1], [-1, -1, 1, 1, -1]])
    ax.plot(*(mean[:, None] + sigmas * np.sqrt(np.diag(P))[:, None] * corners), gid="box")
    ax.plot(*ellipse(mean, P, sigmas=sigmas), gid="ellipse")
    ax.plot(*ellipse(mean, P, sigmas=np.sqrt(D2)), gid="contour")
    ax.plot(*zip(mean, mean + sigmas * axis, strict=True), gid="half-axis")
    ax.plot(*zip(mean, mean + sigmas * side, strict=True), gid="other half-axis")
    ax.plot(*point, "X", gid="point")
    ax.set(xlim=(-5, 5), ylim=(-4, 4))
    ax.set_aspect("equal")
    start = {"mean": mean, "axis": axis, "across": across, "point": point, "sigmas": sigmas}
    values = {"xx": P[0, 0], "xy": P[0, 1], "yy": P[1, 1], "D2": D2, "rho": P[0, 1] / np.sqrt(P[0, 0] * P[1, 1])}
    return drag("ellipse", fig, start, ALT, says=SAYS, values=values)


def bells(plt=plt, prior=(3.0, 1.5), seen=(6.0, 1.0)):
    """The two bells, and what follows."""
    gain = prior[1] ** 2 / (prior[1] ** 2 + seen[1] ** 2)
    after = prior[0] + gain * (seen[0] - prior[0]), np.sqrt(gain) * seen[1]
    fig, ax = plt.subplots()
    x = np.linspace(-6, 16, 1201)
    for name, (m, s) in {"prior": prior, "seen": seen, "posterior": after}.items():
        peak = 1 / (s * np.sqrt(2 * np.pi))
        ax.plot(x, peak * np.exp(-(((x - m) / s) ** 2) / 2), gid=name)
        ax.text(m, peak, name, gid=f"{name} words")
    ax.set(xlim=(-4, 14), ylim=(0, 0.8))
    start, values = {"prior": prior, "seen": seen}, {"gain": gain, "mean": after[0], "sigma": after[1]}
    return drag("bells", fig, start, ALT, says="K = {gain:.2f}: {mean:.2f} ± {sigma:.2f} m", values=values)


def pair(plt=plt, point=(1.1, 3.5), base=1.0, focal=12.0, sigmas=2):
    """Two cameras and a landmark with all parts of its script, by slamlib."""
    half, plane, far = 0.5, 1.2, 7.0
    (x, z), rig = point, rectified(focal, base, half / np.sqrt(3))
    left, _, d = rig.project(np.array([x, 0, z, 1.0]))
    _, P = converted(rig, np.array([left, 0, d]))
    corners = [converted(rig, np.array([left + i, 0, d + i - j]))[0] for i, j in half * np.array(AROUND)]
    fig, ax = plt.subplots()
    for name, start, column in (("left", 0, left), ("right", base, left - d)):
        low, high = (start + far * (column + side) / focal for side in (-half, half))
        ax.plot([far, 0, far], [low, start, high], gid=name)
    ax.plot([plane, plane], [base - 0.5, base + 0.5], gid="right plane")
    ax.plot([0, 2 * plane], [0, 2 * plane * (left - d) / focal], gid="parallel")
    ax.plot([plane, plane], [plane * (left - d) / focal, plane * left / focal], gid="disparity")
    ax.plot(*np.transpose(corners)[[2, 0]], gid="diamond")
    ax.plot(*ellipse(np.array([z, x]), P[np.ix_([2, 0], [2, 0])], sigmas=sigmas), gid="ellipse")
    ax.plot(z, x, "o", gid="point")
    ax.text(plane, plane * (left - d) / focal, "d", gid="d")
    ax.text(0, base, "right", gid="right words")
    ax.set(xlim=(-1, far), ylim=(2.5, -1))  # x is to the right of who looks along z: downwards
    start = {"point": point, "base": base, "focal": focal, "half": half, "plane": plane, "far": far, "sigmas": sigmas}
    values = {"z": z, "b": base, "d": d, "sigma": np.sqrt(P[2, 2])}
    return drag("stereo", fig, start, ALT, says="{z:.2f} m, {b:.2f} m: {d:.1f} px, {sigma:.2f} m", values=values)


AROUND = [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]  # the columns' errors at the diamond's corners


def rectified(focal, base, sigma):
    """A stereo pair with independent noise of its columns."""
    R = sigma**2 * np.array([[1.0, 0, 1], [0, 1, 0], [1, 0, 2]])
    return Calibration(STEREO, R, intrinsics=[0, 0, focal, focal], baseline=[base])


def parallax(plt=plt, distance=10.0, base=0.4, focal=320, noise=1.0, edge=25.0):
    """Two rays, and the interval of the distance between them; whose far end may be beyond the axes, or infinity."""
    w, spread = 1 / distance, 2 * np.sqrt(2) * noise / (focal * base)
    low, high, alpha = w - spread, w + spread, np.arctan2(base, distance)
    near, far = 1 / high, 1 / low if low > 0 else np.inf
    end, radius = min(far, edge), 0.35 * distance
    turn = np.pi - alpha * np.linspace(0, 1, 101)
    fig, (above, below) = plt.subplots(2, 1, figsize=(5.8, 4.8))
    above.plot([0, distance], [0, 0], gid="ray")
    above.plot([0, distance], [base, 0], gid="second ray")
    above.plot([near, end], [0, 0], gid="on the ray")
    above.plot(distance + radius * np.cos(turn), radius * np.sin(turn), gid="angle")
    above.text(distance - radius, -0.25, "a", gid="angle words")
    above.plot(0, base, "s", gid="camera")
    above.plot(distance, 0, "o", gid="point")
    above.set(xlim=(-1, edge), ylim=(-0.4, 1.6))
    below.plot([0, near, near], [high, high, 0], gid="near")
    below.plot([0, end, end], [low, low, 0 if far < edge else low], gid="far")
    below.plot([0, distance, distance], [w, w, 0], gid="middle")
    below.plot([0, 0], [low, high], gid="in w")
    below.plot([near, end], [0, 0], gid="in d")
    below.set(xlim=(-1, edge), ylim=(-0.1, 0.3))
    start = {"distance": distance, "base": base, "focal": focal, "noise": noise, "edge": edge}
    values = {"angle": np.degrees(alpha), "w": w, "spread": spread, "near": near, "far": far}
    return drag(
        "parallax",
        fig,
        start,
        ALT,
        says="{angle:.1f}: {w:.3f} ± {spread:.3f}, {near:.1f} to {far:.1f} m",
        values=values,
    )


def camera(plt=plt, y=0.9, z=4.0, focal=1.6):
    """The pin-hole from the side with everything that its script moves."""
    fig, ax = plt.subplots()
    slopes = {"upper edge": -1 / focal, "lower edge": 1 / focal, "ray": y / z}
    ends = {name: min(6.2, 2 / abs(slope)) for name, slope in slopes.items()}
    lines = {name: ([0, ends[name]], [0, ends[name] * slope]) for name, slope in slopes.items()}
    lines |= {
        "plane": ([focal, focal], [-1, 1]),
        "image": ([focal, focal], [0, focal * y / z]),
        "height": ([z, z], [0, y]),
    }
    for name, line in lines.items():
        ax.plot(*line, gid=name)
    ax.plot(z, y, "o", gid="point")
    ax.set(xlim=(-0.6, 6.2), ylim=(2, -2), aspect="equal")
    start = {"point": (z, y), "focal": focal, "half": 1, "rows": 480, "ends": (6.2, 2)}
    values = {"v": 240 + 240 * focal * y / z, "angle": np.degrees(np.arctan(1 / focal))}
    return drag("camera", fig, start, ALT, says="row {v:.1f}, {angle:.1f}°", values=values)


def test_names_come_through_to_the_drawing_and_a_figure_without_them_has_none():
    parts = ["box", "contour", "ellipse", "half-axis", "other half-axis", "point"]
    for drawer in (plt, stand_in):
        made = held(drawer)
        assert sorted(part.partition('"')[0] for part in made.svg.split('data-part="')[1:]) == parts
        assert made.svg.count("data-view=") == 1
    assert held(plt)._repr_html_() == held(stand_in)._repr_html_()
    fig, ax = figure()
    ax.plot([0, 1], [0, 1])
    assert "data-" not in fig.svg(ALT)


def test_what_is_said_has_true_minus_signs_and_no_sign_at_zero():
    fig, ax = figure()
    ax.plot([0, 1], [0, 1], gid="ellipse")
    made = drag("ellipse", fig, {}, ALT, says=SAYS + " {zero:.2f}", values={**NUMBERS, "zero": -0.001})
    assert made.said == "P = (1.20, \u22120.90; 1.4), \u03c1 = \u22120.694\nD² = 0.00 0.00"
    assert repr(made) == f"Figure with handles: {ALT}"


def test_what_cannot_be_held_is_refused():
    fig, ax = figure()
    ax.plot([1, 2], [1, 2])
    with pytest.raises(SlamlibError, match="nothing of the figure has a name: give what moves a gid"):
        drag("ellipse", fig, {}, ALT)
    ax.plot([1, 2], [1, 2], gid="curve")
    with pytest.raises(SlamlibError, match="says has a place for 'rho'"):
        drag("ellipse", fig, {}, ALT, says="{rho:.2f}")
    with pytest.raises(SlamlibError, match="alt should be a sentence"):
        drag("ellipse", fig, {}, "short")
    ax.set(xscale="log", yscale="log")
    with pytest.raises(SlamlibError, match="along linear axes alone"):
        drag("ellipse", fig, {}, ALT)


@pytest.fixture(scope="module")
def chromium():
    pytest.importorskip("playwright.sync_api", reason="handles are driven by playwright")
    path = browser.browser_path()
    if path is None:
        pytest.skip("no Chromium found (apt-get install chromium): the handles were not driven")
    with browser.chromium(path) as found:
        yield found


@pytest.fixture
def page(chromium, tmp_path):
    """A page beside the scripts, shown by `show(html)`, once all figures have their handles; faults fail the test."""
    for name in ("drag.js", "figures.css"):
        shutil.copy(STATIC / name, tmp_path)
    shutil.copytree(STATIC / "drag", tmp_path / "drag")
    page, faults = chromium.new_page(viewport={"width": 800, "height": 1000}), []
    page.on("pageerror", lambda e: faults.append(str(e)))
    page.on("console", lambda m: faults.append(m.text) if m.type == "error" else None)

    def show(*figures):
        head = '<meta charset="utf-8"><link rel="stylesheet" href="figures.css"><script src="drag.js"></script>'
        body = "".join(f'<div id="f{i}">{made._repr_html_()}</div>' for i, made in enumerate(figures))
        (tmp_path / "page.html").write_text(f"<!doctype html><html>{head}<body>{body}</body></html>", "utf-8")
        page.goto((tmp_path / "page.html").as_uri())
        page.wait_for_function(HELD)

    page.show = show
    yield page
    assert faults == []
    page.close()


def called(page, kind, formula, arguments):
    """What a formula of a script gives for each list of arguments."""
    run = """async ([kind, name, all]) => {
      const { formulas } = await Drag.load(kind);
      return all.map(a => formulas[name](...a)); }"""
    return page.evaluate(run, [kind, formula, arguments])


def covariances(rng, count):
    """Random ones, of all sizes, turns and widths, in lists; round and upright ones as well."""
    scales = 10.0 ** rng.uniform(-3, 3, count)
    roots = rng.standard_normal((count, 2, 2)) * scales[:, None, None]
    return [(r @ r.T).tolist() for r in roots] + [[[2.0, 0.0], [0.0, 2.0]], [[1.0, 0.0], [0.0, 3.0]]]


def test_the_ellipse_s_formulas_are_slamlib_s(page):
    rng = np.random.default_rng(5)
    matrices = covariances(rng, 200)
    page.show()
    for P, found in zip(matrices, called(page, "ellipse", "eigen", [[P] for P in matrices]), strict=True):
        values, vector = np.array(found["values"]), np.array(found["vector"])
        expected = np.linalg.eigvalsh(P)[::-1]
        np.testing.assert_allclose(values, expected, atol=1e-12 * expected[0])
        np.testing.assert_allclose(P @ vector, values[0] * vector, atol=1e-12 * expected[0])
        assert np.hypot(*vector) == pytest.approx(1, abs=1e-12)
    means, sizes = rng.standard_normal((len(matrices), 2)), rng.uniform(0.5, 3, len(matrices))
    asked = [[m.tolist(), P, k] for m, P, k in zip(means, matrices, sizes, strict=True)]
    for (mean, P, k), found in zip(asked, called(page, "ellipse", "outline", asked), strict=True):
        drawn, size = np.array(found).T, np.sqrt(np.trace(P))
        ours = ellipse(mean, P, sigmas=k)  # the same points, begun at another one
        if P[0][0] == P[1][1]:
            continue
        matched = [np.abs(drawn - other).max() for other in from_each_point(ours)]
        assert min(matched) < 1e-12 * size * max(1, np.linalg.cond(P) ** 0.5)
    deviations = rng.standard_normal((len(matrices), 2))
    distances = called(page, "ellipse", "squared", [[e.tolist(), P] for e, P in zip(deviations, matrices, strict=True)])
    for e, P, found in zip(deviations, matrices, distances, strict=True):
        assert found == pytest.approx(float(nees(e, np.array(P))), rel=1e-13 * np.linalg.cond(P) + 1e-12)
    asked = [[e.tolist(), k] for e, k in zip(deviations, sizes, strict=True)]
    for (axis, across), found in zip(asked, called(page, "ellipse", "covariance", asked), strict=True):
        V = np.column_stack([axis, [-axis[1], axis[0]]]) / np.hypot(*axis)
        P = V @ np.diag([np.hypot(*axis) ** 2, across**2]) @ V.T
        np.testing.assert_allclose(found, P, atol=1e-12 * np.trace(P))


def from_each_point(outline):
    """A closed outline begun at each of its points, in either sense."""
    ring = outline[:, :-1]
    for way in (ring, ring[:, ::-1]):
        for start in range(way.shape[1]):
            one = np.roll(way, start, axis=1)
            yield np.concatenate([one, one[:, :1]], axis=1)


def test_the_product_of_bells_is_the_update_of_a_belief(page):
    rng = np.random.default_rng(6)
    asked = [
        [[m, s], [z, r]] for m, z, s, r in zip(*rng.normal(0, 10, (2, 50)), *rng.uniform(0.1, 5, (2, 50)), strict=True)
    ]
    page.show()
    for ((m, s), (z, r)), found in zip(asked, called(page, "bells", "product", asked), strict=True):
        belief = Belief()
        block = belief.add(1, np.array([m]), np.array([[s**2]]))
        belief.update([block], [np.eye(1)], np.array([z - m]), np.array([[r**2]]))
        assert found["mean"] == pytest.approx(block.mean[0], rel=1e-12, abs=1e-12)
        assert found["variance"] == pytest.approx(belief.matrix[0, 0], rel=1e-12)
        assert found["gain"] * r**2 == pytest.approx(found["variance"], rel=1e-12)
    for x, (m, s) in ((0.3, (0.1, 0.7)), (-2.0, (1.0, 3.0))):
        assert called(page, "bells", "density", [[x, m, s]]) == pytest.approx(
            [np.exp(-((x - m) ** 2) / s**2 / 2) / np.sqrt(2 * np.pi) / s], rel=1e-12
        )


def test_the_pair_s_formulas_are_slamlib_s(page):
    rng = np.random.default_rng(7)
    page.show()
    for _ in range(50):
        focal, base, sigma = rng.uniform(10, 900), rng.uniform(0.05, 1), rng.uniform(0.1, 1)
        x, z = rng.uniform(-3, 3), rng.uniform(1, 20)
        rig = rectified(focal, base, sigma)
        u, _, d = rig.project(np.array([x, 0, z, 1.0]))
        (found,) = called(page, "stereo", "columns", [[[x, z], focal, base]])
        assert found == pytest.approx([u, u - d], rel=1e-12, abs=1e-9)
        (found,) = called(page, "stereo", "triangulate", [[[u, u - d], focal, base]])
        assert found == pytest.approx([x, z], rel=1e-9)
        _, P = converted(rig, np.array([u, 0, d]))
        (found,) = called(page, "stereo", "covariance", [[[x, z], focal, base, sigma]])
        np.testing.assert_allclose(found, P[np.ix_([0, 2], [0, 2])], rtol=1e-9, atol=1e-12 * P[2, 2])
        half = 0.4 * d
        ends = [[u + i, 0, d + i - j] for i, j in half * np.array(AROUND[:4])]
        (found,) = called(page, "stereo", "diamond", [[[x, z], focal, base, half]])
        expected = [converted(rig, np.array(y))[0][[0, 2]] for y in ends]
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9)


def test_a_landmark_dragged_away_is_less_certain_and_stays_within_reach(page):
    page.show(pair())
    landmark, camera = (page.locator(f"#f0 [data-handle={name}]") for name in ("point", "base"))
    landmark.focus()
    for _ in range(5):
        page.keyboard.press("Shift+ArrowRight")
    assert page.locator("#f0 .sweep-note").text_content() == pair(point=(1.1, 6.0)).said
    camera.focus()
    for _ in range(10):
        page.keyboard.press("Shift+ArrowUp")  # towards the left camera, on an axis that points downwards
    least = 2 * 0.5 * 7 / 12
    assert page.locator("#f0 .sweep-note").text_content() == pair(point=(1.1, 6.0), base=least).said


def two_images(distance, base, noise, focal):
    """Standard deviation of the inverse depth and angle between the rays, by slamlib's model of a point ahead."""
    landmark, information, rays = np.array([*ORIGIN, 0, 0, 1 / distance]), np.zeros((3, 3)), []
    for x in (0.0, -base):
        point, J = FHM_POINT.to_frame.jac(np.array([x, *ORIGIN[1:]]), landmark)
        u, v, z = point[:3]
        rows = focal / z * np.array([[1, 0, -u / z], [0, 1, -v / z]]) @ J.landmark[:3, 6:]
        information += rows.T @ rows / noise**2
        rays.append(point[:3] / np.linalg.norm(point[:3]))
    return np.sqrt(np.linalg.inv(information)[2, 2]), np.arcsin(np.linalg.norm(np.cross(*rays)))


def test_the_interval_of_two_images_is_that_of_least_squares(page):
    rng = np.random.default_rng(7)
    asked = np.column_stack([rng.uniform(2, 24, 50), rng.uniform(0.1, 2, 50), rng.uniform(0.2, 3, 50)])
    page.show()
    sigmas = called(page, "parallax", "sigma", [[b, s, 320] for _, b, s in asked])
    angles = called(page, "parallax", "angle", [[d, b] for d, b, _ in asked])
    for (d, b, s), sigma, angle in zip(asked, sigmas, angles, strict=True):
        assert (sigma, angle) == pytest.approx(two_images(d, b, s, 320), rel=1e-9)
    found = called(page, "parallax", "interval", [[1 / d, s] for (d, *_), s in zip(asked, sigmas, strict=True)])
    endless = [far for _, far in found].count(None)
    assert 0 < endless < 50
    for (d, *_), sigma, (near, far) in zip(asked, sigmas, found, strict=True):
        assert 1 / near - 1 / d == pytest.approx(2 * sigma)
        assert (far is None) == (2 * sigma >= 1 / d)
        if far is not None:
            assert 1 / d - 1 / far == pytest.approx(2 * sigma)


def test_a_short_base_line_leaves_the_distance_open(page):
    page.show(parallax(distance=15.0))
    camera, note = page.locator("#f0 [data-handle=camera]"), page.locator("#f0 .sweep-note")
    assert "\u221e" not in note.text_content()
    camera.focus()
    page.keyboard.press("Shift+ArrowDown")  # by a fifth of a metre
    assert note.text_content() == parallax(distance=15.0, base=0.2).said
    page.keyboard.press("Shift+ArrowDown")
    assert note.text_content().endswith(" to \u221e m")
    assert camera.get_attribute("aria-valuenow") == "0.1"


def test_the_camera_s_row_is_the_pin_hole_s(page):
    rng = np.random.default_rng(7)
    y, z, alpha, v0 = rng.uniform([-2, 0.4, 100, 200], [2, 6, 900, 300], (50, 4)).T
    page.show()
    asked = np.stack([y, z, alpha, v0], axis=-1).tolist()
    for found, *given in zip(called(page, "camera", "row", asked), y, z, alpha, v0, strict=True):
        y_i, z_i, alpha_i, v0_i = given
        _, expected = project(np.array([0.3, y_i, z_i, 1]), np.array([320, v0_i, 500, alpha_i]), np.zeros(8))
        assert found == pytest.approx(expected, rel=1e-12)
    below = np.array([0, 1, 1.6, 1])  # the image's lower border
    (angle,) = called(page, "camera", "view", [[1.6, 1]])
    assert 240 + 384 * np.tan(np.radians(angle)) == pytest.approx(
        project(below, np.array([320, 240, 384, 384.0]), np.zeros(8))[1], rel=1e-12
    )


def test_a_camera_is_held_by_its_point_and_its_image_plane(page):
    page.show(camera())
    for name, key, times in (("point", "ArrowUp", 20), ("plane", "ArrowRight", 10)):
        page.locator(f"[data-handle={name}]").focus()
        for _ in range(times):
            page.keyboard.press(key)
    said = camera(y=0.9 - 20 * 0.04, focal=1.6 + 10 * 0.068).said  # a hundredth of each axis, and up is up
    assert page.locator(".sweep-note").text_content() == said
    page.locator("[data-handle=point]").focus()
    for _ in range(20):
        page.keyboard.press("Shift+ArrowLeft")  # not behind the pin-hole
    assert float(page.locator("[data-handle=point]").get_attribute("aria-valuetext").split(",")[0]) == 0.4


def test_the_script_goes_on_from_what_python_drew(page):
    made = (
        held(),
        held(turned=(-0.3, 1.2), across=0.9, point=(-1, 2.0), sigmas=2.0),
        bells(),
        pair(),
        pair(base=1.6),
        parallax(),
        camera(),
        camera(y=-0.4, z=2.5, focal=2.2),
    )
    page.show(*made)
    goes_on(page, "".join(m._repr_html_() for m in made))
    for m in made:
        assert page.evaluate(DRAWN, m._repr_html_())[0]["said"] == m.said
    with pytest.raises(AssertionError, match="half-axis"):
        goes_on(page, held(turned=(1.0, 0.5))._repr_html_())


def middle(handle):
    box = handle.locator(".seen").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def test_a_pointer_drags_and_the_figure_follows(page):
    page.show(held(point=(1.5, -1.2)), bells())
    point = page.locator("#f0 [data-handle=point]")
    x, y = middle(point)
    page.mouse.move(x + 3, y - 2)  # beside its middle: it must not jump
    page.mouse.down()
    page.mouse.move(x - 57, y + 28, steps=3)
    page.mouse.up()
    page.mouse.move(x, y)  # let go
    assert middle(point) == pytest.approx((x - 60, y + 30), abs=0.2)
    told = page.locator("#f0 .sweep-note").text_content()
    where, _, heard = point.get_attribute("aria-valuetext").partition(". ")
    assert heard == told
    there = held(point=tuple(map(float, where.split(", ")))).said  # to three digits
    assert float(told.partition("D² = ")[2]) == pytest.approx(float(there.partition("D² = ")[2]), rel=0.02)
    assert told != held(point=(1.5, -1.2)).said
    page.mouse.move(*middle(page.locator("#f1 [data-handle='seen mean']")))
    page.mouse.down()
    page.mouse.move(5000, -5000)  # not out of the axes
    page.mouse.up()
    assert page.locator("#f1 [data-handle='seen mean']").get_attribute("aria-valuenow") == "14"
    page.locator("#f1").get_by_role("button", name="Start over").click()
    assert page.locator("#f1 .sweep-note").text_content() == bells().said


def test_a_keyboard_moves_the_handles_and_they_have_names(page):
    page.show(bells(), held())
    assert page.get_by_role("slider").count() == 7
    assert page.get_by_role("img").count() == 0  # whose parts nobody would be told
    page.keyboard.press("Tab")
    width = page.get_by_role("slider", name="the measurement: its standard deviation")
    for _ in range(3):
        page.keyboard.press("Tab")
    assert width.evaluate("e => e === document.activeElement")
    assert width.get_attribute("aria-valuenow") == "1"
    page.keyboard.press("ArrowUp")  # up is right where there is one way only
    assert float(width.get_attribute("aria-valuenow")) == pytest.approx(1.18)
    assert width.get_attribute("aria-valuetext") == f"1.18. {bells(seen=(6.0, 1.18)).said}"
    page.keyboard.press("Shift+ArrowLeft")  # no narrower than the least
    assert width.get_attribute("aria-valuenow") == "0.1"
    page.locator("#f1 [data-handle=across]").focus()
    for _ in range(30):
        page.keyboard.press("Shift+ArrowDown")  # beyond the middle it does not turn over
    assert "nan" not in page.locator("#f1 .sweep-note").text_content().lower()
    assert float(page.locator("#f1 [data-handle=axis]").get_attribute("aria-valuenow")) == pytest.approx(1.8)


def test_a_figure_that_comes_later_has_handles_and_without_a_script_there_is_the_picture(page, chromium):
    page.show()
    page.evaluate("html => { document.body.innerHTML = html; }", held()._repr_html_())
    page.wait_for_selector("figure.drag[data-held=yes]")
    assert page.get_by_role("slider").count() == 3
    context = chromium.new_context(java_script_enabled=False)
    plain = context.new_page()
    plain.set_content(held()._repr_html_())
    assert plain.get_by_role("img", name=ALT).count() == 1
    assert plain.get_by_text("Drag the round handles").count() == 0
    context.close()
