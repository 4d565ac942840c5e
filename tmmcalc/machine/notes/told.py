"""What several chapters on machines say alike: speeds in rpm, the reduced inertia, the constant ones."""

from __future__ import annotations

from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon


def mean_speed(speed: float) -> Given:
    """The mean angular velocity [rad/s] that the coefficient of speed fluctuation is told of."""
    return Given(speed, "rad/s", tr("mean angular velocity of the input link, half the sum of the extreme ones"))


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
