"""The pairs of gears: given data, shifts, every size with its formula, contact, conditions, measures, parameters."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from tmmcalc.gears.facts.meshes import USUAL
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import NOISE, MeshPair
from tmmcalc.gears.notes.pairs.choice import chosen
from tmmcalc.gears.notes.pairs.conditions import judged
from tmmcalc.gears.notes.pairs.contact import contact, interference, quality
from tmmcalc.gears.notes.pairs.lexicon import CUTTER, Told, indexed, shortened, told_of
from tmmcalc.gears.notes.pairs.measured import measured, quantities
from tmmcalc.gears.notes.pairs.sizes import SECTION, circles, teeth
from tmmcalc.gears.notes.pairs.tables import of_wheels, parameters
from tmmcalc.gears.pictures.pieces import draw_curves, draw_to_scale
from tmmcalc.gears.pictures.placedpair import placed_pair
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph, Result
from tmmcalc.report.telling import WIDE, named

GIVEN = ("z_1", "z_2", "m", "alpha", "h_a^{*}", "c^{*}", "beta", "b", *CUTTER)
REFERENCE, TOTAL = "a = m*<z>/(2*cos(beta))", "x_Sigma = x_1 + x_2"
BY_SHIFTS = "inv(alpha_tw) = inv(<t>) <+> 2*x_Sigma*tan(alpha)/<z>"
BY_DISTANCE = (
    "alpha_tw = acos(a*cos(<t>)/a_w)",
    "x_Sigma = <z>*(<larger> - <smaller>)/(2*tan(alpha))",
)
INVERSE = "inv(alpha_tw) = tan(alpha_tw) - rad(alpha_tw)"
OPERATING = "a_w = a*cos(<t>)/cos(alpha_tw)"
MODIFIED, SHORTENED = "y = (a_w - a)/m", "Deltay = x_Sigma - y"
COMMON = (
    *("m", "alpha", "h_a^{*}", "c^{*}", "beta", "b", "alpha_tw", "H", "p_b", "g_alpha"),
    "eps_alpha",
)
WHEELED = "a", "a_w", "x_Sigma", "y", "u", "g"  # not of a rack
HELICAL = "m_t", "alpha_t", "beta_b"
WHEELS = (
    *("z", "x", "r", "r_w", "r_a", "r_f", "r_b", "r_F", "d", "d_w", "d_a", "d_f", "d_b", "h"),
    *("s_n", "s", "s_t", "s_na", "s_a", "x_min", "alpha_a", "z_w", "W", "s_c", "h_c", "D", "M"),
)
MESH, CURVES = (WIDE, 125.0), (WIDE, 105.0)  # sizes of the pictures [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Every pair, one after another."""
    for k, found in enumerate(order.results["pair"].pairs, 1):
        yield from _pair(told_of(found), f"pair{k}")


def _pair(told: Told, key: str) -> Iterator[Block]:
    found, task = told.found, told.found.task
    yield Heading(title_of(found))
    yield from _data(told, key)
    if task.kind != "rack":
        yield Heading(tr("Shifts and centre distance"), 3)
        yield from told.lines(*SECTION * bool(task.helix))
        yield from _distance(told)
    yield Heading(tr("Circles and teeth"), 3)
    if task.kind == "rack":
        yield from told.lines(*SECTION * bool(task.helix))
    yield from circles(told)
    for wheels in told.wheels:
        yield from teeth(wheels, helical=bool(task.helix))
    yield Heading(tr("Contact"), 3)
    yield from contact(told)
    yield from quality(told)
    yield from interference(told)
    yield from _pictures(found, key)
    yield Heading(tr("Conditions"), 3)
    names = (task.wheels[0], tr("rack") if task.kind == "rack" else task.wheels[1])
    yield from judged(found.checks, told.lexicon, told.words, names, f"{key}_quality")
    yield Heading(tr("Measures"), 3)
    for wheels in told.wheels:
        numbers = wheels.numbers
        yield from measured(wheels, [found.measures[k] for k in numbers], [task.measuring_of(k + 1) for k in numbers])
    yield from _parameters(told, key)
    place = "/".join(str(teeth) for teeth in task.teeth if teeth)
    if "a_w" in told.lexicon:
        yield Result("a_w", told.lexicon["a_w"], place=place)
    yield Result("eps_alpha", told.lexicon["eps_alpha"], task.limits.contact_ratio, ">=", place)


