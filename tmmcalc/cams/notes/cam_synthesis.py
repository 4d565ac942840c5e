"""The chapter on cams, its second part: limits and given sizes, the least size, designs beside it, the roller."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import degrees, floor, isclose

import numpy as np

from tmmcalc.cams.notes.flatface import told_face
from tmmcalc.cams.notes.hung import hung
from tmmcalc.cams.notes.lexicon import (
    SHORT,
    Told,
    angle,
    degrees_of,
    dwell_of,
    mm,
    number,
    of_follower,
    quantities_table,
    told_of,
    where,
)
from tmmcalc.cams.notes.rocker import rocker_base, told_pivot, told_rocker
from tmmcalc.cams.notes.stem import stem_base, told_stem
from tmmcalc.cams.pictures.pieces import synthesis_pieces
from tmmcalc.cams.pictures.wording import design_name
from tmmcalc.cams.synthesis.candidates import SizeCandidate, candidates
from tmmcalc.cams.synthesis.completion import GIVEN, PIVOT_ROOM, WHOLE_NAME
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, headed, lines, number_of, pictured, titled

HIGH = 190.0  # of the picture of the region at most [mm]
RULES = {  # bounds of the roller's radius by the names that the synthesis gives them
    "0.4 R0": "0.4*R_0",
    "0.7 rho2": "0.7*rho_2",
    "rho2 - r_m": "rho_2 - r_m",
    "R0 - r1": "R_0 - r_1",
    "rho1 - r_m, second wall": "rho_1 - r_m",
}
LIMITS = "theta_P", "theta_{Pc}", "r_m", "r_i", "r_1"
SIZES = {  # names of the sizes in formulas
    "S0": "S_0",
    "e": "e",
    "R0": "R_0",
    "l0": "l_0",
    "l2": "l_2",
    "psi0": "psi_0",
    "r2": "r_2",
}


def blocks(order: Order) -> Iterator[Block]:
    """What is given, how the sizes follow, what other rules give, the roller."""
    told, result = told_of(order), order.results["cam_synthesis"]
    yield Heading(tr("Sizes of the cam"))
    lexicon = told.named(of_follower(told.follower) | of_limits(told))
    yield from _given(told, result, lexicon)
    if result.kind == "flat":
        yield from told_face(told, result, lexicon)
    else:
        sizes, base = (told_stem, stem_base) if result.kind == "translating" else (told_rocker, rocker_base)
        yield from sizes(told, result, lexicon)
        yield from _governed(result)
        yield from base(told, result, lexicon)
    yield from _designs(told, result)
    yield from _candidates(told, result)
    yield from _pictures(order)
    yield from _roller(told, result, lexicon)
    yield from told_pivot(told, result, lexicon)
    yield Heading(tr("Sizes taken"), 3)
    yield Paragraph(tr("The sizes taken are in table {tab:cam_sizes}."))
    names = [SIZES[size.symbol] for size in result.sizes]
    yield quantities_table(tr("Sizes of the cam and its follower"), names, lexicon, "cam_sizes")
    yield Result(*_main(result, lexicon))


def of_limits(told: Told) -> Lexicon:
    """The limits of pressure angles and radii, those that the cam has."""
    limits, flat = told.task.limits, told.follower.kind == "flat"
    found = {"r_m": mm(limits.convex, tr("least radius of curvature of convex parts of the profile"))}
    if limits.shaft:
        found["r_1"] = mm(limits.shaft, tr("radius of the camshaft"))
    if flat:
        return found
    found["theta_P"] = angle(limits.rise, tr("permissible pressure angle on the rise"))
    if limits.back is not None:
        found["theta_{Pc}"] = angle(limits.back, tr("permissible pressure angle on the return"))
    if limits.allow_concave:
        found["r_i"] = mm(limits.concave, tr("least radius of the tool for concave parts of the profile"))
    return found


def _given(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """Limits and sizes that are given."""
    yield Paragraph(tr("Limits and sizes that are given are in table {tab:cam_limits}."))
    sizes = [SIZES[size.symbol] for size in result.sizes if size.given]
    yield quantities_table(tr("Limits and given sizes"), (*LIMITS, *sizes), lexicon, "cam_limits")
    if result.kind != "flat" and told.task.limits.back is None:
        yield Paragraph(tr("On the return, where the closing force drives, the pressure angle is not limited."))
    if not told.task.limits.allow_concave:
        yield Paragraph(tr("The profile shall have no concave parts."))


def _governed(result: Synthesis) -> Iterator[Block]:
    """What decides the size where it is not the pressure angle."""
    said = {
        "curvature": tr("The cam is made larger for the radius of curvature of its convex parts."),
        "second wall": tr("The cam is made larger for the radius of curvature of the second wall of the groove."),
        "no concave parts": tr("The cam is made larger so that its profile has no concave parts."),
        "shaft": tr("The cam is made larger so that it has room for the camshaft."),
        PIVOT_ROOM: tr("The cam is placed so that it clears the pivot of the rocker."),
        GIVEN: tr("The sizes are given."),
    }
    if result.governs in said:
        yield Paragraph(said[result.governs])


def _designs(told: Told, result: Synthesis) -> Iterator[Block]:
    """The designs by several rules with the pressure angles that they reach, and whole millimetres."""
    whole = [result.rounded] if result.rounded is not None and result.kind != "flat" else []
    rows = [*_different(result.designs), *whole]
    if not rows:
        if result.rounded is not None:
            size = number(mm(result.rounded.start))
            yield Paragraph(tr("In whole millimetres $S_0$ is {size} mm.", size=size))
        return
    yield Paragraph(
        tr(
            "Table {tab:cam_designs} compares the sizes by several rules with the largest pressure angles that they "
            "reach on the rise, $theta_y$, and on the return, $theta_c$."
        )
    )
    columns: dict[str, list[float]] = {}
    if result.kind == "translating":
        columns["$S_0$, mm"] = [1e3 * each.start for each in rows]
        columns["$e$, mm"] = [1e3 * told.follower.sense * each.offset + 0.0 for each in rows]
    else:
        columns["$l_0$, mm"] = [1e3 * each.centres for each in rows]
        columns["$l_2$, mm"] = [1e3 * each.rocker for each in rows]
        columns["$psi_0$, deg"] = [degrees(each.start) for each in rows]
    columns["$R_0$, mm"] = [1e3 * each.base for each in rows]
    columns["$theta_y$, deg"] = [degrees(max(map(abs, each.rise))) for each in rows]
    columns["$theta_c$, deg"] = [degrees(max(map(abs, each.back))) for each in rows]
    cells = [[_rule(each, told.follower.sense) for each in rows], *(column_of(each) for each in columns.values())]
    head = tr("How they are chosen"), *(headed(name) for name in columns)
    yield Table(tr("Sizes by several rules"), head, tuple(zip(*cells, strict=True)), key="cam_designs")


def _different(designs: Iterable[Design]) -> Iterator[Design]:
    """The designs but those that have the sizes of one before them."""
    known: list[tuple[float, ...]] = []
    for each in designs:
        sizes = each.base, each.start, each.offset, each.centres, each.rocker
        if not any(np.allclose(sizes, other, equal_nan=True) for other in known):
            yield each
        known.append(sizes)


def _rule(design: Design, sense: int) -> str:
    return tr("In whole millimetres") if design.name == WHOLE_NAME else design_name(design, sense)


def _roller(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The bounds of its radius, and what is taken."""
    choice = result.roller
    if choice is None:
        return
    yield Heading(tr("Roller"), 3)
    place = where(choice.convex.phi, dwell_of(told.task.program, choice.convex.phi))
    said = tr("The least radius of convex parts of the pitch curve is $rho_2 = {convex}$ mm {where}",
              convex=significant(1e3 * choice.convex.value, SHORT), where=place)  # fmt: skip
    walled = any("rho_1" in RULES[rule.name] for rule in choice.rules)
    if choice.concave is not None and walled:
        said += tr(", that of concave parts $rho_1 = {concave}$ mm at $phi$ = {angle}°",
                   concave=significant(1e3 * choice.concave.value, SHORT),
                   angle=degrees_of(choice.concave.phi))  # fmt: skip
    yield Paragraph(f"{said}.")
    lexicon["rho_2"] = mm(choice.convex.value, tr("least radius of curvature of convex parts of the pitch curve"))
    if choice.concave is not None and walled:
        lexicon["rho_1"] = mm(choice.concave.value, tr("least radius of curvature of concave parts of the pitch curve"))
    yield Paragraph(tr("The radius of the roller is bounded by these rules:"))
    names = []
    for k, rule in enumerate(choice.rules, 1):
        name = f"r_{{2,{k}}}"
        lexicon[name] = mm(rule.value, tr("bound {number} of the radius of the roller", number=k))
        names.append(name)
        yield from lines((f"{name} = {RULES[rule.name]}",), [Place("", lexicon)])
    least = min(number_of(lexicon, name) for name in names)
    taken = number_of(lexicon, "r_2")
    found = next(size for size in result.sizes if size.symbol == "r2")
    if found.given:
        if taken <= least * (1 + 1e-9):
            yield Paragraph(tr("The given radius $r_2$ = {radius} mm is within all of them.", radius=_mm(taken)))
        else:
            yield Paragraph(
                tr("The given radius $r_2$ = {radius} mm is above the least of them, {least} mm.",
                   radius=_mm(taken), least=_mm(least))
            )  # fmt: skip
    elif isclose(floor(least), taken, abs_tol=1e-9):
        yield Paragraph(tr("The least of them is taken, rounded down to a whole millimetre:"))
        yield from lines((f"r_2 = floor(min({', '.join(names)}))",), [Place("", lexicon)])
    else:
        yield Paragraph(tr("The least of them is taken: $r_2$ = {radius} mm.", radius=_mm(taken)))


