"""What of the machine stands on the sheet of forces and motion, each to standard scale factors."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from tmmcalc.report.language import tr
from tmmcalc.report.sheets.piece import Piece

if TYPE_CHECKING:
    from tmmcalc.report.drawing.box import Box
    from tmmcalc.report.drawing.order import Order
    from tmmcalc.report.drawing.shapes import Drawing

SHEET = "forces"
NARROW, WIDE = 144.0, 180.0  # of a turn at 2.5 and at 2 degrees to a mm
SIDES = 32.0  # beside it, for numbers and names
LARGER = 1.4  # words against those of a picture: 3.5 mm


def of_reduction(order: Order) -> Iterator[Piece]:
    """Moments, works, energy and inertia, one under another."""
    from tmmcalc.machine.pictures.reduction import draw_course

    draw = partial(draw_course, result=order.results["reduction"], flywheel=order.results.get("flywheel"))
    heading = tr("Reduced moments, works, excess energy, reduced inertia")
    yield _piece(heading, draw, (NARROW + SIDES, 205.0), (WIDE + SIDES, 260.0))


def of_flywheel(order: Order) -> Iterator[Piece]:
    """The energy-mass curve, and the excess work by Mertsalov."""
    from tmmcalc.machine.pictures.constructions import draw_ordinates, machine_of
    from tmmcalc.machine.pictures.energymass import draw_energy_mass

    result, reduction = order.results["flywheel"], order.results["reduction"]
    machine = machine_of(result.picture, reduction.cycle, reduction.phi, result.delta)
    curve = partial(draw_energy_mass, picture=result.picture, sense=machine.sense)
    yield _piece(tr("Energy-mass curve"), curve, (145.0, 140.0), (180.0, 200.0))
    ordinates = partial(draw_ordinates, machine=machine)
    heading = tr("Excess work by Mertsalov and Artobolevsky")
    yield _piece(heading, ordinates, (NARROW + SIDES, 120.0), (WIDE + SIDES, 170.0))


def of_motion(order: Order) -> Iterator[Piece]:
    """The speed over the cycle, and the characteristic of a motor."""
    from tmmcalc.machine.pictures.characteristic import draw_motor, motor_curves
    from tmmcalc.machine.pictures.motion import draw_speed

    result, power = order.results["motion"], order.results["power"]
    speed = partial(draw_speed, result=result, cycle=order.results["reduction"].cycle)
    yield _piece(tr("Angular speed of the input link"), speed, (NARROW + SIDES, 70.0), (WIDE + SIDES, 100.0))
    if result.kind == "motor" and power.duty is not None:
        motor = motor_curves(result, power.duty, power.transmission)
        high = 70.0 if motor.kloss is None else 130.0
        draw = partial(draw_motor, motor=motor, scaled=True)
        heading = tr("Characteristic of the motor and its working part")
        yield _piece(heading, draw, (152.0, 1.3 * high), (160.0, 1.7 * high))


def of_balance(order: Order) -> Iterator[Piece]:
    """The shaking force before and after balancing."""
    from tmmcalc.machine.pictures.balance import draw_shaking

    result = order.results["balance"].linkage
    if result is not None:
        draw = partial(draw_shaking, result=result)
        heading = tr("Shaking force before and after balancing")
        yield _piece(heading, draw, (NARROW + SIDES, 135.0), (WIDE + SIDES, 170.0))


def _piece(heading: str, draw: Callable[..., object], least: tuple[float, float], good: tuple[float, float]) -> Piece:
    """A piece with words as large as on a sheet."""

    def drawn(drawing: Drawing, box: Box) -> object:
        with drawing.lettered(LARGER):
            return draw(drawing, box)

    return Piece(SHEET, heading, drawn, least, good)
