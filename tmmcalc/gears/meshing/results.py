"""The pairs of a project, solved; lengths in metres unless a field says modules, angles in radians."""

from __future__ import annotations

from typing import Literal

import numpy as np

from tmmcalc.core.notes import Note
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.quality.verdicts import Check, Verdict, worst
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.model import Values

UsableEnd = Literal["active", "form"]
WheelKind = Literal["external", "ring"]
NOISE = 1e-9  # [modules] a flank shorter by less is whole; of a radius, its part of the base circle's


@record
class ToothStrength:
    """The weakest section of a tooth with the load at its tip."""

    factor: float = quantity("Y_F", "form factor of the tooth")
    chord: float = quantity("s_Fn[m]", "chord of the weakest section")
    arm: float = quantity("h_F[m]", "arm of the bending force")


@record
class WheelSizes:
    """One wheel of a pair. The rack of a pinion has none of these."""

    name: str = quantity("wheel", "name of the wheel")
    kind: WheelKind = quantity("kind", "external or ring")
    teeth: int = quantity("z", "number of teeth")
    shift: float = quantity("x", "profile shift")  # of a ring with the sign of ISO 21771
    reference: float = quantity("r[m]", "reference radius")
    operating: float = quantity("r_w[m]", "operating pitch radius")
    tip: float = quantity("r_a[m]", "tip radius")
    root: float = quantity("r_f[m]", "root radius")
    base: float = quantity("r_b[m]", "base radius")
    form: float = quantity("r_F[m]", "form radius: the involute ends")
    # the last radius towards the root that the mate's tip reaches on the line of action
    active: float = quantity("r_p[m]", "active radius: the contact ends")
    active_left: float = quantity("r_usable[m]", "active radius on the involutes that there are")
    thickness: float = quantity("s_n[m]", "tooth thickness, normal")  # arc on the reference circle
    tip_thickness: float = quantity("s_na[m]", "tip thickness, normal")  # arc on the tip circle
    arc: float = quantity("s_t[m]", "tooth thickness, transverse")
    tip_arc: float = quantity("s_ta[m]", "tip thickness, transverse")
    half_angle: float = quantity("psi[rad]", "half the angle of the tooth on the reference circle")
    operating_half_angle: float = quantity("psi_w[rad]", "half the angle of the tooth on the operating pitch circle")
    # None of the next: ring
    least_shift: float | None = quantity("x_min", "least shift without undercut")
    limit: float | None = quantity("LN[m]", "radius of curvature at the limit point, signed")
    pointing: float | None = quantity("r_s[m]", "radius where the flanks meet")
    least_teeth: float | None = quantity("z_min", "least number of teeth without undercut at this shift")
    strength: ToothStrength | None

    @derived("r_p_left[m]", "the same of the flanks left")
    def active_shortened(self) -> float | None:
        """The active radius where the contact ends earlier than the whole flanks would let it."""
        return self.active_left if abs(self.active_left - self.active) > NOISE * self.base else None


@record
class LineOfAction:
    """Distances along the line of action from N1, where it touches the base circle of wheel 1."""

    length: float  # N1N2; negative for a ring, whose N2 lies before N1; 0 for a rack, which has none
    pitch: float = quantity("N1P[m]", "distance of the pitch point P from N1")
    start: float = quantity("N1A2[m]", "where the whole flanks would begin to touch")
    end: float = quantity("N1A1[m]", "where the contact of the whole flanks would end")
    begins: float = quantity("contact_from[m]", "where the contact begins on the involutes that there are")
    ends: float = quantity("contact_to[m]", "where the contact ends on the involutes that there are")

    @derived("N2A1[m]", "distance of A1, the end of the contact, from N2, where the line touches the other base circle")
    def end_from_second(self) -> float:
        """N2A1."""
        return abs(self.length - self.end)

    @derived("N2P[m]", "distance of N2 from the pitch point P")
    def pitch_from_second(self) -> float:
        """N2P."""
        return abs(self.length - self.pitch)

    @derived("g[m]", "distance between the points N1 and N2")
    def between(self) -> float:
        """g = N1N2."""
        return abs(self.length)

    @derived("g_alpha[m]", "path of contact of the whole flanks")
    def path(self) -> float:
        """g_alpha = A2A1."""
        return self.end - self.start


@record
class SlidingTable:
    """n points of the line of action."""

    # all (n,)
    rho1: Values = quantity("rho1[m]", "N1K, radius of curvature of wheel 1")
    along: Values = quantity("s[m]", "distance from the pitch point, negative before it")
    theta1: Values = quantity("theta1", "specific sliding of wheel 1")
    theta2: Values = quantity("theta2", "specific sliding of wheel 2")
    pressure: Values = quantity("lambda", "coefficient of specific pressure")
    active: np.ndarray = quantity("active", "whether the flanks touch there")


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
    span_teeth: int | None  # number of teeth of the chosen span; None: none is admitted
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
    usable: UsableEnd = quantity("usable_to", "where the usable involute ends towards the root")
    chords: tuple[ChordRow, ...]
    remarks: tuple[Note, ...]  # what is unusual or cannot be measured

    @property
    def span(self) -> SpanRow | None:
        """The chosen span."""
        return next((row for row in self.spans if row.teeth == self.span_teeth), None)


