"""Span over teeth: the length of the common normal between outer flanks (4.58-4.65); lengths in normal modules.

    W = cos(alpha) [pi (z_w - 1/2) + 2 x tan(alpha) + z inv(alpha_t)]

The plates touch in the normal section, where each has the radius of curvature W/2; in the transverse section that is
W cos(beta_b)/2. It must lie on the usable involute, and on a helical wheel the points lie W sin(beta_b) apart along the
axis. The textbook tests the upper limits only, and each a little more strictly than need be.
"""

from __future__ import annotations

from math import ceil, cos, floor, pi, sin, tan
from typing import Literal

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.wheel import Wheel

Rule = Literal["book", "exact"]
LEAST = 2  # teeth of a span: over one there is no common normal of outer flanks to be clamped
ROWS = 3  # of the table, at least
NEAR = 1e-9  # of a tooth: a limit that a whole number meets but for rounding is kept


@record
class SpanLimits:
    """Limits of the span of one wheel; None: no such limit."""

    lowest: float  # W below which the plates touch beneath the usable involute
    tip: float  # W* of the textbook (4.62)
    tip_exact: float  # W*/cos(beta_b)
    width: float | None  # W** of the textbook, b/sin(beta) (4.64)
    width_exact: float | None  # b/sin(beta_b)

    def highest(self, rule: Rule) -> float:
        """W_min, the least of the textbook's upper limits; the rule is that of the face width."""
        width = self.width if rule == "book" else self.width_exact
        return self.tip if width is None else min(self.tip, width)

    @property
    def highest_exact(self) -> float:
        """The least of the exact upper limits."""
        return self.tip_exact if self.width_exact is None else min(self.tip_exact, self.width_exact)


@record
class Span:
    """The span over one number of teeth."""

    teeth: int  # z_w
    length: float  # W
    curvature: float  # transverse radius of curvature of the flanks where the plates touch
    radius: float  # of the circle on which they touch
    width: float  # b_min = W sin(beta_b), the face width that it needs
    book: bool  # whether the textbook's rule admits it
    valid: bool  # whether the plates touch the involute: the exact rule


@record
class Spans:
    """All spans of a wheel."""

    thickness: float  # s_n on the reference circle (4.61)
    base_thickness: float  # s_bn (4.59)
    base_pitch: float  # p_bn (4.60)
    limits: SpanLimits
    book_teeth: int  # z_w,max of the textbook (4.65), at least 0
    exact_teeth: int  # the same with the exact limit of the face width
    middle: int  # the z_w that touches nearest to mid-flank, valid or not
    recommended: int | None  # the valid z_w nearest to that; None: no span is valid
    table: tuple[Span, ...]  # from z_w = 2 to the last that a rule admits, three at least

    def most(self, rule: Rule) -> int:
        """z_w,max (4.65) by the face width of a rule."""
        return self.book_teeth if rule == "book" else self.exact_teeth

    def over(self, teeth: int) -> Span | None:
        """The span over ``teeth``, if it is in the table."""
        return next((span for span in self.table if span.teeth == teeth), None)


def span_length(wheel: Wheel, teeth: int) -> float:
    """W over ``teeth`` teeth.

    >>> from math import radians
    >>> round(5 * span_length(Wheel(27, 0.32, radians(15)), 5), 4)
    69.6047
    """
    inner = pi * (teeth - 0.5) + 2 * float(wheel.shift) * tan(wheel.rack.angle)
    return cos(wheel.rack.angle) * (inner + wheel.teeth * float(involute(wheel.transverse_angle)))


def spans(
    wheel: Wheel, tip: float, lowest: float, face_width: float | None = None, relief: float | None = None
) -> Spans:
    """Every span of an external wheel with its validity.

    ``tip`` is the radius of the tip circle, ``relief`` of the circle where a tip relief begins, ``lowest`` the radius
    of curvature of the lowest usable point of the involute (of the form circle, or of the lowest active point).
    """
    limits = span_limits(wheel, tip if relief is None else min(relief, tip), lowest, face_width)
    pitch, base = pi * cos(wheel.rack.angle), span_length(wheel, 1)

    def up_to(length: float) -> int:
        return max(floor((length - base) / pitch + 1 + NEAR), 0)

    book, relaxed, last = (
        up_to(length) for length in (limits.highest("book"), limits.highest("exact"), limits.highest_exact)
    )
    first = max(ceil((limits.lowest - base) / pitch + 1 - NEAR), LEAST)
    end = max(book, relaxed, last, LEAST + ROWS - 1)
    table = tuple(_span(wheel, k, book, (first, last)) for k in range(LEAST, end + 1))
    middle = mid_flank_teeth(wheel)
    usual = min(max(middle, first), last)
    return Spans(
        pi / 2 + 2 * float(wheel.shift) * tan(wheel.rack.angle),
        base,
        pitch,
        limits,
        book,
        relaxed,
        middle,
        usual if first <= last else None,
        table,
    )


def span_limits(wheel: Wheel, tip: float, lowest: float, face_width: float | None = None) -> SpanLimits:
    """The limits of W by both rules (4.62, 4.64)."""
    base_helix = abs(wheel.section.base_helix)
    chord = 2 * float(wheel.curvature_at(max(tip, wheel.base)))
    helical = face_width is not None and wheel.helix != 0
    width = face_width if face_width is not None else 0.0
    return SpanLimits(
        2 * lowest / cos(base_helix),
        chord,
        chord / cos(base_helix),
        width / sin(abs(wheel.helix)) if helical else None,
        width / sin(base_helix) if helical else None,
    )


def mid_flank_teeth(wheel: Wheel) -> int:
    """z_w at which the plates touch nearest to the circle r + x.

    >>> mid_flank_teeth(Wheel(30))
    4
    """
    cut, z = wheel.section, wheel.teeth
    cosine = z * cos(cut.angle) / (z + 2 * float(wheel.shift) * cos(wheel.helix))
    angle = float(np.arccos(np.clip(cosine, 0.0, 1.0)))
    turned = tan(angle) / cos(cut.base_helix) ** 2 - float(involute(cut.angle))
    return max(round(z / pi * turned - 2 * float(wheel.shift) * tan(wheel.rack.angle) / pi + 0.5), 1)


def _span(wheel: Wheel, teeth: int, book: int, exact: tuple[int, int]) -> Span:
    length, base_helix = span_length(wheel, teeth), abs(wheel.section.base_helix)
    curvature = length * cos(base_helix) / 2
    return Span(
        teeth,
        length,
        curvature,
        float(np.hypot(wheel.base, curvature)),
        length * sin(base_helix),
        LEAST <= teeth <= book,
        exact[0] <= teeth <= exact[1],
    )
