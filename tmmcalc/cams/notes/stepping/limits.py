"""Limits of lambda and of the step, which B decides; the centre distance and what is chosen (2), (7) to (11)."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, isclose

from tmmcalc.cams.indexing.choice import ABOVE, EQUAL, TIGHT
from tmmcalc.cams.notes.stepping.quantities import Stepping
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Result, Table
from tmmcalc.report.telling import lines, named

FIGURES = 5  # digits of a side of a condition


def limits(of: Stepping) -> Iterator[Block]:
    """The limits in their order, the conditions with both sides."""
    found, place = of.found, of.place
    yield Heading(tr("Centre distance and angle of the step"), 3)
    yield from lines(["beta_m = deg(360)/z_2", "beta_0 = deg(180)/z_2"], place)
    yield from _dwells(of)
    yield Paragraph(tr("The groove does not cross itself, and its profile has no point, where $lambda$ is above"))
    yield from lines(["lambda_min = 1 + deg(360)*B/(z_2*phi_p)", "a_min = lambda_min*l_k"], place)
    if found.bounds.ratio_max is None:
        yield Paragraph(tr("The pressure angle at the start of the step stays below its limit for every $lambda$."))
    else:
        yield Paragraph(tr("The pressure angle at the start of the step is within its limit where $lambda$ is below"))
        yield from lines(["lambda_max = cos(theta_d)/cos(beta_0 + theta_d)"], place)
    yield from _ratio(of)
    yield Paragraph(tr("In a dwell the rollers beside the line of centres stand at"))
    texts = ("delta_0 = atan2(sin(beta_0), lambda - cos(beta_0))", "R_0 = sqrt(a**2 + l_k**2 - 2*a*l_k*cos(beta_0))")
    yield from lines(texts, place)
    yield Paragraph(tr("The step begins with the pressure angle"))
    yield from lines(["vartheta_1m = deg(90) - delta_0 - beta_0"], place)
    yield Paragraph(tr("With this $lambda$ the limits of the step are"))
    yield from lines(["phi_pmin = deg(360)*B/(z_2*(lambda - 1))", "phi_pmax = deg(180) - 2*delta_0"], place)
    yield from _conditions(of)


def _dwells(of: Stepping) -> Iterator[Block]:
    """The dwells that two steps leave of a turn."""
    if of.found.dwells is None:
        yield Paragraph(tr("A turn of the cams has two steps and two equal dwells:"))
        yield from lines(["phi_d = deg(180) - phi_p"], of.place)
    else:
        yield Paragraph(tr("A turn of the cams has two steps and two dwells, the first of which is given:"))
        yield from lines(["phi_d2 = deg(360) - 2*phi_p - phi_d1"], of.place)


def _ratio(of: Stepping) -> Iterator[Block]:
    """lambda as it is given or chosen, and the centre distance."""
    if of.task.ratio is not None:
        yield Paragraph(tr("The centre distance is given:"))
        yield from lines(["lambda = a/l_k"], of.place)
        return
    least, most = of.found.bounds.ratio_min, of.found.bounds.ratio_max or 0.0
    ways = {
        f"{ABOVE:g}*lambda_min": (ABOVE * least, tr("near the least pressure angle and clear of the point")),
        "(lambda_min + lambda_max)/2": ((least + most) / 2, tr("in the middle of its limits")),
        "lambda_max": (most, tr("as large as the pressure angle allows")),
        f"{TIGHT:g}*lambda_min": (TIGHT * least, tr("just clear of the point, because the limits leave no room")),
    }
    chosen, why = next((text, why) for text, (value, why) in ways.items() if isclose(value, of.found.ratio))
    yield Paragraph(tr("$lambda$ is chosen {why}:", why=why))
    yield from lines([f"lambda = {chosen}", "a = lambda*l_k"], of.place)


def _conditions(of: Stepping) -> Iterator[Block]:
    """Both limits of lambda and of the step, or of the shorter dwell."""
    found, held = of.found, of.found.bounds
    ratio, least = named(of.lexicon)["lambda"], "<="
    rows = [_row("lambda >= lambda_min", found.ratio, held.ratio_min)]
    yield Result("lambda", ratio, held.ratio_min, ">=")
    if held.ratio_max is not None:
        rows.append(_row("lambda <= lambda_max", found.ratio, held.ratio_max))
        yield Result("lambda", ratio, held.ratio_max, least)
    rows.append(_row("phi_p >= phi_pmin", degrees(found.step), degrees(found.step_min), "deg"))
    if found.dwells is None:
        rows.append(_row("phi_p <= phi_pmax", degrees(found.step), degrees(found.step_max), "deg"))
    else:
        name = f"phi_d{1 + found.dwells.index(min(found.dwells))}"
        rows.append(_row(f"{name} >= 2*delta_0", degrees(min(found.dwells)), degrees(2 * found.start_angle), "deg"))
    yield Paragraph(tr("The conditions with both of their sides are in table {tab:indexing_limits}."))
    head = tr("Condition"), tr("In numbers"), tr("Verdict")
    yield Table(tr("Conditions of the indexing drive"), head, tuple(rows), "indexing_limits")


def _row(condition: str, value: float, limit: float, unit: str = "") -> tuple[str, str, str]:
    """A condition in letters, in numbers, and whether it is kept."""
    sign = ">=" if ">=" in condition else "<="
    room = limit * (1 - EQUAL) if sign == ">=" else limit * (1 + EQUAL)
    kept = value >= room if sign == ">=" else value <= room
    sides = [f"deg({text})" if unit else text for text in (significant(each, FIGURES) for each in (value, limit))]
    return f"${condition}$", f"${sides[0]} {sign} {sides[1]}$", tr("kept") if kept else tr("not kept")
