"""What several chapters on machines say alike: the positions shown, the reduced inertia, the constant ones."""

from __future__ import annotations

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.motion import Motion
from tmmcalc.report.drawing.order import POSITIONS, Order
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


def shown(result: Motion, order: Order) -> list[int]:
    """The positions whose step is worked out: those that are asked for, or one.

    It is that of the working stroke that other chapters show, or without a linkage one at a quarter of the cycle.
    """
    asked = order.rows(POSITIONS, result.labels)
    rows = asked if asked is not None else _first(result, order)
    return [row for row in rows if row > 0] or [1]


def _first(result: Motion, order: Order) -> list[int]:
    """The position that is shown where none is asked for."""
    if order.spec.torque is not None:
        return [max(1, (len(result.labels) - 1) // 4)]
    kinematics = order.results["kinematics"]
    chain = chain_of(to_linkage(order.spec.linkage), kinematics)
    return [result.labels.index(kinematics.labels[rows_shown(order, chain, kinematics)[0]])]
