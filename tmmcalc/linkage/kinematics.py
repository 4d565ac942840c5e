"""Kinematics of planar linkages: one mechanism in, all positions with their derivatives out.

Order of the work: structure and assembly variants; the intervals where the mechanism assembles; position
0 (a number, or the dead centre before the working stroke); a dense survey of the asked range for dead points,
transmission angles and extremes; then the asked positions in one vectorised pass.

Transfer functions are per unit of the input coordinate, d/dphi_1 for a crank [1/rad]; velocities and
accelerations in time follow as v = S' omega, a = S'' omega^2 + S' eps.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.core.errors import NoSolutionError, SingularityError
from tmmcalc.core.plane import Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.assembly import check_range, coordinate
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.differentiation import (
    STEPS_DEG,
    DifferenceError,
    StepError,
    difference_error,
    differentiate,
)
from tmmcalc.linkage.errors import estimate
from tmmcalc.linkage.grid import analysed_range, positions
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.outputs import default_outputs, summarise
from tmmcalc.linkage.placing import placed
from tmmcalc.linkage.quality import assess, check_regular, grade
from tmmcalc.linkage.results import Domain, Grade, GroupQuality, Kinematics, Method, Trace
from tmmcalc.linkage.structure import Structure, solve_structure
from tmmcalc.linkage.survey import Survey, survey
from tmmcalc.linkage.trace import continuous, trace
from tmmcalc.linkage.variants import sketch_grades

BOOK_STEP = math.radians(1.5)  # recommended for positions with six decimals


def solve_kinematics(
    mechanism: Mechanism, structure: Structure | None = None, method: Method | None = None
) -> Kinematics:
    """Positions, velocities, accelerations and transfer functions of a mechanism of any class.

    Raises `StructureError`, `AssemblyError`, `SingularityError`, `NoSolutionError` (exit code 3) with the
    group, the lengths and the input coordinate at fault.
    """
    structure = structure or solve_structure(mechanism)
    method = method or Method()
    chain, domain, start = placed(mechanism, structure)
    signs = {step.group.name: step.variant for step in chain.steps}
    branches = chain.branches
    sketched_at = start if mechanism.assembly.at is None else mechanism.assembly.at
    dense, qualities = _surveyed(chain, domain, start)
    outputs = default_outputs(chain)
    summaries = tuple(summarise(chain, output, dense, start) for output in outputs)
    phi, labels = positions(mechanism, summaries[0] if summaries else None, start)
    x = start + phi
    evaluate = _evaluation(chain, method)
    values = _tracked(chain, x, evaluate(x), dense)
    s, ds, dds = _displacements(chain, outputs, values)
    _freeze(phi, x, s, ds, dds, *(v for v in vars(values).values() if isinstance(v, np.ndarray)))
    return Kinematics(
        structure=structure,
        variants=signs,
        branches=branches,
        input_joint=mechanism.input.joint,
        turns=chain.turns,
        speed=mechanism.input.speed,
        acceleration=mechanism.input.acceleration,
        crank_length=crank_length(chain),
        labels=labels,
        phi=phi,
        x=x,
        trace=values,
        outputs=tuple(output.name for output in outputs),
        angular=tuple(output.link is not None for output in outputs),
        s=s,
        ds=ds,
        dds=dds,
        domain=domain,
        summaries=summaries,
        qualities=qualities,
        grades=(
            *sketch_grades(mechanism, structure, signs, branches, sketched_at),
            *grade(chain, qualities),
            *_method_grades(chain, method, dense.x),
        ),
        method=method,
        error=estimate(chain, x, evaluate, [q.regularity_at for q in qualities if q.regularity_at is not None]),
        counters={"positions": len(x), "survey_positions": len(dense.x), "groups": len(chain.steps)},
    )


def _surveyed(chain: Chain, domain: Domain, start: float) -> tuple[Survey, tuple[GroupQuality, ...]]:
    """The asked range densely, and the quality of the groups over it; raises where it does not pass regularly."""
    low, high = analysed_range(chain.mechanism, start)
    check_range(chain, domain, low, high)
    dense = survey(chain, low, high, start)
    qualities = assess(chain, dense, start)
    check_regular(chain, qualities)
    return dense, qualities


def crank_length(chain: Chain) -> float | None:
    """Distance l_1 [m] from the crank's pivot to its first other joint; None for a driven slider."""
    if not chain.turns:
        return None
    k = chain.structure.input_link
    pins = {joint.name: joint.points[joint.links.index(k)] for joint in chain.mechanism.joints if k in joint.links}
    pivot = pins.pop(chain.input_joint.name)
    return next((abs(pin - pivot) for pin in pins.values() if pin != pivot), None)


