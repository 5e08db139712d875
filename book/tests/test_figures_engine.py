"""What stands behind a figure: positions of data, ticks, layout, legends, contours, images, clear errors."""

import base64
import re
import struct
import zlib
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from slambook.figures import colors, paths
from slambook.figures import figure as empty
from slambook.figures.axis import SIZE
from slambook.figures.images import colored, png
from slambook.figures.legend import PLACES
from slambook.figures.scales import SCALES, DataView, spread
from slambook.figures.ticks import decades, labels, nice_ticks
from slambook.figures.words import Lettering, runs, width_of

from book.live.standin.axes import Axes
from book.live.standin.contours import contour_lines, regions
from slamlib.errors import NonFiniteError, ShapeError, SlamlibError, UnknownNameError

MINUS = "\N{MINUS SIGN}"
TOKEN = re.compile(r"([MmLlHhVvZz])|(-?(?:\d+\.?\d*|\.\d+))")


def figure(rows=1, columns=1, *, equal=False, **size):
    """A figure whose axes have all calls of the page's stand-in for matplotlib."""
    fig, axes = empty(rows, columns, kind=Axes, **size)
    for ax in fig.axes if equal else ():
        ax.set_aspect("equal", adjustable="datalim")
    return fig, axes


def vertices(data):
    """The lines of a path, each (N, 2), for the commands that slamlib writes."""
    lines, at, start, command, numbers = [], np.zeros(2), np.zeros(2), "", []
    for letter, digits in TOKEN.findall(data):
        if letter:
            command = letter
            if letter in "zZ":
                at = start
            continue
        numbers.append(float(digits))
        if len(numbers) < (1 if command in "hHvV" else 2):
            continue
        axis = {"h": [1, 0], "v": [0, 1]}.get(command.lower())
        step = np.array(numbers) if axis is None else np.array(axis) * numbers[0]
        keep = at if axis is None else at * (1 - np.array(axis))
        at = at + step if command.islower() else (step if axis is None else keep + step)
        if command in "mM":
            start = at
            lines.append([at])
            command = "l" if command == "m" else "L"
        else:
            lines[-1].append(at)
        numbers = []
    return [np.array(line) for line in lines]


def paths_of(fig, *, color):
    """The path elements of a figure in a colour of the palette."""
    svg = ElementTree.fromstring(fig.svg("A figure for a test."))
    return [e for e in svg.iter("path") if f"--figure-{color}" in e.get("style")]


def texts_of(fig):
    return [e for e in ElementTree.fromstring(fig.svg("A figure for a test.")).iter("text")]


def box_of(fig):
    """The place of the (first) axes' rectangle: left, top, right, bottom."""
    return fig.axes[0].view(fig._boxes()[0]).box


# -- positions of data ------------------------------------------------------------------------------------------------


def drawn_points(x, y, *, call="plot", **settings_):
    fig, ax = figure(equal=settings_.pop("equal", False))
    getattr(ax, call)(x, y, "-", color=colors.purple)
    inverted = settings_.pop("inverted", "")
    ax.set(**settings_)
    for name in inverted:
        getattr(ax, f"invert_{name}axis")()
    (path,) = paths_of(fig, color="purple")
    left, top, right, bottom = box_of(fig)
    (line,) = vertices(path.get("d"))
    return (line - [left, bottom]) / [right - left, top - bottom]


def test_linear_axes_put_data_where_they_belong():
    shares = drawn_points([0, 1, 4], [10, 30, 20], xlim=(-1, 4), ylim=(10, 50))
    np.testing.assert_allclose(shares, [[0.2, 0], [0.4, 0.5], [1, 0.25]], atol=1e-4)


def test_logarithmic_axes_put_data_where_they_belong():
    shares = drawn_points([1, 10, 1000], [1e-8, 1e-4, 1e-2], call="loglog", xlim=(1, 1e4), ylim=(1e-8, 1))
    np.testing.assert_allclose(shares, [[0, 0], [0.25, 0.5], [0.75, 0.75]], atol=1e-4)
    shares = drawn_points([0, 1, 2], [1, 10, 1], call="semilogy", xlim=(0, 2), ylim=(1, 100))
    np.testing.assert_allclose(shares, [[0, 0], [0.5, 0.5], [1, 0]], atol=1e-4)


def test_inverted_axes_run_backwards():
    shares = drawn_points([0, 1, 4], [0, 3, 1], xlim=(0, 4), ylim=(0, 4), inverted="xy")
    np.testing.assert_allclose(shares, [[1, 1], [0.75, 0.25], [0, 0.75]], atol=1e-4)
    np.testing.assert_allclose(drawn_points([1, 2], [1, 2], xlim=(4, 0), ylim=(0, 4))[:, 0], [0.75, 0.5], atol=1e-4)


def test_free_limits_leave_a_margin_and_grow_to_the_ticks():
    _, ax = figure()
    ax.plot([0, 10], [-1, 1])
    assert ax.get_xlim() == pytest.approx((-0.5, 10.5))
    ax.set(yticks=[-4, 0, 4], xlim=(0, None))
    assert ax.get_ylim() == (-4, 4)
    assert ax.get_xlim() == pytest.approx((0, 10.5))
    ax.set(xlim=(20, None))  # beyond the data
    low, high = ax.get_xlim()
    assert low == 20 < high
    bars = figure()[1]
    bars.bar([1, 2], [3, 4])
    assert bars.get_ylim() == pytest.approx((0, 4.2))  # they stand on their end of the axis


