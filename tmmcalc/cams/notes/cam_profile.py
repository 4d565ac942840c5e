"""The chapter on cams, its third part: points of pitch curve and walls, curvature with its limits, the cam to scale."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import isclose, isfinite

import numpy as np

from tmmcalc.cams.follower import Complex, Follower, contact_path
from tmmcalc.cams.further import of_profile
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.notes.cam_synthesis import of_limits
from tmmcalc.cams.notes.lexicon import (
    Told,
    angle,
    degrees_of,
    dwell_of,
    mm,
    of_follower,
    of_motion,
    of_values,
    shown_unit,
    table_rows,
    told_of,
    where,
)
from tmmcalc.cams.pictures.cam_profile import draw_cam, height_of
from tmmcalc.cams.pictures.curvature import draw_bends, names_of
from tmmcalc.cams.pictures.pieces import NAMES
from tmmcalc.cams.pictures.wording import sense_of, wall_name
from tmmcalc.cams.profile.columns import curves_of
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Place as Bend
from tmmcalc.cams.profile.results import Profile, Reach, Wall
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import SIDES, stacked
from tmmcalc.report.drawing.diagram import key_rows
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import WIDE, column, headed, lines, named

STEM = (
    "x = e*cos(phi) <-> S*sin(phi)",
    "y = S*cos(phi) <+> e*sin(phi)",
    "x' = <s->((S' <+> e)*sin(phi) + S*cos(phi))",
    "y' = (S' <+> e)*cos(phi) - S*sin(phi)",
)
ROCKER = (
    "beta = phi <d-> psi",
    "x = l_0*cos(phi) - l_2*cos(beta)",
    "y = <s>(l_0*sin(phi) - l_2*sin(beta))",
    "x' = l_2*(1 <d-> psi')*sin(beta) - l_0*sin(phi)",
    "y' = <s>(l_0*cos(phi) - l_2*(1 <d-> psi')*cos(beta))",
)
ROCKER_BENDS = (
    "x'' = l_2*((1 <d-> psi')**2*cos(beta) <d-> psi''*sin(beta)) - l_0*cos(phi)",
    "y'' = <s>(l_2*((1 <d-> psi')**2*sin(beta) <d+> psi''*cos(beta)) - l_0*sin(phi))",
)
FLAT = ("x_w = <s->(S'*cos(phi) + S*sin(phi))", "y_w = S*cos(phi) - S'*sin(phi)", "rho_w = S + S''")
ARC = "w = sqrt(x'**2 + y'**2)"
WALLS = {  # curves by the index of their points
    "inner": ("x_w = x <-> r_2*y'/w", "y_w = y <+> r_2*x'/w"),
    "outer": ("x_o = x <+> r_2*y'/w", "y_o = y <-> r_2*x'/w"),
    "tool": ("x_t = x <+> (r_t - r_2)*y'/w", "y_t = y <-> (r_t - r_2)*x'/w"),
    "outer tool": ("x_{to} = x <-> (r_t - r_2)*y'/w", "y_{to} = y <+> (r_t - r_2)*x'/w"),
}
BENT = "D = <s>(x'*y'' - x''*y')", "rho = w**3/D"
STEM_ARC = "w = sqrt(S**2 + (S' <+> e)**2)"
STEM_BENT = "D = w**2 + S'*(S' <+> e) - S*S''", "rho = w**3/D"
CENTRAL_BENT = "D = w**2 + S'**2 - S*S''", "rho = w**3/D"
DIGITS = 7  # of a coordinate: tenths of a micrometre
STRAIGHT = 1e-9  # of 1/R0: the curvature of a straight place
KEPT = 1e-9  # relative: a limit that is just reached is kept
HIGH, CURVATURE = 190.0, (WIDE, 75.0)  # of the picture of the cam at most, of its curvature [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Points at the shown positions, the table, curvature and what it allows, the pictures."""
    told, result = told_of(order), order.results["cam_profile"]
    yield Heading(tr("Profile of the cam"))
    yield Paragraph(_inverted(told))
    lexicon = told.named(of_follower(told.follower) | of_limits(told))
    if result.tool_radius is not None:
        lexicon["r_t"] = mm(result.tool_radius, tr("radius of the tool"))
    rows = [lexicon | told.named(_of_row(told, result, row)) for row in told.rows]
    places = [Place(told.labelled(row), own) for row, own in zip(told.rows, rows, strict=True)]
    yield from _points(told, result, places)
    yield from _table(order, told, result)
    yield from _curvature(told, result, places, lexicon)
    yield from _pictures(order, told, result)


