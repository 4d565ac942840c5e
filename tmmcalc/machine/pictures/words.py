"""What the results of the room call things, as drawings say it: methods, schemes, causes, ends of motions."""

from __future__ import annotations

import math
import re

from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.numbers import number

BEHIND = "behind "  # how the name of a mass after a shaft begins
LEVEL = re.compile(r"-?\d[\d.e+-]*")  # a number of a message


def indexed(sign: str) -> str:
    """A letter and its index, as a formula has them.

    >>> indexed("M_red")
    'M_{red}'
    """
    letter, _, index = sign.partition("_")
    return f"{letter}_{{{index}}}"


def speed_words(speed: float, *, turns: bool = True) -> str:
    """The speed of the input."""
    if not turns:
        return tr("{speed} m/s", speed=minus(number(speed)))
    values = {"speed": minus(number(speed)), "rpm": minus(number(speed * 30 / math.pi))}
    return tr("{speed} rad/s ({rpm} rpm)", **values)


def under(result: Flywheel) -> str:
    """What the machine really runs under."""
    if result.undriven:
        return tr("under its loads")
    return tr("under forces of position") if result.required is None else tr("under the motor")


def method_name(method: str) -> str:
    """A method for the flywheel."""
    names = {
        "book": tr("textbook"),
        "wittenbauer": tr("Wittenbauer"),
        "mertsalov": tr("Mertsalov"),
        "artobolevsky": tr("Artobolevsky"),
    }
    return names.get(method) or tr_name(method)


def scheme_name(scheme: str) -> str:
    """A scheme of balancing, or the weights that the spec gives."""
    names = {
        "minimax": tr("least maximum"),
        "lanchester": tr("Lanchester's pair"),
        "lanchester 2": tr("Lanchester's pairs, 1st and 2nd order"),
        "given": tr("weights given"),
    }
    return names.get(scheme) or tr_name(scheme)


def cause_name(name: str) -> str:
    """A cause of reduced moment: one of the program's own, or as the spec calls it."""
    own = {
        "weight": tr("weights"),
        "cam force": tr("force on the cam"),
        "cam weight": tr("weight on the cam"),
        "cam spring": tr("spring of the cam"),
        "cam friction": tr("friction of the cam"),
    }
    return own.get(name) or tr_name(name)


def mass_name(name: str) -> str:
    """A mass of the drive: one of its ends, or by the shaft before it, as the spec calls it."""
    if name.startswith(BEHIND):
        return tr("behind {shaft}", shaft=name.removeprefix(BEHIND))
    return tr_name(name)


def form_name(kind: str) -> str:
    """A form of a motor's characteristic."""
    names = {
        "parabolic": tr("parabola"),
        "linear": tr("line"),
        "kloss": tr("Kloss"),
        "table": tr("by points"),
    }
    return names.get(kind) or tr_name(kind)


def end_text(end: End) -> str:
    """How a motion in time ended."""
    return {
        "time": tr("its time is up"),
        "speed": tr("it has reached the speed asked for"),
        "angle": tr("it has turned by the angle asked for"),
        "standstill": tr("it stands still for good"),
        "stall": tr("the motor stalls"),
        "steady": tr("it repeats itself from cycle to cycle"),
        "runaway": tr("it runs away, faster and faster"),
    }[end]


def event_text(event: Event) -> str:
    """What happened; its level is the number in its message."""
    found = LEVEL.search(event.message)
    level = minus(number(float(found[0]), 6)) if found else ""
    return {
        "load": tr("load factor {level}", level=level),
        "motor on": tr("the motor is switched on"),
        "motor off": tr("the motor is switched off"),
        "brake on": tr("the brake is put on"),
        "brake off": tr("the brake is taken off"),
        "target": tr("speed of the crank {level} rad/s", level=level),
        "overload": tr("the motor falls below its rated speed, {level} rad/s at the crank", level=level),
        "pull-out": tr(
            "the motor falls below the speed of its largest moment, {level} rad/s at the crank", level=level
        ),
        "reversal": tr("the crank turns back"),
        "runaway": tr("the crank runs away: {level} rad/s", level=level),
        "steady": tr("the motion repeats itself from cycle to cycle"),
        "angle": tr("the crank has turned by {level} rad", level=level),
        "standstill": tr("the crank stands still"),
        "stall": tr("the motor cannot move the crank"),
    }[event.kind]
