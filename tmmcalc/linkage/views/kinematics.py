"""The linkage over its cycle, moved by its input: with velocities, accelerations, reactions, plans, dead centres."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.linkage.columns import PHI
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.freebody import Solved, solved
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.pictures.bodies import centre_of_block
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.views.applied import Drawn, applied_of
from tmmcalc.linkage.views.linkage import MovingLinkage
from tmmcalc.linkage.views.plans import plans_of_forces, plans_of_motion
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import Arrow, Handle, Layer, Mark, Plan, Stop, View

ARC = 64  # parts of a turn
SECTOR = 0.16  # of the crank: how large sectors are


def views(order: Order) -> Iterator[View]:
    """The linkage over its cycle."""
    mechanism = to_linkage(order.spec.linkage)
    yield Cycle(mechanism, order.results["kinematics"], order.results.get("forces"), order.spec).view()


class Cycle:
    """The linkage while its view is made; ``spec`` tells the loads of its forces."""

    def __init__(self, mechanism: Mechanism, result: Kinematics, forces: Any = None, spec: Any = None) -> None:
        self.mechanism, self.result, self.forces, self.spec = mechanism, result, forces, spec
        self.per = math.pi / 180 if result.turns else 1.0  # of the input in its unit
        self.moved = MovingLinkage(mechanism, result, result.x, self.per)
        self.rows: Rows | None = None
        if isinstance(forces, Forces):
            from tmmcalc.linkage.tables.tasks.loading import to_loading

            self.rows = Rows(mechanism, to_loading(spec), result, forces)

    @cached_property
    def acting(self) -> Solved | None:
        """All that acts on the links, in the rows of the forces."""
        if self.rows is None:
            return None
        return solved(self.rows.statics, self.rows.result.theta, self.rows.side)

    def view(self) -> View:
        """The view."""
        result, moved, unreached = self.result, self.moved, tuple(self._unreached())
        applied = Drawn((), ()) if self.acting is None else applied_of(self.acting, self.forces, self.per)
        return View(
            name="kinematics",
            title="Mechanism",
            symbol="φ" if result.turns else "s",
            unit="deg" if result.turns else "m",
            values=result.phi / self.per,
            whole=result.turns and math.isclose(abs(float(result.phi[-1] - result.phi[0])), 2 * math.pi),
            column=PHI.of(unit="deg" if result.turns else "m").key,
            steps=(),
            box=moved.box,
            bodies=(*moved.bodies(), *applied.points),
            frame=(*unreached, *moved.frame()),
            spots=tuple(moved.spots()),
            handle=self._handle(),
            layers=(*self._layers(), *applied.layers),
            centres=tuple(moved.centres()),
            plans=self._plans,
            stops=tuple(self._stops()),
            shown=tuple(self._shown()),
            reach=self._reach(),
            note="in the sectors at the crank's pivot the links do not close" if unreached else "",
        )

    def _handle(self) -> Handle | None:
        """The input link: a crank about its pivot, or a slider; none between two moving links."""
        joint: Joint = self.mechanism.joint(self.result.input_joint)
        if FRAME not in joint.links:
            return None
        at = joint.links.index(FRAME)
        return Handle(str(joint.links[1 - at]), joint.points[at] if self.result.turns else None)

    def _unreached(self) -> Iterator[Mark]:
        """The sectors that a crank does not come into, for its links do not close there."""
        handle, reach = self._handle(), sorted(self._reach())
        if handle is None or handle.pivot is None or not reach:
            return
        link = int(handle.body)
        outline = next(each for each in self.moved.outlines if each.link == link)
        ends = [complex(self.moved.motion.place(link, p)[0]) - handle.pivot for p in outline.corners]
        crank = SECTOR * max(ends, key=abs)
        sense = float(np.ravel(self.moved.motion.configuration.motions[link].omega)[0])
        for (_, last), (first, _) in zip(reach, [*reach[1:], (reach[0][0] + 360.0, 0.0)], strict=True):
            if first > last:
                angles = np.radians(np.linspace(last, first, 1 + math.ceil((first - last) / 360.0 * ARC)))
                arc = handle.pivot + crank * np.exp(1j * sense * angles)
                yield Mark("zone", (handle.pivot, *map(complex, arc)))

    def _layers(self) -> Iterator[Layer]:
        yield from self.moved.layers("kinematics")
        if isinstance(self.forces, Forces):
            yield Layer("reaction", "Reactions", "N", tuple(self._reactions()), hidden=True)

    def _reactions(self) -> Iterator[Arrow]:
        """The force of the lower-numbered link on the higher-numbered one in every pair."""
        for joint in self.mechanism.joints:
            lower, higher = sorted(joint.links)
            spot = next((pin.name for pin in self.moved.pins if joint.name in pin.joints), None) or self._at_block(
                joint
            )
            if spot is not None:
                column = f"forces.R_{joint.name}"
                yield Arrow(f"R_{lower}{higher}", spot, f"{column}_x", f"{column}_y")

    def _at_block(self, joint: Joint) -> str | None:
        """The point at the centre of the block of a prismatic pair."""
        if joint.kind != "prismatic":
            return None
        link, centre = joint.links[0], centre_of_block(joint, self.moved.pins)
        return next((pin.name for pin in self.moved.pins if pin.at.get(link) == centre), None)

    def _plans(self) -> Iterator[Plan]:
        """Plans of velocities and accelerations; of forces, where they are computed."""
        yield from plans_of_motion(self.mechanism, self.result)
        if self.rows is not None and self.acting is not None:
            yield from plans_of_forces(self.rows, self.acting, self.per)

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
