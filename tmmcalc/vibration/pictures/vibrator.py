"""The picture of the vibratory device: modes, resonance curve, starts, paths of the part's points in space."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import HEIGHT, key_above
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.pens import AXIS, CURVES, GRID, MARK, MIDDLE, THIN
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.vibration.pictures.sheets import sheets_of
from tmmcalc.vibration.vibrator.results import Curve, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.task import COORDINATES, UNITS

SHIFTS = [k for k, unit in enumerate(UNITS) if unit == "m"]
TURNS = [k for k, unit in enumerate(UNITS) if unit == "rad"]
NAMES = ("x", "y", "φ", "θ_x", "θ_y", "z", "γ")
LOWEST = 1e-4  # of the largest amplitude that is drawn
RPM = 30 / np.pi
ENLARGED = 0.35  # of the part's size: how large the widest path is drawn
ABOVE = np.array([1.0, 1j, 0.0])  # directions on paper of x, y, z: seen from above,
ASLANT = np.array([np.exp(-1j * np.pi / 12), 0.55 * np.exp(1j * np.pi / 5), 1j])  # and aslant
MARGIN = 9.0  # free border of the paths [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return vibrator_drawing(order.results["vibrator"])


def vibrator_drawing(result: VibratorResult) -> Drawing:
    """A sheet each of modes, resonance curve, starts and paths, as far as there are results."""
    return sheets_of([(piece.heading, piece.draw) for piece in pieces_of(result).values()])


def pieces_of(result: VibratorResult) -> dict[str, Piece]:
    """Modes, resonance curve, starts and paths, as far as there are results."""
    found = {"modes": _piece(tr("Natural modes"), partial(_modes, result=result), 110.0)}
    if result.curve is not None:
        drawn = partial(_curve, result=result, curve=result.curve)
        found["curve"] = _piece(tr("Resonance curve"), drawn, 130.0)
    if result.run_up is not None:
        drawn = partial(_start, result=result, start=result.run_up)
        found["start"] = _piece(tr("Start with a given angle of the rotor"), drawn, 150.0)
    if result.drive is not None:
        drawn = partial(_start, result=result, start=result.drive)
        found["drive"] = _piece(tr("Start by the motor"), drawn, 150.0)
    if result.paths:
        found["paths"] = _piece(
            tr("Paths of points of the part in steady motion"), partial(_paths, result=result), 95.0
        )
    return found


def _piece(heading: str, draw: Callable[[Drawing, Box], None], high: float) -> Piece:
    return Piece("linkage", heading, draw, (150.0, 80.0), (160.0, high))


def _modes(drawing: Drawing, box: Box, result: VibratorResult) -> None:
    """Bars of the shapes, turns by what they move at the rods' radius against the largest displacement."""
    arm = 1 / float(np.max(np.abs(result.shapes[TURNS]))) if np.any(result.shapes[TURNS]) else 1.0
    weights = np.array([1.0 if unit == "m" else arm for unit in UNITS])
    places = [part for row in box.split(1, 1, gap=4) for part in row.split(1, 1, 1, 1, gap=4, across=True)]
    for k, part in enumerate(places[: len(COORDINATES)]):
        hertz = float(result.frequency[k]) / (2 * np.pi)
        title = tr("{k}: {hertz} Hz, {rpm} rpm", k=k + 1, hertz=number(hertz, 5), rpm=number(60 * hertz, 5))
        drawing.add(Words(complex(part.middle.real, part.top), title, 2.2, 1j))
        _bars(drawing, part.inset(2, 8, 2, 7), result.shapes[:, k] * weights)


def _bars(drawing: Drawing, frame: Box, values: Values) -> None:
    pitch, unit = frame.width / len(values), frame.height / 2.3
    zero = frame.middle.imag
    for level in (-1.0, 0.0, 1.0):
        y = zero + level * unit
        drawing.line([complex(frame.left, y), complex(frame.right, y)], GRID if level else MIDDLE, level=1)
    for k, value in enumerate(values.tolist()):
        x, half = frame.left + (k + 0.5) * pitch, 0.3 * pitch
        corners = np.array(
            [complex(x + s * half, zero + h * unit) for s, h in ((-1, 0), (1, 0), (1, value), (-1, value))]
        )
        drawing.add(Area(corners, CURVES[0 if UNITS[k] == "m" else 1].colour))
        drawing.add(Words(complex(x, frame.bottom - 1.5), f"${NAMES[k]}$", HEIGHT, 1j))


