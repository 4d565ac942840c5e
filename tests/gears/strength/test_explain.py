"""Coefficients of a train give its modules; outcomes and remarks say the numbers."""

from __future__ import annotations

import re

import numpy as np
import pytest

from gears.strength.scenes import sets_of, steel_40kh, task_of
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.strength.explain import coefficients, reason, remarks
from tmmcalc.gears.strength.material import Hardness, Material
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StageTask, StrengthTask, pinion_torque


@pytest.mark.parametrize("layout", ["unfolded2", "unfolded3", "coaxial", "AI", "AA"])
def test_modules_follow_from_the_coefficients_shown(layout: str) -> None:
    """(4.38) and (4.41) with the numbers of the list; layouts with one mesh a stage."""
    sets, task = sets_of(layout, planets=1), task_of(60.0)
    result = solve_strength(sets, task)
    shown = coefficients(sets, task, 0)
    assert all(c.source and c.unit for c in shown)
    for mesh in LAYOUTS[layout].meshes:
        own = {c.symbol: c.value for c in shown if c.of == f"mesh {mesh.first}-{mesh.second}"}
        factor = own["(u - 1)/u" if mesh.internal else "(u + 1)/u"]
        m_H = own["A_H"] / own["Z"] * (factor * own["q"]) ** (1 / 3)
        m_F = own["A_F"] * (own["Y_F"] * own["q"] / own["Z"] ** 2) ** (1 / 3)
        assert result.contact_module[0, mesh.stage] == pytest.approx(m_H, rel=1e-13)
        assert result.bending_module[0, mesh.stage] == pytest.approx(m_F, rel=1e-13)
        assert own["T"] == pytest.approx(60.0 * own["q"], rel=1e-15)


def test_every_wheel_stage_and_mesh_is_shown() -> None:
    sets, task = sets_of("AII", planets=3), task_of(load=None)
    shown = coefficients(sets, task, 0)
    layout = LAYOUTS["AII"]
    owners = {f"wheel {w}" for w in layout.wheels} | {f"mesh {m.first}-{m.second}" for m in layout.meshes}
    assert {c.of for c in shown} == owners | {"train", "stage 1", "stage 2"}
    assert {*solve_strength(sets, task).coefficients} <= {*shown}
    assert len({(c.of, c.symbol) for c in shown}) == len(shown)
    given = StageTask(steel_40kh(), psi_bd=0.6, permissible_contact=5e8)
    of_wheel = [c for c in coefficients(sets, StrengthTask(5.0, (given,)), 0) if c.of == "wheel 1"]
    assert [c.source for c in of_wheel if c.symbol == "sigma_HP"] == ["given"]
    assert [c.value for c in of_wheel if c.symbol == "S_F'"] == [1.75]


def test_reasons_state_what_is_required_and_what_there_is() -> None:
    teeth = [[30, 138, 17, 113], [25, 136, 20, 112]]
    sets = sets_of("AI", teeth, planets=3)
    result = solve_strength(sets, task_of(75.0, on_overload="reject"))
    required = 1000 * result.required[0]
    assert reason(result, 0) == (
        f"strength of stage 2 is not satisfied: {required[0]:.4g}, {required[1]:.4g} mm required, 2, 3.5 mm there"
    )
    assert reason(result, 1) == "strong enough"
    huge = solve_strength(sets, task_of(1e7))
    assert "no standard module is large enough" in reason(huge, 0)
    odd = solve_strength(sets_of("AI", proportion=[101, 103], planets=3), task_of(75.0))
    assert "no standard modules stand in this proportion" in reason(odd, 0)
    weak = solve_strength(sets, task_of(75.0, modules=(0.002,)))
    assert "strength of stage 2 is not satisfied" in reason(weak, 0)
    apart = solve_strength(sets, task_of(75.0, modules=(0.002, 0.003)))
    assert "do not stand in the proportion" in reason(apart, 0)
    assert "2, 3 mm given" in reason(apart, 0)


def test_the_cause_of_an_overload_is_named_with_the_number_that_is_enough() -> None:
    """The width that is asked for is enough, a millimetre less is not; a module that is too small is named itself."""
    sets = sets_of("AI", [[22, 118, 17, 97]], planets=3)
    required = solve_strength(sets, task_of(60.0)).required[0]
    modules = (4e-3, 7e-3)
    assert (required < modules).all()

    def checked(first: float, given: tuple[float, float] = modules) -> str:
        return reason(solve_strength(sets, task_of(60.0, modules=given, widths=(first, 0.2))), 0)

    narrow = re.search(r"stage 1 has the width 1 mm, (\d+) mm needed at this module$", checked(0.001))
    assert narrow is not None
    enough = int(narrow[1]) / 1000
    assert checked(enough) == "strong enough"
    assert "width" in checked(enough - 0.001)
    small = checked(0.001, (1e-3, 1.75e-3))
    assert f"stage 1 has the module 1 mm, {1000 * required[0]:.4g} mm needed at psi_bd" in small


