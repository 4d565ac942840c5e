"""The pairs of a project, solved; lengths in metres unless a field says modules, angles in radians."""

from __future__ import annotations

from typing import Literal

import numpy as np

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.quality.verdicts import Check, Verdict, worst
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.model import Values

UsableEnd = Literal["active", "form"]
WheelKind = Literal["external", "ring"]


@record
class ToothStrength:
    """The weakest section of a tooth with the load at its tip."""

    factor: float  # Y_F
    chord: float  # s_Fn
    arm: float  # h_F of the bending force


@record
class WheelSizes:
    """One wheel of a pair. The rack of a pinion has none of these."""

    name: str
    kind: WheelKind
    teeth: int
    shift: float  # x, of a ring with the sign of ISO 21771
    reference: float  # r
    operating: float  # r_w
    tip: float  # r_a
    root: float  # r_f
    base: float  # r_b
    form: float  # r_F where the involute ends at the fillet
    active: float  # r_p, the last radius towards the root that the mate's tip reaches on the line of action
    active_left: float  # the same on the involutes that there are
    thickness: float  # s_n, arc on the reference circle in the normal section
    tip_thickness: float  # s_na, arc on the tip circle in the normal section
    arc: float  # s_t, the first in the transverse section
    tip_arc: float  # s_ta, the second
    half_angle: float  # psi [rad], half the tooth on the reference circle
    operating_half_angle: float  # psi_w [rad], on the operating pitch circle
    least_shift: float | None  # x_min without undercut; None: ring
    limit: float | None  # LN, signed: radius of curvature at the limit point L; None: ring
    pointing: float | None  # radius where the flanks meet; None: ring
    least_teeth: float | None  # z_min without undercut at this shift; None: ring
    strength: ToothStrength | None  # None: ring


@record
class LineOfAction:
    """Distances along the line of action from N1, where it touches the base circle of wheel 1."""

    length: float  # g = N1N2; negative for a ring, whose N2 lies before N1; 0 for a rack, which has none
    pitch: float  # N1P
    start: float  # N1A2, where the whole flanks would begin to touch
    end: float  # N1A1
    begins: float  # where the contact begins on the involutes that there are
    ends: float


@record
class SlidingTable:
    """n points of the line of action."""

    rho1: Values  # (n,) N1K, radius of curvature of wheel 1
    along: Values  # (n,) s, distance from the pitch point, negative before it
    theta1: Values  # (n,) specific sliding
    theta2: Values  # (n,)
    pressure: Values  # (n,) specific pressure lambda
    active: np.ndarray  # (n,) whether the flanks touch there


@record
class SpanRow:
    """The span over one number of teeth."""

    teeth: int = quantity("z_w", "number of teeth spanned")
    length: float = quantity("W[m]", "span over z_w teeth", source="(4.61)")
    radius: float = quantity("W_radius[m]", "radius of the circle on which the plates touch", symbol="r", header="r[m]")
    curvature: float = quantity("W_rho[m]", "transverse radius of curvature of the flanks where the plates touch")
    width: float = quantity("b_min[m]", "face width that the span needs")
    valid: bool = quantity("W_exact", "the plates touch the usable involute, exactly", header="exact")
    book: bool = quantity("W_textbook", "the textbook's rule admits the span", header="textbook")


@record
class BallsRow:
    """The size over (in a ring: between) two balls or pins."""

    diameter: float = quantity("D[m]", "diameter of the balls or pins")
    size: float = quantity("M[m]", "size over two balls or pins, of a ring between them")
    radius: float = quantity("M_radius[m]", "radius of the circle on which they touch")
    angle: float = quantity("alpha_D[rad]", "transverse pressure angle on the circle of the centres")
    centres: float = quantity("d_D[m]", "diameter of the circle of the centres")
    curvature: float = quantity("rho_M[m]", "transverse radius of curvature of the flanks where they touch")
    on_flank: bool = quantity("M_on_flank", "they touch the usable involute")
    clear: bool = quantity("M_clear", "they stand proud of the tip circle and clear of the root circle")


@record
class ChordRow:
    """The tooth on one circle."""

    name: str = quantity("circle", "reference, operating, tip, or asked")
    radius: float = quantity("r[m]", "radius of the circle")
    half_angle: float = quantity("theta[rad]", "half the angle of the tooth")
    angle: float = quantity("alpha_y[rad]", "transverse pressure angle")
    helix: float = quantity("beta_y[rad]", "helix angle")
    transverse: float = quantity("s_t[m]", "arc of the tooth in the transverse section")
    arc: float = quantity("arc[m]", "arc of the tooth in the normal section", symbol="s_n")
    chord: float = quantity("chord[m]", "chord of the tooth in the normal section")
    height: float = quantity("height[m]", "height of the tip circle above the chord")
    space: float = quantity("space[m]", "arc of the space in the normal section", symbol="e_n")


