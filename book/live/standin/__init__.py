"""What the page's Python imports under the name matplotlib: a stand-in, for no matplotlib exists for WebAssembly.

It has the calls of the chapters and those that readers type first, and draws with the book's small renderer, so that a
figure looks as it did before its cell was run. It will be removed when a wheel exists. In a kernel, matplotlib is
matplotlib: nothing of this name lies on disk where Python could import it.
"""

from slamlib.errors import UnknownCallError

__version__ = "0 (stand-in)"
rcParams: dict[str, object] = {}  # it may be written to; the page's style is the book's


def missing(what: str, name: str, known: list[str]) -> UnknownCallError:
    """The error for what the stand-in lacks: it says so, and what there is instead."""
    error = UnknownCallError.of_object(what, name, known)
    if name.startswith("_"):
        return error
    return UnknownCallError(
        f"the page's matplotlib is a small stand-in and has no {name} in {what}; "
        f"in JupyterLab or VS Code matplotlib is whole. {str(error)[:1].upper()}{str(error)[1:]}"
    )


def __getattr__(name: str) -> object:
    raise missing("matplotlib", name, ["pyplot", "rcParams"])
