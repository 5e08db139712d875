"""From a model's definition to NumPy code and proofs (needs sympy).

`derive` shows the formula and its Jacobians, `assert_same` proves that two formulas are equal, `check_model` compares
Jacobians with numerical ones, `show` prints source. `python -m slamlib.codegen` writes slamlib/generated.
Once imported, it is the compiler of the models that have no code in the package.
"""

from slamlib.codegen.derive import Derivation, derive, show
from slamlib.codegen.emit import module
from slamlib.codegen.proof import assert_same, check_model
from slamlib.models.compiler import register as register_compiler

__all__ = ["Derivation", "assert_same", "check_model", "derive", "load_ipython_extension", "show"]

register_compiler(module)


def load_ipython_extension(shell: object) -> None:
    """`%load_ext slamlib.codegen` registers the cell magic %%tangle."""
    from slamlib.codegen.tangle import register

    register(shell)
