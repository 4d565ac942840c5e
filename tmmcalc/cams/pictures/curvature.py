"""Diagrams beside the drawing of a cam: curvature over the turn, distance from the axis."""

from __future__ import annotations

from itertools import pairwise
from math import degrees
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.report.drawing.curves import frame, mark
from tmmcalc.report.drawing.labels import Labels
from tmmcalc.report.drawing.style import INK, MARK, PATH

DENSE = 160  # points of a piece of the motion
PITCH: dict[str, Any] = {"color": PATH, "linestyle": "-"}
WORKING: dict[str, Any] = {"color": INK, "linestyle": "-"}
CUSP: dict[str, Any] = {"color": MARK, "linewidth": 1.0, "linestyle": (0, (6, 2)), "zorder": 3}
CUSPED = 0.02  # of the pitch curve's radius: a working profile that is sharper has a cusp, without end on paper
NEAR_CUSP = 2.5  # 1/r2 against the largest curvature of the pitch curve, where it is drawn


def pieces_of(rim: Rim) -> list[tuple[Values, np.ndarray]]:
    """Angles (m,) of every piece of the motion with its number (m,), up to both its ends."""
    edges = rim.program.edges
    return [(np.linspace(a, b, DENSE), np.full(DENSE, k)) for k, (a, b) in enumerate(pairwise(edges))]


def _bend(rim: Rim, result: Profile, phi: Values, piece: np.ndarray) -> list[Values]:
    """Curvature [1/mm] of pitch curve and working profile, or the radius [mm] under a flat face."""
    here = rim.at(phi, piece)
    if result.flat:
        return [1e3 * here.speed]
    kappa = here.bend
    gap = 1 - kappa * result.follower.roller
    working = np.where(gap > CUSPED, kappa / np.where(gap > CUSPED, gap, 1.0), np.nan)
    return [kappa / 1e3, working / 1e3] if result.follower.roller else [kappa / 1e3]


def draw_bends(axes: Axes, rim: Rim, result: Profile) -> None:
    """Curvature of pitch curve and working profile, or the radius under a flat face."""
    styles = [WORKING] if result.flat else [PITCH, WORKING]
    for phi, piece in pieces_of(rim):
        for style, values in zip(styles, _bend(rim, result, phi, piece), strict=False):
            axes.plot(np.degrees(phi), values, linewidth=1.3, zorder=4, **style)
    label = r"$\rho = S + S''$, mm" if result.flat else r"curvature $\kappa$, 1/mm"
    frame(axes, label, np.array([0.0, 360.0]), True, 13)
    if not result.flat:
        _limit_bends(axes, result)


def _limit_bends(axes: Axes, result: Profile) -> None:
    """The curvature of the pitch curve that would be a cusp, where it is near; the heights, endless with a cusp."""
    roller = result.follower.roller
    peak = max(result.sharpest.value / 1e3, _working_peak(result) or 0.0)
    names = (("pitch curve", PITCH), ("working profile", WORKING))
    handles = [Line2D([], [], label=name, linewidth=1.3, **style) for name, style in names[: 2 if roller else 1]]
    if roller and 1 / roller < NEAR_CUSP * result.sharpest.value:
        axes.axhline(1e-3 / roller, **CUSP)
        handles.append(Line2D([], [], label="$1/r_2$: cusp of the pitch curve", **CUSP))
        peak = max(peak, 1e-3 / roller)
    low = 0.0 if result.hollowest is None else result.hollowest.value / 1e3
    axes.set_ylim(1.6 * low - 0.08 * peak, 1.25 * peak)
    axes.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, handlelength=2.4, columnspacing=1.2
    )


def _working_peak(result: Profile) -> float | None:
    """The largest curvature of the working profile [1/mm], where that of the pitch curve is; None by a cusp."""
    gap = 1 - result.sharpest.value * result.follower.roller
    return result.sharpest.value / gap / 1e3 if gap > CUSPED else None


def name_bends(axes: Axes, rim: Rim, result: Profile) -> None:
    """Mark the sharpest and the hollowest place, of the working profile the sharpest."""
    labels = Labels(axes)
    for phi, piece in pieces_of(rim):
        for values in _bend(rim, result, phi, piece):
            labels.avoid((np.degrees(phi) + 1j * values)[np.isfinite(values)], 0.7)
    factor = 1e3 if result.flat else 1e-3
    for place in (result.sharpest, result.hollowest):
        if place is not None:
            at = complex(degrees(place.phi), factor * place.value)
            mark(axes, labels, at, WORKING if result.flat else PITCH)
    worked = None if result.flat or not result.follower.roller else _working_peak(result)
    if worked is not None:
        mark(axes, labels, complex(degrees(result.sharpest.phi), worked), WORKING)


def draw_distance(axes: Axes, rim: Rim, result: Profile) -> None:
    """How far the curves are from the axis of the cam."""
    for phi, piece in pieces_of(rim):
        here = rim.at(phi, piece)
        if not result.flat:
            axes.plot(np.degrees(phi), 1e3 * np.abs(here.points), linewidth=1.3, zorder=4, **PITCH)
        radius = 1e3 * np.abs(here.offset(result.working.distance))
        axes.plot(np.degrees(phi), radius, linewidth=1.3, zorder=4, **WORKING)
    frame(axes, "distance from $O$, mm", np.array([0.0, 360.0]), True, 13)
    axes.set_ylim(bottom=0.0)


def name_distance(axes: Axes, rim: Rim, result: Profile) -> None:
    """Mark the place that is nearest to the axis."""
    labels = Labels(axes)
    for phi, piece in pieces_of(rim):
        here = rim.at(phi, piece)
        labels.avoid(np.degrees(phi) + 1e3j * np.abs(here.offset(result.working.distance)), 0.7)
    mark(axes, labels, complex(degrees(result.nearest.phi), 1e3 * result.nearest.value), WORKING)
