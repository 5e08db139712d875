"""Build the book: run every notebook (or take it from the cache), then let Sphinx make HTML with warnings as errors."""

import csv
import shutil
import subprocess
import sys
import time
from pathlib import Path

from book.tools import assets, bundle, layout, live, notebooks

SOURCE = layout.BUILD / "source"
STAMP = layout.SITE / ".built-from"
JUPYTER_BOOK = [str(Path(sys.executable).with_name("jupyter-book")), "build"]


def main() -> int:
    """Exit status 0 if the book is built; prints where it is."""
    start = time.perf_counter()
    print(f"running {len(layout.notebooks())} notebooks", flush=True)
    key = layout.digest(layout.package_files())
    try:
        done = notebooks.each(layout.notebooks(), lambda file: notebooks.executed(file, key))
    except notebooks.BrokenNotebook as error:
        print(error, file=sys.stderr)
        return 1
    try:
        stage(dict(done))
    except (assets.AssetError, RuntimeError) as error:
        print(error, file=sys.stderr)
        return 1
    state = layout.digest(f for f in SOURCE.rglob("*") if f.is_file())
    if STAMP.is_file() and STAMP.read_text() == state:
        print("nothing has changed since the last build", flush=True)
    elif not html():
        return 1
    STAMP.write_text(state)
    minutes, seconds = divmod(time.perf_counter() - start, 60)
    print(f"the book: {layout.SITE / 'index.html'}  ({minutes:.0f} min {seconds:.0f} s)")
    print(f"          {(layout.SITE / 'index.html').as_uri()}  (or: make serve)")
    return 0


def stage(executed: dict[Path, tuple[Path, bool]]) -> None:
    """The source tree for Sphinx: the pages, with the executed copies of the notebooks in place of the stored ones,
    and the files that the site serves itself."""
    shutil.rmtree(SOURCE, ignore_errors=True)
    skip = shutil.ignore_patterns("__pycache__", ".*", "tools", "live", "offline", "slambook", "tests")
    shutil.copytree(layout.BOOK, SOURCE / "book", ignore=skip)
    for page, (copy, _) in executed.items():
        shutil.copy(copy, SOURCE / page.relative_to(layout.ROOT))
    for name in ("_config.yml", "_toc.yml"):
        text = (layout.ROOT / name).read_text("utf-8").replace("execute_notebooks: force", "execute_notebooks: 'off'")
        (SOURCE / name).write_text(text, "utf-8")
    assets.mathjax(SOURCE / "book" / "_static" / "mathjax")
    live.build(SOURCE / "book" / "_static" / "live")


def page(file: Path, executed: Path) -> Path | None:
    """Build one page by itself, from its executed copy; where it is, or None. Its links to other pages lead nowhere."""
    stage({file: (executed, True)})
    name = file.relative_to(layout.ROOT).with_suffix("")
    (SOURCE / "_toc.yml").write_text(f"format: jb-book\nroot: {name.as_posix()}\n", "utf-8")
    print("building the page", flush=True)
    target = layout.BUILD / "chapter"
    if subprocess.run([*JUPYTER_BOOK, "-qq", str(SOURCE), "--path-output", str(target)]).returncode:
        return None
    return target / "_build" / "html" / f"{name}.html"


def html() -> bool:
    """Run Jupyter Book; after a failure the next build starts afresh, since Sphinx repeats no warning."""
    print("building the pages", flush=True)
    strict = ["-W", "-n", "--keep-going", "-q"]
    run = subprocess.run([*JUPYTER_BOOK, *strict, str(SOURCE), "--path-output", str(layout.BUILD / "sphinx")])
    output = layout.BUILD / "sphinx" / "_build"
    if run.returncode:
        shutil.rmtree(output, ignore_errors=True)
        STAMP.unlink(missing_ok=True)
        print("the build failed: see the messages above", file=sys.stderr)
        return False
    shutil.rmtree(layout.SITE, ignore_errors=True)
    shutil.copytree(output / "html", layout.SITE, ignore=shutil.ignore_patterns(".buildinfo"))
    redirect(layout.SITE)
    bundle.pack(layout.SITE)
    return True


def redirect(site: Path) -> None:
    """A page for each address of an earlier edition (book/moved.csv), which leads to where the page is now."""
    with (layout.BOOK / "moved.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            old, new = site / f"{row['old page']}.html", f"{Path(row['new page']).name}.html"
            text = f'<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={new}">'
            layout.write_whole(old, f'{text}<title>Moved</title><a href="{new}">This page has moved.</a>\n'.encode())


if __name__ == "__main__":
    sys.exit(main())