@pytest.mark.parametrize("fixed", [True, False])
def test_a_metre_is_a_metre_on_both_axes_of_a_map(fixed):
    fig, ax = figure(equal=True)
    ax.plot([0, 4, 4, 0, 0], [0, 0, 1, 1, 0], color=colors.purple)
    if fixed:
        ax.set(xlim=(0, 4), ylim=(0, 1), adjustable="box")
    line = vertices(paths_of(fig, color="purple")[0].get("d"))[0]
    wide, high = np.ptp(line, axis=0)
    assert wide / 4 == pytest.approx(high, rel=1e-3)
    left, top, right, bottom = box_of(fig)
    assert ((right - left) / (bottom - top) == pytest.approx(4, rel=1e-3)) == fixed  # else the limits give way


def test_an_image_is_not_padded_to_fill_its_place():
    fig, ax = figure()
    ax.imshow(np.zeros((10, 20)))
    left, top, right, bottom = box_of(fig)
    assert (right - left) / (bottom - top) == pytest.approx(2, rel=1e-3)
    assert ax.get_ylim() == (9.5, -0.5)


def test_coordinates_are_kept_to_a_hundredth_of_a_point():
    x = np.array([0.123456789, 0.5, 0.9])
    fig, ax = figure()
    ax.plot(x, [0, 1, 0], color=colors.purple)
    ax.set(xlim=(0, 1), ylim=(0, 1))
    left, top, right, bottom = box_of(fig)
    data = paths_of(fig, color="purple")[0].get("d")
    assert not re.search(r"\.\d{3}", data)
    wanted = np.stack([left + x * (right - left), [bottom, top, bottom]], axis=1)
    np.testing.assert_allclose(vertices(data)[0], wanted, atol=0.0051)


@given(st.lists(st.floats(-1e4, 1e4), min_size=2, max_size=40))
def test_written_numbers_are_the_nearest_hundredths(values):
    for value in values:
        text = paths.number(value)
        assert float(text) == pytest.approx(value, abs=0.00501)
        assert not text.startswith("-0.00")
        assert text not in ("-0", "", "-")
    whole = [round(100 * v) for v in values]
    read = [float(d) for _, d in TOKEN.findall(paths.joined(whole))]
    assert read == pytest.approx([w / 100 for w in whole])


@given(st.integers(0, 2**32 - 1), st.integers(3, 400), st.floats(0.01, 20))
@settings(max_examples=60, deadline=None)
def test_thinning_moves_nothing_by_more_than_a_fifth_of_a_point(seed, count, step):
    rng = np.random.default_rng(seed)
    line = np.cumsum(step * rng.standard_normal((2, count)), axis=1)
    thin = paths.thinned(line)
    np.testing.assert_array_equal(thin[:, [0, -1]], line[:, [0, -1]])
    distance = np.min([paths._from_segments(line, a[:, None], b[:, None]) for a, b in pairwise(thin.T)], axis=0)
    assert distance.max() <= 0.2**2


def test_a_long_line_is_thinned_below_what_a_reader_sees():
    t = np.linspace(0, 1, 50_001)
    fig, ax = figure()
    ax.plot(t, np.sin(20 * t), color=colors.purple)
    assert len(paths_of(fig, color="purple")[0].get("d")) < 4_000


def test_nan_breaks_a_line_and_empty_data_are_fine():
    fig, ax = figure()
    ax.plot([0, 1, np.nan, 3, 4, np.nan, 6], [0, 1, 2, 3, 4, 5, 6], color=colors.purple)
    ax.plot([], [], "o-", label="nothing")
    ax.scatter([], [])
    ax.fill_between([], [])
    ax.plot([np.nan], [np.nan], "x")
    lines = [line for path in paths_of(fig, color="purple") for line in vertices(path.get("d"))]
    assert [len(line) for line in lines] == [2, 2]
    assert "<svg" in figure()[0].svg("An empty figure.")


def test_huge_values_keep_their_direction_and_do_not_break_the_file():
    fig, ax = figure()
    ax.plot([0, 1e9], [0, 5e8], color=colors.purple)
    ax.plot([-1e300, 0.5, 1e300], [1e300, 0.5, -1e300])
    ax.fill([0, 1e200, 1e200, 0], [0, 0, 1e200, 1e200])
    ax.set(xlim=(0, 1), ylim=(0, 1))
    line = vertices(paths_of(fig, color="purple")[0].get("d"))[0]
    left, top, right, bottom = box_of(fig)
    share = (line - [left, bottom]) / [right - left, top - bottom]
    assert share[-1, 1] / share[-1, 0] == pytest.approx(0.5, abs=1e-3)
    numbers = [
        float(d)
        for p in ElementTree.fromstring(fig.svg("Huge.")).iter("path")
        for line in vertices(p.get("d"))
        for d in line.ravel()
    ]
    assert np.abs(numbers).max() < 2000


