"""Steady regimes of a driven rotor: where the moment of the motor is what vibration and drag take at that speed.

    M_motor(w) = L(w) + d w,   L(w) = (power of the dampers)/w

A regime is stable where the motor's surplus falls with the speed. At a resonance L has a peak: a motor that cannot give
it stays below (Sommerfeld's effect), although it could keep the speed beyond.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.energies import Excitation
from tmmcalc.vibration.vibrator.forced import load_moment
from tmmcalc.vibration.vibrator.modes import Modes
from tmmcalc.vibration.vibrator.rotor import motor_moments
from tmmcalc.vibration.vibrator.task import Drive

EVEN = 600  # speeds of the search, equal steps
NEAR = 80  # speeds about every resonance
BEYOND = 1.25  # of the no-load speed, or of the highest natural frequency without one


@record
class Regime:
    """A steady regime of the rotor."""

    speed: float = quantity("omega[rad/s]", "speed of the rotor")
    moment: float = quantity("M[N*m]", "moment of the motor")
    stable: bool = quantity("stable", "the surplus of the motor falls with the speed")


@record
class Barrier:
    """The moment that a resonance asks of the motor."""

    speed: float = quantity("omega[rad/s]", "speed of the peak of the load")
    mode: int = quantity("mode", "number of the mode from 1")
    load: float = quantity("load[N*m]", "moment that vibration and drag take at the peak", symbol="L + d omega")
    motor: float = quantity("M[N*m]", "moment of the motor at the peak")


def regimes(modes: Modes, excitation: Excitation, drive: Drive) -> tuple[tuple[Regime, ...], tuple[Barrier, ...]]:
    """All steady regimes by their speed, and the peaks of the load."""
    grid = _grid(modes, drive)
    load = load_moment(modes, excitation, grid) + drive.drag * grid
    surplus = motor_moments(drive, grid) - load
    k = np.flatnonzero(np.signbit(surplus[1:]) != np.signbit(surplus[:-1]))

    def open_(omega: Values, _: np.ndarray) -> Values:
        return motor_moments(drive, omega) - load_moment(modes, excitation, omega) - drive.drag * omega

    roots = bracketed(open_, grid[k], grid[k + 1])
    found = tuple(
        Regime(float(w), float(drive.characteristic.moment(float(w))), bool(surplus[i] > 0))
        for w, i in zip(roots, k, strict=True)
    )
    return found, tuple(_barriers(modes, drive, grid, load))


def _grid(modes: Modes, drive: Drive) -> Values:
    """Speeds that are close where the load changes fast."""
    own = drive.characteristic.synchronous
    top = BEYOND * (own if own is not None else float(modes.frequency[-1]))
    parts = [np.linspace(top / EVEN, top, EVEN)]
    ratio = np.geomspace(1e-6, 0.3, NEAR // 2)
    for w in modes.frequency:
        parts.append(w * np.concatenate((1 - ratio, 1 + ratio)))
    grid = np.sort(np.concatenate(parts))
    grid = grid[(grid > 0) & (grid <= top)]
    kept: Values = grid[np.concatenate(([True], np.diff(grid) > 0))]
    return kept


def _barriers(modes: Modes, drive: Drive, grid: Values, load: Values) -> list[Barrier]:
    inner = np.flatnonzero((load[1:-1] > load[:-2]) & (load[1:-1] >= load[2:])) + 1
    listed = []
    for i in inner.tolist():
        mode = int(np.argmin(np.abs(modes.frequency - grid[i])))
        moment = float(drive.characteristic.moment(float(grid[i])))
        listed.append(Barrier(float(grid[i]), mode + 1, float(load[i]), moment))
    return listed
