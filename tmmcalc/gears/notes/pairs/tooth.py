"""The profile of a tooth: formulas of a point of the involute and of one of the fillet, the points, the picture."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import atan, atan2, cos, hypot, nan, pi, sin, tan

from tmmcalc.gears.involute.profile.rounding import rounding
from tmmcalc.gears.meshing.booktables import CENTRE, CUT, MAIN, RADIUS, ROLL, BookTables, X, Y, book_tables
from tmmcalc.gears.meshing.halftooth import fault_of, half_tooth
from tmmcalc.gears.meshing.members import Toothed
from tmmcalc.gears.meshing.results import NOISE
from tmmcalc.gears.notes.pairs.lexicon import HELICAL, MINUS, PLUS, SPUR, angle, length, of_rack, worked_out
from tmmcalc.gears.pictures.toothpoints import INTERVALS, draw_tooth, textbook_points
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Lexicon, Paragraph, Place
from tmmcalc.report.telling import named, tabulated

SIZE = 96.0, 72.0  # of the picture of a tooth, which stands beside the table of its points [mm]
PSI = "psi = (pi/2 + 2*x*tan(alpha))/z"
TIP = "phi_A = tan(alpha_a) - tan(<t>)"
LIMIT = "phi_L = m*(x - <hl>)/(r*sin(<t>)*cos(<t>))"
INVOLUTE = (
    "F_T = phi_T - psi",
    "X_T = r*(sin(F_T) - phi_T*cos(<t>)*cos(F_T + rad(<t>)))",
    "Y_T = r*(cos(F_T) + phi_T*cos(<t>)*sin(F_T + rad(<t>))) - r_b",
    "R_T = r*(sin(<t>) + phi_T*cos(<t>))",
)
RING_INVOLUTE = (
    "alpha_T = atan(phi_T + tan(<t>))",
    "r_T = r_b/cos(alpha_T)",
    "psi_T = psi - inv(<t>) + inv(alpha_T)",
    "X_T = -r_T*sin(psi_T)",
    "Y_T = r_T*cos(psi_T) - r_b",
    "R_T = r_b*tan(alpha_T)",
)
ON_RACK = (
    "rho_t = m*<rho>",
    "x_{1S} = m*((x - <hl>)*tan(<t>) - <rho>*cos(<t>))",
    "y_{1S} = m*(x - <hl> + <rho>*sin(<t>))",
    "phi_D = x_{1S}/r",
)
BELOW, BEYOND = "rho_t + v**3/(v**2 - r*y_{1S})", "abs(rho_t + v**3/(r*y_{1S} - v**2))"
FILLET = (
    "F = phi - psi",
    "p = r*phi - x_{1S}",
    "v = sqrt(y_{1S}**2 + p**2)",
    "X_S = (y_{1S} + r)*sin(F) - p*cos(F)",
    "Y_S = (y_{1S} + r)*cos(F) + p*sin(F) - r_b",
    "X'_S = y_{1S}*cos(F) + p*sin(F)",
    "Y'_S = p*cos(F) - y_{1S}*sin(F)",
    "X = X_S <-> rho_t*Y'_S/v",
    "Y = Y_S <+> rho_t*X'_S/v",
    "R = <R>",
)


def tooth(member: Toothed, key: str, *, alike: bool = False) -> Iterator[Block]:
    """The tooth of a wheel that has a profile; nothing of a rack, whose flanks are straight.

    The formulas are left out where they are ``alike`` to those of a wheel before.
    """
    tables = None if fault_of(member) is not None else book_tables(member, "tooth", INTERVALS)
    if tables is None:
        return
    if alike:
        yield Paragraph(tr("The points are found by the same formulas as those of the wheel before."))
    else:
        yield from _formulas(tables)
    yield from _points(tables, key)


def _numbered(tables: BookTables, roll: float) -> str:
    """The number in the table of the point with this roll angle."""
    found = [each.number for each in textbook_points(tables) if each.roll is not None and abs(each.roll - roll) < NOISE]
    return found[0] if found else ""


def _formulas(tables: BookTables) -> Iterator[Block]:
    """The ends of the flank, a point of the involute and one of the fillet that a rounding cuts."""
    member = tables.member
    lexicon, words = named(_quantities(member) | _involute_point(tables)), _words(member)
    places = (Place("", lexicon),)
    yield Paragraph(
        tr("The origin lies on the base circle, axis Y along the tooth; the points are those of the left flank.")
    )
    yield from worked_out((PSI, TIP), places, words)
    roll = lexicon["phi_T"].value
    assert isinstance(roll, float)
    point = tr("Point {number} of the involute:", number=_numbered(tables, roll))
    if member.shape == "ring":
        yield Paragraph(point)
        yield from worked_out(RING_INVOLUTE, places, words)
    else:
        yield from worked_out((LIMIT,), places, words)
        yield Paragraph(point)
        yield from worked_out(INVOLUTE, places, words)
    if tables.rounded:
        lexicon |= named(_rounding(tables))
        if tables.apart:
            yield Paragraph(tr("A circle stands for the ellipse of the rounding across helical teeth."))
        yield from worked_out(ON_RACK, places, words)
        if found := _fillet_point(tables):
            lexicon |= named(found)
            roll = lexicon["phi"].value
            assert isinstance(roll, float)
            yield Paragraph(tr("Point {number} of the fillet:", number=_numbered(tables, roll)))
            yield from worked_out(FILLET, places, words)


def _words(member: Toothed) -> dict[str, str]:
    """Words of the formulas of a tooth; signs as the centre of the rounding lies below or beyond the rolling line."""
    helical, rack = member.wheel.helix > 0, member.wheel.rack
    below = member.shape == "ring" or float(rounding(member.wheel, "circle").y) < 0
    return {
        **(HELICAL if helical else SPUR),
        **(PLUS if below else MINUS),
        "R": BELOW if below else BEYOND,
        "rho": "rho_t^{*}" if helical else "rho^{*}",
        "hl": "h_a^{*}" if abs(rack.straight - rack.addendum) <= NOISE else "h_l^{*}",
    }


def _quantities(member: Toothed) -> Lexicon:
    """What the formulas of a tooth begin with."""
    m, half = member.module, half_tooth(member)
    limit, _, tip, _ = half.rolls
    wheel, ring = member.wheel, member.shape == "ring"
    psi = pi / wheel.teeth - float(wheel.half_angle) if ring else float(wheel.half_angle)
    return of_rack(wheel.rack) | {
        "z": Given(float(wheel.teeth), "", tr("number of teeth")),
        "x": Given(float(member.shift), "", tr("shift coefficient")),
        "m": length(m, tr("module")),
        "r": length(m * wheel.reference, tr("reference radius")),
        "r_b": length(m * wheel.base, tr("base radius")),
        "alpha_t": angle(wheel.transverse_angle, tr("transverse profile angle")),
        "alpha_a": angle(atan(tip + tan(wheel.transverse_angle)), tr("profile angle at the tip circle")),
        "rho_t^{*}": Given(wheel.section.radius, "", tr("radius of the rounding across the teeth in modules")),
        "psi": Given(psi, "rad", tr("half the angle of the tooth on the reference circle")),
        "phi_A": Given(tip, "rad", tr("roll angle at the tip")),
        "phi_L": Given(limit, "rad", tr("roll angle at the limit point")),
    }


def _involute_point(tables: BookTables) -> Lexicon:
    """The point in the middle of the table of the involute."""
    columns, k = tables.main.columns, len(tables.main.points) // 2
    roll = float(columns[ROLL.key][k])
    x, y, radius = (float(columns[each.of(of=MAIN).key][k]) for each in (X, Y, RADIUS))
    base = abs(tables.member.wheel.base) * tables.member.module
    psi = float(tables.member.wheel.half_angle)
    return {
        "phi_T": Given(roll, "rad", tr("roll angle of the point")),
        "F_T": Given(roll - psi, "rad", tr("roll angle from the axis of the tooth")),
        "X_T": length(x, tr("coordinate of the point")),
        "Y_T": length(y, tr("coordinate of the point")),
        "R_T": length(radius, tr("radius of curvature at the point")),
        "r_T": length(hypot(x, y + base), tr("radius of the point")),
        "alpha_T": angle(atan2(radius, base), tr("profile angle at the point")),
        "psi_T": Given(atan2(-x, y + base), "rad", tr("half the angle of the tooth at the point")),
    }


def _rounding(tables: BookTables) -> Lexicon:
    """The rounding of the rack that cuts the fillet: a circle about S."""
    tool, m = rounding(tables.member.wheel, "circle"), tables.member.module
    centre = tr("coordinates of the centre S of the rounding on the rack")
    return {
        "rho_t": length(tables.radius, tr("radius of the rounding of the rack")),
        "x_{1S}": length(m * float(tool.x), centre),
        "y_{1S}": length(m * float(tool.y), centre),
        "phi_D": Given(float(tool.roll(pi / 2)), "rad", tr("roll angle at the root circle")),
    }


def _fillet_point(tables: BookTables) -> Lexicon | None:
    """A point in the middle of the table of the fillet; None: its rounding has its centre on the rolling line.

    What the path of S gives is told from S and from the point Q of the reference circle about which the rack turns.
    """
    columns, names = tables.fillet.columns, tables.fillet.points
    inner = [k for k, name in enumerate(names) if not name and tables.fillet.cut[k]]
    if not inner:
        return None
    k = inner[len(inner) // 2]
    wheel, m = tables.member.wheel, tables.member.module
    roll = float(columns[ROLL.key][k])
    turned = roll - float(wheel.half_angle)
    x, y, radius = (float(columns[key][k]) for key in CUT)
    xs, ys = (float(columns[each.of(of=CENTRE).key][k]) for each in (X, Y))
    r, base = m * wheel.reference, m * wheel.base
    across, along = xs - r * sin(turned), ys + base - r * cos(turned)  # from Q to S
    rate = tr("derivative of the coordinate of S by the roll angle")
    return {
        "phi": Given(roll, "rad", tr("roll angle of the point")),
        "F": Given(turned, "rad", tr("roll angle from the axis of the tooth")),
        "p": length(along * sin(turned) - across * cos(turned), tr("distance of S along the rolling line")),
        "v": length(hypot(across, along), tr("distance of S from the point about which the rack turns")),
        "X_S": length(xs, tr("coordinate of S")),
        "Y_S": length(ys, tr("coordinate of S")),
        "X'_S": length(along, rate),
        "Y'_S": length(-across, rate),
        "X": length(x, tr("coordinate of the point")),
        "Y": length(y, tr("coordinate of the point")),
        "R": length(radius, tr("radius of curvature at the point")),
    }


def _points(tables: BookTables, key: str) -> Iterator[Block]:
    """The points of both curves, and the tooth with them."""
    found = textbook_points(tables)
    base = abs(tables.member.wheel.base) * tables.member.module
    rolled = (
        {} if found[0].roll is None else {"$phi$, rad": [nan if each.roll is None else each.roll for each in found]}
    )
    columns = {
        **rolled,
        "$X$, mm": [1e3 * each.at.real for each in found],
        "$Y$, mm": [1e3 * (each.at.imag - base) for each in found],
        "$R$, mm": [1e3 * each.radius for each in found],
    }
    said = tr(
        "Table {table} holds points from the tip to the root, figure {figure} shows them.",
        table=f"{{tab:{key}}}",
        figure=f"{{fig:{key}}}",
    )
    yield Paragraph(said)
    labels = [each.number for each in found]
    yield tabulated(
        tr("Points of the tooth profile of wheel {wheel}", wheel=tables.member.label),
        columns,
        labels,
        head=tr("Point"),
        key=key,
    )
    caption = tr("Tooth of wheel {wheel} by points", wheel=tables.member.label)
    yield Figure(caption, partial(draw_tooth, tables=tables), SIZE, key)
