"""The tables on the sheets of a pair, in mm: its parameters, sliding and pressure at the ends of the contact."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.pictures.listing import Heading, Row
from tmmcalc.gears.pictures.placedpair import ALIKE, SIGNS, Circle, PlacedPair
from tmmcalc.gears.pictures.slidingcurves import course, singles
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.numbers import number

NAMES: dict[Circle, str] = {
    "reference": "reference circle",
    "operating": "pitch circle",
    "tip": "tip circle",
    "root": "root circle",
    "base": "base circle",
}


def _mm(value: float) -> str:
    return minus(number(round(1e3 * value, 3), 7))


def _degrees(value: float) -> str:
    return f"{number(math.degrees(value), 6)}°"


def parameters(found: MeshPair) -> list[Row]:
    """The table of parameters: of the pair, then of both wheels, in mm."""
    task, rack = found.task, found.task.rack
    length = "$a_w$" if task.kind != "rack" else "axis to datum line"
    rows: list[Row] = [
        Heading(("Pair",)),
        ("module $m$", "", _mm(task.module)),
        ("rack: $α$, $h_a^*$, $c^*$", "", f"{_degrees(rack.angle)}, {rack.addendum:g}, {rack.clearance:g}"),
        ("helix angle $β$", "", _degrees(task.helix)),
        ("face width $b$", "", _mm(task.face_width)) if task.face_width else (),
        (length, "", _mm(found.distance)),
        ("reference distance $a$", "", _mm(found.reference_distance)) if task.kind != "rack" else (),
        ("pressure angle $α_{tw}$", "", _degrees(found.angle_w)),
        ("modification $y$", "", minus(number(round(found.modification, 5), 5))) if task.kind != "rack" else (),
        ("tip shortening $Δ$$y$", "", minus(number(round(found.shortening, 5), 5))) if task.kind == "external" else (),
        ("contact ratio $ε_α$", "", number(found.contact_ratio, 5)),
        ("with the flanks left", "", number(found.shortened, 5)) if _shortened(found) else (),
        ("overlap ratio $ε_β$", "", number(found.overlap, 5)) if found.overlap else (),
        ("total $ε_γ$", "", number(found.total, 5)) if found.overlap else (),
        ("active length $A_2A_1$", "", _mm(found.line.end - found.line.start)),
        Heading(("Wheel", *(sizes.name for sizes in found.sizes))),
    ]
    return [row for row in [*rows, *_of_wheels(found)] if row]


def _shortened(found: MeshPair) -> bool:
    return found.shortened < found.contact_ratio - 1e-9


def _of_wheels(found: MeshPair) -> list[Row]:
    sizes = found.sizes
    rows: list[Row] = [
        ("teeth $z$", *(str(one.teeth) for one in sizes)),
        ("shift $x$", *(minus(number(round(one.shift, 5), 5)) for one in sizes)),
    ]
    for circle, name in NAMES.items():
        index = SIGNS[circle]
        rows.append((f"{name} $r_{index}$" if index else f"{name} $r$", *(_mm(getattr(one, circle)) for one in sizes)))
    rows += [
        ("end of involute $r_F$", *(_mm(one.form) for one in sizes)),
        ("active to $r_p$", *(_mm(one.active) for one in sizes)),
        ("thickness $s_n$", *(_mm(one.thickness) for one in sizes)),
        ("at the tip $s_{na}$", *(_mm(one.tip_thickness) for one in sizes)),
        ("clearance at the root", *(_mm(value) for value in found.clearances[: len(sizes)])),
    ]
    spans = [measures.span for measures in found.measures]
    if any(spans):
        rows.append(("span over teeth $z_w$", *("" if span is None else str(span.teeth) for span in spans)))
        rows.append(("span $W$", *("" if span is None else _mm(span.length) for span in spans)))
    return rows


def contact_values(pair: PlacedPair) -> list[Row]:
    """Sliding and pressure at the ends of the contact, where one pair of teeth takes over, and at P."""
    line = pair.found.line
    begins = line.begins > line.start * (1 + ALIKE) + ALIKE * pair.found.task.module
    ends = line.ends < line.end * (1 - ALIKE)
    points = [("F1" if begins else "A2", line.begins), ("P", line.pitch), ("F2" if ends else "A1", line.ends)]
    points += singles(pair)
    points = sorted((point for point in points if point[1] > 0), key=lambda point: point[1])
    values = course(pair.found, np.array([rho for _, rho in points]))
    rows: list[Row] = [Heading(("", "$ρ_1$, mm", "$ϑ_1$", "$ϑ_2$", "$λ$"))]
    for k, (name, rho) in enumerate(points):
        numbers = (values.theta1[k], values.theta2[k], values.pressure[k])
        sign = f"${name[0]}_{name[1]}$" if len(name) > 1 else f"${name}$"
        rows.append((sign, _mm(rho), *(_fixed(float(v)) for v in numbers)))
    if begins or ends:
        rows.append(("the contact is shorter than $A_2A_1$: fillet or undercut",))
    if singles(pair):
        rows.append(("shaded: two pairs of teeth touch; from $B_2$ to $B_1$ one",))
    return rows


def _fixed(value: float) -> str:
    """Four decimals with a true minus sign."""
    return minus(f"{round(value, 4) + 0.0:.4f}")
