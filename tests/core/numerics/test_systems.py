"""Small systems of which some have no solution."""

from __future__ import annotations

import numpy as np
import pytest

from tmmcalc.core.numerics.systems import solve


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [float, np.longdouble])
def test_systems_without_a_solution_leave_the_others_alone(kind: type) -> None:
    """One is regular, one is singular, two have left the numbers."""
    matrix = np.array([[[2, 1], [1, 3]], [[1, 2], [2, 4]], [[np.nan, 1], [1, 1]], [[np.inf, 1], [1, 1]]], kind)
    right = np.array([[4, 7], [1, 1], [1, 1], [1, 1]], kind)
    x = solve(np.moveaxis(matrix, 0, -1), right.T)
    assert x[:, 0].tolist() == pytest.approx([1.0, 2.0], rel=1e-15)
    assert np.isnan(x[:, 1:]).all()