def test_lines_are_cut_at_the_edge_of_what_is_seen():
    box = (0.0, 0.0, 10.0, 10.0)
    parts = paths.cut_line(np.array([[-5, 5, 5, 15, 15, 5], [5, 5, 20, 20, 5, 5.0]]), box)
    np.testing.assert_allclose(np.concatenate(parts, axis=1), [[0, 5, 5, 10, 5], [5, 5, 10, 5, 5]])
    assert [p.shape[1] for p in parts] == [3, 2]
    square = paths.cut_area(np.array([[-5, 5, 5, -5], [-5, -5, 5, 5.0]]), box)
    assert sorted(map(tuple, square.T.tolist())) == [(0, 0), (0, 5), (5, 0), (5, 5)]
    assert paths.cut_area(np.array([[-5, -1, -1], [5, 5, 6.0]]), box).shape[1] == 0


def test_marks_end_where_the_axes_end_unless_they_are_let_out():
    fig, ax = figure()
    ax.plot([0, 1], [0, 2], color=colors.purple)
    ax.plot(1, 0.5, "o", color=colors.red, clip_on=False)
    ax.set(xlim=(0, 1), ylim=(0, 1))
    svg = ElementTree.fromstring(fig.svg("A line that is cut."))
    (group,) = (g for g in svg.iter("g") if g.get("clip-path"))
    inside = "".join(e.get("style") for e in group.iter("path"))
    assert "--figure-purple" in inside
    assert "--figure-red" not in inside
    clip = next(svg.iter("clipPath"))[0]
    left, top, right, bottom = box_of(fig)
    place = [float(clip.get(k)) for k in ("x", "y", "width", "height")]
    assert place == pytest.approx([left, top, right - left, bottom - top], abs=0.011)


def test_many_points_are_one_path_and_translucent_ones_darken_where_they_meet():
    rng = np.random.default_rng(0)
    x, y = rng.random((2, 800))
    fig, ax = figure()
    ax.plot(x, y, ".", color=colors.purple)
    (path,) = paths_of(fig, color="purple")
    assert len(path.get("d")) < 12_000
    assert len(vertices(path.get("d"))) == 800
    fig, ax = figure()
    ax.plot([0, 0, 1], [0, 0, 1], "o", ms=4, color=colors.purple, alpha=0.5)
    layers = [np.concatenate(vertices(p.get("d"))) for p in paths_of(fig, color="purple")]
    places = [tuple(p) for layer in layers for p in np.unique(layer, axis=0)]
    assert sorted(places.count(p) for p in set(places)) == [1, 2]


def test_stairs_bars_and_counts():
    fig, ax = figure()
    counts, edges, _ = ax.hist([1, 1, 2, 5], bins=4, range=(1, 5), color=colors.purple)
    assert counts.tolist() == [2, 1, 0, 1]
    assert edges.tolist() == [1, 2, 3, 4, 5]
    tops = [line[:, 1].min() for line in vertices(paths_of(fig, color="purple")[0].get("d"))]
    heights = box_of(fig)[3] - np.array(tops)
    np.testing.assert_allclose(heights / heights[0], [1, 0.5, 0, 0.5], atol=1e-3)
    _, ax = figure()
    for where, corners in (("pre", [[0, 0, 1], [1, 2, 2]]), ("post", [[0, 1, 1], [1, 1, 2]])):
        (line,) = ax.step([0, 1], [1, 2], where=where)
        np.testing.assert_array_equal([line.x, line.y], corners)
    (line,) = ax.step([0, 2], [1, 2], where="mid")
    np.testing.assert_array_equal([line.x, line.y], [[0, 1, 1, 2], [1, 1, 2, 2]])


def test_bands_reach_across_the_axes_and_are_in_the_legend():
    fig, ax = figure()
    ax.plot([0, 10], [0, 10])
    ax.axhspan(2, 4, color=colors.purple, label="band")
    ax.axvline(5, color=colors.red)
    ax.legend()
    left, top, right, bottom = box_of(fig)
    band = vertices(paths_of(fig, color="purple")[0].get("d"))[0]
    assert (band[:, 0].min(), band[:, 0].max()) == pytest.approx((left, right), abs=0.011)
    view = fig.axes[0].view(box_of(fig))
    assert sorted({round(v, 1) for v in band[:, 1]}) == sorted(
        round(float(v), 1) for v in view.points(0, np.array([2, 4]))[1]
    )
    rule = vertices(paths_of(fig, color="red")[0].get("d"))[0]
    assert sorted(rule[:, 1]) == pytest.approx([top, bottom], abs=0.011)
    assert "band" in [t.text for t in texts_of(fig)]


def test_words_beside_the_axes_have_room_and_words_at_unseen_points_are_not_seen():
    fig, ax = figure()
    ax.set(xlim=(0, 1), ylim=(0, 1))
    before = box_of(fig)
    ax.text(7, 7, "far away")
    assert box_of(fig) == before
    assert "far away" not in [t.text for t in texts_of(fig)]
    ax.text(1.02, 0.5, "beside the axes", transform=ax.transAxes, fontsize=9)
    (words,) = (t for t in texts_of(fig) if t.text == "beside the axes")
    assert box_of(fig)[2] < float(words.get("x"))
    assert float(words.get("x")) + width_of(words.text, 9) <= fig.width