def _curve(drawing: Drawing, box: Box, result: VibratorResult, curve: Curve) -> None:
    rows = []
    shifts, turns = (SHIFTS, 1e3, tr("amplitude, mm"), 0), (TURNS, 180 / np.pi, tr("amplitude, °"), 3)
    for of, factor, label, first in (shifts, turns):
        lines = tuple((f"${NAMES[k]}$", factor * curve.amplitude[k]) for k in of if np.any(curve.amplitude[k] > 0))
        if lines:
            top = max(float(np.max(values)) for _, values in lines)
            rows.append(Panel(label, lines, first, True, (LOWEST * top, 2 * top)))
    found = panels(drawing, box, curve.omega * RPM, tr("speed of the rotor, rpm"), rows)
    marked(found, (result.frequency * RPM).tolist())
    for field in found:
        if result.steady is not None:
            field.vertical(result.steady.speed * RPM, MARK)


def _start(drawing: Drawing, box: Box, result: VibratorResult, start: Start | MotorStart) -> None:
    course = start.course
    rows = [
        Panel(tr("speed, rpm"), ((tr("rotor"), course.omega * RPM),)),
        Panel(tr_unit("mm"), _moved(course.q, SHIFTS, 1e3)),
        Panel("°", _moved(course.q, TURNS, 180 / np.pi), 3),
    ]
    speed, *_ = panels(drawing, box, course.t, f"$t$, {tr_unit('s')}", rows)
    reached = float(np.max(course.omega)) * RPM
    for k, natural in enumerate((result.frequency * RPM).tolist(), 1):
        if natural < 1.15 * reached:
            speed.level(natural, AXIS)
            speed.name_level(natural, str(k), AXIS.colour)


def _moved(q: Values, rows: list[int], factor: float) -> tuple[tuple[str, Values], ...]:
    return tuple((f"${NAMES[k]}$", factor * q[k]) for k in rows)


def _paths(drawing: Drawing, box: Box, result: VibratorResult) -> None:
    """Aslant and from above, enlarged about the places at rest."""
    places = np.array([each.at for each in result.paths])
    size = float(np.max(np.ptp(places, axis=0))) if len(places) > 1 else float(np.max(np.abs(places)))
    widest = max(each.major for each in result.paths) or 1.0
    factor = ENLARGED * (size or 1.0) / widest
    names = [(each.name, CURVES[k % len(CURVES)]) for k, each in enumerate(result.paths)]
    enlarged = tr("paths {factor} times enlarged", factor=number(factor, 3))
    views = (enlarged, ASLANT), (tr("from above; a diamond is $ψ$ = 0"), ABOVE)
    for part, (title, directions) in zip(box.split(1, 1, gap=4, across=True), views, strict=True):
        flat = directions is ABOVE
        drawn = [(1e3 * (each.at + factor * each.path)) @ directions for each in result.paths]
        rest = [complex(1e3 * each.at @ directions) for each in result.paths]
        content = np.concatenate([*drawn, np.array(rest)])
        board = Board(drawing, part.inset(*AROUND, 12), content, MARGIN)
        drawing.add(Words(complex(part.middle.real, part.top), title, 2.5, 1j))
        if flat:
            name_axes(board, ("x", "y"), float(np.max(np.abs(content))) or 1.0, "mm")
        else:
            _triad(board)
        key_above(drawing, board.box, names)
        for path, at, (_, pen) in zip(drawn, rest, names, strict=True):
            board.line([*path, path[0]], pen, level=4)
            board.dot(at, 0.5, colour=pen.colour, level=5)
            start = board.place(complex(path[0]))
            corners = np.array([start + 0.9 * w for w in (-1j, 1, 1j, -1)])
            drawing.add(Area(corners, "#ffffff", pen._replace(width=0.25, dashes=())), level=6)


def _triad(board: Board) -> None:
    """The directions of x, y, z in the corner, and the frame."""
    box = board.box
    corners = [complex(box.left, box.bottom), complex(box.right, box.bottom)]
    board.drawing.line([*corners, complex(box.right, box.top), complex(box.left, box.top)], THIN, closed=True)
    origin = complex(box.left + 8, box.bottom + 8)
    for name, way in zip("xyz", ASLANT.tolist(), strict=True):
        board.drawing.vector(origin, origin + 9 * way, MIDDLE)
        board.drawing.add(Words(origin + 12 * way, f"${name}$", HEIGHT))
