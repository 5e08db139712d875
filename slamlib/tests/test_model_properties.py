"""Whatever a model is given, it returns finite numbers or reports what is wrong; its arguments stay as they are."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from slamlib.codegen.__main__ import models
from slamlib.errors import SlamlibError

ALL = [pytest.param(m, id=f"{path}:{m.name}") for path, own in models().items() for m in own]
ANY_NUMBER = st.floats(width=64, allow_nan=True, allow_infinity=True)


@st.composite
def any_argument(draw, argument):
    """Mostly the right shape, with leading axes or not; sometimes any shape. Mostly usable numbers; sometimes any."""
    lead = draw(st.sampled_from([(), (), (2,), (1, 3), (0,)]))
    shape = draw(st.one_of(st.just((*lead, *argument.shape)), array_shapes(max_dims=3, max_side=7)))
    values = arrays(np.float64, shape, elements=draw(st.sampled_from([ANY_NUMBER, st.floats(-10, 10)])))
    value = draw(values)
    if argument.is_manifold and draw(st.booleans()) and shape[-1:] == argument.shape:
        seed = draw(st.integers(0, 99))
        point = argument.manifold.random(np.random.default_rng(seed))
        value = np.broadcast_to(point, shape).copy()
    return value


@pytest.mark.parametrize("model", ALL)
@settings(max_examples=60, deadline=None, derandomize=True)
@given(data=st.data())
def test_finite_numbers_or_a_clear_error(model, data):
    arguments = [data.draw(any_argument(a)) for a in model.arguments]
    before = [a.copy() for a in arguments]
    try:
        value, jacobians = model.jac(*arguments)
    except SlamlibError as error:
        assert model.name in str(error)
    else:
        assert np.isfinite(value).all()
        assert all(np.isfinite(j).all() for j in jacobians)
        lead = np.broadcast_shapes(
            *(a.shape[: a.ndim - len(s.shape)] for a, s in zip(arguments, model.arguments, strict=True))
        )
        assert value.shape[: len(lead)] == lead
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(arguments, before, strict=True))
