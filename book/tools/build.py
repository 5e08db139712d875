"""Build the book: run every notebook (or take it from the cache), then let Sphinx make HTML with warnings as errors.

Sphinx always begins with an empty folder. What it takes over from a build before is not what it would make anew: the
search index loses the glossary and all other index entries of pages that are not written again
(`sphinx.search.IndexBuilder.load`), links into pages that were added, moved or removed stay as they were, and what our
extensions and their tables would do differently is not seen at all. So a build is whole, or, where nothing that it is
made from has changed, it is left as it is.

With a NAME, while a chapter is written: run it, compare it with what it stores, and build its page by itself.
"""

import argparse
import base64
import csv
import hashlib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from book.tools import assets, layout, live, notebooks

SOURCE = layout.BUILD / "source"
ZIP, FOLDER = "ekf-slam-book.zip", "ekf-slam-book"
STAMP = layout.SITE / ".built-from"
# The theme has its icons twice, as a font and as half a megabyte of script, and loads two fonts that few pages need.
ICONS = re.compile(r'<script src="[^"]*/fontawesome/[^>]*></script>|<link rel="preload"[^>]*/fa-[br][^>]*>')
PICTURE = re.compile(r"data:image/png;base64,([A-Za-z0-9+/=]{10000,})")
JUPYTER_BOOK = [str(Path(sys.executable).with_name("jupyter-book")), "build"]


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if the book, or the page of the chapter that is named, is built; prints where it is."""
    known = {page.stem: page for page in layout.notebooks()}
    parser = argparse.ArgumentParser(prog="python -m book.tools.build", description=__doc__)
    parser.add_argument("name", nargs="?", choices=known, metavar="NAME", help=f"a page: {', '.join(known)}")
    name = parser.parse_args(arguments).name
    return book() if name is None else chapter(known[name])


def book() -> int:
    """Exit status 0 if the book is built; prints where it is."""
    start = time.perf_counter()
    print(f"running {len(layout.notebooks())} notebooks", flush=True)
    key = layout.digest(layout.package_files())
    try:
        stage(dict(notebooks.each(layout.notebooks(), lambda file: notebooks.executed(file, key))))
    except (notebooks.BrokenNotebook, assets.AssetError, RuntimeError) as error:
        print(error, file=sys.stderr)
        return 1
    state = made_from()
    if STAMP.is_file() and STAMP.read_text() == state:
        print("nothing has changed since the last build", flush=True)
    elif not html(SOURCE, layout.SITE):
        return 1
    STAMP.write_text(state)
    minutes, seconds = divmod(time.perf_counter() - start, 60)
    print(f"the book: {layout.SITE / 'index.html'}  ({minutes:.0f} min {seconds:.0f} s)")
    print(f"          {(layout.SITE / 'index.html').as_uri()}  (or: make serve)")
    return 0


def made_from() -> str:
    """Fingerprint of all that the site is made from: what is staged for Sphinx, what builds it, and with what."""
    staged = (file for file in SOURCE.rglob("*") if file.is_file())
    tools = [*(layout.BOOK / "tools").glob("*.py"), *(layout.BOOK / "offline").iterdir()]
    return f"{layout.digest(staged)} {layout.digest([*tools, *layout.package_files()])} {sys.version}"


def stage(executed: dict[Path, tuple[Path, bool]]) -> None:
    """The source tree for Sphinx: the pages, with the executed copies of the notebooks in place of the stored ones,
    and the files that the site serves itself."""
    shutil.rmtree(SOURCE, ignore_errors=True)
    skip = shutil.ignore_patterns("__pycache__", ".*", "tools", "experiments", "live", "offline", "slambook", "tests")
    shutil.copytree(layout.BOOK, SOURCE / "book", ignore=skip)
    for page, (copy, _) in executed.items():
        shutil.copy(copy, SOURCE / page.relative_to(layout.ROOT))
    for name in ("_config.yml", "_toc.yml"):
        text = (layout.ROOT / name).read_text("utf-8").replace("execute_notebooks: force", "execute_notebooks: 'off'")
        (SOURCE / name).write_text(text, "utf-8")
    assets.mathjax(SOURCE / "book" / "_static" / "mathjax")
    live.build(SOURCE / "book" / "_static" / "live")


def chapter(file: Path) -> int:
    """Exit status 0 if a notebook prints what it stores and its page is built; links to other pages lead nowhere."""
    compared = subprocess.run([sys.executable, "-m", *notebooks.NBVAL, str(file)], cwd=layout.ROOT).returncode
    try:
        copy = notebooks.executed(file, layout.digest(layout.package_files()))
    except notebooks.BrokenNotebook as error:
        print(error, file=sys.stderr)
        return 1
    stage({file: copy})
    name = file.relative_to(layout.ROOT).with_suffix("")
    (SOURCE / "_toc.yml").write_text(f"format: jb-book\nroot: {name.as_posix()}\n", "utf-8")
    print("building the page", flush=True)
    output = sphinx(SOURCE, layout.BUILD / "chapter", ["-qq"])
    if output is None:
        return 1
    print(f"the page: {(output / f'{name}.html').as_uri()}")
    return compared


def sphinx(source: Path, work: Path, options: list[str]) -> Path | None:
    """The folder of the pages that Jupyter Book makes of a source tree, in a new folder `work`; None if it fails."""
    shutil.rmtree(work, ignore_errors=True)
    run = subprocess.run([*JUPYTER_BOOK, *options, str(source), "--path-output", str(work)])
    return None if run.returncode else work / "_build" / "html"


def html(source: Path, site: Path) -> bool:
    """Make the site of a source tree, in place of the one that is there, which stays if the build fails."""
    print("building the pages", flush=True)
    output = sphinx(source, site.with_name("sphinx"), ["-W", "-n", "--keep-going", "-q"])
    if output is None:
        print("the build failed: see the messages above", file=sys.stderr)
        return False
    shutil.rmtree(site, ignore_errors=True)
    shutil.copytree(output, site, ignore=shutil.ignore_patterns(".buildinfo"))
    lighten(site)
    redirect(site)
    pack(site)
    return True


def lighten(site: Path) -> None:
    """Take out of the pages what they need not carry: icons that come twice, and large pictures, which become files
    (one for each picture, however often it is shown)."""
    for page in site.rglob("*.html"):
        images = os.path.relpath(site / "_images", page.parent)

        def filed(found: re.Match[str], images: str = images) -> str:
            content = base64.b64decode(found[1])
            file = site / "_images" / f"{hashlib.sha256(content).hexdigest()[:16]}.png"
            if not file.is_file():
                file.parent.mkdir(exist_ok=True)
                file.write_bytes(content)
            return f"{images}/{file.name}"

        text = page.read_text("utf-8")
        page.write_text(PICTURE.sub(filed, ICONS.sub("", text)), "utf-8")
    for scripts in site.glob("_static/vendor/fontawesome/*/js"):
        shutil.rmtree(scripts)


def redirect(site: Path) -> None:
    """A page for each address of an earlier edition (book/moved.csv), which leads to where the page is now."""
    with (layout.BOOK / "moved.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            old = site / f"{row['old page']}.html"
            new = os.path.relpath(site / f"{row['new page']}.html", old.parent)
            if old.is_file():
                continue  # some of its exercises have moved, not the page
            text = f'<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={new}">'
            layout.write_whole(old, f'{text}<title>Moved</title><a href="{new}">This page has moved.</a>\n'.encode())


def pack(site: Path) -> Path:
    """Pack the built site into one ZIP in itself that can be read, and run, without a network."""
    target = site / ZIP
    files = {f.relative_to(site).as_posix(): f for f in site.rglob("*") if f.is_file() and f != target}
    files |= {f.name: f for f in (layout.BOOK / "offline").iterdir()}
    content = {f"{FOLDER}/{name}": file.read_bytes() for name, file in files.items()}
    layout.write_whole(target, live.zipped(content, level=6))
    return target


if __name__ == "__main__":
    sys.exit(main())
