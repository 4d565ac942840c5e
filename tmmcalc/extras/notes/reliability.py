"""Reliability under shock loads: the strength by a test, the reliability over the time, mean life and lives."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.extras.notes.told import course, given
from tmmcalc.extras.pictures.reliability import draw_reliability
from tmmcalc.extras.reliability import (
    Law,
    LifeTest,
    Reliability,
    ReliabilityTask,
    failure_rate,
    falling_part,
    hazard,
    load_margin,
    strength_at,
)
from tmmcalc.extras.tables.reliability import ReliabilityTable
from tmmcalc.extras.tables.tasks.reliability import to_reliability
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Display, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import data_of, drawn, lines, named, numeral, plainly, tabulated

READINGS = ("a = (n*x_{(1)} - x_{(n)})/(n - 1)", "b = (n*x_{(n)} - x_{(1)})/(n - 1)")
CLIPPED = "a = max((n*x_{(1)} - x_{(n)})/(n - 1), 0)"
STRENGTH = ("w = beta*(b - a)/(2*h*m)", "x_m = b + w - sqrt(w*(2*b + w))", "r = x_m*exp(beta*t_{(1)})")
LONGEST = "t_0 = ln(r/b)/beta"
SURE = "t_a = ln(r/a)/beta"
BEFORE, WITHIN, AFTER = range(3)  # t_0; t_0 and t_a; t_a
HAZARD = {
    WITHIN: "H = h*b*(t - t_0)/(b - a) - h*(x_0 - x)/((b - a)*beta)",
    AFTER: "H = H_a + h*(t - t_a)",
}
INTENSITY = {WITHIN: "lambda = h*(b - x)/(b - a)", AFTER: "lambda = h"}
FIGURE = 120.0  # height [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Loads, strength, the reliability at times, mean life and lives, the course over the time."""
    result: Reliability = order.results["reliability"]
    task, table = to_reliability(order.spec), order.spec.reliability
    assert table is not None
    law = Law(result.low, result.high, task.rate, result.strength, result.decay)
    known = _known(task, table)
    lexicon = named(_quantities(result, task, table) | known)
    place = Place("", lexicon)
    yield Heading(tr("Reliability under shock loads"))
    yield _shocks()
    yield from given(data_of(known), "reliability")
    if table.readings is not None:
        yield from _readings(table.readings, place)
    if task.test is not None:
        yield Heading(tr("Strength by the test"), 3)
        yield Paragraph(
            tr(
                "The shortest life of the test is the most probable one of the shortest lives of $m$ items, which "
                "gives $r$ for every $beta$; with $beta$ the mean life grows or falls until it is that of the test. "
                "This is solved numerically: $beta$ = {beta}.",
                beta=f"${numeral(result.decay, 7)}$",
            )
        )
        yield from lines(STRENGTH, [place])
    yield Heading(tr("Reliability over the time"), 3)
    yield from _ends(result, place)
    yield from _at_times(result, law, lexicon)
    yield from _mean(result, law, place)
    yield from _lives(result, law, lexicon)
    yield Heading(tr("Course of the reliability"), 3)
    yield from _course(result)
    yield Result("T", lexicon["T"])
    if result.threshold:
        yield Result("t_0", lexicon["t_0"])


def data(order: Order) -> Iterator[Block]:
    """How the product fails, its loads, its strength or a test, the times that are asked for."""
    task, table = to_reliability(order.spec), order.spec.reliability
    assert table is not None
    yield _shocks()
    if task.test is not None:
        yield Paragraph(
            tr(
                "The strength is estimated by a test: its shortest life is the most probable one of the shortest lives "
                "of $m$ items, its mean life that of the product."
            )
        )
    yield from data_of(_known(task, table))
    if table.readings is not None:
        said = tr("loads of single shocks, by which the uniform load is estimated")
        yield Datum(said, ("x",), tuple(table.readings))
    if task.times:
        yield Datum(tr("times at which the reliability is sought"), ("t",), task.times)


def _shocks() -> Paragraph:
    return Paragraph(
        tr(
            "The strength of the product falls as $x = r*exp(-beta*t)$. Shocks strike it at a constant rate $h$, "
            "their loads are uniform between $a$ and $b$; a shock above the strength is a failure. Times and loads "
            "are in the units of the input data, rates in one over the unit of time."
        )
    )


