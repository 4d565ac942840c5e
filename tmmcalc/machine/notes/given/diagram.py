"""What is given of a machine by its diagram: the moment on its shaft by one law, and the inertia of the shaft."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.machine.model import InertiaPoints, TorqueFormula, TorqueHarmonics, TorquePoints, TorqueTask
from tmmcalc.machine.motors.model import RPM
from tmmcalc.machine.tables.tasks.machine import to_torque
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import between, in_rows

EVEN = 1e-9  # [rad] by which equal steps may differ


def of_diagram(order: Order) -> Iterator[Datum]:
    """The diagram with its speed and its period, several equal ones on a shaft, the inertia."""
    task = to_torque(order.spec)
    if task is None:
        return
    if order.spec.torque.by_motor:
        yield Datum(tr("mean speed of the shaft"), text=tr("that which the motor gives it"))
    else:
        yield Datum(tr("mean speed of the shaft"), ("n_1",), (task.speed * RPM,), "rpm")
    yield Datum(tr("angle of the cycle"), ("phi_c",), (math.degrees(task.period),), "deg")
    yield from _law(task)
    if task.delays:
        said = tr("how far the equal diagrams on the shaft are behind the first")
        yield Datum(said, (), tuple(map(math.degrees, task.delays)), "deg")
    if task.inertia:
        said = tr("constant moment of inertia of the shaft and of what turns with it")
        yield Datum(said, (), (task.inertia,), "kg*m^2")
    if task.reduced is not None:
        yield from _inertia(task.reduced, task.period)
    if task.balanced:
        yield Datum(tr("further moment"), text=tr("a constant one that makes the work of the cycle zero"))


def _law(task: TorqueTask) -> Iterator[Datum]:
    """The moment over the angle of the shaft; one that drives is positive."""
    said = tr("moment on the shaft “{name}”; one that resists is negative", name=task.name)
    match task.law:
        case TorqueFormula(text=formula, constants=constants):
            plain = spelt(formula.replace("**", "^").replace("$", ""))
            over = tr("{formula} {unit}, over the angle of the shaft in rad", formula=plain, unit=tr_unit("N*m"))
            yield Datum(said, text=over)
            for name, value in constants:
                yield Datum(tr("number {name} of this formula", name=name), (), (value,))
        case TorqueHarmonics(constant=constant, terms=terms):
            yield Datum(said, text=tr("constant part and harmonics of the angle of the shaft"))
            yield Datum(tr("constant part"), (), (constant,), "N*m")
            yield Datum(tr("orders of the harmonics"), (), tuple(order for order, _, _ in terms))
            yield Datum(tr("amplitudes of the cosines"), (), tuple(cosine for _, cosine, _ in terms), "N*m")
            yield Datum(tr("amplitudes of the sines"), (), tuple(sine for _, _, sine in terms), "N*m")
        case TorquePoints(theta=theta, moment=moment, interpolation=interpolation):
            places = _places(tr("angles of the points of the diagram"), theta, task.period)
            there = tr("{moment}, at these points", moment=said)
            yield from in_rows(places, Datum(there, (), tuple(moment), "N*m"))
            yield Datum(tr("moment between the points"), text=between(interpolation))


def _inertia(found: InertiaPoints, cycle: float) -> Iterator[Datum]:
    """The reduced inertia that varies with the angle."""
    places = _places(tr("angles of the points of the reduced moment of inertia"), found.theta, found.period)
    there = Datum(tr("reduced moment of inertia at these points"), (tr("J_red"),), found.inertia, "kg*m^2")
    yield from in_rows(places, there)
    yield Datum(tr("reduced moment of inertia between the points"), text=between(found.interpolation))
    if found.period != cycle:
        said = tr("angle after which the reduced moment of inertia repeats itself")
        yield Datum(said, (), (math.degrees(found.period),), "deg")


def _places(said: str, theta: Sequence[float], period: float) -> Datum:
    """The angles of points; equal steps of a period by their number."""
    ends = abs(theta[-1] - period) < EVEN  # whether the end of the period has its own value
    count = len(theta) - ends
    if all(abs(angle - k * period / count) < EVEN for k, angle in enumerate(theta)):
        text = tr("number of equal steps of the period: {count}, from zero on", count=count)
        return Datum(said, text=tr("{steps}, with its end", steps=text) if ends else text)
    return Datum(said, (), tuple(map(math.degrees, theta)), "deg")
