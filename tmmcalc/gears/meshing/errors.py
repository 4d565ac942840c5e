"""What rounding leaves of a pair: its main sizes again from the shifts by ISO 21771, in extended precision.

A ring counts as a wheel with a negative number of teeth, negative radii and a negative centre distance, so one set of
formulas serves external and internal pairs; a rack rolls on the reference circle of its pinion. Tips that a rule of
clearance cut short are taken as they are.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.numerics.extended import PI, apart
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import Long, inverse_extended, involute_extended
from tmmcalc.gears.involute.measure.balls import Body
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.results import Measures, MeshPair, PairError
from tmmcalc.gears.meshing.task import PairTask

RULE = 1e-9  # [module] within which a tip is that of the rule


@record
class Cut:
    """The wheels of a pair in the transverse section; the arrays (1,) or (2,), lengths in modules."""

    teeth: Long  # negative: a ring
    shift: Long
    alpha: np.longdouble  # alpha, normal
    slant: np.longdouble  # tan(beta)
    cosine: np.longdouble  # cos(beta)
    angle: np.longdouble  # alpha_t
    level: Long  # inv(alpha_t)

    @property
    def reference(self) -> Long:
        """r."""
        return self.teeth / (2 * self.cosine)

    @property
    def base(self) -> Long:
        """r_b."""
        return self.reference * np.cos(self.angle)

    @property
    def half(self) -> Long:
        """psi, half the tooth on the reference circle."""
        return (PI / 2 + 2 * self.shift * np.tan(self.alpha)) / self.teeth


def pair_error(found: MeshPair) -> PairError:
    """Largest relative difference of the sizes of a pair and the same in extended precision."""
    task, m = found.task, np.longdouble(found.task.module)
    cut = _cut(found)
    angle, distance = _operating(task, cut)
    tips = _tips(found, cut, distance)
    rho = curvature(cut, tips)
    ratio = (_path(task, cut, angle, distance, rho)) / (PI / cut.cosine * np.cos(cut.angle))
    told = [size.thickness for size in found.sizes] + [size.tip_thickness for size in found.sizes]
    return PairError(
        angle=apart(found.angle_w, angle),
        distance=apart(found.distance, m * np.abs(distance)),
        contact_ratio=apart(found.contact_ratio, ratio),
        thickness=apart(told, m * arcs(cut, tips)),
        span=span_error(found.measures, cut, m),
        balls=balls_error(found.measures, cut, m, task.measuring.body),
    )


def _cut(found: MeshPair) -> Cut:
    task, count = found.task, len(found.sizes)
    signs = (1, -1 if task.kind == "internal" else 1)
    teeth = [sign * z for sign, z in zip(signs, task.teeth[:count], strict=False)]
    return cut_of(teeth, found.shifts[:count], task.rack, task.helix)


def cut_of(teeth: Sequence[int], shifts: Sequence[float], rack: Rack, helix: float) -> Cut:
    """Wheels of one rack and one helix angle [rad]; a negative number of teeth is that of a ring."""
    alpha, slant = np.longdouble(rack.angle), np.longdouble(abs(helix))
    angle = np.arctan(np.tan(alpha) / np.cos(slant))
    z, x = np.array(teeth, np.longdouble), np.array(shifts, np.longdouble)
    return Cut(z, x, alpha, np.tan(slant), np.cos(slant), angle, involute_extended(angle))


def _operating(task: PairTask, cut: Cut) -> tuple[Long, Long]:
    """alpha_tw and a_w; of a rack the distance of its datum line."""
    asked = None if task.strategy != "given_aw" or task.distance is None else task.distance / np.longdouble(task.module)
    if task.kind == "rack":
        return np.asarray(cut.angle), np.asarray(cut.reference[0] + cut.shift[0] if asked is None else asked)
    base = np.sum(cut.base)
    if asked is not None:
        return np.arccos(np.abs(base) / asked), np.sign(base) * asked
    angle = inverse_extended(cut.level + 2 * np.sum(cut.shift) * np.tan(cut.alpha) / np.sum(cut.teeth))
    return angle, base / np.cos(angle)


def _tips(found: MeshPair, cut: Cut, distance: Long) -> Long:
    """Tip radii, signed: as asked, else by the rule where the pair has them."""
    task, rack, m = found.task, found.task.rack, np.longdouble(found.task.module)
    sign = np.sign(cut.teeth)
    told = sign * np.array([size.tip for size in found.sizes], np.longdouble) / m
    rule = cut.reference + rack.addendum + cut.shift
    if task.kind == "external":
        rule = distance - cut.reference[::-1] - cut.shift[::-1] + rack.addendum
    given = np.array([tip is not None for tip in task.tips[: len(told)]])
    tips = np.where(~given & (np.abs(rule - told) < RULE), rule, told)
    return sign * np.maximum(np.abs(tips), np.abs(cut.base))


def _path(task: PairTask, cut: Cut, angle: Long, distance: Long, rho: Long) -> Long:
    """Length of the path of contact."""
    if task.kind == "rack":
        rack = task.rack
        addendum = min(rack.addendum, rack.straight) if task.tips[1] is None else task.tips[1] / task.module
        across = (addendum - cut.shift[0]) / np.sin(cut.angle)
        return np.asarray(rho[0] + across - cut.reference[0] * np.sin(cut.angle))
    return np.asarray(np.sum(np.sign(cut.teeth) * rho) - distance * np.sin(angle))


def _turned(rho: Long, base: Long) -> Long:
    """inv(alpha_y) on circles by their radii of curvature."""
    tangent = rho / np.abs(base)
    small = np.arctan(tangent)
    return involute_extended(small) if np.any(small < 0.1) else tangent - small


def arcs(cut: Cut, tips: Long) -> Long:
    """Normal arcs of the teeth on the reference circles and then on the tip circles, whose signed radii are given."""
    at_tip = cut.half + cut.level - _turned(curvature(cut, tips), cut.base)
    slope = cut.slant * tips / cut.reference
    return np.concatenate((2 * cut.reference * cut.half * cut.cosine, 2 * tips * at_tip / np.sqrt(1 + slope * slope)))


def curvature(cut: Cut, tips: Long) -> Long:
    """Radii of curvature of the flanks on the tip circles."""
    return np.sqrt((np.abs(tips) - np.abs(cut.base)) * (np.abs(tips) + np.abs(cut.base)))


def span_error(measured: Sequence[Measures], cut: Cut, m: np.longdouble) -> float | None:
    """Of the chosen spans W, if there are any."""
    told, exact = [], []
    for k, each in enumerate(measured):
        if each.span is not None:
            inner = PI * (each.span.teeth - 0.5) + 2 * cut.shift[k] * np.tan(cut.alpha)
            told.append(each.span.length)
            exact.append(m * np.cos(cut.alpha) * (inner + cut.teeth[k] * cut.level))
    return apart(told, exact) if told else None


def balls_error(measured: Sequence[Measures], cut: Cut, m: np.longdouble, body: Body) -> float | None:
    """Of the sizes M over or between balls or pins of their diameters, if there are any."""
    told, exact = [], []
    for k, each in enumerate(measured):
        if each.balls is None:
            continue
        z, size = cut.teeth[k], each.balls.diameter / m
        space = (PI / 2 - 2 * cut.shift[k] * np.tan(cut.alpha)) / z
        angle = inverse_extended(size / (z * np.cos(cut.alpha)) + cut.level - space)
        across = 2 * np.abs(cut.base[k]) / np.cos(angle)
        if z % 2 and (body == "balls" or not cut.slant or z < 0):
            across = across * np.cos(PI / (2 * z))
        told.append(each.balls.size)
        exact.append(m * (across + np.sign(z) * size))
    return apart(told, exact) if told else None
