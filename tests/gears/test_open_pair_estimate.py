"""The estimates of the open pair against closed formulas in decimal arithmetic, over pairs and diagrams at random."""

from __future__ import annotations

import random
from decimal import Decimal, getcontext

import pytest

import tmmcalc
from tmmcalc.gears.openload import OpenLoad
from tmmcalc.pipeline.runner import run

getcontext().prec = 40
SPEC = """[torque]
formula = "-{mean!r} - {wave!r}*sin(theta)"
speed = "60 rpm"
[open_pair]
teeth = [{z_a}, {z_b}]
module = "{module} mm"
face_width = "{width} mm"
x1 = {shift}
strategy = "equal_shift"
material = {{ steel = "40Kh", treatment = "improved", hardness = "300 HB" }}
"""


def drawn(seed: int) -> tuple[dict[str, float], OpenLoad]:
    pick = random.Random(seed)
    values = {
        "mean": pick.uniform(10, 5000),
        "wave": pick.uniform(10, 5000),
        "z_a": pick.randint(18, 30),
        "z_b": pick.randint(40, 120),
        "module": pick.choice((2, 3, 5, 8)),
        "width": pick.randint(20, 90),
        "shift": round(pick.uniform(0.05, 0.25), 3),
    }
    results = run(tmmcalc.parse_spec(SPEC.format(**values)), target="open_pair").results
    return values, results["open_pair"]


@pytest.mark.parametrize("seed", range(12))
def test_estimates(seed: int) -> None:
    """T = M0 + M1 of M0 + M1 sin(theta); (4.38), (4.41) with K_d = 770 and K_m = 14 in N*m, mm, MPa."""
    values, found = drawn(seed)
    z_a, z_b, m, b = (Decimal(values[name]) for name in ("z_a", "z_b", "module", "width"))
    torque = Decimal(values["mean"]) + Decimal(values["wave"])
    pinion, u, psi = torque * z_a / z_b, z_b / z_a, b / (m * z_a)
    contact = (770**3 * pinion * (1 + psi / 2) * (u + 1) / u / (b * (m * z_a) ** 2)).sqrt() * 10**6
    form = Decimal("3.568") + Decimal("201.95") / z_a**2
    bending = 14**3 * pinion * (1 + Decimal("1.08") * psi) * form / (b * m * z_a * m) * 10**6
    assert found.strength is not None
    assert found.torque is not None
    told = (
        (found.torque, torque, found.error.torque),
        (float(found.strength.contact_stress[0, 0]), contact, found.error.contact_stress),
        (float(found.strength.bending_stress[0, 0]), bending, found.error.bending_stress),
    )
    for value, truth, error in told:
        assert abs(Decimal(value) / truth - 1) <= Decimal(error) + Decimal("4e-16")
        assert error < 1e-9
