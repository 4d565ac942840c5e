"""From the tables of a spec to the plain values that balancing reads: of the linkage, of an engine, of a rotor."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.machine.model import EngineTask, RotorTask
from tmmcalc.spec.units import unit_direction

if TYPE_CHECKING:
    from tmmcalc.machine.balance.cylinders import Cylinder
    from tmmcalc.machine.balance.rotors import Unbalance
    from tmmcalc.machine.balance.schemes import RotatingWeight
    from tmmcalc.machine.balance.solve import BalanceTask
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.tables.balance import RotatingWeightTable
    from tmmcalc.machine.tables.engine import CylinderTable, EngineTable
    from tmmcalc.machine.tables.rotor import UnbalanceTable


def to_balance(spec: MachineTables) -> BalanceTask:
    """What is asked of the balance of the linkage; without a table all schemes."""
    from tmmcalc.linkage.model import FRAME
    from tmmcalc.linkage.tables.tasks.mechanism import link_points, place, to_linkage
    from tmmcalc.machine.balance.redistribution import Place
    from tmmcalc.machine.balance.solve import BalanceTask

    table = spec.balance
    if table is None:
        return BalanceTask()
    mechanism = to_linkage(spec.linkage)
    joint = mechanism.joint(mechanism.input.joint)
    pivot = joint.points[joint.links.index(FRAME)]
    return BalanceTask(
        mass=table.mass,
        radius=table.radius,
        point=None if table.point is None else place(table.point, link_points(spec.linkage)[FRAME]),
        schemes=tuple(table.schemes),
        places=tuple(Place(weight.link, weight.mass, weight.radius) for weight in table.counterweights),
        weights=tuple(_rotating(weight, pivot) for weight in table.add),
    )


def _rotating(table: RotatingWeightTable, pivot: complex) -> RotatingWeight:
    from tmmcalc.machine.balance.schemes import RotatingWeight

    moment = table.mass * table.radius * unit_direction(table.angle)
    return RotatingWeight(table.order, moment, pivot if table.axis is None else complex(*table.axis))


def to_engine(spec: MachineTables) -> EngineTask | None:
    """The engine of the spec, None if it has none; in line the firing order is the customary one if none is given."""
    table = spec.engine
    if table is None:
        return None
    return EngineTask(
        cylinders=_cylinders(table),
        speed=table.speed,
        orders=tuple(table.orders),
        strokes=table.strokes,
        firing_order=_firing_order(table),
    )


def _cylinders(table: EngineTable) -> tuple[Cylinder, ...]:
    if not isinstance(table.cylinders, int):
        return tuple(_cylinder(cylinder, table) for cylinder in table.cylinders)
    from tmmcalc.machine.balance.arrangements import Gear, in_line, vee

    count, spacing = table.cylinders, table.spacing or 0.0
    sizes = (table.crank_radius or 0.0, table.rod_length or 0.0, table.reciprocating_mass or 0.0)
    gear = Gear(*sizes, table.rotating_mass, table.offset)
    if table.arrangement == "vee":
        angle, split, stagger = table.angle or 0.0, table.split, table.stagger
        return vee(count, angle, spacing, gear, throws=table.throws, split=split, stagger=stagger)
    order = table.firing_order
    return in_line(count, spacing, gear, firing_order=order, strokes=table.strokes, throws=table.throws)


def _cylinder(own: CylinderTable, engine: EngineTable) -> Cylinder:
    """A cylinder with its own sizes and masses, or else those of the engine."""
    from tmmcalc.machine.balance.cylinders import Cylinder

    names = ("crank_radius", "rod_length", "reciprocating_mass", "rotating_mass", "offset")
    sizes = [getattr(engine if getattr(own, name) is None else own, name) for name in names]
    return Cylinder(own.axis_angle, own.crank_angle, own.position, *sizes)


def _firing_order(table: EngineTable) -> tuple[int, ...] | None:
    if table.firing_order is not None:
        return tuple(table.firing_order)
    if table.arrangement != "in-line" or not isinstance(table.cylinders, int) or table.throws is not None:
        return None
    from tmmcalc.machine.balance.arrangements import FIRING

    return FIRING[table.cylinders]


def to_rotor(spec: MachineTables) -> RotorTask | None:
    """The rotor of the spec, None if it has none."""
    table = spec.rotor
    if table is None:
        return None
    from tmmcalc.machine.balance.rotors import Rotor

    first, second = table.bearings
    below, above = table.planes
    unbalances = tuple(_unbalance(unbalance) for unbalance in table.unbalances)
    rotor = Rotor(table.mass, table.center, (first, second), table.speed, unbalances)
    return RotorTask(rotor, (below, above), table.static_plane, table.grade, table.radius)


def _unbalance(table: UnbalanceTable) -> Unbalance:
    """A mass at its radius; of a static moment the mass that has it at 1 m."""
    from tmmcalc.machine.balance.rotors import Unbalance

    if table.moment is not None:
        return Unbalance(table.moment, 1.0, table.angle, table.position)
    return Unbalance(table.mass or 0.0, table.radius or 0.0, table.angle, table.position)
