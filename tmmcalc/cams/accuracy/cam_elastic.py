"""Methods for the vibration of the follower on an elastic train: exact on panels, harmonics of the lift, steps in time.

    panels         the response to the law itself between its jumps, by Gauss's rule to rounding
    harmonics      of n positions of the turn: each through its amplification, as the theory of vibration has it
    trapezoid      z' and z by the trapezoid rule (Newmark's method of constant mean acceleration), the periodic
                   start from one turn more, since a turn is an affine map

The reference takes each panel in halves in extended precision. What is compared is the stretch at its edges.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.accuracy.sides import beside
from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import TURN, Program
from tmmcalc.cams.response import Response, kicks_of, steady
from tmmcalc.cams.speed import Speed, constant_speed
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study

POSITIONS = (90, 180, 360, 720, 1440, 2880, 5760)  # of a turn
JUMPS = "of order 2 where the acceleration jumps at positions alone; of order 1 where it does between them"


def studies(scene: Scene) -> Iterator[Study]:
    """The steady vibration of a cam that turns evenly."""
    task: CamTask = scene.inputs.at_speed(scene.results.get("motion"))
    result: ElasticResult = scene.results["cam_elastic"]
    if task.turning is not None or not WIDER:
        return
    omega = loads_of(task, "cam_elastic").speed
    problem = _Problem(task.program, omega, result.frequency, result.damping)
    exact = problem.exact()

    def error(found: Values) -> float:
        return relative(found, exact)

    rows = [
        ("harmonics of n positions", problem.by_harmonics, JUMPS),
        ("trapezoid rule", problem.by_trapezoid, JUMPS),
    ]
    yield Study(
        "cam_elastic",
        "stretch of the train",
        Reference("panels cut in half, in extended precision (64-bit mantissa)", result.error["residual"]),
        (
            series("exact on panels", [Way("", None, problem.stretch)], error, scene.clock),
            *(
                series(name, [Way(f"{n} positions", 1 / n, partial(solve, n)) for n in POSITIONS], error, scene.clock,
                       expected=2.0, note=note)
                for name, solve, note in rows
            ),
        ),
    )  # fmt: skip


class _Problem:
    """z'' + 2 zeta w z' + w^2 z = -y'' in time; stretches (K + 1,) at the edges of the panels."""

    def __init__(self, program: Program, omega: float, frequency: float, damping: float) -> None:
        self.program, self.omega, self.frequency, self.damping = program, omega, frequency, damping
        self.edges = self.course().panels.edges

    @property
    def speed(self) -> Speed:
        return constant_speed(self.omega)

    def course(self) -> Response:
        return steady(self.program, self.speed, self.frequency, self.damping)

    def stretch(self) -> Values:
        """By the program."""
        q = self.course().edges
        return q.imag / (self.frequency * sqrt(1 - self.damping**2))

    def exact(self) -> Values:
        """By the same chain of panels, each in halves and all in extended precision."""
        zeta, w = np.longdouble(self.damping), np.longdouble(self.frequency)
        free = w * np.sqrt(1 - zeta * zeta)
        rate = -zeta * w + np.clongdouble(1j) * free
        edges = wide(self.edges)
        middles = (edges[1:] + edges[:-1]) / 2
        halves = Panels(np.sort(np.concatenate((edges, middles))), self.course().panels.order)
        ratio, kicks = kicks_of(self.program.wider, self.speed, halves, rate)
        q = _chained(ratio, kicks, np.clongdouble(0))
        q = _chained(ratio, kicks, q[-1] / (1 - np.prod(ratio)))
        found: Values = q[::2].imag / free
        return found

    def given(self, count: int) -> Values:
        """y'' in time (n,) at n positions; at a jump the mean of both limits."""
        phi = TURN * np.arange(count) / count
        both = [self.program.at(at, piece)[2] for at, piece in beside(self.program, phi)]
        return np.asarray((both[0] + both[1]) / 2 * self.omega**2)

    def by_harmonics(self, count: int) -> Values:
        """Each harmonic of y'' through its amplification."""
        c = np.fft.fft(self.given(count)) / count
        order = np.fft.fftfreq(count, 1 / count)
        w, zeta = self.frequency, self.damping
        turning = order * self.omega
        amplitude = -c / (w * w - turning**2 + 2j * zeta * w * turning)
        amplitude = np.where(2 * np.abs(order) < count, amplitude, 0.0)
        spread = np.fft.ifft(amplitude) * count
        return self._between(count, spread.real)

    def by_trapezoid(self, count: int) -> Values:
        """(z, z') of the next position from that of this one and y'' of both."""
        given = self.given(count)
        h, w, zeta = TURN / self.omega / count, self.frequency, self.damping
        system = np.array([[0.0, 1.0], [-w * w, -2 * zeta * w]])
        left = np.linalg.inv(np.eye(2) - h / 2 * system)
        whole = left @ (np.eye(2) + h / 2 * system)
        kick = left @ np.array([0.0, -h / 2])
        pushes = np.outer(given + np.roll(given, -1), kick)
        states = _turned(whole, pushes, np.zeros(2))
        begun = np.linalg.solve(np.eye(2) - np.linalg.matrix_power(whole, count), states[-1])
        return self._between(count, _turned(whole, pushes, begun)[:-1, 0])

    def _between(self, count: int, z: Values) -> Values:
        """At the edges of the panels, by parabolas through the three nearest positions."""
        at = self.edges / TURN * count
        k = np.rint(at).astype(int)
        s = at - k
        low, here, high = (z[(k + side) % count] for side in (-1, 0, 1))
        return np.asarray(here + s * (high - low) / 2 + s * s * (high - 2 * here + low) / 2)


def _chained(ratio: NDArray[np.complexfloating], kicks: NDArray[np.complexfloating], q: np.clongdouble) -> Values:
    found = [q]
    for factor, kick in zip(ratio, kicks, strict=True):
        found.append(factor * found[-1] + kick)
    return np.array(found)


def _turned(whole: Values, pushes: Values, state: Values) -> Values:
    """States (n + 1, 2) over the turn."""
    found = [state]
    for push in pushes:
        found.append(whole @ found[-1] + push)
    return np.array(found)
