"""The file of the experiment with GPS belongs to the filters as they are: chapter observability."""

from dataclasses import replace

import numpy as np
import pytest

from book.experiments import absolute_measurements, stored
from book.tests.stored_results import comes_out_again

KEPT = stored.kept(absolute_measurements.FILE)
RENEW = "run `make absolute-measurements` and `python -m book.tools.notebooks run` for chapter observability"
TYPES = [name for name in KEPT if "," not in name]


def test_all_tables_are_there():
    assert set(KEPT) == set(absolute_measurements.parts()), RENEW


def again(preset, name, every, sigma):
    return absolute_measurements.one_run(preset, name, every, sigma, absolute_measurements.SETS[0])


@pytest.mark.parametrize("kind", TYPES)
def test_a_run_of_each_type_comes_out_again(kind):
    for name in ("local", absolute_measurements.REST, "world"):
        first = KEPT[kind][name][str(absolute_measurements.SETS[0])]["first"]
        comes_out_again(np.array(again(absolute_measurements.of_type(kind), name, 5, 0.1)), first, RENEW, digits=3)


@pytest.mark.parametrize("name", absolute_measurements.FILTERS)
def test_a_run_of_each_filter_comes_out_again(name):
    """In space each way to take a fix; in the plane those that are there."""
    kept = KEPT["space, 20 degrees"][name][str(absolute_measurements.SETS[0])]
    comes_out_again(np.array(again(absolute_measurements.in_space(20), name, 10, 0.3)), kept["first"], RENEW, digits=3)
    if name in KEPT["plane, 20 degrees, every 2"]:
        kept = KEPT["plane, 20 degrees, every 2"][name][str(absolute_measurements.SETS[0])]
        found = again(absolute_measurements.in_plane(20), name, 2, 0.5)
        comes_out_again(np.array(found), kept["first"], RENEW, digits=3)


def test_a_run_with_weak_fixes_comes_out_again():
    for name, sets in KEPT["idpPnt, fixes of 0.3 m"].items():
        if name in absolute_measurements.FILTERS:
            found = again(absolute_measurements.of_type("idpPnt"), name, 5, 0.3)
            comes_out_again(np.array(found), sets[str(absolute_measurements.SETS[0])]["first"], RENEW, digits=3)


def test_stored_claim_converted_points_are_consistent_with_weak_fixes_as_the_rest_turns_with_the_world():
    """Two controls leave only that: points that are not converted, and a start that is known."""
    found = {
        (case, name): [sets["invariant"][0] for sets in KEPT[f"idpPnt, fixes of 0.3 m{case}"][name].values()]
        for case in ("", ", not converted", ", start known")
        for name in ("world", absolute_measurements.REST)
        if name in KEPT[f"idpPnt, fixes of 0.3 m{case}"]
    }
    assert min(found["", absolute_measurements.REST]) > 12
    others = (mean for what, means in found.items() if what != ("", absolute_measurements.REST) for mean in means)
    assert max(others) < 8


@pytest.mark.parametrize(("convert", "most"), [(True, 0.8), (False, 1.1)], ids=["converted", "as they are"])
def test_a_run_that_turns_its_map_by_27_degrees_late(convert, most):
    """Its NEES, as a share of that with the rest as it was; points that are not converted have no axes."""
    base = absolute_measurements.of_type("idpPnt")
    p = replace(base, frames=20, options=replace(base.options, convert=convert))
    found = [absolute_measurements.one_run(p, name, 5, 0.3, 5013)[1] for name in ("world", absolute_measurements.REST)]
    assert found[0] < most * found[1]
