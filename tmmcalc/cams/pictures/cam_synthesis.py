"""The picture of the synthesis: where the axis of the cam may stand, after figures 5.14 to 5.18 and 5.34."""

from __future__ import annotations

from math import degrees

from tmmcalc.cams.pictures.face import draw_convexity
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.phaseplane import content_of as plane_content
from tmmcalc.cams.pictures.phaseplane import draw_plane
from tmmcalc.cams.pictures.rockers import content_of as rocker_content
from tmmcalc.cams.pictures.rockers import draw_rockers
from tmmcalc.cams.pictures.zone import BASE, LIMIT, OTHER, PASSING, ZONE
from tmmcalc.cams.pressure.angle import Reached
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.polar import AROUND
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.numbers import angle, number

MARGIN = 9.0  # mm of paper around the drawing
SYMBOLS = {"S0": "S_0", "e": "e", "R0": "R_0", "l0": "l_0", "l2": "l_2", "psi0": "ψ_0", "r2": "r_2"}
HEADINGS = {
    "translating": "Admissible places of the cam's axis: diagram $S'$($ΔS$)",
    "oscillating": "Admissible places of the cam's axis: positions of the rocker",
    "flat": "Flat-faced follower: convexity of the profile and reach of the face",
}


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return synthesis_drawing(cam_of(order), order.results["cam_synthesis"])


def synthesis_drawing(task: CamTask, result: Synthesis) -> Drawing:
    """One sheet: the drawing to one scale, beside it the sizes, the designs and the meaning of the lines."""
    drawing, box = titled(HEADINGS[result.kind], 3.2)
    if result.kind == "flat" and result.convexity is not None:
        draw_convexity(drawing, box, task, result.convexity, result.follower)
        return drawing
    plane, key = box.split(2.4, 1.0, gap=5, across=True)
    if result.kind == "oscillating":
        board = Board(drawing, plane, rocker_content(task, result), MARGIN)
        draw_rockers(board, task, result)
    else:
        left, bottom, right = AROUND
        board = Board(drawing, plane.inset(left, bottom, right, 0), plane_content(task, result), MARGIN)
        draw_plane(board, task, result)
    write_key(drawing, key, list(_parts(result, board.mu)))
    return drawing


def _parts(result: Synthesis, mu: float) -> list[Part]:
    sizes = [
        (f"${SYMBOLS[size.symbol]}${' (given)' if size.given else ''}", _shown(size.symbol, size.value))
        for size in result.sizes
    ]
    limits = [
        (
            f"[$θ$], {word}",
            "not limited" if on.limit is None else f"{minus(number(float(angle(degrees(on.limit))), 5))}°",
        )
        for word, on in (("rise", result.rise), ("return", result.back))
        if on is not None
    ]
    reached = [
        (
            f"$|θ|$ max, {word}",
            f"{minus(number(degrees(abs(on.worst.value)), 5))}° at $φ$ = {minus(number(degrees(on.worst.phi), 4))}°"
            f"{_unlimited(on)}",
        )
        for word, on in (("rise", result.rise), ("return", result.back))
        if on is not None
    ]
    parts = [Part("The cam taken", [*sizes, *limits, *reached])]
    parts += [_design_part(result, design) for design in result.designs]
    scale = f"1 mm of paper: {minus(number(mu if result.kind == 'translating' else 1e3 * mu, 4))} mm"
    return [*parts, Part(f"Lines ({scale})", samples=_samples(result))]


def _design_part(result: Synthesis, design: Design) -> Part:
    sizes: dict[str, float] = {"S0": design.start, "e": result.follower.sense * design.offset + 0.0, "R0": design.base}
    if result.kind == "oscillating":
        sizes = {"l0": design.centres, "psi0": design.start, "R0": design.base}
    names = ", ".join(f"${SYMBOLS[name]}$" for name in sizes)
    ends = (("rise", design.rise, result.rise), ("return", design.back, result.back))
    angles = [
        (f"$|θ|$ max, {word}", f"{minus(number(degrees(max(map(abs, own))), 5))}°{_unlimited(on)}")
        for word, own, on in ends
    ]
    return Part(
        design.name[:1].upper() + design.name[1:],
        [
            (names, ";  ".join(_shown(name, value) for name, value in sizes.items())),
            *angles,
        ],
    )


def _unlimited(on: Reached | None) -> str:
    return " (not limited)" if on is not None and on.limit is None else ""


def _samples(result: Synthesis) -> list[Sample]:
    swings = result.kind == "oscillating"
    what = "ends of $l_2$$ψ'$ along the rocker" if swings else "$S'$($ΔS$)"
    samples = [
        Sample(f"{what}, rise", CURVES[0]._replace(width=0.6)),
        Sample(f"{what}, return", CURVES[2]._replace(width=0.6)),
        Sample("$θ$ at its limit", LIMIT),
        Sample("the same where others are nearer", OTHER),
        Sample("admissible places of $O$", ZONE),
    ]
    if not swings:
        return samples
    passes = result.pivot is not None and not result.pivot.beside
    samples += [Sample("the cam just passes the pivot", PASSING)] if passes else []
    return [*samples, Sample("base circle $R_0$", BASE)]


def _shown(name: str, value: float) -> str:
    return (
        f"{minus(number(float(angle(degrees(value))), 6))}°"
        if name == "psi0"
        else f"{minus(number(1e3 * value, 6))} mm"
    )
