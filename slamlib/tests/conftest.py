"""Which tests `make quick` runs: those of the core that are quick, by the marker `core`. No test is timed."""

from typing import Any

from hypothesis import settings

settings.register_profile("untimed", deadline=None)  # a busy machine is no failure
settings.load_profile("untimed")
CORE = {
    *("test_association", "test_belief", "test_belief_properties", "test_compatibility", "test_evaluation"),
    *("test_expected", "test_forgetting", "test_geometry", "test_implicit", "test_kernel", "test_model"),
    *("test_model_properties", "test_motions", "test_observation", "test_package", "test_points", "test_rig"),
    *("test_series", "test_slam"),
}


def pytest_collection_modifyitems(items: list[Any]) -> None:
    """Mark them."""
    for item in items:
        if item.path.stem in CORE:
            item.add_marker("core")
