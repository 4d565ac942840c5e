"""Unsteady motion of a mechanism: the law of its input in time, and what follows from it at all links.

A quantity f of the configuration moves with f' v and f'' v^2 + f' a, where f' and f'' are its transfer functions, v and
a speed and acceleration of the input. They are exact, and so are the one-sided limits where the acceleration jumps.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.timelaw import TimeLaw, by_duration, by_travel, by_travel_and_duration, motion
from tmmcalc.core.timerows import TimedExtreme, extremes, time_rows
from tmmcalc.linkage.assembly import check_range
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.errors import estimate
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.outputs import coordinate_of, default_outputs
from tmmcalc.linkage.quality import assess, check_regular, grade
from tmmcalc.linkage.results import Grade, Kinematics, Trace
from tmmcalc.linkage.survey import Survey, survey
from tmmcalc.linkage.trace import continuous, trace
from tmmcalc.linkage.unsteady.ends import WHERE, Ends, find_ends
from tmmcalc.linkage.unsteady.errors import with_law
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask


def solve_unsteady(mechanism: Mechanism, task: UnsteadyTask, kinematics: Kinematics | None = None) -> Unsteady:
    """The motion of a mechanism whose input goes from rest to rest by the time-optimal law (textbook 2.10).

    Variants and position 0 are those of ``kinematics``, by default of the mechanism's own grid. Raises what
    `solve_kinematics` does, and `NoSolutionError` for ends or times that cannot be kept.
    """
    kinematics = kinematics or solve_kinematics(mechanism)
    chain = chain_of(mechanism, kinematics)
    ends = find_ends(chain, kinematics.domain, task, float(kinematics.x[0]))
    law = law_of(task, ends)
    start, end = ends.start, ends.start + law.travel
    low, high = min(start, end), max(start, end)
    check_range(chain, kinematics.domain, low, high)
    dense, grades = (None, ()) if low == high else _surveyed(chain, low, high, start)
    rows = time_rows(law.duration, task.steps, law.instants)
    s, v, a = motion(law, rows.t, rows.side)
    x = start + s
    found = trace(chain, x)
    found = found if dense is None else replace(found, angle=continuous(found.angle, x, *dense.link_angles()))
    outputs = default_outputs(chain)
    moved = _in_time(found, v, a)
    return Unsteady(
        law=law,
        input_link=chain.structure.input_link or None,
        input_joint=mechanism.input.joint,
        turns=chain.turns,
        start=start,
        end=end,
        labels=rows.labels,
        t=rows.t,
        side=rows.side,
        drive=np.stack((x, v, a)),
        trace=moved,
        outputs=tuple(output.name for output in outputs),
        angular=tuple(output.link is not None for output in outputs),
        coordinate=_coordinates(chain, outputs, x, moved, v, a),
        extremes=_extremes(chain, outputs, law, start, moved),
        grades=grades,
        error=with_law(estimate(chain, x, lambda at: trace(chain, at)), law, start, found, moved),
        counters={"rows": len(x), "survey_positions": 0 if dense is None else len(dense.x)},
    )


def law_of(task: UnsteadyTask, ends: Ends) -> TimeLaw:
    """The law for the travel, for the duration, or for both; raises `UsageError` if a limit is lacking."""
    travel = None if ends.end is None else ends.end - ends.start
    if travel is not None and task.duration is not None:
        return by_travel_and_duration(travel, task.duration, task.acceleration, task.speed)
    if task.speed is None:
        lacking = "the largest speed is needed, unless travel and duration are both given"
        raise UsageError(lacking, where=WHERE, remedy="give speed")
    if travel is not None:
        return by_travel(travel, task.speed, task.acceleration)
    if task.duration is None:
        raise UsageError("neither an end nor a duration is given", where=WHERE, remedy="give end, travel or duration")
    return by_duration(task.duration, task.speed, task.acceleration, task.sense or 1)


def _surveyed(chain: Chain, low: float, high: float, start: float) -> tuple[Survey, tuple[Grade, ...]]:
    """The range of the motion densely, and what is to be told of its weak places; a dead point is an error."""
    dense = survey(chain, low, high, start)
    qualities = assess(chain, dense, start)
    check_regular(chain, qualities)
    return dense, grade(chain, qualities)


def _in_time(found: Trace, v: Real, a: Real) -> Trace:
    """The motion in time from transfer functions, at speeds v (n,) and accelerations a (n,) of the input."""
    square = v * v
    return replace(
        found,
        dr=found.dr * v,
        ddr=found.ddr * square + found.dr * a,
        dangle=found.dangle * v,
        ddangle=found.ddangle * square + found.dangle * a,
        ds=found.ds * v,
        dds=found.dds * square + found.ds * a,
    )


def _coordinates(chain: Chain, outputs: tuple[Output, ...], x: Real, moved: Trace, v: Real, a: Real) -> Real:
    """Output coordinates and their derivatives by the time, (3, O, n)."""
    rows = np.empty((3, len(outputs), len(x)))
    configuration = chain.evaluate(x)
    for k, output in enumerate(outputs):
        value, rate, rate2 = coordinate_of(chain, output, configuration)
        rows[0, k] = value if output.link is None else moved.angle[moved.link_ids.index(output.link)]
        rows[1, k], rows[2, k] = rate * v, rate2 * v * v + rate * a
    return rows


def _extremes(
    chain: Chain, outputs: tuple[Output, ...], law: TimeLaw, start: float, rows: Trace
) -> tuple[TimedExtreme, ...]:
    """Extremes of the speeds and accelerations of input, outputs, links, points and slides over the motion.

    The motion at its ``rows`` gives the sizes beside which the rounding of a link that only translates is none.
    """

    def rates(t: Real) -> Real:
        s, v, a = motion(law, t)
        moved = _in_time(trace(chain, start + s), v, a)
        own = _coordinates(chain, outputs, start + s, moved, v, a)
        return _rows(v, a, own, moved)

    names = _names(chain, outputs)
    sizes = _sizes(rows)
    return extremes(rates, law.duration, law.instants, names, np.array([sizes[unit] for _, unit in names]))


def _sizes(rows: Trace) -> dict[str, float]:
    """The largest speeds and accelerations by their units, lengths and angles brought together by the points' reach."""

    def largest(values: Real | Plane) -> float:
        return float(np.max(np.abs(values), initial=0.0))

    reach = largest(rows.r - rows.r[:, :1]) + largest(rows.r - rows.r[:1])
    found = {}
    for per, turning, moving in (("s", rows.dangle, (rows.dr, rows.ds)), ("s^2", rows.ddangle, (rows.ddr, rows.dds))):
        along = max(largest(values) for values in moving)
        found[f"rad/{per}"] = max(largest(turning), along / reach if reach else 0.0)
        found[f"m/{per}"] = max(along, largest(turning) * reach)
    return found


