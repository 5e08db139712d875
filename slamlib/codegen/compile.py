"""Compile a model that is defined outside the package, in a reader's notebook say, with the same generator."""

import linecache
from types import ModuleType

from slamlib.errors import SlamlibError
from slamlib.model import Model


def compile_in_memory(model: Model) -> ModuleType:
    """A module with the model's generated functions; its text is kept, so that tracebacks and `show` can print it."""
    try:
        from slamlib.codegen.emit import module
    except ModuleNotFoundError as error:
        raise SlamlibError(
            f"{model.name} is not part of slamlib, so its code is generated now, which needs sympy: "
            "pip install 'slamlib[book]'"
        ) from error
    text = module([model], f"{model.module}.{model.name}")
    name = f"<generated from {model.module}.{model.name} {abs(hash(text)):x}>"
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    code = ModuleType(f"generated_{model.name}")
    code.__file__ = name
    exec(compile(text, name, "exec"), code.__dict__)
    code.__dict__["TEXT"] = text
    return code
