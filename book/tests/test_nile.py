"""The belief as a Kalman filter of the Nile's level, against numbers that another implementation printed."""

from pathlib import Path

import numpy as np
import pytest

import slamlib
from slamlib.belief import Belief

CSV = Path(slamlib.__file__).parent.parent / "book" / "chapters" / "data" / "nile.csv"
Q, R, PRIOR = 1469.1, 15099.0, 1e7  # Durbin and Koopman 2012, section 2.2

# statsmodels 0.15.0, UnobservedComponents(flow, "llevel") from N(0, 1e7): year -> filtered level, its variance.
WHOLE = {
    1871: (1118.31146152, 15076.23639067),
    1872: (1140.10843916, 7894.55753088),
    1875: (1129.73580766, 4478.27778804),
    1969: (819.6372663, None),
    1970: (798.37029261, 4032.15794181),
}
WITHOUT_1911_TO_1930 = {
    1910: (None, 4032.15794196),
    1930: (930.3394669, 33414.15794196),
    1931: (826.11354036, 10537.78547334),
    1937: (None, 4126.02665487),
    1970: (798.37044273, 4032.15794192),
}


@pytest.fixture(scope="module")
def nile():
    years, flow = np.loadtxt(CSV, delimiter=",", skiprows=2).T
    return dict(zip(years.astype(int).tolist(), flow.tolist(), strict=True))


def test_the_data_are_the_published_hundred_numbers(nile):
    assert list(nile) == list(range(1871, 1971))
    assert (sum(nile.values()), min(nile.values()), max(nile.values())) == (91935, 456, 1370)


@pytest.mark.parametrize("method", ["batch", "scalar"])
@pytest.mark.parametrize(
    ("missing", "expected"), [((), WHOLE), (range(1911, 1931), WITHOUT_1911_TO_1930)], ids=["whole", "gap"]
)
def test_filtered_levels_are_those_of_another_implementation(nile, method, missing, expected):
    belief, one = Belief(), np.eye(1)
    level = belief.add(1, np.zeros(1), PRIOR * one)
    for year, flow in nile.items():
        if year not in missing:
            belief.update([level], [one], flow - level.mean, R * one, method=method)
        mean, variance = expected.get(year, (None, None))
        if mean is not None:
            assert level.mean[0] == pytest.approx(mean, abs=2e-8)
        if variance is not None:
            assert belief.matrix[0, 0] == pytest.approx(variance, abs=1e-5)
        belief.predict(level, level.mean, one, Q * one)
