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
from tmmcalc.gears.single.results import SingleWheel


def remeasured(
    result: Pairs, teeth: int | None = None, ball: float | None = None, radii: Sequence[float] = ()
) -> Pairs:
    """The same pairs, every wheel measured over ``teeth``, with balls or pins of the diameter ``ball`` [m].

    Its tooth is measured on the circles of ``radii`` [m] too. None keeps what was measured before. Raises `UsageError`
    for fewer than 2 teeth, or a diameter or radius that is not positive.
    """
    _check(teeth, ball, radii)
    return replace(result, pairs=tuple(_again(found, teeth, ball, radii) for found in result.pairs))


def remeasured_wheel(
    found: SingleWheel, teeth: int | None = None, ball: float | None = None, radii: Sequence[float] = ()
) -> SingleWheel:
    """The same of a wheel without a mate; raises as `remeasured`."""
    from tmmcalc.gears.single.solve import gear_of_task

    _check(teeth, ball, radii)
    task, asked = found.task, found.task.measuring
    if teeth is not None:
        asked = replace(asked, span_teeth=teeth)
    if ball is not None:
        asked = replace(asked, ball=ball)
    again = measures(asked, gear_of_task(task), (*task.circles, *radii))
    return replace(found, task=replace(task, measuring=asked), measures=again)


def _check(teeth: int | None, ball: float | None, radii: Sequence[float]) -> None:
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


def _again(found: MeshPair, teeth: int | None, ball: float | None, radii: Sequence[float]) -> MeshPair:
    asked = found.task.measuring
    if teeth is not None:
        asked = replace(asked, span_teeth=(teeth, teeth))
    if ball is not None:
        asked = replace(asked, balls=(ball, ball))
    task = replace(found.task, measuring=asked)
    gears = [gear_of(found, number, size) for number, size in enumerate(found.sizes, 1)]
    again = tuple(measures(task.measuring_of(number), gear, radii) for number, gear in enumerate(gears, 1))
    return replace(found, task=task, measures=again)


def gear_of(found: MeshPair, number: int, size: WheelSizes) -> Gear:
    """Wheel 1 or 2 of a solved pair with its circles in modules."""
    task, m = found.task, found.task.module
    ring = size.kind == "ring"
    wheel = ring_of(task, size.shift).signed if ring else wheel_of(task, number, size.shift)
    form = float(wheel.curvature_at(max(size.form / m, abs(wheel.base))))
    active = float(wheel.curvature_at(max(size.active_left / m, abs(wheel.base))))
    return Gear(wheel, size.tip / m, size.root / m, size.operating / m, form, active)
