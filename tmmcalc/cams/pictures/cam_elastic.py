"""The picture of the elastic follower: accelerations and load over the turn, residual vibration of the laws."""

from __future__ import annotations

from math import degrees
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.separation import Contact
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.curves import bottom, frame
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK, THIN
from tmmcalc.report.numbers import number

TICKS = 25
WALL = "#e4e4e4"
LOWEST = 1e-4  # of the spectra's amplitude that is drawn, part of the stroke


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return elastic_figure(cam_of(order), order.results["cam_elastic"])


def elastic_figure(task: CamTask, result: ElasticResult) -> Figure:
    """Two sheets: the turn, and the spectra."""
    figure, (first, second) = blank(2)
    upper, lower = first.subplots(2, 1, sharex=True)
    multiple = number(result.multiple, 5)
    heading = f"Elastic follower, natural frequency {multiple} times that of the cam"
    first.suptitle(heading + _shaded(result.contact), fontsize=10)
    phi = np.degrees(result.phi)
    unit, force = ("rad/s²", "N·m") if result.turns else ("m/s²", "N")
    upper.plot(phi, result.given, linewidth=1.1, label="of the cam's law", **CURVES[1])
    upper.plot(phi, result.response, linewidth=1.3, label="of the mass", **CURVES[0])
    frame(upper, f"acceleration, {unit}", phi, True, TICKS)
    lower.plot(phi, result.rigid, linewidth=1.1, label="rigid train", **CURVES[1])
    lower.plot(phi, result.load, linewidth=1.3, label="elastic train", **CURVES[0])
    frame(lower, f"load along the lift $P_c$, {force}", phi, True, TICKS)
    low, high = lower.get_ylim()
    colour: dict[str, Any] = {"color": MARK, "alpha": 0.25} if result.contact.closure == "force" else {"color": WALL}
    for begin, end in result.contact.beyond if result.contact.judged else ():
        lower.axvspan(degrees(begin), degrees(end), zorder=0.5, linewidth=0, **colour)
    lower.set_ylim(low, max(high, 0.08 * (high - low)))
    for axes in (upper, lower):
        for start in np.degrees(task.program.starts[1:-1]).tolist():
            axes.axvline(start, color=THIN, linewidth=0.6, zorder=1)
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, handlelength=3, borderaxespad=0.3)
    bottom([upper, lower], True)
    second.suptitle("Residual vibration after a rise from rest", fontsize=10)
    _spectra(second.subplots(), result)
    settle(figure)
    return figure


def _shaded(contact: Contact) -> str:
    """What is shaded, as a second line of the heading."""
    if not contact.beyond or not contact.judged:
        return ""
    return "\nshaded: " + ("the follower leaves the cam" if contact.lost else "the outer wall of the groove presses")


def _spectra(axes: Axes, result: ElasticResult) -> None:
    """Amplitude over the stroke by the ratio of phase time and natural period; the cam's own ratio is marked."""
    for each, style in zip(result.spectra, CURVES, strict=False):
        axes.semilogy(result.ratios, each.residual, linewidth=1.4, label=each.law, zorder=4, **style)
    axes.set_ylim(LOWEST, 2.0)
    axes.set_xlim(0.0, float(result.ratios[-1]))
    for phase in result.phases:
        if phase.ratio < result.ratios[-1]:
            axes.axvline(phase.ratio, color=INK, linewidth=1.0, linestyle=(0, (6, 2)), zorder=3)
            axes.annotate(
                f"{phase.kind}: {number(phase.ratio, 4)}",
                (phase.ratio, 1.15 if phase.kind == "rise" else 0.8),
                xytext=(4, 0),
                textcoords="offset points",
                fontsize=7.5,
                va="center",
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
                zorder=5,
            )
    axes.grid(True, which="major", linewidth=0.35, color="#d0d0d0")
    axes.set_xlabel("time of the phase over the natural period")
    axes.set_ylabel("amplitude over the stroke")
    axes.legend(loc="upper right", ncols=2, handlelength=3.5, frameon=True, framealpha=0.9, edgecolor="none")
