"""What lambda and the step angle decide: the groove near lambda_min, pressure angles and k_m over both."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, pi
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from tmmcalc.cams.indexing.bounds import start_pressure
from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.handover import handover
from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.indexingstep import LIMIT, PLACE
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import number

POINTS = 33
BELOW = 0.88  # of lambda_min: a groove that crosses itself
DENSE = 601
LARGEST_STEP = 0.98 * pi


def draw_study(panels: list[Axes], task: IndexingTask, result: Indexing, drive: Drive) -> None:
    """The groove at three lambda; theta_1m, theta_2 and k_m over lambda and over the step."""
    _grooves(panels[0], result, drive)
    limits = result.bounds
    high = max(limits.ratio_max or 0.0, 1.05 * result.ratio, 1.2 * limits.ratio_min)
    ratios = np.linspace(limits.ratio_min, high, POINTS)
    _curves(panels[1], ratios, [drive_of(task, ratio) for ratio in ratios.tolist()], task)
    for ratio in (limits.ratio_max, result.ratio):
        if ratio is not None:
            panels[1].axvline(ratio, **(PLACE if ratio == result.ratio else LIMIT))
    panels[1].set_xlabel("$\\lambda = a/l_k$")
    low = limits.step_min or 0.0
    steps = np.linspace(low, max(min(limits.step_max or pi, LARGEST_STEP), 1.05 * low, 1.02 * result.step), POINTS)
    drives = [drive_of(replace(task, step=step), result.ratio) for step in steps.tolist()]
    _curves(panels[2], np.degrees(steps), drives, task)
    panels[2].axvline(degrees(result.step), **PLACE)
    panels[2].set_xlabel(f"$\\varphi_\\mathrm{{p}}$, °, at $\\lambda$ = {number(result.ratio, 5)}")


def _grooves(axes: Axes, result: Indexing, drive: Drive) -> None:
    """Pitch curves of the groove below lambda_min, at it, and of the drive, each turned upright."""
    k = np.linspace(0.0, 1.0, DENSE)
    for ratio, name, style in (
        (BELOW * result.bounds.ratio_min, f"{BELOW:g} $\\lambda_\\mathrm{{min}}$, a loop", CURVES[1]),
        (result.bounds.ratio_min, "$\\lambda_\\mathrm{min}$, a point", CURVES[2]),
        (result.ratio, f"$\\lambda$ = {number(result.ratio, 5)}", CURVES[0]),
    ):
        flank = Flank(replace(drive, centres=ratio * drive.wheel), "B")
        points = 1e3j * flank.roller(k) * np.exp(-1j * drive.step * (k - 0.5))
        axes.plot(points.real, points.imag, label=name, linewidth=1.3, **style)
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_xlabel("pitch curve of the groove, mm")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=1)


def _curves(axes: Axes, x: Values, drives: list[Drive | None], task: IndexingTask) -> None:
    found = [None if drive is None else handover(drive) for drive in drives]
    start = [0.0 if drive is None else degrees(start_pressure(drive.rollers, drive.ratio)) for drive in drives]
    angle = [np.nan if tip is None else degrees(tip.angle) for tip in found]
    part = [np.nan if tip is None else tip.part for tip in found]
    axes.plot(x, start, label="$\\vartheta_{1\\mathrm{m}}$, °", linewidth=1.4, **CURVES[0])
    axes.plot(x, angle, label="$\\vartheta_2(k_\\mathrm{m})$, °", linewidth=1.4, **CURVES[1])
    axes.axhline(degrees(task.limit), **LIMIT)
    axes.set_ylim(0.0, 90.0)
    axes.set_xlim(x[0], x[-1])
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    second = axes.twinx()
    style: dict[str, Any] = {"linewidth": 1.4, **CURVES[2]}
    second.plot(x, part, **style)
    second.set_ylim(0.5, 1.0)
    second.set_ylabel("$k_\\mathrm{m}$")
    axes.plot([], [], label="$k_\\mathrm{m}$, right", **style)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)


def name_study(panels: list[Axes], task: IndexingTask) -> None:
    """The limit of the pressure angle by name."""
    for axes in panels[1:]:
        low, high = axes.get_xlim()
        place = complex(low + 0.03 * (high - low), degrees(task.limit) + 1.5)
        axes.text(place.real, place.imag, "$\\theta_\\mathrm{d}$", fontsize=8, color=LIMIT["color"])
