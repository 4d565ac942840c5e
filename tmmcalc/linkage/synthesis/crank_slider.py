"""Slider-crank from its stroke, time ratio, pressure angles or ratios of its sizes.

       B
    r / ` . l           guide y = +e, slider to the right, crank counter-clockwise: on the working
A . . . . . . . .       stroke, from the far right to the near end, the pin is on the guide's side
     e      ` C ==
                        sin(nu_p) = (r - e)/l, sin(nu_x) = (r + e)/l where the crank stands across the guide
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Said, held
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.synthesis.builders import SliderCrank, slider_crank
from tmmcalc.linkage.synthesis.designs import ClosedForm, closed_form, scene_of
from tmmcalc.linkage.synthesis.results import PRESSURE, Check, Size, Synthesis
from tmmcalc.linkage.synthesis.simulation import check, simulate, tilts
from tmmcalc.linkage.synthesis.strokes import overlap, time_ratio
from tmmcalc.linkage.synthesis.task import SliderCrankTask, SynthesisTask
from tmmcalc.linkage.synthesis.triangle import (
    Demand,
    Overlap,
    Scaled,
    StraightLine,
    crossings,
    overlap_of,
    stroke_of,
)

RULE = "the least pressure angle over both strokes"
INDEPENDENT = 3  # sizes that a slider-crank has


def solve(task: SynthesisTask) -> Synthesis:
    """All slider-cranks that have the sizes asked for; raises `NoSolutionError` if none turns fully."""
    asked: SliderCrankTask = task.asked
    demands = list(_demands(asked))
    if len(demands) != INDEPENDENT - 1 or _scale(asked, 0.5, 0.0) is None:
        raise UsageError(
            f"{len(demands) + 1} independent sizes are given, a slider-crank needs {INDEPENDENT} with one length",
            where="synthesis.slider_crank",
            value=float(len(demands) + 1),
            limit=float(INDEPENDENT),
            remedy="give the stroke and two ratios or angles, for example",
        )
    found = crossings(demands[0], demands[1])
    if not found:
        raise NoSolutionError(
            "no slider-crank that turns fully (r + |e| < l) has these sizes",
            where="synthesis.slider_crank",
            remedy="take a time ratio nearer to 1, a longer rod, or larger pressure angles",
        )
    designs = [_closed(task, asked, *place) for place in sorted(found, key=lambda place: place[0] + abs(place[1]))]
    return closed_form(task, "slider_crank", RULE, designs)


def _demands(asked: SliderCrankTask) -> Iterator[Demand]:
    """What holds of lambda and kappa: one less than the sizes that are given, for one of them is the scale."""
    ratios: dict[str, Callable[[float], Demand]] = {
        "crank_ratio": (lambda v: StraightLine(1.0, 0.0, v)),
        "offset_ratio": (lambda v: StraightLine(-v, 1.0, 0.0)),
        "pressure_working": (lambda v: StraightLine(1.0, -1.0, math.sin(v))),
        "pressure_idle": (lambda v: StraightLine(1.0, 1.0, math.sin(v))),
        "time_ratio": (lambda v: Overlap(overlap(v)) if v != 1 else StraightLine(0.0, 1.0, 0.0)),
        "offset_part": (lambda v: Scaled(lambda lam, kappa: kappa, v) if v else StraightLine(0.0, 1.0, 0.0)),
    }
    known = asked.offset_part is not None and asked.stroke is not None and bool(asked.crank or asked.rod)
    for name, make in ratios.items():
        value = getattr(asked, name)
        if value is not None and not (known and name == "offset_part"):
            yield make(value)
    yield from _lengths(asked, (asked.offset_part or 0.0) * (asked.stroke or 0.0) if known else asked.offset)


def _lengths(asked: SliderCrankTask, offset: float | None) -> Iterator[Demand]:
    """Ratios of the lengths that are given, the offset among them or e/S times the stroke."""
    r, l, e, stroke = asked.crank, asked.rod, offset, asked.stroke
    if e == 0:
        yield StraightLine(0.0, 1.0, 0.0)
        e = None
    if r is not None and l is not None:
        yield StraightLine(1.0, 0.0, r / l)
    if e is not None and (l is not None or r is not None):
        yield StraightLine(0.0, 1.0, e / l) if l is not None else StraightLine(-e / (r or 1.0), 1.0, 0.0)
    if stroke is None:
        return
    if l is not None:
        yield Scaled(lambda lam, kappa: 1 + 0 * lam, l / stroke)
    elif r is not None:
        yield Scaled(lambda lam, kappa: lam, r / stroke)
    elif e is not None:
        yield Scaled(lambda lam, kappa: kappa, e / stroke)


def _scale(asked: SliderCrankTask, lam: float, kappa: float) -> float | None:
    """Length of the rod by the first length that gives it."""
    if asked.stroke is not None:
        return asked.stroke / float(stroke_of(lam, kappa))
    if asked.rod is not None:
        return asked.rod
    if asked.crank is not None:
        return asked.crank / lam
    return asked.offset / kappa if asked.offset and kappa else asked.offset or None


def _closed(task: SynthesisTask, asked: SliderCrankTask, lam: float, kappa: float) -> ClosedForm:
    """The design at one place of the plane, checked by its simulation."""
    l = _scale(asked, lam, kappa) or math.nan
    r, e = lam * l, kappa * l
    if asked.offset == 0 or kappa == 0:
        e = 0.0
    psi = float(overlap_of(lam, kappa))
    stroke, ratio = l * float(stroke_of(lam, kappa)), time_ratio(psi)
    scene = scene_of(task, stroke, ratio, Output("C", resistance="positive"))
    mechanism = slider_crank(SliderCrank(0j, r, l, 1j * e), scene)
    found = simulate(mechanism)
    working, idle = tilts(found, 2, 1 + 0j)
    sizes = (
        Size("r", r, "m", "crank AB"),
        Size("l", l, "m", "connecting rod BC"),
        Size("e", e, "m", "offset of the guide"),
        Size("lambda", lam, "-", "r/l"),
        Size("eps", kappa / lam, "-", "e/r"),
        Size("eps_lambda", kappa, "-", "e/l"),
        Size("psi", psi, "rad", "overlap angle"),
        Size("phi_zero", math.asin(e / (l + r)), "rad", "crank at the far end of the stroke"),
        Size("phi_second", math.pi + math.asin(e / (l - r)), "rad", "crank at the near end of the stroke"),
    )
    checks = list(_checks(asked, found.stroke, found.time_ratio, (r, l, e)))
    nu_p, nu_x = -min(working.stationary), max(idle.stationary)
    checks += [
        check("nu_p", nu_p, "rad", asked.pressure_working),
        check("nu_x", nu_x, "rad", asked.pressure_idle),
        check("largest pressure angle working", working.largest, "rad"),
        check("largest pressure angle idle", idle.largest, "rad"),
    ]
    merits = {PRESSURE.key: math.degrees(max(working.largest, idle.largest)), "r/l": lam, "e/r": kappa / lam}
    notes = tuple(_notes(asked, e, working.largest, idle.largest))
    return ClosedForm("slider-crank", sizes, tuple(checks), merits, mechanism, found, notes)


def _checks(
    asked: SliderCrankTask, stroke: float, ratio: float, lengths: tuple[float, float, float]
) -> Iterator[Check]:
    """Stroke and time ratio of the simulation, and the ratios of lengths that were asked for."""
    r, l, e = lengths
    yield check("S", stroke, "m", asked.stroke)
    yield check("K", ratio, "-", asked.time_ratio)
    given = (
        ("r", r, "m", asked.crank),
        ("l", l, "m", asked.rod),
        ("e", e, "m", asked.offset),
        ("lambda", r / l, "-", asked.crank_ratio),
        ("eps", e / r, "-", asked.offset_ratio),
        ("e/S", e / stroke, "-", asked.offset_part),
    )
    yield from (check(name, value, unit, target) for name, value, unit, target in given if target is not None)


def _notes(asked: SliderCrankTask, e: float, working: float, idle: float) -> Iterator[Said]:
    if e < 0:
        yield "warning: e < 0 and K < 1: the strokes exchange their roles, the working one is the faster"
    if asked.pressure_working is not None and working > asked.pressure_working * (1 + 1e-9) + 1e-12:
        text = (
            "at the ends of the stroke the pressure angle is {value:.4g} deg, more than nu_p where the crank stands "
            "across the guide"
        )
        numbers = math.degrees(working), math.degrees(asked.pressure_working), "deg"
        yield held("warning", text, *numbers, name="nu_p")
    if asked.pressure_idle is not None and idle > asked.pressure_idle * (1 + 1e-9) + 1e-12:
        text = "at an end of the idle stroke the pressure angle is {value:.4g} deg, more than nu_x"
        numbers = math.degrees(idle), math.degrees(asked.pressure_idle), "deg"
        yield held("warning", text, *numbers, name="nu_x")
