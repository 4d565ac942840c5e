"""From the tables of a spec to the plain values that gear stages read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.material import Material, parse_hardness
from tmmcalc.gears.strength.task import StageTask, StrengthTask, pinion_torque

if TYPE_CHECKING:
    from tmmcalc.gears.tables.strength import MaterialTable, StrengthTable

_OF_STAGE = {
    "psi_bd": "face_width",
    "row": "arrangement",
    "permissible_contact": "permissible_contact",
    "permissible_bending": "permissible_bending",
}
_RULES = {
    "rows": "modules_row",
    "underrun": "underrun",
    "width_rule": "face_width_rule",
    "rounding": "rounding",
    "on_overload": "on_overload",
    "iterate": "iterate",
}


def to_strength(table: StrengthTable, moment: float | None = None) -> StrengthTask:
    """The task of a strength calculation; ``moment`` [N*m] is the largest reduced one, where the table gives none.

    Raises `UsageError` for a torque that is not known, and for lists of stages of different lengths.
    """
    given = {name: value for name, key in _RULES.items() if (value := getattr(table, key)) is not None}
    return StrengthTask(
        torque=_torque(table, moment),
        stages=_stages(table),
        modules=tuple(table.module or ()),
        widths=tuple(table.width or ()),
        **given,
    )


def _torque(table: StrengthTable, moment: float | None) -> float:
    if table.torque is not None:
        return table.torque
    largest = table.moment if table.moment is not None else moment
    if largest is None or table.moment_ratio is None:
        raise UsageError(
            "the torque on wheel 1 is not known",
            where="strength",
            remedy="give torque, or moment_ratio with moment or a mechanism that is loaded",
        )
    return pinion_torque(largest, table.moment_ratio)


def _stages(table: StrengthTable) -> tuple[StageTask, ...]:
    """One stage for all, if nothing differs between them."""
    own = {name: list(value) for name, key in _OF_STAGE.items() if (value := getattr(table, key)) is not None}
    count = max((len(values) for values in own.values()), default=1)
    for name, values in own.items():
        if len(values) not in (1, count):
            what = f"{_OF_STAGE[name]} is given for {len(values)} stages, another key for {count}"
            raise UsageError(what, where="strength", remedy="give one value for all stages, or one for each")
    pinion = table.pinion if table.pinion is not None else table.material
    materials = (to_material(pinion), to_material(table.wheel))
    return tuple(
        StageTask(*materials, **{name: values[k if len(values) > 1 else 0] for name, values in own.items()})
        for k in range(count)
    )


def to_material(table: MaterialTable | None) -> Material | None:
    """A material of a wheel, None where none is given; raises `UsageError` for one without treatment or hardness."""
    if table is None:
        return None
    if table.treatment is None or table.hardness is None:
        raise UsageError("a material has a treatment and a hardness", where="strength", remedy="add both")
    data: dict[str, Any] = table.model_dump(exclude_none=True)
    for name in ("hardness", "core"):
        if name in data:
            data[name] = parse_hardness(data[name])
    return Material(**data)
