"""Accelerations without a term, against the vector equations of a slotted link and a crank-slider written out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from mistakes import CONFIGS, items, key, wrong

from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.results import Terms
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project import load_spec

R, D = 0.250, 0.100  # crank and distance of the pivots of configs/slotted-link.toml
CRANK, ROD, OFFSET = 0.100, 0.320, -0.040  # of configs/crank-slider.toml
LINKAGES = ("shaper", "slotter", "four-dyads", "class-three", "class-four", "hydraulic-lift", "trammel", "slotted-link")
HEAVY = (
    *("mechanism.links[id=3].mass=30", "mechanism.links[id=3].inertia=2.5", "mechanism.links[id=3].center=[0.2, 0.03]"),
    *("mechanism.gravity=0", 'mechanism.input.speed="7 rad/s"'),
)


def slotted(phi: float, coriolis: float, normal: float) -> tuple[float, float, float]:
    """Rate and second rate of the slotted link, second of the block: a_A = (-n w^2 s + s'' + i(eps s + c 2 w s')) e."""
    q = R * np.exp(1j * phi) + 1j * D
    e, s = q / abs(q), abs(q)
    v, a = 1j * R * np.exp(1j * phi) / e, -R * np.exp(1j * phi) / e
    omega, sliding = v.imag / s, v.real
    return omega, (a.imag - coriolis * 2 * omega * sliding) / s, a.real + normal * omega**2 * s


@pytest.mark.parametrize(
    ("mistake", "coriolis", "normal"),
    [("coriolis_left_out", 0.0, 1.0), ("coriolis_once", 0.5, 1.0), ("normal_left_out", 1.0, 0.0)],
)
@pytest.mark.parametrize("position", [2, 5, 13, 20])
def test_a_slotted_link_without_a_term(mistake: str, coriolis: float, normal: float, position: int) -> None:
    asked = f"kinematics.eps_3@{position} rad/s^2", f"kinematics.a_A3@{position} m/s^2"
    found = wrong("slotted-link", f"linkage.{mistake}", *asked)
    _, eps, sliding = slotted(np.radians(15 * position), coriolis, normal)
    assert found == pytest.approx([eps, sliding], rel=1e-11)


@pytest.mark.parametrize("position", [1, 4, 9])
def test_a_piston_without_the_normal_acceleration_of_its_rod(position: int) -> None:
    """a_B = a_A + i eps l e^(i psi) along x; the crank's own normal acceleration is there."""
    angle, got = wrong(
        "crank-slider",
        "linkage.normal_left_out",
        f"kinematics.angle_1@{position} rad",
        f"kinematics.aS_B@{position} m/s^2",
    )
    psi = np.arcsin((OFFSET - CRANK * np.sin(angle)) / ROD)
    a = -CRANK * np.exp(1j * angle)
    eps = -a.imag / (ROD * np.cos(psi))
    assert got == pytest.approx((a + 1j * eps * ROD * np.exp(1j * psi)).real, rel=1e-11)


@pytest.mark.parametrize("name", LINKAGES)
def test_with_all_terms_they_are_those_of_the_groups(name: str) -> None:
    """Closure of all joints at once and elimination group by group are two ways to the same accelerations."""
    mechanism = to_linkage(load_spec(CONFIGS / f"{name}.toml").linkage)
    one, other = solve_kinematics(mechanism), solve_kinematics(mechanism, terms=Terms())
    for stack in ("ddr", "ddangle", "dds"):
        own: Any = getattr(one.trace, stack)
        if own.size:
            scale = max(float(np.max(np.abs(own))), 1e-6)
            assert np.max(np.abs(own - getattr(other.trace, stack))) < 1e-9 * scale, stack
    assert [each.acceleration[1].value for each in one.summaries] == pytest.approx(
        [each.acceleration[1].value for each in other.summaries], rel=1e-9, abs=1e-12
    )


@pytest.mark.parametrize(("mistake", "coriolis", "normal"), [("coriolis_left_out", 0, 1), ("normal_left_out", 1, 0)])
def test_the_drive_carries_the_error_of_the_accelerations(mistake: str, coriolis: float, normal: float) -> None:
    """M of the drive by virtual power, M w = m a_S v_S + J eps w_3, with the wrong a_S and eps."""
    (got,) = wrong("slotted-link", f"linkage.{mistake}", "forces.M_drive@7 N*m", sets=HEAVY)
    phi, speed = np.radians(105), 7.0
    omega, eps, _ = slotted(phi, coriolis, normal)
    q = R * np.exp(1j * phi) + 1j * D
    arm = (0.2 + 0.03j) * q / abs(q)
    v, a = 1j * omega * arm, (1j * eps - normal * omega**2) * arm
    work = 30 * (a * np.conj(v)).real + 2.5 * eps * omega
    assert got == pytest.approx(work * speed**2, rel=1e-10)


def test_a_fixed_guide_has_no_coriolis_term() -> None:
    asked = items("kinematics.aS_B@4 m/s^2", "kinematics.eps_2@4 rad/s^2")
    assert np.all(np.isnan(key("crank-slider", asked, "linkage.coriolis_left_out").mistaken))
