"""What stands on the sheet of the cam: each picture with its heading and the room that it needs."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.laws.graphical import constructed
from tmmcalc.cams.pictures.cam_pressure import draw_angle
from tmmcalc.cams.pictures.cam_profile import draw_cam
from tmmcalc.cams.pictures.cam_synthesis import MARGIN, centre_heading, draw_centre, samples_of
from tmmcalc.cams.pictures.curvature import draw_bends, names_of
from tmmcalc.cams.pictures.face import draw_convexity
from tmmcalc.cams.pictures.flatregion import draw_flat_region
from tmmcalc.cams.pictures.indexing import draw_drive
from tmmcalc.cams.pictures.indexingstep import draw_step
from tmmcalc.cams.pictures.integration import INTERVALS, draw_integration, integration_heading
from tmmcalc.cams.pictures.lawdiagrams import draw_laws
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.toscale import FACTORS, write_factors
from tmmcalc.cams.pictures.wording import sense_of
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import SIDES, stacked
from tmmcalc.report.drawing.diagram import key_rows
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.polar import AROUND
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.piece import Piece

SHEET = "cam"
NAMES = (1.0, 3.0, 0.0, 0.0)  # room that names of axes take beside diagrams, all around [mm]
# diagrams over the turn have a degree to a mm from 381 mm on: what they like makes columns of A1 that wide [mm]
LEAST, WIDE, BROAD = 205.0, 420.0, 476.0
FOOT = 13.0  # room of what the lines of a drawing to scale are [mm]


def law_pieces(order: Order) -> Iterator[Piece]:
    """Diagrams of the law and its derivatives, and their graphical integration."""
    task, result = cam_of(order), order.results["cam_law"]

    def laws(drawing: Drawing, box: Box) -> None:
        draw_laws(drawing, box.inset(*NAMES), task.program, result, (2, 1, 0), to_scale=True)

    def integration(drawing: Drawing, box: Box) -> None:
        draw_integration(drawing, box, task.program, result, constructed(task.program, INTERVALS))

    yield Piece(SHEET, _law_heading(result), laws, (LEAST, 140.0), (WIDE, 220.0))
    yield Piece(SHEET, integration_heading(result), integration, (250.0, 170.0), (252.0, 215.0))


def _law_heading(result: LawResult) -> str:
    if result.turns:
        return tr("Diagrams of $ψ''$, $ψ'$ and $Δψ$")
    return tr("Diagrams of $S''$, $S'$ and $ΔS$")


def synthesis_pieces(order: Order) -> Iterator[Piece]:
    """The admissible places of the cam's axis."""
    task, result = cam_of(order), order.results["cam_synthesis"]

    def centre(drawing: Drawing, box: Box) -> None:
        _centre(drawing, box, task, result)

    if result.kind == "flat":
        yield Piece(SHEET, tr("Admissible places of the cam's axis: diagram $ΔS$($S''$)"), centre, (110.0, 90.0),
                    (200.0, 150.0))  # fmt: skip

        def convexity(drawing: Drawing, box: Box) -> None:
            draw_convexity(drawing, box.inset(*NAMES), task, result.convexity, result.follower)

        yield Piece(SHEET, centre_heading(result), convexity, (140.0, 130.0), (280.0, 160.0))
    else:
        yield Piece(SHEET, centre_heading(result), centre, (140.0, 130.0), (160.0, 200.0))


def _centre(drawing: Drawing, box: Box, task: CamTask, result: Synthesis) -> None:
    """The drawing to a standard scale, under it the scale and what the lines are."""
    inner = box.inset(0, FOOT, 0, 2.0)
    if result.kind == "flat" and result.convexity is not None:
        board = draw_flat_region(drawing, inner, task, result, result.convexity, MARGIN)
    else:
        board = draw_centre(drawing, inner, task, result, to_scale=True)
    metres = board.mu if result.kind == "oscillating" else board.mu / 1e3
    top = board.box.bottom - (0.0 if result.kind == "oscillating" else AROUND[1])
    foot = Box(box.left, top - FOOT, box.right, top - 1.0)
    drawing.add(Words(complex(box.middle.real, foot.top), scale_text(metres), 2.5, 1j))
    lines = [(sample.text, sample.line) for sample in samples_of(result) if not isinstance(sample.line, str)]
    samples_in_rows(drawing, foot.inset(0, 0, 0, 4.5), lines, 2.0)


def profile_pieces(order: Order) -> Iterator[Piece]:
    """The cam with its dimensions, and the curvature over the turn."""
    task, result = cam_of(order), order.results["cam_profile"]

    def cam(drawing: Drawing, box: Box) -> None:
        draw_cam(drawing, box, task, result, to_scale=True)

    def bends(drawing: Drawing, box: Box) -> None:
        _bends(drawing, box, task, result)

    heading = tr("Profile of the cam, which turns {sense}", sense=sense_of(result.follower))
    yield Piece(SHEET, heading, cam, (140.0, 120.0), (420.0, 315.0))
    if not result.flat:
        yield Piece(SHEET, tr("Curvature of the cam"), bends, (LEAST, 70.0), (BROAD, 80.0))


def _bends(drawing: Drawing, box: Box, task: CamTask, result: Profile) -> None:
    box = box.inset(*NAMES)
    rows = len(key_rows(names_of(task, result), box.width - SIDES[0] - SIDES[2]))
    (frame,) = stacked(box.inset(0, 0, 0, FACTORS), [rows])
    diagram = draw_bends(drawing, frame, task, Rim(result.follower, task.program), result, to_scale=True)
    write_factors(drawing, box, [diagram], [("κ", "1/mm")])


def pressure_pieces(order: Order) -> Iterator[Piece]:
    """The pressure angle over the turn; under a flat face there is none."""
    task, result = cam_of(order), order.results["cam_pressure"]

    def pressure(drawing: Drawing, box: Box) -> None:
        inner = box.inset(*NAMES)
        (frame,) = stacked(inner.inset(0, 0, 0, FACTORS), [0])
        diagram = draw_angle(drawing, frame, task, result, to_scale=True)
        write_factors(drawing, inner, [diagram], [("θ", "°")])

    if result.follower.kind != "flat":
        heading = tr("Pressure angle over a turn of the cam")
        yield Piece(SHEET, heading, pressure, (LEAST, 65.0), (BROAD, 90.0))


def indexing_pieces(order: Order) -> Iterator[Piece]:
    """The indexing drive to scale, and its motion, pressure angles and efficiency over a step."""
    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    task, result = to_indexing(order.spec), order.results["indexing"]
    drive = drive_of(task, result.ratio)
    if drive is None or result.cam is None:
        return

    def scheme(drawing: Drawing, box: Box) -> None:
        draw_drive(drawing, box, task, result, 0.0, to_scale=True)

    def step(drawing: Drawing, box: Box) -> None:
        draw_step(drawing, box.inset(*NAMES), drive, result, result.cam)

    yield Piece(SHEET, tr("Indexing drive at the start of a step"), scheme, (200.0, 120.0), (420.0, 250.0))
    yield Piece(SHEET, tr("One step of the wheel"), step, (200.0, 130.0), (330.0, 230.0))
