"""A train as a page turns it, seen along its axes: wheels to scale with spokes and a mark, in mesh; true speeds.

Planets go with their carrier, all of them. A bevel planet turns across the axis of its carrier: it is seen from its
side. The input is the angle of the member that drives; after so many of its turns as all others need to come round, or
many, the travel ends.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.chosen.motion import Moving
from tmmcalc.gears.gearingtask import ends
from tmmcalc.gears.network.model import FRAME
from tmmcalc.gears.pictures.words import teeth_text
from tmmcalc.gears.views.wheels import ALIKE, Member, members_of, teeth_of
from tmmcalc.report.moving import FRAME as STANDING
from tmmcalc.report.moving import TONES, Body, Handle, Mark, Reading, Spot, Track, View, track_of

TURNS, USUAL = 36, 12  # of the member that drives, after which the travel ends: at most; where all do not come round
PLAIN = 10**4  # denominators of ratios that are looked for where two speeds are given
SECONDS = 2.0  # that a turn of the fastest member takes
RIM, DEEP = 0.035, 3.0  # width of the rim of a ring, in parts of the train, and at least in modules
SPOKES = 3  # of a wheel
MARK, INNER = 0.8, 0.88  # where the mark of a wheel is, where its spokes end, in parts of its radius
NUDGE = 5.0  # of the arrow keys [deg]
HUB = 0.3  # radius of the hub that holds a wheel which stands, in parts of its own
THICK = 0.12  # of a bevel planet from its side, in parts of its diameter
SHORT = 2  # letters of a name that has room in a ring


class Front:
    """A train while its view is made."""

    def __init__(self, found: Moving) -> None:
        self.found = found
        self.members, self.meshes = members_of(found)
        self.teeth = teeth_of(self.members, self.meshes)
        self.axis = {member.name: member.axes[0] for member in self.members}
        self.driver = self._driver()
        self.rates = {member.name: self._rate(member.name) for member in self.members}
        self.turns, self.whole = self._travel()
        self.low, self.high = self._box(0.0)
        modules = [2 * each.radius / each.teeth for member in self.members for each in member.circles if each.ring]
        self.rim = max(
            RIM * max((self.high - self.low).real, (self.high - self.low).imag), DEEP * max(modules, default=0)
        )
        self.low, self.high = self._box(self.rim)

    def view(self, name: str) -> View:
        """What moves."""
        fastest = max(abs(float(rate)) for rate in self.rates.values())
        chosen = self.found.chosen
        title = "Gear train"
        if chosen is not None:
            teeth = teeth_text(chosen.sets.teeth[0].tolist())
            title = Phrase("Gear train, {name}: z = {teeth}", name=chosen.sets.scheme.title, teeth=teeth)
        return View(
            name=name,
            title=title,
            symbol=f"φ{_below(self.driver)}",
            unit="deg",
            values=np.array([0.0, 360.0 * self.turns]),
            whole=self.whole,
            column="",
            steps=tuple(("", 360.0 * at) for at in self._stops()),
            box=(self.low, self.high),
            bodies=tuple(self._bodies()),
            frame=tuple(self._frame()),
            spots=tuple(self._spots()),
            handle=self._handle(),
            readings=tuple(self._readings()),
            seconds=SECONDS * self.turns * fastest,
            nudge=NUDGE,
        )

    def _driver(self) -> str:
        """The member whose angle is the input: that which drives, or else the first that is known to turn."""
        motion = self.found.motion
        driver, _ = ends(self.found.task)
        moving = [name for name in (driver, *motion.driven, *motion.members) if name and motion.speed(name)]
        return moving[0] if moving else motion.members[0]

    def _rate(self, name: str) -> Fraction:
        """The turns of a member for one of the driver."""
        exact = dict(zip(self.found.motion.members, self.found.motion.exact, strict=True))
        own, driver = exact.get(name, Fraction()), exact[self.driver]
        if not driver:
            return Fraction()
        rate = own / driver
        plain = rate.limit_denominator(PLAIN)
        return plain if math.isclose(plain, rate, rel_tol=ALIKE) else rate

    def _travel(self) -> tuple[int, bool]:
        """Turns of the driver over the travel, and whether all have come round then."""
        seen = [self.rates[member.name] for member in self.members if not member.tilted]
        needed = math.lcm(*(rate.denominator for rate in seen))
        if needed <= TURNS:
            return needed, True
        slowest = min(abs(rate) for rate in seen if rate)
        return min(max(USUAL, math.ceil(1 / slowest)), TURNS), False

    def _stops(self) -> Iterator[float]:
        """Where one steps to: quarters of a turn, or turns where there are many."""
        per = 4 if self.turns <= USUAL else 1
        yield from (k / per for k in range(per * self.turns + 1))

    def _box(self, rim: float) -> tuple[complex, complex]:
        """Corners of all that moves, rings with their rims."""
        reach: list[tuple[complex, float]] = []
        for member in self.members:
            own = max((circle.radius + rim * circle.ring for circle in member.circles), default=0.0)
            if member.bearer == FRAME:
                reach += [(axis, own) for axis in member.axes]
            else:
                centre = self.axis[member.bearer]
                reach += [(centre, abs(axis - centre) + own) for axis in member.axes]
        low = complex(min(z.real - r for z, r in reach), min(z.imag - r for z, r in reach))
        high = complex(max(z.real + r for z, r in reach), max(z.imag + r for z, r in reach))
        return low, high

    def _bodies(self) -> Iterator[Body]:
        """Members by their size, the largest undermost, carriers over all."""
        for member in sorted(self.members, key=lambda each: (each.name in self._carriers(), -each.outer)):
            for k, axis in enumerate(member.axes):
                yield self._body(member, k, axis)

    def _carriers(self) -> set[str]:
        return {member.bearer for member in self.members if member.bearer != FRAME}

    def _body(self, member: Member, k: int, axis: complex) -> Body:
        bearer = member.bearer
        origin = axis - (self.axis[bearer] if bearer != FRAME else 0j)
        turn = self.rates[member.name] - (self.rates[bearer] if bearer != FRAME else 0)
        still = track_of(np.array(0.0), np.array(0.0), 2)
        start = float(np.angle(origin)) if bearer != FRAME and origin else 0.0
        angle = still if member.tilted else self._turning(turn)
        if start:
            angle = Track(angle.values + start, angle.rates)
        x, y = (track_of(np.array(part), np.array(0.0), 2) for part in (origin.real, origin.imag))
        marks = [*(self._tilted(member) if member.tilted else self._wheels(member, k, start))]
        if member.name in self._carriers():
            marks += self._arms(member)
        named = k == 0 and len(member.name) <= SHORT
        return Body(
            f"{member.name}#{k}" if k else member.name,
            x,
            y,
            angle,
            tuple(marks),
            member.name if named else "",
            (self._beside(member),),
            on=STANDING if bearer == FRAME else bearer,
        )

    def _turning(self, rate: Fraction) -> Track:
        """The angle of a member that turns evenly with the driver."""
        total = 2 * math.pi * float(rate) * self.turns
        return track_of(np.array([0.0, total]), np.array(total / (360.0 * self.turns)), 2)

    def _tone(self, member: Member) -> int:
        """The number of its colour: wheels by turns, carriers that of ink."""
        wheels = [each.name for each in self.members if each.circles]
        return TONES[wheels.index(member.name) % len(TONES)] if member.circles else 0

    def _wheels(self, member: Member, copy: int, start: float) -> Iterator[Mark]:
        """Wheels and rims with what shows that they turn; what stands is hatched. Its axes begin at ``start`` [rad]."""
        tone, stands = self._tone(member), not self.rates[member.name]
        for place, circle in sorted(enumerate(member.circles), key=lambda each: -each[1].radius):
            radius, outer = circle.radius, circle.radius + self.rim
            angle = self.teeth[member.name, copy, place] - start
            tooth = radius * complex(math.cos(angle), math.sin(angle))
            if circle.ring:
                yield Mark("rim", (0j, tooth, complex(outer)), circle.teeth, tone)
                if stands:
                    yield Mark("held", (0j,), outer)
                else:
                    yield Mark("dot", (complex(radius + 0.6 * self.rim),), tone=tone)
                continue
            yield Mark("cog", (0j, tooth), circle.teeth, tone)
            if stands:
                yield Mark("held", (0j,), HUB * radius)
                continue
            for k in range(SPOKES):
                way = INNER * radius * complex(math.cos(2 * math.pi * k / SPOKES), math.sin(2 * math.pi * k / SPOKES))
                yield Mark("spoke", (0j, way), tone=tone)
            yield Mark("dot", (complex(MARK * radius),), tone=tone)

    def _tilted(self, member: Member) -> Iterator[Mark]:
        """A bevel planet from its side, its axis along the ray."""
        for circle in member.circles:
            half = THICK * circle.radius
            corners = [complex(x, y) for x, y in ((-half, -1), (half, -1), (half, 1), (-half, 1))]
            yield Mark("gear", tuple(complex(z.real, z.imag * circle.radius) for z in corners), tone=self._tone(member))

    def _arms(self, carrier: Member) -> Iterator[Mark]:
        """From the axis of a carrier to all that it bears."""
        for member in self.members:
            if member.bearer == carrier.name:
                for axis in member.axes:
                    if axis != carrier.axes[0]:
                        yield Mark("bar", (0j, axis - carrier.axes[0]))
                        yield Mark("dot", (axis - carrier.axes[0],))

    def _beside(self, member: Member) -> complex:
        """Where its number stands: in the rim, else between its circle and the next smaller one, beside spokes."""
        if not member.circles:
            far = [
                abs(axis - member.axes[0]) for each in self.members if each.bearer == member.name for axis in each.axes
            ]
            return complex(0.5 * max(far, default=0.0))
        largest = max(member.circles, key=lambda each: each.radius)
        if largest.ring:
            return 1j * (largest.radius + 0.6 * self.rim)
        within = [
            circle.radius
            for other in self.members
            for circle in other.circles
            if other.axes[0] == member.axes[0] and circle.radius < largest.radius * (1 - ALIKE)
        ]
        between = (max(within) + largest.radius) / 2 if within else 0.55 * largest.radius
        return between * np.exp(1j * math.pi / SPOKES).item()

    def _frame(self) -> Iterator[Mark]:
        """Axes that stand."""
        for axis in dict.fromkeys(axis for member in self.members if member.bearer == FRAME for axis in member.axes):
            yield Mark("cross", (axis,))

    def _spots(self) -> Iterator[Spot]:
        """Names that have no room in a ring."""
        for member in self.members:
            if len(member.name) > SHORT and member.name != FRAME:
                yield Spot(member.name, member.name, self._beside(member), "point")

    def _handle(self) -> Handle | None:
        """The driver, or a member that turns in the frame."""
        able = [each for each in self.members if each.bearer == FRAME and not each.tilted and self.rates[each.name]]
        able.sort(key=lambda each: each.name != self.driver)
        return Handle(able[0].name, pivot=able[0].axes[0]) if able else None

    def _readings(self) -> Iterator[Reading]:
        """Speeds of the members; where none is known, their turns for one of the driver."""
        unknown = bool(self.found.remarks)
        for name, speed in zip(self.found.motion.members, self.found.motion.speeds.tolist(), strict=True):
            value = float(self.rates[name]) if unknown and name in self.rates else speed
            told = Phrase("member {member}: turns for one of {driver}", member=name, driver=self.driver)
            said = told if unknown else Phrase("member {member}: angular velocity", member=name)
            sign, unit = (f"i_{name}", "") if unknown else (f"omega_{name}", "rad/s")
            yield Reading(said, sign, unit, track_of(np.array(value), np.array(0.0), 2))


def _below(name: str) -> str:
    """A name as an index: digits below the line.

    >>> _below("1"), _below("H")
    ('₁', '(H)')
    """
    return name.translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")) if name.isdigit() else f"({name})"
