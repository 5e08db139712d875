"""Tables of results: the same cells as text and as HTML."""

import re

import pytest
from slambook.tables import decisive, table

from slamlib.errors import SlamlibError

COLUMNS = {"50 runs": "", "error [m]": ".2f", "inside": ".0%"}
ROWS = ["two laps", ("EKF", 0.3149, decisive(0.42)), ("<right>", 12.0, None), ("alone", "lost", decisive(0.9, False))]


def test_text_is_aligned_and_marks_what_decides():
    assert repr(table(COLUMNS, ROWS, note="of <60> steps")).splitlines() == [
        "50 runs  error [m]  inside",
        "two laps",
        "EKF           0.31    42%*",
        "<right>      12.00       -",
        "alone         lost     90%",
        "of <60> steps",
    ]


def test_html_has_the_same_cells_and_heads_of_rows_and_columns():
    html = table(COLUMNS, ROWS, note="of <60> steps")._repr_html_()
    assert "<caption>of &lt;60&gt; steps</caption><thead>" in html
    assert re.findall(r'<th scope="col"[^>]*>(.*?)</th>', html) == list(COLUMNS)
    assert re.findall(r'<th scope="row"[^>]*>(.*?)</th>', html) == ["EKF", "&lt;right&gt;", "alone"]
    assert '<th scope="rowgroup" colspan="3">two laps</th>' in html
    assert re.findall(r'<td class="number">(.*?)</td>', html) == [
        "0.31", "<strong>42%</strong>", "12.00", "-", "lost", "90%"
    ]  # fmt: skip
    assert "<thead><tr><td></td>" in table({"": "", "a": "d"}, [("b", 1)])._repr_html_()


def test_rows_that_do_not_fit_are_refused():
    with pytest.raises(SlamlibError, match=r"3 columns, but a row of 2: \['EKF', 1\]"):
        table(COLUMNS, [("EKF", 1)])
    with pytest.raises(SlamlibError, match="there are no rows"):
        table(COLUMNS, ["a heading alone"])
