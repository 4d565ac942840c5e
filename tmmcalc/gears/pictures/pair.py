"""The sheets of a pair: the mesh to scale with its parameters, sliding and pressure under it, the whole pair."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.pictures.listing import list_rows
from tmmcalc.gears.pictures.mesh import draw_mesh
from tmmcalc.gears.pictures.pairtable import contact_values, parameters
from tmmcalc.gears.pictures.placedpair import Body, PlacedPair, placed_pair
from tmmcalc.gears.pictures.sketch import ACTION, CENTRES, COLOURS, FACES, STYLES
from tmmcalc.gears.pictures.slidingcurves import draw_course
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import PHASE, Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import number

LEFT, WIDTH = 0.052, 0.668  # of the mesh, in parts of the sheet
BESIDE = (0.735, 0.25)  # of the table
AROUND = np.exp(2j * np.pi * np.linspace(0, 1, 241))
LEAST = 5.0  # radius on paper of a wheel whose rotation is shown [mm]


def chosen(found: Pairs, choose: int | None) -> tuple[MeshPair, ...]:
    """All pairs, or the one of this number, from 1; raises `UsageError` if there is none."""
    if choose is None:
        return found.pairs
    if not 1 <= choose <= len(found.pairs):
        raise UsageError(
            f"there is no pair {choose}",
            where="plot",
            value=choose,
            limit=len(found.pairs),
            remedy=f"1 to {len(found.pairs)}",
        )
    return (found.pairs[choose - 1],)


def figure(order: Order) -> Figure:
    """The figure of the stage, of the pair that is chosen, in a phase of its mesh."""
    return pair_figure(order.results["pair"], choose=order.choice, phase=order.angle(PHASE))


def pair_figure(found: Pairs, *, choose: int | None = None, phase: float = 0.0) -> Figure:
    """Two sheets a pair; the first wheel has turned clockwise by ``phase`` [rad] since the contact at P.

    ``choose`` is the number of a pair, from 1; None: all. A pair with a wheel that has no profile has one sheet, which
    tells why. Raises `UsageError` for a pair that there is not, `NoSolutionError` if no other pair can be drawn.
    """
    faulty, sound = list[tuple[MeshPair, list[NoSolutionError]]](), list[PlacedPair]()
    for one in chosen(found, choose):
        errors = [error for member in both(one) if (error := fault_of(member)) is not None]
        if errors:
            faulty.append((one, errors))
        else:
            sound.append(placed_pair(one, phase))
    if not sound:
        every = [error for _, errors in faulty for error in errors]
        raise error_of_all(every, 2 * len(faulty))
    figure, sheets = blank(2 * len(sound) + len(faulty))
    finish = [_sheets(sheets[2 * k], sheets[2 * k + 1], pair) for k, pair in enumerate(sound)]
    for sheet, (one, errors) in zip(sheets[2 * len(sound) :], faulty, strict=True):
        tell(sheet, f"Mesh {one.task.title} cannot be drawn", errors)
    settle(figure)
    for draw in finish:
        draw()
    return figure


def tell(sheet: SubFigure, heading: str, errors: Sequence[NoSolutionError]) -> None:
    """A sheet in place of a drawing, with the reasons why there is none."""
    sheet.text(LEFT, 0.965, heading, size=10)
    lines = [f"{error.where}: {error.message}; remedy: {error.remedy}" for error in errors]
    sheet.text(LEFT, 0.925, "\n".join(lines), size=8, va="top", parse_math=False)


def _sheets(first: SubFigure, second: SubFigure, pair: PlacedPair) -> Callable[[], None]:
    """Lay both sheets of a pair out; what is returned draws."""
    mesh = first.add_axes((LEFT, 0.02, WIDTH, 0.905))
    table = first.add_axes((BESIDE[0], 0.04, BESIDE[1], 0.875))
    upper = second.add_axes((LEFT, 0.47, WIDTH, 0.41))
    lower = second.add_axes((LEFT, 0.09, WIDTH, 0.34))
    whole = second.add_axes((BESIDE[0], 0.42, BESIDE[1], 0.5))
    values = second.add_axes((BESIDE[0], 0.06, BESIDE[1], 0.33))

    def finish() -> None:
        board = draw_mesh(mesh, pair)
        _head(first, pair, board.mu)
        list_rows(table, parameters(pair.found), (57.0, 74.0))
        draw_course(upper, lower, pair, mesh.get_xlim())
        second.text(LEFT, 0.965, "Specific sliding and specific pressure along the line of action", size=10)
        _draw_whole(whole, pair)
        list_rows(values, contact_values(pair), (26.0, 42.0, 58.0, 74.0))

    return finish


def _head(sheet: SubFigure, pair: PlacedPair, mu: float) -> None:
    found = pair.found
    turned = f", turned by {signed(math.degrees(pair.phase), 4)}° since the contact at $P$" if pair.phase else ""
    title, section = found.task.title, "transverse section; " if found.task.helix else ""
    sheet.text(LEFT, 0.965, f"Mesh of {title}{turned}" if not found.task.name else f"Mesh {title}{turned}", size=10)
    sheet.text(LEFT + WIDTH, 0.965, f"{section}{scale(mu)}; lengths in mm", size=8, ha="right")


def scale(mu: float) -> str:
    """The scale on paper, ``mu`` in metres to a millimetre.

    >>> scale(0.0005), scale(0.002)
    ('$\\\\mu_l$ = 0.0005 m/mm (2:1)', '$\\\\mu_l$ = 0.002 m/mm (1:2)')
    """
    part = f"1:{number(1e3 * mu, 3)}" if mu > 1e-3 * (1 + 1e-9) else f"{number(1e-3 / mu, 3)}:1"
    return f"$\\mu_l$ = {np.format_float_positional(mu, 3, fractional=False, trim='-')} m/mm ({part})"


def _draw_whole(axes: Axes, pair: PlacedPair) -> None:
    """The whole pair, small."""
    axes.set_axis_off()
    content = np.concatenate([body.whole for body in pair.bodies])
    board = Board(axes, content, 3.0)
    for body in pair.bodies[::-1]:
        _draw_wheel(board, body)
    at = np.array([body.centre for body in pair.bodies if body.sizes is not None])
    over = 4 * board.mu * 1j
    ends = np.concatenate([at, [pair.pitch_point]])
    low, high = ends.imag.min() * 1j, ends.imag.max() * 1j
    board.line([low - over, high + over], weight=0.3, **CENTRES)
    line = pair.found.line
    board.line(pair.on_line(np.array([min(0.0, line.length), max(line.end, line.length)])), linewidth=0.6, zorder=9)
    board.line(pair.on_line(np.array([line.begins, line.ends])), linewidth=1.8, color=ACTION, zorder=10)
    for body in pair.bodies:
        if body.sizes is not None:
            board.circle(body.centre, 0.6, zorder=11)
            board.labels.put(f"$O_{body.number}$", [body.centre], size=8, prefer=-1 + 0j, gaps=(1.4, 2.2, 3.4))
            _arrow(board, body)
    board.labels.put("$P$", [pair.pitch_point], size=8, gaps=(1.6, 2.6, 4.0))
    axes.text(1.0, -0.01, scale(board.mu), transform=axes.transAxes, ha="right", va="top", size=7.5)


def _draw_wheel(board: Board, body: Body) -> None:
    look: dict[str, Any] = {"facecolor": FACES[body.number - 1], "edgecolor": INK, "linewidth": 0.5, "zorder": 3}
    sizes = body.sizes
    if sizes is None:
        board.area(np.concatenate([body.edge, body.back[::-1]]), weight=0.3, **look)
        return
    if body.kind == "ring":
        rim = abs(body.back[0] - body.centre)
        board.area(body.centre + rim * AROUND, weight=0.1, **look)
        board.area(body.whole, weight=0.1, **{**look, "facecolor": "white"})
    else:
        board.area(body.whole, weight=0.1, **look)
    circle = body.centre + sizes.operating * AROUND
    board.line(circle, color=COLOURS[body.number - 1], zorder=5, weight=0.2, **STYLES["operating"])


def _arrow(board: Board, body: Body) -> None:
    """The sense of rotation while the first wheel drives."""
    if body.sizes is None or body.sizes.root < LEAST * board.mu:
        return
    sense = 1 if body.number == 1 or body.kind == "ring" else -1
    radius = (0.45 if body.kind == "external" else 0.8) * body.sizes.root
    arc = body.centre + radius * np.exp(1j * (math.radians(200) + sense * np.linspace(0, math.radians(50), 21)))
    color = COLOURS[body.number - 1]
    board.line(arc, color=color, linewidth=1.2, zorder=9, weight=0.5)
    board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-2]), 2.4, facecolor=color)
    board.labels.put(f"$\\omega_{body.number}$", [complex(arc[10])], size=8, color=color)
