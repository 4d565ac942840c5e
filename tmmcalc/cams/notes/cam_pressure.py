"""The chapter on cams, its fourth part: the pressure angle at positions, largest in each phase against its limit."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import degrees

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.notes.lexicon import Told, angle, degrees_of, of_follower, of_motion, of_values, table_rows, told_of
from tmmcalc.cams.pictures.cam_pressure import draw_angle
from tmmcalc.cams.pictures.pieces import NAMES
from tmmcalc.cams.pressure.angle import Extreme, Reached, pressure_angle
from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import stacked
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import WIDE, lines, tabulated

STEM = ("theta = atan((S' <+> e)/S)",)
ROCKER = ("theta = atan((l_2*(1 <d-> psi') - l_0*cos(psi))/(l_0*sin(psi)))",)
TRANSMITTED = ("gamma = deg(90) - abs(theta)",)
SIZE = WIDE, 75.0  # of the diagram [mm]
NOTHING = 1e-9  # [rad]
NEAR = 1e-9  # of the turn: an angle at the edge of a piece


def blocks(order: Order) -> Iterator[Block]:
    """The angle at the shown positions, its extremes, the table, the diagram; under a flat face it is zero."""
    told, result = told_of(order), order.results["cam_pressure"]
    if told.follower.kind == "flat":
        return
    formulas = ROCKER if told.turns else STEM
    sizes = of_follower(told.follower)
    yield Heading(tr("Pressure angle"))
    yield Paragraph(_said(told))
    rows = [_at(told, result, row) for row in told.rows]
    yield from lines((*formulas, *TRANSMITTED), told.places(sizes, rows), told.words)
    phases = ("rise", result.rise), ("return", result.back)
    yield Paragraph(tr("The extremes of the pressure angle on the rise and on the return:"))
    places = [place for kind, on in phases for place in _extremes(told, kind, on, told.named(sizes))]
    yield from lines(formulas, places, told.words)
    for kind, on in phases:
        yield from _judged(kind, on)
    shown = table_rows(told, dwells=False)
    columns = {
        "$phi$, deg": np.degrees(result.phi[shown]),
        "$theta$, deg": np.degrees(result.theta[shown]),
        "$gamma$, deg": result.gamma[shown],
    }
    yield Paragraph(
        tr(
            "The pressure angle in the positions $i$ is in table {tab:cam_pressure}, over the turn in figure "
            "{fig:cam_pressure}."
        )
    )
    labels = [result.labels[row] for row in shown]
    yield tabulated(tr("Pressure angle"), columns, labels, head="$i$", key="cam_pressure")
    yield Figure(
        tr("Pressure angle over a turn of the cam"), partial(_draw, task=told.task, result=result), SIZE, "cam_pressure"
    )


def _draw(drawing: Drawing, box: Box, task: CamTask, result: Pressure) -> None:
    """The diagram over the turn."""
    (frame,) = stacked(box.inset(*NAMES), [0])
    draw_angle(drawing, frame, task, result, numbered=True)


def _said(told: Told) -> str:
    """What the angle is, and its sign."""
    if told.turns:
        return tr(
            "The pressure angle is that between the velocity of the roller centre on the rise and the normal of the "
            "profile; it is positive where the force of the cam pulls the rocker away from its pivot."
        )
    return tr(
        "The pressure angle is that between the velocity of the follower on the rise and the normal of the profile; it "
        "is positive where the normal is turned from the velocity as the cam turns."
    )


def _of_angle(theta: float) -> Lexicon:
    return {
        "theta": angle(theta, tr("pressure angle of the cam")),
        "gamma": Given(90 - abs(degrees(theta)), "deg", tr("transmission angle")),
    }


def _at(told: Told, result: Pressure, row: int) -> Lexicon:
    return (
        of_motion(told, row)
        | _of_angle(float(result.theta[row]))
        | {"gamma": Given(float(result.gamma[row]), "deg", tr("transmission angle"))}
    )


def _extremes(told: Told, kind: str, on: Reached, sizes: Lexicon) -> Iterator[Place]:
    """The places of the largest and the least angle of a phase, unless it is zero there."""
    for extreme in dict.fromkeys((on.largest, on.least)):
        if abs(extreme.value) <= NOTHING:
            continue
        motion = _motion(told, kind, extreme)
        own = of_values(told, motion) | _of_angle(extreme.value)
        yield Place(tr("at φ = {angle}°", angle=degrees_of(extreme.phi)), sizes | told.named(own))


def _motion(told: Told, kind: str, extreme: Extreme) -> Values:
    """The motion (4,) at an extreme, on the side of a jump that belongs to the phase and has it."""
    program, phi = told.task.program, extreme.phi
    near = np.flatnonzero((program.edges[:-1] <= phi + NEAR) & (phi - NEAR <= program.edges[1:]))
    own = near[[program.phases[number].kind == kind for number in program.places[0][near]]]
    every = program.at(np.full(own.size, phi), own)
    theta = pressure_angle(told.follower, np.full(own.size, phi), every)
    found: Values = every[:, np.argmin(np.abs(theta - extreme.value))]
    return found


def _judged(kind: str, on: Reached) -> Iterator[Block]:
    """The largest angle of a phase against its limit."""
    worst = on.worst
    phase = tr("on the rise") if kind == "rise" else tr("on the return")
    values = {"phase": phase, "theta": degrees_of(abs(worst.value)), "phi": degrees_of(worst.phi)}
    if on.limit is None:
        yield Paragraph(
            tr("The largest pressure angle {phase} is {theta}° at $phi$ = {phi}°; it is not limited there.", **values)
        )
    else:
        values["limit"] = degrees_of(on.limit)
        if on.exceeded:
            spans = "; ".join(f"{degrees_of(low)}°–{degrees_of(high)}°" for low, high in on.exceeded)
            yield Paragraph(
                tr(
                    "The largest pressure angle {phase} is {theta}° at $phi$ = {phi}°, above the permissible {limit}°: "
                    "it is exceeded for $phi$ = {spans}.",
                    spans=spans,
                    **values,
                )
            )
        else:
            yield Paragraph(
                tr(
                    "The largest pressure angle {phase} is {theta}° at $phi$ = {phi}°, not above the permissible "
                    "{limit}°.",
                    **values,
                )
            )
    name, said = "theta_y", tr("largest pressure angle on the rise")
    if kind == "return":
        name, said = "theta_c", tr("largest pressure angle on the return")
    if on.limit is None:
        yield Result(name, angle(abs(worst.value), said))
    else:
        value = abs(worst.value) if on.exceeded else min(abs(worst.value), on.limit)
        yield Result(name, angle(value, said), degrees(on.limit), "<=")
