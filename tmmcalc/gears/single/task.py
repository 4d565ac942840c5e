"""What is asked of a wheel without a mate."""

from __future__ import annotations

from math import pi
from typing import Literal

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.ring import Cutter, Ring
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.rack import Rack, Section
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.task import WheelMeasuring

Kind = Literal["external", "internal"]


@record
class WheelTask:
    """One wheel, external or a ring, with the tool that cuts it."""

    teeth: int = quantity("z", "number of teeth")
    module: float = quantity("m[m]", "normal module")
    measuring: WheelMeasuring  # what is measured besides its teeth on the circles
    kind: Kind = "external"
    shift: float = quantity("shift", "profile shift", symbol="x", default=0.0)  # of a ring with the sign of ISO 21771
    helix: float = quantity("beta[rad]", "helix angle at the reference cylinder, of either hand", default=0.0)
    rack: Rack = Rack()  # basic rack in the normal section
    tip: float | None = None  # radius of the tip circle [m]; None: of teeth as high as the rack's
    cutter: Cutter | None = None  # of a ring
    face_width: float | None = quantity("b[m]", "working face width", default=None)
    fillet: Shape = "ellipse"  # section of the tip rounding across helical teeth
    circles: tuple[float, ...] = ()  # radii [m] on which the tooth is measured too
    tip_thickness: float = 0.0  # [module] below it the wheel fails
    tip_thickness_wanted: float = 0.25  # [module] below it is warned
    undercut: bool = True  # whether undercut is tolerated, with a warning
    points: int = 50  # of each curve of the profile

    @property
    def wheel(self) -> Wheel:
        """An external wheel; of a ring the one of ISO 21771, with negative number of teeth and radii."""
        teeth = -self.teeth if self.kind == "internal" else self.teeth
        return Wheel(teeth, self.shift, abs(self.helix), self.rack)

    @property
    def ring(self) -> Ring:
        """The ring."""
        return Ring(self.teeth, self.shift, abs(self.helix), self.rack, self.cutter)

    @property
    def section(self) -> Section:
        """The basic rack across the wheel."""
        return Section(self.rack, abs(self.helix))

    @property
    def tip_radius(self) -> float:
        """Radius of the tip circle in modules."""
        plain = self.ring.plain_tip if self.kind == "internal" else float(self.wheel.plain_tip)
        return plain if self.tip is None else self.tip / self.module

    @derived("p_n[m]", "normal pitch")
    def pitch(self) -> float:
        """p_n = pi m."""
        return pi * self.module

    @derived("p_t[m]", "transverse pitch")
    def transverse_pitch(self) -> float:
        """p_t = pi m_t."""
        return pi * self.module * self.section.module
