"""All requirements with both of their sides, what is left of the limit, and what follows from it."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from tmmcalc.cams.notes.loaded.judged import Judging
from tmmcalc.cams.strength.results import OK, OPEN, Margin
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Result, Table
from tmmcalc.report.telling import column_of

FIGURES = 5  # digits of a side
UNITS = {"m": ("mm", 1e3), "Pa": ("MPa", 1e-6), "1/m": ("1/mm", 1e-3), "": ("", 1.0)}
CONDITIONS = {  # of a requirement: its sides in letters, the sign between them
    "no slip": ("D", "<=", "1"),
    "no undercut": ("r_2 + r_m", "<=", "rho_2"),
    "convex profile": ("r_m - F_min", "<=", "S_0"),
    "concave parts": ("rho_1 + r_2", ">=", "r_i"),
    "outer wall": ("r_2 + r_m", "<=", "rho_1"),
    "rule of the roller": ("r_2", "<=", "min(0.4*R_0, 0.7*rho_2)"),
    "roller unit": ("r_2^{*}", "<=", "r_2"),
    "pressure on the pin": ("p_0", "<=", "p_0P"),
    "shaft strength": ("r'_1", "<=", "r_1"),
    "shaft stiffness": ("r''_1", "<=", "r_1"),
    "bending of the stem": ("sigma_F", "<=", "sigma_FP"),
    "pressure in the guide": ("p_g", "<=", "p_gP"),
    "contact stress": ("sigma_H", "<=", "sigma_HP"),
}
SMOOTH = ("kappa", ">=", "0")  # where concave parts are not allowed
SHAPE = ("no undercut", "convex profile", "concave parts", "outer wall")  # the profile is told of before
PERCENT = 100


def margins(of: Judging) -> Iterator[Block]:
    """The table of the requirements that have data, and whether they hold."""
    shown = [each for each in of.found.margins if each.value is not None and each.limit is not None]
    slips = [each for each in of.found.margins if each.verdict == "slip" and each.value is None]
    yield Heading(tr("Requirements"), 3)
    yield Paragraph(
        tr(
            "Table {tab:cam_margins} compares every requirement with its limit. Here $rho_1$ and $rho_2$ are the least "
            "radii of curvature of the concave and convex parts of the pitch curve; the margin is what is left of the "
            "limit."
        )
        if of.of.kind != "flat"
        else tr(
            "Table {tab:cam_margins} compares every requirement with its limit. Here $F_min$ is the least sum of the "
            "displacement and its second derivative; the margin is what is left of the limit."
        )
    )
    concave = next((each for each in shown if each.name == "concave parts"), None)
    if concave is not None:
        yield Paragraph(concave_margin_said(smooth=concave.symbol == "kappa"))
    head = (tr("Requirement"), tr("Condition"), tr("In numbers"), tr("Margin of the limit, %"), tr("Verdict"))
    yield Table(tr("Requirements and their limits"), head, tuple(_row(of, each) for each in shown), "cam_margins")
    for each in slips:
        yield Paragraph(
            tr(
                "The force of the cam passes through zero at $phi$ = {angle}°, where the roller cannot roll without "
                "slip.",
                angle=spelt(f"{degrees(each.phi or 0.0):.6g}"),
            )
        )
    broken = [each for each in (*shown, *slips) if each.verdict not in (OK, OPEN)]
    decisive = [name_of(each) for each in broken if not each.advice]
    advised = [name_of(each) for each in broken if each.advice]
    if decisive:
        yield Paragraph(tr("Requirements that are not kept: {names}.", names=", ".join(decisive)))
    else:
        yield Paragraph(tr("All requirements are kept."))
    if advised:
        yield Paragraph(tr("Recommendations that are not kept: {names}.", names=", ".join(advised)))
    yield from _results(of, shown)


def concave_margin_said(*, smooth: bool) -> str:
    """By what the margin of concave parts is measured: their radius may be far below its limit."""
    if smooth:
        return tr("The margin of concave parts is measured by their curvature: it is $kappa*R_0$.")
    return tr("The margin of concave parts is measured by their curvature: it is $1 - (r_i - r_2)/rho_1$.")


def name_of(margin: Margin) -> str:
    """A requirement in the language in force."""
    own = {
        "no slip": tr("rolling without slip"),
        "outer wall": tr("outer wall of the groove"),
        "rule of the roller": tr("recommended radius of the roller"),
        "roller unit": tr("roller on its pin"),
        "shaft strength": tr("strength of the camshaft"),
        "shaft stiffness": tr("stiffness of the camshaft"),
        "clearance of the shaft": tr("clearance of the camshaft"),
    }
    return own.get(margin.name) or tr_name(margin.name)


def condition_of(of: Judging, margin: Margin) -> tuple[str, str, str]:
    """Both sides in letters with the sign between them."""
    if margin.name == "clearance of the shaft":
        radius = "r_1" if of.of.task.limits.shaft >= (of.found.shaft.radius if of.found.shaft else 0.0) else "r_1^{*}"
        return (radius, "<=", "S_0") if of.of.kind == "flat" else (f"r_2 + {radius}", "<=", "R_0")
    return SMOOTH if margin.symbol == "kappa" else CONDITIONS[margin.name]


def _row(of: Judging, margin: Margin) -> tuple[str, ...]:
    left, sign, right = condition_of(of, margin)
    unit, factor = UNITS[margin.unit]
    assert margin.value is not None
    assert margin.limit is not None
    sides = [significant(factor * side, FIGURES) for side in (margin.value, margin.limit)]
    broken = margin.verdict not in (OK, OPEN)
    shown = {"<=": ">", ">=": "<"}[sign] if broken else sign
    numbers = f"${sides[0]} {shown} {sides[1]}$" + (f" {tr_unit(unit)}" if unit else "")
    left_over = "" if margin.margin is None else column_of([PERCENT * margin.margin], 4)[0]
    verdict = tr("not kept") if broken else tr("kept")
    if margin.advice and broken:
        verdict = tr("not recommended")
    return name_of(margin), f"${left} {sign} {right}$", numbers, left_over, verdict


def _results(of: Judging, shown: list[Margin]) -> Iterator[Block]:
    """The requirements that decide, for the conclusions; those of the profile stand there with it."""
    for margin in shown:
        if margin.advice or margin.name in SHAPE:
            continue
        left, sign, _ = condition_of(of, margin)
        unit, factor = UNITS[margin.unit]
        value, limit = float(factor * (margin.value or 0.0)), float(factor * (margin.limit or 0.0))
        yield Result(left, Given(value, unit, name_of(margin)), limit, sign)
