"""The ratio of a train by its kinds, and the tooth ratio U that each stands for.

u      tooth ratio U itself, positive           all but AII; the speeds of fixed axes are in this ratio but for sign
i_1H   wheel 1 over carrier = 1 + sign U        planetary, wheel 3 (or 4) fixed (4.19)
i_H1   carrier over wheel 1 = 1/i_1H            the carrier drives
i_14   wheel 1 over ring 4, with its sign       AII, ring 3 fixed
"""

from __future__ import annotations

from fractions import Fraction

from tmmcalc.gears.scheme import Layout

KINDS = ("u", "i_1H", "i_H1", "i_14")


def kinds_of(layout: Layout) -> tuple[str, ...]:
    """The kinds in which the ratio of this layout can be given, the customary one first."""
    if not layout.planetary:
        return ("u",)
    return ("i_1H", "i_H1", "u") if layout.sign else ("i_14",)


def to_tooth_ratio(layout: Layout, kind: str, ratio: Fraction) -> Fraction:
    """U of a ratio of this kind, not zero; of AII the ratio itself.

    >>> from tmmcalc.gears.scheme import layout_of
    >>> to_tooth_ratio(layout_of("AA"), "i_H1", Fraction(10_000))
    Fraction(9999, 10000)
    """
    if kind == "i_H1":
        ratio = 1 / ratio
    return layout.sign * (ratio - 1) if kind in ("i_1H", "i_H1") else ratio


def from_tooth_ratio(layout: Layout, kind: str, ratio: Fraction) -> Fraction | None:
    """The ratio of this kind of a train of tooth ratio U; None for i_H1 of a wheel 1 that stands still (U = 1)."""
    if kind not in ("i_1H", "i_H1"):
        return ratio
    speed = 1 + layout.sign * ratio
    if kind == "i_1H":
        return speed
    return 1 / speed if speed else None


def is_possible(layout: Layout, kind: str, ratio: Fraction) -> bool:
    """Whether wheels of any numbers of teeth can have this ratio: a reducer reduces, U is positive."""
    if not ratio:
        return False
    tooth_ratio = to_tooth_ratio(layout, kind, ratio)
    return bool(layout.planetary and not layout.sign) or tooth_ratio > (0 if layout.planetary else 1)


def rule(layout: Layout, kind: str) -> str:
    """Which ratios of this kind a layout has, in words."""
    if kind == "u":
        return "U is above 0" if layout.planetary else "the ratio of a reducer is above 1"
    if kind == "i_14":
        return "i_14 is not 0"
    if layout.sign > 0:
        return "i_1H = 1 + U is above 1" if kind == "i_1H" else "i_H1 = 1/(1 + U) is between 0 and 1"
    return "i_1H = 1 - U is below 1 and not 0" if kind == "i_1H" else "i_H1 = 1/(1 - U) is above 1 or below 0"


def turns_back(layout: Layout) -> bool:
    """Whether the last shaft of a train with fixed axes turns against the first: an odd number of external meshes."""
    return len(layout.meshes) % 2 == 1
