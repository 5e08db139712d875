"""Where things are, and which pages the book has."""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import yaml

from slamlib.plain_data import files

ROOT = Path(__file__).resolve().parents[2]
BOOK = ROOT / "book"
BUILD = ROOT / "_build"
SITE = BUILD / "html"


def _toc() -> Any:
    return yaml.safe_load((ROOT / "_toc.yml").read_text("utf-8"))


def parts() -> list[list[str]]:
    """The pages' names of each part of the book."""
    return [[name.rsplit("/", 1)[-1] for name in _names(part)] for part in _toc()["parts"]]


def pages() -> list[Path]:
    """Source file of every page of _toc.yml, in order; raises FileNotFoundError for a page that is not there."""
    toc, found = _toc(), []
    for name in _names(toc):
        files = [f for suffix in (".ipynb", ".md") if (f := ROOT / (name + suffix)).is_file()]
        if not files:
            raise FileNotFoundError(f"_toc.yml names {name}, but there is no {name}.ipynb or {name}.md")
        found.append(files[0])
    return found


def notebooks() -> list[Path]:
    """The notebooks among the pages."""
    return [p for p in pages() if p.suffix == ".ipynb"]


def lessons() -> list[Path]:
    """The notebooks that teach: the chapters, and the pages on the report's filter, which have exercises as well."""
    return [*sorted((BOOK / "chapters").glob("*.ipynb")), *sorted((BOOK / "sources").glob("report_*.ipynb"))]


def digest(files: Iterable[Path]) -> str:
    """Fingerprint of the files' names and contents."""
    total = hashlib.sha256()
    for file in sorted(files):
        total.update(file.relative_to(ROOT).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    return total.hexdigest()[:20]


def write_whole(file: Path, content: bytes) -> None:
    """Write a file atomically, with the folders that lead to it."""
    file.parent.mkdir(parents=True, exist_ok=True)
    files.write_whole(file, content)


def package_files() -> list[Path]:
    """What the result of a notebook depends on besides the notebook: the packages, the lock, the data of the book."""
    tops = (ROOT / "slamlib", BOOK / "slambook", ROOT / "benchmarks", BOOK / "chapters", BOOK / "sources")
    found = [f for top in tops for f in top.rglob("*") if f.is_file() and f.suffix not in (".ipynb", ".md", ".pyc")]
    ours = [f for f in found if not {"tests", ".ipynb_checkpoints"} & set(f.relative_to(ROOT).parts)]
    return [*ours, ROOT / "requirements.txt", BOOK / "tools" / "notebooks.py"]


def _names(node: Any) -> list[str]:
    if isinstance(node, dict):
        own = [node[k] for k in ("root", "file") if k in node]
        return own + [n for key in ("parts", "chapters", "sections") for n in _names(node.get(key, []))]
    return [n for item in node for n in _names(item)]
