"""The true flywheel: the least constant inertia for which the motion under the real motor is even enough.

Nothing is approximated here: every trial is the steady motion under the motor's characteristic, with the viscous and
quadratic forces and the lag of the motor. The inertia found is the smallest one, not below what is at hand, with
delta <= [delta]. The fluctuation need not fall steadily with the inertia (a lagging motor resonates with it), so
inertias between are probed for an earlier root, and the result says whether delta fell in all trials.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.collocation import Orbit
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import energy_curve
from tmmcalc.machine.flywheel.results import RequiredInertia, Trial
from tmmcalc.machine.flywheel.search import Model, inertia_between, least_inertia, sufficient, tried
from tmmcalc.machine.flywheel.wittenbauer import METHODS, check, tangents
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.onemass import SPEEDS, OneMass, vanishing
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.settling import Halt, directly, followed, guessed
from tmmcalc.machine.stall import stall_inertia
from tmmcalc.machine.steady import driven, regime_on

PROBES = 1  # inertias tried between the one at hand and the root
PROBES_LAGGING = 5  # the same where the motor lags, so that a resonance may stand between
BEYOND = (1.5, 3.0)  # times the root: inertias tried above it where the motor lags
SHORTEST = 0.01  # of the root: where the probes begin if less is at hand
ABOVE = 2.0  # times the inertia that just does not stall: where the search begins if Mertsalov's stalls
THRESHOLD = 1e-3  # relative tolerance of the inertia that just does not stall, which is told
EQUAL = 1e-9  # relative differences of delta that do not count as rising
MARGIN = 2.0  # of the slope between trials, which is not that at the root
PEAK = 1.02  # times the largest moment of the motor at some speeds: more it has at none
APART = 1e-3  # relative difference of delta from which on two trials tell a slope
NOISE = 1e-12  # nor absolute ones: delta is a difference of two speeds, and has their rounding

_MERTSALOV = METHODS[2]


def required_inertia(
    cycle: Cycle,
    characteristic: Characteristic,
    delta: float,
    constant_inertia: float,
    time_constant: float = 0.0,
    *,
    probes: int | None = None,
    sense: float = 1.0,
    remarked: bool = True,
) -> RequiredInertia:
    """Least constant inertia, not below ``constant_inertia`` [kg*m^2], with delta <= ``delta`` under the motor.

    ``characteristic`` is the motor's moment on the input shaft, ``time_constant`` its lag [s]; ``probes`` inertias in
    between are tried for an earlier root; ``sense`` is -1 where the input turns clockwise; ``remarked``: what the
    machine does without a flywheel is told, and of one that stalls the inertia that just carries it, which costs most.
    Raises `NoSolutionError` if the motor cannot carry the load with any inertia, `UsageError` for a ``delta`` outside
    (0, 1).
    """
    check(delta, cycle.speed, constant_inertia)
    trials, near = _ample(cycle, characteristic, delta, constant_inertia, time_constant, sense)
    motions, start = Motions(cycle, characteristic, time_constant, near), trials[-1]

    def model(inertia: float) -> float | None:
        if not remarked and surely_uneven(cycle, characteristic, inertia, delta):
            return None  # by how much, or whether it stalls, takes as long as all the rest
        return motions.delta(inertia)

    first, root = searched(model, delta, constant_inertia, trials, lagging=time_constant > 0, probes=probes)
    regime = near if root is start else motions.regime(root.inertia)
    if not remarked:
        return replace(result_of(first, root, regime, trials, None, delta), remarks=())
    carrying = None
    if first.delta is None:
        carrying = _carrying(cycle, characteristic, time_constant, first.inertia)
    return result_of(first, root, regime, trials, carrying, delta)


def surely_uneven(cycle: Cycle, characteristic: Characteristic, constant_inertia: float, delta: float) -> bool:
    """Whether no steady motion with an inertia [kg*m^2] keeps ``delta``, as its energy could not cover the work.

    Between two angles the loads take at least the work that is left if the motor gave its largest moment all the
    way; the energy of a motion within ``delta`` falls by what is between its bounds at most. Nothing is sure where
    loads drive, for then the motor does not bound the speed.
    """
    fastest = characteristic.synchronous
    if fastest is None or fastest <= 0 or np.any(cycle.viscous > 0) or np.any(cycle.quadratic > 0):
        return False
    if float(cycle.panels.total(cycle.moment)) >= 0:
        return False
    slowest = (1 - delta / 2) / (1 + delta / 2)  # of a motion, over its fastest speed
    energy = (fastest / slowest) ** 2 / 2  # of 1 kg*m^2: the motor drives somewhere, so below its no-load speed
    speeds = np.append(fastest * SPEEDS, characteristic.critical or fastest)
    largest = PEAK * float(np.max(characteristic.moment(speeds)))
    work, _ = cycle.panels.primitive(cycle.moment + largest)
    inertia = cycle.inertia + constant_inertia
    before = np.maximum.accumulate((work - energy * inertia).ravel())
    after = work.ravel() - energy * slowest**2 * float(np.min(inertia))
    return bool(np.any(before > after))


def fluctuation(cycle: Cycle, characteristic: Characteristic, time_constant: float = 0.0) -> Model:
    """The function constant inertia [kg*m^2] -> delta of the steady motion.

    None where the machine stalls or runs away, or where its inertia vanishes and nothing bounds the speed.
    """
    return Motions(cycle, characteristic, time_constant).delta


class Motions:
    """Steady motions of a machine with one constant inertia or another; each is guessed from the nearest of before."""

    def __init__(
        self, cycle: Cycle, characteristic: Characteristic, time_constant: float, near: Regime | None = None
    ) -> None:
        self._machine = OneMass(cycle, 0.0, characteristic, time_constant)
        self._known = {} if near is None else {near.constant_inertia: (near.panels, near.omega)}
        self._orbits: dict[float, Orbit] = {}

    def delta(self, inertia: float) -> float | None:
        """Unevenness with a constant inertia [kg*m^2], as `fluctuation` gives it."""
        if vanishing(self._machine.cycle, inertia) is not None:
            return None
        machine, guess = replace(self._machine, constant=inertia), None
        if self._known:
            beside = min(self._known, key=lambda each: abs(each - inertia))
            guess = guessed(machine, self._known[beside], beside)
        orbit = directly(machine, guess) or followed(machine)
        if isinstance(orbit, Halt):
            return None
        omega = machine.speed(orbit.panels, orbit.y[0])
        self._known[inertia], self._orbits[inertia] = (orbit.panels, omega), orbit
        (slowest, _), (fastest, _) = orbit.panels.extremes(omega)
        return 2 * (fastest - slowest) / (fastest + slowest)

    def regime(self, inertia: float) -> Regime:
        """The regime with an inertia whose unevenness was asked for."""
        return regime_on(replace(self._machine, constant=inertia), self._orbits[inertia])


def searched(
    model: Model,
    delta: float,
    constant_inertia: float,
    trials: list[Trial],
    *,
    lagging: bool = False,
    probes: int | None = None,
) -> tuple[Trial, Trial]:
    """The trial with the inertia at hand and that with the least one that does, from the last of the ``trials`` on.

    Every run of the model is added to ``trials``.
    """
    start = trials[-1]
    at_hand = trials[0].inertia == constant_inertia
    first = root = trials[0] if at_hand else tried(model, constant_inertia, trials)
    if not sufficient(first, delta):
        inside, beyond = (PROBES_LAGGING, BEYOND) if lagging else (PROBES, ())
        root = least_inertia(model, delta, first, start, trials)
        root = _earliest(model, delta, first, root, inside if probes is None else probes, trials)
        for factor in beyond:
            tried(model, factor * root.inertia, trials)
    return first, root


def _ample(
    cycle: Cycle,
    characteristic: Characteristic,
    delta: float,
    constant_inertia: float,
    time_constant: float,
    sense: float,
) -> tuple[list[Trial], Regime]:
    """The motion with the inertia by Mertsalov, or the one at hand if that is more; `driven` says why if there is none.

    If the machine stalls with it, a second trial follows with enough inertia to run.
    """
    inertia, trials = ample(cycle, delta, constant_inertia), []
    try:
        regime = driven(cycle, inertia, characteristic, time_constant=time_constant, sense=sense)
    except NoSolutionError as error:
        if error.value != inertia or error.limit is None:
            raise
        # the error of a stall tells the inertia that just carries the machine over its peak load
        trials = [Trial(inertia, None)]
        inertia = ABOVE * error.limit
        regime = driven(cycle, inertia, characteristic, time_constant=time_constant, sense=sense)
    return [*trials, Trial(inertia, regime.delta)], regime


def ample(cycle: Cycle, delta: float, constant_inertia: float) -> float:
    """The inertia that a search begins with: that by Mertsalov, or the one at hand if that is more [kg*m^2]."""
    return max(float(tangents(energy_curve(cycle), delta, cycle.speed, (_MERTSALOV,)).inertia[0]), constant_inertia)


def _carrying(cycle: Cycle, characteristic: Characteristic, time_constant: float, stalls: float) -> float | None:
    """The least constant inertia beyond one that ``stalls`` that carries the machine; None if the search finds none."""
    try:
        return stall_inertia(cycle, characteristic, time_constant=time_constant, tolerance=THRESHOLD, stalls=stalls)
    except (AccuracyError, NoSolutionError):
        return None


def _earliest(model: Model, delta: float, first: Trial, root: Trial, count: int, trials: list[Trial]) -> Trial:
    """The earliest root that ``count`` probes between the inertia at hand and the ``root`` found reveal."""
    low, start = first, max(first.inertia, SHORTEST * root.inertia)
    for i in range(1, count + 1):
        probe = tried(model, start * (root.inertia / start) ** (i / (count + 1)), trials)
        if sufficient(probe, delta):
            return inertia_between(model, delta, low, probe, trials)
        low = probe
    return root


def _inexact(root: Trial, regime: Regime, trials: tuple[Trial, ...], delta: float) -> float:
    """Relative error of the inertia: by how much the unevenness is off, times d ln J / d ln delta.

    The unevenness is off by what the search leaves, and by the errors of the two speeds that it is the difference of.
    """
    near = [t for t in trials if t.delta and t.inertia > 0 and abs(t.delta / regime.delta - 1) > APART]
    slope = 1.0
    if near:
        other = min(near, key=lambda trial: abs(trial.inertia - root.inertia))
        slope = abs(math.log(other.inertia / root.inertia) / math.log((other.delta or delta) / regime.delta))
    return MARGIN * slope * (abs(regime.delta / delta - 1) + 2 * regime.error / delta)


def result_of(
    first: Trial, root: Trial, regime: Regime, trials: list[Trial], carrying: float | None, delta: float
) -> RequiredInertia:
    """What a search found; ``carrying`` is the inertia that just carries a machine which stalls without more."""
    ordered = tuple(sorted(trials, key=lambda trial: trial.inertia))
    rises = [(a, b) for a, b in pairwise(ordered) if _size(b) > _size(a) * (1 + EQUAL) + NOISE]
    remarks = []
    if first.delta is None:
        text = "without a flywheel the machine stalls or runs away"
        if carrying is not None:
            text = Phrase(
                "without a flywheel the machine stalls or runs away; {carrying:.4g} kg*m^2 of constant inertia "
                "just carry "
                "it on",
                carrying=carrying,
            )
        remarks.append(text)
    for a, b in rises:
        text = (
            "delta rises from {low:.4g} at {less:.5g} kg*m^2 to {high:.4g} at {more:.5g} kg*m^2: more inertia is not "
            "always better here"
        )
        if b.delta is None:
            text = (
                "delta rises from {low:.4g} at {less:.5g} kg*m^2 to a stall at {more:.5g} kg*m^2: more inertia is not "
                "always better here"
            )
        remarks.append(Phrase(text, low=a.delta, less=a.inertia, high=b.delta or 0.0, more=b.inertia))
    return RequiredInertia(
        root.inertia,
        root.inertia - first.inertia,
        first is not root,
        regime.delta,
        regime,
        ordered,
        not rises,
        tuple(remarks),
        0.0 if first is root else _inexact(root, regime, ordered, delta),
    )


def _size(trial: Trial) -> float:
    return math.inf if trial.delta is None else trial.delta
