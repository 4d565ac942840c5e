"""The scheme of an indexing drive where its cams have turned by an angle: both cams, the wheel and its two rows."""

from __future__ import annotations

from math import pi, tau

import numpy as np

from tmmcalc.cams.files.indexing import chain_of
from tmmcalc.cams.indexing.flanks import Drive
from tmmcalc.cams.indexing.outline import outline
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.indexing.second import rows_of
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.pictures.wording import deg, mm
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import Part, Sample
from tmmcalc.report.drawing.pens import AXIS, MARK, PATH, WHITE, Pen
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

CHORD = 1e-4  # of the wheel: tolerance of drawn curves
CENTRES = AXIS._replace(width=0.18, colour="#6b6b6b")
PITCH = Pen("PITCH_CURVE", 0.3, (5.0, 1.2, 0.9, 1.2), PATH.colour)
NEAR = Pen("FRONT_CAM", 0.7)
FAR = Pen("REAR_CAM", 0.4, (3.0, 1.0), "#7a7a7a")
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
    for points, pen, face in ((behind * rear, FAR, ""), (working, NEAR, BODY)):
        shape = turn * points
        if face:
            board.filled(shape, face)
        board.line([*shape, shape[0]], pen, weight=0.6, level=4)
    shape = turn * pitch
    board.line([*shape, shape[0]], PITCH, weight=0.3, level=3)
    around = np.exp(1j * np.linspace(0, tau, 121))
    board.line(drive.centres + drive.wheel * around, CENTRES, weight=0.2, level=2)
    board.line((0j, complex(drive.centres)), CENTRES, weight=0.3, level=2)
    first = result.roller or 0.0
    radii = first, first if result.second is None else result.second.roller
    for row, pen, face, radius in zip(rows_of(drive, rests, phase), (NEAR, FAR), (WHITE, ""), radii, strict=True):
        for place in row.tolist():
            arm = 0.8 * board.mu
            board.lines([(place - way * arm, place + way * arm) for way in (1, 1j)], pen._replace(width=0.2, dashes=()),
                        weight=0.5, level=7)  # fmt: skip
            disc = place + radius * around
            if face:
                board.filled(disc, face, level=4.5)
            board.line(disc, pen._replace(width=0.45), weight=0.4, level=6)
    _draw_shafts(board, drive, cam)


def _draw_shafts(board: Board, drive: Drive, cam: Cam) -> None:
    """The two shafts with their names and senses of rotation."""
    radius = min(0.6 * cam.nearest, 0.5 * drive.wheel)
    for at, name, sense in ((0j, "O_1", 1), (complex(drive.centres), "O_2", -1)):
        board.circle(at, 0.9, level=9)
        board.labels.put(f"${name}$", board.paper([at]), height=2.6, prefer=-1 - 1j)
        arc = at + radius * np.exp(1j * (0.6 * pi + sense * np.linspace(0.0, 0.7 * pi, 31)))
        board.line(arc[:-1], MARK._replace(width=0.4), weight=0.5, level=8)
        board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-3]), MARK)


def parts_of(result: Indexing, cam: Cam, scale: str) -> list[Part]:
    """The key beside the scheme; ``scale`` is that of the drawing."""
    limits, found = result.bounds, cam.efficiency
    most = tr("any") if limits.ratio_max is None else number(limits.ratio_max, 5)
    sizes = [
        ("$λ$", tr("{ratio} in {least} ... {most}", ratio=number(result.ratio, 5), least=number(limits.ratio_min, 5),
                   most=most)),
        (tr("$φ_p$, dwell"), "; ".join(map(deg, (result.step, *(result.dwells or (result.dwell,)))))),
        ("$β_m$", deg(tau / result.rollers)),
        ("$R_0$", f"{mm(result.base)} {tr_unit('mm')}"),
        ("$ϑ_{1m}$", deg(result.start_pressure)),
        (tr("$k_m$, working $k_w$"), f"{number(cam.handover.part, 4)}; {number(cam.working_part, 4)}"),
        ("$ϑ_2(k_m)$", deg(cam.handover.angle)),
        (tr("$ρ$, bottom of the groove"), f"{mm(cam.bottom, 4)} {tr_unit('mm')}"),
        (tr("mean $η$, load against"), number(found.mean_against, 3)),
        (tr("mean $η$, load along"), number(found.mean_aiding, 3)),
    ]  # fmt: skip
    samples = [
        Sample(tr("front cam and its row"), NEAR),
        Sample(tr("rear cam and its row"), FAR),
        Sample(tr("pitch curve of the front cam"), PITCH),
    ]
    return [Part(tr("The drive"), sizes), Part(tr("Lines ({scale})", scale=scale), samples=samples)]