def test_load_distribution_is_that_of_the_real_width() -> None:
    sets, task = sets_of("AI", planets=3), task_of(60.0, modules=(2e-3, 3.5e-3), widths=(0.019, 0.037))
    shown = {(c.of, c.symbol): c for c in coefficients(sets, task, 0)}
    z = int(sets.of("1")[0])
    psi, beta = 19 / (2 * z), shown["stage 1", "beta_H"].value
    assert shown["stage 1", "psi"].value == pytest.approx(psi, rel=1e-13)
    assert shown["stage 1", "K_Hbeta"].value == pytest.approx(1 + beta * psi, rel=1e-13)
    assert shown["stage 1", "K_Hbeta"].source == "1 + beta_H psi, of the real width"
    assert shown["stage 1", "K_Fbeta"].source == "1 + beta_F psi, of the real width"


def test_the_wheel_that_governs_the_bending_is_shown() -> None:
    """A wheel of a weaker material decides: its coefficients give the module, and both wheels are shown."""
    hard = Material("carburised", Hardness(58.0, "HRC"), "18KhGT")
    soft = Material("improved", Hardness(280.0, "HB"), "40KhN")
    task = StrengthTask(40.0, (StageTask(hard, soft),))
    sets = sets_of("unfolded2", [[17, 61, 18, 41]], planets=1)
    own = {c.symbol: c for c in coefficients(sets, task, 0) if c.of == "mesh 1-2"}
    m_F = own["A_F"].value * (own["Y_F"].value / own["Z"].value ** 2) ** (1 / 3)
    assert solve_strength(sets, task).bending_module[0, 0] == pytest.approx(m_F, rel=1e-13)
    assert own["Y_F"].value == pytest.approx(3.568 + 201.95 / 61**2, rel=1e-13)
    assert "of wheel 2, which governs" in own["A_F"].source
    assert own["Y_F of wheel 1"].value == pytest.approx(3.568 + 201.95 / 17**2, rel=1e-13)
    assert own["sigma_FP"].value < own["sigma_FP of wheel 1"].value
    assert "of wheel 1, which does not govern" in own["A_F of wheel 1"].source


def test_remarks() -> None:
    sets = sets_of("AI", [[28, 133, 17, 109], [14, 60, 20, 90]], planets=3)
    result = solve_strength(sets, task_of(75.0))
    told = [str(remark) for remark in remarks(result, 0)]
    assert any(line.startswith("stage 1: psi* = ") and "outside Table D.4.2" in line for line in told)
    assert "stage 1: b/m = 1 is narrow, below 6" in told
    assert any("fewer than 15 teeth" in str(remark) for remark in remarks(result, 1))
    wide = solve_strength(sets, task_of(75.0, modules=(0.001, 0.00175), widths=(0.05, 0.05)))
    assert "stage 1: b/m = 50 is wide, above 40" in [str(remark) for remark in remarks(wide, 0)]
    weak = solve_strength(sets, task_of(75.0, modules=(0.001,)))
    assert any("the contact stress is" in str(remark) for remark in remarks(weak, 0))
    printed = solve_strength(sets_of("unfolded2"), task_of(22.0, psi=0.9, width_rule="book1992"))
    assert printed.accepted.all()
    assert any("above the permissible one" in str(remark) for remark in remarks(printed, 0))


def test_usual_trains_have_no_remarks() -> None:
    module = solve_strength(sets_of("unfolded2"), task_of(22.0, psi=0.9)).required[0]
    exact = solve_strength(sets_of("unfolded2"), task_of(22.0, psi=0.9, modules=tuple(map(float, module))))
    assert remarks(exact, 0) == ()
    assert np.isclose(exact.psi, 0.9).all()


def test_torque_from_a_reduced_moment() -> None:
    assert pinion_torque(-1980.0, 15.0) == 132.0
    assert pinion_torque(1980.0, -15.0) == 132.0
    for moment, ratio in ((0.0, 15.0), (1980.0, 0.0), (float("inf"), 15.0), (1980.0, float("nan"))):
        with pytest.raises(UsageError, match="finite and not zero"):
            pinion_torque(moment, ratio)
