"""Other positions than those of ``[mechanism.grid]``: one more, where a result is asked for between them; many."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from tmmcalc.linkage.tables.joints import RevoluteTable
from tmmcalc.spec.units import dimension_of, parse

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables


def with_position(spec: LinkageTables, value: str) -> LinkageTables:
    """The spec with a position more: where the input is ``"45 deg"`` from position 0, as the column phi counts it.

    A number without a unit is in that of the column: deg of a crank, m of a driven slider. Raises `UnitError` for what
    is neither an angle nor a length.
    """
    mechanism = spec.linkage
    driven = next(joint for joint in mechanism.joints if joint.name == mechanism.input.joint)
    turns = isinstance(driven, RevoluteTable)
    if dimension_of(value) is None:
        value = f"{value} {'deg' if turns else 'm'}"
    along = math.copysign(1.0, mechanism.input.speed) * parse(value, "angle" if turns else "length")
    if turns and not 0 <= along <= 2 * math.pi:
        along %= 2 * math.pi
    grid = mechanism.grid.model_copy(update={"extra": [*mechanism.grid.extra, along]})
    whole: Any = spec  # the root of the spec, which is put together of the rooms
    placed: LinkageTables = whole.model_copy(update={"mechanism": mechanism.model_copy(update={"grid": grid})})
    return placed


def with_positions(spec: LinkageTables, count: int) -> LinkageTables:
    """The spec with so many equal steps over the same travel."""
    mechanism = spec.linkage
    steps: dict[str, Any] = {"positions": count, "working": None, "idle": None, "extra": [], "extremes": False}
    grid = mechanism.grid.model_copy(update=steps)
    whole: Any = spec  # the root of the spec, which is put together of the rooms
    dense: LinkageTables = whole.model_copy(update={"mechanism": mechanism.model_copy(update={"grid": grid})})
    return dense
