"""Sheets of free bodies: of each group its load diagram, its closed force polygon to scale, and the values."""

from __future__ import annotations

import cmath
import math

from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, cleared, free_bodies
from tmmcalc.linkage.pictures.cycle import LinkageMotion, motion_at, whole_cycle
from tmmcalc.linkage.pictures.forcepolygon import draw_force_polygon
from tmmcalc.linkage.pictures.loaddiagram import draw_load_diagram
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import minus, symbol
from tmmcalc.report.drawing.pens import FORCES, INK
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

BODIES = 3  # on a sheet
SEEN = 1e-4  # of the largest force or couple: less is left out
DIFFERENT = 1e-6  # of the largest force: a smaller difference of the limits is none
ROW = 3.6  # height of a row of the values [mm]
GREY = "#555555"
HEADING, FOOT = 10.0, 10.0  # room above and below the bodies [mm]
HEIGHTS = (0.45, 0.33, 0.22)  # of load diagram, polygon, values
COLUMNS = (1.0, 11.0, 19.0, 37.0, 49.0, 65.0, 83.0)  # where the columns of the values begin [mm]
WIDEST = 95.0  # of all of them [mm]
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
    limits = ("just before", "just after") if side < 0 else ("just after", "just before")
    if not _differ(bodies, others):
        others = ()
    motion, cycle = motion_at(chain, statics.scene.travel.x(result.theta[[row]])), whole_cycle(chain, kinematics)
    heading = _heading(result, row, limits if others else None)
    count = -(-len(bodies) // -(-len(bodies) // BODIES))
    return [
        Sheet(heading, bodies[k : k + count], others[k : k + count], limits, motion, cycle)
        for k in range(0, len(bodies), count)
    ]


def _heading(result: Forces, row: int, limits: tuple[str, str] | None) -> str:
    phi = float(result.phi[row])
    value = minus(number(math.degrees(phi) if result.turns else phi, 5))
    at = f"$φ$ = {value}°" if result.turns else f"$s − s_0$ = {value} m"
    text = f"Load diagrams and force polygons in position {result.labels[row].removesuffix('-')}, {at}"
    if limits:
        text += f"\nFriction jumps here: drawn {limits[0]}, dashed polygon {limits[1]} the position"
    return text


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
    columns = box.inset(0, FOOT, 0, HEADING).split(*(1.0 for _ in drawn.bodies), gap=4.0, across=True)
    for k, (column, body) in enumerate(zip(columns, drawn.bodies, strict=True)):
        other = drawn.others[k] if drawn.others else None
        diagram, polygon, values = column.split(*HEIGHTS, gap=2.0)
        mu = draw_load_diagram(drawing, diagram.inset(0, 0, 0, 5.0), body, drawn.motion, drawn.cycle)
        title = f"{body.name},  $μ_l$ = {number(mu, 4)} m/mm"
        drawing.add(Words(complex(diagram.middle.real, diagram.top), title, 2.5, 1j))
        draw_force_polygon(drawing, polygon, body, other)
        _draw_values(drawing, values, body, other, drawn.limits)
    _draw_legend(drawing, Box(box.left, box.bottom, box.right, box.bottom + FOOT - 2.0), drawn)


def _draw_values(drawing: Drawing, box: Box, body: FreeBody, other: FreeBody | None, limits: tuple[str, str]) -> None:
    """Size and direction of everything, in both limits if there are two."""
    parts = _parts(body)
    pitch = min(ROW, box.height / (len(parts) + 1.5))
    left = box.left + max(0.0, (box.width - WIDEST) / 2)
    narrow = min(1.0, box.width / WIDEST)
    now, then = ("size", "") if other is None else limits
    arms = "arm $h$" if any(isinstance(part, Acting) and part.arm for part in parts) else ""
    heads = ["", "joint", now, "direction", arms, then]
    rows = [heads, *(_row(part, _found(other, part)) for part in parts)]
    for r, row in enumerate(rows):
        for x, text in zip(COLUMNS, row, strict=False):
            if text:
                at = complex(left + narrow * x, box.top - pitch * (r + 0.5))
                height = (2.0 if r else 1.8) * narrow * pitch / ROW
                drawing.add(Words(at, text, height, -1, colour=INK if r else GREY))


def _found(other: FreeBody | None, part: Part) -> Part | None:
    if other is None:
        return None
    return next((p for p in _parts(other) if _key(p) == _key(part)), None)


def _row(part: Part, other: Part | None) -> list[str]:
    arm = f"{minus(number(part.arm * 1e3, 4))} mm" if isinstance(part, Acting) and part.arm else ""
    told = part.joint or ("damping" if part.kind == "damper" else "")  # a damper has the name of its spring
    row = [symbol(part.letter, part.index), told, *_value(part), arm]
    return row if other is None else [*row, *_value(other)]


def _value(part: Part) -> tuple[str, str]:
    """Size with its unit, and direction or sense."""
    if isinstance(part, Couple):
        return f"{number(abs(part.value), 5)} N·m", "ccw" if part.value > 0 else "cw"
    return f"{number(abs(part.value), 5)} N", f"{minus(number(round(math.degrees(cmath.phase(part.value)), 2), 6))}°"


def _draw_legend(drawing: Drawing, box: Box, drawn: Sheet) -> None:
    """What the kinds of lines are, and how to read the names."""
    used = {part.kind for body in drawn.bodies for part in _parts(body)}
    samples_in_rows(drawing, box, [(kind, pen) for kind, pen in FORCES.items() if kind in used])
    text = "First index: the link acted on, second: the link it comes from. Arrows of load diagrams are not to scale. "
    text += "What is less than 0.01 % of the largest is left out."
    drawing.add(Words(complex(box.middle.real, box.bottom), text, 2.0, -1j, colour=GREY))
