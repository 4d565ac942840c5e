"""Which method integrates a drive: the eigenvalues of its Jacobian against the duration asked for.

Explicit steps must be shorter than about three of the fastest time constants, whatever the accuracy; implicit ones need
not. An oscillation that lasts must be followed by either, period by period; if it is so fast that nobody
would, the stiffest shaft is taken as rigid.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.machine.transient.equations import System, derivative
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.model import Drive, rigid_shafts
from tmmcalc.machine.transient.profile import Profile
from tmmcalc.machine.transient.reading import stretches
from tmmcalc.machine.transient.results import Method
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.setup import assembled, at_start, sizes, working
from tmmcalc.machine.transient.steps import MERSON
from tmmcalc.numerics.panels import Values

EXPLICIT = 3_000  # explicit steps for the sake of stability that are still cheaper than implicit ones
PERIODS = 20  # periods that Kutta-Merson follows in less time than scipy takes to load and to follow them
FOLLOWED = 1_000  # periods that are followed at all
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
    periods: float  # most periods of an oscillation within the duration, before it has died away


def plan(drive: Drive, scenario: Scenario, profile: Profile, method: Method) -> Plan:
    """The method asked for, or the one that suits the stiffness."""
    rigid = rigid_shafts(drive)
    if method.name != "auto":
        return Plan(method.name, "asked for", rigid, (), 0.0)
    taken: list[str] = []
    ripple = 0.0
    while True:
        system = assembled(drive, scenario, profile, rigid)
        mode = modes(system, drive, scenario, profile)
        if mode.periods <= FOLLOWED or len(system.chain.inertia) == 1:
            name, reason = _suitable(mode, scenario.duration)
            return Plan(name, reason, rigid, tuple(taken), ripple)
        shaft, rate, inertia = _stiffest(system)
        size = sizes(drive, system, scenario, profile)
        ripple += size.moment / (inertia * rate * size.speed)
        rigid |= {shaft}
        taken.append(
            f"shaft {shaft + 1} is taken as rigid, for it would swing {mode.periods:.3g} periods at {rate:.3g} rad/s; "
            f"its moment is that of the rigid drive, and a moment that comes suddenly can double it"
        )


def modes(system: System, drive: Drive, scenario: Scenario, profile: Profile) -> Mode:
    """The fastest eigenvalue and the longest oscillation at the start and at the working speeds."""
    n, size = system.layout.groups, system.layout.works
    regime = at_start(scenario, profile, system.moment is not None)
    stretch = stretches(profile, regime.factor)[regime.stretch]
    matrix = jacobian(system, profile, regime, derivative(system, regime, stretch))
    found = []
    for speed in working(drive, scenario, system.chain.motor_ratio):
        y = np.zeros(system.layout.size)
        y[0], y[n : 2 * n] = scenario.angle, speed
        found.append(np.linalg.eigvals(matrix(0.0, y)[:size, :size]))
    return _mode(np.concatenate(found), scenario.duration)


def _mode(values: Values, duration: float) -> Mode:
    lasting = np.minimum(DECAY / np.maximum(-values.real, DECAY / duration), duration)
    return Mode(float(np.abs(values).max()), float((np.abs(values.imag) * lasting).max()) / (2 * math.pi))


def _suitable(mode: Mode, duration: float) -> tuple[str, str]:
    """The method for these eigenvalues and the reason."""
    steps = mode.fastest * duration / MERSON.real
    fast = f"fastest time constant {1 / mode.fastest:.3g} s in {duration:.3g} s" if mode.fastest else "no time constant"
    if steps > EXPLICIT:
        return "LSODA", f"{fast}: stiff, stability alone would take {steps:.2g} explicit steps"
    if mode.periods > PERIODS:
        return "DOP853", f"{mode.periods:.0f} periods of oscillation to follow"
    return "merson", f"{fast}: not stiff"


def _stiffest(system: System) -> tuple[int, float, float]:
    """The shaft between the two groups that swing fastest on it, their frequency [rad/s] and smaller inertia."""
    chain = system.chain
    pairs = [(a, b or math.inf) for a, b in pairwise(chain.inertia)]
    rates = [math.sqrt(c * (1 / a + 1 / b)) for c, (a, b) in zip(chain.stiffness, pairs, strict=True)]
    group = int(np.argmax(rates))
    return max(i for i, g in enumerate(chain.group) if g == group), rates[group], min(pairs[group])
