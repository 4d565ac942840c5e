"""The picture of the synthesis: where the axis of the cam may stand, after figures 5.14 to 5.18 and 5.34."""

from __future__ import annotations

from tmmcalc.cams.pictures.face import draw_convexity
from tmmcalc.cams.pictures.flatregion import draw_flat_region
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.phaseplane import plane_board
from tmmcalc.cams.pictures.rockers import rocker_board
from tmmcalc.cams.pictures.wording import deg, design_name, limit_name, mm
from tmmcalc.cams.pictures.zone import BASE, LIMIT, OTHER, PASSING, ZONE
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.polar import AROUND
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

MARGIN = 9.0  # mm of paper around the drawing
SYMBOLS = {"S0": "S_0", "e": "e", "R0": "R_0", "l0": "l_0", "l2": "l_2", "psi0": "ψ_0", "r2": "r_2"}


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return synthesis_drawing(cam_of(order), order.results["cam_synthesis"])


def synthesis_drawing(task: CamTask, result: Synthesis) -> Drawing:
    """One sheet: the drawing to one scale, beside it the sizes, the designs and the meaning of the lines."""
    drawing, box = titled(centre_heading(result), 3.2)
    if result.kind == "flat" and result.convexity is not None:
        left, right = box.split(1.0, 1.3, gap=4, across=True)
        board = draw_flat_region(drawing, left, task, result, result.convexity, MARGIN)
        under = left._replace(top=board.box.bottom - AROUND[1] - MARGIN)
        write_key(drawing, under, list(_parts(result, board.mu)))
        draw_convexity(drawing, right, task, result.convexity, result.follower)
        return drawing
    plane, key = box.split(2.4, 1.0, gap=5, across=True)
    board = draw_centre(drawing, plane, task, result)
    write_key(drawing, key, list(_parts(result, board.mu)))
    return drawing


def centre_heading(result: Synthesis) -> str:
    """What the drawing of the admissible places is called."""
    if result.kind == "translating":
        return tr("Admissible places of the cam's axis: diagram $S'$($ΔS$)")
    if result.kind == "oscillating":
        return tr("Admissible places of the cam's axis: positions of the rocker")
    return tr("Flat-faced follower: convexity of the profile and reach of the face")


def draw_centre(drawing: Drawing, box: Box, task: CamTask, result: Synthesis, *, to_scale: bool = False) -> Board:
    """The admissible places of the axis of a cam with a roller; ``to_scale``: at a standard scale of lengths."""
    make = rocker_board if result.kind == "oscillating" else plane_board
    return make(drawing, box, task, result, MARGIN, to_scale=to_scale)


def _parts(result: Synthesis, mu: float) -> list[Part]:
    sizes = []
    for size in result.sizes:
        sign = f"${SYMBOLS[size.symbol]}$"
        sizes.append((tr("{sign} (given)", sign=sign) if size.given else sign, _shown(size.symbol, size.value)))
    kinds = ("rise", tr("rise"), result.rise), ("return", tr("return"), result.back)
    phases = [(word, on) for _, word, on in kinds if on is not None]
    limits = [
        (f"{limit_name(kind)}, {word}", tr("not limited") if on.limit is None else deg(on.limit))
        for kind, word, on in kinds
        if on is not None
    ]
    reached = []
    for word, on in phases:
        angle, phi = deg(abs(on.worst.value)), deg(on.worst.phi, 4)
        text = tr("{angle} at $φ$ = {phi}", angle=angle, phi=phi)
        if on.limit is None:
            text = tr("{angle} at $φ$ = {phi} (not limited)", angle=angle, phi=phi)
        reached.append((_largest(word), text))
    parts = [Part(tr("The cam taken"), [*sizes, *limits, *reached])]
    parts += [_design_part(result, design) for design in result.designs]
    step = f"{minus(number(1e3 * mu if result.kind == 'oscillating' else mu, 4))} {tr_unit('mm')}"
    return [*parts, Part(tr("Lines (1 mm of paper: {step})", step=step), samples=samples_of(result))]


def _largest(word: str) -> str:
    """The largest pressure angle of a phase."""
    return tr("$|θ|$ max, {phase}", phase=word)


def _design_part(result: Synthesis, design: Design) -> Part:
    sizes: dict[str, float] = {"S0": design.start, "e": result.follower.sense * design.offset + 0.0, "R0": design.base}
    if result.kind == "oscillating":
        sizes = {"l0": design.centres, "psi0": design.start, "R0": design.base}
    names = ", ".join(f"${SYMBOLS[name]}$" for name in sizes)
    ends = ((tr("rise"), design.rise, result.rise), (tr("return"), design.back, result.back))
    angles = []
    for word, own, on in ends:
        angle = deg(max(map(abs, own)))
        free = on is not None and on.limit is None
        angles.append((_largest(word), tr("{angle} (not limited)", angle=angle) if free else angle))
    return Part(
        design_name(design, result.follower.sense),
        [(names, ";  ".join(_shown(*size) for size in sizes.items())), *angles],
    )


def samples_of(result: Synthesis) -> list[Sample]:
    """What the lines of the drawing mean."""
    swings = result.kind == "oscillating"
    rise, back = CURVES[0]._replace(width=0.6), CURVES[2]._replace(width=0.6)
    if result.kind == "flat":
        return [
            Sample(tr("$ΔS$($S''$), rise"), rise),
            Sample(tr("$ΔS$($S''$), return"), back),
            Sample(tr("$ΔS + S'' = F_{min}$"), LIMIT),
            Sample(tr("admissible places of $O$"), ZONE),
        ]
    if swings:
        curves = [
            Sample(tr("ends of $l_2$$ψ'$ along the rocker, rise"), rise),
            Sample(tr("ends of $l_2$$ψ'$ along the rocker, return"), back),
        ]
    else:
        curves = [Sample(tr("$S'$($ΔS$), rise"), rise), Sample(tr("$S'$($ΔS$), return"), back)]
    samples = [
        *curves,
        Sample(tr("$θ$ at its limit"), LIMIT),
        Sample(tr("the same where others are nearer"), OTHER),
        Sample(tr("admissible places of $O$"), ZONE),
    ]
    if not swings:
        return samples
    passes = result.pivot is not None and not result.pivot.beside
    samples += [Sample(tr("the cam just passes the pivot"), PASSING)] if passes else []
    return [*samples, Sample(tr("base circle $R_0$"), BASE)]


def _shown(name: str, value: float) -> str:
    return deg(value, 6) if name == "psi0" else f"{mm(value, 6)} {tr_unit('mm')}"
