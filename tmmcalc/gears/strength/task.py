"""What a strength calculation is asked: torque, stages, rules of rounding; and given modules, where it checks."""

from __future__ import annotations

import math
from typing import Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.strength.material import Material

WidthRule = Literal["consistent", "book1992"]
Rounding = Literal["ceil", "floor1"]
OnOverload = Literal["reject", "scale"]
WIDTH_RULES = ("consistent", "book1992")
ROUNDINGS = ("ceil", "floor1")
ON_OVERLOAD = ("reject", "scale")

LARGEST_PSI = 2.0  # no pinion is wider than twice its diameter
LARGEST_UNDERRUN = 0.05
WHERE = "strength"


@record
class StageTask:
    """One stage: its materials or permissible stresses, its place between the bearings, its width."""

    pinion: Material | None = None  # of the driving wheel: 1, 2', 3'; of the planets of meshes with rings only
    wheel: Material | None = None  # of the other wheels; None: as the pinion
    psi_bd: float | None = None  # b/d_1 of the stage's smallest wheel; None: the middle of D.4.2
    row: int | None = None  # of D.4.1; None: that of the layout and stage
    permissible_contact: float | None = None  # permissible contact stress in place of the materials' [Pa]
    permissible_bending: float | None = None  # permissible bending stress in place of the materials' [Pa]
    hard: bool | None = None  # both wheels harder than HB 350; None: by the materials, soft without them


@record
class StrengthTask:
    """Task of a strength calculation; raises `UsageError` for numbers that none can have."""

    torque: float  # T1 on wheel 1, total of all branches [N*m]: divided by their number once, in the formulas
    stages: tuple[StageTask, ...]  # one for every stage, or one for all of them
    modules: tuple[float, ...] = ()  # [m] given ones are checked; one for every stage, or the first
    widths: tuple[float, ...] = ()  # [m] of given modules; none: psi_bd d_1
    rows: Literal[1, 2] = 2  # of D.4.8 for standard modules: the first alone, or both
    underrun: float = 0.0  # relative amount by which a standard module may stay below the required one
    width_rule: WidthRule = "consistent"
    rounding: Rounding = "ceil"  # of widths, to whole mm
    on_overload: OnOverload = "scale"  # of modules that are tied: larger ones for all stages, or none
    iterate: bool = False  # K_beta with the face width that results, in place of psi_bd

    def __post_init__(self) -> None:
        """Refuse a torque, widths and words out of range."""
        if not 0 < self.torque < math.inf:
            what = f"the torque on wheel 1 is {self.torque:g} N*m; it is positive"
            raise _fault(what, self.torque, 0.0, "give its magnitude")
        if not self.stages:
            raise _fault("no stage is described", remedy="describe each stage, or one for all")
        if not 0 <= self.underrun <= LARGEST_UNDERRUN:
            what = f"underrun is {self.underrun:g}; it is 0 to {LARGEST_UNDERRUN:g}"
            raise _fault(what, self.underrun, LARGEST_UNDERRUN, "such as 0.005")
        for name, values in (("module", self.modules), ("face width", self.widths)):
            for value in values:
                if not 0 < value < math.inf:
                    raise _fault(f"a {name} is {value:g} m; it is positive", value, 0.0, "give it in m")
        if self.widths and not self.modules:
            raise _fault("face widths without modules", remedy="give the modules that are checked, too")
        _check_words(self)
        for number, stage in enumerate(self.stages, 1):
            _check_stage(stage, f"{WHERE}, stage {number}")

    @property
    def checks(self) -> bool:
        """Whether modules are given and their stresses are asked."""
        return bool(self.modules)


def pinion_torque(moment: float, ratio: float) -> float:
    """Torque T1 [N*m] on wheel 1, total of all branches, from the largest reduced moment max|M_c| [N*m].

    ``ratio`` is that of the speeds of wheel 1 and of the shaft that the moment is reduced to. Table D.4.9 divides
    by the number of branches here; the formulas of this package do, once. Raises `UsageError`.

    >>> pinion_torque(1980.0, 15.0)
    132.0
    """
    for name, value in (("moment", moment), ("ratio", ratio)):
        if not 0 < abs(value) < math.inf:
            raise _fault(f"the {name} is {value:g}; it is finite and not zero", value, 0.0, f"give the {name}")
    return abs(moment) / abs(ratio)


def stage_tasks(task: StrengthTask, layout: Layout) -> tuple[StageTask, ...]:
    """The task of every stage of a layout; raises `UsageError` if their number is another."""
    if len(task.stages) not in (1, layout.stages):
        raise _fault(
            f"{len(task.stages)} stages are described; the layout {layout.key} has {layout.stages}",
            len(task.stages),
            layout.stages,
            "describe each stage, or one for all",
        )
    return task.stages * (layout.stages if len(task.stages) == 1 else 1)


def _check_words(task: StrengthTask) -> None:
    words = (
        ("rows", (1, 2)),
        ("width_rule", WIDTH_RULES),
        ("rounding", ROUNDINGS),
        ("on_overload", ON_OVERLOAD),
    )
    for field, known in words:
        value = getattr(task, field)
        if value not in known:
            raise _fault(f"{field} {value!r} is not known", remedy=f"{field}: {', '.join(map(str, known))}")


def _check_stage(stage: StageTask, where: str) -> None:
    if stage.psi_bd is not None and not 0 < stage.psi_bd <= LARGEST_PSI:
        what = f"psi_bd is {stage.psi_bd:g}; it is above 0 and at most {LARGEST_PSI:g}"
        raise UsageError(what, where=where, value=stage.psi_bd, limit=LARGEST_PSI, remedy="Table D.4.2 has 0.4 to 1.2")
    for name in ("permissible_contact", "permissible_bending"):
        value = getattr(stage, name)
        if value is not None and not 0 < value < math.inf:
            what = f"{name} is {value:g} Pa; it is positive"
            raise UsageError(what, where=where, value=value, limit=0.0, remedy="give it in Pa")
    if stage.pinion is None and (stage.permissible_contact is None or stage.permissible_bending is None):
        raise UsageError(
            "neither a material nor both permissible stresses are given",
            where=where,
            remedy="give the material of the pinion, or permissible_contact and permissible_bending",
        )


def _fault(message: str, value: float | None = None, limit: float | None = None, remedy: str = "") -> UsageError:
    return UsageError(message, where=WHERE, value=value, limit=limit, remedy=remedy)
