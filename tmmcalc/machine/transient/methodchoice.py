"""Which method integrates a drive: the eigenvalues of its Jacobian against the duration asked for.

Explicit steps must be shorter than about three of the fastest time constants, whatever the accuracy; implicit ones need
not. The eigenvalues are those at all speeds that are known beforehand, with all that acts there. An oscillation that
lasts must be followed by either, period by period; where these are too many its shaft is taken as rigid.
"""

from __future__ import annotations

import math
from itertools import pairwise, product
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.timescales import TimeScales, time_scales
from tmmcalc.machine.transient.equations import Regime, System, derivative
from tmmcalc.machine.transient.initial import assembled, known_speeds, sizes
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive, rigid_shafts
from tmmcalc.machine.transient.pointwise import stretches
from tmmcalc.machine.transient.profile import Profile
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.stability import growth, stable_step

EXPLICIT = 1_000  # explicit steps for the sake of stability that one mass takes before an implicit method is quicker
SEVERAL = 150  # the same with more unknowns, where accuracy asks for many times as many
PERIODS = 20  # periods that Kutta-Merson follows quicker than collocation
FOLLOWED = 1_000  # periods that are followed
DECAY = 20.0  # time constants after which an oscillation has died away


class Plan(NamedTuple):
    """The method that will run, why, and the shafts taken as rigid."""

    name: str
    reason: str
    rigid: frozenset[int]
    notes: tuple[str, ...]  # on the shafts that were not given as rigid
    ripple: float  # what rigid shafts leave out of the speeds: the swing after a sudden largest moment [rad/s]
    scales: TimeScales | None  # of the drive that runs; None: nothing changes within the duration


def plan(
    drive: Drive, scenario: Scenario, profile: Profile, method: Method, rigid: frozenset[int] | None = None
) -> Plan:
    """The method asked for, with the ``rigid`` shafts (by default those given so), or the one that suits the stiffness.

    Raises `AccuracyError` for fixed steps that are unstable.
    """
    rigid = rigid_shafts(drive) if rigid is None else rigid
    if method.name != "auto":
        values = eigenvalues(assembled(drive, scenario, profile, rigid), drive, scenario, profile)
        if method.step is not None:
            _check_stable(values, method.name, method.step, scenario.duration)
        return Plan(method.name, "asked for", rigid, (), 0.0, time_scales(values, scenario.duration))
    notes: list[str] = []
    ripple = 0.0
    while True:
        system = assembled(drive, scenario, profile, rigid)
        values = eigenvalues(system, drive, scenario, profile)
        periods, swing = _periods(values, scenario.duration), _swing(system, scenario.duration)
        if swing is None or periods <= FOLLOWED:
            scales = time_scales(values, scenario.duration)
            name, reason = _suitable(scales, periods, system.layout.works)
            return Plan(name, reason, rigid, tuple(notes), ripple, scales)
        size = sizes(drive, system, scenario, profile)
        ripple += size.moment / (swing.inertia * swing.rate)
        rigid |= {swing.shaft}
        notes.append(
            Phrase(
                "shaft {shaft} is taken as rigid, for it would swing {periods:.3g} periods at {rate:.3g} rad/s; "
                "its moment is that of the rigid drive, and one that comes suddenly can double it",
                shaft=swing.shaft + 1,
                periods=swing.periods,
                rate=swing.rate,
            )
        )


def _check_stable(values: Values, name: str, step: float, duration: float) -> None:
    """Refuse a fixed step with which a part of the solution would grow in place of dying away or swinging."""
    limit = stable_step(name, values, duration)
    if step <= limit:
        return
    worst = values[np.argmax(growth(name, step * values) / np.exp(step * np.maximum(values.real, 0.0)))]
    fastest = f"the fastest time constant is {1 / float(np.abs(values).max()):.3g} s"
    what = f"a swing of {abs(worst.imag):.4g} rad/s" if abs(worst.imag) > abs(worst.real) else "what should die away"
    times = float(growth(name, step * worst))
    longest = _rounded_down(limit)
    raise AccuracyError(
        f"steps of {step:g} s are unstable: {what} grows {times:.3g} times in every step; {fastest}",
        where="transient motion",
        value=step,
        limit=limit,
        remedy=f"steps of at most {longest} s, or step control, or an implicit method",
    )


