"""The tables of a pair, in mm: its parameters, its figures of quality, sliding and pressure along the contact."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.quality.verdicts import Check
from tmmcalc.gears.meshing.results import MeshPair, WheelSizes
from tmmcalc.gears.pictures.listing import Heading, Row
from tmmcalc.gears.pictures.placedpair import ALIKE, SIGNS, Circle, PlacedPair, point_sign
from tmmcalc.gears.pictures.slidingcurves import course, singles
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import minus, plain
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.numbers import number

APART = 5.0  # between two tables [mm]
PLACES = 4  # decimals of a figure of quality
LETTERS, NOTE = 3.5, 2.5  # height of the letters of a table on a sheet, and of what is told under it [mm]
AT_LEAST, AT_MOST = "\N{GREATER-THAN OR EQUAL TO}", "\N{LESS-THAN OR EQUAL TO}"


@record
class Parameter:
    """One row of the table of parameters."""

    name: str
    symbol: str
    unit: str  # empty: a number
    values: tuple[str, ...]  # of the pair, or of its wheels

    @property
    def text(self) -> str:
        """Its name and symbol."""
        return f"{self.name} {self.symbol}".strip()


def _mm(value: float) -> str:
    return minus(number(round(1e3 * value, 3), 7))


def _degrees(value: float) -> str:
    return f"{number(math.degrees(value), 6)}°"


def _pure(value: float) -> str:
    return minus(number(round(value, 5) + 0.0, 5))


def parameters(found: MeshPair) -> list[Row]:
    """The parameters as a list: of the pair, then of both wheels, in mm."""
    return [
        Heading((tr("Pair"),)),
        *((each.text, "", each.values[0]) for each in of_pair(found)),
        Heading((tr("Wheel"), *(plain(sizes.name) for sizes in found.sizes))),
        *((each.text, *each.values) for each in of_wheels(found)),
    ]


def of_pair(found: MeshPair) -> list[Parameter]:
    """The parameters that both wheels have in common."""
    task, rack, mm = found.task, found.task.rack, tr_unit("mm")
    external, racked = task.kind == "external", task.kind == "rack"
    tool = f"{_degrees(rack.angle)}; {number(rack.addendum)}; {number(rack.clearance)}"
    rows = [
        Parameter(tr("module"), "$m$", mm, (_mm(task.module),)),
        Parameter(tr("rack"), "$α$; $h_a^*$; $c^*$", "", (tool,)),
        Parameter(tr("helix angle"), "$β$", "", (_degrees(task.helix),)),
        Parameter(tr("face width"), "$b$", mm, (_mm(task.face_width),)) if task.face_width else None,
        Parameter(tr("axis to datum line"), "", mm, (_mm(found.distance),))
        if racked
        else Parameter(tr("centre distance"), "$a_w$", mm, (_mm(found.distance),)),
        None if racked else Parameter(tr("reference distance"), "$a$", mm, (_mm(found.reference_distance),)),
        Parameter(tr("operating pressure angle"), "$α_{tw}$", "", (_degrees(found.angle_w),)),
        None if racked else Parameter(tr("modification"), "$y$", "", (_pure(found.modification),)),
        Parameter(tr("tip shortening"), "$Δ$$y$", "", (_pure(found.shortening),)) if external else None,
        Parameter(tr("contact ratio"), "$ε_α$", "", (number(found.contact_ratio, 5),)),
        Parameter(tr("with the flanks left"), "", "", (number(found.shortened, 5),)) if _shortened(found) else None,
        Parameter(tr("overlap ratio"), "$ε_β$", "", (number(found.overlap, 5),)) if found.overlap else None,
        Parameter(tr("total contact ratio"), "$ε_γ$", "", (number(found.total, 5),)) if found.overlap else None,
        Parameter(tr("active length"), "$A_2A_1$", mm, (_mm(found.line.end - found.line.start),)),
    ]
    return [row for row in rows if row is not None]


def _shortened(found: MeshPair) -> bool:
    return found.shortened < found.contact_ratio - 1e-9


def of_wheels(found: MeshPair) -> list[Parameter]:
    """The parameters of the wheels."""
    sizes, mm = found.sizes, tr_unit("mm")
    circles: dict[Circle, str] = {
        "reference": tr("reference circle"),
        "operating": tr("pitch circle"),
        "tip": tr("tip circle"),
        "root": tr("root circle"),
        "base": tr("base circle"),
    }

    def lengths(name: str, symbol: str, values: Sequence[float]) -> Parameter:
        return Parameter(name, symbol, mm, tuple(map(_mm, values)))

    rows = [
        Parameter(tr("teeth"), "$z$", "", tuple(str(one.teeth) for one in sizes)),
        Parameter(tr("shift"), "$x$", "", tuple(_pure(one.shift) for one in sizes)),
    ]
    for circle, name in circles.items():
        index = SIGNS[circle]
        rows.append(lengths(name, f"$r_{index}$" if index else "$r$", [_radius(one, circle) for one in sizes]))
    rows += [
        lengths(tr("end of involute"), "$r_F$", [one.form for one in sizes]),
        lengths(tr("active to"), "$r_p$", [one.active for one in sizes]),
        lengths(tr("tooth thickness"), "$s_n$", [one.thickness for one in sizes]),
        lengths(tr("at the tip"), "$s_{na}$", [one.tip_thickness for one in sizes]),
        lengths(tr("clearance at the root"), "", found.clearances[: len(sizes)]),
    ]
    spans = [measures.span for measures in found.measures]
    if any(spans):
        counted = tuple("" if span is None else str(span.teeth) for span in spans)
        rows.append(Parameter(tr("span over teeth"), "$z_w$", "", counted))
        rows.append(Parameter(tr("span"), "$W$", mm, tuple("" if each is None else _mm(each.length) for each in spans)))
    return rows


def _radius(one: WheelSizes, circle: Circle) -> float:
    return float(getattr(one, circle))


def draw_parameters(drawing: Drawing, box: Box, found: MeshPair) -> None:
    """Two tables with lines: what both wheels have in common, then the wheels."""
    common, wheels = of_pair(found), of_wheels(found)
    upper, _ = box.split(len(common) + 1, len(wheels) + 1, gap=APART)
    head = (tr("Quantity"), tr("Designation"), tr("Unit"))
    below = box.top - draw_table(drawing, upper, (*head, tr("Value")), _told(common), LETTERS)
    lower = Box(box.left, box.bottom, box.right, below - APART)
    named = tuple(plain(sizes.name) for sizes in found.sizes)
    draw_table(drawing, lower, (*head, *(tr("wheel {wheel}", wheel=name) for name in named)), _told(wheels), LETTERS)


def _told(rows: Sequence[Parameter]) -> list[tuple[str, ...]]:
    return [(each.name, each.symbol, each.unit, *each.values) for each in rows]


def draw_quality(drawing: Drawing, box: Box, found: MeshPair) -> None:
    """The figures of quality with their limits, and whether these are kept."""
    verdicts = {"ok": tr("kept"), "warn": tr("not recommended"), "fail": tr("not kept")}
    rows = []
    for check in found.checks:
        least = check.limit is None or math.isclose(check.margin, check.value - check.limit, abs_tol=1e-12)
        limit = (
            "" if check.limit is None else f"{AT_LEAST if least else AT_MOST} {_figure(check, check.limit, short=True)}"
        )
        judged = check.limit is not None or check.verdict != "ok"
        whose = _whose(found, check.wheel)
        verdict = verdicts[check.verdict] if judged else ""
        rows.append((check_called(check), whose, _figure(check, check.value), limit, verdict))
    head = tr("Figure of quality"), tr("wheel"), tr("Value"), tr("Limit"), tr("Condition")
    below = box.top - draw_table(drawing, box.inset(0, 3 * NOTE, 0, 0), head, rows, LETTERS)
    said = tr("lengths in modules: interference, undercut, tip thickness, clearance")
    drawing.add(Words(complex(box.left, below - 2.0), said, NOTE, -1 + 1j))


def _whose(found: MeshPair, wheel: int) -> str:
    if wheel == 2 and found.task.kind == "rack":
        return tr("rack")
    return plain(found.task.wheels[wheel - 1]) if wheel else ""


def check_called(check: Check) -> str:
    """The name of a figure in the language in force."""
    names = {
        "pressure": tr("specific pressure"),
        "fillet 1 interference": tr("interference with the fillet of the pinion"),
        "fillet 2 interference": tr("interference with the fillet of the ring"),
        "trochoid interference": tr("tips outside the line of action"),
        "trimming interference": tr("radial assembly"),
    }
    return names.get(check.name) or tr_name(check.name)


def _figure(check: Check, value: float, *, short: bool = False) -> str:
    """A value of a check: an angle in degrees, else as it is, in as few digits as it has if ``short``."""
    if check.name == "pressure angle":
        return f"{number(round(math.degrees(value), 3), 7)}°"
    return minus(number(round(value, PLACES) + 0.0)) if short else _fixed(value)


def contact_values(pair: PlacedPair) -> list[Row]:
    """Sliding and pressure at the ends of the contact, where one pair of teeth takes over, and at P."""
    line = pair.found.line
    begins = line.begins > line.start * (1 + ALIKE) + ALIKE * pair.found.task.module
    ends = line.ends < line.end * (1 - ALIKE)
    points = [("F1" if begins else "A2", line.begins), ("P", line.pitch), ("F2" if ends else "A1", line.ends)]
    points += singles(pair)
    points = sorted((point for point in points if point[1] > 0), key=lambda point: point[1])
    values = course(pair.found, np.array([rho for _, rho in points]))
    rows: list[Row] = [Heading(("", f"$ρ_1$, {tr_unit('mm')}", "$θ_1$", "$θ_2$", "$λ$"))]
    for k, (name, rho) in enumerate(points):
        numbers = (values.theta1[k], values.theta2[k], values.pressure[k])
        rows.append((point_sign(name), _mm(rho), *(_fixed(float(v)) for v in numbers)))
    if begins or ends:
        rows.append((tr("the contact is shorter than $A_2A_1$: fillet or undercut"),))
    if singles(pair):
        rows.append((tr("shaded: two pairs of teeth touch; from $B_2$ to $B_1$ one"),))
    return rows


def _fixed(value: float) -> str:
    """Four decimals with a true minus sign."""
    return tr_number(minus(f"{round(value, PLACES) + 0.0:.{PLACES}f}"))
