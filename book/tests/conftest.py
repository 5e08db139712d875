"""The wheel and an environment of its own, made once for all tests that want them."""

from pathlib import Path

import pytest

from book.tests.bare import Environment
from book.tools import wheel


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel."""
    pytest.importorskip("setuptools", reason="the wheel is built with setuptools")
    return wheel.build(tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="session")
def bare(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Environment:
    """An environment with the wheel, and NumPy beside it."""
    return Environment.made(tmp_path_factory.mktemp("bare"), built)
