"""The nominal ratio of a train: as it is given by its kind, or as that of the speeds of the shafts that it joins."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.exact import around
from tmmcalc.gears.kinds import is_possible, rule, to_tooth_ratio
from tmmcalc.gears.model import Interval
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.trains import Request

SMALLEST = Fraction(1, 10**7)  # of tooth ratios within the limits that can be asked for
SPEEDS = 10**6  # a ratio of speeds is the nearest fraction of smaller terms, which 1450 rpm to 178 rpm is exactly


def with_nominal(request: Request, nominal: Fraction) -> Request:
    """The request with a ratio of its kind, the tolerance about it, and the tooth ratios that this admits."""
    layout, kind = request.scheme, request.kind
    admitted = around(nominal, request.tolerance, relative=request.relative)
    tooth_ratio = to_tooth_ratio(layout, kind, nominal)
    task = replace(request.task, nominal=tooth_ratio, ratio=_tooth_ratios(layout, kind, admitted))
    usual, remarks = layout.usual_ratio, request.remarks
    if usual is not None and tooth_ratio > usual:
        large = Phrase(
            "U = {tooth_ratio:g} is large for {title}, which is usual up to {usual}",
            tooth_ratio=float(tooth_ratio),
            title=layout.title,
            usual=usual,
        )
        remarks = (*remarks, large)
    return replace(request, task=task, nominal=nominal, admitted=admitted, remarks=remarks)


def with_speeds(request: Request, ratio: float, origin: str) -> Request:
    """The request with the ratio of the speeds of its input and output shaft, ``origin`` tells whose; either way round.

    A motor turns either way, so the sign is the one that the layout can have. Raises `NoSolutionError` for a layout
    that can have neither.
    """
    size = Fraction(ratio).limit_denominator(SPEEDS)
    layout, kind = request.scheme, request.kind
    for nominal in (size, -size):
        if is_possible(layout, kind, nominal):
            return replace(with_nominal(request, nominal), origin=origin)
    raise NoSolutionError(
        f"layout {layout.key} cannot have the ratio {float(size):.6g} = {origin}: {rule(layout, kind)}",
        where="train",
        value=float(size),
        remedy="choose another layout, ratio_kind, motor or speed of the crank",
    )


def _tooth_ratios(layout: Layout, kind: str, admitted: Interval) -> Interval:
    """The admitted ratios as tooth ratios, exactly; where they reach below zero they end above it."""
    low, high = sorted(to_tooth_ratio(layout, kind, end) for end in (admitted.low, admitted.high))
    return Interval(low, high) if layout.planetary and not layout.sign else Interval(max(low, SMALLEST), high)