@record
class Measures:
    """What is measured on one wheel."""

    wheel: str = quantity("wheel", "name of the wheel")
    base_pitch: float = quantity("p_bn[m]", "base pitch in the normal section")
    base_thickness: float = quantity("s_bn[m]", "arc of the tooth on the base circle in the normal section")
    spans: tuple[SpanRow, ...]  # none for a ring
    span_teeth: int | None  # z_w chosen; None: none is admitted
    # limits of a ring's spans, which it has not, are 0
    span_most: int = quantity(
        "z_w_max", "largest number of teeth by the textbook's W* and W**; below 2: no span", source="(4.65)"
    )
    span_most_exact: int = quantity("z_w_max_exact_width", "the same with the exact limit of the face width")
    span_middle: int = quantity("z_w_middle", "number of teeth of the span that touches nearest to mid-flank")
    span_lowest: float = quantity("W_lowest[m]", "span below which the plates touch beneath the involute")
    span_lowest_active: float = quantity(
        "W_lowest_active[m]", "span below which the plates touch beneath the lowest active point; not below W_lowest"
    )
    span_tip: float = quantity("W_star[m]", "span that reaches the tip circle", symbol="W^*", source="(4.62)")
    span_tip_exact: float = quantity("W_star_exact[m]", "the same, exactly")
    span_width: float | None = quantity(  # None: no helix or no face width
        "W_starstar[m]", "span that the face width allows", symbol="W^(**)", source="(4.64)"
    )
    span_width_exact: float | None = quantity("W_starstar_exact[m]", "the same, exactly")
    balls: BallsRow | None  # None: none of the asked diameter stands in the space
    constant_chord: float = quantity("s_c[m]", "constant chord")
    constant_chord_height: float = quantity("h_c[m]", "height of the tip above the constant chord")
    constant_chord_curvature: float = quantity(
        "rho_s[m]", "transverse radius of curvature of the flank where the constant chord ends"
    )
    constant_chord_valid: bool = quantity("s_c_valid", "the constant chord ends on the usable involute")
    usable: UsableEnd  # where the usable involute ends towards the root
    chords: tuple[ChordRow, ...]
    remarks: tuple[str, ...]  # what is unusual or cannot be measured

    @property
    def span(self) -> SpanRow | None:
        """The chosen span."""
        return next((row for row in self.spans if row.teeth == self.span_teeth), None)


@record
class SlidingPeaks:
    """The largest values of the contact."""

    theta1: float  # at its beginning
    theta2: float  # at its end
    pressure_start: float
    pressure_pitch: float
    pressure_end: float
    pressure_largest: float


@record
class PairError:
    """Relative errors of the sizes of a pair, for its shifts as they are; of a group to the largest of it."""

    angle: float  # alpha_tw
    distance: float  # a_w
    contact_ratio: float  # eps_alpha of the whole flanks
    thickness: float  # of the teeth on reference and tip circles
    span: float | None  # W of the chosen spans
    balls: float | None  # M over or between balls or pins


@record
class MeshPair:
    """One pair, solved."""

    task: PairTask  # with what the train gave
    shifts: tuple[float, float]  # x1, x2; of a rack x2 = 0
    note: str  # what the choice of the shifts could not give
    broken: tuple[str, ...]  # conditions of the blocking contour that the shifts do not meet, in words
    nearest: tuple[float, float] | None  # admissible shifts nearest to them, if any is broken
    angle_t: float  # alpha_t
    angle_w: float  # alpha_tw
    base_helix: float  # beta_b
    reference_distance: float  # a; of a rack the radius r
    distance: float  # a_w; of a rack the distance of its datum line from the axis
    stretch: float  # eta = a_w/a
    modification: float  # y, modules
    shortening: float  # dy, modules
    contact_ratio: float  # eps_alpha of the whole flanks
    shortened: float  # eps_alpha of the involutes that there are
    overlap: float  # eps_beta
    line: LineOfAction
    sizes: tuple[WheelSizes, ...]  # two, of a rack and pinion one
    clearances: tuple[float, float]  # radial, at the roots of both
    checks: tuple[Check, ...]  # lengths in modules
    peaks: SlidingPeaks | None  # of the whole flanks if their contact lies on the line of action, else as the next
    peaks_left: SlidingPeaks | None  # of the involutes that there are; None: these do not reach each other
    sliding: SlidingTable
    measures: tuple[Measures, ...]  # as sizes
    error: PairError | None = None  # None: not estimated

    @property
    def total(self) -> float:
        """eps_gamma of the whole flanks (4.69)."""
        return self.contact_ratio + self.overlap

    @property
    def total_left(self) -> float:
        """eps_gamma of the involutes that there are."""
        return self.shortened + self.overlap

    @property
    def turn(self) -> float:
        """gamma [rad] between the points of a flank on the reference and on the operating pitch circle (4.73)."""
        return float(involute(self.angle_w) - involute(self.angle_t))

    @property
    def verdict(self) -> Verdict:
        """The worst of all checks."""
        return worst(self.checks)


@record
class Pairs:
    """All pairs of a project."""

    pairs: tuple[MeshPair, ...]
    train: str  # layout and teeth of the train that they belong to; empty: pairs by themselves
    remarks: tuple[str, ...]  # what was taken for want of data, and what the train asks of its pairs