def test_an_arrow_points_from_its_words_to_its_point():
    fig, ax = figure()
    ax.annotate("", xy=(0.8, 0.5), xytext=(0.2, 0.5), arrowprops={"arrowstyle": "->", "color": colors.purple, "lw": 2})
    ax.set(xlim=(0, 1), ylim=(0, 1))
    shaft, head = (vertices(p.get("d"))[0] for p in paths_of(fig, color="purple"))
    left, top, right, bottom = box_of(fig)
    height = (top + bottom) / 2
    ends = [[left + 0.2 * (right - left) + 2, height], [left + 0.8 * (right - left) - 2, height]]
    np.testing.assert_allclose(shaft, ends, atol=0.011)
    np.testing.assert_allclose(head[1], shaft[1], atol=0.011)
    assert (head[[0, 2], 0] < head[1, 0]).all()


# -- ticks and words ---------------------------------------------------------------------------------------------------


@given(st.floats(-1e6, 1e6), st.floats(-9, 9), st.integers(4, 7))
@settings(max_examples=300, deadline=None)
def test_ticks_are_round_and_few_and_within_the_limits(low, exponent, most):
    high = low + 10.0**exponent
    assume(high - low > 1e-9 * abs(low))
    places = nice_ticks(low, high, most)
    assert 2 <= len(places) <= most + 2
    assert low <= places.min() < places.max() <= high
    step = float(np.diff(places).mean())
    np.testing.assert_allclose(np.diff(places), step, rtol=1e-4)
    mantissa = step / 10.0 ** np.floor(np.log10(step) + 1e-3)
    assert min(abs(mantissa / m - 1) for m in (1, 2, 2.5, 5, 10)) < 1e-3
    names = labels(places)
    assert len(set(names)) == len(names)
    assert f"{MINUS}0" not in [n.rstrip(".0") + "0" for n in names if not n.strip(f"{MINUS}.0")]


@given(st.floats(-300, 300), st.floats(0.001, 60), st.integers(4, 7))
@settings(max_examples=300, deadline=None)
def test_logarithmic_ticks_are_round_and_few_and_within_the_limits(start, reach, most):
    low, high = 10.0**start, 10.0 ** min(start + reach, 307)
    assume(high > low * 1.001)
    places = decades(low, high, most)
    assert 2 <= len(places) <= most + 2
    assert low * (1 - 1e-8) <= places.min() < places.max() <= high * (1 + 1e-8)
    assert (np.diff(places) > 0).all()


def test_what_ticks_say():
    assert labels([-0.5, 0.0, 0.5]) == [f"{MINUS}0.5", "0.0", "0.5"]
    assert labels([0, 0.125, 1]) == ["0.000", "0.125", "1.000"]
    assert labels([1899, 1900]) == ["1899", "1900"]
    assert labels([0, 2e7, 4e7]) == ["0", "2·$10^{7}$", "4·$10^{7}$"]
    assert labels([1000000, 1000002]) == ["1000000", "1000002"]  # no offset to be added in the head
    assert labels([-2.5e-5, 0]) == [f"{MINUS}2.5·$10^{{-5}}$", "0"]
    assert SCALES["log"].labels(np.array([1e-3, 1.0, 1e3])) == ["$10^{-3}$", "$10^{0}$", "$10^{3}$"]
    assert SCALES["log"].labels(np.array([1.0, 2.0, 5.0])) == ["1", "2", "5"]
    assert decades(1, 1000).tolist() == [1, 10, 100, 1000]
    assert decades(0.9, 6).tolist() == [1, 2, 5]


def test_a_power_is_raised_and_its_sign_is_a_minus():
    fig, ax = figure()
    ax.loglog([1e-6, 1], [1, 2])
    powers = [t for t in texts_of(fig) if len(t)]
    assert powers
    (raised,) = powers[0]
    assert raised.text.startswith(MINUS)
    assert float(raised.get("dy")) < 0
    assert 0.5 * SIZE < float(re.search(r"font-size:([\d.]+)px", raised.get("style"))[1]) < 0.8 * SIZE


def test_given_ticks_and_names_are_kept():
    fig, ax = figure()
    ax.set(xlim=(0, 3), xticks=[0, 1, 2, 5], xticklabels=["none", "one", "two", "five"])
    said = [t.text for t in texts_of(fig)]
    assert {"none", "one", "two"} <= set(said)
    assert "five" not in said
    with pytest.raises(ShapeError, match="xticklabels: give xticks first, as many as labels"):
        ax.set(xticklabels=["a"])


@pytest.mark.parametrize("named", [lambda set_ticks: set_ticks([1, 2], labels=["p", "q"]),
                                   lambda set_ticks: set_ticks([1, 2], ["p", "q"])])  # fmt: skip
