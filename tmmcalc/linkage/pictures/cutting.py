"""Sheets of free bodies: of each group its load diagram, its closed force polygon to scale, and the values."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, cleared, free_bodies
from tmmcalc.linkage.pictures.cycle import LinkageMotion, motion_at, whole_cycle
from tmmcalc.linkage.pictures.forcepolygon import draw_force_polygon
from tmmcalc.linkage.pictures.loaddiagram import draw_load_diagram, scale_in
from tmmcalc.linkage.pictures.plans import SENSES
from tmmcalc.linkage.pictures.scheme import position_text
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import minus, symbol
from tmmcalc.report.drawing.pens import FORCES
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

BODIES = 2  # on a sheet
SEEN = 1e-4  # of the largest force or couple: less is left out
DIFFERENT = 1e-6  # of the largest force: a smaller difference of the limits is none
GREY = "#555555"
HEADING, FOOT = 10.0, 10.0  # room above and below the bodies [mm]
HEIGHTS = (0.40, 0.39, 0.21)  # of load diagram, polygon, values
TALL = (0.54, 0.46)  # of a load diagram with the values beside it, and of the polygon
VALUES = 58.0  # width of values beside a load diagram [mm]
NAME = 5.0  # room of the name of a body [mm]
GAP = 6.0  # between bodies [mm]
Part = Acting | Couple


@record
class Sheet:
    """What one sheet shows: its heading, the bodies, those of the other limit where friction jumps, the position."""

    heading: str
    bodies: tuple[FreeBody, ...]
    others: tuple[FreeBody, ...]  # empty without a jump
    limits: tuple[str, str]  # names of the limit that is drawn and of the other
    motion: LinkageMotion
    cycle: LinkageMotion


def sheets_of(statics: Statics, kinematics: Kinematics, result: Forces, row: int) -> list[Sheet]:
    """The free bodies of one row of the result, a few to a sheet, with the other limit where friction jumps there."""
    theta, chain = float(result.theta[row]), statics.scene.chain
    side = side_of(result, row)
    bodies, others = (cleared(free_bodies(statics, theta, s), SEEN) for s in (side, -side))
    limits = (tr("just before"), tr("just after")) if side < 0 else (tr("just after"), tr("just before"))
    if not _differ(bodies, others):
        others = ()
    motion, cycle = motion_at(chain, statics.scene.travel.x(result.theta[[row]])), whole_cycle(chain, kinematics)
    heading = _heading(result, kinematics, row, limits if others else None)
    count = -(-len(bodies) // -(-len(bodies) // BODIES))
    return [
        Sheet(heading, bodies[k : k + count], others[k : k + count], limits, motion, cycle)
        for k in range(0, len(bodies), count)
    ]


def _heading(result: Forces, kinematics: Kinematics, row: int, limits: tuple[str, str] | None) -> str:
    position = kinematics.labels.index(result.labels[row].removesuffix("-"))
    text = tr("{position}: load diagrams and force polygons", position=position_text(kinematics, position))
    if limits is None:
        return text
    return text + "\n" + tr("Friction jumps here: drawn {one}, dashed polygon {other}", one=limits[0], other=limits[1])


def _parts(body: FreeBody) -> list[Part]:
    return [*body.forces, *([] if body.inner is None else [body.inner]), *body.couples]


def _key(part: Part) -> tuple[str, ...]:
    return (part.letter, part.index, part.kind, str(part.link), part.joint, type(part).__name__)


def _differ(one: tuple[FreeBody, ...], other: tuple[FreeBody, ...]) -> bool:
    forces = [{_key(f): f.value for body in bodies for f in body.forces} for bodies in (one, other)]
    peak = max(map(abs, forces[0].values()), default=0.0)
    return any(abs(forces[0].get(key, 0j) - forces[1].get(key, 0j)) > DIFFERENT * peak for key in forces[0] | forces[1])


def draw_sheet(drawing: Drawing, box: Box, drawn: Sheet) -> None:
    """One column a body: load diagram, polygon, values."""
    drawing.add(Words(complex(box.middle.real, box.top), drawn.heading, 3.0, 1j))
    columns = box.inset(0, FOOT, 0, HEADING).split(*(1.0 for _ in drawn.bodies), gap=GAP, across=True)
    for k, (column, body) in enumerate(zip(columns, drawn.bodies, strict=True)):
        other = drawn.others[k] if drawn.others else None
        diagram, polygon, values = _places(column, body, drawn)
        draw_body(drawing, diagram, body, drawn.motion, drawn.cycle)
        draw_force_polygon(drawing, polygon, body, other)
        _draw_values(drawing, values, body, other, drawn.limits)
    _draw_legend(drawing, Box(box.left, box.bottom, box.right, box.bottom + FOOT - 2.0), drawn.bodies)


def _places(column: Box, body: FreeBody, drawn: Sheet) -> tuple[Box, Box, Box]:
    """Where load diagram, polygon and values of a body stand: the values below, or beside links that stand upright."""
    below = column.split(*HEIGHTS, gap=2.0)
    upper, polygon = column.split(*TALL, gap=2.0)
    beside = upper.split(upper.width - VALUES, VALUES, gap=2.0, across=True)
    rooms = [box.inset(0, 0, 0, NAME) for box in (below[0], beside[0])]
    sizes = [scale_in(room, body, drawn.motion, drawn.cycle) for room in rooms]
    if drawn.others or sizes[0] <= sizes[1]:
        return below[0], below[1], below[2]
    return beside[0], polygon, beside[1].inset(0, 0, 0, NAME)


def body_scale(drawing: Drawing, box: Box, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion) -> float:
    """The scale that `draw_body` would have in a rectangle."""
    return scale_in(box.inset(0, 0, 0, NAME * drawing.letters), body, motion, cycle)


def draw_body(drawing: Drawing, box: Box, body: FreeBody, motion: LinkageMotion, cycle: LinkageMotion) -> None:
    """The load diagram of a body with its name and scale above."""
    larger = drawing.letters
    mu = draw_load_diagram(drawing, box.inset(0, 0, 0, NAME * larger), body, motion, cycle)
    drawing.add(Words(complex(box.middle.real, box.top), f"{body.name},  {scale_text(mu)}", 2.5 * larger, 1j))


def _draw_values(drawing: Drawing, box: Box, body: FreeBody, other: FreeBody | None, limits: tuple[str, str]) -> None:
    """Size and direction of everything, in both limits if there are two."""
    parts = _parts(body)
    now, then = (tr("magnitude"), []) if other is None else (limits[0], [limits[1], tr("direction")])
    head = ["", tr("joint"), now, tr("direction"), f"$h$, {tr_unit('mm')}", *then]
    rows = [_row(part, _found(other, part), len(head)) for part in parts]
    used = [k for k in range(len(head)) if k == 0 or any(row[k] for row in rows)]
    draw_table(drawing, box, [head[k] for k in used], [[row[k] for k in used] for row in rows], 2.1)


def _found(other: FreeBody | None, part: Part) -> Part | None:
    if other is None:
        return None
    return next((p for p in _parts(other) if _key(p) == _key(part)), None)


def _row(part: Part, other: Part | None, columns: int) -> list[str]:
    arm = minus(number(part.arm * 1e3, 4)) if isinstance(part, Acting) and part.arm else ""
    told = part.joint or (tr("damping") if part.kind == "damper" else "")  # a damper has the name of its spring
    row = [symbol(part.letter, part.index), told, *_value(part), arm, *(_value(other) if other else ())]
    return [*row, *[""] * (columns - len(row))]


def _value(part: Part) -> tuple[str, str]:
    """Size with its unit, and direction or sense."""
    if isinstance(part, Couple):
        return f"{number(abs(part.value), 5)} {tr_unit('N*m')}", SENSES[part.value > 0]
    direction = minus(number(round(math.degrees(cmath.phase(part.value)), 2), 6))
    return f"{number(abs(part.value), 5)} {tr_unit('N')}", f"{direction}°"


def _draw_legend(drawing: Drawing, box: Box, bodies: Sequence[FreeBody]) -> None:
    """What the kinds of lines are, and how to read the names."""
    used = {part.kind for body in bodies for part in _parts(body)}
    names = {kind: tr("inertia force") if kind == "inertia" else tr_name(kind) for kind in used}
    samples_in_rows(drawing, box, [(names[kind], pen) for kind, pen in FORCES.items() if kind in used])
    text = tr(
        "First index: the link acted on, second: the link it comes from. Arrows of load diagrams are not to scale. "
        "What is less than 0.01 % of the largest is left out."
    )
    drawing.add(Words(complex(box.middle.real, box.bottom), text, 2.0, -1j, colour=GREY))
