"""Angles and distances in the picture of a mesh: generating points, gamma, y m, the pressure angle."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.pictures.placedpair import ALIKE, Body
from tmmcalc.gears.pictures.sketch import POINT, SMALLER, Sketch, up_of
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import AXIS, DIMENSION, INK, THIN
from tmmcalc.report.numbers import number

FROM_EDGE = 3.0  # of the arc of the pressure angle, whose value stands beside the frame [mm]
ASIDE = -7.5  # of the distance of the reference circles from the line of centres [mm]
HEAD = 2.0  # length of arrowheads [mm]
SMALL = 1.2  # a distance shorter than this on paper is not dimensioned [mm]


def generating_points(sketch: Sketch) -> None:
    """P0 and D of both reference circles, the angle gamma and the distance y m between the circles."""
    pair, gamma = sketch.pair, sketch.pair.gamma
    if abs(gamma) < ALIKE:
        return
    toothed = [body for body in pair.bodies if body.sizes is not None]
    feet = [body.centre + up_of(body) * body.sizes.reference for body in toothed if body.sizes is not None]
    for body, foot, other in zip(toothed, feet, feet[::-1], strict=True):
        away = 1j if foot.imag > other.imag else -1j
        sketch.board.circle(foot, 0.45, POINT, fill=INK, level=12)
        sketch.text(f"$D_{body.number}$", foot, 1 + away, height=2.5)
        if pair.phase == 0:
            _gamma(sketch, body, gamma, away)
    if abs(feet[0] - feet[-1]) > SMALL * sketch.mm:
        _distance(sketch, feet)


def _gamma(sketch: Sketch, body: Body, gamma: float, away: complex) -> None:
    """P0 where the flank crosses the reference circle, and the angle to it."""
    if body.sizes is None:
        return
    up = up_of(body)
    ray = up * np.exp(1j * gamma)
    at = body.centre + ray * body.sizes.reference
    sketch.board.circle(at, 0.45, POINT, fill=INK, level=12)
    name = f"$P_{{0{body.number}}}$"
    sketch.text(name, at, (ray - up) / abs(ray - up) + away, height=2.5)
    inward = -1 if body.kind != "ring" else 1
    depth = abs(body.sizes.root - body.sizes.reference) + 0.5 * sketch.pair.found.task.module
    radius = body.sizes.reference + inward * depth
    sketch.board.line([body.centre, at], THIN, weight=0.2, level=6)
    if body.kind == "ring":
        sketch.board.line([at, body.centre + ray * radius], THIN, weight=0.2, level=6)
    if radius * abs(gamma) < SMALL * sketch.mm:
        return
    arc = body.centre + radius * up * np.exp(1j * gamma * np.linspace(0, 1, 15))
    beyond = body.centre + radius * up * np.exp(1j * gamma * np.linspace(1, 1 + 5 * sketch.mm / radius / abs(gamma), 9))
    before = body.centre + radius * up * np.exp(-1j * gamma * np.linspace(0, 5 * sketch.mm / radius / abs(gamma), 9))
    sketch.board.line(np.concatenate([before[::-1], arc, beyond]), DIMENSION, weight=0.6, level=9)
    for tip, tail in ((arc[0], before[-1]), (arc[-1], beyond[-1])):
        sketch.board.arrowhead(complex(tip), complex(tip - tail), DIMENSION, HEAD)
    text = f"$γ$ = {minus(number(math.degrees(gamma), 4))}°"
    sketch.text(text, beyond[-1:], complex(beyond[-1] - arc[-1]), height=SMALLER)


def _distance(sketch: Sketch, feet: list[complex]) -> None:
    """The distance of the reference circles on the line of centres."""
    low, high = sorted(feet, key=lambda z: z.imag)
    x = ASIDE * sketch.mm
    for foot in (low, high):
        sketch.board.line([foot, foot + x - 1.5 * sketch.mm], DIMENSION, weight=0.3, level=9)
    outside = (high - low).imag < 7 * sketch.mm
    stretch = 5j * sketch.mm if outside else 0j
    sketch.board.line([low + x - stretch, high + x + stretch], DIMENSION, weight=0.6, level=9)
    for foot, sense in ((low, 1), (high, -1)):
        sketch.board.arrowhead(foot + x, sense * (1j if outside else -1j), DIMENSION, HEAD)
    found = sketch.pair.found
    text = f"$y$$m$ = {minus(number(1e3 * found.modification * found.task.module, 4))}"
    along = [*(low + (high - low) * np.array([0.5, 0.3, 0.7, 0.15, 0.85])), high + stretch, low - stretch]
    sketch.text(text, np.array([x + z for z in along], dtype=complex), -1 + 0j, height=SMALLER)


def pressure_angle(sketch: Sketch) -> None:
    """The common tangent at P and the angle from it to the line of action, its value in the column beside."""
    pair, at, angle = sketch.pair, sketch.pair.pitch_point, sketch.pair.found.angle_w
    reach = min(at.real - sketch.low.real, (sketch.high.imag - at.imag) / math.sin(angle))
    radius = reach - FROM_EDGE * sketch.mm
    arc = at + radius * np.exp(1j * (math.pi - angle * np.linspace(0, 1, 31)))
    sketch.board.line([complex(x, at.imag) for x in (sketch.low.real, sketch.high.real)], AXIS, weight=0.4, level=6)
    last = max(float(np.max(np.abs([mark.at - at for mark in pair.marks if mark.at.real < at.real]), initial=0.0)), 0.0)
    if radius > last:
        beyond = radius + FROM_EDGE * sketch.mm
        sketch.board.line([at + r * pair.direction for r in (last, beyond)], DIMENSION, weight=0.4, level=6)
    sketch.board.arc(at, radius, DIMENSION, start=math.pi - angle, end=math.pi, weight=0.6, level=9)
    for k in (0, -1):
        sketch.board.arrowhead(complex(arc[k]), complex(arc[k] - arc[1 if k == 0 else -2]), DIMENSION, HEAD)
    text = f"$α_{{tw}}$ = {number(math.degrees(angle), 5)}°"
    sketch.beside[0].append((text, complex(arc[15]), INK))
