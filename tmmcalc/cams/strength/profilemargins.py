"""Margins of the profile: no cusp, what the tool reaches, the guide-book's rule for the roller."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.strength.case import Case
from tmmcalc.cams.strength.formulas import concave_margin, convex_margin, unused
from tmmcalc.cams.strength.results import OK, OPEN, Margin, judged

RULE_BASE, RULE_SHARP = 0.4, 0.7  # of R0 and of the least radius of curvature


def shape_margins(case: Case) -> Iterator[Margin]:
    """Constraints 3 and 4, the outer wall of a groove, the rule of the roller."""
    if case.flat:
        yield _flat(case)
        return
    yield _convex(case)
    yield _concave(case)
    if case.grooved:
        yield _outer_wall(case)
    yield _rule(case)


def _flat(case: Case) -> Margin:
    """S0 >= r_m - F_min with F = dS + S'' (5.97)."""
    start, least = case.follower.start, case.task.limits.convex
    value = start + least - case.bend.least
    return judged(
        "convex profile", 3, "S0 >= r_m - F_min, rho = S0 + dS + S'' (5.97)", "S0_min", "m", value, start,
        float(unused(value, start)), case.bend.least_phi, "undercut",
    )  # fmt: skip


def _convex(case: Case) -> Margin:
    roller, least, bend = case.follower.roller, case.task.limits.convex, case.bend
    name, formula = "no undercut", "r2 + r_m <= rho2 (5.39)"
    if bend.largest <= 0:
        return Margin(name, 3, OK, formula, why="the pitch curve has no convex part")
    margin = float(convex_margin(bend.largest, roller, least))
    return judged(
        name, 3, formula, "r2 + r_m", "m", roller + least, 1 / bend.largest, margin, bend.largest_phi, "undercut"
    )


def _concave(case: Case) -> Margin:
    limits, bend, roller = case.task.limits, case.bend, case.follower.roller
    name, formula = "concave parts", "rho1 + r2 >= r_i (5.41)"
    if bend.least >= 0:
        return Margin(name, 4, OK, formula, why="the profile has no concave part")
    if not limits.allow_concave:
        margin, why = bend.least * case.follower.base, "concave parts are not allowed"
        fault = "tool_interference"
        return Margin(name, 4, fault, "kappa >= 0", "kappa", "1/m", bend.least, 0.0, margin, bend.least_phi, why)
    if case.grooved:
        return Margin(name, 4, OPEN, formula, why="a groove is milled by a tool as large as the roller")
    value = roller - 1 / bend.least
    margin = float(concave_margin(bend.least, roller, limits.concave))
    return judged(
        name, 4, formula, "rho1 + r2", "m", value, limits.concave, margin, bend.least_phi, "tool_interference"
    )


def _outer_wall(case: Case) -> Margin:
    """The same as (5.39) of the wall that bulges where the pitch curve is concave."""
    roller, least, bend = case.follower.roller, case.task.limits.convex, case.bend
    name, formula = "outer wall", "r2 + r_m <= rho1"
    if bend.least >= 0:
        return Margin(name, None, OK, formula, why="the profile has no concave part")
    margin = float(convex_margin(-bend.least, roller, least))
    return judged(
        name, None, formula, "r2 + r_m", "m", roller + least, -1 / bend.least, margin, bend.least_phi, "undercut"
    )


def _rule(case: Case) -> Margin:
    """r2 <= min(0.4 R0; 0.7 rho_min), a recommendation."""
    roller, base = case.follower.roller, case.follower.base
    sharp = 1 / case.bend.largest if case.bend.largest > 0 else float("inf")
    limit = min(RULE_BASE * base, RULE_SHARP * sharp)
    formula = "r2 <= min(0.4 R0; 0.7 rho_min)"
    margin = float(unused(roller, limit))
    verdict = OK if margin >= 0 else "exceeded"
    return Margin("rule of the roller", None, verdict, formula, "r2", "m", roller, limit, margin, None, "", True)