def test_ticks_and_their_names_are_given_in_one_call(named):
    for name in "xy":
        fig, ax = figure()
        ax.set(xlim=(0, 3), ylim=(0, 3), xticks=[], yticks=[])
        named(getattr(ax, f"set_{name}ticks"))
        assert {t.text for t in texts_of(fig)} - {""} == {"p", "q"}


@pytest.mark.parametrize(
    ("ticks", "names"),
    [({}, {"0.0", "0.5", "1.0", "1.5", "2.0"}), ({"yticks": [0, 1, 2]}, {"0", "1", "2"}), ({"yticks": []}, set())],
)
def test_ticks_without_names_keep_their_marks(ticks, names):
    """As of an axis whose neighbour says what its own ticks are: `ax.set(yticklabels=[])`."""
    (named, with_names), (silent, without) = figure(), figure()
    for ax in (with_names, without):
        ax.set(xlim=(0, 3), ylim=(0, 2), xticks=[], **ticks)
    without.set(yticklabels=[])
    assert {t.text for t in texts_of(named)} - {""} == names
    assert {t.text for t in texts_of(silent)} - {""} == set()
    marks = [len(re.findall("<line|<path", fig.svg("Marks."))) for fig in (named, silent)]
    assert marks[0] == marks[1]


def test_mathematics_in_words():
    assert [(r.text, r.level, r.italic) for r in runs(r"rate $\sigma_x^2 = 10^{-3}$ m")] == [
        ("rate ", 0, False),
        ("\N{GREEK SMALL LETTER SIGMA}", 0, True),
        ("x", -1, True),
        ("2", 1, False),
        (" = 10", 0, False),
        (f"{MINUS}3", 1, False),
        (" m", 0, False),
    ]
    assert runs("5 $ a day")[0].text == "5 $ a day"
    with pytest.raises(UnknownNameError, match=r"unknown command in \$...\$ '\\\\sgima'; did you mean"):
        runs(r"$\sgima$")
    assert width_of("mm", 10) > width_of("ii", 10) > 0


LABEL = st.text(st.characters(codec="utf-8", exclude_characters="$\\"), max_size=60) | st.sampled_from(
    ["", "a\nb", "w" * 300]
)


@example("a", "b", "c", 5e-324, None)
@given(LABEL, LABEL, LABEL, st.floats(-1e9, 1e9), st.sampled_from([None, "best", "center right"]))
@settings(max_examples=60, deadline=None)
def test_no_word_leaves_the_sheet_and_every_file_is_well_formed(title, xlabel, ylabel, scale, loc):
    fig, axes = figure(1, 2, width=4, height=2.5)
    for ax in axes:
        ax.plot([0, scale], [0, 1], label=title or "a")
        ax.text(scale, 1, xlabel, ha="right", rotation=30)
        ax.set(title=title, xlabel=xlabel, ylabel=ylabel)
        if loc:
            ax.legend(loc=loc)
    svg = ElementTree.fromstring(fig.svg("Words everywhere."))
    width, height = (float(v) for v in svg.get("viewBox").split()[2:])
    parents = {id(child): parent for parent in svg.iter() for child in parent}
    for text in svg.iter("text"):
        turn = re.match(r"rotate\((\S+) ", text.get("transform") or "")
        anchor = {e: a for a, e in (("left", "start"), ("center", "middle"), ("right", "end"))}
        style = text.get("style") or parents[id(text)].get("style")
        side = anchor[(re.search(r"text-anchor:(\w+)", style) or ["", "start"])[1]]
        size = float(re.search(r"font-size:([\d.]+)px", style)[1])
        look = Lettering(size, ha=side, turned=-float(turn[1]) if turn else 0.0)
        raised = "".join("".join(part.itertext()) for part in text if "font-size" in (part.get("style") or ""))
        words = "".join(text.itertext()).replace(raised, f"$^{{{raised}}}$" if raised else "")
        left, top, right, bottom = look.box(float(text.get("x")), float(text.get("y")), words)
        assert left >= -0.2
        assert right <= width + 0.2
        assert top >= -0.5 * look.size
        assert bottom <= height + 0.2


# -- layout and legend -------------------------------------------------------------------------------------------------


def test_axes_of_a_grid_are_equally_large_and_do_not_touch():
    fig, axes = figure(2, 3, width=6.4, height=4)
    for i, ax in enumerate(axes.ravel()):
        ax.plot([0, 10.0**i], [0, 1])
        ax.set(xlabel="x", ylabel="y", title=f"{i}")
    boxes = np.array(fig._boxes()).reshape(2, 3, 4)
    widths, heights = boxes[..., 2] - boxes[..., 0], boxes[..., 3] - boxes[..., 1]
    np.testing.assert_allclose(widths, widths[0, 0])
    np.testing.assert_allclose(heights, heights[0, 0])
    assert (boxes[:, 1:, 0] - boxes[:, :-1, 2] > 20).all()
    assert (boxes[1:, :, 1] - boxes[:-1, :, 3] > 20).all()
    assert boxes.min() > 0
    assert boxes[..., 2].max() < fig.width


