"""Independent checks: stresses by the formulas in SI, back from stress to module, scaling laws, meshes one by one."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gears.strength.scenes import MM, MPA, random_sets, sets_of, steel_40kh, task_of
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.strength.loads import mesh_loads
from tmmcalc.gears.strength.material import Material, parse_hardness
from tmmcalc.gears.strength.series import Outcome
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StageTask, StrengthTask

CASED = Material("carburised", parse_hardness("60 HRC"), "20Kh", load="one-sided")


def direct(layout: str, task: StrengthTask, seed: int = 0) -> Any:
    """Required modules by (4.38) and (4.41) as printed, in mm, N*m and MPa, mesh by mesh and wheel by wheel."""
    sets = random_sets(layout, 40, seed)
    loads = mesh_loads(sets)
    stage = task.stages[0]
    assert stage.permissible_contact is not None
    assert stage.permissible_bending is not None
    assert stage.psi_bd is not None
    contact, bending = stage.permissible_contact / MPA, stage.permissible_bending / MPA
    K_H, K_F = 1 + 0.5 * stage.psi_bd, 1 + 1.08 * stage.psi_bd
    m_H, m_F = np.zeros((40, sets.scheme.stages)), np.zeros((40, sets.scheme.stages))
    for i in range(40):
        for k, mesh in enumerate(sets.scheme.meshes):
            z, u, q = loads.teeth[i, k], loads.u[i, k], loads.q[i, k]
            psi = stage.psi_bd * loads.reference[i, mesh.stage] / z  # b/d of this mesh's own pinion
            A_H = 770 * (task.torque * K_H / (sets.planets * psi * contact**2)) ** (1 / 3)
            A_F = 14 * (task.torque * K_F / (sets.planets * psi * bending)) ** (1 / 3)
            Y = 3.568 + 201.95 / z**2
            sign = -1 if mesh.internal else 1
            m_H[i, mesh.stage] = max(m_H[i, mesh.stage], A_H / z * ((u + sign) / u * q) ** (1 / 3))
            m_F[i, mesh.stage] = max(m_F[i, mesh.stage], A_F * (Y * q / z**2) ** (1 / 3))
    return sets, m_H * MM, m_F * MM


@pytest.mark.parametrize("layout", LAYOUTS)
def test_modules_by_the_printed_formulas(layout: str) -> None:
    """With one permissible stress of all wheels the pinion is the weaker tooth, as the textbook takes it."""
    stage = StageTask(psi_bd=0.6, row=1, permissible_contact=609 * MPA, permissible_bending=200.6 * MPA)
    sets, m_H, m_F = direct(layout, StrengthTask(50.0, (stage,)))
    result = solve_strength(sets, StrengthTask(50.0, (stage,)))
    np.testing.assert_allclose(result.contact_module, m_H, rtol=1e-13)
    np.testing.assert_allclose(result.bending_module, m_F, rtol=1e-13)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_stress_at_the_required_module_is_the_permissible_one(layout: str) -> None:
    sets = random_sets(layout, 12, 1)
    task = replace(task_of(50.0, load=None))
    required = solve_strength(sets, task)
    for i in range(12):
        one = replace(sets, teeth=sets.teeth[i : i + 1], modules=sets.modules[i : i + 1], angles=sets.angles[i : i + 1])
        for k in range(sets.scheme.stages):
            for module, name in ((required.contact_module, "contact"), (required.bending_module, "bending")):
                # the modules of one stage at its limit; those of the others follow
                modules = module[i] if not sets.scheme.branched else module[i, k] * sets.modules[i] / sets.modules[i, k]
                found = solve_strength(one, replace(task, modules=tuple(float(m) for m in modules)))
                assert abs(getattr(found, f"{name}_margin")[0, k]) < 1e-12


@pytest.mark.parametrize("layout", LAYOUTS)
def test_designed_trains_bear_their_load(layout: str) -> None:
    sets = random_sets(layout, 300, 2)
    for rules in ({}, {"rows": 1}, {"underrun": 0.03}, {"rounding": "floor1"}, {"iterate": True}):
        result = solve_strength(sets, task_of(40.0, load=None, **rules))
        accepted = result.accepted
        assert accepted.sum() > 20
        assert np.minimum(result.contact_margin, result.bending_margin)[accepted].min() >= -1e-12
        for array in (result.module, result.width, result.psi, result.contact_stress, result.bending_stress):
            assert np.isfinite(array).all()
            assert (array > 0).all()
        # the width is the least: a millimetre less would not do
        less = result.width - 1.001 * MM
        share = np.maximum((1 - result.contact_margin) ** 2, 1 - result.bending_margin) * result.width
        usable = accepted[:, None] & (less > 0) & (rules.get("rounding") != "floor1") & (not rules.get("iterate"))
        assert (share[usable] > less[usable]).all()


def test_iterated_width_is_the_fixed_point() -> None:
    """psi* with K_beta at psi*: the stress at the exact width b = psi* m Z is at its limit, at psi* no other."""
    sets = random_sets("unfolded2", 50, 4)
    task = task_of(60.0, psi=0.9, iterate=True)
    found = solve_strength(sets, task)
    plain = solve_strength(sets, replace(task, iterate=False))
    assert (found.psi <= plain.psi * (1 + 1e-12)).all()  # K_beta at a width below psi_bd is smaller
    pinions = mesh_loads(sets).reference
    for i in range(50):
        one = replace(sets, teeth=sets.teeth[i : i + 1], modules=sets.modules[i : i + 1], angles=sets.angles[i : i + 1])
        widths = found.psi[i] * found.module[i] * pinions[i]
        exact = solve_strength(
            one, replace(task, modules=tuple(map(float, found.module[i])), widths=tuple(map(float, widths)))
        )
        np.testing.assert_allclose(np.minimum(exact.contact_margin, exact.bending_margin), 0.0, atol=1e-12)


def test_stresses_in_si() -> None:
    """sigma_H^2 = K_d^3 1000 T K_H (u+1)/(u b d^2), sigma_F = K_m^3/1000 T K_F Y_F/(b m d), all in SI."""
    task = task_of(75.0, modules=(0.002, 0.0035), widths=(0.02, 0.04))
    result = solve_strength(sets_of("AI", planets=3), task)
    z1, z2, z2b, z3 = 25, 136, 20, 112
    for k, (z, u, sign, torque) in enumerate(((z1, z2 / z1, 1, 25.0), (z2b, z3 / z2b, -1, 25.0 * z2 / z1))):
        b, m = ((0.02, 0.002), (0.04, 0.0035))[k]
        d = m * z
        K_H, K_F = 1 + 0.5 * b / d, 1 + 1.08 * b / d
        contact = np.sqrt(770**3 * 1e3 * torque * K_H * (u + sign) / (u * b * d**2))
        bending = 14**3 * 1e-3 * torque * K_F * (3.568 + 201.95 / z**2) / (b * m * d)
        assert result.contact_stress[0, k] == pytest.approx(contact, rel=1e-13)
        assert result.bending_stress[0, k] == pytest.approx(bending, rel=1e-13)


def test_scaling_laws() -> None:
    """m^3 grows with T, falls with K and psi (at the same K_beta), with sigma_HP^2 and with sigma_FP."""
    sets = random_sets("AI", 30, 5)
    stage = StageTask(psi_bd=0.6, permissible_contact=600 * MPA, permissible_bending=200 * MPA)
    base = solve_strength(sets, StrengthTask(50.0, (stage,)))
    heavy = solve_strength(sets, StrengthTask(400.0, (stage,)))
    np.testing.assert_allclose(heavy.required, 2 * base.required, rtol=1e-14)
    more = solve_strength(replace(sets, planets=6), StrengthTask(100.0, (stage,)))
    np.testing.assert_allclose(more.required, base.required, rtol=1e-14)
    strong = solve_strength(
        sets,
        StrengthTask(50.0, (replace(stage, permissible_contact=4800 * MPA, permissible_bending=1600 * MPA),)),
    )
    np.testing.assert_allclose(strong.contact_module, base.contact_module / 4, rtol=1e-14)
    np.testing.assert_allclose(strong.bending_module, base.bending_module / 2, rtol=1e-14)
    similar = solve_strength(sets, StrengthTask(50.0, (stage,), modules=(0.003,)))
    doubled = solve_strength(sets, StrengthTask(400.0, (stage,), modules=(0.006,)))
    np.testing.assert_allclose(doubled.contact_stress, similar.contact_stress, rtol=1e-14)
    np.testing.assert_allclose(doubled.bending_stress, similar.bending_stress, rtol=1e-14)


def test_trains_do_not_depend_on_their_neighbours() -> None:
    sets = random_sets("coaxial", 40, 6)
    task = task_of(50.0)
    together = solve_strength(sets, task)
    for i in (0, 7, 39):
        one = replace(sets, teeth=sets.teeth[i : i + 1], modules=sets.modules[i : i + 1], angles=sets.angles[i : i + 1])
        alone = solve_strength(one, task)
        for name in ("module", "width", "psi", "contact_stress", "bending_stress", "outcome"):
            np.testing.assert_array_equal(getattr(alone, name)[0], getattr(together, name)[i])
    none = replace(sets, teeth=sets.teeth[:0], modules=sets.modules[:0], angles=sets.angles[:0])
    for given in (task, replace(task, modules=(0.002,)), replace(task, on_overload="reject")):
        empty = solve_strength(none, given)
        assert len(empty) == 0
        assert empty.module.shape == (0, 2)


def test_the_meshes_of_a_single_planet() -> None:
    """With Z2 >= Z1 and one material the mesh with the sun decides; with Z2 < Z1 the planet is the pinion of both."""
    one = task_of(66.0)
    large = solve_strength(sets_of("AIbar", planets=3), one)
    unfolded = sets_of("unfolded2", [18, 48, 18, 48])
    alone = solve_strength(unfolded, StrengthTask(22.0, (replace(one.stages[0], row=1),)))
    np.testing.assert_allclose(large.contact_module[0, 0], alone.contact_module[0, 0], rtol=1e-14)
    np.testing.assert_allclose(large.bending_module[0, 0], alone.bending_module[0, 0], rtol=1e-14)
    small = solve_strength(sets_of("AIbar", [30, 20, 70], planets=1), one)
    sigma, psi = 670 / 1.1, 0.6
    torque = 66.0 * 20 / 30
    external = 770 / 20 * (torque * 1.3 / (psi * sigma**2) * 2.5 / 1.5) ** (1 / 3)
    assert small.contact_module[0, 0] / MM == pytest.approx(external, rel=1e-13)


def test_the_weaker_wheel_decides() -> None:
    """A soft wheel lowers the contact limit of its mesh; its tooth is checked with its own form factor."""
    sets = sets_of("unfolded2")
    hard = solve_strength(sets, StrengthTask(22.0, (StageTask(CASED, psi_bd=0.7),)))
    soft = StageTask(CASED, steel_40kh("200 HB"), psi_bd=0.7, hard=True)
    mixed = solve_strength(sets, StrengthTask(22.0, (soft,)))
    np.testing.assert_allclose(mixed.permissible_contact, 470 / 1.1 * MPA)
    np.testing.assert_allclose(mixed.permissible_bending, 360 / 1.75 * MPA)
    assert (mixed.contact_module > hard.contact_module).all()
    Y = 3.568 + 201.95 / 63**2
    m_F = 14 * (22.0 * (1 + 0.53 * 0.7) / (0.7 * 360 / 1.75) * Y / 18**2) ** (1 / 3)
    assert mixed.bending_module[0, 0] / MM == pytest.approx(m_F, rel=1e-13)


def factors(layout: str, task: StrengthTask, symbol: str) -> dict[str, float]:
    found = solve_strength(sets_of(layout), task).coefficients
    return {c.of: c.value for c in found if c.symbol == symbol}


def test_sides_of_the_load_follow_from_the_layout() -> None:
    """Teeth of planets bear load on both sides; layshafts and central wheels on one; the user may say otherwise."""
    own = task_of(load=None)
    assert factors("AIbar", own, "K_FC") == {"wheel 1": 1.0, "wheel 2": 0.65, "wheel 3": 1.0}
    assert factors("AI", own, "K_FC") == {"wheel 1": 1.0, "wheel 2": 0.65, "wheel 2'": 0.65, "wheel 3": 1.0}
    assert {*factors("coaxial", own, "K_FC").values()} == {1.0}
    assert {*factors("AIbar", task_of(load="one-sided"), "K_FC").values()} == {1.0}
    assert {*factors("coaxial", task_of(load="two-sided"), "K_FC").values()} == {0.65}


def test_rows_of_the_layouts() -> None:
    """beta_H of D.4.1, soft; psi_bd without a wish is the middle of D.4.2."""
    beta = {3: 0.16, 4: 0.11, 5: 0.07, 1: 0.5, 7: 0.04}
    rows = {"unfolded2": (3, 5), "unfolded3": (3, 3, 5), "coaxial": (5, 4)}
    for layout in LAYOUTS:
        found = [*factors(layout, task_of(psi=None), "beta_H").values()]
        stages = LAYOUTS[layout].stages
        assert found == [beta[row] for row in rows.get(layout, (1,) * stages)]
        middle = 0.9 if layout in rows else 0.6
        assert [*factors(layout, task_of(psi=None), "psi_bd").values()] == pytest.approx([middle] * stages)
    task = StrengthTask(50.0, (StageTask(steel_40kh(), row=7), StageTask(CASED, row=4)))
    assert [*factors("coaxial", task, "beta_H").values()] == [0.04, 0.25]  # the second stage is hard
    assert [*factors("coaxial", task, "psi_bd").values()] == pytest.approx([1.05, 0.7])


def test_given_modules_of_tied_stages() -> None:
    sets = sets_of("AI", planets=3)
    follows = solve_strength(sets, task_of(75.0, modules=(0.002,)))
    np.testing.assert_allclose(follows.module[0], [0.002, 0.0035])
    wrong = solve_strength(sets, task_of(75.0, modules=(0.002, 0.003)))
    assert list(wrong.outcome) == [Outcome.PROPORTION]
    small = solve_strength(sets, task_of(75.0, modules=(0.001,)))
    assert list(small.outcome) == [Outcome.OVERLOADED]
    (warning,) = solve_strength(sets, task_of(75.0, modules=(0.0021, 0.003675))).warnings[:1]
    assert "2.1 mm is not in Table D.4.8" in warning
    free = solve_strength(sets_of("unfolded2"), task_of(75.0, modules=(0.004,)))
    np.testing.assert_allclose(free.module[0], [0.004, 0.004])


GOOD = {"permissible_contact": 600 * MPA, "permissible_bending": 200 * MPA}


@pytest.mark.parametrize(
    ("make", "message", "remedy"),
    [
        (lambda: task_of(0.0), "torque on wheel 1 is 0", "magnitude"),
        (lambda: task_of(-5.0), "torque on wheel 1 is -5", "magnitude"),
        (lambda: task_of(float("nan")), "torque on wheel 1 is nan", "magnitude"),
        (lambda: task_of(psi=0.0), "psi_bd is 0", "D.4.2"),
        (lambda: task_of(psi=2.5), "psi_bd is 2.5", "D.4.2"),
        (lambda: task_of(underrun=0.2), "underrun is 0.2", "0.005"),
        (lambda: task_of(underrun=-0.1), "underrun is -0.1", "0.005"),
        (lambda: task_of(rows=3), "rows 3 is not known", "1, 2"),
        (lambda: task_of(width_rule="old"), "width_rule 'old'", "consistent, book1992"),
        (lambda: task_of(rounding="floor"), "rounding 'floor'", "ceil, floor1"),
        (lambda: task_of(on_overload="wait"), "on_overload 'wait'", "reject, scale"),
        (lambda: task_of(modules=(0.0,)), "a module is 0 m", "in m"),
        (lambda: task_of(modules=(0.002,), widths=(-0.1,)), "a face width is -0.1 m", "in m"),
        (lambda: task_of(widths=(0.1,)), "face widths without modules", "modules"),
        (lambda: StrengthTask(5.0, ()), "no stage", "describe each"),
        (lambda: StrengthTask(5.0, (StageTask(),)), "neither a material", "sigma|permissible"),
        (lambda: StrengthTask(5.0, (StageTask(**{**GOOD, "permissible_contact": -1.0}),)), "-1 Pa", "in Pa"),
    ],
)
def test_tasks_that_cannot_be(make: Any, message: str, remedy: str) -> None:
    with pytest.raises(UsageError, match=message) as error:
        make()
    assert any(part in error.value.remedy for part in remedy.split("|"))


def test_tasks_that_do_not_fit_the_train() -> None:
    with pytest.raises(UsageError, match="3 stages are described; the layout AI has 2"):
        solve_strength(sets_of("AI"), StrengthTask(5.0, (StageTask(**GOOD),) * 3))
    with pytest.raises(UsageError, match="3 modules are given"):
        solve_strength(sets_of("AI"), task_of(modules=(0.002,) * 3))
    with pytest.raises(UsageError, match="no row 9") as error:
        solve_strength(sets_of("AI"), StrengthTask(5.0, (StageTask(row=9, **GOOD),)))
    assert "1 overhung wheels" in error.value.remedy
    with pytest.raises(UsageError, match="0 branches"):
        solve_strength(sets_of("AI", planets=0), task_of())
    with pytest.raises(UsageError, match="to one another"):
        solve_strength(sets_of("AI", proportion=[4]), task_of())
    steel = Material("through-hardened", parse_hardness("50 HRC"), "40Kh")
    with pytest.raises(UsageError, match="no contact limit for through-hardened"):
        solve_strength(sets_of("AI"), StrengthTask(5.0, (StageTask(steel),)))
