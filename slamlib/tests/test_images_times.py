"""When pictures were taken: units, decimals, gaps and lists; what is guessed is said, what is not clear is refused."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from slamlib.datasets.times import of_file, of_list, of_names
from slamlib.errors import SlamlibError

START, STEP = 1_700_000_000, 1_000_000_000 // 30  # seconds, nanoseconds
WHOLE = [START * 10**9 + STEP * k for k in range(40)]  # nanoseconds


def named(words, form="{}.png"):
    return [form.format(word) for word in words]


def padded(digits):
    """Names as decimals of this many digits."""
    return [f"{n // 10**9}.{n % 10**9 // 10 ** (9 - digits):0{digits}}" for n in WHOLE]


@pytest.mark.parametrize("form", ["{}.png", "frame_{}.jpg", "cam0-{}-left.pgm"])
@pytest.mark.parametrize(
    ("words", "unit"),
    [
        (WHOLE, "nanoseconds"),
        ([n // 1000 for n in WHOLE], "microseconds"),
        ([n // 10**6 for n in WHOLE], "milliseconds"),
        (padded(9), "seconds"),
        (padded(3), "seconds"),
        ([f"{n // 10**9}_{n % 10**9:09}" for n in WHOLE], "seconds"),
        ([str(round(n / 1e9, 6)) for n in WHOLE], "seconds"),  # zeros at the end are lost
        ([f"{n // 10**9}.{n % 10**9}" for n in WHOLE], "seconds"),  # zeros at the start are
        ([f"{k / 30:.6f}" for k in range(40)], "seconds"),
        ([f"{1000 * k / 30:.1f}" for k in range(40)], "milliseconds"),
        ([STEP * k for k in range(40)], "nanoseconds"),
        ([round(k * 1e6 / 30) for k in range(40)], "microseconds"),
        ([word.replace(".", ",") for word in padded(6)], "seconds"),  # a decimal comma
        ([str(round(k / 30, 6)).replace(".", ",") for k in range(40)], "seconds"),
    ],
)
def test_names_that_are_times(words, unit, form):
    shuffled = np.random.default_rng(1).permutation(len(words))
    order, times = of_names([named(words, form)[i] for i in shuffled])
    assert shuffled[order].tolist() == list(range(40))
    assert times.stated
    np.testing.assert_allclose(np.diff(times.values), 1 / 30, atol=2e-3)
    assert times.guess.endswith(f"in {unit}: a picture every {times.interval:.3g} s")
    order, counted = of_names([named(words, form)[i] for i in shuffled], 20)
    assert shuffled[order].tolist() == list(range(40))
    assert counted.values[:3] == (0.0, 0.05, 0.1)  # a rate that is given is taken


def test_two_conventions_for_decimals_that_steps_do_not_tell_apart_are_refused():
    _, times = of_names(named(["7.5", "7.25", "8.125", "9.9", "9.11"]))
    assert "7.5.png and 8.125.png" in times.unclear
    assert "By neither" in times.unclear
    assert "--times" in times.unclear
    assert "By both" in of_names(named(["1.5", "1.25"]))[1].unclear
    assert not of_names(named(["1.5", "1.025"]))[1].unclear  # a count has no zero before it


def test_negative_numbers_of_frames():
    order, times = of_names(["-5.jpg", "-3.jpg", "-1.jpg", "1.jpg"], 10)
    assert (order, times.values) == ([0, 1, 2, 3], (0.0, 0.1, 0.2, 0.3))
    assert of_names(["view-1.jpg", "view-2.jpg"], 10)[1].unclear == ""
    assert "a dash before each number, or a minus?" in of_names(["-1.jpg", "-2.jpg"], 10)[1].unclear


@pytest.mark.parametrize(
    ("words", "places", "told"),
    [
        (["0", "1", "2", "3"], [0, 1, 2, 3], ""),
        (["007", "008", "009"], [0, 1, 2], ""),
        (["1", "2", "5", "6"], [0, 1, 4, 5], "have gaps, which take their time: one every 0.1 s"),
        (["0", "5", "10", "15"], [0, 1, 2, 3], "go by 5: one every 0.1 s"),
        (["0", "5", "10", "20"], [0, 1, 2, 4], "have gaps"),
        (["0", "33", "67", "100"], [0, 33, 67, 100], "one every 3.3 s"),
        (["1.1", "1.2", "1.10", "1.11"], [0, 1, 2, 3], ""),  # shot 1, picture 10
        (["1.0001", "1.0002", "1.0003"], [0, 1, 2], ""),
        (["1_7", "2_9", "3_1"], [0, 1, 2], ""),
        (["a", "b", "c"], [0, 1, 2], ""),
    ],
)
def test_numbers_of_frames(words, places, told):
    order, times = of_names(named(words), 10)
    assert order == list(range(len(words)))
    assert times.values == tuple(place / 10 for place in places)
    assert not times.stated
    assert told in times.guess
    assert bool(told) == bool(times.guess)
    assert "30 pictures a second are assumed" in of_names(named(words))[1].guess


def test_a_number_of_the_frame_beside_the_time():
    order, times = of_names([f"{k:04}_{n}.png" for k, n in enumerate(WHOLE)])
    assert order == list(range(40))
    assert times.interval == pytest.approx(1 / 30)
    assert times.stated


@settings(max_examples=200, deadline=None, derandomize=True, database=None)
@given(
    st.lists(st.text("019.-_e\u00b2\u0665a", max_size=24), min_size=1, max_size=8, unique=True),
    st.sampled_from([None, 9]),
)
def test_whatever_the_names_each_picture_has_its_place_and_time(words, fps):
    order, times = of_names(named(words), fps)
    assert sorted(order) == list(range(len(words)))
    assert len(times.values) == len(words)
    assert times.unclear or (np.diff(times.values) > 0).all()
    assert times.interval > 0


@pytest.mark.parametrize(
    ("values", "stated", "found"),
    [
        ([START + k / 30 for k in range(5)], "seconds", ""),
        ([START * 1e3 + 5 * k for k in range(5)], "seconds", "milliseconds"),  # 5 s would be a film's, too
        ([START * 1e6 + 33333 * k for k in range(5)], "seconds", "microseconds"),
        ([START * 1e9 + 33333333 * k for k in range(5)], "seconds", "nanoseconds"),
        ([START + k / 30 for k in range(5)], "nanoseconds", "seconds"),
        ([START * 1e3 + 50 * k for k in range(5)], "nanoseconds", "milliseconds"),
        ([1.4e12 + 5e7 * k for k in range(5)], "nanoseconds", ""),  # since the start of a computer
        ([33.3 * k for k in range(5)], "seconds", "milliseconds"),
        ([START + 60 * k for k in range(5)], "seconds", "every 60 s"),  # time lapse
        ([5 * k for k in range(5)], "seconds", "every 5 s"),
    ],
)
def test_the_unit_of_a_list(values, stated, found):
    times = of_list(values, named(range(5)), Path("there/rgb.txt"), stated)
    assert found in times.guess
    assert bool(found) == bool(times.guess)
    assert 1e-3 < times.interval <= 60
    assert not found or times.guess.startswith("rgb.txt: ")


@pytest.mark.parametrize("values", [[0, 1e-12, 2e-12], [0, 1e15, 2e15]])
def test_a_list_in_no_unit_is_refused(values):
    with pytest.raises(SlamlibError, match=r"rgb\.txt: a picture every 1e.* s, if its times are seconds; in none of"):
        of_list(values, named(range(3)), Path("rgb.txt"))
    with pytest.raises(SlamlibError, match="times must grow"):
        of_list([0, 1, np.inf], named(range(3)), Path("rgb.txt"))


@pytest.mark.parametrize(
    "text",
    [
        "0.1\n0.2\n0.4\n",
        "# a comment\n100\n\n200\n400\n",
        "time,file\r\n0.1,a.png\r\n0.4,c.png\r\n0.2,b.png\r\n",
        "somewhere/b.png 0.2\nsomewhere/a.png 0.1\nsomewhere/c.png 0.4\nothers/d.png 0.9\n",
        "a 0.1 12.5\nb 0.2 12.5\nc 0.4 12.5\n",  # with exposures, as in TUM's monocular data set
        "\ufefftime;file\n0.1;a\n0.2;b\n0.4;c\n",
    ],
)
def test_a_file_of_times(text, tmp_path):
    (tmp_path / "times.txt").write_text(text, "utf-8")
    order, times = of_file(tmp_path / "times.txt", ["a.png", "b.png", "c.png"])
    assert order == [0, 1, 2]
    np.testing.assert_allclose(times.values, (0.1, 0.2, 0.4))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1\n2\n", "has 2 times, and there are 3 pictures"),
        ("1 a.png\n2 b.png\n3 d.png\n", "has 3 rows, and no time for 1 of the 3 pictures, such as c.png"),
        ("0 0.1\n1 0.2\n2 0.3\n", "no time for 3 of the 3"),
        ("0,5 a.png\n1,7 b.png\n2,9 c.png\n", "line 1: 0,5 has a decimal comma: write numbers with points, as 0.5"),
        ("# ours\n0;a.png\n1,7;b.png\n2,9;c.png\n", "line 3: 1,7 has a decimal comma"),
        ("a.png 0\nb.png soon\nc.png 2\n", "line 2: 'soon' is no time"),
        ("1\n1\n2\n", "times must grow, but a.png"),
        ("", "lists no picture"),
    ],
)
def test_files_of_times_that_do_not_fit(text, message, tmp_path):
    (tmp_path / "times.txt").write_text(text, "utf-8")
    with pytest.raises(SlamlibError, match=message):
        of_file(tmp_path / "times.txt", ["a.png", "b.png", "c.png"])
