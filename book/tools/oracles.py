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
ORACLES = {  # licence GPL: it is run here, and nothing of it is copied
    "evo==1.38.1": "6f9ebbedec38de74c481a62b04d24c2320568878a9a8cf92cc3f627ef515ac9e",
}


def fetched(oracle: str, digest: str) -> Path:
    """The folder with this version, without what it asks for beyond the lock: its core needs none of that."""
    folder = FOLDER / oracle
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
