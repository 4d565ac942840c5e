"""What is asked of the pairs of a project: one by one, or for every mesh of the train that was chosen."""

from __future__ import annotations

from dataclasses import field
from math import cos, pi, tan
from typing import Literal

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.involute.measure.balls import Body
from tmmcalc.gears.involute.measure.span import Rule
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import Rack, Section
from tmmcalc.gears.involute.strategies import DESIRED, Split, Strategy

Kind = Literal["external", "internal", "rack"]
Two = tuple[float | None, float | None]
NEITHER: Two = (None, None)


@record
class Measuring:
    """What is measured on the wheels of a pair, first and second; None: the usual choice."""

    span_teeth: tuple[int | None, int | None] = (None, None)  # z_w; None: the largest that the rule admits
    balls: Two = NEITHER  # diameters [m]; None: those that touch near the circle r + x
    body: Body = "balls"
    rule: Rule = "book"  # of the largest z_w


@record
class WheelMeasuring:
    """What is measured on one wheel; None: the usual choice."""

    name: str  # of the wheel
    module: float  # [m]
    span_teeth: int | None = None
    ball: float | None = None  # [m]
    body: Body = "balls"
    rule: Rule = "book"
    face_width: float | None = None  # [m]

    @property
    def width(self) -> float | None:
        """Face width in normal modules."""
        return None if self.face_width is None else self.face_width / self.module


@record
class PairTask:
    """One pair: a pinion (or any external wheel) with its mate, an external wheel, a ring or a rack."""

    teeth: tuple[int, int]  # z1, z2; of a rack z2 = 0
    module: float = quantity("m[m]", "normal module")
    name: str = ""  # of the pair, in titles and files
    wheels: tuple[str, str] = ("1", "2")  # names of the wheels
    kind: Kind = "external"
    helix: float = quantity("beta[rad]", "helix angle at the reference cylinder, of either hand", default=0.0)
    rack: Rack = Rack()  # basic rack in the normal section
    strategy: Strategy = "balanced"
    shifts: Two = NEITHER  # x1, x2 as given
    distance: float | None = None  # a_w [m]
    split: Split = "equal_sliding"  # of the sum of shifts that a centre distance or its equal shift leaves
    desired: float = DESIRED  # contact ratio of the strategy equal_sliding
    strict: bool = True  # the choice avoids all undercut
    limits: QualityLimits = QualityLimits()
    refuse: bool = True  # whether a pair that cannot work is an error, or only told
    face_width: float | None = quantity("b[m]", "working face width", default=None)
    fillet: Shape = "ellipse"  # section of the tip rounding across helical teeth
    tips: Two = NEITHER  # radii of the tip circles [m] in place of those by the rule
    cutter: Cutter | None = None  # of a ring
    measuring: Measuring = Measuring()

    @property
    def title(self) -> str:
        """The pair in a few words.

        >>> PairTask((14, 17), 0.005).title
        'z = 14/17'
        """
        text = {"rack": "z = {pinion}/rack", "internal": "z = {pinion}/{wheel} (ring)"}.get(
            self.kind, "z = {pinion}/{wheel}"
        )
        pair = Phrase(text, pinion=self.teeth[0], wheel=self.teeth[1])
        return Phrase("{name}: {pair}", name=self.name, pair=pair) if self.name else pair

    @property
    def section(self) -> Section:
        """The basic rack across the wheels."""
        return Section(self.rack, self.helix)

    @derived("p_n[m]", "normal pitch")
    def pitch(self) -> float:
        """p_n = pi m."""
        return pi * self.module

    @derived("p_t[m]", "transverse pitch")
    def transverse_pitch(self) -> float:
        """p_t = pi m_t."""
        return pi * self.module * self.section.module

    @derived("rho_t[m]", "radius of the circle that stands for the ellipse of the tip rounding")
    def rounding(self) -> float:
        """rho_t = rho_t* m."""
        return self.module * self.section.radius

    @derived("e_S[m]", "half the flat of the rack's tip in the transverse section")
    def tip_flat(self) -> float:
        """Half the pitch line of the tooth without the straight flanks and the roundings."""
        cut = self.section
        flat = pi / 4 * cut.module - self.rack.straight * tan(cut.angle) - cut.radius * cos(cut.angle)
        return self.module * flat

    @property
    def width(self) -> float:
        """Face width in normal modules, 0 if it is not given."""
        return 0.0 if self.face_width is None else self.face_width / self.module

    def measuring_of(self, number: int) -> WheelMeasuring:
        """What is measured on wheel 1 or 2."""
        asked, k = self.measuring, number - 1
        return WheelMeasuring(
            self.wheels[k], self.module, asked.span_teeth[k], asked.balls[k], asked.body, asked.rule, self.face_width
        )


@record
class PairsTask:
    """All pairs of a project."""

    pairs: tuple[PairTask, ...] = ()  # written out; none: those of the train
    usual: PairTask | None = None  # of a train: what holds for every mesh, whatever its teeth, module and face width
    own: dict[str, PairTask] = field(default_factory=dict)  # the same of single meshes by their names, such as 2'-3
    on_crank: PairTask | None = None  # the open pair between the reducer and the crank, beside the others
    beside_train: bool = False  # whether those written out stand beside a train whose meshes they are not
