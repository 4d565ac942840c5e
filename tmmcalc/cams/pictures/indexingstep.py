"""Diagrams over one step: motion of the wheel, pressure angles, polar angles of the lobe, efficiency."""

from __future__ import annotations

from math import degrees
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.cams.indexing.efficiency import against, aiding
from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.laws.law import Values
from tmmcalc.report.drawing.curves import frame
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import CURVES, MARK

DENSE = 401
LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 1.0, "linestyle": (0, (6, 2)), "zorder": 3}
PLACE: dict[str, Any] = {"color": "#6b6b6b", "linewidth": 0.7, "linestyle": (0, (9, 2, 2, 2)), "zorder": 2}
FAINT = {"linewidth": 0.9, "alpha": 0.45}
STRONG = {"linewidth": 1.5}


def draw_step(panels: list[Axes], drive: Drive, result: Indexing, cam: Cam) -> None:
    """The curves and frames; texts follow by `name_step`."""
    k = np.linspace(0.0, 1.0, DENSE)
    front, groove = Flank(drive, "A"), Flank(drive, "B")
    _motion(panels[0], front, k)
    _pressure(panels[1], front, groove, result, cam, k)
    _polar(panels[2], front, k)
    _efficiency(panels[3], front, groove, result, cam, k)
    for axes in panels:
        axes.axvline(cam.handover.part, **PLACE)
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("$k = \\varphi/\\varphi_\\mathrm{p}$")


def _motion(axes: Axes, flank: Flank, k: Values) -> None:
    y, y1, y2, _ = flank.motion(k)
    curves = (np.degrees(y) / degrees(2 * flank.drive.half), y1, y2)
    names = ("$\\beta/\\beta_\\mathrm{m}$", "$\\beta'$", "$\\beta''$")
    for values, name, style in zip(curves, names, CURVES, strict=False):
        axes.plot(k, values, label=name, zorder=4, **{**style, **STRONG})
    frame(axes, "motion of the wheel", k, False, 11)
    axes.legend(loc="lower left", ncols=3)


def _pressure(axes: Axes, front: Flank, groove: Flank, result: Indexing, cam: Cam, k: Values) -> None:
    end = cam.handover.part
    for flank, own, name, style in (
        (front, k <= end, "$\\vartheta_1$ on A", CURVES[0]),
        (groove, k >= end, "$\\vartheta_2$ on B", CURVES[1]),
    ):
        values = np.degrees(flank.pressure(k))
        whole = values if flank is front else np.where(np.abs(k - 0.5) < 1e-9, np.nan, values)
        axes.plot(k, whole, zorder=3, **{**style, **FAINT})
        axes.plot(k[own], values[own], label=name, zorder=4, **{**style, **STRONG})
    for sign in (1, -1):
        axes.axhline(sign * degrees(result.limit), **LIMIT)
    frame(axes, "pressure angle, °", k, False, 11)
    axes.set_ylim(-95, 95)
    axes.legend(loc="lower left", ncols=2)


def _polar(axes: Axes, front: Flank, k: Values) -> None:
    """The polar angle of A at k and of the back of the lobe at 1 - k: equal radii, whose angles meet at the tip."""
    back = Flank(front.drive, "back")
    ahead = np.degrees(front.polar(k) - front.drive.step * k)
    behind = np.degrees(back.polar(1 - k) - front.drive.step * (1 - k))
    for values, name, style in ((ahead, "$\\delta_1(k)$", CURVES[0]), (behind, "$\\delta_3(1 - k)$", CURVES[2])):
        axes.plot(k, values, label=name, zorder=4, **{**style, **STRONG})
    frame(axes, "polar angle of the lobe, °", k, False, 11)
    axes.legend(loc="lower left", ncols=2)


def _efficiency(axes: Axes, front: Flank, groove: Flank, result: Indexing, cam: Cam, k: Values) -> None:
    first = k <= cam.handover.part
    angle = np.where(first, front.pressure(k), groove.pressure(k))
    sigma = np.where(first, front.rise_angle(k), groove.rise_angle(k))
    for formula, name, style in (
        (against, "load against the motion", CURVES[0]),
        (aiding, "load along the motion", CURVES[1]),
    ):
        axes.plot(k, formula(angle, sigma, *result.frictions)[0], label=name, zorder=4, **{**style, **STRONG})
    frame(axes, "efficiency $\\eta$", k, False, 11)
    axes.set_ylim(0.0, 1.05)
    axes.legend(loc="upper left", ncols=2)


def name_step(panels: list[Axes], drive: Drive, result: Indexing, cam: Cam) -> None:
    """The tip of the lobe and the limits by name."""
    end, (_, pressure, polar, _) = cam.handover, panels
    k = np.linspace(0.0, 1.0, DENSE)
    labels = Labels(pressure)
    for name in ("A", "B"):
        labels.avoid(k + 1j * np.degrees(Flank(drive, name).pressure(k)))
    labels.avoid([complex(0.0, degrees(result.limit)), complex(1.0, degrees(result.limit))])
    for at in (complex(end.part, degrees(end.angle)), complex(0.0, degrees(result.start_pressure))):
        pressure.plot(at.real, at.imag, "D", markersize=3.6, markerfacecolor="white", color=MARK, zorder=6)
        labels.put(f"{signed(at.imag, 4)}°", [at], size=7, prefer=1 + 1j)
    labels.put("$\\pm\\theta_\\mathrm{d}$", [complex(0.04, degrees(result.limit))], size=8, prefer=1j, color=MARK)
    labels = Labels(polar)
    ahead = -np.degrees(Flank(drive, "A").polar(k) - drive.step * k) - degrees(drive.step)
    for values in (ahead, -degrees(drive.step) - ahead):
        labels.avoid(k + 1j * values)
    tip = complex(end.part, -degrees(drive.step) / 2)
    polar.plot(tip.real, tip.imag, "D", markersize=3.6, markerfacecolor="white", color=MARK, zorder=6)
    labels.put(f"$k_\\mathrm{{m}}$ = {signed(end.part, 4)}", [tip], size=8, prefer=1 + 1j)
