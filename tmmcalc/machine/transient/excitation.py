"""The excitation of a series machine that brakes: at which speed and with which resistance it excites itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.machine.motors.braking import Braking, braking, critical_speed
from tmmcalc.machine.motors.model import RPM, Motor
from tmmcalc.machine.verdicts import Verdict

if TYPE_CHECKING:
    from tmmcalc.machine.transient.results import Transient
    from tmmcalc.machine.transient.scenario import Scenario


def check_excitation(motor: Motor, how: Braking, scenario: Scenario, ratio: float) -> None:
    """Raise `NoSolutionError` for plugging at once at a speed where nothing limits the current.

    ``ratio`` is the speed of the ``motor`` over that of the crank.
    """
    line = braking(motor, how)
    speed, pole = scenario.speed * ratio, line.most
    if pole is None or speed < pole or not scenario.motor_on(0.0):
        return
    critical = _circuit(motor, how) * speed / pole
    raise NoSolutionError(
        f"with {_circuit(motor, how):.5g} ohm in its circuit the current of the series motor, turned round at "
        f"{speed * RPM:.5g} rpm, has no limit: its flux is in proportion to the current, and the critical resistance "
        f"there is {critical:.5g} ohm",
        where=f"transient motion, scenario {scenario.name}",
        value=_circuit(motor, how),
        limit=critical,
        remedy=f"add at least {critical - motor.known('resistance'):.5g} ohm, or give the saturation of the motor",
    )


def excitation(motor: Motor, how: Braking, found: Transient, ratio: float) -> tuple[Verdict, ...]:
    """What a motion shows of a machine that excites itself: none for other ways to brake.

    ``ratio`` is the speed of the ``motor`` over that of the first mass.
    """
    least = critical_speed(braking(motor, how))
    begin = next((on for on, _ in found.scenario.motor if on <= found.t[-1]), None)
    if how.kind != "dynamic" or least is None or begin is None:
        return ()
    speed = float(np.interp(begin, found.t, found.omega[0])) * ratio
    resistance = _circuit(motor, how)
    critical = resistance * speed / least
    numbers = resistance, critical, "ohm", "R + R_a"
    values = {"resistance": resistance, "critical": critical, "speed": speed * RPM, "least": least * RPM}
    if resistance >= critical:
        text = (
            "the motor does not excite itself: the {resistance:.5g} ohm of its circuit are not below the critical "
            "{critical:.5g} ohm at the {speed:.5g} rpm of the motor at which it begins to brake, and nothing but the "
            "load brakes: less resistance, or a source of its own for the field"
        )
        return (Verdict("warning", Phrase(text, **values), *numbers),)
    text = (
        "the motor excites itself, for the {resistance:.5g} ohm of its circuit are below the critical {critical:.5g} "
        "ohm at the {speed:.5g} rpm of the motor at which it begins to brake; it does so down to {least:.5g} rpm, "
        "below "
        "which nothing but the load brakes"
    )
    return (Verdict("note", Phrase(text, **values), *numbers),)


def _circuit(motor: Motor, how: Braking) -> float:
    """Resistance of the whole circuit [ohm]."""
    return motor.known("resistance") + how.resistance
