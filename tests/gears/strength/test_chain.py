"""Every factor of the strength of a train: cells of tables read by hand, formulas worked out, stresses as products."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from gears.formulas import worked
from gears.strength.scenes import CASES, MM, MPA, TRAINS, sets_of, steel_40kh, task_of
from tmmcalc.gears.strength.chain import StrengthFactors, strength_factors
from tmmcalc.gears.strength.endurance import Factor
from tmmcalc.gears.strength.explain import coefficients
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StageTask, StrengthTask

UNITS = {"MPa": MPA, "mm": MM, "N*m": 1.0, "": 1.0}
DATA = Path(tmmcalc.__file__).parent / "gears" / "strength" / "data"


def of(found: StrengthFactors, place: str, symbol: str) -> Factor:
    """The last one of its name: what stands in the steps of the stresses."""
    return [each for each in found.factors if (each.told.of, each.told.symbol) == (place, symbol)][-1]


def check_formulas(found: StrengthFactors) -> None:
    count = 0
    for each in found.factors:
        if each.formula:
            value = worked(each.numbers) * UNITS[each.formula_unit]
            assert value == pytest.approx(each.told.value, rel=3e-7), each
            count += 1
    assert count > 20


RULES: tuple[dict[str, Any], ...] = (
    {},
    {"iterate": True},
    {"rounding": "floor1", "width_rule": "book1992"},
    {"modules": (0.003,)},
    {"modules": (0.003,), "widths": (0.04,)},
    {"psi": None, "load": None},
)


@pytest.mark.parametrize("layout", TRAINS)
@pytest.mark.parametrize("rules", RULES)
def test_factors_times_each_other_are_the_stresses(layout: str, rules: dict[str, Any]) -> None:
    """Of every stage the largest share of its meshes; with every formula worked out by Python."""
    sets, task = sets_of(layout, planets=1 if layout.startswith("unfolded") else 3), task_of(**rules)
    found, stress = strength_factors(sets, task, 0), solve_strength(sets, task)
    check_formulas(found)
    scheme = sets.scheme
    for stage in range(scheme.stages):
        meshes = [mesh for mesh in scheme.meshes if mesh.stage == stage]
        contact, bending = [], []
        for mesh in meshes:
            place = f"mesh {mesh.first}-{mesh.second}"
            sigma, limit = (of(found, place, name) for name in ("sigma_H", "sigma_HP"))
            contact.append((worked(sigma.numbers) * MPA / limit.told.value, worked(sigma.numbers)))
            for wheel in (mesh.first, mesh.second):
                own = of(found, place, f"sigma_F of wheel {wheel}")
                limit = of(found, place, f"sigma_FP of wheel {wheel}")
                bending.append((worked(own.numbers) * MPA / limit.told.value, worked(own.numbers)))
        assert max(contact)[1] == pytest.approx(stress.contact_stress[0, stage] / MPA, rel=3e-7)
        assert max(bending)[1] == pytest.approx(stress.bending_stress[0, stage] / MPA, rel=3e-7)
        assert of(found, f"stage {stage + 1}", "m").told.value == stress.module[0, stage]
        assert of(found, f"stage {stage + 1}", "b").told.value == stress.width[0, stage]
        for name, required in (("m_H", stress.contact_module), ("m_F", stress.bending_module)):
            own_meshes = [of(found, f"mesh {m.first}-{m.second}", name) for m in meshes]
            assert max(each.told.value for each in own_meshes) == pytest.approx(required[0, stage], rel=1e-12)


def test_the_reducer_of_the_textbook() -> None:
    """GT-S12: cells of the tables as they were read by hand, permissible stresses and coefficients of both stages."""
    inputs, expected = CASES["GT-S12"]["inputs"], CASES["GT-S12"]["expected"]
    stage = StageTask(steel_40kh(load="two-sided"), psi_bd=inputs["psi_bd"])
    found = strength_factors(sets_of("unfolded2"), StrengthTask(inputs["T1_Nm"], (stage,)), 0)
    cells = {
        ("wheel 1", "sigma_Hlim"): ("D.4.4", "annealed, normalised, improved; HB 350 at most", 670e6, "2*300 + 70"),
        ("wheel 1", "S_H"): ("D.4.5", "homogeneous", 1.1, ""),
        ("wheel 1", "sigma_Flim^0"): ("D.4.3", "im: normalised, improved; HB 180 to 300", 540e6, "1.8*300"),
        ("wheel 1", "S_F'"): ("D.4.3", "im: normalised, improved", 1.75, ""),
        ("wheel 1", "S_F''"): ("D.4.6", "forging", 1.0, ""),
        ("wheel 1", "K_FC"): ("D.4.7", "two-sided, annealed, normalised, improved", 0.65, ""),
        ("stage 1", "beta_H"): ("D.4.1", "3: high-speed stage of an ordinary two-stage reducer", 0.16, ""),
        ("stage 2", "beta_F"): ("D.4.1", None, 0.16, ""),
    }
    for (place, symbol), (table, row, value, numbers) in cells.items():
        each = of(found, place, symbol)
        assert (each.table, each.numbers) == (table, numbers)
        assert each.row == row or row is None
        assert each.told.value == pytest.approx(value, rel=1e-12)
    assert of(found, "stage 2", "beta_F").row.startswith("5: ")
    assert of(found, "stage 2", "beta_F").column == "beta_F, a wheel up to HB 350"
    assert of(found, "wheel 1", "sigma_FP").numbers == "540*0.65/(1.75*1)"
    for k, mesh in ((1, "mesh 1-2"), (2, "mesh 2'-3")):
        for symbol in ("A_H", "A_F"):
            assert worked(of(found, mesh, symbol).numbers) == pytest.approx(expected[f"stage{k}"][symbol], abs=1e-3)


def test_cells_are_those_of_the_file() -> None:
    """beta_H and beta_F of every row of D.4.1, psi_bd of D.4.2, from the files as csv reads them."""
    with (DATA / "load_distribution.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    with (DATA / "face_width.csv").open(encoding="utf-8") as file:
        widths = {row["position"]: row for row in csv.DictReader(file)}
    for hard, kind, name in ((False, "soft", "a wheel up to HB 350"), (True, "hard", "both wheels above HB 350")):
        for row in rows:
            stage = StageTask(steel_40kh(), row=int(row["row"]), hard=hard)
            found = strength_factors(sets_of("AIbar", planets=3), StrengthTask(50.0, (stage,)), 0)
            contact, bending, width = (of(found, "stage 1", symbol) for symbol in ("beta_H", "beta_F", "psi_bd"))
            assert contact.told.value == float(row[f"{kind}_contact"])
            assert bending.told.value == float(row[f"{kind}_bending"])
            assert contact.row == f"{row['row']}: {row['arrangement']}"
            assert (contact.column, bending.column) == (f"beta_H, {name}", f"beta_F, {name}")
            usual = widths[row["position"]]
            assert (width.table, width.row, width.column) == ("D.4.2", row["position"], name)
            assert width.numbers == f"({float(usual[f'{kind}_low']):g} + {float(usual[f'{kind}_high']):g})/2"


def test_a_given_limit_has_no_cell() -> None:
    stage = StageTask(steel_40kh(contact_limit=700e6, bending_limit=500e6), psi_bd=0.6)
    found = strength_factors(sets_of("AIbar"), StrengthTask(50.0, (stage,)), 0)
    for symbol in ("sigma_Hlim", "sigma_Flim^0"):
        each = of(found, "wheel 1", symbol)
        assert (each.table, each.formula, each.told.source) == ("", "", "given")
    assert of(found, "wheel 1", "S_F'").row == "most rows"


def test_the_steps_begin_with_the_coefficients() -> None:
    sets, task = sets_of("AI", planets=3), task_of()
    told = tuple(each.told for each in strength_factors(sets, task, 0).factors)
    known = coefficients(sets, task, 0)
    assert told[: len(known)] == known


def test_a_module_stands_in_its_row_of_the_table() -> None:
    found = strength_factors(sets_of("AI", planets=3), task_of(), 0)
    for each in found.factors:
        if each.table == "D.4.8":
            assert each.column == f"{each.told.value / MM:g} mm"
    rows = [of(found, f"stage {k}", "m") for k in (1, 2)]
    assert np.isclose(rows[0].told.value * 7, rows[1].told.value * 4)
