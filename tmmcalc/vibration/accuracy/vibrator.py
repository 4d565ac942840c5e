"""Methods for the start of the vibratory device: exact propagation of its linear equations beside methods in time.

The rotor speeds up by a given law, so that the force on the modes is known at every time and a step by e^(A h) leaves
no error but that of its polynomial. Methods in time have to follow the highest frequency of the device. The reference
is the same propagation by shorter steps, which the methods in time confirm down to their tolerances.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.core.studies.timed import Run, Start, controlled, stepped
from tmmcalc.vibration.vibrator.energies import COUNT, Excitation, excitation_of, mass_matrix, stiffness_matrix
from tmmcalc.vibration.vibrator.modes import Modes, modes_of
from tmmcalc.vibration.vibrator.runup import run_up
from tmmcalc.vibration.vibrator.springs import stiffness_of
from tmmcalc.vibration.vibrator.task import RunUp, VibratorTask

LONGEST = 0.2  # of the start [s]
INSTANTS = 16
FINER = (64, 128)  # rows between the instants, each at least a step: of what the reference is compared with, of itself
STEPS = (512, 1024, 2048, 4096)
METHODS = ("RK45", "DOP853", "LSODA")


def studies(scene: Scene) -> Iterator[Study]:
    """The coordinates in the first part of the start, while the rotor speeds up; nothing without one."""
    task: VibratorTask = scene.inputs
    if task.run_up is None or task.unbalance is None or task.speed is None:
        return
    until = min(task.run_up.duration, LONGEST, task.speed / task.run_up.acceleration)
    asked = replace(task.run_up, duration=until, rows=INSTANTS)
    stiffness = stiffness_matrix(task, stiffness_of(task))
    modes = modes_of(mass_matrix(task), stiffness, task.damping, task.rods.radius)
    excitation = excitation_of(task.unbalance)
    propagated = partial(_propagated, modes, excitation, task.speed, asked)
    coarse, exact = (propagated(rows) for rows in FINER)

    def error(found: Values) -> float:
        return max(relative(a, b) for a, b in zip(found, exact, strict=True) if np.any(b))

    def of_run(run: Run) -> float:
        return error(modes.shapes @ (run.states[:COUNT] / modes.frequency[:, None]))

    instants = until * np.arange(1, INSTANTS + 1) / INSTANTS
    start = Start(_slopes(modes, excitation, asked), np.zeros(2 * COUNT), instants, _sizes(modes, exact))
    exactly = [Way("", None, partial(propagated, 1))]
    yield Study(
        "vibrator",
        "coordinates at the start",
        Reference("exact propagation by steps ever shorter, beside steps twice as long", error(coarse)),
        (
            series("exact propagation", exactly, error, scene.clock, note="with the works of force and dampers"),
            *controlled(start, of_run, scene.clock, METHODS),
            stepped(start, STEPS, of_run, scene.clock, note="unstable where a step is long for the highest frequency"),
        ),
    )


def _propagated(modes: Modes, excitation: Excitation, speed: float, asked: RunUp, rows: int) -> Values:
    """Coordinates (7, n) at the instants, of so many rows between them."""
    return run_up(modes, excitation, speed, replace(asked, rows=INSTANTS * rows)).q[:, rows::rows]


def _sizes(modes: Modes, q: Values) -> Values:
    """Sizes (14,) of the states: of w eta, and of eta' the same."""
    eta = np.max(np.abs(np.linalg.solve(modes.shapes, q)), axis=1) * modes.frequency
    return np.tile(np.maximum(eta, float(np.max(eta)) * 1e-6), 2)


def _slopes(modes: Modes, excitation: Excitation, asked: RunUp) -> Callable[[float, Any], Values]:
    """Derivatives of (w eta, eta') while the rotor speeds up."""
    w, epsilon = modes.frequency, np.array(asked.acceleration)

    def slopes(t: float, y: Any) -> Values:
        state = np.asarray(y)
        omega = epsilon * t
        force = excitation.force(omega * t / 2, omega, epsilon, tangential=asked.tangential) @ modes.shapes
        speed = state[COUNT:]
        return np.concatenate((w * speed, force - modes.damping @ speed - w * state[:COUNT]))

    return slopes
