"""Shapes of a cam with its rocker, and the least distance of the centres l0 of each: a scan of all of them.

A cam and its rocker that keep all constraints but 2 keep them when all their lengths grow alike: R falls, radii and
room grow. So every shape, l2/l0 with psi0, has a least l0, found by halving, and below the least of all shapes there is
nothing, in whole steps either. R does not depend on r2: at given l0, l2, psi0 constraints 3 to 6, 9 and 11 leave r2 an
interval in closed form. The best shapes start the linear programming, which holds all constraints, 2 as well.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.rockersizes import RockerScene, Sizes, judge_rocker, start_angle, turn_of
from tmmcalc.cams.strength.formulas import (
    allowed_square,
    pin_pressure,
    pin_radius,
    reduced_moment,
    shaft_by_stiffness,
    shaft_by_strength,
    whole,
)
from tmmcalc.cams.task import Optimum
from tmmcalc.core.records import record

RATIOS, ANGLES = 30, 20  # shapes of the scan
NARROW = 1e-4  # of psi0: its range is not tried to the very ends
SHORTEST, LONGEST = 1e-3, 30.0  # l0 [m] between which it is looked for
HALVINGS = 12  # to a quarter of a per cent
ROOM = (1.0, 1.05, 1.15, 1.3, 1.6, 2.0, 3.0)  # of the least l0 of a shape: larger ones, where the roller may roll
PARTS = (0.5, 0.0, 1.0, 0.25, 0.75)  # of the interval of r2 that are tried
STARTS = 3  # shapes from which the quadratic programming starts
EVERY = 4  # nodes of a panel of which the scan looks at one
FEW = 4000  # shapes at a time


@record
class Bounds:
    """The interval of r2 (B,) [m] that constraints 3 to 6, 9 and 11 leave, the pressure angle and jamming kept."""

    least: Values
    most: Values

    @property
    def some(self) -> Mask:
        """Where there is any r2 (B,)."""
        found: Mask = (self.least <= self.most) & (self.most > 0)
        return found


def thinned(of: RockerScene) -> RockerScene:
    """The scene at a few nodes of its panels and at their ends: what these exclude is excluded."""
    scene = of.scene
    nodes = len(scene.phi) // scene.panels
    kept = sorted({0, nodes - 1, *range(1, nodes - 1, EVERY)})
    rows = (np.array(kept)[:, None] * scene.panels + np.arange(scene.panels)).ravel()

    def part(values: Values) -> Values:
        return values[..., rows]

    few = replace(
        scene,
        phi=part(scene.phi),
        motion=part(scene.motion),
        load=part(scene.load),
        sense=part(scene.sense),
        torque=part(scene.torque),
        rows=replace(
            scene.rows, force=part(scene.rows.force), inverse=part(scene.rows.inverse), twist=part(scene.rows.twist)
        ),
    )
    gaining = None if of.gaining is None else part(of.gaining)
    return replace(
        of, scene=few, rising=of.rising[rows], returning=of.returning[rows], square=part(of.square), gaining=gaining
    )


def bounds(of: RockerScene, sizes: Sizes) -> Bounds:
    """The interval of r2 at sizes (B,) by the nodes of a scene; r2 of the sizes does not matter."""
    scene, need, limits = of.scene, of.scene.requirements, of.scene.limits
    turn = turn_of(of, sizes)
    force = scene.rows.force / turn.useful
    contact, (bent, most) = np.max(force, axis=1), (np.min(turn.kappa, axis=1), np.max(turn.kappa, axis=1))
    upper = np.where(most > 0, 1 / np.where(most > 0, most, 1.0) - limits.convex, np.inf)
    lower = np.zeros(len(contact))
    concave = bent < -SLACK / sizes.base
    if limits.allow_concave:
        lower = np.where(concave, limits.concave + 1 / np.where(concave, bent, -1.0), 0.0)
    upper = np.where(concave & (not limits.allow_concave), 0.0, upper)
    pin = need.pin
    if need.pin_pressure is not None:
        if pin is None:
            lower = np.maximum(lower, need.roller_ratio * pin_radius(contact, need.pin_pressure, need.pin_ratio))
        else:
            upper = np.where(pin_pressure(contact, pin, need.pin_ratio) > need.pin_pressure, 0.0, upper)
    if pin is not None:
        lower = np.maximum(lower, need.roller_ratio * pin)
    upper = np.minimum(upper, sizes.base - _shaft(of, force, contact))
    if need.contact is not None and need.width is not None:
        each = force / allowed_square(need.contact, need.width, need.modulus)  # r2 (1 - kappa r2) is no less
        left = 1 - 4 * turn.kappa * each
        root = 1 + np.sqrt(np.maximum(left, 0.0))
        lower = np.maximum(lower, np.max(2 * each / root, axis=1))
        convex = turn.kappa > 0
        high = np.where(convex, root / (2 * np.where(convex, turn.kappa, 1.0)), np.inf)
        upper = np.where(np.all(left >= 0, axis=1), np.minimum(upper, np.min(high, axis=1)), 0.0)
    psi = start_angle(sizes)[0] + of.top
    reach = np.sqrt(sizes.centres**2 + sizes.rocker**2 - 2 * sizes.centres * sizes.rocker * np.cos(psi))
    lower = np.maximum(lower, reach - sizes.centres + of.pivot)
    lean, kept = np.abs(turn.theta), turn.works
    for phase, limit in ((of.rising, limits.rise), (of.returning, limits.back)):
        if limit is not None and phase.any():
            kept &= np.max(lean[:, phase], axis=1) <= limit * (1 + SLACK)
    return Bounds(lower, np.where(kept, upper, -1.0))


def _shaft(of: RockerScene, force: Values, contact: Values) -> Values:
    """r1* (B,) [m] in whole mm, from R at the nodes (B, M) and its largest."""
    need, radius = of.scene.requirements, np.zeros(len(contact))
    if need.span is not None and need.bending is not None:
        moment = np.max(reduced_moment(force, of.scene.torque, need.span, need.torsion), axis=1)
        radius = np.maximum(radius, shaft_by_strength(moment, need.bending))
    if need.span is not None and need.deflection is not None:
        radius = np.maximum(radius, shaft_by_stiffness(contact, need.span, need.young, need.deflection))
    found: Values = np.maximum(whole(radius), of.scene.limits.shaft)
    return found


def angles(of: RockerScene, ratio: Values) -> tuple[Values, Values]:
    """Least and largest psi0 (B,) [rad] that the pressure angle leaves at l2/l0 (B,), by the nodes, in closed form.

    |theta| <= t means l2 w cos(t) between l0 cos(psi + t) and l0 cos(psi - t), w = 1 - delta psi'.
    """
    scene, limits = of.scene, of.scene.limits
    low, high = np.zeros(len(ratio)), np.full(len(ratio), pi)
    high -= of.top
    for phase, limit in ((of.rising, limits.rise), (of.returning, limits.back)):
        if limit is None or not phase.any():
            continue
        y = scene.motion[0][phase]
        side = ratio[:, None] * (1 - scene.follower.assembly * scene.motion[1][phase]) * np.cos(limit)
        arc = np.arccos(np.clip(side, -1.0, 1.0))
        low = np.maximum(low, np.max(np.maximum(limit - arc, arc - limit) - y, axis=1))
        high = np.minimum(high, np.min(np.minimum(limit + arc, 2 * pi - arc - limit) - y, axis=1))
        high = np.where(np.any(side > 1, axis=1) | np.any(side < -1, axis=1), -1.0, high)
    return low, high


def triangle(ratio: Values, angle: Values, centres: Values) -> Sizes:
    """Sizes (B,) from l2/l0, psi0 and l0, with no roller."""
    base = centres * np.sqrt(np.maximum(1 + ratio**2 - 2 * ratio * np.cos(angle), 0.0))
    return Sizes(ratio * centres, base, np.zeros(len(ratio)), centres)


def shapes(of: RockerScene, count: int = RATIOS, each: int = ANGLES) -> tuple[Values, Values]:
    """l2/l0 and psi0 (n,) of a net of all shapes that keep the pressure angle; none: (0,)."""
    limits = [of.scene.limits.rise]
    if of.scene.limits.back is not None and of.returning.any():
        limits.append(of.scene.limits.back)
    longest = 1 / np.cos(min(limits))  # at rest w = 1
    ratio = longest * (np.arange(20 * count) + 0.5) / (20 * count)
    low, high = angles(of, ratio)
    open_ = np.flatnonzero(high > low)
    if not open_.size:
        return np.empty(0), np.empty(0)
    ratio = np.linspace(ratio[open_[0]], ratio[open_[-1]], count)
    low, high = angles(of, ratio)
    keep = high > low
    part = np.linspace(NARROW, 1 - NARROW, each)
    angle = low[keep, None] + (high - low)[keep, None] * part
    return np.repeat(ratio[keep], each), angle.ravel()


def _fits(of: RockerScene, ratio: Values, angle: Values, centres: Values) -> Mask:
    parts = [slice(i, i + FEW) for i in range(0, len(ratio), FEW)]
    found = [bounds(of, triangle(ratio[p], angle[p], centres[p])).some for p in parts]
    return np.concatenate(found) if found else np.empty(0, bool)


def least_by_shape(of: RockerScene, ratio: Values, angle: Values) -> Values:
    """The least l0 (n,) of shapes by all constraints but 2, by the nodes; infinite where no size keeps them."""
    low, high = np.full(len(ratio), SHORTEST), np.full(len(ratio), LONGEST)
    fits = _fits(of, ratio, angle, high)
    rows = np.flatnonzero(fits)
    for _ in range(HALVINGS):
        middle = np.sqrt(low[rows] * high[rows])
        good = _fits(of, ratio[rows], angle[rows], middle)
        high[rows[good]], low[rows[~good]] = middle[good], middle[~good]
    return np.where(fits, high, np.inf)


def scanned(of: RockerScene, asked: Optimum) -> Values:
    """Sizes (4, n) of the best shapes of the scan, lowest first, that keep the asked ranges; with all constraints."""
    few = thinned(of)
    ratio, angle = shapes(few)
    least = least_by_shape(few, ratio, angle)
    if asked.rocker_lengths is not None:
        shortest, longest = asked.rocker_lengths
        least = np.maximum(least, shortest / ratio)
        least = np.where(ratio * least > longest * (1 + SLACK), np.inf, least)
    if asked.centre_distances is not None:
        least = np.maximum(least, asked.centre_distances[0])
        least = np.where(least > asked.centre_distances[1] * (1 + SLACK), np.inf, least)
    order = np.argsort(least, kind="stable")
    order = order[np.isfinite(least[order])]
    if not order.size:
        return np.empty((4, 0))
    found: list[Values] = []
    for k in _apart(ratio[order], angle[order]):
        row = order[k]
        start = _rolling(few, asked, float(ratio[row]), float(angle[row]), float(least[row]))
        if start is not None:
            found.append(start)
        if len(found) == STARTS:
            break
    return np.stack(found, axis=1) if found else np.empty((4, 0))


def _apart(ratio: Values, angle: Values) -> list[int]:
    """Numbers of shapes, the best first, none beside one before it."""
    kept: list[int] = []
    wide, high = np.ptp(ratio) + SLACK, np.ptp(angle) + SLACK
    for k in range(len(ratio)):
        if len(kept) == 4 * STARTS:
            break
        beside = (abs(ratio[k] - ratio[j]) / wide + abs(angle[k] - angle[j]) / high < 3 / ANGLES for j in kept)
        if not any(beside):
            kept.append(k)
    return kept


def _rolling(of: RockerScene, asked: Optimum, ratio: float, angle: float, least: float) -> Values | None:
    """Sizes (4,) of a shape, with r2 in its interval, at the first size at which the roller rolls; else the least."""
    centres = least * np.array(ROOM)
    if asked.rocker_lengths is not None:
        centres = np.minimum(centres, asked.rocker_lengths[1] / ratio)
    one = np.ones(len(centres))
    sizes = triangle(ratio * one, angle * one, centres)
    free = bounds(of, sizes)
    roller = free.least[:, None] + np.maximum(free.most - free.least, 0.0)[:, None] * np.array(PARTS)
    every = Sizes(*(np.repeat(size, len(PARTS)) for size in sizes))._replace(roller=roller.ravel())
    good = judge_rocker(of, every).margin[0] >= 0
    k = int(np.argmax(good))
    return np.stack(every)[:, k] if roller.ravel()[k] > 0 else None
