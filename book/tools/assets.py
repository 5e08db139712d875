"""Fetch what the site serves itself: packages by version and checksum, unpacked into _build/assets, once."""

import subprocess
import sys
import zipfile
from pathlib import Path

from book.tools import layout

ASSETS = layout.BUILD / "assets"
LIST = layout.BOOK / "assets.txt"
INSIDE = "mathjax/static/mathjax/"
WANTED = ("es5/tex-chtml.js", "es5/output/chtml/fonts/woff-v2/", "es5/input/tex/extensions/", "LICENSE")


def fetch() -> Path:
    """The folder with the site's assets; downloads only when book/assets.txt has changed."""
    target = ASSETS / layout.digest([LIST])
    if (target / ".complete").is_file():
        return target
    wheels = target / "wheels"
    print("fetching the site's assets (once)", flush=True)
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps"]
    subprocess.run([*command, "--require-hashes", "--dest", str(wheels), "-r", str(LIST)], check=True)
    for wheel in wheels.glob("*.whl"):
        with zipfile.ZipFile(wheel) as archive:
            for name in archive.namelist():
                inner = name.removeprefix(INSIDE)
                if name.startswith(INSIDE) and inner.startswith(WANTED) and not name.endswith("/"):
                    file = target / "mathjax" / inner.removeprefix("es5/")
                    file.parent.mkdir(parents=True, exist_ok=True)
                    file.write_bytes(archive.read(name))
        wheel.unlink()
    wheels.rmdir()
    (target / ".complete").touch()
    return target


if __name__ == "__main__":
    print(fetch())