def _inverted(told: Told) -> str:
    """The method, and where the axes lead."""
    moved = tr(
        "The cam turns {sense}. In the inverted motion it stands still and the rest turns against it.",
        sense=sense_of(told.follower),
    )
    return f"{moved} {axes_of(told.follower)}"


def axes_of(follower: Follower) -> str:
    """Where the axes of the cam lead."""
    if follower.kind == "oscillating":
        return tr("Axis $x$ leads from the axis of the cam to the pivot of the rocker at $phi$ = 0.")
    return tr("Axis $y$ leads along the lift at $phi$ = 0, axis $x$ to the right.")


def _words(told: Told) -> dict[str, str]:
    """The words of the follower, with the sign of a whole expression."""
    canonical = told.follower.sense > 0
    return {**told.words, "s": "" if canonical else "-", "s-": "-" if canonical else ""}


def _of_row(told: Told, result: Profile, row: int) -> Lexicon:
    """The motion and the curves in a row."""
    own = of_motion(told, row)
    own["phi"] = angle(float(told.law.positions.phi[row]), own["phi"].meaning)
    found = own | _of_path(told, told.law.positions.phi[row : row + 1], told.law.motion[:, row : row + 1])
    for index, points in curves_of(result):
        at = complex(points[row])
        ends = {"": ("x", "y")}.get(index.replace("c", ""), (f"x_{{{index}}}", f"y_{{{index}}}"))
        said = _coordinate(index)
        found |= {name: mm(part, said) for name, part in zip(ends, (at.real, at.imag), strict=True)}
    return found | _of_bends(told, result, row)


def _coordinate(index: str) -> str:
    words = {
        "c": tr("coordinates of the pitch curve"),
        "w": tr("coordinates of the working profile"),
        "o": tr("coordinates of the second wall"),
        "t": tr("coordinates of the centre of the tool"),
        "to": tr("coordinates of the centre of the tool along the second wall"),
    }
    return words[index]


def _of_path(told: Told, phi: Values, motion: Values) -> Lexicon:
    """The derivatives of the pitch curve at one angle."""
    follower = told.follower
    if follower.kind == "flat":
        return {}
    path: Complex = np.array([follower.placed(each)[0] for each in contact_path(follower, phi, motion)])
    first, second = path[1], path[2]
    once, twice = (
        tr("first derivatives of these coordinates by $phi$"),
        tr("second derivatives of these coordinates by $phi$"),
    )
    found = {
        "x'": mm(first.real, once),
        "y'": mm(first.imag, once),
        "x''": mm(second.real, twice),
        "y''": mm(second.imag, twice),
        "w": mm(abs(first), tr("derivative of the arc of the pitch curve by $phi$")),
    }
    if told.turns:
        lean = float(phi[0] - follower.assembly * (follower.start + motion[0, 0]))
        found["beta"] = angle(lean, tr("angle of the rocker in the inverted motion"))
    return found


def _of_bends(told: Told, result: Profile, row: int) -> Lexicon:
    """The radii of curvature in a row, where the curves are not straight."""
    found: Lexicon = {}
    pitch = None if result.pitch_curvature is None else float(result.pitch_curvature[row])
    if pitch is not None and abs(pitch) * told.follower.base > STRAIGHT:
        found |= _of_radius(told, told.law.positions.phi[row : row + 1], told.law.motion[:, row : row + 1], pitch)
    if abs(result.curvature[row]) * told.follower.base > STRAIGHT:
        found["rho_w"] = mm(1 / float(result.curvature[row]), tr("radius of curvature of the working profile"))
    return found


def _of_radius(told: Told, phi: Values, motion: Values, bend: float) -> Lexicon:
    """A radius of curvature of the pitch curve with its denominator."""
    arc = 1e3 * float(np.abs(contact_path(told.follower, phi, motion)[1, 0]))
    return {
        "rho": mm(1 / bend, tr("radius of curvature of the pitch curve, positive where it is convex")),
        "D": Given(1e-3 * bend * arc**3, "mm^2", tr("denominator of the radius of curvature")),
    }