def _known(task: ReliabilityTask, table: ReliabilityTable) -> Lexicon:
    if table.readings is not None:
        found = {"n": Given(float(len(table.readings)), "", tr("number of readings of the load"))}
    else:
        found = {
            "a": Given(task.low, "", tr("least load of a shock")),
            "b": Given(task.high, "", tr("largest load of a shock")),
        }
    found["h"] = Given(task.rate, "", tr("rate of shocks"))
    if task.test is not None:
        found["m"] = Given(float(task.test.items), "", tr("number of items of the test"))
        found["t_{(1)}"] = Given(task.test.least, "", tr("shortest life of the test"))
        found["T"] = Given(task.test.mean, "", tr("mean life"))
    elif task.strength is not None and task.decay is not None:
        found["r"] = Given(task.strength, "", tr("strength at the beginning"))
        found["beta"] = Given(task.decay, "", tr("decay of the strength"))
    return found


def _quantities(result: Reliability, task: ReliabilityTask, table: ReliabilityTable) -> Lexicon:
    found = {
        "a": Given(result.low, "", tr("least load of a shock")),
        "b": Given(result.high, "", tr("largest load of a shock")),
        "r": Given(result.strength, "", tr("strength at the beginning")),
        "beta": Given(result.decay, "", tr("decay of the strength")),
        "t_0": Given(result.threshold, "", tr("time up to which nothing fails")),
        "x_0": Given(min(result.strength, result.high), "", tr("strength from which on failures are possible")),
        "T": Given(result.mean, "", tr("mean life")),
    }
    if table.readings is not None:
        found["x_{(1)}"] = Given(min(table.readings), "", tr("least reading"))
        found["x_{(n)}"] = Given(max(table.readings), "", tr("largest reading"))
    if task.test is not None:
        margin = load_margin(task, task.test, result.decay)
        found["w"] = Given(margin, "", tr("auxiliary quantity of the strength"))
        found["x_m"] = Given(_weakest(result, task.test), "", tr("strength at the shortest life"))
    if result.floor is not None:
        found["t_a"] = Given(result.floor, "", tr("time from which on every shock is a failure"))
    return found


def _weakest(result: Reliability, test: LifeTest) -> float:
    law = Law(result.low, result.high, 1.0, result.strength, result.decay)
    return float(strength_at(law, np.array([test.least]))[0])


def _readings(readings: list[float], place: Place) -> Iterator[Block]:
    """The range of the loads from single readings."""
    yield Paragraph(
        tr(
            "Loads of single shocks: {readings}. They give these ends of the uniform load:",
            readings="; ".join(map(plainly, readings)),
        )
    )
    low = (READINGS[0],) if place.lexicon["a"].value else (CLIPPED,)
    yield from lines([*low, READINGS[1]], [place])


def _ends(result: Reliability, place: Place) -> Iterator[Block]:
    """When failures begin, and when every shock is one."""
    if result.threshold:
        yield Paragraph(tr("Until the strength has fallen to the largest load nothing fails:"))
        yield from lines([LONGEST], [place])
    else:
        yield Paragraph(tr("The strength begins not above the largest load, so failures are possible from the start."))
    if result.floor is None:
        yield Paragraph(tr("The load has no least value, so a shock may spare the product at any time."))
    elif result.floor:
        yield Paragraph(tr("From the time at which the strength is below the least load every shock is a failure:"))
        yield from lines([SURE], [place])


def _part(result: Reliability, t: float) -> int:
    if t <= result.threshold:
        return BEFORE
    return WITHIN if result.floor is None or t <= result.floor else AFTER


def _place(result: Reliability, law: Law, lexicon: Lexicon, t: float) -> Place:
    """A time with strength, intensity of failures, its integral, reliability and density."""
    at = np.array([t])
    total, rate, kept = float(hazard(law, at)[0]), float(failure_rate(law, at)[0]), _kept(law, t)
    found = {
        "t": Given(t, "", tr("time")),
        "x": Given(float(strength_at(law, at)[0]), "", tr("strength at this time")),
        "lambda": Given(rate, "", tr("intensity of failures")),
        "H": Given(total, "", tr("integral of the intensity of failures")),
        "R": Given(kept, "", tr("reliability")),
        "f": Given(rate * kept, "", tr("density of the life")),
    }
    if result.floor is not None:
        until = float(hazard(law, np.array([result.floor]))[0])
        found["H_a"] = Given(until, "", tr("its value when every shock becomes a failure"))
    return Place(tr("at t = {time}", time=plainly(t)), lexicon | named(found))


