"""Print source in a chapter: the text is read from the package, so that it cannot drift from it."""

import inspect
from types import ModuleType
from typing import Any

from slamlib.model import Model
from slamlib.modeling import fingerprint


class Source:
    """A piece of source text, highlighted where it is displayed."""

    def __init__(self, text: str) -> None:
        self.text = text.rstrip() + "\n"

    def _repr_markdown_(self) -> str:
        return f"```python\n{self.text}```"

    def __repr__(self) -> str:
        return self.text


def show(thing: Any, *, generated: bool = False) -> Source:
    """Source of a model, function, class or module; generated=True gives the NumPy code generated from a model."""
    if not isinstance(thing, Model):
        return Source(inspect.getsource(thing))
    if not generated:
        return Source(fingerprint.source(thing.function))
    return Source("\n\n".join(_functions(thing.code, thing.name)))


def _functions(code: ModuleType, name: str) -> list[str]:
    return [inspect.getsource(f) for n in (name, f"{name}_jac") if (f := getattr(code, n, None))]
