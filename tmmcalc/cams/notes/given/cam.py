"""What is given of a cam: its kind, its shaft, its motion and law, sizes and limits, the search for the best."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi
from typing import Any

import numpy as np

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.notes.cam_elastic import TRAIN, train_scene
from tmmcalc.cams.notes.cam_law import described, laws_described
from tmmcalc.cams.notes.cam_profile import axes_of
from tmmcalc.cams.notes.cam_synthesis import SIZES, of_limits
from tmmcalc.cams.notes.given.laws import of_laws
from tmmcalc.cams.notes.given.loads import of_loads, of_needed, written
from tmmcalc.cams.notes.laws import named_title
from tmmcalc.cams.notes.lexicon import Told, of_follower, of_task, told_of
from tmmcalc.cams.tables.cam import CamTable
from tmmcalc.cams.task import Optimum
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import is_whole
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import as_given, data_of

LIMITS = {  # keys of [cam.limits] by the names in formulas
    "pressure_angle": "theta_P",
    "pressure_angle_return": "theta_{Pc}",
    "convex_radius": "r_m",
    "concave_radius": "r_i",
    "shaft_radius": "r_1",
}
NEAR = 1e-9  # [rad]: one angle


def of_cam(order: Order) -> Iterator[Datum]:
    """The cam in the order of its chapter."""
    if not {"cam_law", "cam_synthesis"} <= set(order.results):
        return
    table, told = order.spec.cam, told_of(order)
    yield from (Datum(what, text=text) for what, text in described(told))
    yield from _shaft(order, told)
    yield from _rows(table, told.law)
    if "cam_profile" in order.results:
        yield Datum(tr("axes of the cam"), text=axes_of(told.follower))
    motion = told.named(of_task(told))
    if table.speed is not None and is_whole(turns := table.speed * 30 / pi):  # as it was written, then
        yield Datum(tr("rotational speed of the cam"), ("n_k",), (turns,), "rpm")
    yield from data_of(motion, (name for name in motion if name != told.words["wn"] or table.speed is not None))
    yield from (Datum(what, text=text) for what, text in laws_described(told))
    yield from of_laws(table.rise_law or table.law, table.return_law or table.law)
    yield from _sizes(order, told)
    if "cam_pressure" in order.results and told.follower.kind != "flat":
        yield Datum(tr("where the pressure angle is positive"), text=_positive(told))
    if "cam_forces" in order.results:
        yield from of_loads(order)
    yield from of_needed(table, told.task)
    if "cam_optimum" in order.results and told.task.optimum is not None:
        yield from _search(told.task.optimum, told)
    if "cam_elastic" in order.results:
        yield from data_of(train_scene(told, order.results["cam_elastic"]), TRAIN)


def _shaft(order: Order, told: Told) -> Iterator[Datum]:
    """The shaft of the machine that the cam turns with: which, how fast, and where on it the rise begins."""
    table, task = order.spec.cam, told.task
    machine = order.spec.mechanism is not None or order.spec.torque is not None
    if not machine or (table.shaft is None and table.speed is not None):
        return
    shafts = {"crank": tr("the input shaft, which it loads"), "motor": tr("the shaft of the motor, which it loads")}
    yield Datum(tr("shaft that drives the cam"), text=shafts.get(table.shaft, tr("the input shaft")))
    if table.shaft is not None:
        said = tr("speed of the cam over that of the motor")
        if table.shaft == "crank":
            said = tr("speed of the cam over that of the input shaft")
        yield Datum(said, ("u_c",) if table.shaft == "crank" else (), (float(table.ratio),))
    said = tr("angle of the input shaft from position 0 at which the rise begins")
    yield Datum(said, ("phi_r",), (degrees(task.begin),), "deg")


def _rows(table: CamTable, law: LawResult) -> Iterator[Datum]:
    """The positions of the tables."""
    if table.steps is not None:
        yield Datum(tr("number of equal steps of each phase of motion"), (), (float(table.steps),))
        yield from _positions(law)
    else:
        said = tr("angle of the cam from position to position, from the beginning of the rise on")
        yield Datum(said, (), (degrees(table.step),), "deg")


def _positions(law: LawResult) -> Iterator[Datum]:
    """The numbers of the positions from the beginning to the end of each phase of motion."""
    words = {"rise": tr("positions of the rise"), "return": tr("positions of the return")}
    for phase in law.phases:
        if phase.constants is not None:
            within = (law.positions.phi >= phase.begin - NEAR) & (law.positions.phi <= phase.end + NEAR)
            first, *_, last = (law.labels[row].rstrip("-") for row in np.flatnonzero(within))
            said = tr("{first} at its beginning to {last} at its end", first=first, last=last)
            yield Datum(words[phase.kind], text=said)


def _sizes(order: Order, told: Told) -> Iterator[Datum]:
    """The sizes that are given; the limits of those that are found, or that the spec writes."""
    table, result = order.spec.cam, order.results["cam_synthesis"]
    sizes = [SIZES[size.symbol] for size in result.sizes if size.given]
    if told.follower.kind == "translating" and table.offset == 0 and "e" not in sizes:
        sizes.append("e")  # it may be sought too, so that none is told
    yield from data_of(of_follower(told.follower), sizes)
    sought = len(sizes) < len(result.sizes)
    yield from data_of(of_limits(told), [*LIMITS.values()] if sought else written(table.limits, LIMITS))
    if sought and told.follower.kind != "flat" and told.task.limits.back is None:
        yield Datum(tr("pressure angle on the return"), text=tr("not limited"))
    if not table.limits.allow_concave:
        yield Datum(tr("concave parts of the profile"), text=tr("none"))
    if told.follower.kind == "flat" and table.face_margin:
        said = tr("length by which the face is longer than the contact needs, on both sides")
        yield Datum(said, ("Delta_b",), (1e3 * table.face_margin,), "mm")
    if table.tool_radius is not None:
        yield Datum(tr("radius of the tool whose path is asked for"), (), (1e3 * table.tool_radius,), "mm")


def _positive(told: Told) -> str:
    """The rule of the sign of the pressure angle."""
    if told.turns:
        return tr("where the force of the cam pulls the rocker away from its pivot")
    return tr("where the normal of the profile is turned from the velocity of the rise as the cam turns")


def _search(asked: Optimum, told: Told) -> Iterator[Datum]:
    """The steps, bounds and options of the search for the best mechanism."""
    yield Datum(tr("step of the sizes in the search"), (), (1e3 * asked.step,), "mm")
    if not told.turns:
        said = tr("step of the height of the guide in the search")
        yield Datum(said, (), (1e3 * asked.height_step,), "mm")
    for ends, key, meaning in (
        (asked.heights, "H_2", tr("heights of the upper edge of the guide in the search, from and to")),
        (asked.centre_distances, "l_0", tr("distances of the axes in the search, from and to")),
        (asked.rocker_lengths, "l_2", tr("lengths of the rocker in the search, from and to")),
    ):
        if ends is not None:
            yield Datum(meaning, (key,), tuple(1e3 * end for end in ends), "mm")
    whole = tr("the whole turn") if asked.phases == "turn" else tr("the rise alone")
    yield Datum(tr("what the search examines"), text=whole)
    yield from _options(asked)


def _options(asked: Optimum) -> Iterator[Datum]:
    """What is tried in place of what the cam has."""
    if asked.laws:
        yield Datum(tr("laws that are tried too"), text=", ".join(map(named_title, asked.laws)))
    if asked.safeties:
        yield Datum(tr("safety factors of the closure that are tried too"), ("K_1",), asked.safeties)
    if asked.contacts:
        said = tr("permissible contact stresses that are tried too")
        yield Datum(said, text=_named(asked.contacts, 1e-6, tr_unit("MPa")))
    if asked.roller_ratios:
        said = tr("least radii of the roller over that of the pin that are tried too")
        yield Datum(said, text=_named(asked.roller_ratios, 1.0, ""))
    if asked.combine:
        yield Datum(tr("what is tried"), text=tr("all combinations"))


def _named(options: Sequence[Any], factor: float, unit: str) -> str:
    """Values, those with a name with it."""
    said = ((tr_name(name), f"{as_given(factor * value)} {unit}".strip()) for name, value in options)
    return "; ".join(f"{name}: {value}" if name else value for name, value in said)
