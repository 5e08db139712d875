"""The compiler of models: what makes code of a model that has none in the package. Models know it by its name alone."""

from collections.abc import Callable
from importlib import import_module
from types import ModuleType

from slamlib.errors import SlamlibError
from slamlib.models.fingerprint import Defined
from slamlib.models.in_memory import load

COMPILER = "slamlib.codegen"  # calls `register` when it is imported
# (list of models, what they are from, by_storage=...) -> text of a module
Compiler = Callable[..., str]
_registered: list[Compiler] = []


def register(compiler: Compiler) -> None:
    """Let `compiler` make the code of the models that have none in the package; it takes the place of another."""
    _registered[:] = [compiler]


def compile_in_memory(model: Defined, *, by_storage: bool = False) -> ModuleType:
    """A module with the generated functions of a Model, and their text as TEXT.

    Where no compiler is registered yet, the module COMPILER, which registers one, is imported by its name: it needs
    sympy, which a filter does without. by_storage: with the derivatives w.r.t. stored numbers instead. Raises
    SlamlibError without sympy.
    """
    if not _registered:
        try:
            import_module(COMPILER)
        except ModuleNotFoundError as error:
            what = "its derivatives by stored numbers are not kept in" if by_storage else "it is not part of"
            raise SlamlibError(
                f"{model.name}: {what} slamlib but generated at the first use, which needs sympy: "
                "pip install 'slamlib[derive]'"
            ) from error
    (compiler,) = _registered
    text = compiler([model], f"{model.module}.{model.name}", by_storage=by_storage)
    code = load(text, f"<generated from {model.module}.{model.name} {abs(hash(text)):x}>")
    vars(code)["TEXT"] = text
    return code
