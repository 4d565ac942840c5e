"""What is given of a train that is sought: its layout and ratio, the limits of the search, what else has to hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.gears.notes.letters import asked_ratio, letter, lowered
from tmmcalc.gears.pictures.words import layout_word
from tmmcalc.gears.scheme import layout_of
from tmmcalc.gears.search.search import KEPT
from tmmcalc.gears.tables.tasks.train import RANGE, to_train
from tmmcalc.gears.tables.train import TrainTable
from tmmcalc.gears.trains import Request
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import as_given

MM = 1e3  # of a metre


def of_train(order: Order) -> Iterator[Datum]:
    """What the train has to be, and among which numbers of teeth it is sought."""
    table: TrainTable | None = order.spec.train
    if table is None:
        return
    requests = to_train(order.spec)
    yield Datum(tr("layout of the train"), text=", ".join(map(_layout, table.layout)))
    yield from _ratio(table, requests, behind=order.spec.open_pair is not None)
    branched = [each for each in requests if each.scheme.branched]
    if branched:
        said = tr("number of planets") if branched[0].scheme.planetary else tr("number of layshafts")
        yield Datum(said, ("K",), _each(each.task.planets for each in branched))
    yield from _modules(table, requests)
    yield Datum(tr("profile angle of the rack"), ("alpha",), (math.degrees(table.pressure_angle),), "deg")
    yield Datum(tr("addendum coefficient"), ("h_a^{*}",), (float(table.addendum),))
    if table.teeth is not None:
        yield Datum(tr("numbers of teeth that are tested"), (), tuple(map(float, table.teeth)))
    else:
        yield from _limits(requests)
        yield from _search(table)
    yield from _demands(requests)
    yield from _radial(requests)


def _layout(key: str) -> str:
    """A layout by its designation, one with fixed axes in words."""
    scheme = layout_of(key)
    return layout_word(key) if scheme.planetary else lowered(tr_name(scheme.title))


def _ratio(table: TrainTable, requests: Sequence[Request], *, behind: bool) -> Iterator[Datum]:
    """The ratio by its kind, or the speeds that give it, those of a train ``behind`` an open pair; its tolerance."""
    kinds = {
        "u": tr("ratio that is asked for"),
        "i_1H": tr("ratio that is asked for, wheel 1 over the carrier"),
        "i_H1": tr("ratio that is asked for, the carrier over wheel 1"),
        "i_14": tr("ratio that is asked for, wheel 1 over ring 4"),
    }
    kind = requests[0].kind
    for each in dict.fromkeys(request.kind for request in requests):
        if table.ratio is not None:
            yield Datum(kinds[each], (asked_ratio(each),), (float(table.ratio),))
    if table.ratio is None and table.input_speed is not None and table.output_speed is not None:
        yield Datum(tr("speed of the input shaft"), (), (table.input_speed * 30 / math.pi,), "rpm")
        yield Datum(tr("speed of the output shaft"), (), (table.output_speed * 30 / math.pi,), "rpm")
    elif table.ratio is None:
        said = tr("that of the speeds of the motor and the crank")
        if behind:
            said = tr("that of the speeds of the motor and the crank over the ratio of the open pair")
        yield Datum(kinds[kind], (asked_ratio(kind),), text=said)
    tolerances = _each(request.tolerance for request in requests)
    if table.tolerance_kind == "relative":
        yield Datum(tr("admitted error of the ratio"), ("Delta",), tuple(100 * each for each in tolerances), "%")
    else:
        yield Datum(tr("admitted deviation of the ratio"), ("Delta",), tolerances)


def _modules(table: TrainTable, requests: Sequence[Request]) -> Iterator[Datum]:
    """The modules of the stages, or the proportions that they may have."""
    if any(each.scheme.branched and each.scheme.stages > 1 for each in requests):
        if table.module_ratios is not None:
            said = "; ".join(f"{_plain(first)}:{_plain(second)}" for first, second in table.module_ratios)
            yield Datum(tr("proportions of the modules of stages 1 and 2"), text=said)
        elif table.modules is None:
            low, high = map(float, table.module_ratio_range or RANGE)
            said = tr("least and largest proportion of the standard modules of stages 2 and 1")
            yield Datum(said, (), (low, high))
    if table.modules is not None:
        yield Datum(tr("modules of the stages"), ("m_1", "m_2"), tuple(MM * each for each in table.modules), "mm")
    elif table.module is not None:
        yield Datum(tr("module of stage 1"), ("m_1",), (MM * table.module,), "mm")


def _limits(requests: Sequence[Request]) -> Iterator[Datum]:
    """The numbers of teeth among which the search looks."""
    limits = requests[0].task.limits  # of all layouts
    yield from _ends(tr("numbers of teeth of external wheels, from and to"), "z", limits.least, limits.largest)
    if any(not each.scheme.branched for each in requests):
        said = tr("largest number of teeth of the pinions")
        yield Datum(said, (letter("z_pinion_max"),), (float(limits.largest_pinion),))
    if any(each.scheme.rings for each in requests):
        said = tr("numbers of teeth of rings, from and to")
        yield from _ends(said, "ring", limits.least_ring, limits.largest_ring)
    if limits.largest_sum is not None:
        yield Datum(
            tr("largest sum of the teeth of wheels 1 and 2"), (letter("sum_max"),), (float(limits.largest_sum),)
        )


def _ends(said: str, name: str, low: float, high: float) -> Iterator[Datum]:
    yield Datum(said, (letter(f"{name}_min"), letter(f"{name}_max")), (float(low), float(high)))


def _search(table: TrainTable) -> Iterator[Datum]:
    """How the sets are sought, where that is not all of them."""
    if table.method == "textbook":
        yield Datum(tr("search for numbers of teeth"), text=tr("by the stepping of the textbook"))
    if table.keep != KEPT:
        said = tr("how many sets, those of the least $z_1 + z_2$, are calculated at most")
        yield Datum(said, (), (float(table.keep),))


def _demands(requests: Sequence[Request]) -> Iterator[Datum]:
    """What else the numbers of teeth have to keep."""
    tasks = [each.task for each in requests]
    demands, several = tasks[0].demands, [task for task in tasks if task.planets > 1]
    if several and not demands.assembly:
        yield Datum(tr("condition of assembly"), text=tr("not asked for"))
    if any(task.planets > 2 for task in tasks):
        yield _asked(tr("least gap between the tips of neighbours, in modules"), ("c_g",), demands.gap)
    if any(each.scheme.rings for each in requests):
        said = tr("least difference of the teeth of a ring and the wheel in it")
        yield _asked(said, (letter("d_min"),), demands.ring_difference)
    undercut = tr("none") if demands.undercut else tr("admitted")
    yield Datum(tr("undercut"), text=undercut)
    angles = _each(task.demands.largest_angle for task in tasks if task.demands.largest_angle is not None)
    if angles:
        said = tr_name("largest operating pressure angle")
        yield Datum(said, (letter("alpha_max"),), tuple(map(math.degrees, angles)), "deg")
    for name, key, meaning, factor, unit in (
        ("stage_ratio", "u_max", tr("largest ratio of one stage"), 1.0, ""),
        ("diameter_band", "delta_d", tr("largest relative difference of the diameters of the wheels"), 100.0, "%"),
        ("envelope", "D_max", tr("largest diameter around the train"), MM, "mm"),
    ):
        found = _each(value for task in tasks if (value := getattr(task.demands, name)) is not None)
        if found:
            yield Datum(meaning, (letter(key),), tuple(factor * each for each in found), unit)
    for low_high, key, meaning in zip(
        demands.centre_distance or (None, None),
        ("a_min", "a_max"),
        (tr("least distance of the axes of wheels 1 and 2"), tr("largest distance of the axes of wheels 1 and 2")),
        strict=True,
    ):
        if low_high is not None:
            yield Datum(meaning, (letter(key),), (MM * low_high,), "mm")
    if demands.equal_pinions:
        yield Datum(tr("numbers of teeth of all pinions"), text=tr("equal"))
    if demands.coprime:
        yield Datum(tr("numbers of teeth of wheels in mesh"), text=tr("without a common factor"))


def _asked(said: str, keys: tuple[str, ...], value: Any) -> Datum:
    """A limit, or that it is switched off."""
    return Datum(said, keys, text=tr("not asked for")) if value is None else Datum(said, keys, (float(value),))


def _radial(requests: Sequence[Request]) -> Iterator[Datum]:
    """What the equations of pairs of planets leave free."""
    for shape in (each.radial for each in requests if each.radial is not None):
        yield Datum(tr("teeth of planet 3 over those of planet 2"), ("y",), (shape.y,))
        if shape.angles is None:
            said = tr("proportions of the cosines of the operating pressure angles, 12 to 23 and 12 to 34")
            yield Datum(said, ("t_1", "t_2"), (shape.t1, shape.t2))
        else:
            said = tr("operating pressure angles of the meshes 1–2, 2–3, 3–4")
            yield Datum(said, (), tuple(map(math.degrees, shape.angles)), "deg")
        if shape.assembly is not None:
            yield Datum(tr("number of the assembly condition"), ("N",), (float(shape.assembly),))


def _each(values: Any) -> tuple[float, ...]:
    """Different values in their order."""
    return tuple(dict.fromkeys(map(float, values)))


def _plain(part: Any) -> str:
    return as_given(float(part))
