"""Fetch the archives of book/assets.toml, by version and checksum, into _build/assets, once."""

import hashlib
import os
import subprocess
import sys
import tempfile
import tomllib
import urllib.error
import urllib.request
import zipfile
from pathlib import Path

from book.tools import layout

ASSETS = layout.BUILD / "assets"
LIST = layout.BOOK / "assets.toml"
NPM = os.environ.get("NPM_REGISTRY", "https://registry.npmjs.org").rstrip("/")
MATHJAX = "mathjax/static/mathjax/"
MATHJAX_WANTED = ("es5/tex-chtml.js", "es5/output/chtml/fonts/woff-v2/", "es5/input/tex/extensions/", "LICENSE")


class AssetError(Exception):
    """An archive that cannot be had, or is not the one that the list names."""


def archive(name: str) -> Path:
    """The archive of that name, downloaded if it is not there yet; raises AssetError."""
    entry = tomllib.loads(LIST.read_text("utf-8"))[name]
    file = ASSETS / f"{name}-{entry['sha256'][:16]}"
    if not file.is_file():
        print(f"fetching {entry.get('npm') or entry['pypi']} (once)", flush=True)
        content = _npm(entry["npm"]) if "npm" in entry else _pypi(entry["pypi"])
        found = hashlib.sha256(content).hexdigest()
        if found != entry["sha256"]:
            raise AssetError(f"{name}: the checksum is {found}, book/assets.toml asks for {entry['sha256']}")
        layout.write_whole(file, content)
    return file


def mathjax(target: Path) -> None:
    """Unpack the part of MathJax that the pages load."""
    with zipfile.ZipFile(archive("mathjax")) as packed:
        for name in packed.namelist():
            inner = name.removeprefix(MATHJAX)
            if name.startswith(MATHJAX) and inner.startswith(MATHJAX_WANTED) and not name.endswith("/"):
                layout.write_whole(target / inner.removeprefix("es5/"), packed.read(name))


def _pypi(requirement: str) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        quiet = ["--quiet", "--disable-pip-version-check", "--no-deps", "--only-binary", ":all:", "--dest", folder]
        run = subprocess.run([sys.executable, "-m", "pip", "download", *quiet, requirement], stderr=subprocess.PIPE)
        files = list(Path(folder).iterdir())
        if run.returncode or len(files) != 1:
            raise AssetError(f"{requirement} cannot be downloaded; is the network there?\n{run.stderr.decode()}")
        return files[0].read_bytes()


def _npm(package: str) -> bytes:
    name = package.rsplit("-", 1)[0]
    try:
        with urllib.request.urlopen(f"{NPM}/{name}/-/{package}.tgz", timeout=180) as answer:
            return bytes(answer.read())
    except (urllib.error.URLError, TimeoutError) as error:
        raise AssetError(f"{package} cannot be downloaded from {NPM}; is the network there? ({error})") from error


def main() -> int:
    """Fetch all of them; exit status 0 if they are there."""
    try:
        for name in tomllib.loads(LIST.read_text("utf-8")):
            print(archive(name))
    except AssetError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