@record
class SlidingPeaks:
    """The largest values of the contact."""

    theta1: float = quantity("theta_1", "specific sliding of wheel 1 at the beginning of the contact")
    theta2: float = quantity("theta_2", "specific sliding of wheel 2 at the end of the contact")
    pressure_start: float = quantity("lambda_start", "coefficient of specific pressure at the beginning of the contact")
    pressure_pitch: float = quantity("lambda_P", "specific pressure at the pitch point")
    pressure_end: float = quantity("lambda_end", "coefficient of specific pressure at the end of the contact")
    pressure_largest: float = quantity("lambda_max", "largest coefficient of specific pressure")


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
    shifts: tuple[float, float] = quantity("x_{wheel}", "profile shift of wheel {wheel}")  # of a rack x2 = 0
    note: str  # what the choice of the shifts could not give
    broken: tuple[str, ...]  # conditions of the blocking contour that the shifts do not meet, in words
    nearest: tuple[float, float] | None  # admissible shifts nearest to them, if any is broken
    angle_t: float = quantity("alpha_t[rad]", "transverse pressure angle", source="(4.52)")
    angle_w: float = quantity("alpha_tw[rad]", "operating transverse pressure angle")
    base_helix: float = quantity("beta_b[rad]", "helix angle at the base cylinder")
    reference_distance: float = quantity("a[m]", "reference centre distance")  # of a rack the radius r
    distance: float = quantity("a_w[m]", "operating centre distance")  # of a rack from its datum line to the axis
    stretch: float = quantity("eta", "operating over reference centre distance, a_w/a")
    modification: float = quantity("y", "centre distance modification in modules")
    shortening: float = quantity("dy", "shortening of the tips in modules", symbol="Delta y")
    contact_ratio: float = quantity("eps_alpha", "transverse contact ratio of the whole flanks", source="(4.67)")
    shortened: float = quantity(
        "eps_alpha_shortened", "transverse contact ratio of the involutes that there are", header="eps_alpha"
    )
    overlap: float = quantity("eps_beta", "overlap ratio")
    line: LineOfAction
    sizes: tuple[WheelSizes, ...]  # two, of a rack and pinion one
    clearances: tuple[float, float] = quantity("clearances[m]", "radial clearances at the roots of both wheels")
    checks: tuple[Check, ...]  # lengths in modules
    peaks: SlidingPeaks | None  # of the whole flanks if their contact lies on the line of action, else as the next
    peaks_left: SlidingPeaks | None  # of the involutes that there are; None: these do not reach each other
    sliding: SlidingTable
    measures: tuple[Measures, ...]  # as sizes
    error: PairError | None = None  # None: not estimated

    @derived("eps_gamma", "total contact ratio of the whole flanks", source="(4.69)")
    def total(self) -> float:
        """eps_gamma = eps_alpha + eps_beta."""
        return self.contact_ratio + self.overlap

    @derived("eps_gamma_shortened", "total contact ratio of the involutes that there are")
    def total_left(self) -> float:
        """The same with the transverse contact ratio of these."""
        return self.shortened + self.overlap

    @derived("inv_alpha_t", "involute function of the transverse pressure angle")
    def involute_t(self) -> float:
        """inv alpha_t."""
        return float(involute(self.angle_t))

    @derived("inv_alpha_tw", "involute function of the operating pressure angle")
    def involute_w(self) -> float:
        """inv alpha_tw."""
        return float(involute(self.angle_w))

    @derived(
        "gamma[rad]",
        "angle between the points of a flank on the reference and on the operating pitch circle",
        source="(4.73)",
    )
    def turn(self) -> float:
        """gamma = inv alpha_tw - inv alpha_t."""
        return self.involute_w - self.involute_t

    @derived("x_sum", "sum of the shifts")
    def shift_sum(self) -> float:
        """x1 + x2."""
        return self.shifts[0] + self.shifts[1]

    @derived("verdict", "the worst verdict of all checks")
    def verdict(self) -> Verdict:
        """The worst of all checks."""
        return worst(self.checks)


@record
class Pairs:
    """All pairs of a project."""

    pairs: tuple[MeshPair, ...]
    train: str  # layout and teeth of the train that they belong to; empty: pairs by themselves
    remarks: tuple[str, ...]  # what was taken for want of data, and what the train asks of its pairs
