"""The pairs of gears: given data, shifts, every size with its formula, contact, conditions, measures, parameters."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from tmmcalc.gears.facts.meshes import USUAL
from tmmcalc.gears.meshing.contours import PairContour
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import NOISE, MeshPair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.notes.pairs.choice import chosen
from tmmcalc.gears.notes.pairs.conditions import judged
from tmmcalc.gears.notes.pairs.contact import contact, interference, quality
from tmmcalc.gears.notes.pairs.lexicon import CUTTER, Told, indexed, shortened, told_of
from tmmcalc.gears.notes.pairs.measured import measured, quantities
from tmmcalc.gears.notes.pairs.sizes import SECTION, circles, teeth
from tmmcalc.gears.notes.pairs.tables import of_wheels, parameters
from tmmcalc.gears.pictures.pieces import draw_curves, draw_to_scale
from tmmcalc.gears.pictures.placedpair import placed_pair
from tmmcalc.gears.pictures.words import pair_name
from tmmcalc.gears.tables.tasks.open_pair import to_open_pair
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
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
SCALE = 2.8  # height of the letters of the scale of a mesh [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Every pair, one after another."""
    pairs, table, on_crank = order.results["pair"].pairs, order.spec.pair, to_open_pair(order.spec)
    contours = order.results["blocking"].pairs if "blocking" in order.results else ()
    for k, found in enumerate(pairs, 1):
        own = found.task
        same = (each for each in contours if (each.name, tuple(each.teeth)) == (own.name, tuple(own.teeth)))
        span = next((_span(each, found) for each in same), None)
        listed = (on_crank is not None and own == on_crank.pair) or (table is not None and not table.of_train)
        yield from _pair(told_of(found), span, f"pair{k}", _teeth(found.task) if pairs[1:] else "", listed=listed)


def _teeth(task: PairTask) -> str:
    return "/".join(str(teeth) for teeth in task.teeth if teeth)


def _span(contour: PairContour, found: MeshPair) -> tuple[float, float] | None:
    """How far x1 may go at the sum of shifts, of a pair that has the middle of it."""
    low, high = contour.low, contour.high
    free = found.task.strategy == "given_aw" and found.task.split == "middle" and found.task.shifts == (None, None)
    if not free or low is None or high is None or abs(found.shifts[0] - (low + high) / 2) > NOISE:
        return None
    return low, high


def _pair(told: Told, span: tuple[float, float] | None, key: str, of: str, *, listed: bool) -> Iterator[Block]:
    """A pair; ``of`` are its teeth where there are several, ``span`` the ends of x1 whose middle it has.

    ``listed``: its data are in the table of the task.
    """
    found, task = told.found, told.found.task
    yield Heading(title_of(found))
    if not listed:
        yield from _data(told, key, of)
    yield from _rule(task)
    if task.kind != "rack":
        yield Heading(tr("Shifts and centre distance"), 3)
        yield from told.lines(*SECTION * bool(task.helix))
        yield from _distance(told, span)
    yield Heading(tr("Circles and teeth"), 3)
    if task.kind == "rack":
        yield from told.lines(*SECTION * bool(task.helix))
    yield from circles(told)
    yield from teeth(told.shared, told.wheels, helical=bool(task.helix))
    yield Heading(tr("Contact"), 3)
    yield from contact(told)
    yield from quality(told)
    yield from interference(told)
    yield from _pictures(found, key, of)
    yield Heading(tr("Conditions"), 3)
    names = (task.wheels[0], tr("rack") if task.kind == "rack" else task.wheels[1])
    yield from judged(found.checks, told.lexicon, told.words, names, f"{key}_quality", of)
    yield Heading(tr("Measures"), 3)
    for wheels in told.wheels:
        numbers = wheels.numbers
        yield from measured(wheels, [found.measures[k] for k in numbers], [task.measuring_of(k + 1) for k in numbers])
    yield from _parameters(told, key, of)
    place = _teeth(task) if of else ""
    if "a_w" in told.lexicon:
        yield Result("a_w", told.lexicon["a_w"], place=place)
    wanted = next((check.limit for check in found.checks if check.name == "contact ratio"), task.limits.contact_ratio)
    yield Result("eps_alpha", told.lexicon["eps_alpha"], wanted, ">=", place)


