"""Pairs for the stereo front end: opened by slamlib.datasets.opening, and looked at before a run begins."""

from dataclasses import replace
from typing import Any

from slamlib.datasets import opening
from slamlib.datasets.sources import Source
from slamlib.vision.stereo.pair_checks import check_pair
from slamlib.vision.stereo.settings import StereoSettings


def opened_pairs(
    *places: Any, settings: StereoSettings | None = None, **options: Any
) -> tuple[Source, dict[str, Any], StereoSettings]:
    """As `slamlib.datasets.opening.opened_pairs`, and the settings with the calibration's offset.

    The first pair is read: its rows and the sign of its disparities are checked. Raises SlamlibError.
    """
    pairs, setup, offset = opening.opened_pairs(*places, **options)
    chosen = settings or StereoSettings()
    chosen = replace(chosen, offset=chosen.offset or offset)
    first = next(iter(pairs))
    check_pair(first.image, first.name, chosen)
    return pairs, setup, chosen