def _points(told: Told, result: Profile, places: list[Place]) -> Iterator[Block]:
    """The coordinates at the shown positions."""
    words = _words(told)
    if result.flat:
        yield Paragraph(tr("The profile is the envelope of the lines of the face; its points:"))
        yield from lines(("S = S_0 + DeltaS", *FLAT[:2]), places, words)
        if result.tool is not None:
            yield Paragraph(tr("The centre of the tool lies outside of the profile by its radius $r_t$."))
        return
    yield Paragraph(tr("Points of the pitch curve, which the centre of the roller describes:"))
    yield from lines(("<y> = <y0> + <dy>", *(ROCKER if told.turns else STEM)), places, words)
    if result.follower.roller:
        yield Paragraph(
            tr("The working profile is the envelope of the circles of the roller, along the normal of the pitch curve:")
        )
    yield from lines((ARC,), places, words)
    for wall in result.walls:
        if wall.name == "outer":
            yield Paragraph(tr("The second wall of the groove lies on the other side of the roller:"))
        elif wall.name == "tool":
            yield Paragraph(tr("The centre of a tool of radius $r_t$ has this path:"))
        yield from lines(WALLS[wall.name], places, words)


def _table(order: Order, told: Told, result: Profile) -> Iterator[Block]:
    """The coordinates and radii of curvature over the turn, further curves in a table of their own."""
    rows = table_rows(told)
    labels = [told.law.labels[row] for row in rows]
    degrees = column("$phi$, deg", np.degrees(told.law.positions.phi)[rows])
    main: dict[str, list[str]] = {}
    further: dict[str, list[str]] = {}
    for index, points in curves_of(result):
        ends = ("x", "y") if index == "c" else (f"x_{{{index}}}", f"y_{{{index}}}")
        for name, part in zip(ends, (points.real, points.imag), strict=True):
            head, cells = column(f"${name}$, mm", 1e3 * part[rows], DIGITS)
            (main if index in "cw" else further)[head] = cells
    for each, name in zip(of_profile(order.spec, order.results), _radii(result), strict=True):
        main[headed(f"${name}$, mm")] = [_radius(float(value)) for value in 1e3 * each.make()[rows]]
    caption = tr("Points of the profile")
    yield Paragraph(tr("The points of the profile are in table {tab:cam_points}."))
    yield _points_table(caption, labels, dict([degrees]) | main, "cam_points")
    if further:
        curves = ", ".join(wall_name(wall.name) for wall in result.walls[1:])
        yield Paragraph(tr("Those of other curves are in table {tab:cam_points_further}."))
        yield _points_table(f"{caption}: {curves}", labels, dict([degrees]) | further, "cam_points_further")


def _points_table(caption: str, labels: list[str], cells: dict[str, list[str]], key: str) -> Table:
    return Table(caption, (tr("Position"), *cells), tuple(zip(labels, *cells.values(), strict=True)), key)


def _radii(result: Profile) -> list[str]:
    return ["rho_w"] if result.flat else ["rho", "rho_w"]


def _radius(value: float) -> str:
    """A radius of curvature, a dash where the curve is straight."""
    if not isfinite(value):
        return "–"
    text = significant(value, 5)
    return f"${text}$" if "e" in text else spelt(text)


def _curvature(told: Told, result: Profile, places: list[Place], lexicon: Lexicon) -> Iterator[Block]:
    """Radii of curvature at the shown positions and at the sharpest places, and the limits of them."""
    words, stem = _words(told), STEM_BENT if told.follower.offset else CENTRAL_BENT
    yield Heading(tr("Curvature"), 3)
    if result.flat:
        yield from lines(FLAT[2:], places, words)
        yield from _flat_limits(told, result, lexicon)
        return
    bent = [place for place in places if "rho" in place.lexicon]
    yield Paragraph(
        tr("The radius of curvature of the pitch curve is positive where the curve is convex, negative where concave:")
    )
    yield from lines((*ROCKER_BENDS, *BENT) if told.turns else stem, bent, words)
    yield from lines(("rho_w = rho - r_2",), [place for place in bent if "rho_w" in place.lexicon], words)
    yield Paragraph(
        tr("The radius of convex and of concave parts is least in size at these places:")
        if result.hollowest is not None
        else tr("The radius is least at this place:")
    )
    found = [_bent(told, lexicon, bend) for bend in (result.sharpest, result.hollowest) if bend is not None]
    yield from lines(BENT if told.turns else (STEM_ARC, *stem), found, words)
    yield from _limits(told, result, lexicon)


