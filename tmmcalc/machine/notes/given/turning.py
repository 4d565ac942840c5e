"""What is given of a rotor with its unbalanced masses and of an engine with its cylinders."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from tmmcalc.machine.balance.cylinders import Cylinder
from tmmcalc.machine.model import EngineTask, RotorTask
from tmmcalc.machine.motors.model import RPM
from tmmcalc.machine.notes.engine import within_turn
from tmmcalc.machine.tables.rotor import UnbalanceTable
from tmmcalc.machine.tables.tasks.balance import to_engine, to_rotor
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum

GRAM_MILLIMETRES = 1e6  # in a kg*m


def of_turning(order: Order) -> Iterator[Datum]:
    """A rotor, an engine."""
    rotor, engine = to_rotor(order.spec), to_engine(order.spec)
    if rotor is not None:
        yield from _rotor(rotor, order.spec.rotor.unbalances)
    if engine is not None:
        yield from _engine(engine)


def _rotor(task: RotorTask, unbalances: Sequence[UnbalanceTable]) -> Iterator[Datum]:
    """The rotor, its unbalanced masses, what it is corrected by."""
    made = task.rotor
    yield Datum(tr("mass of the rotor"), ("m",), (made.mass,), "kg")
    yield Datum(tr("place of the centre of mass along the axis"), ("z_S",), (made.center,), "m")
    yield Datum(tr("places of the bearings along the axis"), ("z_A", "z_B"), made.bearings, "m")
    yield from _unbalances(unbalances)
    yield Datum(tr("places of the planes of correction along the axis"), ("z_I", "z_II"), task.planes, "m")
    if task.static_plane is not None:
        said = tr("place of the plane of static correction along the axis")
        yield Datum(said, (), (task.static_plane,), "m")
    yield Datum(tr("highest service speed"), ("n_R",), (made.speed * RPM,), "rpm")
    if task.radius is not None:
        yield Datum(tr("radius of the correction weights"), ("r_k",), (task.radius,), "m")
    if task.grade is not None:
        yield Datum(tr("grade of balance quality"), ("G",), (task.grade,), "mm/s")


def _unbalances(parts: Sequence[UnbalanceTable]) -> Iterator[Datum]:
    """The unbalances in their order, each by its mass and radius or by its static moment, as it is written."""
    masses = {k: each for k, each in enumerate(parts, 1) if each.moment is None}
    moments = {k: each.moment for k, each in enumerate(parts, 1) if each.moment is not None}

    def of(what: str, own: Mapping[int, object]) -> str:
        numbers = ", ".join(map(str, own))
        return tr("{what}, of unbalances {numbers}", what=what, numbers=numbers) if masses and moments else what

    if masses:
        values = tuple(each.mass or 0.0 for each in masses.values())
        yield Datum(of(tr("unbalanced masses"), masses), ("m_i",), values, "kg")
        radii = tuple(each.radius or 0.0 for each in masses.values())
        yield Datum(of(tr("their distances from the axis"), masses), ("r_i",), radii, "m")
    if moments:
        values = tuple(GRAM_MILLIMETRES * moment for moment in moments.values())
        yield Datum(of(tr("static moments of unbalanced masses"), moments), ("m_i*r_i",), values, "g*mm")
    angles = tuple(math.degrees(each.angle) for each in parts)
    yield Datum(tr("their angles in axes that turn with the rotor"), ("alpha_i",), angles, "deg")
    yield Datum(tr("their places along the axis"), ("z_i",), tuple(each.position for each in parts), "m")


def _engine(engine: EngineTask) -> Iterator[Datum]:
    """An engine, its cylinders in their order; what all have alike stands once."""
    cylinders = engine.cylinders
    yield Datum(tr("number of cylinders"), ("i_c",), (float(len(cylinders)),))
    yield Datum(tr("number of strokes of the cycle"), text=str(engine.strokes))
    if engine.firing_order is not None:
        yield Datum(tr("firing order"), text="–".join(map(str, engine.firing_order)))
    yield Datum(tr("speed of the shaft"), ("n_e",), (engine.speed * RPM,), "rpm")
    places = tuple(each.position_along_shaft for each in cylinders)
    yield Datum(tr("places of the cylinders along the shaft"), ("z_j",), places, "m")
    axes = [within_turn(each.axis_angle) for each in cylinders]
    yield Datum(tr("directions of the cylinders, from axis $x$"), ("gamma_j",), _once(axes), "deg")
    cranks = tuple(within_turn(each.crank_angle) for each in cylinders)
    said = tr("directions of the cranks where the angle of the shaft is zero, from axis $x$")
    yield Datum(said, ("psi_j",), cranks, "deg")
    yield from _crank_gear(cylinders)
    yield Datum(tr("orders that are told apart"), ("k",), tuple(map(float, engine.orders)))


def _crank_gear(cylinders: Sequence[Cylinder]) -> Iterator[Datum]:
    """Sizes and masses of the crank gear of each cylinder."""
    radii, rods = [each.crank_radius for each in cylinders], [each.rod_length for each in cylinders]
    yield Datum(tr("radius of the crank"), ("r_j",), _once(radii), "m")
    yield Datum(tr("length of the connecting rod"), ("l_j",), _once(rods), "m")
    reciprocating = [each.reciprocating_mass for each in cylinders]
    yield Datum(tr("reciprocating mass of a cylinder"), ("m_r",), _once(reciprocating), "kg")
    yield Datum(tr("rotating mass at the crank pin"), ("m_t",), _once([each.rotating_mass for each in cylinders]), "kg")
    if any(each.offset for each in cylinders):
        said = tr("distance at which the axes of the cylinders pass the shaft on the left")
        yield Datum(said, (), _once([each.offset for each in cylinders]), "m")


def _once(values: Sequence[float]) -> tuple[float, ...]:
    """Values of all, one where they are alike."""
    return (values[0],) if len({*values}) == 1 else tuple(values)
