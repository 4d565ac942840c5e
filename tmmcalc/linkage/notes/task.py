"""What is given of a linkage: its scheme with the letters, its motion, its metric, what acts on it, wanted paths.

Of a linkage that a synthesis finds the metric is the answer: neither it nor the scheme is given.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.notes.given.bases import Seen, seen_of
from tmmcalc.linkage.notes.given.loads import given_loads
from tmmcalc.linkage.notes.given.metric import coordinate_said, counted, metric
from tmmcalc.linkage.notes.given.motion import input_motion, unsteady_motion
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.tables.tasks.paths import to_paths
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Figure
from tmmcalc.report.telling import in_rows

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables

EXTREME = "extreme"  # a beginning that is found
SIZE = (150.0, 95.0)  # of the scheme [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The scheme in a position, then the data."""
    if "kinematics" not in order.results or order.spec.mechanism is None:  # of a linkage that is still sought
        return
    mechanism, result = to_linkage(order.spec.linkage), order.results["kinematics"]
    known = order.spec.synthesis is None
    if known:
        chain = chain_of(mechanism, result)
        row = rows_shown(order, chain, result)[0]
        draw = partial(draw_scheme, result=result, cycle=whole_cycle(chain, result), positions=[row], given=True)
        yield Figure(tr("Scheme of the mechanism"), draw, SIZE, "task_scheme")
    seen = seen_of(mechanism, result.structure)
    loaded = bool({"forces", "reduction", "balance"} & set(order.results))
    repeats = math.lcm(*(load.turns for load in to_loading(order.spec).loads)) if loaded else 1
    yield from input_motion(order.spec.linkage, seen, result, cycle=repeats, known=known)
    strokes, cycle = _of_strokes(order.spec), result.turns and order.spec.linkage.grid.span is None
    for output in mechanism.outputs:
        yield from _output(seen, output, asked=output.name in strokes, cycle=cycle)
    if turning := [str(output.link) for output in mechanism.outputs if output.link is not None]:
        yield Datum(tr("links whose angle is an output"), text=", ".join(turning))
    if known:
        yield from metric(seen, centres=not loaded)
        yield from _coordinates(seen)
        yield from _angles(seen, result)
    if loaded:
        yield from given_loads(order.spec, seen, result.structure, metric=known)
    for path in to_paths(order.spec):
        yield from _path(path, turns=result.turns)
    if order.spec.unsteady is not None:
        yield from unsteady_motion(order.spec, mechanism, turns=result.turns)


def _of_strokes(spec: LinkageTables) -> set[str | None]:
    """The outputs on whose working stroke something depends."""
    windows = [load for load in spec.loads if load.stroke is not None]
    grid, first = spec.linkage.grid, spec.linkage.input.start == EXTREME
    first = first or grid.working is not None or any(load.output is None for load in windows)
    names = {load.output for load in windows}
    return names | {output.name for output in to_linkage(spec.linkage).outputs[:1] if first}


def _output(seen: Seen, output: Output, *, asked: bool, cycle: bool) -> Iterator[Datum]:
    """In which sense an output is counted, and which of its strokes is the working one."""
    coordinate = coordinate_said(seen.mechanism, output)
    if output.point is not None:
        said = tr("direction of the coordinate of point {point}, from axis $x$", point=output.point)
        named = tr("{coordinate}: its direction from axis $x$", coordinate=coordinate)
        yield Datum(said if output.label is None else named, (), (math.degrees(output.direction),), "deg")
    senses = {
        "negative": tr("that on which this coordinate grows"),
        "positive": tr("that on which this coordinate falls"),
        None: tr("the longest by the angle of the crank; of equal ones the one from the greatest coordinate on")
        if cycle
        else tr("the first whole one"),
    }
    if output.resistance is not None or asked:
        said = tr("{coordinate}: its working stroke", coordinate=coordinate)
        yield Datum(said, text=senses[output.resistance])


def _coordinates(seen: Seen) -> Iterator[Datum]:
    """Of the prismatic joints that are driven, or outputs, from where their coordinates are counted."""
    mechanism = seen.mechanism
    asked = [mechanism.input.joint, *(output.joint for output in mechanism.outputs if output.joint is not None)]
    for name in dict.fromkeys(asked):
        joint = mechanism.joint(name)
        if joint.kind == "prismatic":
            yield from counted(seen, joint)


def _angles(seen: Seen, result: Kinematics) -> Iterator[Datum]:
    """Of links that turn the line that has their angle, where it is another than that which is seen."""
    trace = result.trace
    for link, rates in zip(trace.link_ids, trace.dangle, strict=True):
        base = seen.bases[link]
        turn = base.angle(1 + 0j)
        if rates.any() and turn:
            said = tr("line of link {link} that has its angle, {origin}", link=link, origin=base.origin)
            yield Datum(said, (), (turn,), "deg")


def _path(path: WantedPath, *, turns: bool) -> Iterator[Datum]:
    """The points that a point of the linkage is to pass, as they lie in the plane, and when."""
    words = {"path": tr("“{name}”", name=path.name), "point": path.point}
    turn = complex(math.cos(path.turn), math.sin(path.turn))
    wanted = [at * turn + path.shift for at in path.through]
    abscissae = tr("wanted path {path} of point {point}: abscissae", **words)
    ordinates = tr("wanted path {path} of point {point}: ordinates", **words)
    lists = [
        Datum(abscissae, ("x_i",), tuple(at.real for at in wanted), "m"),
        Datum(ordinates, ("y_i",), tuple(at.imag for at in wanted), "m"),
    ]
    if path.at and turns:
        said = tr("wanted path {path} of point {point}: angle of the crank from the first position", **words)
        lists.append(Datum(said, ("phi_i",), tuple(map(math.degrees, path.at)), "deg"))
    elif path.at:
        said = tr("wanted path {path} of point {point}: travel of the drive from the first position", **words)
        lists.append(Datum(said, ("Deltas_i",), path.at, "m"))
    yield from in_rows(*lists)
