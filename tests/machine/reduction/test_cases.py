"""Worked cases of reduced moments and reduced inertia, with their own tolerances."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from linkage.forces.worked import CASES, DEGREE, press, press_loading
from linkage.scenes import bar, four_bar, full_turn, pin, shaper, slide, with_input

from tmmcalc import solve_kinematics
from tmmcalc.linkage.loading import Body, Load, Loading, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.model import Assembly, Input, Link, Mechanism, Output
from tmmcalc.machine.reduction.inertia import lumped, reduced_inertia
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.machine.reduction.solve import solve_reduction


def like(case: str, key: str, found: Any) -> None:
    """The value agrees with the case within the case's own tolerance; facts have six digits."""
    tolerance = CASES[case]["tolerance"]
    np.testing.assert_allclose(
        found,
        CASES[case]["expected"][key],
        rtol=max(tolerance.get("rel", 0.0), 5e-6),
        atol=tolerance.get("abs", 1e-9),
        err_msg=f"{case} {key}",
    )


def part(result: Reduction, name: str) -> tuple[Contribution, Any]:
    """A contribution by its name, and its moment at the positions."""
    k = next(k for k, c in enumerate(result.contributions) if c.name == name)
    return result.contributions[k], result.moment[k]


@cache
def pressed() -> Reduction:
    mechanism, kinematics = press()
    return solve_reduction(mechanism, press_loading(), kinematics)


class TestPress:
    """dyn-press-reduced: useful resistance, weights, friction."""

    case = "dyn-press-reduced"

    def test_moments(self) -> None:
        like(self.case, "M_C", part(pressed(), "Q")[1])
        like(self.case, "M_G", part(pressed(), "weight")[1])
        friction = np.array(part(pressed(), "friction")[1])
        expected = np.array(CASES[self.case]["expected"]["M_F"])
        # at 270 degrees the book takes the limit before the position, the stage that after it
        rows = np.arange(13) != 9
        np.testing.assert_allclose(friction[rows], expected[rows], rtol=1e-4)

    def test_work(self) -> None:
        useful, friction, weight = (part(pressed(), name)[0] for name in ("Q", "friction", "weight"))
        like(self.case, "A_C_simpson12", useful.simpson)
        like(self.case, "A_C_exact", useful.work)
        like(self.case, "A_F_fine", friction.work)
        assert weight.work == pytest.approx(0.0, abs=1e-12)
        assert friction.simpson == pytest.approx(CASES[self.case]["expected"]["A_F_simpson12"], rel=3e-3)

    def test_efficiency_and_power(self) -> None:
        expected = CASES[self.case]["expected"]
        useful, friction = (part(pressed(), name)[0] for name in ("Q", "friction"))
        assert useful.work / (useful.work + friction.work) == pytest.approx(expected["eta_fine"], abs=0.0005)
        simpson = useful.simpson + friction.simpson
        assert useful.simpson / simpson == pytest.approx(expected["eta_simpson12"], abs=0.0005)
        # of Simpson's values; friction may differ by 0.3 %, for the book takes the other limit at 270 degrees
        assert -simpson * 5.0 / (2 * np.pi) == pytest.approx(expected["P_W"], rel=6e-4)


class TestPressInertia:
    """dyn-reduced-inertia-press: the rod as it is, and as two masses in its pins."""

    case = "dyn-reduced-inertia-press"

    def test_exact_and_lumped(self) -> None:
        like(self.case, "J_exact", pressed().inertia)
        like(self.case, "J_lumped", pressed().other)
        assert (pressed().rods, pressed().rod_links) == ("exact", (2,))

    def test_the_derivative_of_the_lumped_inertia(self) -> None:
        mechanism, kinematics = press()
        result = solve_reduction(mechanism, press_loading(), kinematics, rods="lumped")
        like(self.case, "J_lumped", result.inertia)
        like(self.case, "J_exact", result.other)
        assert result.rods == "lumped"
        like(self.case, "dJ_dphi_lumped", result.slope)

    def test_masses_in_the_pins(self) -> None:
        mechanism, _ = press()
        at_a, at_b = lumped(mechanism, press_loading(), (2,))[:2]
        assert (at_a.center, at_b.center) == (0, 0.168)
        like(self.case, "m_A_lump", at_a.mass)
        like(self.case, "m_B_lump", at_b.mass)


