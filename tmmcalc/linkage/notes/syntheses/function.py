"""The function generator: precision points, the linear system of the closure, sizes of its coefficients, the error."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.notes.syntheses.fourbar import turning
from tmmcalc.linkage.notes.syntheses.told import Told, angle, course_of, length, quantity_of, ratio, sound, turned
from tmmcalc.linkage.pictures.synthesis import draw_function
from tmmcalc.linkage.synthesis.freudenstein import closure_of
from tmmcalc.linkage.synthesis.function import is_exact
from tmmcalc.linkage.synthesis.functiondesign import structural_error
from tmmcalc.linkage.synthesis.functionfit import coefficients_of
from tmmcalc.linkage.synthesis.results import Precision
from tmmcalc.linkage.synthesis.task import FunctionTask
from tmmcalc.linkage.tables.synthesis_generation import FunctionTable
from tmmcalc.linkage.tables.tasks.synthesis import formula_of, precision_points
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import FormulaError, read
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Display, Figure, Paragraph, Place, Result
from tmmcalc.report.telling import WIDE, cell, lines, named, number_of, tabulated

FOUR_BAR = "cos(phi_i - psi_i) = K_1*cos(psi_i) - K_2*cos(phi_i) + K_3"
SLIDER = "s_i**2 = K_1*s_i*cos(phi_i) + K_2*sin(phi_i) - K_3"
SIZES = {
    False: ("a = d/K_1", "c = d/K_2", "b = sqrt(a**2 + c**2 + d**2 - 2*a*c*K_3)"),
    True: ("r = K_1/2", "e = K_2/(2*r)", "l = sqrt(r**2 + e**2 - K_3)"),
}
ROOM = 5.0, 4.0, 2.0, 0.0  # beside the diagrams: left, below, right, above [mm]
OUTPUT = {  # at the points
    False: (
        "f_i = sqrt(a**2 + d**2 - 2*a*d*cos(phi_i))",
        "delta_i = atan2(a*sin(phi_i), a*cos(phi_i) - d)",
        "gamma_i = acos((f_i**2 + c**2 - b**2)/(2*f_i*c))",
        "psi_i^{*} = delta_i <sign> gamma_i",
    ),
    True: ("s_i^{*} = r*cos(phi_i) <sign> sqrt(l**2 - (e - r*sin(phi_i))**2)",),
}
DIAGRAMS = 105.0  # height of the diagrams [mm]
WORKED = 8  # points that are worked out; the tables have all


def task(told: Told) -> str:
    """What is sought."""
    asked: FunctionTask = told.asked
    if asked.mechanism == "slider_crank":
        return tr(
            "A slider-crank is sought whose slider is at $s$ while the crank $AB = r$ stands at $phi$, as a given "
            "function wants it; $BC = l$ is the connecting rod, $e$ the height of the guide over $A$."
        )
    return tr(
        "A four-bar linkage is sought whose rocker $DC = c$ stands at the angle $psi$ while the crank $AB = a$ stands "
        "at $phi$, as a given function wants it; $BC = b$ is the coupler, $AD = d$ the frame."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: FunctionTask = told.asked
    table = _table(told)
    slides = asked.mechanism == "slider_crank"
    found = {"n": ratio(len(asked.inputs), tr("number of precision points"))}
    if table.range is not None:
        found["x_0"] = ratio(table.range[0], tr("beginning of the range of the function"))
        found["x_e"] = ratio(table.range[1], tr("end of the range of the function"))
    if table.input_range is not None:
        found["Deltaphi"] = angle(table.input_range, tr("turn of the crank over the range"))
    if table.output_range is not None:
        name, said = (
            ("Deltas", tr("travel of the slider over the range"))
            if slides
            else (
                "Deltapsi",
                tr("turn of the rocker over the range"),
            )
        )
        found[name] = quantity_of(table.output_range, "m" if slides else "rad", said)
    if asked.input_start is not None:
        found["phi_s"] = angle(asked.input_start, tr_name("crank where x begins"))
    if asked.output_start is not None:
        said = tr("output where $x$ begins")
        found["s_s" if slides else "psi_s"] = quantity_of(asked.output_start, "m" if slides else "rad", said)
    if not slides:
        found["d"] = length(asked.frame, tr("length of the frame"))
    if told.task.transmission:
        found["mu_a"] = angle(told.task.transmission, tr("allowed transmission angle"))
    return found


def _table(told: Told) -> FunctionTable:
    found: FunctionTable = told.order.spec.synthesis.function
    return found


def further(told: Told) -> Iterator[Block]:
    """The function, its precision points or those that are given."""
    asked, table = told.asked, _table(told)
    slides = asked.mechanism == "slider_crank"
    if table.expression is not None:
        text = _spelt(table.expression)
        chebyshev = table.spacing == "chebyshev"
        yield Datum(tr("the function"), ("y",), text=f"${text}$" if _readable(text) else table.expression)
        spacing = tr("that of Chebyshev") if chebyshev else tr("equal, with both ends of the range")
        yield Datum(tr("spacing of the precision points"), text=spacing)
    for k, (x, y) in enumerate(table.table or [], 1):
        yield Datum(tr("point {number} of the function", number=k), (f"x_{k}", f"y_{k}"), (x, y))
    if table.input_range is not None:
        yield Paragraph(tr("Crank and output run in proportion to $x$ and $y$, counted from where $x$ begins."))
        return
    said = tr("angles of the crank at the precision points, from where $x$ begins")
    yield Datum(said, ("phi'_i",), tuple(np.degrees(asked.inputs).tolist()), "deg")
    outputs = asked.outputs if slides else np.degrees(asked.outputs)
    name, unit = ("s'_i", "m") if slides else ("psi'_i", "deg")
    yield Datum(tr("outputs at these points, from where $x$ begins"), (name,), tuple(outputs.tolist()), unit)


def blocks(told: Told) -> Iterator[Block]:
    """The points, the system, its solution, the sizes."""
    asked: FunctionTask = told.asked
    slides, exact = asked.mechanism == "slider_crank", is_exact(asked)
    yield from _points(told, asked)
    yield Paragraph(
        tr("The closure of the linkage is linear in three combinations of its dimensions (equation of Freudenstein):")
    )
    yield Display(read(SLIDER if slides else FOUR_BAR))
    if slides:
        yield Paragraph(tr("with $K_1 = 2*r$, $K_2 = 2*r*e$, $K_3 = r**2 - l**2 + e**2$."))
    else:
        yield Paragraph(tr("with $K_1 = d/a$, $K_2 = d/c$, $K_3 = (a**2 + c**2 + d**2 - b**2)/(2*a*c)$."))
    yield Paragraph(_method(told, asked, exact))
    best = tr("sum of squares, {unit}", unit=f"{tr_unit('m' if slides else 'rad')}²")
    yield from course_of(told, best, run=tr("Start"))
    yield from _starts(told, slides)
    _coefficients(told, slides)
    places = [*_places(told, slides)]
    if exact:
        yield Paragraph(tr("The solution keeps the equation at all points:"))
        yield from lines([SLIDER if slides else FOUR_BAR], places[:WORKED])
    yield Paragraph(tr("From the coefficients follow the dimensions:"))
    yield from told.lines(*SIZES[slides])
    if not exact:
        yield from _objective(told, slides)
        yield from _outputs(told, slides, places[:WORKED])


def _points(told: Told, asked: FunctionTask) -> Iterator[Block]:
    """The precision points: their spacing, angles of the crank and outputs from where x begins."""
    table, slides = _table(told), asked.mechanism == "slider_crank"
    columns: dict[str, Real] = {}
    if table.expression is not None and table.range is not None:
        low, high = table.range
        x = precision_points(table.points or 3, low, high, table.spacing)
        y_of = formula_of(table.expression)
        first, last = y_of(np.array([low, high])).tolist()
        columns = {"$x_i$": x, "$y_i$": y_of(x)}
        text = _spelt(table.expression)
        shown = tr("The function is $y = {formula}$.", formula=text) if _readable(text) else ""
        if table.spacing == "chebyshev":
            yield Paragraph(f"{shown} {tr('Its precision points have the spacing of Chebyshev:')}".strip())
            lexicon = {
                "x_0": ratio(low, tr("beginning of the range of the function")),
                "x_e": ratio(high, tr("end of the range of the function")),
                "n": ratio(len(x), tr("number of precision points")),
            }
            places = [
                Place(
                    tr("at point {number}", number=k + 1),
                    named(
                        {
                            **lexicon,
                            "i": ratio(k + 1, tr("number of the point")),
                            "x_i": ratio(float(each), tr("abscissa of the point")),
                        }
                    ),
                    str(k + 1),
                )
                for k, each in enumerate(x)
            ]
            yield from lines(["x_i = (x_0 + x_e)/2 - (x_e - x_0)/2*cos(deg(180)*(2*i - 1)/(2*n))"], places[:WORKED])
        elif shown:
            yield Paragraph(shown)
        yield Paragraph(tr("Crank and output run in proportion to $x$ and $y$, counted from where $x$ begins:"))
        ends = {
            "y_0": ratio(first, tr("first value of the function")),
            "y_e": ratio(last, tr("last value of the function")),
        }
        output, whole = ("s'_i", "Deltas") if slides else ("psi'_i", "Deltapsi")
        rows = []
        for k in range(len(x)):
            own = {
                **ends,
                "x_i": ratio(float(x[k]), tr("abscissa of the point")),
                "y_i": ratio(float(columns["$y_i$"][k]), tr("value of the function at the point")),
                "phi'_i": angle(float(asked.inputs[k]), tr("angle of the crank from where $x$ begins")),
                output: quantity_of(
                    float(asked.outputs[k]), "m" if slides else "rad", tr("output from where $x$ begins")
                ),
            }
            rows.append(Place(tr("at point {number}", number=k + 1), told.lexicon | named(own), str(k + 1)))
        texts = (
            "phi'_i = Deltaphi*(x_i - x_0)/(x_e - x_0)",
            f"{output} = {whole}*(y_i - y_0)/(y_e - y_0)",
        )
        yield from lines(texts, rows[:WORKED])
    heads = ("$phi'_i$, deg", "$s'_i$, m" if slides else "$psi'_i$, deg")
    columns[heads[0]] = np.degrees(asked.inputs)
    columns[heads[1]] = asked.outputs if slides else np.degrees(asked.outputs)
    labels = [str(k + 1) for k in range(len(asked.inputs))]
    yield Paragraph(tr("Table {tab:synthesis_points} has the precision points, counted from where $x$ begins."))
    yield tabulated(tr("Precision points"), columns, labels, head=tr("Point"), key="synthesis_points")


def _spelt(expression: str) -> str:
    """An expression of the spec as a formula."""
    return expression.replace("^", "**").replace("log(", "ln(")


def _readable(text: str) -> bool:
    try:
        read(f"y = {text}")
    except FormulaError:
        return False
    return True


def _method(told: Told, asked: FunctionTask, exact: bool) -> str:
    """How the system and the free angles are found."""
    count, closure = len(asked.inputs), closure_of(asked)
    free = sum(each is None for each in closure.given)
    tried = told.found.counters.get("candidates", 0)
    if not exact:
        return tr(
            "With {count} points there are more equations than unknown. The system is solved in the least squares, "
            "the free starting angles on a grid; from the best of these solutions the sum of the squares of the "
            "errors of the output is made least by the method of Levenberg and Marquardt.",
            count=count,
        )
    if count == 3 and free:
        return tr(
            "Three points make three linear equations with the unknown $K_1$, $K_2$, $K_3$ for any starting angles. "
            "The starting angles that are free are gone through on a grid: {tried} linkages, of which the best is "
            "taken.",
            tried=tried,
        )
    if count == 3:
        return tr("Three points make three linear equations with the unknown $K_1$, $K_2$, $K_3$.")
    if count == 4:
        return tr(
            "Three points give $K_1$, $K_2$, $K_3$ as functions of the starting angles; the fourth equation is the "
            "condition that the determinant of the system with its right sides is zero. Its roots along one free "
            "starting angle are bracketed and refined: {tried} linkages.",
            tried=tried,
        )
    return tr(
        "Three points give $K_1$, $K_2$, $K_3$ as functions of both starting angles; the fourth and the fifth "
        "equation are two conditions for these angles, solved by Newton’s method from a grid of starts: {tried} "
        "linkages.",
        tried=tried,
    )


def _starts(told: Told, slides: bool) -> Iterator[Block]:
    """The starting angles that were found."""
    first = turned(number_of(told.lexicon, "phi_s"), 7)
    if slides:
        second = cell(number_of(told.lexicon, "s_s"), 7)
        yield Paragraph(
            tr(
                "Where $x$ begins the linkage that is taken stands at $phi_s$ = {first}, $s_s$ = {second} m.",
                first=first,
                second=second,
            )
        )
        return
    second = turned(number_of(told.lexicon, "psi_s"), 7)
    yield Paragraph(
        tr(
            "Where $x$ begins the linkage that is taken stands at $phi_s$ = {first}, $psi_s$ = {second}.",
            first=first,
            second=second,
        )
    )


def _coefficients(told: Told, slides: bool) -> None:
    """The coefficients of the linkage that is taken."""
    closure = closure_of(told.asked)
    sizes = np.array([[told.design.size(symbol) for symbol in ("rle" if slides else "abcd")]])
    if slides:
        sizes = np.append(sizes, [[0.0]], axis=1)
    found = coefficients_of(closure, sizes)[0].tolist()
    units = ("m", "m^2", "m^2") if slides else ("", "", "")
    said = tr("coefficient of the system")
    told.give({f"K_{k}": Given(value, unit, said) for k, (value, unit) in enumerate(zip(found, units, strict=True), 1)})


def _places(told: Told, slides: bool) -> Iterator[Place]:
    """The points with the angles of the linkage there."""
    precision = told.design.precision
    assert precision is not None
    for k, (x, wanted) in enumerate(zip(precision.crank, precision.wanted, strict=True), 1):
        own = {"phi_i": angle(float(x), tr("angle of the crank at the point"))}
        if slides:
            own["s_i"] = length(float(wanted), tr("place of the slider at the point"))
        else:
            own["psi_i"] = angle(float(wanted), tr("angle of the rocker at the point"))
        yield Place(tr("at point {number}", number=k), told.lexicon | named(own), str(k))


def _objective(told: Told, slides: bool) -> Iterator[Block]:
    """What is least."""
    letter = "s" if slides else "psi"
    yield Paragraph(
        tr(
            "The objective is a sum over the points with the wanted output ${wanted}$ and that of the linkage "
            "${found}$:",
            wanted=f"{letter}_i",
            found=f"{letter}_i^{{*}}",
        )
    )
    yield Display(read(f"F = sum(({letter}_i^{{*}} - {letter}_i)**2, i)"))


def _outputs(told: Told, slides: bool, places: Sequence[Place]) -> Iterator[Block]:
    """The output of the linkage at the points, from the triangle of the crank pin."""
    precision = told.design.precision
    assert precision is not None
    signs = set()
    for place, x, found in zip(places, precision.crank, precision.found, strict=False):
        if slides:
            r = told.design.size("r")
            place.lexicon.update(named({"s_i^{*}": length(float(found), tr("place of the slider of the linkage"))}))
            signs.add(float(found) > r * math.cos(x))
            continue
        across = cmath.rect(told.design.size("a"), float(x)) - told.design.size("d")
        beside = cmath.rect(1.0, float(found)) / across
        signs.add(beside.imag > 0)
        triangle = {
            "f_i": length(abs(across), tr("distance between points {first} and {second}", first="D", second="B")),
            "delta_i": angle(cmath.phase(across), tr("angle of the line {first}{second}", first="D", second="B")),
            "gamma_i": angle(abs(cmath.phase(beside)), tr("angle of the triangle at D")),
            "psi_i^{*}": angle(float(found), tr("angle of the rocker of the linkage")),
        }
        place.lexicon.update(named(triangle))
    if len(signs) == 1:
        yield Paragraph(tr("The output of the linkage that is taken, at the points:"))
        yield from lines(OUTPUT[slides], places, {"sign": "+" if signs.pop() else "-"})


def conditions(told: Told) -> Iterator[Block]:
    """Output and error at the points, over the range; turning and transmission."""
    precision, asked = told.design.precision, told.asked
    assert precision is not None
    slides = asked.mechanism == "slider_crank"
    yield from turning(told)
    merit = structural_error(closure_of(asked)).marked("max")
    largest = Given(told.design.merits[merit.key], merit.unit, tr("largest error of the output over the range"))
    yield Paragraph(
        tr(
            "Table {tab:synthesis_errors} compares the output of the linkage with what is wanted at the points; figure "
            "{fig:synthesis_function} has the error over the whole range."
        )
    )
    yield _errors(precision, slides)
    draw = partial(_drawn, found=precision)
    yield Figure(tr("Output and its error"), draw, (WIDE, DIAGRAMS), "synthesis_function")
    yield Result("Delta_m", largest)


def _drawn(drawing: Drawing, box: Box, found: Precision) -> None:
    """The diagrams with room for their words, which are larger in a note."""
    draw_function(drawing, box.inset(*ROOM), found)


def _errors(precision: Precision, slides: bool) -> Block:
    factor = 1.0 if slides else math.degrees(1.0)
    letter, unit = ("s", "m") if slides else ("psi", "deg")
    columns = {
        "$phi_i$, deg": np.degrees(precision.crank),
        tr("wanted ${name}$", name=f"{letter}_i") + f", {unit}": factor * precision.wanted,
        tr("found ${name}$", name=f"{letter}_i") + f", {unit}": factor * precision.found,
        f"$Delta_i$, {unit}": factor * sound(precision.found - precision.wanted),
    }
    labels = [str(k + 1) for k in range(len(precision.crank))]
    return tabulated(tr("Output at the points"), columns, labels, head=tr("Point"), key="synthesis_errors")
