"""Centre distances, size and envelope."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from gears.criteria.worked import TEETH, lengths, sets
from tmmcalc.gears.criteria.size import RACK, centre_distances, envelope, size
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets, Values

MODULE = (0.002, 0.003, 0.004)


def circles(train: ToothSets, module: Values, row: int) -> list[tuple[complex, float]]:
    """Centres and radii of all pitch circles, planets at equal angles."""
    scheme, z = train.scheme, dict(zip(train.scheme.wheels, train.teeth[row], strict=True))
    stage = {wheel: mesh.stage for mesh in scheme.meshes for wheel in (mesh.first, mesh.second)}
    r = {wheel: module[row, stage[wheel]] * z[wheel] / 2 for wheel in scheme.wheels}
    a = centre_distances(train, module)[row]
    found = []
    for wheel in scheme.wheels:
        if wheel in scheme.planets:
            away = a[2] if (train.layout, wheel) == ("2A-AA", "3") else a[0]
            turns = np.exp(2j * np.pi * np.arange(train.planets) / train.planets)
            found += [(away * turn, r[wheel]) for turn in turns]
        elif train.layout.startswith("unfolded"):
            found.append((complex(sum(a[: int(wheel[0]) - 1])), r[wheel]))
        else:
            found.append((0j, r[wheel]))
    return found


@pytest.mark.parametrize("layout", LAYOUTS)
def test_envelope_holds_all_circles(layout: str) -> None:
    branched = LAYOUTS[layout].branched
    for planets in (1, 3) if layout == "coaxial" else (3 if branched else 1,):
        train = sets(layout, TEETH[layout], planets)
        module = lengths(train, *MODULE)
        for row in range(len(train)):
            drawn = circles(train, module, row)
            if planets == 1:
                truth = max(c.real + r for c, r in drawn) - min(c.real - r for c, r in drawn)
            else:
                truth = 2 * max(abs(c) + r for c, r in drawn)
            assert envelope(train, module)[row] == pytest.approx(truth, rel=1e-14)
            assert size(train, module)[row] <= truth * (1 + 1e-14)


def test_formulas_of_the_textbook() -> None:
    unfolded = sets("unfolded3", [[17, 70, 18, 60, 19, 41]])
    truth = (2 * (2 * 17 + 70) + 3 * (18 + 60) + 4 * (19 + 2 * 41)) / 2
    assert size(unfolded, lengths(unfolded, *MODULE))[0] * 1000 == pytest.approx(truth, rel=1e-14)
    coaxial = sets("coaxial", [[26, 73, 17, 49]])
    assert size(coaxial, lengths(coaxial, *MODULE))[0] * 1000 == pytest.approx((2 * 172 + 3 * 49) / 2, rel=1e-14)
    pairs = sets("2A-AA", [[18, 27, 27, 72]], 3)
    assert size(pairs, lengths(pairs, *MODULE))[0] * 1000 == pytest.approx(2 * (27 + 72 + 27), rel=1e-14)
    rings = sets("II", [[90, 30, 40, 100]], 3)
    assert size(rings, lengths(rings, *MODULE))[0] == pytest.approx(0.3, rel=1e-14)


def test_ring_in_the_envelope() -> None:
    """In AI with a small second stage the circle of the planets is the larger, with a large one the ring."""
    train = sets("AI", [[40, 20, 60, 180]], 3)
    found = envelope(train, lengths(train, 0.002, 0.004))[0]
    assert found == pytest.approx(0.004 * 180, rel=1e-14)
    assert size(train, lengths(train, 0.002, 0.004))[0] == pytest.approx(0.002 * 80, rel=1e-14)
    single = sets("AIbar", [[18, 48, 114]], 3)
    assert size(single, lengths(single, 0.0025)) == envelope(single, lengths(single, 0.0025))


def test_operating_angles_move_the_axes() -> None:
    train = sets("2A-AA", [[18, 27, 27, 72]], 3)
    angles = np.full((1, 3), RACK)
    angles[0, 2] = math.radians(24)
    raised = replace(train, angles=angles)
    a = centre_distances(raised, lengths(raised, 0.002))[0]
    assert a[:2].tolist() == [0.045, 0.054]
    assert a[2] * math.cos(math.radians(24)) == pytest.approx(0.099 * math.cos(RACK), rel=1e-15)
    assert size(raised, lengths(raised, 0.002))[0] == pytest.approx(2 * a[2] + 0.054, rel=1e-14)


def test_equal_sizes_compare_as_equal() -> None:
    """Trains with the same Z1 + 2 Z2 differ in no bit, or the Pareto front would prefer rounding."""
    teeth = [[z1, (301 - z1) // 2, 17, 60] for z1 in range(17, 80, 2)]
    train = sets("AI", teeth, 3)
    assert len(set(size(train, lengths(train, 0.00175, 0.00225)).tolist())) == 1
