"""What linkages keep that pass through prescribed positions, as equations; none where they are only met nearly.

    pose, path    |P_j - E_j p - A| = a,   |P_j - E_j (p - b) - D| = c, or C_j on the line of the guide
    timed         P_j - E_j p - A = a e^(i (phi_1 + tau_j)) in place of the first
    function      |a e^(i phi_j) - d - c e^(i psi_j)| = b,   |r e^(i phi_j) - s_j - i e| = l

E_j is the turn of the coupler BC from the axes, p the coupler point from B along BC. The turns are unknown but for a
body whose angles are prescribed.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import PI
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.errors import Conditions
from tmmcalc.linkage.synthesis.function import is_exact
from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.linkage.synthesis.task import FunctionTask, PoseTask, SynthesisTask


def posed(task: SynthesisTask, design: Design) -> Conditions:
    """Pivots, lengths and coupler point of a linkage through points or poses, then its turns at them."""
    asked: PoseTask = task.asked
    slides = asked.mechanism == "slider_crank"
    symbols = ("x_A", "y_A", "a", "b", "p", "q", *(("x_G", "y_G") if slides else ("c", "x_D", "y_D")))
    told = [design.size(symbol) for symbol in symbols]
    middle = complex(asked.points.mean())
    unit = max(abs(design.size(symbol)) for symbol in ("a", "b") + (() if slides else ("c",)))
    points = _wide(asked.points - middle) / unit
    shift = {"x_A": middle.real, "y_A": middle.imag, "x_D": middle.real, "y_D": middle.imag}
    shift |= {"x_G": middle.real, "y_G": middle.imag}
    lengths = [(np.longdouble(v) - shift.get(s, 0.0)) / unit for s, v in zip(symbols, told, strict=True)]
    angles = [design.size("gamma")] if slides else []
    turns = _turns(asked, design, points, lengths)
    count = len(lengths) + len(angles)
    timed = 0 if asked.timing is None else 1

    def missed(x: Real) -> Real:
        turn = _direction(x[count + timed :]) if asked.angles is None else _direction(asked.angles - x[count + timed])
        pivot, point = x[0] + 1j * x[1], x[4] + 1j * x[5]
        one, two = points - turn * point - pivot, points - turn * (point - x[3])
        first = np.abs(one) - x[2]
        if asked.timing is not None:
            gap = one - x[2] * _direction(asked.timing + x[count])
            first = np.concatenate((gap.real, gap.imag))
        if slides:
            second = ((two - x[6] - 1j * x[7]) * np.conj(_direction(x[8]))).imag
        else:
            second = np.abs(two - x[7] - 1j * x[8]) - x[6]
        return np.concatenate((first, second))

    return Conditions(missed, [*lengths, *angles, *turns], count)


def _turns(asked: PoseTask, design: Design, points: Any, lengths: list[Any]) -> list[Any]:
    """The first angle of a timed crank; the body's axis from BC, or the turns of BC at all points."""
    assert design.precision is not None
    phi = design.precision.crank
    first = [] if asked.timing is None else [phi[0]]
    if asked.angles is not None:
        return [*first, design.size("body")]
    arm = points - lengths[0] - 1j * lengths[1] - lengths[2] * _direction(phi)
    return [*first, *np.angle(arm / (lengths[4] + 1j * lengths[5]))]


def generated(task: SynthesisTask, design: Design) -> Conditions | None:
    """Lengths and free offsets of a function generator; None where the points are more than can be met."""
    asked: FunctionTask = task.asked
    if not is_exact(asked):
        return None
    slides = asked.mechanism == "slider_crank"
    unit = max(abs(design.size(symbol)) for symbol in ("rle" if slides else "abcd"))
    lengths = [np.longdouble(design.size(symbol)) / unit for symbol in ("rle" if slides else "abc")]
    starts: list[Any] = [design.size("phi_start"), np.longdouble(design.size("s_start" if slides else "psi_start"))]
    starts[1] /= unit if slides else 1
    given = [asked.input_start, asked.output_start]
    free = [k for k in (0, 1) if given[k] is None]
    fixed = [_fixed(wanted, told, k, slides, unit) for k, (wanted, told) in enumerate(zip(given, starts, strict=True))]
    inputs, outputs = (part.astype(np.longdouble) for part in (asked.inputs, asked.outputs))
    frame = np.longdouble(asked.frame) / unit

    def missed(x: Real) -> Real:
        at = list(fixed)
        for k, place in enumerate(free):
            at[place] = x[3 + k]
        pin = x[0] * _direction(inputs + at[0])
        if slides:
            return np.asarray(np.abs(pin - outputs / unit - at[1] - 1j * x[2]) - x[1])
        return np.asarray(np.abs(pin - frame - x[2] * _direction(outputs + at[1])) - x[1])

    return Conditions(missed, [*lengths, *(starts[k] for k in free)], 3 + len(free))


def _fixed(wanted: float | None, told: Any, k: int, slides: bool, unit: float) -> Any:
    """A given offset; of an angle with the half turns that a crank or rocker took up."""
    if wanted is None:
        return told
    if slides and k == 1:
        return np.longdouble(wanted) / unit
    return np.longdouble(wanted) + PI * np.rint((told - wanted) / PI)


def _direction(angle: Any) -> Any:
    return np.exp(1j * np.asarray(angle, np.longdouble))


def _wide(points: Any) -> Any:
    return points.astype(np.clongdouble)
