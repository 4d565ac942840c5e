"""The scheme of an indexing drive where its cams have turned by an angle: both cams, the wheel and its two rows."""

from __future__ import annotations

from math import degrees, pi, tau
from typing import Any

import numpy as np

from tmmcalc.cams.files.indexing import chain_of
from tmmcalc.cams.indexing.flanks import Drive
from tmmcalc.cams.indexing.outline import outline
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.indexing.second import rows_of
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.key import Part, Sample
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import INK, MARK
from tmmcalc.report.numbers import angle, number

CHORD = 1e-4  # of the wheel: tolerance of drawn curves
AXIS: dict[str, Any] = {"color": "#6b6b6b", "linewidth": 0.6, "linestyle": (0, (9, 2, 2, 2)), "zorder": 2}
PITCH: dict[str, Any] = {"color": "#0072b2", "linestyle": (0, (8, 2, 1.5, 2)), "linewidth": 0.8}
NEAR: dict[str, Any] = {"color": INK, "linestyle": "-", "linewidth": 1.8}
FAR: dict[str, Any] = {"color": "#7a7a7a", "linestyle": (0, (5, 1.5)), "linewidth": 1.2}
BODY = "#e6ebf0"


def content_of(drive: Drive, result: Indexing) -> Plane:
    """Corners that hold the cams in every position, and the wheel with its rollers."""
    cam = result.cam
    lobe = cam.handover.radius if cam is not None else result.base
    wheel = drive.wheel + (result.roller or 0.0)
    low, high = max(lobe, wheel), drive.centres + wheel
    return np.array([complex(-lobe, -low), complex(high, low)])


def draw_scheme(board: Board, task: IndexingTask, result: Indexing, cam: Cam, phase: float) -> None:
    """Both cams and rows; the cam behind and its row are dashed."""
    drive = drive_of(task, result.ratio)
    assert drive is not None
    turn, rests = np.exp(1j * phase), task.rests
    working, pitch, rear = (
        outline("", chain_of(task, result, which, of_second=second), CHORD * result.wheel).polygon
        for which, second in ((True, False), (False, False), (True, True))
    )
    behind = -1.0 if task.dwells is None else np.exp(-1j * (task.step + rests[0]))
    for points, style, face in ((behind * rear, FAR, "none"), (working, NEAR, BODY)):
        shape = turn * points
        board.axes.fill(shape.real, shape.imag, facecolor=face, edgecolor="none", zorder=0.5)
        board.line([*shape, shape[0]], zorder=4, weight=0.6, **style)
    shape = turn * pitch
    board.line([*shape, shape[0]], zorder=3, weight=0.3, **PITCH)
    around = np.exp(1j * np.linspace(0, tau, 121))
    board.line(drive.centres + drive.wheel * around, weight=0.2, **AXIS)
    board.line((0j, complex(drive.centres)), weight=0.3, **AXIS)
    first = result.roller or 0.0
    radii = first, first if result.second is None else result.second.roller
    for row, style, face, radius in zip(
        rows_of(drive, rests, phase), (NEAR, FAR), ("white", "none"), radii, strict=True
    ):
        for place in row.tolist():
            board.axes.plot(place.real, place.imag, "+", color=style["color"], markersize=4, zorder=7)
            disc = place + radius * around
            board.axes.fill(disc.real, disc.imag, facecolor=face, edgecolor="none", zorder=4.5)
            board.line(place + radius * around, zorder=6, weight=0.4, **{**style, "linewidth": 1.2})
    _draw_shafts(board, drive, cam)


def _draw_shafts(board: Board, drive: Drive, cam: Cam) -> None:
    """The two shafts with their names and senses of rotation."""
    radius = min(0.6 * cam.nearest, 0.5 * drive.wheel)
    for at, name, sense in ((0j, "O_1", 1), (complex(drive.centres), "O_2", -1)):
        board.circle(at, 0.9, zorder=9)
        board.labels.put(f"${name}$", [at], size=9, prefer=-1 - 1j)
        arc = at + radius * np.exp(1j * (0.6 * pi + sense * np.linspace(0.0, 0.7 * pi, 31)))
        board.line(arc[:-1], color=MARK, linewidth=1.2, zorder=8, weight=0.5)
        board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-3]), facecolor=MARK)


def parts_of(result: Indexing, cam: Cam, mu: float) -> list[Part]:
    """The key beside the scheme."""
    limits, found = result.bounds, cam.efficiency
    most = "any" if limits.ratio_max is None else number(limits.ratio_max, 5)
    sizes = [
        ("$\\lambda$", f"{number(result.ratio, 5)} in {number(limits.ratio_min, 5)} ... {most}"),
        ("$\\varphi_\\mathrm{p}$, dwell", ", ".join(map(_deg, (result.step, *(result.dwells or (result.dwell,)))))),
        ("$\\beta_\\mathrm{m}$", _deg(tau / result.rollers)),
        ("$R_0$", f"{number(1e3 * result.base, 5)} mm"),
        ("$\\vartheta_{1\\mathrm{m}}$", _deg(result.start_pressure)),
        ("$k_\\mathrm{m}$, working $k_\\mathrm{w}$", f"{number(cam.handover.part, 4)}, {number(cam.working_part, 4)}"),
        ("$\\vartheta_2(k_\\mathrm{m})$", _deg(cam.handover.angle)),
        ("$\\rho$, bottom of the groove", f"{signed(1e3 * cam.bottom, 4)} mm"),
        ("mean $\\eta$, load against", number(found.mean_against, 3)),
        ("mean $\\eta$, load along", number(found.mean_aiding, 3)),
    ]
    samples = [
        Sample("front cam and its row", NEAR),
        Sample("rear cam and its row", FAR),
        Sample("pitch curve of the front cam", PITCH),
    ]
    return [Part("The drive", sizes), Part(f"Lines (1 mm of paper: {signed(1e3 * mu, 4)} mm)", samples=samples)]


def _deg(value: float) -> str:
    return f"{signed(float(angle(degrees(value))), 5)}°"
