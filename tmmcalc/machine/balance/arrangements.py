"""Ready arrangements of cylinders: in-line engines and V-engines.

The shaft lies along z and turns counter-clockwise; an in-line engine stands upright, a V opens upwards, symmetric to
the vertical. Throws are the angles of the cranks against the first one. In-line throws follow from the firing order,
so that the engine fires at equal intervals.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.machine.balance.cylinders import Cylinder

WHERE = "engine arrangement"
UP = math.pi / 2
FIRING = {
    1: (1,),
    2: (1, 2),
    3: (1, 3, 2),
    4: (1, 3, 4, 2),
    5: (1, 2, 4, 5, 3),
    6: (1, 5, 3, 6, 2, 4),
    8: (1, 6, 2, 5, 8, 3, 7, 4),
}  # customary orders of in-line engines
THROWS = {
    1: (0,),
    2: (0, 180),
    3: (0, 240, 120),
    4: (0, 90, 270, 180),
    5: (0, 216, 144, 72, 288),
    6: (0, 240, 120, 120, 240, 0),
}  # customary cranks of V-engines [deg], each for two cylinders; of four throws the crossed one


@record
class Gear:
    """Sizes and masses that all cylinders of an engine share."""

    crank_radius: float  # [m]
    rod_length: float  # [m]
    reciprocating_mass: float  # [kg]
    rotating_mass: float = 0.0  # at the crank pin, for one cylinder [kg]
    offset: float = 0.0  # [m]

    def cylinder(self, axis: float, crank: float, place: float) -> Cylinder:
        """The cylinder along ``axis`` with its crank at ``crank`` [rad], at ``place`` [m]."""
        sizes = (self.crank_radius, self.rod_length, self.reciprocating_mass, self.rotating_mass, self.offset)
        return Cylinder(axis, crank, place, *sizes)


def in_line(
    count: int,
    spacing: float,
    gear: Gear,
    *,
    firing_order: Sequence[int] | None = None,
    strokes: int = 4,
    throws: Sequence[float] | None = None,
) -> tuple[Cylinder, ...]:
    """An upright in-line engine, its cylinders ``spacing`` [m] apart, the first one at top dead centre.

    Throws follow from the firing order, by default the customary one of 1, 2, 3, 4, 5, 6 or 8 cylinders, or are given
    [rad]. Raises `UsageError` for an order or throws that do not suit the count.
    """
    if throws is None:
        order = _firing_order(count, firing_order)
        interval = strokes * math.pi / count
        throws = [-interval * order.index(i + 1) for i in range(count)]
    _check_count(count, throws)
    return tuple(gear.cylinder(UP, UP + throw, spacing * i) for i, throw in enumerate(throws))


def vee(
    count: int,
    angle: float,
    spacing: float,
    gear: Gear,
    *,
    throws: Sequence[float] | None = None,
    split: float = 0.0,
    stagger: float = 0.0,
) -> tuple[Cylinder, ...]:
    """A V-engine: two banks at ``angle`` [rad], two cylinders on every throw, the throws ``spacing`` [m] apart.

    Cylinders are numbered throw by throw, the left one first; the first throw stands upright at shaft angle 0. Throws
    [rad] are by default the customary ones of 2, 4, 6, 8 (crossed), 10 or 12 cylinders. ``split`` [rad] turns the pin
    of the right cylinder ahead of the left one's (a boxer: angle and split both pi); ``stagger`` [m] is the distance
    of the two along the shaft. Raises `UsageError` for throws that do not suit the count.
    """
    if throws is None:
        if count // 2 not in THROWS or count % 2:
            counts = ", ".join(str(2 * n) for n in THROWS)
            raise UsageError(f"no customary V of {count}", where=WHERE, remedy=f"give throws; known are {counts}")
        throws = [math.radians(degrees) for degrees in THROWS[count // 2]]
    _check_count(count, [*throws, *throws])
    cylinders = []
    for i, throw in enumerate(throws):
        place, pin = spacing * i, UP + throw
        cylinders.append(gear.cylinder(UP + angle / 2, pin, place - stagger / 2))
        cylinders.append(gear.cylinder(UP - angle / 2, pin + split, place + stagger / 2))
    return tuple(cylinders)


def _check_count(count: int, throws: Sequence[float]) -> None:
    if len(throws) != count or count < 1:
        text = f"throws for {len(throws)} cylinders, but there are {count}"
        raise UsageError(text, where=WHERE, value=count, remedy="give one throw a crank")


def _firing_order(count: int, given: Sequence[int] | None) -> tuple[int, ...]:
    order = tuple(given) if given is not None else FIRING.get(count, ())
    if sorted(order) != list(range(1, count + 1)):
        text = f"firing order {'-'.join(map(str, order)) or 'unknown'} of {count} cylinders"
        known = ", ".join(map(str, FIRING))
        remedy = f"name every cylinder from 1 to {count} once; customary orders are known for {known} cylinders"
        raise UsageError(text, where=WHERE, remedy=remedy)
    return order
