"""Models: a formula is stated once; its code, values and Jacobians are found for it.

`model` declares one (formula.py). Beside it: kernels that run generated code, the seam to what compiles it, code in
memory, fingerprints, implicit models, numerical derivatives.
"""

from slamlib.models.argument import Argument, AtMost
from slamlib.models.formula import FORMULA_PARTS, Formula, Jacobians, Model, calling, model

__all__ = ["FORMULA_PARTS", "Argument", "AtMost", "Formula", "Jacobians", "Model", "calling", "model"]
