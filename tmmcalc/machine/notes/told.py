"""What several parts of the chapter on motion say alike: conditions, numbers, constant inertias, pictures."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Figure, Lexicon
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import DIGITS, WIDE, column_of
from tmmcalc.report.telling import held as held
from tmmcalc.report.telling import numeral as numeral

ANGLE = 6  # decimals of an angle that are no rounding [deg]
LETTERED = 1.15  # words of a picture against those of a drawing on screen


def degrees(angle: float) -> str:
    """An angle [rad] within a formula of a sentence, in degrees.

    >>> degrees(math.pi / 8), degrees(-math.pi / 2)
    ('deg(22.5)', '-deg(90)')
    """
    value = round(math.degrees(angle), ANGLE) + 0.0
    return f"{'-' if value < 0 else ''}deg({numeral(abs(value))})"


def plainly(value: float, digits: int = DIGITS) -> str:
    """A number of a sentence.

    >>> plainly(-12.5)
    '−12.5'
    """
    return spelt(f"{value:.{digits}g}")


def row_of(name: str, unit: str, values: Sequence[float]) -> tuple[str, ...]:
    """A row of a table: a quantity with its unit, then its values, each with its own digits."""
    printed, factor = printed_as(unit)
    head = f"{name}, {tr_unit(printed)}" if printed else name
    return head, *(column_of([factor * value])[0] for value in values)


def reduced() -> dict[str, str]:
    """What the reduced inertia of the links and its derivative are called in formulas, for ``<J>`` and ``<dJ>``."""
    inertia = tr("J_red")
    letter, _, index = inertia.partition("_")
    return {"J": inertia, "dJ": f"{letter}'_{{{index}}}"}


def inertias(parts: ConstantInertia, order: Order) -> Lexicon:
    """The parts of a constant inertia, by their letters."""
    duty = order.results["power"].duty
    rotor = (duty.motor.inertia or 0.0) if duty is not None else 0.0
    return {
        "J_R": Given(rotor, "kg*m^2", tr("moment of inertia of the rotor")),
        "u": Given(duty.ratio if duty is not None else 1.0, "", tr("speed ratio of the motor and the input shaft")),
        "J_g": Given(parts.gears, "kg*m^2", tr("moment of inertia of the gears, reduced to the input link")),
        "J_e": Given(parts.further, "kg*m^2", tr("further constant moment of inertia of the input link")),
    }


def drawn(caption: str, draw: Callable[[Drawing, Box], object], high: float, key: str) -> Figure:
    """A picture at the width of the note, ``high`` mm high, with words about as large as those of the text."""

    def lettered(drawing: Drawing, box: Box) -> object:
        with drawing.lettered(LETTERED):
            return draw(drawing, box)

    return Figure(caption, lettered, (WIDE, high), key)
