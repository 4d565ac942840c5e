"""Masses and inertias against integration over the bodies, and reduced inertia against kinetic energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gears.criteria.test_speeds import solved
from gears.criteria.worked import TEETH, lengths, sets
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.criteria.inertia import reduced_inertia
from tmmcalc.gears.criteria.wheels import Build, wheels
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.scheme import CARRIER

MODULE, WIDTH = (0.002, 0.003, 0.004), (0.02, 0.035, 0.05)


def ring_by_quadrature(inner: float, outer: float, width: float, density: float) -> tuple[float, float]:
    """Mass and inertia of a hollow cylinder by Gauss-Legendre integration over thin tubes."""
    points, weights = np.polynomial.legendre.leggauss(8)
    r = inner + (outer - inner) * (points + 1) / 2
    tubes = weights * (outer - inner) / 2 * 2 * math.pi * r * width * density
    return float(tubes.sum()), float((tubes * r**2).sum())


def test_pinion_wheel_and_ring() -> None:
    build = Build()
    train = sets("AII", TEETH["AII"][:1], planets=3)
    made = wheels(train, lengths(train, *MODULE), lengths(train, *WIDTH))
    pinion = ring_by_quadrature(0.0, 0.020, 0.02, build.density)
    assert (made.masses[0, 0], made.inertias[0, 0]) == pytest.approx(pinion, rel=1e-12)
    solid = ring_by_quadrature(0.0, 0.040, 0.02, build.density)
    assert made.masses[0, 1] == pytest.approx(0.434 * solid[0], rel=1e-12)
    assert made.inertias[0, 1] == pytest.approx(0.434 * 1.21 * solid[1], rel=1e-12)
    ring = ring_by_quadrature(0.135, 0.135 + 3.75 * 0.003, 0.035, build.density)
    assert (made.masses[0, 4], made.inertias[0, 4]) == pytest.approx(ring, rel=1e-12)
    assert made.masses[0, 3] == made.inertias[0, 3] == 0  # the fixed ring
    assert made.mass[0] == pytest.approx(made.masses[0] @ [1, 3, 3, 1, 1], rel=1e-14)


def test_outer_planet_of_the_pair_is_twice_as_wide() -> None:
    train = sets("2A-AA", [[18, 27, 27, 72]], planets=3)
    made = wheels(train, lengths(train, *MODULE), lengths(train, *WIDTH))
    assert made.masses[0, 2] == pytest.approx(2 * made.masses[0, 1], rel=1e-15)
    assert made.masses[0, 3] == 0


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_wheel_moves_or_is_fixed(layout: str) -> None:
    still = set(LAYOUTS[layout].wheels) - set(LAYOUTS[layout].moving)
    assert still == ({LAYOUTS[layout].fixed} - {""})


def energy(train: ToothSets, module: Values, width: Values, row: int, over: str) -> float:
    """Twice the kinetic energy at unit speed of a shaft, planets as points that travel with their own spin.

    Velocities of the planets' centres come from a difference of positions over a small turn of the carrier.
    """
    made = wheels(train, module, width)
    speed = solved(train, row, over)
    z, m = dict(zip(train.scheme.wheels, train.teeth[row], strict=True)), module[row]
    total = 0.0
    for column, wheel in enumerate(train.scheme.wheels):
        number = train.planets if wheel in train.scheme.planets else 1
        total += number * made.inertias[row, column] * speed[wheel] ** 2
        if wheel in train.scheme.planets:
            if wheel == "3":
                radius = m[0] * (z["3"] + z["4"]) / 2
            else:
                radius = m[0] * (z["1"] - z["2"] if layout_is_inner(train) else z["1"] + z["2"]) / 2
            turn = 1e-4
            step = 2 * radius * math.sin(turn / 2) / (turn * (1 - turn**2 / 24))
            total += number * made.masses[row, column] * (step * speed[CARRIER]) ** 2
    return total


def layout_is_inner(train: ToothSets) -> bool:
    return train.scheme.meshes[0].internal


@pytest.mark.parametrize("layout", LAYOUTS)
def test_reduced_inertia_is_the_kinetic_energy(layout: str) -> None:
    train = sets(layout, TEETH[layout], planets=3 if LAYOUTS[layout].branched else 1)
    module, width = lengths(train, *MODULE), lengths(train, *WIDTH)
    for to in (None, "1", "2"):
        found = reduced_inertia(train, module, width, to)
        truth = [energy(train, module, width, row, to or train.scheme.output) for row in range(len(train))]
        assert found == pytest.approx(truth, rel=1e-11)


def test_the_book_formula_of_three_stages() -> None:
    train = sets("unfolded3", TEETH["unfolded3"])
    module, width = lengths(train, *MODULE), lengths(train, *WIDTH)
    j = wheels(train, module, width).inertias.T
    u1, u2, u3 = (train.teeth[:, k + 1] / train.teeth[:, k] for k in (0, 2, 4))
    truth = j[0] * (u1 * u2 * u3) ** 2 + (j[1] + j[2]) * (u2 * u3) ** 2 + (j[3] + j[4]) * u3**2 + j[5]
    assert reduced_inertia(train, module, width) == pytest.approx(truth, rel=1e-13)


def test_reduction_to_another_shaft_is_the_square_of_speeds() -> None:
    train = sets("AI", TEETH["AI"], planets=3)
    module, width = lengths(train, *MODULE), lengths(train, *WIDTH)
    at_carrier, at_sun = (reduced_inertia(train, module, width, to) for to in (CARRIER, "1"))
    i = 1 + np.array([118 * 97 / (22 * 17), 136 * 112 / (25 * 20)])
    assert at_sun * i**2 == pytest.approx(at_carrier, rel=1e-13)
    with pytest.raises(NoSolutionError):
        reduced_inertia(train, module, width, "3")