def _bent(told: Told, lexicon: Lexicon, bend: Bend) -> Place:
    """The quantities at an extreme of the curvature, on its side of a jump."""
    program = told.task.program
    near = np.flatnonzero(np.abs(program.edges - bend.phi) <= KEPT)
    if near.size and bend.side:
        count = len(program.edges) - 1
        piece = np.array([(int(near[0]) - (bend.side < 0)) % count])
    else:
        piece = program.piece(np.array([bend.phi]))
    phi = np.array([bend.phi])
    motion = program.at(phi, piece)
    own = of_values(told, motion[:, 0]) | _of_path(told, phi, motion)
    own |= _of_radius(told, phi, motion, bend.value)
    return Place(tr("at φ = {angle}°", angle=degrees_of(bend.phi)), lexicon | told.named(own))


def _limits(told: Told, result: Profile, lexicon: Lexicon) -> Iterator[Block]:
    """What the radii leave of the working profile, against what can be made."""
    limits, concave = told.task.limits, result.concave
    lexicon |= named(
        {
            "rho_2": mm(result.convex.value, tr("least radius of curvature of convex parts of the pitch curve")),
            "rho_{w2}": mm(result.least_convex, tr("least radius of curvature of convex parts of the working profile")),
        }
    )
    place = [Place("", lexicon)]
    yield Paragraph(tr("The convex parts of the working profile have to keep a radius that can be made:"))
    yield from lines(("rho_{w2} = rho_2 - r_2",), place)
    yield from _held("rho_{w2}", lexicon, "r_m")
    if concave is None:
        yield Paragraph(tr("The profile has no concave parts."))
    elif not limits.allow_concave:
        yield Paragraph(tr("The profile has concave parts, which are not allowed."))
    else:
        least = result.least_concave
        assert least is not None
        lexicon |= named(
            {
                "rho_1": mm(concave.value, tr("least radius of curvature of concave parts of the pitch curve")),
                "rho_{w1}": mm(least, tr("least radius of curvature of concave parts of the working profile")),
            }
        )
        yield Paragraph(tr("A tool of radius $r_i$ has to reach into the concave parts:"))
        yield from lines(("rho_{w1} = rho_1 + r_2",), place)
        yield from _held("rho_{w1}", lexicon, "r_i")
    if result.outer is not None and concave is not None:
        said = tr("least radius of curvature of convex parts of the second wall")
        lexicon["rho_1"] = mm(concave.value, tr("least radius of curvature of concave parts of the pitch curve"))
        lexicon["rho_o"] = mm(concave.value - told.follower.roller, said)
        yield Paragraph(tr("The second wall of the groove is convex where the pitch curve is concave:"))
        yield from lines(("rho_o = rho_1 - r_2",), place)
        yield from _held("rho_o", lexicon, "r_m")
    yield from _shaft(told, result, lexicon)
    for reach, wall in ((result.inner_reach, result.working), (result.outer_reach, result.outer)):
        if reach is not None and wall is not None:
            yield Paragraph(_reached(reach, wall))
    for wall in result.walls:
        if not wall.sound:
            yield Paragraph(_unsound(wall))
    hollow = result.least_concave
    if result.largest_tool is not None and (hollow is None or not isclose(result.largest_tool, hollow, rel_tol=KEPT)):
        yield Paragraph(
            tr("The largest tool that makes the working profile has a radius of {radius} mm.",
               radius=_radius(1e3 * result.largest_tool))
        )  # fmt: skip


