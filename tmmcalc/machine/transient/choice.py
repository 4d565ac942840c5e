"""Which method integrates a drive: the eigenvalues of its Jacobian against the duration asked for.

Explicit steps must be shorter than about three of the fastest time constants, whatever the accuracy; implicit ones need
not. An oscillation that lasts must be followed by either, period by period; where these are too many its shaft is
taken as rigid.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.errors import AccuracyError
from tmmcalc.machine.transient.equations import Regime, System, derivative
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive, rigid_shafts
from tmmcalc.machine.transient.profile import Profile
from tmmcalc.machine.transient.reading import stretches
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.setup import assembled, sizes, working
from tmmcalc.machine.transient.steps import MERSON, RK4_REAL
from tmmcalc.numerics.panels import Values

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
    ripple: float  # what rigid shafts leave out of the speeds, relative: the swing after a sudden largest moment


class Mode(NamedTuple):
    """What the eigenvalues say."""

    fastest: float  # largest |lambda| [1/s]
    damped: float  # fastest decay, largest -Re lambda [1/s]
    periods: float  # most periods of an oscillation within the duration, before it has died away


def plan(drive: Drive, scenario: Scenario, profile: Profile, method: Method) -> Plan:
    """The method asked for, or the one that suits the stiffness.

    Raises `AccuracyError` for fixed steps that are unstable.
    """
    rigid = rigid_shafts(drive)
    if method.name != "auto":
        if method.step is not None:
            _check_stable(modes(assembled(drive, scenario, profile, rigid), drive, scenario, profile), method)
        return Plan(method.name, "asked for", rigid, (), 0.0)
    notes: list[str] = []
    ripple = 0.0
    while True:
        system = assembled(drive, scenario, profile, rigid)
        mode = modes(system, drive, scenario, profile)
        swing = _swing(system, scenario.duration)
        if swing is None or mode.periods <= FOLLOWED:
            name, reason = _suitable(mode, scenario.duration, system.layout.works)
            return Plan(name, reason, rigid, tuple(notes), ripple)
        size = sizes(drive, system, scenario, profile)
        ripple += size.moment / (swing.inertia * swing.rate * size.speed)
        rigid |= {swing.shaft}
        notes.append(
            f"shaft {swing.shaft + 1} is taken as rigid, for it would swing {swing.periods:.3g} periods at "
            f"{swing.rate:.3g} rad/s; its moment is that of the rigid drive, and one that comes suddenly can double it"
        )


def _check_stable(mode: Mode, method: Method) -> None:
    """Refuse a fixed step in which the fastest part of the solution would grow instead of dying away."""
    limit = MERSON.real if method.name == "merson" else RK4_REAL
    if method.step and mode.damped * method.step > limit:
        raise AccuracyError(
            f"steps of {method.step:g} s are unstable: the fastest time constant is {1 / mode.damped:.3g} s",
            where="transient motion",
            value=method.step,
            limit=limit / mode.damped,
            remedy=f"steps below {limit / mode.damped:.3g} s, or step control, or an implicit method",
        )


def modes(system: System, drive: Drive, scenario: Scenario, profile: Profile) -> Mode:
    """The fastest eigenvalue and the longest oscillation at the working speeds, where the inertia is least."""
    n, size = system.layout.groups, system.layout.works
    factor = max((step.factor for step in scenario.load), key=abs)
    place = profile.place(profile.lightest, True)
    regime = Regime(system.moment is not None, scenario.brake is not None, 0.0, frozenset(), factor, *place)
    stretch = stretches(profile, regime.factor)[regime.stretch]
    matrix = jacobian(system, profile, regime, derivative(system, regime, stretch))
    found = []
    for speed in working(drive, scenario, system.chain.motor_ratio):
        y = np.zeros(system.layout.size)
        y[0], y[n : 2 * n] = profile.lightest, speed
        found.append(np.linalg.eigvals(matrix(0.0, y)[:size, :size]))
    return _mode(np.concatenate(found), scenario.duration)


def _mode(values: Values, duration: float) -> Mode:
    lasting = np.minimum(DECAY / np.maximum(-values.real, DECAY / duration), duration)
    size = np.abs(values)
    periods = float((np.abs(values.imag) * lasting).max()) / (2 * math.pi)
    return Mode(float(size.max()), float(-values.real.min()), periods)


def _steps(mode: Mode, duration: float) -> float:
    """Explicit steps that stability alone asks for."""
    return mode.fastest * duration / MERSON.real


def _suitable(mode: Mode, duration: float, unknowns: int) -> tuple[str, str]:
    """The method for these eigenvalues and the reason."""
    steps = _steps(mode, duration)
    fast = f"fastest time constant {1 / mode.fastest:.3g} s in {duration:.3g} s" if mode.fastest else "no time constant"
    if steps > (EXPLICIT if unknowns == 2 else SEVERAL):
        return "collocation", f"{fast}: stiff, stability alone would take {steps:.2g} explicit steps"
    if mode.periods > PERIODS:
        return "collocation", f"{mode.periods:.0f} periods of oscillation to follow"
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
