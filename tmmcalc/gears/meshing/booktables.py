"""The textbook's tables of the main profile and of the fillet for any wheel, in metres (4.77 to 4.95).

The fillet of an external wheel is that of a circular rounding, whatever the rounding of the outline: across helical
teeth the circle rho_t stands for the ellipse.

Axes X-Omega-Y: the origin lies on the base circle, Y runs from the centre along the axis of the tooth or of the space,
or through the point of the flank on the operating pitch circle or on the reference circle.
"""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.quantity import Quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.flank import Flank, flank_of
from tmmcalc.gears.involute.profile.tables import Axis, axis_turn, fillet_table, main_profile
from tmmcalc.gears.meshing.halftooth import ProfilePart, half_tooth
from tmmcalc.gears.meshing.members import Toothed
from tmmcalc.gears.model import Values

ROLL = Quantity("phi[rad]", "roll angle")
X = Quantity("X{of}[m]", "X of a point")  # of the fillet; _T: of the main profile, _S: of the centre of the rounding
Y = Quantity("Y{of}[m]", "Y of a point")
RADIUS = Quantity("R{of}[m]", "radius of curvature of the curve, of S that of its path")
MAIN, CENTRE = "_T", "_S"
CUT = tuple(each.of(of="").key for each in (X, Y, RADIUS))  # what there is only where the rounding cuts the fillet


@record
class BookTable:
    """A table: headers with units and columns (n,); the names of its notable points, empty for the others."""

    points: tuple[str, ...]  # A: tip, L: limit point, F: form radius, D: root
    columns: dict[str, Values]
    cut: np.ndarray  # (n,) whether there is a point of the profile; where not, its columns are 0


@record
class BookTables:
    """Both tables of one wheel."""

    member: Toothed
    axis: Axis
    main: BookTable
    fillet: BookTable
    rounded: bool  # whether the fillet is that of a circular rounding, and has the columns of its centre S
    radius: float  # rho_t of that circle [m]; 0 if there is none
    apart: bool  # whether the outline has another fillet: that of the ellipse


def book_tables(
    member: Toothed,
    axis: Axis = "tooth",
    intervals: int = 10,
    rolls: Values | None = None,
    main_rolls: Values | None = None,
) -> BookTables | None:
    """The tables of one wheel in ``intervals`` equal steps.

    ``rolls`` [rad] are the roll angles of the fillet if they are given, ``main_rolls`` those of the involute, which has
    its ends beside those between them. None for a rack, whose flanks are straight. Raises `NoSolutionError` if the
    wheel has no profile, `UsageError` if rolls are asked of a fillet that no circular rounding cuts.
    """
    if member.shape == "rack":
        return None
    half, turn = half_tooth(member), _turn(member, axis)
    circle = _circular(member)
    if rolls is not None and circle is None:
        raise UsageError(
            f"wheel {member.label}: the table over the roll angle is that of a circular rounding of a rack",
            where="--fillet",
            remedy="name an external wheel with --wheel",
        )
    if member.shape == "ring":
        main = _sampled(member, half.flank, _steps(half.flank, intervals, main_rolls), turn)
    else:
        main = _main(member.flank, turn, intervals, main_rolls, member.module)
    if circle is None:
        fillet = _sampled(member, half.fillet, _steps(half.fillet, intervals), turn)
        return BookTables(member, axis, main, fillet, False, 0.0, False)
    fillet = _fillet(circle, turn, intervals, rolls, member.module)
    own = member.flank.rounding
    radius = member.module * circle.rounding.height
    return BookTables(member, axis, main, fillet, True, radius, own.width != own.height)


def _circular(member: Toothed) -> Flank | None:
    """The flank with a circular rounding; None: a ring, or a circle that is too wide for the rack."""
    if member.shape != "external":
        return None
    try:
        return flank_of(member.wheel, member.tip, "circle")
    except NoSolutionError:
        return None


def _turn(member: Toothed, axis: Axis) -> float:
    """The angle [rad] from the flank's point on the reference circle to the axis Y."""
    if member.shape == "external":
        return axis_turn(member.wheel, axis, member.angle)
    psi, start = _half_angle(member), float(involute(member.wheel.transverse_angle))
    turns = {
        "reference": 0.0,
        "tooth": psi,
        "space": psi - member.half_pitch,
        "pitch": start - float(involute(member.angle)),
    }
    return turns[axis]


def _half_angle(member: Toothed) -> float:
    """psi [rad] of the tooth of a ring: what its space leaves."""
    return pi / member.wheel.teeth - float(member.wheel.half_angle)


def _main(flank: Flank, turn: float, intervals: int, rolls: Values | None, m: float) -> BookTable:
    table = main_profile(flank, turn, intervals, rolls)
    last = "F" if flank.wheel.limit < 0 else "L"
    columns = {ROLL.key: table.roll} | _headed(MAIN, m * table.x, m * table.y, m * table.radius)
    return BookTable(("A", *[""] * (len(table.roll) - 2), last), columns, np.ones(len(table.roll), bool))


def _headed(of: str, x: Values, y: Values, radius: Values) -> dict[str, Values]:
    return {X.of(of=of).key: x, Y.of(of=of).key: y, RADIUS.of(of=of).key: radius}


def _fillet(flank: Flank, turn: float, intervals: int, rolls: Values | None, m: float) -> BookTable:
    ends = flank.rolls
    if rolls is None:
        # a centre on the rolling line cuts the whole fillet at one roll angle
        rolls = np.linspace(ends.root, ends.limit, intervals + 1)[1:-1] if ends.root != ends.limit else np.zeros(0)
    table = fillet_table(flank, turn, rolls)
    columns = {
        ROLL.key: table.roll,
        X.of(of=CENTRE).key: m * table.centre_x,
        Y.of(of=CENTRE).key: m * table.centre_y,
        X.of(of="").key: m * table.x,
        Y.of(of="").key: m * table.y,
        RADIUS.of(of=CENTRE).key: m * table.centre_radius,
        RADIUS.of(of="").key: m * table.radius,
    }
    return BookTable((*[""] * (len(table.roll) - 2), "L", "D"), columns, table.cut)


def _steps(part: ProfilePart, intervals: int, rolls: Values | None = None) -> Values:
    """Parameters of a part from the tip towards the root: equal steps, or those of roll angles of an involute."""
    first, last = part.curve.end, part.curve.start
    if rolls is None:
        return np.linspace(first, last, intervals + 1)
    start = last - float(part.roll(np.array([last]))[0])  # the parameter of an involute is phi + tan(alpha_t)
    given = np.sort(rolls + start)
    inside = given[(given > min(first, last)) & (given < max(first, last))]
    return np.concatenate([[first], inside if first < last else inside[::-1], [last]])


def _sampled(member: Toothed, part: ProfilePart, at: Values, turn: float) -> BookTable:
    """A part of the profile at parameters (n,) from the tip towards the root."""
    m, involute_part = member.module, part.name == "involute"
    psi = _half_angle(member) if member.shape == "ring" else float(member.wheel.half_angle)
    places = part.curve.point(at) * np.exp(1j * (turn - psi)) - 1j * abs(member.wheel.base)
    columns = {ROLL.key: part.roll(at)}
    columns |= _headed(MAIN if involute_part else "", m * places.real, m * places.imag, m * np.abs(part.radius(at)))
    first, last = ("A", "F") if involute_part else ("F", "D")
    return BookTable((first, *[""] * (len(at) - 2), last), columns, np.ones(len(at), bool))