def test_axes_come_as_one_a_row_or_a_table():
    assert figure()[1].marks == []
    assert figure(1, 2)[1].shape == (2,)
    assert figure(2, 1)[1].shape == (2,)
    assert figure(2, 2)[1].shape == (2, 2)
    for wrong in ({"rows": 0}, {"width": -1}, {"height": float("nan")}):
        with pytest.raises(SlamlibError, match="rows, columns and sizes are positive"):
            figure(**wrong)


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=40, deadline=None)
def test_the_best_place_of_a_legend_covers_no_more_than_any_corner(seed):
    rng = np.random.default_rng(seed)
    fig, ax = figure()
    ax.plot(*rng.random((2, 30)) ** rng.uniform(0.2, 4, (2, 1)), "o", label="some points")
    ax.plot(np.sort(rng.random(5)), rng.random(5), label="a line")
    key = ax.legend()
    view = ax.view(fig._boxes()[0])
    size = key._size(300.0)[2]
    ink = np.concatenate([mark.ink(view) for mark in ax.marks], axis=1)
    chosen = key.covered(ink, key.place(ax.marks, view, size))
    assert chosen == min(key.covered(ink, key._box(view, size, loc)) for loc in PLACES)


@pytest.mark.parametrize("loc", ["upper left", "upper right", "lower left", "lower right"])
def test_a_legend_stands_in_its_corner_on_the_page_s_paper(loc):
    fig, ax = figure()
    ax.plot([0, 1], [0, 1], label="line")
    ax.plot([0, 1], [1, 0], label="_hidden")
    ax.legend(loc=loc)
    svg = ElementTree.fromstring(fig.svg("A legend."))
    (ground,) = (r for r in svg.findall("rect"))
    assert "--figure-paper" in ground.get("style")
    assert "fill-opacity" in ground.get("style")
    x, y, wide, high = (float(ground.get(k)) for k in ("x", "y", "width", "height"))
    left, top, right, bottom = box_of(fig)
    across = x - left if "left" in loc else right - x - wide
    down = y - top if "upper" in loc else bottom - y - high
    assert (across, down) == pytest.approx((4, 4), abs=0.02)
    assert "_hidden" not in [t.text for t in texts_of(fig)]


def test_a_legend_goes_where_it_is_wanted_and_enlarges_its_marks():
    fig, ax = figure()
    ax.plot([0, 1], [0, 1], ".", ms=2, label="dots", color=colors.purple)
    ax.legend(loc=(0.2, 0.3), markerscale=4)
    (ground,) = ElementTree.fromstring(fig.svg("A legend.")).findall("rect")
    left, top, right, bottom = box_of(fig)
    corner = float(ground.get("x")), float(ground.get("y")) + float(ground.get("height"))
    assert corner == pytest.approx((left + 0.2 * (right - left) + 4, bottom - 0.3 * (bottom - top) - 4), abs=0.02)
    widths = [float(re.search(r"stroke-width:([\d.]+)", p.get("style"))[1]) for p in paths_of(fig, color="purple")]
    assert widths == [2, 5]  # half the size, and a pen of one point


def test_a_legend_beside_the_axes_has_room_there():
    fig, ax = figure()
    ax.plot([0, 1], [0, 1], label="a line with a name")
    ax.legend(loc="upper left", bbox_to_anchor=(1, 1))
    right = box_of(fig)[2]
    (text,) = (t for t in texts_of(fig) if t.text == "a line with a name")
    assert float(text.get("x")) > right
    assert float(text.get("x")) + width_of(text.text, 10) <= fig.width


# -- contours, images --------------------------------------------------------------------------------------------------


def grid(count=41):
    return np.meshgrid(np.linspace(-2, 2, count), np.linspace(-2, 2, count))


@pytest.mark.parametrize("radius", [0.3, 1.0, 1.9])
def test_the_contour_of_a_paraboloid_is_a_circle(radius):
    x, y = grid()
    (line,) = contour_lines(x, y, -(x**2 + y**2), -(radius**2))
    assert np.array_equal(line[:, 0], line[:, -1])
    np.testing.assert_allclose(np.hypot(*line), radius, atol=0.1**2)  # the step is 0.1
    area = np.sum(line[0, :-1] * line[1, 1:] - line[0, 1:] * line[1, :-1]) / 2
    assert area == pytest.approx(np.pi * radius**2, rel=0.05)  # positive: the higher side is on the left


def test_contours_are_open_at_the_rim_and_regions_are_closed_there():
    x, y = grid()
    (line,) = contour_lines(x, y, x, 1.05)
    np.testing.assert_allclose(line[0], 1.05)
    assert sorted(line[1, [0, -1]]) == [-2, 2]
    (ring,) = regions(x, y, x, 1.05)
    assert np.array_equal(ring[:, 0], ring[:, -1])
    assert (ring[0].min(), ring[0].max(), ring[1].min(), ring[1].max()) == pytest.approx((1.05, 2, -2, 2))
    (ring,) = regions(x, y, x, -9.0)
    assert np.ptp(ring, axis=1) == pytest.approx([4, 4])
    assert regions(x, y, x, 9.0) == []


