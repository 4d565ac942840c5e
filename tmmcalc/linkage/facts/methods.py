"""Numerical differentiation beside exact derivatives: the comparison by position, the study of the step."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tmmcalc.core.columns import select
from tmmcalc.core.quantity import Quantity, keyed, table
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.differentiation import DifferenceError, StepError
from tmmcalc.linkage.facts.kinematics_facts import unit_fact
from tmmcalc.linkage.kinematics import solve_kinematics, step_study
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

BY_METHOD = Quantity("{column}_{method}[{unit}]", "{column} by {method}")
SHARE = Quantity("{column}_diff[%]", "its difference from the exact {column}, against the largest value")
DIFFERENCE = Quantity("difference_{column}[{unit}]", "difference of {column} by the method from the exact one")


def comparison_document(
    mechanism: Mechanism,
    result: Kinematics,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    dimensionless: bool = False,
) -> Document:
    """Columns by the result's method beside the exact ones; differences against the largest value.

    ``patterns`` name the columns, by default v and a of each output; ``rows`` are positions by index, None for all.
    Relative differences refer to the maximum over the cycle: near a zero of v a pointwise one means nothing.
    """
    exact = solve_kinematics(mechanism, result.structure)
    kept = list(range(len(result.labels)) if rows is None else rows)
    headers: list[str] = ["i"]
    columns_: list[list[Any]] = [[result.labels[k] for k in kept]]
    facts = [Fact("method", result.method.name, keyed(result.method, "name"))]
    if dimensionless:
        facts.append(unit_fact(result))
    wanted = patterns or [f"{kind}S_{name}" for name in result.outputs for kind in ("v", "a")]
    both = (select(columns(each, dimensionless=dimensionless), wanted) for each in (exact, result))
    for theirs, ours in zip(*both, strict=True):
        a, b = theirs.make(), ours.make()
        difference, largest = b - a, float(abs(a).max())
        places = {"column": ours.name, "unit": ours.unit, "method": result.method.name}
        headers += [theirs.header, *(told.of(**places).key for told in (BY_METHOD, SHARE))]
        share = 100 * difference / largest if largest else difference
        columns_ += [each[kept].tolist() for each in (a, b, share)]
        worst, mean = float(abs(difference).max()), float(abs(difference).mean())
        text = f"max {number(worst, 4)} {ours.unit} ({number(float(abs(share).max()), 3)} %), mean {number(mean, 4)}"
        told = DIFFERENCE.of(**places)
        values = {told.marked("max").key: worst, told.marked("mean").key: mean}
        facts.append(Fact(f"difference of {ours.name}", text, values))
    notes = tuple(str(grade) for grade in result.grades)
    return Document(title, tuple(facts), notes, View(headers, columns_), wide=True, more="print them with --format csv")


def study_document(
    mechanism: Mechanism, result: Kinematics, title: str, decimals: int | None, output: str | None = None
) -> Document:
    """Error of central differences of an output, the first by default, against their step, exact and rounded."""
    decimals = 6 if decimals is None else decimals
    output = output or next(iter(result.outputs), None)
    rows = step_study(mechanism, result, decimals, output)
    best = min(range(len(rows)), key=lambda k: rows[k].rounded.second)
    steps = table(rows, StepError, "step[deg]" if result.turns else "step", unit="rad" if result.turns else "m")
    ((key, sizes),) = steps.items()
    shown = f"{number(sizes[best], 4)} {'deg' if result.turns else 'm'} with positions rounded to {decimals} decimals"
    facts = (
        Fact("output", str(output), {"output": output}),
        Fact("errors", "largest over the positions, of the transfer functions in units of l_1"),
        Fact("best step for S''", shown, {f"best_{key}": sizes[best]}),
    )
    errors = table([row.rounded for row in rows], DifferenceError, precision=f"{decimals} decimals")
    errors |= table([row.double for row in rows], DifferenceError, precision="double")
    view = View([*steps, *errors], [*steps.values(), *errors.values()], scientific=list(errors))
    return Document(title, facts, (), view)
