"""How the space of a wheel comes to be: positions of the tool in the wheel's axes, and what they leave (Fig. 4.33).

An external wheel is cut by its rack, a ring by its pinion-type cutter. The space of a ring whose cutter is not known
and that of a rack are shown with a tooth of the mate rolling through it. Lengths in metres, the space on +Y.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sin, sqrt, tan

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.profile.generation import in_wheel, path_of_centre, rack_outline
from tmmcalc.gears.involute.profile.mesh import Placing, ring_placings
from tmmcalc.gears.involute.profile.outline import mirrored
from tmmcalc.gears.involute.profile.shaping import ShapedRing
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.members import Member, Toothed, both
from tmmcalc.gears.pictures.placedpair import from_gap_to_gap, placings_of, rack_tooth
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.language import tr

POSITIONS = 15
PATH_POINTS = 241
CUTTER_POINTS = 61  # of an involute and of a rounding
BEYOND = 1.02  # of the last contact: how far the tooth of a mate rolls


@record
class Generation:
    """One space of a wheel, and the positions of what rolls through it; the one in the middle stands upright."""

    what: str  # in words
    outline: Plane  # the space and half a tooth on both sides
    positions: tuple[Plane, ...]  # one tooth of the tool
    path: Plane | None  # of S, the centre of the rounding of a rack's tooth


def generation_of(member: Toothed, positions: int = POSITIONS) -> Generation:
    """The space of one wheel."""
    if member.shape == "external":
        return _by_rack(member, positions)
    if isinstance(member, Member) and member.shape == "rack":
        return _of_rack(member, positions)
    if not isinstance(member, Member) and member.ring.cutter is None:
        return Generation(tr("Space of the ring"), member.module * from_gap_to_gap(member.element), (), None)
    return _of_ring(member, positions)


def _by_rack(member: Toothed, positions: int) -> Generation:
    flank, m, half = member.flank, member.module, member.half_pitch
    rolls, tool = flank.rolls, flank.rounding
    # the tooth of the rack stands upright in the space when its axis passes the line of centres
    upright = (float(tool.x) - tool.flat) / tool.reference
    last = max(rolls.tip, 2 * upright - min(rolls.limit, rolls.root))
    at = upright + (last - upright) * np.linspace(-1, 1, positions)
    into_space = m * np.exp(-1j * half)
    path = path_of_centre(flank, np.linspace(at[0], at[-1], PATH_POINTS))
    return Generation(
        tr("{count} positions of the rack and the path of $S$", count=positions),
        m * _around_space(from_gap_to_gap(member.element), half),
        tuple(in_wheel(flank, rack_outline(flank), at) * into_space),
        path * into_space,
    )


def _around_space(one: Plane, half: float) -> Plane:
    """Half a tooth, the space on +Y, half a tooth, counter-clockwise; ``one`` is a tooth on +Y."""
    turned = np.concatenate([one * np.exp(-1j * half), one * np.exp(1j * half)])
    away = np.abs(np.angle(turned * np.exp(-0.5j * np.pi)))
    return turned[away <= half * (1 + 1e-9)]


@record
class _Rolling:
    """A toothed wheel that rolls in another one; lengths in modules."""

    told: Callable[[int], str]  # what so many positions of its tooth show
    tooth: Plane  # one, on +Y
    places: Callable[[float], tuple[Placing, Placing]]  # by the phase
    base: float  # r_b
    pitch: float  # N1P
    contact: tuple[float, float]  # rho1 at its beginning and end

    def positions(self, count: int) -> list[Plane]:
        """One tooth in the axes of the other wheel, the middle position on the line of centres."""
        upright = self.places(0.0)[0].turn  # phase that brings the tooth there
        ends = [(self.pitch - rho) / self.base - upright for rho in self.contact]
        reach = BEYOND * max(map(abs, ends))
        found = []
        for phase in (upright + reach * np.linspace(-1, 1, count)).tolist():
            first, second = self.places(phase)
            found.append((first(self.tooth) - second.centre) * np.exp(-1j * second.turn))
        return found


def _of_ring(member: Toothed, positions: int) -> Generation:
    rolling, m = _cutter(member) if member.ring.cutter else _mate(member), member.module
    return Generation(
        rolling.told(positions),
        m * from_gap_to_gap(member.element),
        tuple(m * one for one in rolling.positions(positions)),
        None,
    )


def _of_rack(member: Member, positions: int) -> Generation:
    rolling, m, half = _mate(member), member.module, member.half_pitch
    one = rack_tooth(member)
    sides = np.concatenate([one + half, one - half])
    return Generation(
        rolling.told(positions),
        m * sides[np.abs(sides.real) <= half * (1 + 1e-9)],
        tuple(m * (one + half) for one in rolling.positions(positions)),
        None,
    )


def _mate(member: Toothed) -> _Rolling:
    """The pinion of a ring or rack."""
    assert isinstance(member, Member)  # a ring by itself is shown as its cutter makes it
    found = member.found
    pinion, line, m = both(found)[0], found.line, member.module
    return _Rolling(
        lambda count: tr("{count} positions of a tooth of wheel {wheel}", count=count, wheel=plain(pinion.name)),
        from_gap_to_gap(pinion.element),
        lambda phase: placings_of(found, phase),
        found.sizes[0].base / m,
        line.pitch / m,
        (line.begins / m, line.ends / m),
    )


def _cutter(member: Toothed) -> _Rolling:
    """The cutter that shapes a ring."""
    ring, like, shaped = member.ring, member.wheel, member.ring_flank
    if ring.cutter is None or not isinstance(shaped, ShapedRing):
        return _mate(member)
    teeth = ring.cutter.teeth
    cutter = Wheel(teeth, ring.cutter.shift, ring.helix, ring.rack)
    distance = shaped.operating[1] - shaped.operating[0]
    top = shaped.orbit + shaped.rounding
    begins = ring.curvature_at(member.tip) - distance * sin(shaped.angle)
    return _Rolling(
        lambda count: tr("{count} positions of a tooth of the cutter, $z_0$ = {teeth}", count=count, teeth=teeth),
        _cutter_tooth(cutter, shaped),
        lambda phase: ring_placings(cutter, like, shaped.angle, distance, phase),
        cutter.base,
        cutter.base * tan(shaped.angle),
        (max(begins, 0.0), sqrt(top**2 - cutter.base**2)),
    )


def _cutter_tooth(cutter: Wheel, shaped: ShapedRing) -> Plane:
    """A tooth of the cutter from its base circle on, counter-clockwise."""
    half = float(cutter.half_angle) + float(involute(cutter.transverse_angle))
    xi = np.linspace((sqrt(shaped.orbit**2 - cutter.base**2) + shaped.rounding) / cutter.base, 0.0, CUTTER_POINTS)
    flank = cutter.base * (1j - xi) * np.exp(1j * (half - xi))
    centre = shaped.orbit * np.exp(1j * (0.5 * np.pi + shaped.lead))
    ends = np.angle((flank[0] - centre) / centre)
    rounding = centre + shaped.rounding * centre / abs(centre) * np.exp(1j * np.linspace(0.0, ends, CUTTER_POINTS))
    left = np.concatenate([rounding, flank])
    return np.concatenate([mirrored(left), left])