def test_regions_have_holes_and_saddles_and_gaps():
    x, y = grid(81)
    rings = regions(x, y, -np.abs(np.hypot(x, y) - 1.2), -0.3)
    assert sorted(round(float(np.hypot(*r).mean()), 1) for r in rings) == [0.9, 1.5]
    square = np.array([[0.0, 1.0], [0.0, 1.0]]), np.array([[0.0, 0.0], [1.0, 1.0]])
    saddle = np.array([[1.0, 0.0], [0.0, 1.0]])
    assert len(contour_lines(*square, saddle, 0.6)) == len(contour_lines(*square, saddle, 0.4)) == 2
    gap = np.ones((5, 5))
    gap[2, 2] = np.nan
    xs, ys = np.meshgrid(np.arange(5.0), np.arange(5.0))
    assert len(regions(xs, ys, gap, 0.5)) == 2


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=40, deadline=None)
def test_every_boundary_of_a_region_is_closed_and_lies_on_the_level(seed):
    values = np.random.default_rng(seed).standard_normal((7, 9))
    xs, ys = np.meshgrid(np.arange(9.0), np.arange(7.0))
    rings = regions(xs, ys, values, 0.1)
    signed = sum(np.sum(r[0, :-1] * r[1, 1:] - r[0, 1:] * r[1, :-1]) / 2 for r in rings)
    assert all(np.array_equal(r[:, 0], r[:, -1]) for r in rings)
    assert 0 <= signed <= 48
    complement = regions(xs, ys, -values, -0.1)
    other = sum(np.sum(r[0, :-1] * r[1, 1:] - r[0, 1:] * r[1, :-1]) / 2 for r in complement)
    assert signed + other == pytest.approx(48)


def test_filled_contours_are_bands_from_level_to_level():
    x, y = grid()
    fig, ax = figure(equal=True)
    areas = ax.contourf(x, y, np.exp(-(x**2) - y**2), levels=[0.1, 0.5, 1.01], colors=[colors.purple], alpha=0.25)
    assert len(areas) == len(paths_of(fig, color="purple")) == 2
    radii = [np.hypot(*ring).mean() for ring in (*areas[0].rings, areas[1].rings[0])]
    assert radii == pytest.approx(np.sqrt(-np.log([0.1, 0.5, 0.5])), abs=0.02)
    (top,) = (a for a in ax.contourf(x, y, x, levels=[0, 1], colors=["r"]))
    assert len(top.rings) == 2  # what is above the last level is left out
    assert top.holes


