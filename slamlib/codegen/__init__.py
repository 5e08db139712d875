"""From a model's definition to NumPy code and proofs (needs sympy).

`derive` shows the formula and its Jacobians, `assert_same` proves that two formulas are equal, `check_model` compares
Jacobians with numerical ones, `show` prints source. `python -m slamlib.codegen` writes slamlib/generated.
"""

from slamlib.codegen.derive import Derivation, derive, show
from slamlib.codegen.proof import assert_same, check_model

__all__ = ["Derivation", "assert_same", "check_model", "derive", "load_ipython_extension", "show"]


def load_ipython_extension(shell: object) -> None:
    """`%load_ext slamlib.codegen` registers the cell magic %%tangle."""
    from slamlib.codegen.tangle import register

    register(shell)