def _at_times(result: Reliability, law: Law, lexicon: Lexicon) -> Iterator[Block]:
    """Strength, intensity, reliability and density at the times that are asked for, else at the mean life."""
    asked = [t for t, _ in result.asked] or [result.mean]
    for part in (WITHIN, AFTER):
        if places := [_place(result, law, lexicon, t) for t in asked if _part(result, t) == part]:
            yield Paragraph(
                tr("The reliability falls by the integral of the intensity of failures:")
                if part == WITHIN
                else tr("Behind $t_a$, when every shock is a failure:")
            )
            texts = ["x = r*exp(-beta*t)", INTENSITY[part], HAZARD[part], "R = exp(-H)", "f = lambda*R"]
            yield from lines(texts if part == WITHIN else texts[1:], places)
    before = [plainly(t) for t in asked if _part(result, t) == BEFORE]
    if before:
        yield Paragraph(tr("No failure is possible yet, $R$ = 1, at the times {times}.", times="; ".join(before)))


def _mean(result: Reliability, law: Law, place: Place) -> Iterator[Block]:
    """The mean life in closed form."""
    yield Heading(tr("Mean life"), 3)
    begun, end = min(result.strength / result.high, 1.0), result.low / result.high
    if begun <= end:
        yield Paragraph(
            tr("Every shock is a failure from the start, so the mean life is the mean time between shocks:")
        )
        yield from lines(["T = 1/h"], [place])
        return
    yield Paragraph(tr("The mean life is the integral of the reliability over the time:"))
    floor = result.floor
    lexicon = place.lexicon | named(
        {
            "c": Given(law.rate * law.high / ((law.high - law.low) * law.decay), "", tr("parameter of this integral")),
            "I": Given(falling_part(law), "", tr("integral of the reliability while a shock may be a failure or not")),
            "R_a": Given(
                0.0 if floor is None else _kept(law, floor), "", tr("reliability when every shock becomes a failure")
            ),
        }
    )
    yield from lines(["T = t_0 + I/beta + R_a/h"], [Place("", lexicon)])
    yield Paragraph(
        tr(
            "The integral $I$ has a closed form with lower incomplete gamma functions $gamma_0$ of $c*x_0/b$ and "
            "$gamma_a$ of $c*a/b$, both of the order $c$, which is worked out with logarithms:"
        )
    )
    yield from lines(["c = h*b/((b - a)*beta)"], [Place("", lexicon)])
    yield Display(read("I = exp(c*x_0/b)*(c*x_0/b)**(-c)*(gamma_0 - gamma_a)"))


def _kept(law: Law, t: float) -> float:
    return float(np.exp(-hazard(law, np.array([t]))[0]))


def _lives(result: Reliability, law: Law, lexicon: Lexicon) -> Iterator[Block]:
    """Lives at given reliabilities, with the equation that each of them keeps."""
    yield Heading(tr("Lives"), 3)
    yield Paragraph(
        tr(
            "The time up to which the product survives with the reliability $R$ is found numerically from "
            "$H = ln(1/R)$; table {tab:reliability_lives} has these lives. Check:"
        )
    )
    for part in (WITHIN, AFTER):
        places = [_place(result, law, lexicon, life) for _, life in result.lives if _part(result, life) == part]
        if places:
            yield from lines([HAZARD[part]], places)
    kept, lives = zip(*result.lives, strict=True)
    columns = {"$ln(1/R)$": -np.log(kept), "$t$": np.array(lives)}
    labels = [plainly(each) for each in kept]
    yield tabulated(tr("Lives"), columns, labels, head="$R$", key="reliability_lives")


def _course(result: Reliability) -> Iterator[Block]:
    """The table and the diagram."""
    yield Paragraph(
        tr("Values over the time are in table {tab:reliability_course}, diagrams in figure {fig:reliability}.")
    )
    columns = {
        "$t$": result.t,
        "$x$": result.x,
        "$lambda$": result.intensity,
        "$R$": result.kept,
        "$f$": result.density,
    }
    draw = partial(draw_reliability, result=result)
    yield drawn(tr("Reliability, density of the life, intensity of failures"), draw, FIGURE, "reliability")
    yield course(tr("Reliability over the time"), columns, "reliability_course")
