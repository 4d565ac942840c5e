"""Motions of a turn that the tests of cams share."""

from math import radians

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import polynomial
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import AngleLimits, Asked, CamTask

LIMITS = AngleLimits(radians(30), None)


def turn(law="sine", back_law=None, *, rise=60.0, high=30.0, back=60.0, stroke=0.02):
    """Rise, high dwell, return, low dwell; angles in deg, dwells of no angle left out."""
    laws = {"rise": LAWS[law], "return": LAWS[back_law or law]}
    moves = [
        ("rise", rise, 0.0, stroke),
        ("high dwell", high, stroke, stroke),
        ("return", back, stroke, 0.0),
        ("low dwell", 360.0 - rise - high - back, 0.0, 0.0),
    ]
    return Program(tuple(Phase(k, radians(a), b, e, laws.get(k)) for k, a, b, e in moves if a > 1e-9))


def overshooting(stroke):
    """A rise of 90 deg that tops the stroke at k = 0.7, a return of 90 deg that undershoots at k = 0.3."""
    over = polynomial("over", (0.0, [0, 0, 10.5, -17, 7.5]))
    under = polynomial("under", (0.0, [0, 0, -4.5, 13, -7.5]))
    return Program(
        (
            Phase("rise", radians(90), 0.0, stroke, over),
            Phase("high dwell", radians(30), stroke, stroke),
            Phase("return", radians(90), stroke, 0.0, under),
            Phase("low dwell", radians(150), 0.0, 0.0),
        )
    )


def task_of(program, kind="translating", *, limits=LIMITS, steps=None, step=1.0, loads=None, **asked):
    """A task with rows every ``step`` deg, or in ``steps``."""
    return CamTask(program, Asked(kind, **asked), limits, steps, radians(step), loads)
