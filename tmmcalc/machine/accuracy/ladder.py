"""Ladders of stiffness: the program's choice beside the textbook's fixed step, from soft to stiff.

    stiffness of the shafts   the first shaft from 1e3 to 1e9 N*m/rad, the others in proportion, all with the damping
                              ratios that they have
    lag of the motor          its electromagnetic time constant from 1 s to 1e-7 s

The textbook integrates with a fixed Kutta-Merson step. Where a part of the solution is fast, that step has a limit of
stability, and the steps that it takes grow without bound along the ladder; those of an implicit method do not. The
reference of every rung is Radau IIA of order 5 of scipy, integrated apart from the program's own methods.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.measure import Clock, relative
from tmmcalc.core.studies.order import observed
from tmmcalc.core.studies.study import Ladder, Reference, Rung
from tmmcalc.core.studies.timed import STAGES
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate

STIFFNESSES = tuple(10.0**k for k in range(3, 10))  # [N*m/rad]
LAGS = tuple(10.0**-k for k in range(8))  # [s]
LONGEST = 0.2  # of the motion that is run on every rung [s]
ASKED = 0.01  # step of the textbook [s]
REFERENCE = 1e-8  # tolerance of a step of the reference, whose error is of fifth order
BUDGET = 200_000  # evaluations of the reference
INSTANTS = 48


def ladders(drive: Drive, scenario: Scenario, clock: Clock) -> Iterator[Ladder]:
    """The ladders that a drive has: of its elastic shafts, of its motor."""
    short = replace(scenario, duration=min(scenario.duration, LONGEST), until_steady=False)
    if any(shaft.stiffness != math.inf for shaft in drive.shafts):
        yield _ladder("stiffness of the shafts", "N*m/rad", _stiffened, STIFFNESSES, drive, short, clock)
    if drive.characteristic is not None:
        yield _ladder("time constant of the motor", "s", _lagging, LAGS, drive, short, clock)


def _stiffened(drive: Drive, stiffness: float) -> Drive:
    """The first elastic shaft with this stiffness, all others in proportion, damping ratios as they were."""
    first = next(shaft.stiffness for shaft in drive.shafts if shaft.stiffness != math.inf)
    factor = stiffness / first
    scaled = (
        replace(shaft, stiffness=shaft.stiffness * factor, damping=shaft.damping * math.sqrt(factor))
        for shaft in drive.shafts
    )
    return replace(drive, shafts=tuple(scaled))


def _lagging(drive: Drive, lag: float) -> Drive:
    return replace(drive, time_constant=lag)


def _ladder(
    quantity: str,
    unit: str,
    make: Callable[[Drive, float], Drive],
    values: Sequence[float],
    drive: Drive,
    scenario: Scenario,
    clock: Clock,
) -> Ladder:
    rungs = tuple(_rung(make(drive, value), value, scenario, clock, fresh=value == values[0]) for value in values)
    return Ladder(
        "transient",
        f"{quantity}, {scenario.name}",
        unit,
        scenario.duration,
        ASKED,
        Reference(f"Radau of order 5 (scipy) at a tolerance of {REFERENCE:g}", max(rung.reference for rung in rungs)),
        rungs,
        _power([*values], [rung.limit for rung in rungs]),
    )


def _power(values: list[float], limits: list[float]) -> float | None:
    """The power of the value that the limit of the step goes with, on the straightest part of the ladder."""
    falls = (limits[-1] - limits[0]) * (values[-1] - values[0]) < 0
    power = observed([1 / value for value in values] if falls else values, limits, 0.0)
    return None if power is None else -power if falls else power


def _rung(drive: Drive, value: float, scenario: Scenario, clock: Clock, fresh: bool) -> Rung:
    instants = np.linspace(0.0, scenario.duration, INSTANTS + 2)[1:-1]

    def run(method: Method) -> Transient:
        return simulate(drive, scenario, method, instants.tolist())

    found, seconds, _ = clock.median(lambda: run(Method(compared=False)), fresh)
    exact, own = _exact(run, found, instants)
    scales = found.scales
    steps = scales.steps if scales is not None else 1.0
    asked, refused = _asked(run, exact, instants)
    return Rung(
        value=value,
        fastest=scales.fastest if scales is not None else scenario.duration,
        limit=scales.stable_step if scales is not None else scenario.duration,
        steps=steps,
        textbook_evaluations=STAGES * math.ceil(steps),
        textbook_error=asked,
        textbook_fails=refused,
        method=found.method,
        rigid=bool(found.rigid),
        evaluations=found.counters["evaluations"],
        seconds=seconds,
        error=found.error if exact is None else relative(speeds(found, instants), exact),
        reference=own,
    )


def _exact(run: Callable[[Method], Transient], found: Transient, instants: Values) -> tuple[Values | None, float]:
    """The speeds of the reference and its own error; None where shafts swing too fast to be followed."""
    if found.rigid:
        return None, 0.0
    try:
        motion = run(Method("Radau", tolerance=REFERENCE, budget=BUDGET, compared=False))
    except AccuracyError:
        return None, 0.0
    return speeds(motion, instants), motion.error


def _asked(run: Callable[[Method], Transient], exact: Values | None, instants: Values) -> tuple[float | None, str]:
    """The error of the textbook's step, or why it gives no result."""
    try:
        motion = run(Method("merson", step=ASKED, compared=False))
    except AccuracyError as fault:
        return None, fault.message
    return (None if exact is None else relative(speeds(motion, instants), exact)), ""


def speeds(motion: Transient, instants: Values) -> Values:
    """Speeds (N, m) of the masses at the instants; what is at rest stays so."""
    at = np.clip(np.searchsorted(motion.t, instants), 0, len(motion.t) - 1)
    return motion.omega[:, at]
