"""What stands on the sheet of gears: meshes, sliding, tables, teeth by points, the train with its plans, contours."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from tmmcalc.gears.chosen.motion import Moving, written
from tmmcalc.gears.details import trains_in_motion
from tmmcalc.gears.meshing.booktables import BookTables, book_tables
from tmmcalc.gears.meshing.contours import PairContour
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both, members
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.pictures.contourkey import write_key
from tmmcalc.gears.pictures.contourplane import draw_plane
from tmmcalc.gears.pictures.listing import list_rows
from tmmcalc.gears.pictures.mesh import draw_mesh
from tmmcalc.gears.pictures.motionplans import draw_motion
from tmmcalc.gears.pictures.pair import draw_whole
from tmmcalc.gears.pictures.pairtable import contact_values, draw_parameters, draw_quality
from tmmcalc.gears.pictures.placedpair import PlacedPair, placed_pair
from tmmcalc.gears.pictures.sketch import COLUMN
from tmmcalc.gears.pictures.slidingcurves import draw_course
from tmmcalc.gears.pictures.toothpoints import INTERVALS, draw_tooth_points
from tmmcalc.gears.pictures.words import pair_name, pair_title, train_name
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.piece import Piece

SHEET = "gears"
TOLD = 3.5  # height of the scales [mm]
KEY = 106.0  # width of the key of a contour [mm]
VALUES = 70.0  # width of the table beside the curves of sliding [mm]
HEAD = 8.0  # room of the scale over a mesh [mm]
BEYOND = 0.04  # of the curves of sliding beyond the outermost points, in parts of their distance


def train(order: Order) -> Iterator[Piece]:
    """The train that was chosen, in motion; without criteria the first set of every variant."""
    for _, found in trains_in_motion(order.spec, order.results, order.choice or 1):
        yield motion_piece(found)


def gearing(order: Order) -> Iterator[Piece]:
    """The train that is written out, in motion."""
    yield motion_piece(written(order.results["gearing"]))


def pair(order: Order) -> Iterator[Piece]:
    """Of every pair whose wheels have profiles the mesh, sliding, parameters, figures of quality."""
    for found in order.results["pair"].pairs:
        name = pair_title(found.task)
        if all(fault_of(member) is None for member in both(found)):
            yield mesh_of(found)
            yield sliding_of(found)
        table = partial(draw_parameters, found=found)
        yield Piece(SHEET, tr("Parameters of the pair {pair}", pair=name), table, (120, 150), (150, 240))
        quality = partial(draw_quality, found=found)
        yield Piece(SHEET, tr("Figures of quality {pair}", pair=name), quality, (140, 100), (180, 120))


def mesh_of(found: MeshPair) -> Piece:
    """The mesh of a pair whose wheels have profiles."""
    heading = tr("Mesh {pair}", pair=pair_title(found.task))
    return Piece(SHEET, heading, partial(draw_to_scale, found=found), (260, 190), (340, 250))


def sliding_of(found: MeshPair) -> Piece:
    """Sliding and pressure of such a pair along its line of action."""
    heading = tr("Specific sliding and specific pressure {pair}", pair=pair_title(found.task))
    return Piece(SHEET, heading, partial(_course, found=found), (230, 130), (300, 170))


def profile(order: Order) -> Iterator[Piece]:
    """Of every wheel that has a profile its tooth by the textbook's points."""
    for member in members(order.results["pair"]):
        tables = None if fault_of(member) is not None else book_tables(member, "tooth", INTERVALS)
        if tables is not None:
            yield tooth_of(tables)


def tooth_of(tables: BookTables) -> Piece:
    """The tooth of a wheel by the textbook's points."""
    heading = tr("Tooth of wheel {wheel} by points", wheel=plain(tables.member.name))
    return Piece(SHEET, heading, partial(draw_tooth_points, tables=tables), (200, 100), (260, 140))


def blocking(order: Order) -> Iterator[Piece]:
    """The contours of all pairs with the points that were chosen."""
    for found in order.results["blocking"].pairs:
        yield contour_of(found)


def contour_of(found: PairContour) -> Piece:
    """A contour with its lines and points."""
    heading = tr("Blocking contour {pair}", pair=plain(pair_name(found.name)))
    return Piece(SHEET, heading, partial(_contour, found=found), (290, 185), (310, 195))


def motion_piece(found: Moving) -> Piece:
    """A train in motion: its scheme, its plans of velocities and of speeds."""
    heading = tr("Gear train") if found.chosen is None else train_name(found.chosen.sets)
    return Piece(SHEET, heading, partial(draw_motion, found=found), (290, 160), (340, 200))


def draw_to_scale(drawing: Drawing, box: Box, found: MeshPair, told: float = TOLD) -> None:
    """The mesh of a pair whose wheels have profiles, with its scale in letters ``told`` mm high."""
    frame = box.inset(COLUMN, 0, COLUMN, HEAD)
    board = draw_mesh(drawing, frame, placed_pair(found))
    drawing.add(Words(complex(box.left, box.top), scale_text(board.mu), told, -1 + 1j))


def _course(drawing: Drawing, box: Box, found: MeshPair) -> None:
    """The curves over the whole line of action, at their right the values at its points and the pair, small."""
    placed = placed_pair(found)
    draw_curves(drawing, Box(box.left, box.bottom, box.right - VALUES - 6, box.top), placed)
    upper, lower = Box(box.right - VALUES, box.bottom, box.right, box.top).split(1.4, 1.0, gap=4)
    draw_whole(drawing, upper, placed)
    list_rows(drawing, lower, contact_values(placed), tuple(part * VALUES for part in (0.34, 0.56, 0.78, 1.0)))


def draw_curves(drawing: Drawing, box: Box, placed: PlacedPair) -> None:
    """Sliding and pressure over the whole line of action."""
    marks = [mark.at.real for mark in placed.marks if mark.rho >= 0]
    over = BEYOND * (max(marks) - min(marks))
    theta, pressure = Box(box.left + 18, box.bottom + 13, box.right, box.top - 17).split(1.3, 1.0, gap=8)
    draw_course(drawing, (theta, pressure), placed, (min(marks) - over, max(marks) + over))


def _contour(drawing: Drawing, box: Box, found: PairContour) -> None:
    key = min(KEY, 0.45 * box.width)
    seen = draw_plane(drawing, box.inset(0, 0, key + 6, 2), found)
    write_key(drawing, Box(box.right - key, box.bottom, box.right, box.top), found, seen)
