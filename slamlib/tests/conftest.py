"""Which tests `make quick` runs: those of the core that are quick, by the marker `core`. No test is timed."""

from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

# A busy machine is no failure; and the same commit has the same result: other examples by --hypothesis-profile=default.
settings.register_profile("repeatable", deadline=None, derandomize=True)
settings.load_profile("repeatable")
CORE = {
    *("test_association", "test_belief", "test_belief_properties", "test_checkpoint", "test_compatibility"),
    *("test_evaluation", "test_expected", "test_forgetting", "test_geometry", "test_implicit", "test_kernel"),
    *("test_measurement_update", "test_model", "test_model_properties", "test_motions", "test_observation"),
    *("test_package", "test_points", "test_rig", "test_series", "test_slam", "test_slam_options"),
    "test_textbook_update",
}


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """By `-m core`, other files are not even read: what they import need not be there."""
    other = collection_path.name.startswith("test_") and collection_path.stem not in CORE
    return True if other and config.option.markexpr == "core" else None


def pytest_collection_modifyitems(items: list[Any]) -> None:
    """Mark them."""
    for item in items:
        if item.path.stem in CORE:
            item.add_marker("core")
