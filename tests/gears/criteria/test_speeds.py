"""Speeds of the layouts against the linear equations of their meshes."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gears.criteria.worked import TEETH, sets
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.criteria.speeds import speeds
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.scheme import CARRIER


def solved(train: ToothSets, row: int, over: str) -> dict[str, float]:
    """Speeds of one train from one linear system: meshes, common shafts, what stands, ``over`` = 1."""
    scheme = train.scheme
    names = [*scheme.wheels, CARRIER]
    z = dict(zip(scheme.wheels, train.teeth[row], strict=True))
    equations, right = [], []

    def equation(terms: dict[str, float], value: float) -> None:
        equations.append([terms.get(name, 0.0) for name in names])
        right.append(value)

    for mesh in scheme.meshes:
        sign = 1 if mesh.internal else -1
        terms = {mesh.first: float(z[mesh.first]), mesh.second: -sign * float(z[mesh.second])}
        equation({**terms, CARRIER: sign * float(z[mesh.second]) - float(z[mesh.first])}, 0.0)
    for wheel in scheme.wheels:
        if wheel.endswith("'"):
            equation({wheel: 1.0, wheel[:-1]: -1.0}, 0.0)
    equation({train.scheme.fixed or CARRIER: 1.0}, 0.0)
    equation({over: 1.0}, 1.0)
    return dict(zip(names, np.linalg.solve(np.array(equations), np.array(right)), strict=True))


@pytest.mark.parametrize("layout", LAYOUTS)
def test_against_the_equations_of_the_meshes(layout: str) -> None:
    train = sets(layout, TEETH[layout])
    for over in (None, "1", "2"):
        found = speeds(train, over)
        for row in range(len(train)):
            truth = solved(train, row, over or train.scheme.output)
            assert found.ratios.values[row] == pytest.approx(
                [truth[shaft] for shaft in found.shafts], rel=1e-12, abs=1e-12
            )


def test_ratios_are_exact() -> None:
    found = speeds(sets("AI", TEETH["AI"])).exact("1")
    truth = [1 + Fraction(118 * 97, 22 * 17), 1 + Fraction(136 * 112, 25 * 20)]
    pairs = zip(found.numerators.tolist(), found.denominators.tolist(), strict=True)
    assert [Fraction(*pair) for pair in pairs] == truth
    assert [Fraction(n, d).denominator for n, d in zip(found.numerators, found.denominators, strict=True)] == list(
        found.denominators
    )


def test_largest_teeth_stay_in_64_bits() -> None:
    """Three central wheels give products of many tooth numbers."""
    teeth = [[149, 151, 139, 347, 349]]
    z1, z2, p, z3, z4 = (Fraction(z) for z in teeth[0])
    found = speeds(sets("AII", teeth)).exact("1")
    truth = (1 + z3 / z1) / (1 - z3 * p / (z2 * z4))
    assert Fraction(int(found.numerators[0]), int(found.denominators[0])) == truth


def test_a_standing_shaft_is_named() -> None:
    train = sets("AA", [[20, 30, 20, 30], [20, 30, 30, 20]])  # the second has U = 1 and i_1H = 0
    assert speeds(train).of("1").tolist() == [-1.25, 0.0]
    with pytest.raises(NoSolutionError, match="1 of 2 trains, first Z = 20, 30, 30, 20"):
        speeds(train, "1")
    with pytest.raises(NoSolutionError, match="stands still"):
        speeds(train, "3")
    with pytest.raises(UsageError, match="no shaft"):
        speeds(train, "5")


def test_no_trains() -> None:
    assert speeds(sets("AI", [])).ratios.values.shape == (0, 5)
