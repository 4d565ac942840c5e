"""Angles and distances in the picture of a mesh: generating points, gamma, y m, the pressure angle."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.pictures.placedpair import ALIKE, Body
from tmmcalc.gears.pictures.sketch import SIZE, THIN, Sketch, up_of
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import number

ANGLE = (16.0, 34.0)  # radius of the arc of the pressure angle [mm]
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
        sketch.board.circle(foot, 0.45, facecolor=INK, zorder=12)
        sketch.text(f"$D_{body.number}$", foot, 1 + away, size=SIZE - 1)
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
    sketch.board.circle(at, 0.45, facecolor=INK, zorder=12)
    name = f"$P_{{0{body.number}}}$"
    sketch.text(name, at, (ray - up) / abs(ray - up) + away, size=SIZE - 1)
    inward = -1 if body.kind != "ring" else 1
    depth = abs(body.sizes.root - body.sizes.reference) + 0.5 * sketch.pair.found.task.module
    radius = body.sizes.reference + inward * depth
    sketch.board.line([body.centre, at], weight=0.2, zorder=6, **THIN)
    if body.kind == "ring":
        sketch.board.line([at, body.centre + ray * radius], weight=0.2, zorder=6, **THIN)
    if radius * abs(gamma) < SMALL * sketch.mm:
        return
    arc = body.centre + radius * up * np.exp(1j * gamma * np.linspace(0, 1, 15))
    beyond = body.centre + radius * up * np.exp(1j * gamma * np.linspace(1, 1 + 5 * sketch.mm / radius / abs(gamma), 9))
    before = body.centre + radius * up * np.exp(-1j * gamma * np.linspace(0, 5 * sketch.mm / radius / abs(gamma), 9))
    sketch.board.line(np.concatenate([before[::-1], arc, beyond]), weight=0.6, zorder=9, **THIN)
    for tip, tail in ((arc[0], before[-1]), (arc[-1], beyond[-1])):
        sketch.board.arrowhead(complex(tip), complex(tip - tail), 1.8)
    sketch.text(f"$\\gamma$ = {signed(math.degrees(gamma), 4)}°", beyond[-1:], complex(beyond[-1] - arc[-1]), size=7.5)


def _distance(sketch: Sketch, feet: list[complex]) -> None:
    """The distance of the reference circles on the line of centres."""
    low, high = sorted(feet, key=lambda z: z.imag)
    x = -9.0 * sketch.mm
    for foot in (low, high):
        sketch.board.line([foot, foot + x - 1.5 * sketch.mm], weight=0.3, zorder=9, **THIN)
    outside = (high - low).imag < 7 * sketch.mm
    stretch = 5j * sketch.mm if outside else 0j
    sketch.board.line([low + x - stretch, high + x + stretch], weight=0.6, zorder=9, **THIN)
    for foot, sign in ((low, -1), (high, 1)):
        sketch.board.arrowhead(foot + x, sign * (-1j if outside else 1j), 1.8)
    found = sketch.pair.found
    text = f"$ym$ = {signed(1e3 * found.modification * found.task.module, 4)}"
    sketch.text(text, np.array([(low + high) / 2 + x, high + stretch + x, low - stretch + x]), -1 + 0j, size=7.5)


def pressure_angle(sketch: Sketch) -> None:
    """The common tangent at P and the angle from it to the line of action."""
    pair, at = sketch.pair, sketch.pair.pitch_point
    ends = np.abs(np.array([mark.at - at for mark in pair.marks if sketch.seen(np.array([mark.at]))[0]]))
    radius = min(max(0.8 * float(ends.max()), ANGLE[0] * sketch.mm), ANGLE[1] * sketch.mm)
    arc = at + radius * np.exp(1j * (math.pi - pair.found.angle_w * np.linspace(0, 1, 31)))
    over = radius + 8 * sketch.mm
    sketch.board.line([at - over, at + over], weight=0.4, zorder=6, linewidth=0.6, linestyle=(0, (14, 2, 2, 2)))
    sketch.board.line(arc, weight=0.6, zorder=9, **THIN)
    for k in (0, -1):
        sketch.board.arrowhead(complex(arc[k]), complex(arc[k] - arc[1 if k == 0 else -2]), 1.8)
    text = f"$\\alpha_{{tw}}$ = {number(math.degrees(pair.found.angle_w), 5)}°"
    sketch.text(text, arc[[15, 10, 20]], -1 + 0j, size=8)
