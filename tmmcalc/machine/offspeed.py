"""The speed that the spec asks for against the speed that the machine really keeps.

Friction, inertia forces, the work of loads that depend on speed, and power are computed at the speed of the spec; a
motor with its gears turns the input at another one. Half a per cent is worth a note: forces of inertia differ by
a whole one; more than the slip of a motor is a fault of the ratio or of the speed.
"""

from __future__ import annotations

import math
from typing import Any

from tmmcalc.core.notes import Note, Phrase, held
from tmmcalc.machine.verdicts import Verdict

TOLD = 0.005  # relative difference of the speeds that is worth a note
GRAVE = 0.05  # and from which results of the other speed mislead
RPM = 30 / math.pi
INPUT = "mechanism.input.speed"  # where the spec gives the speed; of a diagram ``torque.speed``


def off_speed(mean: float, asked: float, ratio: float | None, sense: float, key: str) -> Verdict | None:
    """What to say of a ``mean`` speed [rad/s] that is not the one ``asked`` for; None if they agree.

    ``ratio`` of the gears to the motor is None where no ratio sets the speed; ``sense`` is -1 of a clockwise input,
    ``key`` the place of the speed in the spec.

    >>> str(off_speed(10.01, 10.0, None, 1.0, INPUT))
    'None'
    """
    off = mean / asked - 1
    if abs(off) <= TOLD:
        return None
    text = _OF_INPUT[off > 0] if key == INPUT else _OF_OTHERS[off > 0]
    said = Phrase(text, mean=mean * RPM, off=100 * abs(off), asked=asked * RPM)
    remedy = 'set {key} to "{speed:.6g} rpm" and run again'
    if ratio:
        remedy = (
            'set {key} to "{speed:.6g} rpm", or to "by the motor" where the ratio is given, and run again, or take the '
            "gear ratio {fitting:.5g} in place of {ratio:.5g}"
        )
    fitting = ratio * mean / asked if ratio else 0.0
    told = Phrase(remedy, key=key, speed=sense * mean * RPM, fitting=fitting, ratio=ratio or 0.0)
    return Verdict(
        "warning" if abs(off) > GRAVE else "note",
        Phrase("{said}: {remedy}", said=said, remedy=told),
        *(mean, asked, "rad/s", "mean speed"),
    )


_OF_INPUT = (
    "the mean speed {mean:.6g} rpm lies {off:.3g} % below the {asked:.6g} rpm of the spec, at which loads, friction, "
    "inertia forces and power are computed",
    "the mean speed {mean:.6g} rpm lies {off:.3g} % above the {asked:.6g} rpm of the spec, at which loads, friction, "
    "inertia forces and power are computed",
)
_OF_OTHERS = (
    "the mean speed {mean:.6g} rpm lies {off:.3g} % below the {asked:.6g} rpm of the spec, at which work and power are "
    "computed",
    "the mean speed {mean:.6g} rpm lies {off:.3g} % above the {asked:.6g} rpm of the spec, at which work and power are "
    "computed",
)


def off_rated(rated: float, ratio: float, asked: float, sense: float, key: str) -> Note | None:
    """What to say of a motor whose ``rated`` speed [rad/s] over the ``ratio`` misses the speed ``asked`` for.

    >>> off_rated(150.0, 15.0, 10.2, 1.0, INPUT) is None
    True
    """
    at_input = rated / ratio
    if abs(at_input / asked - 1) <= GRAVE:
        return None
    text = (
        "at its rated speed the motor turns the input with {value:.6g} rpm through the ratio {ratio:.5g}, "
        "{off:.3g} % below the {limit:.6g} rpm of the spec, at which all of this is computed: set transmission.ratio "
        'to {fitting:.5g}, or {key} to "{speed:.6g} rpm"'
    )
    if at_input > asked:
        text = (
            "at its rated speed the motor turns the input with {value:.6g} rpm through the ratio {ratio:.5g}, "
            "{off:.3g} % above the {limit:.6g} rpm of the spec, at which all of this is computed: set "
            'transmission.ratio to {fitting:.5g}, or {key} to "{speed:.6g} rpm"'
        )
    words: dict[str, Any] = {
        "ratio": ratio,
        "off": 100 * abs(at_input / asked - 1),
        "fitting": rated / asked,
        "key": key,
        "speed": sense * at_input * RPM,
    }
    return held("warning", text, at_input, asked, "rad/s", shown="rpm", name="rated speed at the input", **words)
