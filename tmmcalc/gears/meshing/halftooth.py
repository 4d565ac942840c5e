"""Half a tooth as smooth parts from the middle of the space at the root to the middle of the tip.

Axes of the tooth: origin in the wheel's centre (of a rack on its datum line), the tooth along +Y, its left half; the
teeth of a ring point towards its centre from above. Lengths in normal modules, all curvatures in closed form; a radius
is positive where the outline bulges out of the metal.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi, tan
from typing import Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.curves import Curve
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.outline import Element, arcs, tooth
from tmmcalc.gears.involute.profile.ring import RingFlank
from tmmcalc.gears.involute.profile.shaping import ShapedRing
from tmmcalc.gears.meshing.members import Toothed

PartName = Literal["root", "fillet", "involute", "flank", "tip"]  # the straight flank is that of a rack
Kind = Literal["curve", "arc", "line"]  # an arc has its centre in the wheel's, and its parameter is the polar angle
Function = Callable[[Real], Real]
NARROW, ZOOMS = 33, 7  # samples of a fillet where its least radius is sought, and how often they are drawn together


@record
class ProfilePart:
    """A smooth part; its functions take parameters (n,) from ``start`` to ``end``."""

    name: PartName
    kind: Kind
    curve: Curve
    radius: Function  # of curvature, signed; 0: straight
    roll: Function = np.zeros_like  # phi [rad]


@record
class Half:
    """Half a tooth."""

    parts: tuple[ProfilePart, ...]
    tip: float
    root: float
    base: float
    form: float
    undercut: bool
    rolls: tuple[float, float, float, float]  # phi_L, phi_D, phi_A, phi_F
    remark: str = ""

    @property
    def fillet(self) -> ProfilePart:
        """The curve between root and flank."""
        return next(part for part in self.parts if part.name == "fillet")

    @property
    def flank(self) -> ProfilePart:
        """The involute, of a rack the straight flank."""
        return next(part for part in self.parts if part.name in ("involute", "flank"))

    @property
    def join(self) -> float:
        """Distance of both where they meet."""
        last, first = (part.curve.point(np.array([at])) for part, at in self._meeting)
        return float(np.abs(last - first)[0])

    @property
    def _meeting(self) -> tuple[tuple[ProfilePart, float], tuple[ProfilePart, float]]:
        return (self.fillet, self.fillet.curve.end), (self.flank, self.flank.curve.start)

    @property
    def least_radius(self) -> float:
        """Least radius of curvature of the fillet."""
        low, high = self.fillet.curve.start, self.fillet.curve.end
        best = np.inf
        for _ in range(ZOOMS):
            at = np.linspace(low, high, NARROW)
            radii = np.abs(self.fillet.radius(at))
            k = int(np.argmin(radii))
            best = min(best, float(radii[k]))
            low, high = float(at[max(k - 1, 0)]), float(at[min(k + 1, NARROW - 1)])
        return best


def half_tooth(member: Toothed) -> Half:
    """Half a tooth of a wheel; raises `NoSolutionError` that names it if it cannot have a profile."""
    with member.told():
        if member.shape == "rack":
            return _of_rack(member)
        return _of_ring(member) if member.shape == "ring" else _of_wheel(member)


def fault_of(member: Toothed) -> NoSolutionError | None:
    """Why a wheel cannot have a profile; None: it has one."""
    try:
        half_tooth(member)
    except NoSolutionError as error:
        return error
    return None


def _of_wheel(member: Toothed) -> Half:
    flank = member.flank
    root, tip = _arcs(tooth(flank))
    tool, start, rolls = flank.rounding, tan(flank.rounding.angle), flank.rolls
    involute, fillet = (_upward(curve) for curve in flank.curves)
    curves = (
        ProfilePart("fillet", "curve", fillet, lambda theta: -1 / tool.curvature(theta), tool.roll),
        ProfilePart("involute", "curve", involute, lambda xi: flank.wheel.base * xi, lambda xi: xi - start),
    )
    remark = Phrase("pointed at the radius {tip:.6g} mm, below its tip circle", tip=flank.tip * member.module * 1000.0)
    return Half(
        (*root, *curves, *tip),
        flank.tip,
        float(flank.wheel.root),
        flank.wheel.base,
        flank.form,
        float(tool.limit) < 0,
        (rolls.limit, rolls.root, rolls.tip, rolls.form),
        remark if flank.pointed else "",
    )


def _upward(curve: Curve) -> Curve:
    """The curve from its other end."""
    return replace(curve, start=curve.end, end=curve.start)


def _arcs(element: Element) -> tuple[tuple[ProfilePart, ...], tuple[ProfilePart, ...]]:
    """The left halves of the arcs at the root and over the tip of a tooth; none where they vanish."""
    crest, gap = arcs(element)
    middle = pi / 2 + pi / element.teeth
    return _arc("root", gap.radius, middle, gap.sweep, 1.0), _arc("tip", crest.radius, pi / 2, -crest.sweep, 1.0)


def _arc(name: PartName, radius: float, middle: float, sweep: float, side: float) -> tuple[ProfilePart, ...]:
    """Half of an arc: at the root from its middle on, at the tip to its middle."""
    if sweep == 0:
        return ()
    ends = (middle, middle - sweep / 2) if name == "root" else (middle - sweep / 2, middle)
    curve = Curve(
        lambda angle: radius * np.exp(1j * np.asarray(angle)), lambda angle: 1j * radius * np.exp(1j * angle), *ends
    )
    return (ProfilePart(name, "arc", curve, lambda angle: np.full_like(angle, side * radius)),)


def _of_ring(member: Toothed) -> Half:
    flank = member.ring_flank
    element, start = flank.element, tan(member.wheel.transverse_angle)
    turned = np.exp(1j * member.half_pitch)

    def mirrored(curve: Curve) -> Curve:
        """The right side of a space, turned beside the tooth on +Y."""
        return Curve(
            lambda at: -np.conj(curve.point(at)) * turned,
            lambda at: -np.conj(curve.rate(at)) * turned,
            curve.start,
            curve.end,
        )

    bottom, flat = arcs(element)
    radius, roll = _ring_fillet(flank, start)
    fillet, involute = (mirrored(curve) for curve in element.curves)
    parts = (
        *_arc("root", flank.root, pi / 2 + member.half_pitch, bottom.sweep, -1.0),
        ProfilePart("fillet", "curve", fillet, radius, roll),
        ProfilePart("involute", "curve", involute, lambda xi: -flank.base * xi, lambda xi: xi - start),
        *_arc("tip", flank.tip, pi / 2, -flat.sweep, -1.0),
    )
    form, deepest = involute.start - start, float(roll(np.array([fillet.start]))[0])
    rolls = form, deepest if isinstance(flank, ShapedRing) else form, involute.end - start, form
    return Half(parts, flank.tip, flank.root, flank.base, flank.form, False, rolls)


def _ring_fillet(flank: RingFlank | ShapedRing, start: float) -> tuple[Function, Function]:
    """Radius of curvature and roll angle at the bottom of a ring's space; an arc that nothing rolls has none."""
    if isinstance(flank, RingFlank):
        corner = flank.corner
        return lambda angle: np.full_like(angle, -corner), np.zeros_like
    shaped = flank
    shift = shaped.highest - start - float(shaped.turn(shaped.angle))
    return lambda theta: -shaped.fillet_radius(theta), lambda theta: shaped.turn(theta) + shift


