"""A wheel without a mate: its circles, the thickness of its teeth, conditions, measures."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.notes.pairs.conditions import judged
from tmmcalc.gears.notes.pairs.lexicon import CUTTER, alone
from tmmcalc.gears.notes.pairs.measured import measured
from tmmcalc.gears.notes.pairs.sizes import (
    CIRCLES,
    HEIGHT,
    PLAIN_TIP,
    RING_HEIGHT,
    ROOT,
    SECTION,
    limits,
    ring_root,
    teeth,
)
from tmmcalc.gears.notes.pairs.tables import parameters, something
from tmmcalc.gears.notes.pairs.tooth import tooth
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph
from tmmcalc.report.telling import tabulated

GIVEN = ("z", "m", "alpha", "h_a^{*}", "c^{*}", "beta", "b", "x", *CUTTER)
SIZES = (
    *("r", "r_a", "r_f", "r_b", "r_F", "d", "d_a", "d_f", "d_b", "h", "s_n", "s", "s_t", "s_na", "s_a"),
    *("x_min", "x_max", "alpha_a", "z_w", "W", "s_c", "h_c", "D", "M"),
)


def blocks(order: Order) -> Iterator[Block]:
    """The wheel as a calculation by hand finds it."""
    found: SingleWheel = order.results["wheel"]
    wheel, task = alone(found), found.task
    lexicon = wheel.places[0].lexicon
    ring = task.kind == "internal"
    yield Heading(tr("Ring, $z$ = {teeth}", teeth=task.teeth) if ring else tr("Wheel, $z$ = {teeth}", teeth=task.teeth))
    yield from wheel.lines(*SECTION * bool(task.helix), *CIRCLES)
    if ring:
        yield from ring_root(wheel, task.cutter)
    else:
        yield from wheel.lines(ROOT)
        yield from limits(wheel, [found.limit or 0.0])
    yield from wheel.lines(*(PLAIN_TIP,) * (task.tip is None), RING_HEIGHT if ring else HEIGHT)
    yield from teeth([wheel], [wheel], helical=bool(task.helix))
    yield from judged(found.checks, lexicon, wheel.words, (task.measuring.name,), "wheel_quality")
    yield Heading(tr("Measures"), 3)
    yield from measured(wheel, [found.measures], [task.measuring])
    yield from _chords(found)
    if found.profile is not None:
        yield Heading(tr("Tooth profile"), 3)
        yield from tooth(SingleMember(task), "wheel_tooth")
    yield Paragraph(tr("The parameters of the wheel are in table {table}.", table="{tab:wheel_sizes}"))
    yield parameters(tr("Parameters of the wheel"), SIZES, lexicon, "wheel_sizes")


def given_of_wheel(found: SingleWheel) -> Iterator[tuple[str, Given]]:
    """What is given of it, by the names in formulas."""
    names = [*GIVEN, *["r_a"] * (found.task.tip is not None)]
    yield from something(names, alone(found).places[0].lexicon)


def _chords(found: SingleWheel) -> Iterator[Block]:
    """The tooth on the circles that are asked for."""
    rows = [row for row in found.measures.chords if row.name == "asked"]
    if not rows:
        return
    yield Paragraph(tr("The tooth on other circles is in table {table}.", table="{tab:wheel_chords}"))
    columns = {
        "$d$, mm": [2e3 * row.radius for row in rows],
        "$s_n$, mm": [1e3 * row.arc for row in rows],
        f"{tr('chord')}, mm": [1e3 * row.chord for row in rows],
        f"{tr('height above the chord')}, mm": [1e3 * row.height for row in rows],
    }
    labels = [str(k) for k, _ in enumerate(rows, 1)]
    yield tabulated(tr("The tooth on other circles"), columns, labels, head=tr("Number"), key="wheel_chords")
