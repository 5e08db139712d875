"""The same numbers everywhere? Prints, as JSON, what slamlib computes from fixed inputs: run here and in the page."""

import importlib
import importlib.util
import json
import pkgutil
from typing import Any

import numpy as np

import slamlib
from slamlib.belief import Belief
from slamlib.errors import SingularPointError
from slamlib.evaluation.consistency import nees, nis
from slamlib.kalman.chi_square import chi2_cdf, chi2_quantile
from slamlib.models import FORMULA_PARTS, Model


def formula_models() -> dict[str, Model]:
    """Every generated model of the package, by name."""
    found: dict[str, Model] = {}
    for part in FORMULA_PARTS:
        if importlib.util.find_spec(f"slamlib.{part}") is None:
            continue
        package = importlib.import_module(f"slamlib.{part}")
        for info in pkgutil.iter_modules(package.__path__):
            module = importlib.import_module(f"{package.__name__}.{info.name}")
            own = [m for m in vars(module).values() if isinstance(m, Model) and m.module == module.__name__]
            found |= {f"{m.module.removeprefix('slamlib.')}.{m.name}": m for m in own}
    return dict(sorted(found.items()))


def of_model(model: Model, rng: np.random.Generator) -> list[Any]:
    """Value and Jacobians, one item and five at once."""
    items = [_defined(model, rng) for _ in range(5)]
    numbers: list[Any] = []
    for arguments in (items[0], [np.stack(column) for column in zip(*items, strict=True)]):
        value, jacobians = model.jac(*arguments)
        numbers += [value, *jacobians]
    return numbers


def _defined(model: Model, rng: np.random.Generator) -> list[Any]:
    """Random arguments at which the model has a value: not every matrix is a rotation."""
    while True:
        spaces = ((a.shape, a.manifold) for a in model.arguments)
        arguments = [
            rng.standard_normal(shape) if manifold is None else manifold.random(rng) for shape, manifold in spaces
        ]
        try:
            model.jac(*arguments)
            return arguments
        except SingularPointError:
            continue


def of_filter(rng: np.random.Generator) -> list[Any]:
    """A joint belief through prediction, a new landmark, and updates by each method."""
    numbers: list[Any] = []
    for method in ("batch", "scalar"):
        belief = Belief()
        root = rng.standard_normal((6, 6))
        robot = belief.add(6, rng.standard_normal(6), covariance=root @ root.T)
        J = rng.standard_normal((3, 6))
        landmark = belief.add(3, rng.standard_normal(3), given=[robot], jacobians=[J], covariance=np.eye(3))
        F, H = rng.standard_normal((6, 6)), [rng.standard_normal((2, 6)), rng.standard_normal((2, 3))]
        belief.predict(robot, rng.standard_normal(6), F, np.eye(6))
        root = rng.standard_normal((2, 2))
        done = belief.update([robot, landmark], H, rng.standard_normal(2), root @ root.T + np.eye(2), method=method)
        numbers += [robot.mean, landmark.mean, belief.covariance(robot), belief.covariance(robot, landmark), done.nis]
    return numbers


def of_evaluation(rng: np.random.Generator) -> list[Any]:
    """Consistency statistics and chi-square probabilities."""
    root = rng.standard_normal((7, 3, 3))
    P = root @ root.swapaxes(-1, -2) + np.eye(3)
    errors = rng.standard_normal((7, 3))
    probabilities = [chi2_quantile(p, dof) for p in (0.025, 0.5, 0.975) for dof in (1, 2, 6, 300)]
    return [nees(errors, P), nis(errors, P), probabilities, [chi2_cdf(x, 4) for x in (0.1, 3.0, 30.0)]]


def numbers() -> dict[str, list[float]]:
    """All of them: name -> list of floats."""
    rng = np.random.default_rng(20)
    found = {name: of_model(model, rng) for name, model in formula_models().items()}
    found |= {"belief: predict, add, correct": of_filter(rng), "evaluation: NEES, NIS, chi-square": of_evaluation(rng)}
    return {name: [float(x) for v in values for x in np.ravel(v)] for name, values in found.items()}


print(json.dumps({"numpy": np.__version__, "slamlib": slamlib.__version__, "numbers": numbers()}))
