"""The criteria of a six-bar with a dwell with their numbers, and the search that makes their weighted sum least."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from tmmcalc.linkage.notes.syntheses.told import Told, angle, course_of, ratio, turned
from tmmcalc.linkage.synthesis.dwell.optimum import STEPS
from tmmcalc.linkage.synthesis.dwell.parameters import RANGES, given
from tmmcalc.linkage.synthesis.dwell.results import BarForce, Dwell
from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Optimum
from tmmcalc.report.formula.digits import Given, digits_given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Paragraph, Place, Result, Table
from tmmcalc.report.telling import cell, lines, named, numeral, points, tabulated

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
BAR = {"CB": "35", "DE": "45"}  # bars with the indices of their forces
ARMS = (
    "h_3 = ((xi_C - xi_A)*(eta_C - eta_B) - (eta_C - eta_A)*(xi_C - xi_B))/lambda_CB",
    "h_4 = ((xi_D - xi_A)*(eta_D - eta_E) - (eta_D - eta_A)*(xi_D - xi_E))/lambda_DE",
)
PULLS = (
    "c_3 = ((xi_C - xi_B)*cos(q) + (eta_C - eta_B)*sin(q))/lambda_CB",
    "c_4 = ((xi_D - xi_E)*cos(q) + (eta_D - eta_E)*sin(q))/lambda_DE",
)
TURNS = (
    "c_3 = ((xi_B - xi_F)*(eta_C - eta_B) - (eta_B - eta_F)*(xi_C - xi_B))/lambda_CB",
    "c_4 = ((xi_E - xi_F)*(eta_D - eta_E) - (eta_E - eta_F)*(xi_D - xi_E))/lambda_DE",
)
FORCES = "R_35 = h_4/(h_3*c_4 - h_4*c_3)", "R_45 = h_3/(h_4*c_3 - h_3*c_4)"
STEEP = 60.0  # deg: a larger pressure angle is told


def searched(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The objective, what is sought within which ranges, how, and what came of it."""
    assert asked.optimum is not None
    weights = {f"w_{k}": weight for k, weight in enumerate(asked.optimum.weights, 1) if weight}
    yield Paragraph(
        tr("The parameters that are not given are sought so that the weighted sum of the criteria is least:")
    )
    yield Display(read(f"F = {' + '.join(f'{w}*f_{w[2:]}' for w in weights)}"))
    shown = ", ".join(f"${name} = {numeral(value, digits_given(value))}$" for name, value in weights.items())
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
    best = tr("least sum of the criteria")
    methods = tr("differential evolution"), tr("Nelder’s and Mead’s method")
    yield from course_of(told, best, of=tr("linkages tried"), run=tr("Method"), called=methods)
    if told.found.course:
        said = tr(
            "The search takes the criteria at {count} places of a turn; below they are found exactly.", count=STEPS
        )
        if asked.exact and asked.working_angle is not None and asked.n is None:
            said += " " + tr("Before that $n$ is corrected to the turn of the crank that is asked, which changes them.")
        yield Paragraph(said)


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
    found: dict[str, Callable[[], float]] = {
        "phi12_part": lambda: size("phi_12") / asked.dwell,
        "psi0": lambda: size("psi_0"),
        "psi13": lambda: size("psi_13"),
        "psi12_part": lambda: size("psi_12") / size("psi_13"),
        "bar": lambda: size("l_CB") / size("l_OB"),
        "side": lambda: size("l_CD") / size("l_OB"),
        "alpha": lambda: size("alpha"),
        "n": lambda: size("n"),
    }
    for name in _sought(asked):
        ends = asked.optimum.ranges.get(name, RANGES[name])
        yield LETTERS[name], *(_cell(each, turn=name in ANGLES) for each in (*ends, found[name]()))


def _sought(asked: DwellTask) -> list[str]:
    """The parameters that are not given, by name."""
    values, free = given(asked), ("n",) if asked.lengths is not None else tuple(LETTERS)
    return [name for name in free if values[name] is None and (name != "n" or asked.pivot is None)]


def ranges(asked: DwellTask, optimum: Optimum) -> Iterator[tuple[str, tuple[float, float], str]]:
    """The parameters that are sought by their letters, with their ranges and units."""
    for name in _sought(asked):
        low, high = optimum.ranges.get(name, RANGES[name])
        turn = name in ANGLES
        yield LETTERS[name], (math.degrees(low), math.degrees(high)) if turn else (low, high), "deg" if turn else ""


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
    yield from _bars(told, dwell)
    if asked.optimum is not None and dwell.cost is not None:
        weights = {f"w_{k}": weight for k, weight in enumerate(asked.optimum.weights, 1) if weight}
        told.give({name: ratio(weight, tr("weight of the criterion")) for name, weight in weights.items()})
        told.give({"F": ratio(dwell.cost, tr("weighted sum of the criteria"))})
        yield from told.lines(f"F = {' + '.join(f'{w}*f_{w[2:]}' for w in weights)}")
        yield Result("F", told.lexicon["F"])
    limit = 90.0 - math.degrees(told.task.transmission) if told.task.transmission else STEEP
    yield Result("delta_m", told.lexicon["delta_m"], limit, "<=")


