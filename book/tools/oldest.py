"""The core's tests on the wheel, by the Python and the NumPy that run this: what slamlib promises beside the lock.

`make oldest` creates an environment with NumPy 1.25; `make oldest PYTHON=python3.14 NUMPY='2.*'`, one with others.
"""

import os
import platform
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

import numpy as np

from book.tools import layout, wheel


def install() -> Path:
    """The wheel with what its tests need, beside this NumPy; returns the installed package, with its tests put in."""
    with tempfile.TemporaryDirectory() as folder:
        wanted = [f"{wheel.build(Path(folder))}[test]", f"numpy=={np.__version__}"]
        quiet = ["--quiet", "--disable-pip-version-check"]
        subprocess.run([sys.executable, "-m", "pip", "install", *quiet, *wanted], check=True)
    packages = Path(sysconfig.get_path("purelib"))
    shutil.copytree(layout.ROOT / "slamlib" / "tests", packages / "slamlib" / "tests")
    return packages / "slamlib"


def main() -> int:
    """Install, and run the tests where no checkout is; pytest's exit status."""
    if sys.prefix == sys.base_prefix or Path(sys.prefix) == layout.ROOT / ".venv":
        print("this installs packages, into an environment of its own: make oldest")
        return 2
    package = install()
    options = ["-q", "-m", "core", "-c", str(layout.ROOT / "pyproject.toml"), "-p", "no:cacheprovider"]
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    print(f"Python {platform.python_version()}, NumPy {np.__version__}, {package}", flush=True)
    command = [sys.executable, "-m", "pytest", *options, str(package / "tests")]
    return subprocess.run(command, cwd=sys.prefix, env=clean).returncode


if __name__ == "__main__":
    sys.exit(main())
