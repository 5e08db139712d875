"""Make the folder _static/live of the site: Python, NumPy, slamlib and more for the reader's browser, made small."""

import gzip
import importlib.metadata
import io
import json
import re
import shutil
import sys
import tarfile
import zipfile
from pathlib import Path

from book.tools import assets, layout, wheel

PAGE = layout.BOOK / "live"  # what we wrote ourselves: the worker, the page's script, the style
NUMPY_VERSION = "1.25.2"
PACKED = {".zip", ".whl", ".bin", ".woff", ".woff2", ".png", ".jpg"}  # what does not become smaller
FIRST = ("pyodide.asm.js.bin", "pyodide.asm.wasm.bin", "python_stdlib.zip", "numpy.zip")
# What a page has no use for: tests, headers, servers, sockets, consoles, other languages' tools.
NOT_NUMPY = re.compile(
    r"(^|/)(tests?|f2py|distutils|_pyinstaller|array_api|include|doc)/|(core|random)/lib/|/setup\.py$"
    r"|\.(pyi|pxd|pyx|h|c|a|ini|pyc)$|_simd\.|(rational|umath|flag|ufunc)_tests\.|lapack_lite"
)
NOT_STANDARD = re.compile(
    r"(test|idlelib|lib2to3|turtle|tkinter|ensurepip|pydoc|distutils|venv|wsgiref|xmlrpc|xml|curses|sqlite3|dbm|msilib"
    r"|mailbox|imaplib|poplib|nntplib|smtplib|smtpd|ftplib|telnetlib|multiprocessing|cgi|webbrowser|http/server"
    r"|http/cookie|socketserver|doctest|pdb|optparse|mailcap|asynchat|asyncore|aifc|sunau|wave|chunk|crypt|ipaddress"
    r"|xdrlib|sndhdr|imghdr|tabnanny|pyclbr|cmd|bdb|profile|cProfile|pstats|trace\.|zipapp|plistlib|netrc|rlcompleter"
    r"|pipes|getpass|pty|tty|antigravity|this\.|symtable|modulefinder|unittest/mock"
    r"|encodings/(?!__init__|aliases|ascii|cp437|cp1252|latin_1|utf_8|utf_16|idna|raw_unicode_escape|unicode_escape))"
)
NOT_SYMPY = re.compile(  # physics.units is imported by simplify
    r"(^|/)(tests|benchmarks|autolev|physics/(?!units)\w+)/|\.pyc$|RECORD$|^\.\.|^share/|^bin/"
)


def build(target: Path) -> None:
    """Fill `target` with everything that a live page fetches, and manifest.json with the size of each file."""
    packed = layout.BUILD / "live" / layout.digest([assets.LIST, Path(__file__), layout.ROOT / "requirements.txt"])
    if not (packed / "complete").is_file():
        shutil.rmtree(packed.parent, ignore_errors=True)
        print("packing Python for the page (once)", flush=True)
        _interpreter(packed)
        layout.write_whole(packed / "numpy.zip", zipped(_numpy()))
        layout.write_whole(packed / "sympy.zip", zipped(_sympy()))
        layout.write_whole(packed / "complete", b"")
    shutil.copytree(packed, target, ignore=shutil.ignore_patterns("complete", "lock.json"))
    shutil.copytree(PAGE, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    stand_in = {f"standin/{f.name}": f.read_bytes() for f in (target / "standin").glob("*.py")}
    shutil.rmtree(target / "standin")
    layout.write_whole(target / "standin.zip", zipped(stand_in))
    shutil.copytree(layout.BOOK / "chapters" / "data", target / "data")
    for folder in (layout.BOOK / "chapters" / "pictures").iterdir():
        shown = {f.relative_to(folder.parents[1]).as_posix(): f.read_bytes() for f in folder.rglob("*.*")}
        layout.write_whole(target / "pictures" / f"{folder.name}.zip", zipped(shown))
    made = wheel.build(target)
    files = {
        f.relative_to(target).as_posix(): {"bytes": f.stat().st_size}
        for f in sorted(target.rglob("*"))
        if f.is_file() and "licences" not in f.parts
    }
    manifest = {
        "first": [*FIRST, made.name, "standin.zip", "runner.py"],
        "wheel": made.name,
        "lock": json.loads((packed / "lock.json").read_text("utf-8")),
        "later": {"sympy": "sympy.zip", "mpmath": "sympy.zip"},
        "data": [n for n in files if n.startswith("data/")],
        "files": files,
    }
    layout.write_whole(target / "manifest.json", json.dumps(manifest, indent=1).encode())
    weight = sum((target / name).stat().st_size for name in (*FIRST, made.name, "runner.py", "pyodide.js"))
    script = (target / "page.js").read_text("utf-8").replace("@MEGABYTES@", f"{weight / 1e6:.0f}")
    layout.write_whole(target / "page.js", script.encode())


def _interpreter(target: Path) -> None:
    with tarfile.open(assets.archive("pyodide")) as archive:
        content = {m.name: f.read() for m in archive.getmembers() if (f := archive.extractfile(m)) is not None}
    layout.write_whole(target / "pyodide.js", content["package/pyodide.js"].split(b"\n//# sourceMappingURL")[0])
    for name in ("pyodide.asm.js", "pyodide.asm.wasm"):  # unpacked by the worker, since many hosts compress nothing;
        squeezed = gzip.compress(content[f"package/{name}"], compresslevel=9, mtime=0)
        layout.write_whole(target / f"{name}.bin", squeezed)  # .bin, since some hosts take .gz for an encoding
    lock = json.loads(content["package/pyodide-lock.json"])
    lock["packages"] = {}  # the page fetches nothing from Pyodide's own server
    layout.write_whole(target / "lock.json", json.dumps(lock).encode())
    with zipfile.ZipFile(io.BytesIO(content["package/python_stdlib.zip"])) as library:
        kept = {n: library.read(n) for n in library.namelist() if not n.endswith("/") and not NOT_STANDARD.match(n)}
    layout.write_whole(target / "python_stdlib.zip", zipped(kept))


def _numpy() -> dict[str, bytes]:
    with zipfile.ZipFile(assets.archive("numpy")) as outer:
        name = next(n for n in outer.namelist() if re.search(rf"/numpy-{NUMPY_VERSION}-[^/]*\.tar\.gz$", n))
        inner = io.BytesIO(outer.read(name))
    prefix = "lib/python3.11/site-packages/"
    with tarfile.open(fileobj=inner) as archive:
        content = {m.name: f.read() for m in archive.getmembers() if (f := archive.extractfile(m)) is not None}
    kept = {n.removeprefix(prefix): c for n, c in content.items() if n.startswith(prefix)}
    return {n: c for n, c in kept.items() if not NOT_NUMPY.search(n)}


def _sympy() -> dict[str, bytes]:
    """SymPy and mpmath as the lock has installed them here."""
    entries = (entry for package in ("sympy", "mpmath") for entry in importlib.metadata.files(package) or ())
    return {e.as_posix(): Path(str(e.locate())).read_bytes() for e in entries if not NOT_SYMPY.search(e.as_posix())}


def zipped(files: dict[str, bytes], level: int = 9) -> bytes:
    """A zip archive, the same bytes on every run; what is packed already is stored as it is."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name)
            entry.external_attr = 0o644 << 16
            method = zipfile.ZIP_STORED if Path(name).suffix in PACKED else zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name], method, level)
    return buffer.getvalue()


if __name__ == "__main__":
    build(Path(sys.argv[1]))