def _evaluation(chain: Chain, method: Method) -> Callable[[Real], Trace]:
    """The function that gives the motion at input coordinates (n,) by a method."""
    if method.name == "differences":
        step = method.step or (BOOK_STEP if chain.turns else (chain.mechanism.grid.span or 1.0) / 240)
        unit = crank_length(chain) or 1.0
        return partial(differentiate, chain, step=step, decimals=method.decimals, unit=unit)
    if method.name == "splitting":
        from tmmcalc.linkage.loops.splitstep import split_chain

        return partial(trace, split_chain(chain))
    return partial(trace, chain, method=solvers.projection if method.name == "projection" else solvers.closed)


def _method_grades(chain: Chain, method: Method, x: Real) -> tuple[Grade, ...]:
    """What the method has to tell of the way it took."""
    if method.name != "splitting":
        return ()
    from tmmcalc.linkage.loops.signchanges import split_grades

    return split_grades(chain, x)


def _tracked(chain: Chain, x: Real, values: Trace, dense: Survey) -> Trace:
    """The values at x with continuous angles.

    Nothing that is not a number leaves the stage, whatever the method did beside the asked range.
    """
    stacks = (values.ddr, values.ddangle, values.dds)
    broken = np.any([np.any(~np.isfinite(stack), axis=0) for stack in stacks], axis=0)
    if broken.any():
        raise SingularityError(
            f"no velocities at {coordinate(chain, float(x[broken][0]))}: a position beside it does not assemble",
            where="kinematics",
            remedy="use a smaller step of the differences, or a range that keeps clear of the limit position",
        )
    return replace(values, angle=continuous(values.angle, x, *dense.link_angles()))


def _freeze(*arrays: np.ndarray) -> None:
    """A result is frozen, its arrays with it."""
    for array in arrays:
        array.flags.writeable = False


def _displacements(chain: Chain, outputs: tuple[Output, ...], values: Trace) -> tuple[Real, Real, Real]:
    """Displacement from position 0 and its transfer functions, each (O, n)."""
    n = values.r.shape[1]
    rows = np.array([output_row(output, values) for output in outputs]).reshape(len(outputs), 3, n)
    s, ds, dds = rows[:, 0], rows[:, 1], rows[:, 2]
    return s - s[:, :1], ds, dds


def output_row(output: Output, values: Trace) -> tuple[Real, Real, Real]:
    """Coordinate of an output and its transfer functions, each (n,)."""
    if output.link is not None:
        k = values.link_ids.index(output.link)
        return values.angle[k], values.dangle[k], values.ddangle[k]
    if output.joint is not None:
        k = values.joint_names.index(output.joint)
        return values.s[k], values.ds[k], values.dds[k]
    k = values.point_names.index(output.point or "")
    turn = np.exp(-1j * output.direction) if output.direction else 1.0
    return (values.r[k] * turn).real, (values.dr[k] * turn).real, (values.ddr[k] * turn).real


def step_study(mechanism: Mechanism, result: Kinematics, decimals: int = 6) -> list[StepError]:
    """Error of central differences of the first output against their step (textbook 2.4, 2.9).

    Lengths are in units of the crank length; positions are rounded to ``decimals`` and, beside that, taken in
    double precision. The steps are those of the textbook's range, as parts of a turn or of the range. Raises
    `NoSolutionError` if the mechanism has no output.
    """
    chain = chain_of(mechanism, result)
    if not result.outputs:
        raise NoSolutionError(
            "there is no output whose differences could be studied",
            where="kinematics, --study",
            remedy="name one in [[mechanism.outputs]]",
        )
    output = default_outputs(chain)[0]
    unit = result.crank_length or 1.0
    scale = 1.0 if output.link is not None else unit
    per_degree = math.radians(1.0) if result.turns else float(np.ptp(result.x)) / 360

    def error(step: float, digits: int | None) -> DifferenceError:
        _, ds, dds = output_row(output, differentiate(chain, result.x, step, digits, unit))
        return difference_error((exact[1], exact[2]), (ds, dds), scale)

    exact = output_row(output, trace(chain, result.x))
    steps = [degrees * per_degree for degrees in STEPS_DEG]
    return [StepError(step, error(step, decimals), error(step, None)) for step in steps]