def _mm(value: float) -> str:
    return number(Given(value, "mm"))


def _candidates(told: Told, result: Synthesis) -> Iterator[Block]:
    """What every constraint alone asks of the size, where the size is found."""
    if result.governs == GIVEN:
        return
    found = list(candidates(told.task, result).values())
    stem, decided = result.kind != "oscillating", any(each.binds for each in found)
    yield Paragraph(tr("What each constraint alone asks of the size is in table {tab:cam_candidates}."))
    head = [tr("Constraint"), headed("$R_0$, mm"), *([headed("$S_0$, mm")] * stem), headed("$phi$, deg")]
    rows = [(*_candidate(each, stem), *([tr("yes") if each.binds else ""] * decided)) for each in found]
    head += [tr("Decides")] * decided
    yield Table(tr("Least sizes by the constraints"), tuple(head), tuple(rows), key="cam_candidates")


def _candidate(each: SizeCandidate, stem: bool) -> Iterator[str]:
    yield tr_name(each.constraint)
    for value in (each.base, each.start)[: 1 + stem]:
        yield "–" if value is None else number(mm(value)) if value else tr("any")
    yield "" if each.phi is None else degrees_of(each.phi)


def _pictures(order: Order) -> Iterator[Block]:
    """The admissible places of the axis of the cam."""
    first, *others = synthesis_pieces(order)
    if others:
        yield Paragraph(
            tr(
                "The admissible places of the axis of the cam are shown in figure {fig:cam_region}, the sum of the "
                "displacement and the analogue of acceleration in figure {fig:cam_convexity}."
            )
        )
    else:
        yield Paragraph(tr("The admissible places of the axis of the cam are shown in figure {fig:cam_region}."))
    yield hung(titled(first.heading), first.draw, HIGH, "cam_region")
    for piece in others:
        yield pictured(piece, key="cam_convexity")


def _main(result: Synthesis, lexicon: Lexicon) -> tuple[str, Given]:
    """The size that stands in the conclusions."""
    name = "S_0" if result.kind == "flat" else "R_0"
    return name, lexicon[name]
