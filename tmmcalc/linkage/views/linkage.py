"""A linkage as a page moves it over any input: links with outlines, supports and guides, named points, vectors."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.pictures.bodies import LinkOutline, bodies, centre_of_block, travel
from tmmcalc.linkage.pictures.cycle import motion_at
from tmmcalc.linkage.pictures.links import corners_of
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.moving import FRAME as STANDING
from tmmcalc.report.moving import Arrow, Body, Centre, Layer, Mark, Spot, SpotKind, Track, track_of

REACH = 0.04  # of the size: how far slots go beyond the ends of sliders
FAR = 30.0  # times the size: an instant centre beyond is not shown


class MovingLinkage:
    """A linkage at input coordinates ``x`` (n,) [rad or m], which go with the input of a view at rates ``per``."""

    def __init__(self, mechanism: Mechanism, result: Kinematics, x: Real, per: float | Real) -> None:
        self.mechanism, self.x, self.per = mechanism, x, per
        self.chain = chain_of(mechanism, result)
        self.points = set(result.trace.point_names)
        self.motion = motion_at(self.chain, x)
        self.pins = find_pins(self.mechanism)
        rough = bodies(self.mechanism, self.pins, self.motion, 0.0)
        content = np.concatenate([self.motion.place(body.link, p) for body in rough for p in body.corners])
        fixed = [pin.at[FRAME] for pin in self.pins if pin.fixed]
        content = np.concatenate([content, np.array(fixed, complex)])
        self.low = complex(content.real.min(), content.imag.min())
        self.high = complex(content.real.max(), content.imag.max())
        self.size = max((self.high - self.low).real, (self.high - self.low).imag)
        self.outlines = bodies(self.mechanism, self.pins, self.motion, REACH * self.size)

    @property
    def box(self) -> tuple[complex, complex]:
        """The corners of all that moves."""
        return self.low, self.high

    def bodies(self) -> Iterator[Body]:
        """The links."""
        return map(self._body, self.outlines)

    def _body(self, outline: LinkOutline) -> Body:
        """A link: its origin, its angle, what is drawn of it."""
        motion = self.motion.configuration.motions[outline.link]
        count = len(self.x)
        origin = motion.point(0j)
        angle = np.unwrap(np.angle(np.broadcast_to(motion.u, (count,))))
        x = self._track(np.real(origin.r), np.real(origin.v))
        y = self._track(np.imag(origin.r), np.imag(origin.v))
        marks = [
            *([Mark("plate", outline.plate)] if outline.plate else []),
            *(Mark("slot", slot) for slot in outline.slots),
            *(Mark("bar", bar) for bar in outline.bars),
            *(Mark("block", (block.centre, block.direction)) for block in outline.blocks),
            *(Mark("weld", corner) for corner in corners_of(outline)),
        ]
        beside = _beside(outline)
        return Body(
            str(outline.link), x, y, self._track(angle, motion.omega), tuple(marks), str(outline.link), tuple(beside)
        )

    def _track(self, values: Real, rates: Real) -> Track:
        return track_of(values, np.asarray(rates) * self.per, len(self.x))

    def frame(self) -> Iterator[Mark]:
        """Supports, guides and sleeves."""
        for pin in self.pins:
            if pin.fixed and pin.joints:
                yield Mark("pivot", (pin.at[FRAME], self._free_side(pin)))
            elif pin.fixed and not self._on_guide(pin):
                yield Mark("cross", (pin.at[FRAME],))
        for joint in self.mechanism.joints:
            if joint.kind == "prismatic" and joint.links[1] == FRAME:
                q, e = joint.points[1], joint.directions[1]
                low, high = travel(joint, self.pins, self.motion)
                ends = (q + low * e, q + high * e)
                yield Mark("guide", (*ends, self._outward(sum(ends) / 2, e)))
            elif joint.kind == "prismatic" and joint.links[0] == FRAME:
                direction = joint.directions[1] * complex(self.motion.turn(joint.links[1])[0])
                at = centre_of_block(joint, self.pins)
                yield Mark("sleeve", (at, direction, self._outward(at, direction)))

    def _on_guide(self, pin: Pin) -> bool:
        """Points of the frame that only carry a guide's line need no sign of their own."""
        return any(
            joint.kind == "prismatic" and joint.links[1] == FRAME and joint.points[1] == pin.at[FRAME]
            for joint in self.mechanism.joints
        )

    def _outward(self, at: complex, direction: complex) -> complex:
        """The side of a guide that looks away from the mechanism."""
        normal = -1j * direction
        away = ((at - (self.low + self.high) / 2) * np.conj(normal)).real
        return normal if away >= 0 else -normal

    def _free_side(self, pin: Pin) -> complex:
        """Where the support of a pivot covers links least over the cycle: below, or else above, left, right."""
        at = pin.at[FRAME]
        rays: list[Plane] = []
        for outline in self.outlines:
            if outline.link in pin.at:
                for segment in outline.segments:
                    rays += [self.motion.place(outline.link, end) - at for end in segment]
        sides = (-1j, 1j, -1 + 0j, 1 + 0j)

        def covered(side: complex) -> float:
            return sum(float(np.mean((ray * np.conj(side)).real > 0.8 * np.abs(ray))) for ray in rays)

        costs = [covered(side) for side in sides]
        return sides[int(np.argmin(np.round(costs, 6)))]

    def spots(self) -> Iterator[Spot]:
        """Named points, moving ones with their paths."""
        for pin in self.pins:
            link = FRAME if pin.fixed else next(iter(pin.at))
            kind: SpotKind = "pin" if pin.joints else "mass" if pin.centre else "point"
            body = STANDING if pin.fixed else str(link)
            yield Spot(pin.name, body, pin.at[link], kind, path=not pin.fixed and not pin.centre)

    def layers(self, stage: str) -> Iterator[Layer]:
        """Velocities and accelerations of the moving points, by the columns of a stage."""
        moving = [pin for pin in self.pins if not pin.fixed]
        known = self.points
        for name, letter, title, unit in (
            ("velocity", "v", "Velocities", "m/s"),
            ("acceleration", "a", "Accelerations", "m/s^2"),
        ):
            arrows = tuple(
                Arrow(
                    f"{letter}_{pin.name}",
                    pin.name,
                    f"{stage}.{letter}x_{pin.name}",
                    f"{stage}.{letter}y_{pin.name}",
                )
                for pin in moving
                if pin.name in known
            )
            if arrows:
                yield Layer(name, title, unit, arrows, hidden=name == "acceleration")

    def centres(self) -> Iterator[Centre]:
        """Instant centres of the moving links against the frame."""
        middle = (self.low + self.high) / 2
        for outline in self.outlines:
            motion = self.motion.configuration.motions[outline.link]
            origin = motion.point(0j)
            with np.errstate(divide="ignore", invalid="ignore"):
                at = np.broadcast_to(origin.r + 1j * origin.v / motion.omega, self.x.shape).copy()
            lost = ~np.isfinite(at) | (np.abs(at - middle) > FAR * self.size)
            if not lost.all() and np.ptp(at[~lost].real) + np.ptp(at[~lost].imag) > 1e-9 * self.size:
                at[lost] = complex(np.nan, np.nan)
                yield Centre(f"P_{outline.link}0", at)


def _beside(outline: LinkOutline) -> Iterator[complex]:
    """Where the number of a link may stand."""
    if outline.plate:
        yield sum(outline.plate) / len(outline.plate)
    segments = outline.bars or outline.slots
    if segments:
        a, b = max(segments, key=lambda segment: abs(segment[1] - segment[0]))
        yield from (a + t * (b - a) for t in (0.5, 0.35, 0.65))
    elif outline.blocks:
        yield outline.blocks[0].centre
    elif not outline.plate:
        yield 0j