def title_of(found: MeshPair) -> str:
    """The pair by its name, its kind and its teeth."""
    task = found.task
    first, second = task.teeth
    if task.kind == "rack":
        said = tr("Rack and pinion, $z$ = {teeth}", teeth=first)
    elif task.kind == "internal":
        said = tr("Internal pair {teeth}", teeth=f"{first}/{second}")
    else:
        said = tr("External pair {teeth}", teeth=f"{first}/{second}")
    return f"{said} ({pair_name(task.name)})" if task.name else said


def captioned(caption: str, of: str) -> str:
    """A caption with the teeth of the pair that it is of, where there are several."""
    return f"{caption} {of}" if of else caption


def given_quantities(found: MeshPair) -> list[str]:
    """The names of the quantities that are given."""
    task = found.task
    names = [*GIVEN, *(f"x_{k}" for k, shift in enumerate(task.shifts[: len(found.sizes)], 1) if shift is not None)]
    if task.strategy == "given_aw":
        names.append("H" if task.kind == "rack" else "a_w")
    return names + [f"r_a{k}" for k, tip in enumerate(task.tips[: len(found.sizes)], 1) if tip is not None]


def _data(told: Told, key: str, of: str) -> Iterator[Block]:
    """What is given."""
    yield Paragraph(tr("The given data of the pair are in table {table}.", table=f"{{tab:{key}_data}}"))
    yield parameters(
        captioned(tr("Given data of the pair"), of), given_quantities(told.found), told.lexicon, f"{key}_data"
    )


def _rule(task: PairTask) -> Iterator[Block]:
    """Which wheel is which, and how the shifts are chosen."""
    if task.wheels != USUAL:
        first, second = task.wheels
        yield Paragraph(
            tr("Index 1 is that of wheel {first}, index 2 that of wheel {second}.", first=first, second=second)
        )
    if task.kind == "internal":
        yield Paragraph(tr("A positive shift of the ring makes its teeth thicker."))
    yield Paragraph(chosen(task))


def _distance(told: Told, span: tuple[float, float] | None) -> Iterator[Block]:
    """The shifts with the pressure angle and the centre distance that belong to them."""
    found, task = told.found, told.found.task
    yield from told.lines(REFERENCE)
    if task.strategy == "given_aw":
        yield from told.lines(*BY_DISTANCE)
        if span is not None:
            ends = tr("ends of the admissible shift of wheel 1 at this sum")
            told.lexicon.update(named({"x'_1": Given(span[0], "", ends), "x''_1": Given(span[1], "", ends)}))
            yield from told.lines("x_1 = (x'_1 + x''_1)/2")
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
                "The sum of the shifts is zero: the pitch circles are the reference circles, {relations}.",
                relations=f"$a_w = a$, $alpha_tw = {told.words['t']}$",
            )
        )


def _parameters(told: Told, key: str, of: str) -> Iterator[Block]:
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
    names = [name for name in names if name not in given_quantities(found)]  # which the table of the data has
    yield parameters(captioned(tr("Parameters of the pair"), of), names, told.lexicon, f"{key}_common")
    caption, own = captioned(tr("Parameters of the wheels of the pair"), of), task.wheels[: len(found.sizes)]
    yield of_wheels(caption if of else tr("Parameters of the wheels"), WHEELS, _wheels(told), own, f"{key}_wheels")


def _pictures(found: MeshPair, key: str, of: str) -> Iterator[Block]:
    """The mesh and the course of sliding, where both wheels have profiles."""
    if all(fault_of(member) is None for member in both(found)):
        yield Paragraph(
            tr(
                "Figure {mesh} shows the mesh, figure {sliding} sliding and pressure along the line of action.",
                mesh=f"{{fig:{key}_mesh}}",
                sliding=f"{{fig:{key}_sliding}}",
            )
        )
        yield Figure(
            captioned(tr("Mesh of the pair"), of), partial(draw_to_scale, found=found, told=SCALE), MESH, f"{key}_mesh"
        )
        caption = captioned(tr("Specific sliding and specific pressure of the pair"), of)
        caption = caption if of else tr("Specific sliding and specific pressure")
        yield Figure(caption, partial(draw_curves, placed=placed_pair(found)), CURVES, f"{key}_sliding")


def _wheels(told: Told) -> list[Lexicon]:
    """All quantities of each wheel by names without an index."""
    both = zip(told.own, told.found.measures, strict=True)
    return [named(indexed(own | quantities(measures), "", told.words)) for own, measures in both]
