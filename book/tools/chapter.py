"""One chapter while it is written: run it, compare it with what it stores, build its page by itself."""

import argparse
import subprocess
import sys

from book.tools import build, layout, notebooks


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 if the notebook prints what it stores and its page is built; prints where the page is."""
    known = {page.stem: page for page in layout.notebooks()}
    parser = argparse.ArgumentParser(prog="python -m book.tools.chapter", description=__doc__)
    parser.add_argument("name", choices=known, metavar="NAME", help=f"a page of the book: {', '.join(known)}")
    page = known[parser.parse_args(arguments).name]
    compared = subprocess.run([sys.executable, "-m", *notebooks.NBVAL, str(page)], cwd=layout.ROOT).returncode
    try:
        copy = notebooks.executed(page, layout.digest(layout.package_files()))
    except notebooks.BrokenNotebook as error:
        print(error, file=sys.stderr)
        return 1
    shown = build.page(page, copy[0])
    if shown:
        print(f"the page: {shown.as_uri()}")
    return compared or int(not shown)


if __name__ == "__main__":
    sys.exit(main())
