"""Kinematics of planar linkages: one mechanism in, all positions with their derivatives out.

Order of the work: structure and assembly variants; the intervals where the mechanism assembles; position
0 (a number, or the dead centre before the working stroke); a dense survey of the asked range for dead points,
transmission angles and extremes; then the asked positions in one vectorised pass.

Transfer functions are per unit of the input coordinate, d/dphi_1 for a crank [1/rad]; velocities and
accelerations in time follow as v = S' omega, a = S'' omega^2 + S' eps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.core.errors import AssemblyError, SingularityError
from tmmcalc.core.notes import Phrase
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
from tmmcalc.linkage.errors import estimate, weakest_of
from tmmcalc.linkage.grid import analysed_range, positions
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.outputs import default_outputs, output_named, summarise
from tmmcalc.linkage.placing import placed
from tmmcalc.linkage.quality import assess, check_regular, grade
from tmmcalc.linkage.results import Domain, Grade, GroupQuality, Kinematics, Method, MethodName, Terms, Trace
from tmmcalc.linkage.sizes import size_grades
from tmmcalc.linkage.structure import Structure, solve_structure
from tmmcalc.linkage.survey import Survey, survey
from tmmcalc.linkage.trace import continuous, trace
from tmmcalc.linkage.variants import sketch_grades

BOOK_STEP = math.radians(1.5)  # recommended for positions with six decimals


def solve_kinematics(
    mechanism: Mechanism,
    structure: Structure | None = None,
    method: MethodName = "closed",
    step: float | None = None,
    decimals: int | None = None,
    terms: Terms | None = None,
) -> Kinematics:
    """Positions, velocities, accelerations and transfer functions of a mechanism of any class.

    ``method``, ``step`` and ``decimals`` are those of `Method`; 0 means the default step and no rounding. ``terms``
    are those that accelerations are made of, None: all.
    Raises `StructureError`, `AssemblyError`, `SingularityError`, `NoSolutionError` (exit code 3) with the
    group, the lengths and the input coordinate at fault.
    """
    structure = structure or solve_structure(mechanism)
    how = Method(method, step or None, decimals or None)
    try:
        chain, domain, start, centres = placed(mechanism, structure)
    except AssemblyError as error:
        odd = "".join(f"\n  {grade}" for grade in size_grades(mechanism))
        raise AssemblyError(
            error.message + odd, where=error.where, value=error.value, limit=error.limit, remedy=error.remedy
        ) from None
    chain = chain if terms is None else replace(chain, terms=terms)
    signs = {each.group.name: each.variant for each in chain.steps}
    branches = chain.branches
    sketched_at = start if mechanism.assembly.at is None else mechanism.assembly.at
    dense, qualities = _surveyed(chain, domain, start)
    outputs = default_outputs(chain)
    summaries = tuple(
        summarise(chain, output, dense, start, centres if output is outputs[0] else None) for output in outputs
    )
    phi, labels = positions(mechanism, summaries, start)
    x = start + phi
    evaluate = _evaluation(chain, how)
    values = _tracked(chain, x, evaluate(x), dense)
    s, ds, dds = _displacements(chain, outputs, values)
    for array in (phi, x, s, ds, dds, *(v for v in vars(values).values() if isinstance(v, np.ndarray))):
        array.flags.writeable = False  # a result is frozen, its arrays with it
    return Kinematics(
        structure=structure,
        variants=signs,
        branches=branches,
        input_joint=mechanism.input.joint,
        turns=chain.turns,
        speed=mechanism.input.speed,
        acceleration=mechanism.input.acceleration,
        crank_length=crank_length(chain),
        frame_points={name: (at.real, at.imag) for name, at in mechanism.frame.points.items()},
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
            *_speed_grades(mechanism, chain.turns),
            *size_grades(mechanism),
            *sketch_grades(mechanism, structure, signs, branches, sketched_at),
            *grade(chain, qualities),
            *_method_grades(chain, how, dense.x),
        ),
        method=how,
        error=estimate(chain, x, evaluate, weakest_of(qualities), None if centres is None else start),
        counters={"positions": len(x), "survey_positions": len(dense.x), "groups": len(chain.steps)},
        terms=terms,
    )


def _speed_grades(mechanism: Mechanism, turns: bool) -> Iterator[Grade]:
    """What rates are without a speed of the input."""
    if not mechanism.input.given:
        unit = "rad/s" if turns else "m/s"
        told = Phrase("speed is not given: velocities and accelerations are those at 1 {unit}", unit=unit)
        yield Grade("note", "[mechanism.input]", told)


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
        step = method.step or default_step(chain)
        unit = crank_length(chain) or 1.0
        return partial(differentiate, chain, step=step, decimals=method.decimals, unit=unit)
    if method.name == "splitting":
        from tmmcalc.linkage.loops.splitstep import split_chain

        return partial(trace, split_chain(chain))
    return partial(trace, chain, method=solvers.projection if method.name == "projection" else solvers.closed)


def default_step(chain: Chain) -> float:
    """The step of differences that nobody told: 1.5 degrees, or 1/240 of a slider's range."""
    return BOOK_STEP if chain.turns else (chain.mechanism.grid.span or 1.0) / 240


def _method_grades(chain: Chain, method: Method, x: Real) -> tuple[Grade, ...]:
    """What the method has to tell of the way it took."""
    higher = [step.group.name for step in chain.steps if not step.group.kind]
    if method.name == "projection" and higher:
        message = "the equations of its loops are projected on two axes in every method: only dyads differ by this one"
        return tuple(Grade("note", Phrase("kinematics, group {name}", name=name), message) for name in higher)
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


def step_study(
    mechanism: Mechanism, result: Kinematics, decimals: int = 6, output: str | None = None
) -> list[StepError]:
    """Error of central differences of an output, the first by default, against their step (textbook 2.4, 2.9).

    Lengths are in units of the crank length; positions are rounded to ``decimals`` and, beside that, taken in
    double precision. The steps are those of the textbook's range, as parts of a turn or of the range. Raises
    what `output_named` does.
    """
    chain = chain_of(mechanism, result)
    told = output_named(chain, output, "kinematics, --study")
    unit = result.crank_length or 1.0
    scale = 1.0 if told.link is not None else unit
    per_degree = math.radians(1.0) if result.turns else float(np.ptp(result.x)) / 360

    def error(step: float, digits: int | None) -> DifferenceError:
        _, ds, dds = output_row(told, differentiate(chain, result.x, step, digits, unit))
        return difference_error((exact[1], exact[2]), (ds, dds), scale)

    exact = output_row(told, trace(chain, result.x))
    steps = [degrees * per_degree for degrees in STEPS_DEG]
    return [StepError(step, error(step, decimals), error(step, None)) for step in steps]
