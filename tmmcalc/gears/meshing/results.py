"""The pairs of a project, solved; lengths in metres unless a field says modules, angles in radians."""

from __future__ import annotations

from typing import Literal

import numpy as np

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

    teeth: int  # z_w
    length: float  # W
    radius: float  # of the circle on which the plates touch
    curvature: float  # transverse radius of curvature of the flanks there
    width: float  # b_min, the face width that it needs
    valid: bool  # the plates touch the usable involute, exactly
    book: bool  # the textbook's rule admits it


@record
class BallsRow:
    """The size over (in a ring: between) two balls or pins."""

    diameter: float  # D
    size: float  # M
    radius: float  # of the circle on which they touch
    angle: float  # alpha_D [rad], transverse, on the circle of the centres
    centres: float  # d_D, diameter of that circle
    curvature: float  # rho_M, transverse radius of curvature of the flanks where they touch
    on_flank: bool  # they touch the usable involute
    clear: bool  # they stand proud of the tip circle and clear of the root circle


@record
class ChordRow:
    """The tooth on one circle."""

    name: str  # reference, operating, tip, or asked
    radius: float
    half_angle: float  # theta [rad], half the tooth
    angle: float  # pressure angle [rad], transverse
    helix: float  # [rad]
    transverse: float  # arc, transverse section
    arc: float  # normal section
    chord: float  # normal section
    height: float  # from the tip circle to the chord
    space: float  # arc of the space, normal section


@record
class Measures:
    """What is measured on one wheel."""

    wheel: str
    base_pitch: float  # p_bn, normal
    base_thickness: float  # s_bn, normal, on the base circle
    spans: tuple[SpanRow, ...]  # none for a ring
    span_teeth: int | None  # z_w chosen; None: none is admitted
    span_most: int  # z_w,max of the textbook (4.65), with W* and W**; below 2: no span is admitted; 0 for a ring
    span_most_exact: int  # the same with the exact limit of the face width
    span_middle: int  # z_w that touches nearest to mid-flank; 0 for a ring
    span_lowest: float  # W below which the plates touch beneath the involute; 0 for a ring
    span_lowest_active: float  # W below which they touch beneath the lowest active point; at least the former
    span_tip: float  # W* by the textbook (4.62); 0 for a ring
    span_tip_exact: float
    span_width: float | None  # W** by the textbook (4.64); None: no helix or no face width
    span_width_exact: float | None
    balls: BallsRow | None  # None: none of the asked diameter stands in the space
    constant_chord: float  # s_c
    constant_chord_height: float  # h_c
    constant_chord_curvature: float  # rho_s, transverse radius of curvature of the flank where it ends
    constant_chord_valid: bool
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
