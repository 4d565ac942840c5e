"""The path of the gripper: an arc about its centre, a line, a polyline with its corners (2.90 to 2.95).

An arc in the plane is counted from the axis x, one in space from its chord, or from the side before a rounded corner.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.notes.told import AXES, Told
from tmmcalc.manipulators.routes import Bow, Piece, bow_of, corners_of, line
from tmmcalc.manipulators.task import ArcRoute, ArcThrough, PathTask, PolyRoute
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Place, Table
from tmmcalc.report.sheets.piece import Piece as PicturePiece
from tmmcalc.report.telling import column_of, lines, named, pictured

HALF_CIRCLE = 1e-9  # of a turn from half a turn: the centre is in the middle of the chord
SHOWN = 3  # corners that are worked out by numbers


def path(told: Told, picture: PicturePiece) -> Iterator[Block]:
    """What settles the path, its picture, and the table of its pieces."""
    asked = told.task.motion
    assert isinstance(asked, PathTask)
    route = asked.route
    if isinstance(route, PolyRoute):
        yield from _polyline(told, route)
    else:
        yield from _arc(told, route)
    yield seen(told)
    yield pictured(picture, key="manipulator_path")
    yield from _pieces(told)


def seen(told: Told) -> Paragraph:
    """What the picture of the path shows."""
    if told.arm.spatial:
        return Paragraph(
            tr(
                "Figure {fig:manipulator_path} shows the path of the gripper from above and in the plane of the arm; "
                "its points are equally spaced in time, so where they are close the gripper is slow."
            )
        )
    return Paragraph(
        tr(
            "Figure {fig:manipulator_path} shows the path of the gripper with the arm in several places; the points "
            "of the path are equally spaced in time, so where they are close the gripper is slow."
        )
    )


def unit_vector(name: str, told: Told, values: Values, meaning: str) -> Lexicon:
    """The projections of a unit vector."""
    return {f"{name}{axis}": Given(float(each), "", meaning) for axis, each in zip(told.axes, values, strict=True)}


def point(index: str, told: Told, values: Sequence[float] | Values, meaning: str) -> Lexicon:
    """The coordinates of a point."""
    return {f"{axis}_{index}": Given(float(each), "m", meaning) for axis, each in zip(told.axes, values, strict=True)}


def arc_quantities(told: Told, piece: Piece) -> Lexicon:
    """Centre, radius, angles, and in space the axes from which the angle is counted."""
    if piece.radius is None or piece.centre is None:
        return {}
    found = {
        **point("c", told, piece.centre, tr("coordinates of the centre of the arc")),
        "R": Given(piece.radius, "m", tr("radius of the arc")),
        "theta_1": Given(piece.theta, "rad", tr("angle of the beginning of the arc about its centre")),
        "theta_2": Given(piece.theta_end, "rad", tr("angle of the end of the arc about its centre")),
        "q": Given(float(piece.sense), "", tr("sense of the motion along the arc, +1 counter-clockwise")),
    }
    if told.arm.spatial:
        found |= unit_vector("e_1", told, piece.e1, tr("unit vector from which the angle of the arc is counted"))
        found |= unit_vector("e_2", told, piece.e2, tr("unit vector across it in the plane of the arc"))
    return found


def _squares(told: Told, text: str, join: str = " + ") -> str:
    """A term of each axis, % being its letter, one after another."""
    return join.join(text.replace("%", axis) for axis in told.axes)


def _arc(told: Told, route: ArcRoute | ArcThrough) -> Iterator[Block]:
    """The centre, the angles and the length of the one arc of the path."""
    ((piece,),) = told.legs
    bow = bow_of(route)
    lexicon = named({**_ends(told, route), **arc_quantities(told, piece), **_bow(told, route, bow, piece)})
    place = [Place("", lexicon)]
    yield Paragraph(
        tr("The gripper goes along the shorter arc of the given radius.")
        if isinstance(route, ArcRoute)
        else tr("The gripper goes along the arc through three given points.")
    )
    yield from lines([f"d = sqrt({_squares(told, '(%_2 - %_1)**2')})"], place)
    half = abs(abs(piece.theta_end - piece.theta) - math.pi) < HALF_CIRCLE
    if half and isinstance(route, ArcRoute):
        yield Paragraph(tr("The radius is half the distance of the ends: the centre is in the middle between them."))
    yield from lines(list(_centre(told, route, piece, half=half)), place)
    yield from lines(list(_angles(told, piece)), place)
    yield from lines(["q = (theta_2 - theta_1)/abs(theta_2 - theta_1)", "S_m = R*abs(theta_2 - theta_1)"], place)


def _ends(told: Told, route: ArcRoute | ArcThrough) -> Lexicon:
    """The given points."""
    found = {
        **point("1", told, route.start, tr("coordinates of the start of the path")),
        **point("2", told, route.end, tr("coordinates of the end of the path")),
    }
    if isinstance(route, ArcThrough):
        found |= point("v", told, route.via, tr("coordinates of the point that the arc goes through"))
    elif told.arm.spatial:
        found |= {
            f"n_{axis}": Given(float(each), "", tr("normal of the plane of the arc"))
            for axis, each in zip(AXES, route.normal, strict=True)
        }
    return found


def _bow(told: Told, route: ArcRoute | ArcThrough, bow: Bow, piece: Piece) -> Lexicon:
    """The chord, and where the centre is beside it."""
    found = {
        "d": Given(bow.chord, "m", tr("distance of the ends of the arc")),
        "S_m": Given(piece.length, "m", tr("length of the path")),
        "h_c": Given(bow.height, "m", tr("height of the centre above the chord, to its left")),
    }
    if isinstance(route, ArcThrough):
        found |= {
            "a_v": Given(bow.via[0], "m", tr("way along the chord to the foot of this point")),
            "b_v": Given(bow.via[1], "m", tr("height of this point above the chord")),
        }
        if not told.arm.spatial:
            found |= unit_vector("e_1", told, bow.along, tr("unit vector along the chord"))
            found |= unit_vector("e_2", told, bow.left, tr("unit vector across the chord, to the point"))
        return found
    turn = abs(piece.theta_end - piece.theta)
    return found | {
        "K": Given(float(route.side), "", tr("side of the centre: +1 left of the way from start to end, −1 right")),
        "phi_0": Given(math.degrees(np.angle(complex(*bow.along[:2]))), "deg", tr("direction from start to end")),
        "beta": Given(math.degrees(math.pi - turn) / 2, "deg", tr("angle between the chord and the radius")),
    }


def _centre(told: Told, route: ArcRoute | ArcThrough, piece: Piece, *, half: bool) -> Iterator[str]:
    """The formulas of the centre."""
    if isinstance(route, ArcRoute) and half:
        yield from (f"{axis}_c = ({axis}_1 + {axis}_2)/2" for axis in told.axes)
    if isinstance(route, ArcRoute) and not told.arm.spatial:
        if not half:
            yield from ("phi_0 = atan2(y_2 - y_1, x_2 - x_1)", "beta = acos(d/(2*R))")
            yield from ("x_c = x_1 + R*cos(phi_0 + K*beta)", "y_c = y_1 + R*sin(phi_0 + K*beta)")
        return
    yield from (f"e_1{axis} = ({axis}_2 - {axis}_1)/d" for axis in told.axes)
    if isinstance(route, ArcThrough):
        yield f"a_v = {_squares(told, '(%_v - %_1)*e_1%')}"
        yield f"b_v = sqrt({_squares(told, '(%_v - %_1 - a_v*e_1%)**2')})"
        yield from (f"e_2{axis} = ({axis}_v - {axis}_1 - a_v*e_1{axis})/b_v" for axis in told.axes)
        yield "h_c = (a_v**2 - a_v*d + b_v**2)/(2*b_v)"
    else:
        across = {"x": "n_y*e_1z - n_z*e_1y", "y": "n_z*e_1x - n_x*e_1z", "z": "n_x*e_1y - n_y*e_1x"}
        size = " + ".join(f"({each})**2" for each in across.values())
        yield from (f"e_2{axis} = ({each})/sqrt({size})" for axis, each in across.items())
        if half:
            return
        yield "h_c = K*sqrt(R**2 - (d/2)**2)"
    yield from (f"{axis}_c = ({axis}_1 + {axis}_2)/2 + h_c*e_2{axis}" for axis in told.axes)
    if isinstance(route, ArcThrough):
        yield f"R = sqrt({_squares(told, '(%_1 - %_c)**2')})"


def _angles(told: Told, piece: Piece) -> Iterator[str]:
    """The angles of both ends, the second one continuous from the first."""
    if told.arm.spatial:
        first, second = "atan2(-h_c, -d/2)", "atan2(-h_c, d/2)"
    else:
        first, second = "atan2(y_1 - y_c, x_1 - x_c)", "atan2(y_2 - y_c, x_2 - x_c)"
    yield f"theta_1 = {first}"
    turns = np.ceil((abs(piece.theta_end) - math.pi) / (2 * math.pi) - HALF_CIRCLE)
    whole = "" if turns <= 0 else f" {'+' if piece.theta_end > 0 else '-'} 2*pi"
    yield f"theta_2 = {second}{whole}"


def _polyline(told: Told, route: PolyRoute) -> Iterator[Block]:
    """The sides between the points, the rounded corners between the sides."""
    corners, _ = corners_of(route)
    sides = [line(a, b) for (_, a), (_, b) in pairwise(corners)]
    places = []
    for ((k, begin), (j, end)), side in zip(pairwise(corners), sides, strict=True):
        found = {
            **point("1", told, begin, tr("coordinates of the beginning of the line")),
            **point("2", told, end, tr("coordinates of the end of the line")),
            "l": Given(side.length, "m", tr("length of the line")),
            **unit_vector("u_", told, side.e1, tr("unit vector along the line")),
        }
        name = tr("from point {first} to point {second}", first=k, second=j) if len(sides) > 1 else ""
        places.append(Place(name, named(found)))
    if len(sides) > 1:
        yield Paragraph(
            tr("The gripper goes along lines between the given points; arcs round the corners.")
            if route.corner
            else tr("The gripper goes along lines between the given points and stops at each corner.")
        )
        yield from _points(told, route)
    else:
        yield Paragraph(tr("The gripper goes along a straight line."))
    length = f"l = sqrt({_squares(told, '(%_2 - %_1)**2')})"
    yield from lines([length, *(f"u_{axis} = ({axis}_2 - {axis}_1)/l" for axis in told.axes)], places[: SHOWN + 1])
    if route.corner and len(sides) > 1:
        yield from _rounded(told, corners, sides)


def _points(told: Told, route: PolyRoute) -> Iterator[Block]:
    """The given points."""
    yield Paragraph(tr("The points are in table {table}.", table="{tab:manipulator_points}"))
    columns = [column_of([place[k] for place in route.points]) for k in range(len(told.axes))]
    head = (tr("Point"), *(f"${axis}$, {tr_unit('m')}" for axis in told.axes))
    labels = [str(k) for k, _ in enumerate(route.points, 1)]
    rows = tuple(zip(labels, *columns, strict=True))
    yield Table(tr("Points of the path"), head, rows, "manipulator_points")


def _rounded(told: Told, corners: Sequence[tuple[int, Values]], sides: Sequence[Piece]) -> Iterator[Block]:
    """The arcs that touch both sides of a corner: where they begin, their centres, angles and lengths."""
    arcs = [piece for leg in told.legs for piece in leg if piece.radius is not None]
    places: dict[str, list[Place]] = {}
    for (number, corner), (before, after) in zip(corners[1:-1], pairwise(sides), strict=True):
        cut = next((arc for arc in arcs if _touches(arc, corner, before, after)), None)
        if cut is None or cut.radius is None or sum(map(len, places.values())) >= SHOWN:
            continue
        found = {
            **arc_quantities(told, cut),
            **point("2", told, corner, tr("coordinates of the corner")),
            **point("s", told, cut.start, tr("coordinates of the beginning of the arc")),
            **unit_vector("u_", told, before.e1, tr("unit vector along the line before the corner")),
            **unit_vector("w_", told, after.e1, tr("unit vector along the line after the corner")),
            "kappa": Given(abs(cut.theta_end - cut.theta), "rad", tr("angle by which the path turns at the corner")),
            "c": Given(
                float(np.linalg.norm(corner - cut.start)), "m", tr("way from the corner to both ends of the arc")
            ),
            "S": Given(cut.length, "m", tr("length of the arc")),
        }
        turned = "" if told.arm.spatial else "+" if cut.sense > 0 else "-"
        places.setdefault(turned, []).append(Place(tr("at point {number}", number=number), named(found)))
    every = [place for own in places.values() for place in own]
    if not every:
        return
    yield Paragraph(tr("An arc of the radius $R$ touches both lines of a corner:"))
    axes = told.axes
    across = {axis: f"({f'w_{axis} - u_{axis}*cos(kappa)'})/sin(kappa)" for axis in axes}
    centre = [f"{axis}_c = {axis}_s + R*({across[axis].partition('/')[0]})/sin(kappa)" for axis in axes]
    texts = [f"kappa = acos({_squares(told, 'u_%*w_%')})", "c = R*tan(kappa/2)"]
    texts += [f"{axis}_s = {axis}_2 - c*u_{axis}" for axis in axes]
    yield from lines([*texts, *centre, "S = R*kappa"], every)
    if told.arm.spatial:
        yield Paragraph(
            tr(
                "The angle of the arc is counted from the direction $e_1 = u$ of the line before it; across it "
                "is $e_2$:"
            )
        )
        yield from lines([f"e_2{axis} = ({axis}_c - {axis}_s)/R" for axis in axes], every)
        yield from lines(["theta_1 = -pi/2", "theta_2 = theta_1 + kappa"], every)
        return
    yield from lines(["theta_1 = atan2(y_s - y_c, x_s - x_c)"], every)
    for sign, own in places.items():
        yield from lines([f"theta_2 = theta_1 {sign} kappa"], own)


def _touches(arc: Piece, corner: Values, before: Piece, after: Piece) -> bool:
    """Whether an arc rounds the corner between two lines."""
    inward, outward = corner - arc.start, arc.end - corner
    near = 1e-6 * (before.length + after.length)
    return bool(
        np.linalg.norm(inward - before.e1 * (inward @ before.e1)) < near
        and np.linalg.norm(outward - after.e1 * (outward @ after.e1)) < near
        and abs((inward @ before.e1) - (outward @ after.e1)) < near
        and inward @ before.e1 > 0
    )


def _pieces(told: Told) -> Iterator[Block]:
    """All pieces of the path, with the times at which they begin."""
    pieces = [piece for leg in told.result.legs for piece in leg.pieces]
    if len(pieces) < 2:
        return
    yield Paragraph(tr("The pieces of the path are in table {table}.", table="{tab:manipulator_pieces}"))
    kinds = [tr("line") if piece.radius is None else tr("arc") for piece in pieces]
    lengths = column_of([piece.length for piece in pieces])
    begins = column_of([piece.begin for piece in pieces])
    ends = [column_of([piece.end[k] for piece in pieces]) for k in range(len(told.axes))]
    head = (
        tr("Piece"),
        tr("Kind"),
        f"$S$, {tr_unit('m')}",
        *(f"${axis}_e$, {tr_unit('m')}" for axis in told.axes),
        f"$t_b$, {tr_unit('s')}",
    )
    labels = [str(k) for k, _ in enumerate(pieces, 1)]
    rows = tuple(zip(labels, kinds, lengths, *ends, begins, strict=True))
    caption = tr("Pieces of the path: length, end and the time of the beginning")
    yield Table(caption, head, rows, "manipulator_pieces")