def decoded(data):
    """The pixels of a PNG of the kind that slamlib writes."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = {}, 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        name, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length : at + 12 + length])[0] == zlib.crc32(name + body)
        chunks[name], at = body, at + 12 + length
    columns, rows, depth, kind = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    assert depth == 8
    channels = {0: 1, 2: 3, 6: 4}[kind]
    lines = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(rows, 1 + channels * columns)
    assert (lines[:, 0] == 2).all()  # each row as its change from the one above
    pixels = np.cumsum(lines[:, 1:], axis=0, dtype=np.uint8).reshape(rows, columns, channels)
    return pixels[..., 0] if channels == 1 else pixels


@pytest.mark.parametrize("shape", [(3, 5), (4, 2, 3), (2, 3, 4), (1, 1)])
def test_a_png_decodes_to_its_pixels(shape):
    pixels = np.random.default_rng(0).integers(0, 256, shape).astype(np.uint8)
    np.testing.assert_array_equal(decoded(png(pixels)), pixels)


def test_an_image_is_embedded_in_its_place():
    array = np.array([[0.0, 1.0], [2.0, 4.0]])
    for options, wanted in (({}, [[0, 64], [128, 255]]), ({"origin": "lower"}, [[128, 255], [0, 64]])):
        fig, ax = figure()
        ax.imshow(array, **options)
        (image,) = ElementTree.fromstring(fig.svg("Four pixels.")).iter("image")
        pixels = decoded(base64.b64decode(image.get("href").removeprefix("data:image/png;base64,")))
        np.testing.assert_array_equal(pixels, wanted)  # the first row of the file is at the top of the page
        left, top, right, bottom = box_of(fig)
        place = [float(image.get(k)) for k in ("x", "y", "width", "height")]
        assert place == pytest.approx([left, top, right - left, bottom - top], abs=0.011)
    rgba = colored(np.array([[0.0, np.nan], [1.0, 2.0]]), "viridis")
    assert rgba[0, 1, 3] == 0
    assert rgba[0, 0].tolist() == [0x44, 0x01, 0x54, 255]
    with pytest.raises(SlamlibError, match=r"an image is \(rows, columns\)"):
        ax.imshow(np.zeros(3))
    with pytest.raises(UnknownNameError, match="unknown cmap 'jet'"):
        ax.imshow(array, cmap="jet")


# -- clear errors ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda ax: ax.plot([1], [1], colour="r"), "unknown keyword of plot 'colour'; did you mean 'color'"),
        (lambda ax: ax.plot([1], [1], lw=1, linewidth=2), "linewidth is given twice"),
        (lambda ax: ax.plot([1], [1], "o~"), "unknown part of a line format '~'"),
        (lambda ax: ax.plot([1], [1], marker="h"), "unknown marker 'h'"),
        (lambda ax: ax.plot([1], [1], ls="dotte"), "unknown linestyle 'dotte'; did you mean 'dotted'"),
        (lambda ax: ax.plot([1], [1], color="blu"), "unknown color 'blu'; did you mean 'blue'"),
        (lambda ax: ax.plot([1], [1], color=(2, 0, 0)), "unknown color"),
        (lambda ax: ax.plot([1], [1], alpha=2), "alpha is an opacity between 0 and 1, got 2"),
        (lambda ax: ax.plot([1], [1], lw=-1), "linewidth is a size in points, at least 0, got -1"),
        (lambda ax: ax.plot([1, 2], [1, 2, 3]), "x and y should have the same length, got 2 and 3"),
        (lambda ax: ax.plot([1, 2], [1, np.inf]), r"plot: y\[1\] is inf: leave it out, or put nan for a gap"),
        (lambda ax: ax.plot(["a"], [1]), "plot: x should be real numbers, not"),
        (lambda ax: ax.plot([1j], [1]), "plot: x should be real numbers, not complex128"),
        (lambda ax: ax.plot(1, 2, 3), "plot takes y, or x and y, and a format; got 3 arrays"),
        (lambda ax: ax.scatter([1, 2], [1, 2], c=["r"]), "2 points need one color or 2, got 1"),
        (
            lambda ax: ax.fill_between([1, 2], [1, 2, 3]),
            "fill_between: these should have the same length: x 2, y1 3, y2 1",
        ),
        (lambda ax: ax.axhline(np.inf), r"axhline: y\[\] is inf"),
        (lambda ax: ax.step([1], [1], where="now"), "unknown where of step 'now'"),
        (lambda ax: ax.set(xlabl="x"), "unknown keyword of set 'xlabl'; did you mean 'xlabel'"),
        (lambda ax: ax.set(xlim=(1, 1)), "xlim: the ends should be two different numbers"),
        (lambda ax: ax.set(xscale="logit"), "unknown xscale 'logit'; did you mean 'log'"),
        (lambda ax: ax.plt([1], [1]), "stand-in and has no plt in axes; .* did you mean 'plot'"),
        (lambda ax: ax.legend(loc="top"), "unknown loc of legend 'top'"),
        (lambda ax: ax.legend(nclos=2), "unknown keyword of legend 'nclos'; did you mean 'ncols'"),
        (lambda ax: ax.set_aspect("wide"), "unknown aspect 'wide'"),
        (lambda ax: ax.set_aspect("equal", adjustable="x"), "unknown adjustable 'x'"),
        (lambda ax: ax.legend(bbox_to_anchor=(1, 1)), "loc says which corner"),
        (lambda ax: ax.text(0, 0, "a", ha="middle"), "unknown ha 'middle'"),
        (lambda ax: ax.annotate("a", (0, 0), (1, 1), arrowprops={"arrowstyle": "fancy"}), "unknown arrowstyle 'fancy'"),
        (lambda ax: ax.contour(np.zeros(3)), r"z should be \(rows, columns\)"),
        (lambda ax: ax.contourf(np.zeros((3, 3))), "z has one value only"),
        (lambda ax: ax.contourf(np.eye(3), levels=[1, 0]), "levels must increase"),
    ],
)
def test_misuse_is_named_with_what_is_possible(call, message):
    with pytest.raises(SlamlibError, match=message):
        call(figure()[1])


def test_infinity_has_its_own_error_and_unknown_calls_are_attribute_errors():
    fig, ax = figure()
    with pytest.raises(NonFiniteError):
        ax.plot([np.inf], [1])
    assert not hasattr(ax, "twinx")
    assert not hasattr(fig, "colorbar")
    assert not hasattr(ax, "_ipython_display_")
    with pytest.raises(SlamlibError, match="unknown call of a figure 'savefi'; did you mean 'savefig'"):
        fig.savefi("a.svg")
    ax.semilogx([1, 2], [1, 2])
    ax.set(xlim=(0, 1))
    with pytest.raises(SlamlibError, match="a logarithmic axis cannot span 0 to 1: both ends must be positive"):
        fig.svg("A figure for a test.")


def test_setters_exist_one_by_one():
    _, ax = figure()
    ax.set_xlim(0, 5)
    ax.set_ylabel("y [m]")
    ax.set_aspect("equal")
    ax.set_yscale("linear")
    assert (ax.get_xlim(), ax.y.label, ax.equal) == ((0, 5), "y [m]", True)


def test_spread_of_nothing_and_of_one_number():
    assert spread(np.nan, np.nan, SCALES["linear"]) == (0, 1)
    assert spread(np.nan, np.nan, SCALES["log"]) == (1, 10)
    low, high = spread(5.0, 5.0, SCALES["linear"])
    assert low < 5 < high
    low, high = spread(0.0, 0.0, SCALES["linear"])
    assert low < 0 < high
    view = DataView((0, 0, 10, 10), (1, 100), (0, 1), SCALES["log"], SCALES["linear"])
    floored = view.points(np.array([0.0]), np.array([0.5]), floored=True)  # no place on a logarithmic axis
    assert floored[:, 0].tolist() == [0, 5]
    assert np.isnan(view.points(np.array([-1.0]), np.array([0.5]))[0, 0])