def _bars(told: Told, dwell: Dwell) -> Iterator[Block]:
    """The bars' forces where they are largest on each stroke, and the criteria of the forces made of them."""
    rocks = dwell.output == "rocker"
    yield Paragraph(
        tr(
            "The bars carry axial forces alone. For a unit resistance they follow from the equilibrium of moments of "
            "the coupler about $A$ and from that of link 5 along its motion:"
        )
    )
    yield Display(read("R_35*h_3 + R_45*h_4 = 0"))
    yield Display(read("R_35*c_3 + R_45*c_4 = -1"))
    yield Paragraph(
        tr("Table {tab:synthesis_bars} has the places of the crank at which each bar is loaded most on each stroke.")
    )
    strokes = {"working": tr("working stroke"), "idle": tr("idle stroke")}
    names = [f"{each.bar}, {strokes[each.stroke]}" for each in dwell.bars]
    columns = {
        "$phi$, deg": [math.degrees(each.at) for each in dwell.bars],
        **{f"$h_{k + 3}$": [each.arms[k] for each in dwell.bars] for k in (0, 1)},
        **{f"$c_{k + 3}$": [each.pulls[k] for each in dwell.bars] for k in (0, 1)},
        tr("force of the bar"): [each.force for each in dwell.bars],
    }
    caption = tr("Bars where they are loaded most, for a unit resistance")
    yield tabulated(caption, columns, names, head=tr("Bar"), key="synthesis_bars")
    places = [
        Place(name, {**told.lexicon, **named(_loaded(told, each, rocks=rocks))})
        for name, each in zip(names, dwell.bars, strict=True)
    ]
    yield from lines([f"lambda_{bar} = l_{bar}/l_OB" for bar in BAR], [Place("", places[0].lexicon)])
    yield from lines((*ARMS, *(TURNS if rocks else PULLS)), places[:1])
    yield Paragraph(tr("The other places likewise. The forces of the bars are then:"))
    for bar, text in zip(BAR, FORCES, strict=True):
        yield from lines([text], [place for place, each in zip(places, dwell.bars, strict=True) if each.bar == bar])
    for each in dwell.bars:
        largest = tr("largest force of bar {bar}, {stroke}", bar=each.bar, stroke=strokes[each.stroke])
        told.give({f"R_{BAR[each.bar]}^{each.stroke[0]}": ratio(each.force, largest)})
    yield from told.lines("f_4 = (R_35^w)**2 + (R_45^w)**2", "f_5 = (R_35^i)**2 + (R_45^i)**2")


def _loaded(told: Told, each: BarForce, *, rocks: bool) -> dict[str, Given]:
    """What the forces of the bars follow from at one place; lengths in parts of l_OB."""
    size = told.design.size
    coordinates = tr("coordinates of the points, parts of the distance OB")
    pins = dict(zip("ABCDE", zip(each.x, each.y, strict=True), strict=True))
    if rocks:
        pins["F"] = size("x_F") / size("l_OB"), size("y_F") / size("l_OB")
    found: dict[str, Given] = {}
    for pin, (x, y) in pins.items():
        found |= {f"xi_{pin}": ratio(x, coordinates), f"eta_{pin}": ratio(y, coordinates)}
    for k, (bar, index) in enumerate(BAR.items()):
        pull = tr("projection of a unit force along {bar} on the guide", bar=bar)
        if rocks:
            pull = tr("arm of a unit force along {bar} about {pin}", bar=bar, pin="F")
        length = size(f"l_{bar}") / size("l_OB")
        found |= {
            f"lambda_{bar}": ratio(length, tr("length of {bar}, part of the distance OB", bar=bar)),
            f"h_{k + 3}": ratio(each.arms[k], tr("arm of a unit force along {bar} about {pin}", bar=bar, pin="A")),
            f"c_{k + 3}": ratio(each.pulls[k], pull),
        }
        if bar == each.bar:
            said = tr("force of bar {bar} for a unit resistance, positive in compression", bar=bar)
            found[f"R_{index}"] = ratio(each.force, said)
    return found