def title_of(found: MeshPair) -> str:
    """The pair by its name, its kind and its teeth."""
    task = found.task
    first, second = task.teeth
    if task.kind == "rack":
        said = tr("Rack and pinion, z = {teeth}", teeth=first)
    elif task.kind == "internal":
        said = tr("Internal pair {teeth}", teeth=f"{first}/{second}")
    else:
        said = tr("External pair {teeth}", teeth=f"{first}/{second}")
    return f"{said} ({tr_name(task.name)})" if task.name else said


def _data(told: Told, key: str) -> Iterator[Block]:
    """What is given, and how the shifts are chosen."""
    found, task = told.found, told.found.task
    names = [*GIVEN, *(f"x_{k}" for k, shift in enumerate(task.shifts[: len(found.sizes)], 1) if shift is not None)]
    if task.strategy == "given_aw":
        names.append("H" if task.kind == "rack" else "a_w")
    names += [f"r_a{k}" for k, tip in enumerate(task.tips[: len(found.sizes)], 1) if tip is not None]
    yield Paragraph(tr("The given data of the pair are in table {table}.", table=f"{{tab:{key}_data}}"))
    yield parameters(tr("Given data of the pair"), names, told.lexicon, f"{key}_data")
    if task.wheels != USUAL:
        first, second = task.wheels
        yield Paragraph(
            tr("Index 1 is that of wheel {first}, index 2 that of wheel {second}.", first=first, second=second)
        )
    if task.kind == "internal":
        yield Paragraph(tr("A positive shift of the ring makes its teeth thicker."))
    yield Paragraph(chosen(task))


def _distance(told: Told) -> Iterator[Block]:
    """The shifts with the pressure angle and the centre distance that belong to them."""
    found, task = told.found, told.found.task
    yield from told.lines(REFERENCE)
    if task.strategy == "given_aw":
        yield from told.lines(*BY_DISTANCE)
        yield from told.lines("x_1 = x_Sigma - x_2" if task.shifts[1] is not None else "x_2 = x_Sigma - x_1")
    elif abs(found.shift_sum) > NOISE:
        yield from told.lines(TOTAL, BY_SHIFTS)
        yield Paragraph(
            tr("The angle is found by its involute function, as the table of it or Newton’s method gives it:")
        )
        yield from told.lines(INVERSE, OPERATING)
    if abs(found.shift_sum) > NOISE:
        yield from told.lines(MODIFIED, *(SHORTENED,) * (task.kind == "external"))
    else:
        yield Paragraph(
            tr(
                "The sum of the shifts is nothing: the pitch circles are the reference circles, {relations}.",
                relations=f"$a_w = a$, $alpha_tw = {told.words['t']}$",
            )
        )


def _parameters(told: Told, key: str) -> Iterator[Block]:
    """The tables of all parameters."""
    found, task = told.found, told.found.task
    yield Paragraph(
        tr(
            "The parameters of the pair are in table {common}, those of the wheels in table {wheels}.",
            common=f"{{tab:{key}_common}}",
            wheels=f"{{tab:{key}_wheels}}",
        )
    )
    names = [*COMMON, *HELICAL * bool(task.helix), *WHEELED * (task.kind != "rack")]
    names += ["Deltay"] * (task.kind == "external")
    names += [*["eps_beta", "eps_gamma"] * bool(found.overlap), *["eps'_alpha"] * shortened(found)]
    yield parameters(tr("Parameters of the pair"), names, told.lexicon, f"{key}_common")
    yield of_wheels(
        tr("Parameters of the wheels"), WHEELS, _wheels(told), task.wheels[: len(found.sizes)], f"{key}_wheels"
    )


def _pictures(found: MeshPair, key: str) -> Iterator[Block]:
    """The mesh and the course of sliding, where both wheels have profiles."""
    if all(fault_of(member) is None for member in both(found)):
        yield Paragraph(
            tr(
                "Figure {mesh} shows the mesh, figure {sliding} sliding and pressure along the line of action.",
                mesh=f"{{fig:{key}_mesh}}",
                sliding=f"{{fig:{key}_sliding}}",
            )
        )
        yield Figure(tr("Mesh of the pair"), partial(draw_to_scale, found=found), MESH, f"{key}_mesh")
        caption = tr("Specific sliding and specific pressure")
        yield Figure(caption, partial(draw_curves, placed=placed_pair(found)), CURVES, f"{key}_sliding")


def _wheels(told: Told) -> list[Lexicon]:
    """All quantities of each wheel by names without an index."""
    both = zip(told.own, told.found.measures, strict=True)
    return [named(indexed(own | quantities(measures), "", told.words)) for own, measures in both]
