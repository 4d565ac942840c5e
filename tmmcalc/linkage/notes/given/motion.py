"""What is given of the motion of the input: of a crank its speed, of a driven slider its travel, and the positions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.notes.given.bases import Seen
from tmmcalc.linkage.notes.given.metric import coordinate_said
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.tables.grid import GridTable
    from tmmcalc.linkage.tables.mechanism import MechanismTable


def input_motion(table: MechanismTable, seen: Seen, result: Kinematics, *, cycle: int, known: bool) -> Iterator[Datum]:
    """Speed, sense, beginning and positions; of a linkage that is found without the numbers that are found with it.

    ``cycle``: turns of the crank after which the loads repeat.
    """
    start = table.input.start
    if known:
        yield from _speed(seen, result)
    if result.turns:
        sense = tr("counter-clockwise") if result.speed > 0 else tr("clockwise")
        yield Datum(tr("sense in which the crank turns"), text=sense)
    yield from _steps(table.grid, result, cycle)
    if isinstance(start, str):
        text = tr("dead centre before the working stroke")
        if len(table.outputs) > 1:
            text = f"{text}: {coordinate_said(seen.mechanism, seen.mechanism.outputs[0])}"
        yield Datum(tr("beginning of the count, position 0"), text=text)
    elif known and result.turns:
        yield Datum(tr("position 0: angle of the crank from axis $x$"), (), (math.degrees(start),), "deg")
    elif known:
        yield Datum(tr("coordinate of the drive in the first position"), ("s_0",), (start,), "m")


def _speed(seen: Seen, result: Kinematics) -> Iterator[Datum]:
    """How fast the input moves, and to which side a driven slider does."""
    if result.turns:
        name = f"n_{result.structure.input_link}"
        yield Datum(tr("speed of the crank"), (name,), (abs(result.speed) * 30 / math.pi,), "rpm")
        if result.acceleration:
            said = tr("angular acceleration of the crank, positive counter-clockwise")
            yield Datum(said, (f"eps_{result.structure.input_link}",), (result.acceleration,), "rad/s^2")
        return
    pair = "".join(map(str, seen.mechanism.joint(result.input_joint).links))
    yield Datum(tr("speed of the drive"), (f"v_{{{pair}}}",), (abs(result.speed),), "m/s")
    sense = tr("its coordinate grows") if result.speed > 0 else tr("its coordinate falls")
    yield Datum(tr("sense in which the drive moves"), text=sense)
    if result.acceleration:
        said = tr("acceleration of the drive along its coordinate")
        yield Datum(said, (f"a_{{{pair}}}",), (result.acceleration,), "m/s^2")


def _steps(grid: GridTable, result: Kinematics, cycle: int) -> Iterator[Datum]:
    """The positions: equal steps over the cycle, over a part of it, over each stroke; those between."""
    if grid.working is not None and grid.idle is not None:
        yield Datum(tr("number of equal steps of the working stroke"), ("n_w",), (float(grid.working),))
        yield Datum(tr("number of equal steps of the idle stroke"), ("n_i",), (float(grid.idle),))
    else:
        even = [label for label in result.labels if label.isdigit()]  # without those between, as 7'
        said = tr("number of equal steps of the cycle")
        if not result.turns:
            said = tr("number of equal steps of the travel of the drive")
        elif grid.span is not None:
            said = tr("number of equal steps of the travel of the crank")
        elif cycle > 1:
            said = tr("number of equal steps of a turn of the crank")
        yield Datum(said, ("n",), (float(len(even) - 1),))
        if result.turns and grid.span is None and cycle > 1:
            whole = tr("{count} turns of the crank, positions 0 to {last}", count=cycle, last=cycle * (len(even) - 1))
            yield Datum(tr("cycle of the loads"), text=whole)
    if grid.span is not None and result.turns:
        yield Datum(tr("travel of the crank from the first position"), ("phi_n",), (math.degrees(grid.span),), "deg")
    elif grid.span is not None:
        yield Datum(tr("travel of the drive from the first position to the last"), ("Deltas_n",), (grid.span,), "m")
    if grid.extra and result.turns:
        said = tr("further positions, by the angle of the crank from the first position")
        yield Datum(said, ("phi",), tuple(map(math.degrees, grid.extra)), "deg")
    elif grid.extra:
        said = tr("further positions, by the travel of the drive from the first position")
        yield Datum(said, ("Deltas",), tuple(grid.extra), "m")
    if grid.extremes:
        yield Datum(tr("further positions"), text=tr("the dead centres of the outputs"))


def unsteady_motion(spec: LinkageTables, mechanism: Mechanism, *, turns: bool) -> Iterator[Datum]:
    """The motion from rest to rest: its ends, its limits, its duration."""
    task, unit = to_unsteady(spec), "rad" if turns else "m"
    if task.output is None:
        begin, end = tr("coordinate of the input at the beginning"), tr("coordinate of the input at the end")
        keys, factor, shown = ("x_0", "x_e"), 1.0, unit
    else:
        output = next(each for each in mechanism.outputs if each.name == task.output)
        angular, coordinate = output.link is not None, coordinate_said(mechanism, output)
        begin = tr("{coordinate}, at the beginning of the unsteady motion", coordinate=coordinate)
        end = tr("{coordinate}, at the end of the unsteady motion", coordinate=coordinate)
        keys, factor, shown = ("", ""), math.degrees(1.0) if angular else 1.0, "deg" if angular else "m"
    for said, key, value in ((begin, keys[0], task.start), (end, keys[1], task.end)):
        if value is not None:
            yield Datum(said, (key,) if key else (), (factor * value,), shown)
    if task.start is None:
        yield Datum(begin, text=tr("in position 0"))
    if task.travel is not None:
        yield Datum(tr("travel of the input in the unsteady motion, with its sign"), ("S_m",), (task.travel,), unit)
    if task.sense is not None:
        said = tr("its coordinate grows") if task.sense > 0 else tr("its coordinate falls")
        yield Datum(tr("sense in which the input moves in the unsteady motion"), text=said)
    if task.speed is not None:
        yield Datum(tr("allowed speed of the input"), ("v_m",), (task.speed,), f"{unit}/s")
    yield Datum(tr("allowed acceleration of the input"), ("a_m",), (task.acceleration,), f"{unit}/s^2")
    if task.duration is not None:
        yield Datum(tr("time of the whole motion"), ("T",), (task.duration,), "s")
    yield Datum(tr("number of equal steps of the time"), ("n_t",), (float(task.steps),))
