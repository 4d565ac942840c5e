"""The levels of speed and angle that a scenario and a motor ask to be watched, and the words for passing them."""

from __future__ import annotations

from typing import NamedTuple

from tmmcalc.machine.transient.equations import Layout, Regime
from tmmcalc.machine.transient.events import Watch, level
from tmmcalc.machine.transient.pointwise import Stretch
from tmmcalc.machine.transient.scenario import Scenario

PASSED = {
    "target": "speed of the crank {level:.6g} rad/s",
    "overload": "the motor falls below its rated speed, {level:.6g} rad/s at the crank",
    "pull-out": "the motor falls below the speed of its largest moment, {level:.6g} rad/s at the crank",
    "reversal": "the crank turns back",
    "runaway": "the crank runs away: {level:.6g} rad/s",
    "cycle": "the motion repeats itself from cycle to cycle",
}


RUNAWAY = 5.0  # times the largest speed that is known beforehand: a motion without a duration is not followed further


class Limits(NamedTuple):
    """Speeds of the motor's group that are noted on the way down, of a crank that runs away, of the pole [rad/s]."""

    overload: float | None  # rated speed
    pull_out: float | None  # speed of the largest moment
    runaway: float | None  # None: the motion has a duration
    pole: float | None = None  # of the characteristic, beyond which the motor cannot be switched on


def stretch_ends(regime: Regime, stretch: Stretch) -> list[Watch]:
    """Both ends of the stretch in which the crank turns."""
    if stretch.period is not None:
        return []
    return [level("above", 0, regime.base + stretch.high, 1.0), level("below", 0, regime.base + stretch.low, -1.0)]


def ends(scenario: Scenario, layout: Layout) -> list[Watch]:
    """The angle and the speed that end the run."""
    found = []
    if scenario.end_angle is not None:
        found.append(level("angle", 0, scenario.angle + scenario.end_angle, 1.0))
    if scenario.end_speed is not None:
        found.append(level("speed", layout.crank, scenario.end_speed, _towards(scenario.speed, scenario.end_speed)))
    return found


def runaway_speeds(layout: Layout, limits: Limits) -> list[Watch]:
    """The speeds at which the crank has run away, forwards or backwards."""
    if limits.runaway is None:
        return []
    return [level("runaway", layout.crank, way * limits.runaway, way) for way in (1.0, -1.0)]


def noted_speeds(scenario: Scenario, layout: Layout, limits: Limits, motor: bool) -> list[Watch]:
    """Speeds that are only noted: the targets, and with the ``motor`` on its limits."""
    targets = [at for at in scenario.targets if at != scenario.end_speed]
    found = [level("target", layout.crank, at, _towards(scenario.speed, at), halts=False) for at in targets]
    for kind, at in (("overload", limits.overload), ("pull-out", limits.pull_out)):
        if at is not None and motor:
            found.append(level(kind, layout.speed, at, -1.0, halts=False))
    return found


def _towards(now: float, then: float) -> float:
    return 1.0 if then > now else -1.0