def _flat_limits(told: Told, result: Profile, lexicon: Lexicon) -> Iterator[Block]:
    """The least radius under a flat face."""
    lexicon |= named({"rho_{min}": mm(result.sharpest.value, tr("least radius of curvature of the profile"))})
    phi = result.sharpest.phi
    place = where(phi, dwell_of(told.task.program, phi))
    yield Paragraph(tr("The radius of curvature is least {where}:", where=place))
    yield from _held("rho_{min}", lexicon, "r_m")
    if not result.working.sound:
        yield Paragraph(_unsound(result.working))


def _shaft(told: Told, result: Profile, lexicon: Lexicon) -> Iterator[Block]:
    """Whether the cam has room for its shaft."""
    if not told.task.limits.shaft:
        return
    lexicon |= named({"r_{min}": mm(result.nearest.value, tr("least radius of the working profile"))})
    yield Paragraph(tr("The camshaft has to have room within the profile, whose least radius is $r_min$:"))
    yield from _held("r_{min}", lexicon, "r_1")


def _held(name: str, lexicon: Lexicon, limit: str) -> Iterator[Block]:
    """A condition ``name >= limit`` with the numbers of both sides, whether it holds, and as a main result."""
    given = lexicon[canonical(name)]
    own, least = _value(given), _value(lexicon[canonical(limit)])
    holds = own >= least * (1 - KEPT)
    sides = f" {'>=' if holds else '<'} ".join(significant(each, 5) for each in (own, least))
    said = tr("The condition holds.") if holds else tr("The condition fails.")
    yield Paragraph(f"${name} >= {limit}$: ${sides}$ {shown_unit(given.unit)}. {said}")
    yield Result(name, given._replace(value=max(own, least) if holds else own), least, ">=")


def _value(given: Given) -> float:
    assert isinstance(given.value, float)
    return given.value


def _reached(reach: Reach, wall: Wall) -> str:
    """How large the roller may be for a wall, and what it is bounded by."""
    name, at = wall_name(wall.name), [degrees_of(phi) for phi in reach.at]
    if reach.cause == "cusp":
        return tr(
            "The radius of the roller has to stay below ${radius}$, with which the {wall} has a cusp at "
            "$phi$ = {angle}°.",
            radius="rho_1" if wall.name == "outer" else "rho_2",
            wall=name,
            angle=at[0],
        )
    return tr(
        "The largest roller has a radius of {radius} mm: with it the {wall} touches itself at $phi$ = {first}° and "
        "$phi$ = {second}°.",
        radius=_radius(1e3 * reach.distance),
        wall=name,
        first=at[0],
        second=at[-1],
    )


def _unsound(wall: Wall) -> str:
    """Where a wall runs backwards or crosses itself."""
    name, spans = wall_name(wall.name), "; ".join(f"{degrees_of(a)}°–{degrees_of(b)}°" for a, b in wall.loops)
    if spans:
        return tr("The {wall} is undercut: it runs backwards for $phi$ = {spans}.", wall=name, spans=spans)
    return tr("The {wall} crosses itself.", wall=name)


def _pictures(order: Order, told: Told, result: Profile) -> Iterator[Block]:
    """The cam to scale with its dimensions, its curvature over the turn."""
    yield Paragraph(
        tr("The cam is drawn to scale in figure {fig:cam_profile}.")
        if result.flat
        else tr("The cam is drawn to scale in figure {fig:cam_profile}, its curvature in figure {fig:cam_curvature}.")
    )
    caption = tr("Profile of the cam, which turns {sense}", sense=sense_of(told.follower))
    size = WIDE, height_of(told.task, result, Box(0.0, 0.0, WIDE, HIGH))
    yield Figure(caption, partial(draw_cam, task=told.task, result=result, to_scale=True), size, "cam_profile")
    if not result.flat:
        draw = partial(_draw_bends, task=told.task, result=result)
        yield Figure(tr("Curvature of the cam"), draw, CURVATURE, "cam_curvature")


def _draw_bends(drawing: Drawing, box: Box, task: CamTask, result: Profile) -> None:
    """The curvature over the turn."""
    inner = box.inset(*NAMES)
    rows = len(key_rows(names_of(task, result), inner.width - SIDES[0] - SIDES[2]))
    (frame,) = stacked(inner, [rows])
    draw_bends(drawing, frame, task, Rim(result.follower, task.program), result, numbered=True)
