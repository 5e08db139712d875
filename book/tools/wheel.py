"""Build slamlib's wheel: one file for `pip install` and for the page's interpreter, the same bytes on every run."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from book.tools import layout

SOURCES = ("pyproject.toml", "LICENSE", "slamlib", "book/slambook")
FIRST_DATE_OF_ZIP = "315532800"  # 1980-01-01: file times must not change the bytes


def build(target: Path) -> Path:
    """The wheel, built from a clean copy of the sources into the folder `target`; raises RuntimeError."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "source"
        copy.mkdir()
        for name in SOURCES:
            source = layout.ROOT / name
            if source.is_dir():
                shutil.copytree(source, copy / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
            else:
                shutil.copy(source, copy / name)
        command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps"]
        run = subprocess.run(
            [*command, "--no-build-isolation", "--wheel-dir", str(Path(folder) / "out"), str(copy)],
            env={**os.environ, "SOURCE_DATE_EPOCH": FIRST_DATE_OF_ZIP},
            capture_output=True,
            text=True,
        )
        if run.returncode:
            raise RuntimeError(f"slamlib's wheel cannot be built:\n{run.stdout}{run.stderr}")
        made = next((Path(folder) / "out").glob("*.whl"))
        layout.write_whole(target / made.name, made.read_bytes())
        return target / made.name


def main() -> int:
    """Build it into _build/wheel and print where it is."""
    print(build(layout.BUILD / "wheel"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