def _rows(v: Real, a: Real, own: Real, moved: Trace) -> Real:
    """Speeds and accelerations (F, n) in the order of `_names`."""
    pairs: list[tuple[Real | Plane, Real | Plane]] = [
        (v, a),
        *zip(own[1], own[2], strict=True),
        *zip(moved.dangle, moved.ddangle, strict=True),
        *zip(np.abs(moved.dr), np.abs(moved.ddr), strict=True),
        *zip(moved.ds, moved.dds, strict=True),
    ]
    return np.array([row for pair in pairs for row in pair])


def _names(chain: Chain, outputs: tuple[Output, ...]) -> list[tuple[str, str]]:
    what, turning, sliding = chain.layout, ("rad/s", "rad/s^2"), ("m/s", "m/s^2")
    named = [
        (("v", "a"), turning if chain.turns else sliding),
        *(((f"vS_{o.name}", f"aS_{o.name}"), sliding if o.link is None else turning) for o in outputs),
        *(((f"omega_{link}", f"eps_{link}"), turning) for link in what.links),
        *(((f"speed_{name}", f"acceleration_{name}"), sliding) for name, _, _ in what.points),
        *(((f"v_{joint}", f"a_{joint}"), sliding) for joint in what.joints),
    ]
    return [pair for names, units in named for pair in zip(names, units, strict=True)]
