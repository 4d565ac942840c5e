"""The sheet of one train: side view and end view to one scale, and the table of its wheels."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures import endview, lengthwise, sideview
from tmmcalc.gears.pictures.endview import CENTRES, PITCH, TIPS, length_text
from tmmcalc.gears.pictures.placed import PlacedTrain
from tmmcalc.gears.pictures.words import counted
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.page import headed
from tmmcalc.report.drawing.pens import THIN, Pen
from tmmcalc.report.drawing.scales import fitting_scale, scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

MARGIN = 5.0  # free border of the views [mm]
APART = 0.34  # between the views, in parts of the height of the train
NAMED = 0.06  # room for the name at the left end of a shaft that lies across, in the same parts
TABLE = 52.0  # width of the table [mm]
NARROW, ABOVE, BELOW = 220.0, 4.0, 4.0  # width of a picture whose table stands under the views; free over and under it
FOOT = 6.0  # height of the row of samples under the views [mm]
ROW, HEIGHT = 6.2, 2.5  # of the table: from row to row, and of its letters [mm]
LINE, FACT = 5.0, 2.4  # the same of what is told below it
ALIKE = 1e-9  # relative: pressure angles that are one


def scheme_sheet(drawing: Drawing, box: Box, train: PlacedTrain, heading: str) -> Board:
    """Fill a sheet with a train under a heading; the board of the views."""
    return draw_scheme(drawing, headed(drawing, box, heading), train)


def draw_scheme(drawing: Drawing, free: Box, train: PlacedTrain) -> Board:
    """A train from two sides with the table of its wheels; the board of the views."""
    if free.width < NARROW:
        high = max((len(_facts(train)) + 0.7) * LINE, (len(train.wheels) + 1) * ROW) + ABOVE + BELOW
        views, lower = free.inset(0, high, 0, 0), Box(free.left, free.bottom, free.right, free.bottom + high)
        table, told = lower.inset(0, 0, free.width - TABLE, ABOVE), lower.inset(TABLE + 8, 0, 0, ABOVE)
        _tabulate(drawing, table, train)
    else:
        views, table = free.inset(0, 0, TABLE + 4, 0), Box(free.right - TABLE, free.bottom, free.right, free.top)
        told = Box(table.left, table.bottom, table.right, _tabulate(drawing, table, train))
    _tell(drawing, told, train)
    board = _views(drawing, views.inset(0, FOOT, 0, 0), train)
    foot = Box(views.left, views.bottom, views.right, views.bottom + FOOT - 2)
    samples_in_rows(drawing, foot, _samples(train))
    drawing.add(Words(complex(free.right, free.bottom), _scale(train, board.mu), HEIGHT, 1 - 1j))
    return board


def _views(drawing: Drawing, box: Box, train: PlacedTrain) -> Board:
    to, at, content = _arranged(train)
    # in modules there is no standard scale
    board = Board(drawing, box, content, MARGIN, fitting_scale(content, box, MARGIN) if train.known else 0.0)
    sideview.draw_side_view(board, train, to)
    endview.draw_end_view(board, train, at)
    _axis_line(board, train, to)
    endview.label_end_view(board, train, at)
    sideview.label_side_view(board, train, to)
    return board


def _arranged(train: PlacedTrain) -> tuple[sideview.To, complex, Plane]:
    """How the side view is put on the board, where the main axis of the end view stands, corners of all."""
    end, side = endview.extent(train), lengthwise.extent(train)
    apart = APART * train.height
    if train.scheme.branched:
        at = complex(side.real.max() - end.real.min() + apart)
        return complex, at, np.concatenate((side, at + end, [side.real.min() - NAMED * train.height]))
    # seen from above: the axis of the shafts runs down, below the end view
    at = 1j * (side.real.max() - end.imag.min() + apart)

    def turned(s: float, r: float) -> complex:
        return complex(r, side.real.max() - s + side.real.min())

    corners = np.array([turned(z.real, z.imag) for z in side.tolist()])
    return turned, at + 1j * (corners.imag.max() - side.real.max()), np.concatenate((corners, at + end))


def _axis_line(board: Board, train: PlacedTrain, to: sideview.To) -> None:
    """The main axis through the side view."""
    if train.scheme.branched:
        frame, over = lengthwise.frame_of(train), sideview.BEYOND * board.mu
        board.line((to(frame.left, 0.0) - over, to(frame.right, 0.0) + over), CENTRES, weight=0.2, level=2)


def _samples(train: PlacedTrain) -> list[tuple[str, Pen]]:
    found = []
    for plane in range(train.planes):
        names = ", ".join(w.name for w in train.wheels if w.planes[0] <= plane <= w.planes[1])
        found.append((tr("pitch circles {wheels}", wheels=names), PITCH[plane % len(PITCH)]))
    if train.scheme.branched:
        planets = [wheel for wheel in train.wheels if wheel.planet]
        found.append((tr("tips of planets"), TIPS[endview.plane_of(planets[0])]))
    return found


def _scale(train: PlacedTrain, mu: float) -> str:
    said = tr("1 mm of paper = {length} $m_1$", length=number(mu, 4))
    if train.known:
        said = scale_text(mu)
    return said if train.widths is not None else tr("{scale}; widths of wheels not to scale", scale=said)


def _tabulate(drawing: Drawing, box: Box, train: PlacedTrain) -> float:
    """The wheels in a table on top of a rectangle; where it ends."""
    unit, mm = 1e3 if train.known else 1.0, tr_unit("mm")
    named = (f"$m$, {mm}", f"$d$, {mm}") if train.known else ("$m/m_1$", "$d/m_1$")
    rows: list[Sequence[str]] = [(tr("wheel"), "$z$", *named, *((f"$b$, {mm}",) if train.widths is not None else ()))]
    for wheel in train.wheels:
        row = [wheel.name, str(wheel.teeth), number(unit * wheel.module, 4), number(unit * 2 * wheel.reference, 5)]
        rows.append(row if train.widths is None else [*row, number(1e3 * _width(train, wheel.name), 4)])
    widest = [max(width(row[k], HEIGHT) for row in rows) for k in range(len(rows[0]))]
    columns = box.split(*(each + 2.0 for each in widest), across=True)
    size = HEIGHT * min(1.0, (box.width - 2.2 * len(columns)) / sum(widest))
    for k, cells in enumerate(rows):
        y = box.top - k * ROW
        drawing.line([complex(box.left, y), complex(box.right, y)], THIN)
        for column, text in zip(columns, cells, strict=True):
            drawing.add(Words(complex(column.middle.real, y - ROW / 2), text, size))
    end = box.top - len(rows) * ROW
    drawing.line([complex(box.left, end), complex(box.right, end)], THIN)
    return end


def _tell(drawing: Drawing, box: Box, train: PlacedTrain) -> None:
    """What else is to be known, line by line."""
    for k, text in enumerate(_facts(train)):
        size = min(FACT, box.width / width(text))
        said = text.lstrip()
        left = box.left + width(text, size) - width(said, size)
        drawing.add(Words(complex(left, box.top - (k + 1.2) * LINE), said, size, -1))


def _width(train: PlacedTrain, name: str) -> float:
    widths = train.widths or ()
    stages = {mesh.stage for mesh in train.scheme.meshes if name in (mesh.first, mesh.second)}
    wheel = train.wheel(name)
    return widths[min(stages)] * (1 + wheel.planes[1] - wheel.planes[0])


def _facts(train: PlacedTrain) -> list[str]:
    found = []
    if train.scheme.branched:
        found.append(counted(train.scheme, train.planets))
    found += [tr("wheel {wheel} stands still", wheel=wheel.name) for wheel in train.wheels if wheel.fixed]
    for mesh, distance, angle in zip(train.scheme.meshes, train.distances, train.angles, strict=True):
        one, other = train.wheel(mesh.first).teeth, train.wheel(mesh.second).teeth
        length = length_text(train, distance)
        text = tr("mesh {first}–{second}: $a_w$ = {length}", first=mesh.first, second=mesh.second, length=length)
        if _raised(train):
            text += f", $α_w$ = {number(math.degrees(angle), 4)}°"
        shared = math.gcd(one, other)
        found += [text, f"     {tr('coprime') if shared == 1 else tr('common factor {factor}', factor=shared)}"]
    gap = train.gap
    if gap is not None:
        found.append(tr("gap of neighbours {length}", length=length_text(train, gap.size)))
    if _raised(train) and train.scheme.branched:
        found.append(tr("tips drawn without profile shift"))
    if train.estimated:
        found += [tr("modules not chosen yet, drawn with"), "$m_{k+1} = m_k u_k^{1/3}$ (4.4)"]
    elif not train.known:
        found.append(tr("lengths in modules of stage 1"))
    return found


def _raised(train: PlacedTrain) -> bool:
    """Whether the meshes differ in their pressure angle, or it is not that of the rack."""
    return max(train.angles) - min(train.angles) > ALIKE * max(train.angles)
