"""A function generator as a mechanism: its simulation over the range, its errors at the points and between them."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.errors import TmmError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid, Mechanism, Output
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.synthesis.builders import FourBar, Operation, SliderCrank, four_bar, slider_crank
from tmmcalc.linkage.synthesis.designs import SPEED, remarks
from tmmcalc.linkage.synthesis.freudenstein import Closure, exact_points
from tmmcalc.linkage.synthesis.functionfit import LONG, MET, POOR, Fitted, difference
from tmmcalc.linkage.synthesis.planar import grashof
from tmmcalc.linkage.synthesis.ready import ready_spec
from tmmcalc.linkage.synthesis.results import STRUCTURAL_ERROR, TRANSMISSION, Design, Precision, Size
from tmmcalc.linkage.synthesis.simulation import check
from tmmcalc.linkage.synthesis.task import FunctionTask, SynthesisTask


def design_of(task: SynthesisTask, closure: Closure, fitted: Fitted, k: int) -> Design | None:
    """The design of a candidate; None if its mechanism does not run through the range."""
    asked: FunctionTask = task.asked
    u, v = fitted.offsets[k].tolist()
    mechanism = _mechanism(task, closure, fitted, k)
    try:
        result = solve_kinematics(mechanism)
    except TmmError:
        return None
    x, wanted = asked.inputs + u, (closure.outputs + v) * closure.unit
    found = _outputs(closure, mechanism, result, x)
    off = difference(closure, found, wanted)
    fine = closure.fine[0] + u
    error = difference(closure, _outputs(closure, mechanism, result, fine), (closure.fine[1] + v) * closure.unit)
    precision = Precision(
        unit="m" if closure.slides else "rad",
        sense=_sense(asked),
        crank=x,
        wanted=wanted,
        found=wanted + off,
        points=np.zeros(0, complex),
        reached=np.zeros(0, complex),
        angle_errors=np.zeros(0),
        fine=fine,
        error=error,
    )
    transmission = result.qualities[0].transmission or 0.0
    sizes = _sizes(closure, fitted, k)
    told, factor = structural_error(closure), 1.0 if closure.slides else math.degrees(1.0)
    merits = {
        told.marked("max").key: factor * float(np.max(np.abs(error))),
        told.marked("rms").key: factor * float(np.sqrt(np.mean(error**2))),
        TRANSMISSION.key: math.degrees(transmission),
    }
    checks = (
        check("largest error at the points", float(np.max(np.abs(off))), "m" if closure.slides else "rad"),
        check("largest error over the range", float(np.max(np.abs(error))), "m" if closure.slides else "rad"),
    )
    name = "slider-crank" if closure.slides else _type(fitted, k)
    text = ready_spec(mechanism, task.title or f"function generator, {name}", tuple(remarks(sizes)))
    met = float(np.max(np.abs(off))) / closure.unit <= MET or len(asked.inputs) > exact_points(closure)
    return Design(name, sizes, checks, merits, tuple(_defects(task, transmission, sizes, met)), text, None, precision)


def structural_error(closure: Closure) -> Quantity:
    """The figure of merit of a function generator."""
    return STRUCTURAL_ERROR.of(unit="m" if closure.slides else "deg")


def _sense(asked: FunctionTask) -> int:
    """Sense of the crank while x grows."""
    return 1 if asked.inputs[-1] >= asked.inputs[0] else -1


def _type(fitted: Fitted, k: int) -> str:
    return f"four-bar, {grashof(fitted.sizes[k][:, None])[0]}"


def _mechanism(task: SynthesisTask, closure: Closure, fitted: Fitted, k: int) -> Mechanism:
    """Over the range of the crank alone, in the sense in which x grows, with the points among the positions."""
    asked: FunctionTask = task.asked
    a, b, c, d = (fitted.sizes[k] * closure.unit).tolist()
    u, sign = float(fitted.offsets[k, 0]), int(fitted.sign[k])
    low, high = asked.span
    sense = _sense(asked)
    start = u + (low if sense > 0 else high)
    ways = np.minimum(np.sort(sense * (asked.inputs + u - start)), high - low)
    extra = tuple(float(along) for along in ways if along > 0)
    speed = sense * abs(task.crank_speed or SPEED)
    outputs = (Output("C"),) if closure.slides else (Output(link=3),)
    scene = Operation(speed, start, Grid(task.positions, span=high - low, extra=extra), outputs)
    if closure.slides:
        return slider_crank(SliderCrank(0j, a, b, 1j * c, variant=sign), scene)
    return four_bar(FourBar(0j, a, b, c, complex(d), variant=-sign), scene)


def _outputs(closure: Closure, mechanism: Mechanism, result: Kinematics, x: Real) -> Real:
    """The output (n,) of the simulated mechanism at crank angles (n,)."""
    motions = chain_of(mechanism, result).evaluate(x, order=0).motions
    if closure.slides:
        return np.asarray(motions[3].point(0j).r.real)
    return np.angle(np.asarray(motions[3].u))


def _sizes(closure: Closure, fitted: Fitted, k: int) -> tuple[Size, ...]:
    a, b, c, d = (fitted.sizes[k] * closure.unit).tolist()
    u, v = fitted.offsets[k].tolist()
    start = math.remainder(u, 2 * math.pi)
    if closure.slides:
        return (
            Size("r", a, "m", "crank AB"),
            Size("l", b, "m", "connecting rod BC"),
            Size("e", c, "m", "offset of the guide"),
            Size("phi_start", start, "rad", "crank where x begins"),
            Size("s_start", v * closure.unit, "m", "slider where x begins, by the function"),
        )
    return (
        Size("a", a, "m", "crank AB"),
        Size("b", b, "m", "coupler BC"),
        Size("c", c, "m", "rocker DC"),
        Size("d", d, "m", "frame AD"),
        Size("phi_start", start, "rad", "crank where x begins"),
        Size("psi_start", math.remainder(v, 2 * math.pi), "rad", "rocker where x begins, by the function"),
    )


def _defects(task: SynthesisTask, transmission: float, sizes: tuple[Size, ...], met: bool) -> Iterator[str]:
    if not met:
        yield "branch: the points belong to both variants of the dyad"
    least = task.transmission or POOR
    if transmission < least:
        found, limit = math.degrees(transmission), math.degrees(least)
        yield Phrase(
            "transmission: the least angle is {found:.4g} deg, below {limit:.4g} deg", found=found, limit=limit
        )
    lengths = [abs(size.value) for size in sizes if size.symbol in "abcdrl"]
    if max(lengths) > LONG * min(lengths):
        yield Phrase("sizes: the longest link has {ratio:.3g} times the shortest", ratio=max(lengths) / min(lengths))
