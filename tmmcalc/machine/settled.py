"""The ratio that a train has between a motor and a crank of given speeds: u = omega_N/omega_1, without an open pair's.

A motor that is to be chosen asks for the efficiency and the inertia of the train, which has the ratio that the speed of
the motor gives it. Both are settled in rounds: the motor with the train of the round before, the train of this motor,
until the motor comes again. The first round takes gears without losses and without inertia. Where two or more motors
come in turn no round settles it: the strongest of them is taken, which is safe.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.driveline import DriveLine, Round, drive_line
from tmmcalc.machine.judged import Judged, Taken
from tmmcalc.machine.motors.model import Motor

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Winner
    from tmmcalc.machine.model import Gears

RPM = 30 / math.pi


@record
class MotorFound:
    """A motor that was chosen, why, and what came of the others."""

    motor: Motor
    reasons: tuple[str, ...]
    judged: tuple[Judged, ...]  # itself and all that are not larger, by their power
    taken: tuple[Taken, ...]  # what each rule of choice would take


@record
class Settled:
    """The ratio of speeds that the train is sought for, and the motor where that was chosen with it."""

    ratio: float = quantity(
        "u_asked", "speed of the motor over that of the train's output shaft, for which it is sought"
    )
    origin: str = quantity("u_asked_of", "whose ratio that is")
    found: MotorFound | None = None  # None: the motor is given, or the ratio
    rounds: tuple[Round, ...] = ()
    alternating: tuple[str, ...] = quantity(
        "motors_in_turn", "motors that came in turn, of which the strongest is taken; empty: settled", default=()
    )


class Chosen(Protocol):
    """A motor that was chosen; the others are looked at when it is to be told."""

    motor: Motor

    def told(self) -> MotorFound:
        """With what came of the others."""


Choose = Callable[[DriveLine], Chosen]  # the motor for a drive line
Seek = Callable[[float, str], "Winner | None"]  # (ratio, whose it is) -> the best train; None: none is chosen


def settled(given: Gears, speed: float, choose: Choose, seek: Seek) -> Settled:
    """The motor and the ratio at the mean ``speed`` [rad/s] of the crank, in rounds.

    Efficiency and inertia that are ``given`` stay; where no train is chosen one round is enough. Raises what ``choose``
    and ``seek`` raise.
    """
    rounds: list[Round] = []
    every: list[Chosen] = []
    line = drive_line(given)
    while True:
        found = choose(line)
        motor = found.motor
        names = [each.motor for each in rounds]
        if motor.name in names:
            turn = every[names.index(motor.name) :]
            safe = max(turn, key=lambda each: each.motor.power) if len(turn) > 1 else found
            return _settled(
                safe, speed, given, rounds, tuple(each.motor.name for each in turn) if len(turn) > 1 else ()
            )
        ratio = motor.speed / speed
        train = seek(*of_reducer(ratio, origin(motor, speed), given))
        line = replace(drive_line(given, train), ratio=None, ratio_of="")
        rounds.append(Round(motor.name, ratio, "" if train is None else train.name, line.efficiency, line.inertia))
        every.append(found)
        if train is None:
            return _settled(found, speed, given, rounds, ())


def _settled(found: Chosen, speed: float, given: Gears, rounds: list[Round], turn: tuple[str, ...]) -> Settled:
    left = of_reducer(found.motor.speed / speed, origin(found.motor, speed), given)
    return Settled(*left, found.told(), tuple(rounds), turn)


def of_reducer(ratio: float, whose: str, given: Gears) -> tuple[float, str]:
    """What an open pair leaves of a ratio to the reducer, and whose it is."""
    if given.open is None:
        return ratio, whose
    return ratio / given.open.ratio, f"{whose}, over {given.open.ratio:.6g} of the {given.open.name}"


def origin(motor: Motor, speed: float) -> str:
    """Whose ratio it is, with its numbers: the rated speed over the mean speed [rad/s] of the crank.

    >>> origin(Motor("4A80B4", 1500.0, 1415 / RPM), 80 / RPM)
    '1415 rpm of motor 4A80B4 over 80 rpm of the crank'
    """
    return f"{motor.speed * RPM:.6g} rpm of motor {motor.name} over {speed * RPM:.6g} rpm of the crank"