def _rounded_down(value: float) -> str:
    """Three digits that are not more than the value."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 2)
    return f"{math.floor(value / unit) * unit:.3g}"


def eigenvalues(system: System, drive: Drive, scenario: Scenario, profile: Profile) -> Values:
    """Eigenvalues (m,) [1/s] at the speeds known beforehand and the telling angles, motor and brake on and off."""
    n, size = system.layout.groups, system.layout.works
    factor = max((step.factor for step in scenario.load), key=abs)
    parts, found = stretches(profile, factor), []
    for (motor, brake), angle in product(_switched(system, scenario), profile.telling):
        regime = Regime(motor, brake, 0.0, frozenset(), factor, *profile.place(angle, True))
        matrix = jacobian(system, profile, regime, derivative(system, regime, parts[regime.stretch]))
        for speed in known_speeds(drive, scenario, system.chain.motor_ratio):
            y = np.zeros(system.layout.size)
            y[0], y[n : 2 * n] = angle, speed
            found.append(matrix(0.0, y)[:size, :size])
    values: Values = np.linalg.eigvals(np.array(found)).ravel()
    return values


def _switched(system: System, scenario: Scenario) -> list[tuple[bool, bool]]:
    """Whether motor and brake act, as they do one after the other."""
    times = (0.0, *scenario.times()[:-1])
    powered = system.moment is not None
    return list(dict.fromkeys((powered and scenario.motor_on(t), scenario.brake_on(t)) for t in times))


def _periods(values: Values, duration: float) -> float:
    """Most periods of an oscillation within the duration, before it has died away."""
    lasting = np.minimum(DECAY / np.maximum(-values.real, DECAY / duration), duration)
    return float((np.abs(values.imag) * lasting).max()) / (2 * math.pi)


def _suitable(scales: TimeScales | None, periods: float, unknowns: int) -> tuple[str, str]:
    """The method for these time scales and the reason."""
    if scales is None:
        return "merson", "no time constant: not stiff"
    fast = f"fastest time constant {scales.fastest:.3g} s in {scales.duration:.3g} s"
    if scales.steps > (EXPLICIT if unknowns == 2 else SEVERAL):
        return "collocation", f"{fast}: stiff, stability alone would take {scales.steps:.2g} explicit steps"
    if periods > PERIODS:
        return "collocation", f"{periods:.0f} periods of oscillation to follow"
    return "merson", f"{fast}: not stiff"


class _Swing(NamedTuple):
    """The oscillation of two neighbours on their shaft."""

    shaft: int  # of the drive
    rate: float  # [rad/s]
    inertia: float  # the smaller one of the two groups [kg*m^2]
    periods: float  # within the duration, before it has died away


def _swing(system: System, duration: float) -> _Swing | None:
    """The shaft that swings longest between its two groups; None if no shaft swings."""
    chain, found = system.chain, []
    for group, (a, b) in enumerate(pairwise(chain.inertia)):
        mobility = 1 / a + (1 / b if b else 0.0)
        decay = chain.damping[group] * mobility / 2
        rate = math.sqrt(max(chain.stiffness[group] * mobility - decay * decay, 0.0))
        shaft = max(i for i, g in enumerate(chain.group) if g == group)
        periods = rate * min(duration, DECAY / decay if decay else duration) / (2 * math.pi)
        found.append(_Swing(shaft, rate, min(a, b or a), periods))
    longest = max(found, key=lambda swing: swing.periods, default=None)
    return longest if longest and longest.rate else None
