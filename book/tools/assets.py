"""Fetch the archives of book/assets.toml, by version and checksum, into _build/assets, once."""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
import urllib.error
import urllib.request
import zipfile
from collections.abc import Callable
from pathlib import Path

from book.tools import layout

ASSETS = layout.BUILD / "assets"
LIST = layout.BOOK / "assets.toml"
NPM = os.environ.get("NPM_REGISTRY", "https://registry.npmjs.org").rstrip("/")
DEBIAN = os.environ.get("DEBIAN_MIRROR", "http://deb.debian.org/debian").rstrip("/")
MATHJAX = "mathjax/static/mathjax/"
MATHJAX_WANTED = ("es5/tex-chtml.js", "es5/output/chtml/fonts/woff-v2/", "es5/input/tex/extensions/", "LICENSE")


class AssetError(Exception):
    """An archive that cannot be had, or is not the one that the list names."""


def archive(name: str) -> Path:
    """The archive of that name, downloaded if it is not there yet; raises AssetError."""
    entry = tomllib.loads(LIST.read_text("utf-8"))[name]
    file = ASSETS / f"{name}-{entry['sha256'][:16]}"
    if not file.is_file():
        download, asked = next((get, entry[kind]) for kind, get in DOWNLOADS.items() if kind in entry)
        print(f"fetching {Path(asked).name} (once)", flush=True)
        content = download(asked)
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
    return _url(f"{NPM}/{name}/-/{package}.tgz")


def _deb(path: str) -> bytes:
    """By apt-get, which needs no root for a download, or where there is none, or no such package, from a mirror."""
    name, version, _ = Path(path).name.split("_")
    if shutil.which("apt-get") is not None:
        with tempfile.TemporaryDirectory() as there:
            command = ["apt-get", "download", "-q", f"{name}={version}"]
            subprocess.run(command, cwd=there, capture_output=True, check=False)
            for file in Path(there).glob("*.deb"):
                return file.read_bytes()
    return _url(f"{DEBIAN}/pool/{path}")


def _url(address: str) -> bytes:
    try:
        with urllib.request.urlopen(address, timeout=600) as answer:
            return bytes(answer.read())
    except (urllib.error.URLError, TimeoutError) as error:
        raise AssetError(f"{address} cannot be downloaded; is the network there? ({error})") from error


DOWNLOADS: dict[str, Callable[[str], bytes]] = {"npm": _npm, "pypi": _pypi, "deb": _deb}


def main() -> int:
    """Fetch all but those of Debian; exit status 0 if they are there."""
    try:
        for name, entry in tomllib.loads(LIST.read_text("utf-8")).items():
            if "deb" not in entry:
                print(archive(name))
    except AssetError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
