"""A flywheel of another inertia than the machine needs, as a mistake leads to it."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.machine.flywheel.placement import wheels
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine


def of_total(machine: Machine, found: Flywheel, total: float) -> Flywheel:
    """The flywheel of a total constant inertia [kg*m^2] on the input shaft; none where that is at hand."""
    addition = max(total - machine.at_hand.total, 0.0)
    fastest = found.wheels[0].speed / abs(machine.ratio)
    made = wheels(machine.task, addition, fastest, machine.ratio, machine.motor_ratio)
    return replace(found, inertia=machine.at_hand.total + addition, addition=addition, wheels=made)


def of_own(machine: Machine, found: Flywheel, own: float) -> Flywheel:
    """The same wheel on the input shaft, whose inertia on its own shaft comes out as ``own`` [kg*m^2]."""
    first = wheels(
        machine.task, own * machine.ratio**2, found.wheels[0].speed / abs(machine.ratio), machine.ratio, None
    )
    return replace(found, wheels=(first[0], *found.wheels[1:]))


def by_method(found: Flywheel, name: str) -> float:
    """The total inertia [kg*m^2] that a method for forces of position asks for."""
    return next(row.positional.inertia for row in found.rows if row.positional.method == name)
