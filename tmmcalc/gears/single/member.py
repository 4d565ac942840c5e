"""A wheel without a mate as something that has teeth, for outlines, profiles and drawings; lengths in modules."""

from __future__ import annotations

from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.ring import Ring
from tmmcalc.gears.involute.profile.rounding import Shape as Section
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.members import Shape, Toothed
from tmmcalc.gears.single.task import WheelTask


@record
class SingleMember(Toothed):
    """The wheel of a task."""

    task: WheelTask

    @property
    def name(self) -> str:
        """The name of the wheel."""
        return self.task.measuring.name

    @property
    def pair(self) -> str:
        """It is in none."""
        return ""

    @property
    def shape(self) -> Shape:
        """External, or a ring."""
        return "ring" if self.task.kind == "internal" else "external"

    @property
    def module(self) -> float:
        """Normal module [m]."""
        return self.task.module

    @property
    def wheel(self) -> Wheel:
        """The wheel as its rack cuts it; of a ring the wheel whose teeth fill its spaces."""
        if self.shape == "external":
            return self.task.wheel
        ring = self.ring
        return Wheel(ring.teeth, -ring.shift, ring.helix, ring.rack)

    @property
    def ring(self) -> Ring:
        """The ring, if it is one."""
        return self.task.ring

    @property
    def tip(self) -> float:
        """Radius of the tip circle."""
        return self.task.tip_radius

    @property
    def fillet(self) -> Section:
        """Section of the rounding of its rack across helical teeth."""
        return self.task.fillet

    @property
    def shift(self) -> float:
        """Its shift."""
        return self.task.shift

    @property
    def angle(self) -> float:
        """Transverse pressure angle [rad] of its rack."""
        return self.task.wheel.transverse_angle
