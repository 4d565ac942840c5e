"""Wheels of solved pairs measured once more: over another number of teeth, over other balls."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.measure.span import LEAST
from tmmcalc.gears.meshing.geometry import ring_of, wheel_of
from tmmcalc.gears.meshing.measures import measures
from tmmcalc.gears.meshing.results import MeshPair, Pairs, WheelSizes
from tmmcalc.gears.meshing.sizes import Gear


def remeasured(
    result: Pairs, teeth: int | None = None, ball: float | None = None, radii: Sequence[float] = ()
) -> Pairs:
    """The same pairs, every wheel measured over ``teeth``, with balls or pins of the diameter ``ball`` [m].

    Its tooth is measured on the circles of ``radii`` [m] too. None keeps what was measured before. Raises `UsageError`
    for fewer than 2 teeth, or a diameter or radius that is not positive.
    """
    if teeth is not None and teeth < LEAST:
        raise UsageError(
            f"a span is not measured over {teeth}", where="span", value=teeth, limit=LEAST, remedy="2 teeth or more"
        )
    for where, values in (("balls", () if ball is None else (ball,)), ("circle", radii)):
        for value in values:
            if not value > 0:
                raise UsageError(
                    f"{value:g} cannot be measured over", where=where, value=value, limit=0.0, remedy="a positive value"
                )
    return replace(result, pairs=tuple(_again(found, teeth, ball, radii) for found in result.pairs))


def _again(found: MeshPair, teeth: int | None, ball: float | None, radii: Sequence[float]) -> MeshPair:
    asked = found.task.measuring
    if teeth is not None:
        asked = replace(asked, span_teeth=(teeth, teeth))
    if ball is not None:
        asked = replace(asked, balls=(ball, ball))
    task = replace(found.task, measuring=asked)
    gears = [gear_of(found, number, size) for number, size in enumerate(found.sizes, 1)]
    return replace(
        found, task=task, measures=tuple(measures(task, number, gear, radii) for number, gear in enumerate(gears, 1))
    )


def gear_of(found: MeshPair, number: int, size: WheelSizes) -> Gear:
    """Wheel 1 or 2 of a solved pair with its circles in modules."""
    task, m = found.task, found.task.module
    ring = size.kind == "ring"
    wheel = ring_of(task, size.shift).signed if ring else wheel_of(task, number, size.shift)
    form = float(wheel.curvature_at(max(size.form / m, abs(wheel.base))))
    active = float(wheel.curvature_at(max(size.active_left / m, abs(wheel.base))))
    return Gear(wheel, size.tip / m, size.root / m, size.operating / m, form, active)
