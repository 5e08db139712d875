"""Other people's programs beside slamlib: fetch them by version and checksum, and run the tests that compare the two.

They are no part of the environment: each lies in a folder of its own below `_build/oracles`, on NumPy and SciPy of the
lock. Needs the network once.
"""

import os
import subprocess
import sys
from pathlib import Path

from book.tools import layout

TESTS = "book/tests/oracles"
FOLDER = layout.BUILD / "oracles"
CPYTHON_ON_LINUX = 'python_version == "3.11" and sys_platform == "linux" and platform_machine == "x86_64"'
ORACLES = {  # each with its licence: they are run here, and nothing of them is copied
    "evo==1.38.1": "6f9ebbedec38de74c481a62b04d24c2320568878a9a8cf92cc3f627ef515ac9e",  # GPL-3.0
    "filterpy==2.0.0": "c5028eaf31a7181d2d5565a5447e9b1cda746c99b317f62d89018fc791ef1f7e",  # MIT
    "pykalman==0.11.2": "00dcc0c88b93a8ab6100295501e7f440350b872d558b41d0deff2fcaf827a553",  # BSD-3-Clause
    # What pykalman asks for, BSD-3-Clause
    "scikit-base==0.13.2": "0a67063c0323b9521ede91cfcc87ce097126de5f9d5367abed6e76ff97a0eda5",
    "spatialmath-python==1.1.18": "309f36fe96b8d3e3f31a7787366dbbbbfa7186ef1818776b8fde54962d99a26a",  # MIT
    # BSD-2-Clause; compiled, and tried by this Python alone: elsewhere its tests are skipped
    f"gtsam==4.3.0; {CPYTHON_ON_LINUX}": "63cae1c925f0094832b7f8d629951d4631cac57c6d7faba140c8ecc9f3c57752",
}


def fetched(oracle: str, digest: str) -> Path:
    """The folder with this version, without what it asks for beyond the lock; empty where its marker does not hold."""
    folder = FOLDER / oracle.partition(";")[0]
    ready = folder / ".ready"
    if not ready.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        wanted = folder / "wanted.txt"
        wanted.write_text(f"{oracle} --hash=sha256:{digest}\n", "utf-8")
        pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--upgrade"]
        subprocess.run([*pip, "--no-deps", "--require-hashes", "--target", folder, "-r", wanted], check=True)
        ready.touch()
    return folder


def main() -> int:
    """The exit status of the tests; 1 if an oracle cannot be had."""
    try:
        folders = [fetched(oracle, digest) for oracle, digest in ORACLES.items()]
    except subprocess.CalledProcessError:
        print("oracles: they cannot be fetched (is there a network?), and nothing was compared", file=sys.stderr)
        return 1
    known = [str(folder) for folder in (layout.ROOT, layout.BOOK, *folders)]
    found = {**os.environ, "PYTHONPATH": os.pathsep.join(known)}
    return subprocess.run([sys.executable, "-m", "pytest", "-q", "-rs", TESTS], cwd=layout.ROOT, env=found).returncode


if __name__ == "__main__":
    sys.exit(main())
