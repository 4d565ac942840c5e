"""What a strength calculation starts from: permissible stresses of the wheels, width and load factors of the stages.

    K_Hbeta = 1 + beta_H psi_bd,   K_Fbeta = 1 + beta_F psi_bd        D.4.1, D.4.2; steps 6 and 7 of 9.1

The row of D.4.1 follows from the layout: unfolded reducers take 3 in the first stage (and the middle one of three) and
5 in the last, coaxial ones 5 and 4, planetary trains 1, the overhung wheels of the textbook's examples. The table calls
a stage soft if one wheel at least is up to HB 350.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Note
from tmmcalc.gears.model import Values
from tmmcalc.gears.scheme import Layout, Mesh
from tmmcalc.gears.strength.endurance import GIVEN, Coefficient, Endurance, Factor, endurance, made
from tmmcalc.gears.strength.material import Material
from tmmcalc.gears.strength.tables import Arrangement, WidthRange, table
from tmmcalc.gears.strength.task import WHERE, StageTask, StrengthTask, stage_tasks

OVERHUNG = 1  # row of D.4.1
ONE_SIDED, TWO_SIDED = "one-sided", "two-sided"


class StageBasis(NamedTuple):
    """Width and load distribution of a stage."""

    psi_bd: float
    low: float  # usual range of psi_bd
    high: float
    beta_contact: float
    beta_bending: float
    factors: tuple[Factor, ...]


class Basis(NamedTuple):
    """All that does not depend on tooth numbers."""

    wheels: tuple[Endurance, ...]  # in the order of the layout's wheels
    stages: tuple[StageBasis, ...]

    def of_stages(self, name: str) -> Values:
        """A number of every stage (stages,)."""
        return np.array([getattr(stage, name) for stage in self.stages])

    @property
    def factors(self) -> tuple[Factor, ...]:
        """Those of all wheels, then of all stages."""
        parts = (*(wheel.factors for wheel in self.wheels), *(stage.factors for stage in self.stages))
        return tuple(factor for part in parts for factor in part)

    @property
    def coefficients(self) -> tuple[Coefficient, ...]:
        """The same without their cells and formulas."""
        return tuple(factor.told for factor in self.factors)

    @property
    def warnings(self) -> tuple[Note, ...]:
        """What the tables say about the materials."""
        return tuple(warning for wheel in self.wheels for warning in wheel.warnings)


def basis_of(layout: Layout, task: StrengthTask) -> Basis:
    """The basis of a task for a layout; raises `UsageError` where the tables have no answer."""
    stages = stage_tasks(task, layout)
    wheels = tuple(_wheel(layout, wheel, stages) for wheel in layout.wheels)
    return Basis(wheels, tuple(_stage(layout, k, stage) for k, stage in enumerate(stages)))


def drives(layout: Layout, wheel: str) -> bool:
    """Whether a wheel has the material ``pinion``: it drives its first mesh, or is the planet of a ring only.

    >>> from tmmcalc.gears.scheme import layout_of
    >>> [wheel for wheel in layout_of("AII").wheels if drives(layout_of("AII"), wheel)]
    ['1', "2'"]
    """
    mesh = _first_mesh(layout, wheel)
    return wheel not in layout.rings if mesh.internal else wheel == mesh.first


def _first_mesh(layout: Layout, wheel: str) -> Mesh:
    return next(mesh for mesh in layout.meshes if wheel in (mesh.first, mesh.second))


def _wheel(layout: Layout, wheel: str, stages: tuple[StageTask, ...]) -> Endurance:
    stage = stages[_first_mesh(layout, wheel).stage]
    of = f"wheel {wheel}"
    material = stage.pinion if drives(layout, wheel) or stage.wheel is None else stage.wheel
    if material is None or (stage.permissible_contact is not None and stage.permissible_bending is not None):
        return _given(stage, None, of)
    return _given(stage, endurance(material, _load(layout, wheel, material), of), of)


def _load(layout: Layout, wheel: str, material: Material) -> str:
    planet = layout.planetary and wheel in layout.planets
    return material.load or (TWO_SIDED if planet else ONE_SIDED)


def _given(stage: StageTask, found: Endurance | None, of: str) -> Endurance:
    """Permissible stresses that the stage gives stand in place of those of the material."""
    given = {"sigma_HP": stage.permissible_contact, "sigma_FP": stage.permissible_bending}
    told = tuple(
        Factor(Coefficient(of, name, value, "Pa", GIVEN)) for name, value in given.items() if value is not None
    )
    if found is None:
        return Endurance(given["sigma_HP"] or 0.0, given["sigma_FP"] or 0.0, told)
    kept = tuple(factor for factor in found.factors if given.get(factor.told.symbol) is None)
    return Endurance(
        given["sigma_HP"] or found.permissible_contact,
        given["sigma_FP"] or found.permissible_bending,
        (*kept, *told),
        found.warnings,
    )


def _stage(layout: Layout, k: int, stage: StageTask) -> StageBasis:
    of = f"stage {k + 1}"
    row = _row(layout, k, stage)
    hard = _hard(stage)
    beta_H, beta_F = (row.hard_contact, row.hard_bending) if hard else (row.soft_contact, row.soft_bending)
    usual = next(r for r in table(WidthRange) if r.position == row.position)
    low, high = (usual.hard_low, usual.hard_high) if hard else (usual.soft_low, usual.soft_high)
    psi, whence = (low + high) / 2, f"{usual.source}, middle of {low:g} to {high:g}: {row.position} wheels"
    if stage.psi_bd is not None:
        psi, whence = stage.psi_bd, GIVEN
    kind = "both wheels above HB 350" if hard else "a wheel up to HB 350"
    source = f"row {row.row}, {row.arrangement}, {kind}: {row.source}"
    letters, place = {"psi_bd": psi, "beta_H": beta_H, "beta_F": beta_F}, f"{row.row}: {row.arrangement}"
    width = Coefficient(of, "psi_bd", psi, "-", whence)
    limits = {"psi_low": low, "psi_high": high}
    mean = replace(made(width, "(psi_low + psi_high)/2", limits), table="D.4.2", row=row.position, column=kind)
    factors = (
        Factor(width) if whence == GIVEN else mean,
        Factor(Coefficient(of, "beta_H", beta_H, "-", source), "D.4.1", place, f"beta_H, {kind}"),
        Factor(Coefficient(of, "beta_F", beta_F, "-", source), "D.4.1", place, f"beta_F, {kind}"),
        made(Coefficient(of, "K_Hbeta", 1 + beta_H * psi, "-", "1 + beta_H psi_bd"), "1 + beta_H*psi_bd", letters),
        made(Coefficient(of, "K_Fbeta", 1 + beta_F * psi, "-", "1 + beta_F psi_bd"), "1 + beta_F*psi_bd", letters),
    )
    return StageBasis(psi, low, high, beta_H, beta_F, factors)


def _row(layout: Layout, k: int, stage: StageTask) -> Arrangement:
    number = stage.row if stage.row is not None else layout.arrangements[k] if layout.arrangements else OVERHUNG
    row = next((row for row in table(Arrangement) if row.row == number), None)
    if row is None:
        raise UsageError(
            f"Table D.4.1 has no row {number}",
            where=f"{WHERE}, stage {k + 1}",
            value=number,
            remedy="rows: " + "; ".join(f"{row.row} {row.arrangement}" for row in table(Arrangement)),
        )
    return row


def _hard(stage: StageTask) -> bool:
    if stage.hard is not None:
        return stage.hard
    materials = [material for material in (stage.pinion, stage.wheel) if material is not None]
    return bool(materials) and not any(material.hardness.soft for material in materials)
