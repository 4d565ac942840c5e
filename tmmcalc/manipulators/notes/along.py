"""The gripper along its path: the time-optimal law of each leg, way and speed in the phases, the gripper on the piece.

A leg is a part of the path between two stops; its time and its way are counted from where it begins.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.manipulators.notes.path import arc_quantities, point, unit_vector
from tmmcalc.manipulators.notes.told import At, Told, gripper_law, law_of
from tmmcalc.manipulators.task import PathTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place
from tmmcalc.report.optimal import PHASES, by_travel, phase_named
from tmmcalc.report.telling import lines, named

SHOWN = 3  # legs whose law is worked out by numbers
LINE = {
    "place": "<%> = <%>_s + (s - s_j)*u_<%>",
    "velocity": "v_<%> = v*u_<%>",
    "acceleration": "a_<%> = a*u_<%>",
}
FLAT = (  # an arc in the plane (2.96) to (2.99)
    ("x = x_c + R*cos(theta)", "y = y_c + R*sin(theta)"),
    ("v_x = -q*v*sin(theta)", "v_y = q*v*cos(theta)"),
    ("a_x = -q*a*sin(theta) - v**2/R*cos(theta)", "a_y = q*a*cos(theta) - v**2/R*sin(theta)"),
)
SPATIAL = (
    "<%> = <%>_c + R*(cos(theta)*e_1<%> + sin(theta)*e_2<%>)",
    "v_<%> = q*v*(cos(theta)*e_2<%> - sin(theta)*e_1<%>)",
    "a_<%> = q*a*(cos(theta)*e_2<%> - sin(theta)*e_1<%>) - v**2/R*(cos(theta)*e_1<%> + sin(theta)*e_2<%>)",
)


def law(told: Told) -> Iterator[Block]:
    """The largest speed, and the times of the phases, of every leg that is shown."""
    asked = told.task.motion
    assert isinstance(asked, PathTask)
    drive, legs = asked.drive, told.result.legs
    yield Heading(tr("Time-optimal law of the gripper"), 2)
    yield Paragraph(gripper_law(drive))
    if len(legs) > 1:
        yield Paragraph(
            tr("It does so on each of {count} parts of the path, which are parted by stops.", count=len(legs))
        )
    yield from _allowed(told)
    groups: dict[tuple[str, ...], list[Place]] = {}
    for k, leg in enumerate(legs[:SHOWN]):
        lengths = {"S_j": Given([piece.length for piece in leg.pieces], "m", tr("lengths of the pieces of the path"))}
        lexicon = named({**law_of(told, k), **lengths})
        texts = by_travel(leg.law, timed=drive.duration is not None, speed=_bound(drive.speed, leg.speed_limit))
        # the length of one arc is that of the path, which stands above
        arc = len(leg.pieces) == 1 and leg.pieces[0].radius is not None
        texts = (*(() if arc else ("S_m = sum(S_j, j)",)), *texts)
        groups.setdefault(texts, []).append(Place(_leg_named(told, k), lexicon))
    for texts, places in groups.items():
        yield from lines(texts, places)
        if drive.duration is None and "t_2" not in " ".join(texts):
            yield Paragraph(tr("There is no uniform motion: the allowed speed is not reached."))


def _leg_named(told: Told, leg: int) -> str:
    return tr("on part {number} of the path", number=leg + 1) if len(told.result.legs) > 1 else ""


def _bound(speed: float | None, arcs: float | None) -> str:
    """The speed that the law has at most, in letters."""
    if speed is None:
        return "v_R"
    return "v_m" if arcs is None else "min(v_m, v_R)"


def _allowed(told: Told) -> Iterator[Block]:
    """The speed that the limits of the accelerations allow on the arcs."""
    asked = told.task.motion
    assert isinstance(asked, PathTask)
    normal, total = "sqrt(a_n^{lim}*R_{min})", "sqrt(R_{min}*sqrt(a_Σ^{lim}**2 - a_m**2))"
    found = [text for text, limit in ((normal, asked.drive.normal), (total, asked.drive.total)) if limit is not None]
    places = [
        Place(_leg_named(told, k), law_of(told, k))
        for k, leg in enumerate(told.result.legs[:SHOWN])
        if leg.speed_limit is not None
    ]
    if not found or not places:
        return
    yield Paragraph(tr("On the arc with the least radius the accelerations keep their limits up to the speed:"))
    yield from lines([f"v_R = {found[0] if len(found) == 1 else 'min(' + ', '.join(found) + ')'}"], places)


def motion(told: Told) -> Iterator[Block]:
    """Way and speed in each phase, then the gripper on each kind of piece."""
    yield Heading(tr("Motion of the gripper"), 2)
    sites = told.sites
    phases = {at: int(told.result.phase[at.row]) for at in sites}
    several = len(told.result.legs) > 1
    more = {at: _at(told, at) for at in sites}
    if several and sites:
        yield Paragraph(tr("Time and way are counted from the last stop:"))
        yield from lines(["tau = t - t_b"], [Place(told.named(at.row), more[at]) for at in sites])
    for phase, texts in PHASES.items():
        places = [Place(told.named(at.row), more[at]) for at in sites if phases[at] == phase]
        if places:
            yield Paragraph(phase_named(phase))
            yield from lines(texts, places, {"t": "tau" if several else "t"})
    yield from _on_lines(told, [at for at in sites if told.piece(at).radius is None], more)
    yield from _on_arcs(told, [at for at in sites if told.piece(at).radius is not None], more)


def _at(told: Told, at: At) -> Lexicon:
    """The law, the piece and the gripper at a row."""
    result, piece = told.result, told.piece(at)
    leg = result.legs[at.leg]
    before = math.fsum(other.law.travel for other in result.legs[: at.leg])
    way, speed, acceleration = result.way[:, at.row].tolist()
    found = {
        **told.lexicon(at.row),
        **law_of(told, at.leg),
        "tau": Given(float(result.t[at.row]) - leg.begin, "s", tr("time from the last stop")),
        "t_b": Given(leg.begin, "s", tr("time of the last stop")),
        "s": Given(
            way - before, "m", tr("way along the path") if len(result.legs) == 1 else tr("way from the last stop")
        ),
        "v": Given(speed, "m/s", tr("speed of the gripper")),
        "a": Given(acceleration, "m/s^2", tr("tangential acceleration of the gripper")),
        "s_j": Given(
            math.fsum(each.length for each in leg.pieces[: at.piece]), "m", tr("way at the beginning of the piece")
        ),
        **arc_quantities(told, piece),
    }
    if piece.radius is None or piece.centre is None:
        found |= point("s", told, piece.start, tr("coordinates of the beginning of the line"))
        found |= unit_vector("u_", told, piece.e1, tr("unit vector along the line"))
        return named(found)
    out = result.gripper[0, :, at.row] - piece.centre
    theta = math.atan2(float(out @ piece.e2), float(out @ piece.e1))
    near = (piece.theta + piece.theta_end) / 2
    theta += 2 * math.pi * round((near - theta) / (2 * math.pi))
    found["theta"] = Given(theta, "rad", tr("angle of the gripper about the centre of the arc"))
    normal = result.gripper[2, :, at.row] @ -out / piece.radius
    found["a_n"] = Given(float(normal), "m/s^2", tr("normal acceleration of the gripper"))
    return named(found)


def _on_lines(told: Told, sites: list[At], more: dict[At, Lexicon]) -> Iterator[Block]:
    """The gripper on a straight line."""
    if not sites:
        return
    places = [Place(told.named(at.row), more[at]) for at in sites]
    yield Paragraph(tr("On a straight line the coordinates of the gripper, its velocity and its acceleration are:"))
    for text in LINE.values():
        for axis in told.axes:
            yield from lines([text], places, {"%": axis})


def _on_arcs(told: Told, sites: list[At], more: dict[At, Lexicon]) -> Iterator[Block]:
    """The gripper on an arc."""
    if not sites:
        return
    places = [Place(told.named(at.row), more[at]) for at in sites]
    yield Paragraph(tr("On an arc the coordinates of the gripper, its velocity and its acceleration are:"))
    yield from lines(["theta = theta_1 + q*(s - s_j)/R", "a_n = v**2/R"], places)
    for k, texts in enumerate(FLAT):
        if told.arm.spatial:
            for axis in told.axes:
                yield from lines([SPATIAL[k]], places, {"%": axis})
        else:
            yield from lines(texts, places)


def shown(told: Told) -> list[int]:
    """Of each phase, and of lines and arcs in it, the row in the middle; one at its end only where it has no other."""
    result = told.result
    rows: dict[tuple[int, bool], list[int]] = {}
    for row in range(len(result.t)):
        rows.setdefault((int(result.phase[row]), told.piece(told.site(row)).radius is None), []).append(row)
    inner = [[row for row in own[1:-1] if result.labels[row].isdigit()] or own for own in rows.values()]
    return sorted(own[len(own) // 2] for own in inner)


def largest(told: Told) -> Iterator[tuple[str, Given, float | None]]:
    """The extremes of the gripper with what they are held to: name, quantity, limit."""
    asked = told.task.motion
    drive = asked.drive if isinstance(asked, PathTask) else None
    limits = (drive.speed, drive.total, drive.acceleration, drive.normal) if drive is not None else (None,) * 4
    said = {
        "speed": ("v_{max}", tr("largest speed of the gripper"), limits[0]),
        "acceleration": ("a_{Σ,max}", tr("largest acceleration of the gripper"), limits[1]),
        "a_tangential": ("a_{max}", tr("largest tangential acceleration of the gripper"), limits[2]),
        "a_normal": ("a_{n,max}", tr("largest normal acceleration of the gripper"), limits[3]),
    }
    for each in told.result.extremes:
        if each.name in said:
            key, what, limit = said[each.name]
            yield key, Given(float(np.max(np.abs([each.least, each.largest]))), each.unit, what), limit
