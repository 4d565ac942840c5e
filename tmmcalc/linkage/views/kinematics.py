"""The linkage as a page moves it: links with their outlines, named points, velocities, accelerations, reactions."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.model import FRAME, Joint
from tmmcalc.linkage.pictures.bodies import LinkOutline, bodies, centre_of_block, travel
from tmmcalc.linkage.pictures.cycle import motion_at
from tmmcalc.linkage.pictures.links import corners_of
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.views.plans import plans_of_forces, plans_of_motion
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import FRAME as STANDING
from tmmcalc.report.moving import (
    Arrow,
    Body,
    Centre,
    Handle,
    Layer,
    Mark,
    Plan,
    Spot,
    SpotKind,
    Stop,
    Track,
    View,
    track_of,
)

REACH = 0.04  # of the size: how far slots go beyond the ends of sliders
FAR = 30.0  # times the size: an instant centre beyond is not shown


def views(order: Order) -> Iterator[View]:
    """The linkage over its cycle."""
    yield _Linkage(order.results["kinematics"], order).view()


class _Linkage:
    """The linkage while its view is made."""

    def __init__(self, result: Kinematics, order: Order) -> None:
        self.result, self.forces, self.spec = result, order.results.get("forces"), order.spec
        self.mechanism = to_linkage(order.spec.linkage)
        self.chain = chain_of(self.mechanism, result)
        self.motion = motion_at(self.chain, result.x)
        self.pins = find_pins(self.mechanism)
        self.per = math.pi / 180 if result.turns else 1.0  # of the input in its unit
        rough = bodies(self.mechanism, self.pins, self.motion, 0.0)
        content = np.concatenate([self.motion.place(body.link, p) for body in rough for p in body.corners])
        fixed = [pin.at[FRAME] for pin in self.pins if pin.fixed]
        content = np.concatenate([content, np.array(fixed, complex)])
        self.low = complex(content.real.min(), content.imag.min())
        self.high = complex(content.real.max(), content.imag.max())
        self.size = max((self.high - self.low).real, (self.high - self.low).imag)
        self.outlines = bodies(self.mechanism, self.pins, self.motion, REACH * self.size)

    def view(self) -> View:
        result = self.result
        return View(
            name="kinematics",
            title="Mechanism",
            symbol="φ" if result.turns else "s",
            unit="deg" if result.turns else "m",
            values=result.phi / self.per,
            whole=result.turns and math.isclose(abs(float(result.phi[-1] - result.phi[0])), 2 * math.pi),
            column="phi[deg]" if result.turns else "phi[m]",
            steps=(),
            box=(self.low, self.high),
            bodies=tuple(map(self._body, self.outlines)),
            frame=tuple(self._frame()),
            spots=tuple(self._spots()),
            handle=self._handle(),
            layers=tuple(self._layers()),
            centres=tuple(self._centres()),
            plans=self._plans,
            stops=tuple(self._stops()),
            shown=tuple(self._shown()),
            reach=self._reach(),
        )

    def _body(self, outline: LinkOutline) -> Body:
        """A link: its origin, its angle, what is drawn of it."""
        motion = self.motion.configuration.motions[outline.link]
        count = len(self.result.x)
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
        return track_of(values, np.asarray(rates) * self.per, len(self.result.x))

    def _frame(self) -> Iterator[Mark]:
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

    def _spots(self) -> Iterator[Spot]:
        """Named points, moving ones with their paths."""
        for pin in self.pins:
            link = FRAME if pin.fixed else next(iter(pin.at))
            kind: SpotKind = "pin" if pin.joints else "mass" if pin.centre else "point"
            body = STANDING if pin.fixed else str(link)
            yield Spot(pin.name, body, pin.at[link], kind, path=not pin.fixed and not pin.centre)

    def _handle(self) -> Handle:
        """The input link: a crank about its pivot, or a slider along its guide."""
        joint: Joint = self.mechanism.joint(self.result.input_joint)
        link = self.result.structure.input_link
        if self.result.turns:
            return Handle(str(link), pivot=joint.points[joint.links.index(FRAME)])
        side = joint.links.index(link)
        direction = joint.directions[side] * complex(self.motion.turn(link)[0])
        return Handle(str(link), direction=direction if side == 0 else -direction)

    def _layers(self) -> Iterator[Layer]:
        moving = [pin for pin in self.pins if not pin.fixed]
        known = set(self.result.trace.point_names)
        for name, letter, title, unit in (
            ("velocity", "v", "Velocities", "m/s"),
            ("acceleration", "a", "Accelerations", "m/s^2"),
        ):
            arrows = tuple(
                Arrow(
                    f"{letter}_{pin.name}",
                    pin.name,
                    f"kinematics.{letter}x_{pin.name}",
                    f"kinematics.{letter}y_{pin.name}",
                )
                for pin in moving
                if pin.name in known
            )
            if arrows:
                yield Layer(name, title, unit, arrows)
        if isinstance(self.forces, Forces):
            yield Layer("reaction", "Reactions", "N", tuple(self._reactions()))

    def _reactions(self) -> Iterator[Arrow]:
        """The force of the lower-numbered link on the higher-numbered one in every pair."""
        for joint in self.mechanism.joints:
            lower, higher = sorted(joint.links)
            spot = next((pin.name for pin in self.pins if joint.name in pin.joints), None) or self._at_block(joint)
            if spot is not None:
                column = f"forces.R_{joint.name}"
                yield Arrow(f"R_{lower}{higher}", spot, f"{column}_x", f"{column}_y")

    def _at_block(self, joint: Joint) -> str | None:
        """The point at the centre of the block of a prismatic pair."""
        if joint.kind != "prismatic":
            return None
        link, centre = joint.links[0], centre_of_block(joint, self.pins)
        return next((pin.name for pin in self.pins if pin.at.get(link) == centre), None)

    def _centres(self) -> Iterator[Centre]:
        """Instant centres of the moving links against the frame."""
        middle = (self.low + self.high) / 2
        for outline in self.outlines:
            motion = self.motion.configuration.motions[outline.link]
            origin = motion.point(0j)
            with np.errstate(divide="ignore", invalid="ignore"):
                at = np.broadcast_to(origin.r + 1j * origin.v / motion.omega, self.result.x.shape).copy()
            lost = ~np.isfinite(at) | (np.abs(at - middle) > FAR * self.size)
            if not lost.all() and np.ptp(at[~lost].real) + np.ptp(at[~lost].imag) > 1e-9 * self.size:
                at[lost] = complex(np.nan, np.nan)
                yield Centre(f"P_{outline.link}0", at)

    def _plans(self) -> Iterator[Plan]:
        """Plans of velocities and accelerations; of forces, where they are computed."""
        yield from plans_of_motion(self.mechanism, self.result)
        if isinstance(self.forces, Forces):
            from tmmcalc.linkage.pictures.course import statics_of
            from tmmcalc.linkage.tables.tasks.loading import to_loading

            statics = statics_of(self.mechanism, to_loading(self.spec), self.result)
            yield from plans_of_forces(statics, self.result, self.forces, self.per)

    def _stops(self) -> Iterator[Stop]:
        """Dead centres of the outputs."""
        start, turn = float(self.result.x[0]), 2 * math.pi
        for summary in self.result.summaries:
            for centre in summary.dead_centres:
                along = centre.x - start
                along = along % math.copysign(turn, self.result.speed) if self.result.turns else along
                yield Stop(Phrase("dead centre of {output}", output=summary.name), along / self.per)

    def _shown(self) -> Iterator[str]:
        """Motion of the first output, and the drive."""
        for output in self.result.outputs[:1]:
            yield from (f"kinematics.{letter}S_{output}" for letter in ("", "v", "a"))
        if isinstance(self.forces, Forces):
            yield f"forces.{'M' if self.result.turns else 'F'}_drive"

    def _reach(self) -> tuple[tuple[float, float], ...]:
        """Where the mechanism assembles, counted as the positions are."""
        if self.result.domain.full:
            return ()
        start = float(self.result.x[0])
        return tuple(
            ((each.low - start) / self.per, (each.high - start) / self.per) for each in self.result.domain.intervals
        )


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
