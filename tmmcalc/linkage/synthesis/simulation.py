"""The post-check of every synthesis: the mechanism is simulated by the kinematics room, not by the formulas used.

Dead centres are roots of the output's rate, pressure angles are refined extremes of the rod's tilt against the guide:
the signed sine sin(nu) = Im(u_rod / e_guide), whose stationary values lie one on each stroke.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.extrema import around, refine, turning
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.synthesis.results import Check
from tmmcalc.linkage.synthesis.strokes import TURN

SAMPLES = 720  # of the tilt over a turn


@record
class Tilt:
    """The rod against the guide on one stroke [rad]: its stationary signed angles, and the largest size of all."""

    stationary: tuple[float, ...]
    largest: float


@record
class Simulation:
    """A simulated mechanism: stroke, time ratio and dead centres of its first output."""

    result: Kinematics
    chain: Chain
    stroke: float
    time_ratio: float
    first: float  # crank angle of the dead centre before the working stroke [rad]
    working: float  # crank angle of the working stroke [rad]


def simulate(mechanism: Mechanism) -> Simulation:
    """Solve the mechanism, which has an output with two dead centres; raises `NoSolutionError` if it has not."""
    result = solve_kinematics(mechanism)
    summary = result.summaries[0]
    if summary.stroke is None or summary.time_ratio is None or summary.working_angle is None:
        raise NoSolutionError(
            f"the output of the mechanism found has {len(summary.dead_centres)} dead centres, not two",
            where="synthesis, post-check",
            remedy="change the sizes asked for",
        )
    chain = chain_of(mechanism, result)
    first = summary.dead_centres[0].x
    return Simulation(result, chain, summary.stroke, summary.time_ratio, first, summary.working_angle)


def tilts(simulation: Simulation, rod: int, guide: complex) -> tuple[Tilt, Tilt]:
    """The tilt of link ``rod`` against the direction ``guide`` on the working and on the idle stroke."""

    def tilt(x: Real) -> Real:
        turned = simulation.chain.evaluate(x, order=0).motions[rod].u * np.conj(guide)
        return np.broadcast_to(np.asarray(turned.imag), x.shape)

    x = simulation.first + TURN * (np.arange(SAMPLES + 1) + 0.5) / SAMPLES
    values = tilt(x)
    rows = np.concatenate([turning(values[:-1], sign, True) for sign in (1, -1)])
    at, extremes = refine(lambda x, which: tilt(x), *around(x, rows, True))
    along = np.mod((at - simulation.first) * math.copysign(1.0, simulation.result.speed), TURN)
    ends = np.abs(tilt(np.array([centre.x for centre in simulation.result.summaries[0].dead_centres])))
    working = along < simulation.working
    return _tilt(extremes[working], ends), _tilt(extremes[~working], ends)


def _tilt(extremes: Real, ends: Real) -> Tilt:
    largest = float(np.max(np.abs(np.concatenate((extremes, ends)))))
    return Tilt(tuple(math.asin(s) for s in np.clip(extremes, -1, 1)), math.asin(min(largest, 1.0)))


def check(name: str, achieved: float, unit: str, target: float | None = None) -> Check:
    """A check with its residual, relative to the target unless that is zero.

    >>> check("K", 1.25, "-", 1.0).residual
    0.25
    """
    residual = None if target is None else abs(achieved - target) / (abs(target) or 1.0)
    return Check(name, achieved, unit, target, residual)
