"""The formulas of the time-optimal law (`tmmcalc.core.timelaw`), of whatever moves by it: its times, its phases."""

from __future__ import annotations

from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon

ACCELERATED, UNIFORM, SLOWED = 1, 2, 3  # numbers of the phases
PHASES = {  # way and speed; <t> is the time from the beginning
    ACCELERATED: ("s = a_m*<t>**2/2", "v = a_m*<t>"),
    UNIFORM: ("s = S_1 + v_p*(<t> - t_1)", "v = v_p"),
    SLOWED: ("s = S_m - a_m*(T - <t>)**2/2", "v = a_m*(T - <t>)"),
}
SETTLED, BETWEEN = ("t_1 = v_p/a_m", "S_1 = a_m*t_1**2/2"), ("t_2 = T - 2*t_1", "S_2 = v_p*t_2")


def by_travel(law: TimeLaw, *, timed: bool, speed: str = "v_m") -> tuple[str, ...]:
    """The formulas from the travel on, which a given duration settles where ``timed``, else the limit of the speed."""
    if timed:
        return ("v_p = a_m*(T - sqrt(T**2 - 4*S_m/a_m))/2", *SETTLED, *BETWEEN)
    if not law.uniform:
        return ("v_p = sqrt(S_m*a_m)", *SETTLED, "T = 2*t_1")
    return (f"v_p = {speed}", *SETTLED, "t_2 = (S_m - 2*S_1)/v_p", BETWEEN[1], "T = 2*t_1 + t_2")


def by_duration(law: TimeLaw) -> tuple[str, ...]:
    """The formulas to the travel that the duration leaves."""
    if law.uniform:
        return ("v_p = v_m", *SETTLED, *BETWEEN, "S_m = 2*S_1 + S_2")
    return ("t_1 = T/2", "v_p = a_m*t_1", SETTLED[1], "S_m = 2*S_1")


def quantities(law: TimeLaw, unit: str, *, travel: str, peak: str, allowed: str) -> Lexicon:
    """The law by its letters, of a motion to the negative side the sizes; what travel, speed, acceleration are of."""
    return {
        "S_m": Given(abs(law.travel), unit, travel),
        "v_p": Given(law.speed, f"{unit}/s", peak),
        "a_m": Given(law.acceleration, f"{unit}/s^2", allowed),
        "t_1": Given(law.ramp, "s", tr("time of the acceleration and of the deceleration")),
        "t_2": Given(law.uniform, "s", tr("time of the uniform motion")),
        "T": Given(law.duration, "s", tr("time of the whole motion")),
        "S_1": Given(law.ramp_travel, unit, tr("travel during the acceleration and during the deceleration")),
        "S_2": Given(law.uniform_travel, unit, tr("travel during the uniform motion")),
    }


def phase_named(phase: int) -> str:
    """A phase as it heads what is told of it."""
    return {
        ACCELERATED: tr("Acceleration:"),
        UNIFORM: tr("Uniform motion:"),
        SLOWED: tr("Deceleration:"),
    }[phase]
