"""The criteria of a six-bar with a dwell with their numbers, and the search that makes their weighted sum least."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.notes.syntheses.told import Told, angle, ratio, turned
from tmmcalc.linkage.synthesis.dwell.parameters import NAMES, RANGES, given
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Paragraph, Result, Table
from tmmcalc.report.telling import cell, numeral, points

ANGLES = ("psi0", "psi13", "alpha")
LETTERS = {
    "phi12_part": "$phi_12$/$phi_B$",
    "psi0": "$psi_0$",
    "psi13": "$psi_13$",
    "psi12_part": "$psi_12$/$psi_13$",
    "bar": "$l_CB$/$l_OB$",
    "side": "$l_CD$/$l_OB$",
    "alpha": "$alpha$",
    "n": "$n$",
}
STEEP = 60.0  # deg: a larger pressure angle is told


def searched(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The objective, what is sought within which ranges, how, and what came of it."""
    assert asked.optimum is not None
    weights = {f"w_{k}": weight for k, weight in enumerate(asked.optimum.weights, 1) if weight}
    yield Paragraph(
        tr("The parameters that are not given are sought so that the weighted sum of the criteria is least:")
    )
    yield Display(read(f"F = {' + '.join(f'{w}*f_{w[2:]}' for w in weights)}"))
    shown = ", ".join(f"${name} = {numeral(value)}$" for name, value in weights.items())
    yield Paragraph(
        tr("The weights are {weights}. The criteria are told with the numbers of the linkage below.", weights=shown)
    )
    rows = [*_ranges(told, asked)]
    if rows:
        yield Paragraph(tr("Table {tab:synthesis_ranges} has the parameters that are sought."))
        head = tr("Parameter"), tr("least"), tr("largest"), tr("found")
        yield Table(tr("Parameters that are sought"), head, tuple(rows), "synthesis_ranges")
    counters = told.found.counters
    yield Paragraph(
        tr(
            "The search is differential evolution with {population} linkages a generation and {generations} "
            "generations at most, then Nelder’s and Mead’s method with {polish} evaluations at most. A linkage counts "
            "only if its crank turns fully: {tried} linkages were tried, {worked} of them work.",
            population=asked.optimum.population,
            generations=asked.optimum.generations,
            polish=asked.optimum.polish,
            tried=counters.get("linkages tried", 0),
            worked=counters.get("worked", 0),
        )
    )
    refused = {key.partition(": ")[2]: count for key, count in counters.items() if key.startswith("refused: ")}
    if refused:
        yield Paragraph(tr("The others were refused:"))
        yield points([f"{tr_name(reason)}: {count}" for reason, count in refused.items()])
    yield from _sifted(told)


def _sifted(told: Told) -> Iterator[Block]:
    """How many linkages of the search keep the constraints of the spec, and which of them fail."""
    counters = told.found.counters
    if "kept the constraints" in counters:
        yield Paragraph(
            tr(
                "The constraints of the spec are kept by {count} linkages of the search; those that break them come "
                "after all others.",
                count=counters["kept the constraints"],
            )
        )
        failing = {key.removeprefix("failed "): count for key, count in counters.items() if key.startswith("failed ")}
        if failing:
            yield Paragraph(tr("Constraints that fail:"))
            yield points([f"{name}: {count}" for name, count in failing.items()])


def _ranges(told: Told, asked: DwellTask) -> Iterator[tuple[str, ...]]:
    """The free parameters with their ranges and what was found."""
    assert asked.optimum is not None
    size = told.design.size
    found = {
        "phi12_part": size("phi_12") / asked.dwell,
        "bar": size("l_CB") / size("l_OB"),
        "side": size("l_CD") / size("l_OB"),
        "alpha": size("alpha"),
    }
    if asked.lengths is None:
        found |= {"psi0": size("psi_0"), "psi13": size("psi_13"), "psi12_part": size("psi_12") / size("psi_13")}
    if asked.pivot is None:
        found["n"] = size("n")
    values = given(asked)
    for name in NAMES:
        if values[name] is None and name in found:
            ends = asked.optimum.ranges.get(name, RANGES[name])
            turn = name in ANGLES
            yield LETTERS[name], *(_cell(each, turn=turn) for each in (*ends, found[name]))


def _cell(value: float, *, turn: bool) -> str:
    return turned(math.degrees(value)) if turn else cell(value)


def criteria(told: Told, asked: DwellTask, dwell: Dwell) -> Iterator[Block]:
    """What each criterion is, with its numbers; their sum."""
    steepest = next(each for each in dwell.maxima if each.name == "delta")
    f = dict(zip(("f_1", "f_2", "f_3", "f_4", "f_5"), dwell.criteria, strict=True))
    slides = dwell.output == "slider"
    told.give(
        {
            "delta_m": angle(steepest.value, tr("largest pressure angle over the turn")),
            "f_2": ratio(f["f_2"], tr("criterion of the size")),
            "f_3": ratio(f["f_3"], tr("criterion of the pressure angle")),
            "f_4": ratio(f["f_4"], tr("criterion of the forces on the working stroke")),
            "f_5": ratio(f["f_5"], tr("criterion of the forces on the idle stroke")),
        }
    )
    yield Paragraph(tr("The criteria of quality, with lengths in parts of $l_OB$ and a unit resistance:"))
    if slides:
        yield from told.lines("f_2 = l_OB/l_OA")
    yield from told.lines("f_3 = tan(delta_m)")
    yield Paragraph(
        tr(
            "The bars carry axial forces alone. They follow from the equilibrium of moments of the coupler about $A$ "
            "and of link 5 along its motion. With $R_35$ and $R_45$ for a unit resistance the criteria of the forces "
            "are"
        )
    )
    yield Display(read("f_4 = max(R_35**2) + max(R_45**2)"))
    yield Paragraph(
        tr(
            "over the working stroke, and $f_5$ the same over the idle stroke: $f_4 = {working}$, $f_5 = {idle}$.",
            working=numeral(f["f_4"]),
            idle=numeral(f["f_5"]),
        )
    )
    if asked.optimum is not None and dwell.cost is not None:
        weights = {f"w_{k}": weight for k, weight in enumerate(asked.optimum.weights, 1) if weight}
        told.give({name: ratio(weight, tr("weight of the criterion")) for name, weight in weights.items()})
        told.give({"F": ratio(dwell.cost, tr("weighted sum of the criteria"))})
        yield from told.lines(f"F = {' + '.join(f'{w}*f_{w[2:]}' for w in weights)}")
        yield Result("F", told.lexicon["F"])
    limit = 90.0 - math.degrees(told.task.transmission) if told.task.transmission else STEEP
    yield Result("delta_m", told.lexicon["delta_m"], limit, "<=")
