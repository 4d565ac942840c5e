"""A motor of a catalogue against the rules by which one is chosen, and what each rule alone would take.

The rules: the rated power covers the mean one; the root mean square of the moment in the steady motion does not exceed
the rated moment, so that the motor does not overheat; its largest moment stays below the break-down moment; every start
that is asked for succeeds. The textbook's own demand is sharper than the middle two: the speed never falls below the
rated one, so that the moment never exceeds the rated one (spec 3.58, w_min >= w_N). It is told, not asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.motors.model import Motor

START = "start"
TEXTBOOK = "never above the rated moment (textbook: w_min >= w_N)"  # told, not asked for
SLACK = 1e-9  # relative: a limit that is met exactly counts as kept


@record
class Judged:
    """A motor with what the machine asks of it over what it has; None: not found out, or not known of it."""

    motor: Motor
    ratio: float | None = quantity("u", "speed of the motor over that of the input shaft")
    load: float = quantity("P_required/P_N", "required power over the rated power")
    heating: float | None = quantity("M_motor_rms/M_N", "rms moment of the motor over its rated moment", default=None)
    largest: float | None = quantity(
        "M_motor_max/M_K", "largest moment of the motor over its break-down moment", default=None
    )
    peak: float | None = quantity("M_motor_max/M_N", "largest moment of the motor over its rated moment", default=None)
    starts: bool | None = quantity("starts", "whether every start that is asked for succeeds", default=None)
    reason: str = quantity("refused", "why the motor is refused; empty: it is chosen", default="")

    @derived("motor", "name of the motor")
    def name(self) -> str:
        """As in the catalogue."""
        return self.motor.name

    @derived("P_N[W]", "rated power")
    def power(self) -> float:
        """Of the name plate."""
        return self.motor.power

    @derived("n_N[rpm]", "rated speed")
    def rated_rpm(self) -> float:
        """Of the name plate."""
        return self.motor.rated_rpm


@record
class Taken:
    """The motor that one rule, beside that of mean power, would take."""

    rule: str = quantity("rule", "rule by which a motor is chosen")
    motor: str = quantity("motor", "name of the motor")
    power: float = quantity("P_N[W]", "rated power")


def kept(value: float | None, reserve: float = 0.0) -> bool | None:
    """Whether what is asked for, over what there is, leaves the reserve; None: not known."""
    return None if value is None else value * (1 + reserve) <= 1 + SLACK


def rules(reserve: float) -> Mapping[str, Callable[[Judged], bool | None]]:
    """Every rule by its name: whether a motor keeps it, None where that is not known."""
    return {
        "mean power": lambda each: kept(each.load, reserve),
        "rms moment": lambda each: kept(each.heating, reserve),
        "break-down moment": lambda each: kept(each.largest),
        START: lambda each: each.starts,
        TEXTBOOK: lambda each: kept(each.peak),
    }


def taken(judged: Collection[Judged], reserve: float) -> tuple[Taken, ...]:
    """What every rule would take, the first that keeps it; none for a rule that none keeps."""
    firsts = ((rule, next((each for each in judged if keeps(each)), None)) for rule, keeps in rules(reserve).items())
    return tuple(Taken(rule, first.name, first.power) for rule, first in firsts if first is not None)


def decided(judged: Collection[Judged], reserve: float) -> bool:
    """Whether it is known what every rule takes that the steady motion decides."""
    told = [keeps for rule, keeps in rules(reserve).items() if rule != START]
    return all(any(keeps(each) for each in judged) for keeps in told)
