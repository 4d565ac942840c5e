"""Numerical differentiation beside exact derivatives: the comparison by position, the study of the step."""

from __future__ import annotations

import math
from typing import Any

from tmmcalc.core.columns import select
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.kinematics import solve_kinematics, step_study
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number


def comparison_document(mechanism: Mechanism, result: Kinematics, title: str) -> Document:
    """Each output's v and a by the result's method beside the exact ones; differences against the largest value.

    Relative differences refer to the maximum over the cycle: near a zero of v a pointwise one means nothing.
    """
    exact = solve_kinematics(mechanism, result.structure)
    headers: list[str] = ["i"]
    columns_: list[list[Any]] = [list(result.labels)]
    facts = [Fact("method", result.method.name, {"method": result.method.name})]
    wanted = [f"{kind}S_{name}" for name in result.outputs for kind in ("v", "a")]
    for theirs, ours in zip(select(columns(exact), wanted), select(columns(result), wanted), strict=True):
        a, b = theirs.make(), ours.make()
        difference, largest = b - a, float(abs(a).max())
        headers += [
            f"{theirs.name}[{theirs.unit}]",
            f"{ours.name}_{result.method.name}[{ours.unit}]",
            f"{ours.name}_diff[%]",
        ]
        share = 100 * difference / largest if largest else difference
        columns_ += [a.tolist(), b.tolist(), share.tolist()]
        worst, mean = float(abs(difference).max()), float(abs(difference).mean())
        text = f"max {number(worst, 4)} {ours.unit} ({number(float(abs(share).max()), 3)} %), mean {number(mean, 4)}"
        values = {f"difference_{ours.name}_max[{ours.unit}]": worst, f"difference_{ours.name}_mean[{ours.unit}]": mean}
        facts.append(Fact(f"difference of {ours.name}", text, values))
    notes = tuple(str(grade) for grade in result.grades)
    return Document(title, tuple(facts), notes, View(headers, columns_), wide=True, more="print them with --format csv")


def study_document(mechanism: Mechanism, result: Kinematics, title: str, decimals: int | None) -> Document:
    """Error of central differences of the first output against their step, exact and rounded positions."""
    decimals = 6 if decimals is None else decimals
    rows = step_study(mechanism, result, decimals)
    unit, factor = ("deg", math.degrees(1.0)) if result.turns else ("m", 1.0)
    best = min(rows, key=lambda row: row.rounded.max_second)
    facts = (
        Fact("output", result.outputs[0], {"output": result.outputs[0]}),
        Fact("errors", "largest over the positions, of the transfer functions in units of l_1"),
        Fact(
            "best step for S''",
            f"{number(best.step * factor, 4)} {unit} with positions rounded to {decimals} decimals",
            {f"best_step[{unit}]": best.step * factor},
        ),
    )
    errors = [f"dS[{decimals} decimals]", f"ddS[{decimals} decimals]", "dS[double]", "ddS[double]"]
    view = View(
        [f"step[{unit}]", *errors],
        [
            [row.step * factor for row in rows],
            [row.rounded.max_first for row in rows],
            [row.rounded.max_second for row in rows],
            [row.double.max_first for row in rows],
            [row.double.max_second for row in rows],
        ],
        scientific=errors,
    )
    return Document(title, facts, (), view)