def test_shaper() -> None:
    """dyn-shaper-reduced: the cutting force in positions 2 to 12, the rocker and the ram."""
    case = "dyn-shaper-reduced"
    mechanism = with_input(shaper(positions=24), speed=5.0)
    kinematics = solve_kinematics(mechanism)
    loading = Loading(
        bodies=(Body(3, 55.0, 4.5, 0.5 + 0j), Body(5, 190.0, 0.0, 0j)),
        loads=(Load("Q", 5, "force", Constant(7500.0), window=Window(positions=("2", "12"))),),
    )
    result = solve_reduction(mechanism, loading, kinematics)
    assert CASES[case]["inputs"]["J_3_about_B"] == 4.5 + 55 * 0.5**2
    like(case, "M_Q_Nm", part(result, "Q")[1])
    like(case, "J_var_kgm2", result.inertia)
    like(case, "A_Q_exact_J", part(result, "Q")[0].work)
    moment = part(result, "Q")[1][2:13]
    simpson = 15 * DEGREE / 3 * (moment[0] + moment[-1] + 4 * moment[1:-1:2].sum() + 2 * moment[2:-2:2].sum())
    like(case, "A_Q_simpson_2_12_J", simpson)


def v_engine() -> Mechanism:
    """Two central rods on one crank pin; the right cylinder lies along x, the left one along y."""
    given = CASES["dyn-vengine-table31"]["inputs"]
    l1, rod = given["l1"], given["l_rod"]
    mechanism = Mechanism(
        Link(0, {"O": 0j}),
        (bar(1, O=0, A=l1), bar(2, A=0, B=rod), bar(3, B=0), bar(4, A=0, D=rod), bar(5, D=0)),
        (
            pin("O", 0, 1),
            pin("A", 1, 2, l1),
            pin("B", 2, 3, rod),
            slide("B0", 3, 0),
            pin("A4", 1, 4, l1),
            pin("D", 4, 5, rod),
            slide("D0", 5, 0, 0, given["cylinder_angle_deg"] * DEGREE),
        ),
        Input("O", 150.0, start=np.pi),
        (Output(point="B"), Output(point="D", direction=np.pi / 2)),
        assembly=Assembly(variants={(2, 3): 1, (4, 5): 1}),
    )
    return full_turn(mechanism, np.pi, 12)


def test_v_engine() -> None:
    """dyn-vengine-table31: tables of gas forces, positive outwards along each cylinder."""
    case = "dyn-vengine-table31"
    given, mechanism = CASES[case]["inputs"], v_engine()
    angles = tuple(30 * DEGREE * i for i in range(13))

    def gas(name: str, link: int, key: str, direction: complex) -> Load:
        table = Tabulated("angle", angles, tuple(1e3 * q for q in given[key]), period=2 * np.pi)
        return Load(name, link, "force", table, direction=direction, role="drive")

    mass = given["m_reciprocating_each_kg"]
    loading = Loading(
        bodies=(Body(3, mass, 0.0, 0j), Body(5, mass, 0.0, 0j)),
        loads=(gas("right", 3, "Q_right_kN", 1 + 0j), gas("left", 5, "Q_left_kN", 1j)),
    )
    kinematics = solve_kinematics(mechanism)
    result = solve_reduction(mechanism, loading, kinematics)
    like(case, "S_right_analog_m", kinematics.ds[0])
    like(case, "S_left_analog_m", kinematics.ds[1])
    like(case, "M_right_kNm", part(result, "right")[1] / 1e3)
    like(case, "M_left_kNm", part(result, "left")[1] / 1e3)
    like(case, "M_total_kNm", result.total / 1e3)
    like(case, "J_var_1e3_kgm2", result.inertia * 1e3)
    assert result.grades == ()


def test_four_bar_inertia() -> None:
    """dyn-fourbar-forces: its reduced inertia, in the assembly that is given."""
    case = "dyn-fourbar-forces"
    mechanism = with_input(full_turn(four_bar(0.1, 0.35, 0.25, 0.38 + 0.05j), 0.0, 6), speed=12.0)
    loading = Loading(bodies=(Body(2, 4.0, 0.05, 0.15 + 0j), Body(3, 3.0, 0.02, 0.12 + 0j)))
    result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
    like(case, "J_var", result.inertia[:6])


def test_closed_form_of_a_crank_slider() -> None:
    """J = m S'^2 and dJ = 2 m S' S'' (3.65)."""
    mechanism, kinematics = press()
    result = solve_reduction(mechanism, Loading(bodies=(Body(3, 7.0, 0.0, 0j),)), kinematics)
    np.testing.assert_allclose(result.inertia, 7.0 * kinematics.ds[0] ** 2, atol=1e-16)
    np.testing.assert_allclose(result.slope, 14.0 * kinematics.ds[0] * kinematics.dds[0], atol=1e-16)
    assert reduced_inertia((), None, 3)[0].tolist() == [0.0, 0.0, 0.0]
