"""Formulas of other variables than the angle of a torque diagram."""

from __future__ import annotations

import numpy as np
import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.core.expression import parse


def test_a_formula_of_x() -> None:
    formula = parse("x**2 - log(x)", variables=("x",), where="synthesis.function")
    x = np.linspace(0.5, 3, 7)
    assert formula(x) == pytest.approx(x**2 - np.log(x), rel=1e-15)


def test_faults_name_the_variable_and_the_place() -> None:
    formula = parse("sqrt(x)", variables=("x",), where="synthesis.function")
    with pytest.raises(UsageError, match=r"synthesis.function: .*no finite value at x = -1\n") as fault:
        formula(np.array([-1.0]))
    assert "rad" not in fault.value.message
    with pytest.raises(UsageError, match="unknown name 'theta'"):
        parse("theta", variables=("x",))
    with pytest.raises(UsageError, match="unknown name 'x'"):
        parse("x")
    with pytest.raises(UsageError) as broken:
        parse("2 +", variables=("x",))
    assert "x" in broken.value.remedy
