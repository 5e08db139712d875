"""Central differences of what a model computes, where `central_difference` takes those of its definition."""

from types import SimpleNamespace

from slamlib.models.numerical import central_difference


def differences(model, place, index, step=1e-6):
    """Jacobian w.r.t. one argument, on the tangent space, from the values of the generated code alone."""
    values = SimpleNamespace(definition=model, arguments=model.arguments, result=model.result)
    return central_difference(values, place, index, step)
