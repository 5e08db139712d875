"""Compile what is not generated into the package with the same generator: models of readers, storage Jacobians."""

import linecache
from types import ModuleType

from slamlib.errors import SlamlibError
from slamlib.model import Model


def compile_in_memory(model: Model, *, by_storage: bool = False) -> ModuleType:
    """A module with the model's generated functions; its text is kept, so that tracebacks and `show` can print it.

    by_storage: with the derivatives by stored numbers instead. Raises SlamlibError without sympy.
    """
    try:
        from slamlib.codegen.emit import module
    except ModuleNotFoundError as error:
        what = "its derivatives by stored numbers are not kept in" if by_storage else "it is not part of"
        raise SlamlibError(
            f"{model.name}: {what} slamlib but generated at the first use, which needs sympy: "
            "pip install 'slamlib[book]'"
        ) from error
    text = module([model], f"{model.module}.{model.name}", by_storage=by_storage)
    name = f"<generated from {model.module}.{model.name} {abs(hash(text)):x}>"
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    code = ModuleType(f"generated_{model.name}")
    code.__file__ = name
    exec(compile(text, name, "exec"), code.__dict__)
    code.__dict__["TEXT"] = text
    return code