def _of_rack(member: Toothed) -> Half:
    tool, rack = member.tool, member.wheel.rack
    quarter, slope = member.half_pitch / 2, tan(tool.angle)
    root, foot = -rack.addendum - rack.clearance, float(np.imag(tool.on_rack(tool.angle)))
    rounded = Curve(
        lambda theta: tool.on_rack(theta) - quarter,
        lambda theta: -1j * tool.radius_of_curvature(theta) * np.exp(-1j * theta),
        pi / 2,
        tool.angle,
    )
    fillet = ProfilePart("fillet", "curve", rounded, lambda theta: -tool.radius_of_curvature(theta))
    lowest, highest = complex(slope * foot - quarter, foot), complex(slope * member.tip - quarter, member.tip)
    middle = complex(-2 * quarter, root)
    bottom = (_line("root", middle, middle + tool.flat),) if tool.flat > 0 else ()
    above = _line("flank", lowest, highest), _line("tip", highest, 1j * member.tip)
    return Half((*bottom, fillet, *above), member.tip, root, 0.0, foot, False, (0.0, 0.0, 0.0, 0.0))


def _line(name: PartName, first: complex, last: complex) -> ProfilePart:
    run = last - first
    curve = Curve(lambda t: first + t * run, lambda t: np.full_like(t, run, dtype=complex), 0.0, 1.0)
    return ProfilePart(name, "line", curve, np.zeros_like)
