"""The kinematic scheme of any train seen from the side, to scale: that of its layout, or one made from its meshes.

A member inside another one's hub is drawn as its shaft, the outer ones as sleeves around it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.chosen.motion import MODULE, Moving, modules_of
from tmmcalc.gears.gearingtask import ends
from tmmcalc.gears.network.model import FRAME
from tmmcalc.gears.network.places import places
from tmmcalc.gears.network.willis import wheel_names
from tmmcalc.gears.pictures import lengthwise, sideview
from tmmcalc.gears.pictures.endview import CENTRES, COLOURS
from tmmcalc.gears.pictures.memberplaces import (
    AXLES,
    EXIT,
    RIM,
    STEP,
    WIDE,
    Scheme,
    Wheel,
    arranged,
    exit_of,
    layers_of,
    web_of,
)
from tmmcalc.gears.pictures.placed import placed
from tmmcalc.gears.pictures.sideview import AXLE, CARRIER, FACE, SHAFT, SLEEVES, WHEELS
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.signs import hatched

HUB, BEARING = 3.0, (4.6, 0.9)  # half length of a hub; length of a bearing and its distance from the shaft [mm]
HELD = 3.2  # half length of the ground that holds the end of a shaft [mm]
MARGIN = 6.0  # of the scheme alone [mm]
LAYER = 1.5  # from a shaft to the sleeve around it [mm]
ON_SHAFT, ON_WHEEL, ON_CARRIER = 4, 5, 6


class SchemeView(NamedTuple):
    """What is drawn, as data: s along the axes + i height [m]."""

    content: Plane
    draw: Callable[[Board, float], None]  # to what part of their usual height letters are written


def view_of(found: Moving) -> SchemeView:
    """The scheme of a train in motion."""
    if found.chosen is not None:
        chosen = found.chosen
        driver = "1" if ends(found.task)[0] in ("1", None) else "H"
        module = np.array(modules_of(chosen))
        train = placed(chosen.sets, 0, module, rack=chosen.task.pressure_angle, driver=driver)

        def drawn(board: Board, part: float) -> None:
            sideview.draw_side_view(board, train, complex)
            axis = 0.0 if train.scheme.branched else train.wheels[0].axes[0].real
            extent = lengthwise.extent(train)
            board.line((complex(extent.real.min(), axis), complex(extent.real.max(), axis)), CENTRES, weight=0.2)
            sideview.label_side_view(board, train, complex, part)

        return SchemeView(lengthwise.extent(train), drawn)
    network = found.task.network
    at = places(network, None, found.task.locked, MODULE)
    held = tuple(name for name, speed in found.task.speeds.items() if not speed)
    scheme = arranged(network, at, held)
    return SchemeView(scheme.content, lambda board, part: _draw(board, scheme, part))


def draw_members(drawing: Drawing, box: Box, found: Moving) -> None:
    """The scheme alone, as large as the box lets it be."""
    view = view_of(found)
    view.draw(Board(drawing, box, view.content, MARGIN), 1.0)


def _draw(board: Board, scheme: Scheme, part: float) -> None:
    """Axes, shafts, wheels, carriers, then their names."""
    layers = layers_of(scheme)
    wide = scheme.content.real.min(), scheme.content.real.max()
    for height in sorted({scheme.height(name) for name in layers}):
        board.line([complex(s, height) for s in wide], CENTRES, weight=0.2, level=2)
    ends = {name: _shaft(board, scheme, name, layer) for name, layer in layers.items()}
    for carrier in scheme.arms:
        _carrier(board, scheme, carrier)
    # planets beside the line of centres stand behind those on it
    for wheel in sorted(scheme.wheels, key=lambda each: -abs(scheme.at.axes.get(each.member, 0j).imag)):
        _wheel(board, scheme, wheel)
    for name, end in ends.items():
        if end is not None:
            _name(board, name, end, part)
    _label(board, scheme, part)


def _wheel(board: Board, scheme: Scheme, wheel: Wheel) -> None:
    """A bar to the pitch circle; of a ring its rim and its web; of a bevel wheel a disc."""
    plane = scheme.span(wheel)[0] % len(WHEELS)
    start, end = scheme.along(wheel)
    axis, pen, fill = scheme.height(wheel.member), WHEELS[plane], FACE[plane]
    if wheel.tilt and scheme.network.tilted(wheel.member):
        own = wheel.radius
        middle = scheme.place(scheme.span(wheel)[0])
        thick = 0.3 * WIDE * scheme.unit / 2
        _bar(board, (middle - own, middle + own), (axis - thick, axis + thick), pen, fill)
        if scheme.network.bearer(wheel.member) == FRAME:
            end = axis + AXLES * scheme.unit
            board.line([complex(middle, axis), complex(middle, end)], SHAFT, level=ON_SHAFT)
            for side in (1, -1):
                x = middle + side * BEARING[1] * board.mu
                hatched(board, complex(x, end - BEARING[0] * board.mu), complex(x, end), complex(side))
        return
    if not wheel.ring:
        _bar(board, (start, end), (axis - wheel.radius, axis + wheel.radius), pen, fill)
        return
    rim = RIM * scheme.unit
    for side in (1, -1):
        edge = axis + side * (wheel.radius + rim)
        _bar(board, (start, end), (axis + side * wheel.radius, edge), pen, fill)
        if wheel.member == FRAME or wheel.member in scheme.held:
            hatched(board, complex(start, edge), complex(end, edge), side * 1j)
    if wheel.member != FRAME:
        at = web_of(scheme, wheel)
        near = end if at > end else start
        height = wheel.radius + rim / 2
        board.line([complex(near, axis + height), complex(at, axis + height)], SHAFT, level=ON_SHAFT)
        board.line([complex(near, axis - height), complex(at, axis - height)], SHAFT, level=ON_SHAFT)
        board.line([complex(at, axis + height), complex(at, axis - height)], SHAFT, level=ON_SHAFT)


def _bar(board: Board, s: tuple[float, float], y: tuple[float, float], pen: Pen, fill: str) -> None:
    corners = [complex(s[0], y[0]), complex(s[1], y[0]), complex(s[1], y[1]), complex(s[0], y[1])]
    board.area(corners, pen, fill=fill, level=ON_WHEEL)


class End(NamedTuple):
    """Where a shaft ends, for its name."""

    anchors: tuple[complex, ...]
    side: int  # on which it leaves, to the right 1 or to the left -1; 0: on none


def _shaft(board: Board, scheme: Scheme, name: str, layer: int) -> End | None:
    """The shaft of a member over all that it has, as a sleeve around those inside; None: nothing to name there."""
    stands, axis = scheme.stands(name), scheme.height(name)
    rings = [web_of(scheme, wheel) for wheel in scheme.wheels if wheel.member == name and wheel.ring]
    discs = [wheel for wheel in scheme.wheels if wheel.member == name and not wheel.ring]
    ends = [s for wheel in discs for s in scheme.along(wheel)] + rings
    if name in scheme.arms:
        ends.append(scheme.place(scheme.arms[name]))
    if not stands or not ends:
        return None
    borne = scheme.network.bearer(name) != FRAME
    hub = HUB * board.mu
    low, high = min(ends) - hub, max(ends) + hub
    radius = layer * LAYER * board.mu
    if borne:
        bearer = scheme.network.bearer(name)
        arm = scheme.place(scheme.arms[bearer]) if bearer in scheme.arms else low + hub
        low, high = min(low + hub, arm), max(high - hub, arm)
        board.line([complex(low, axis), complex(high, axis)], AXLE, level=ON_SHAFT)
        return None
    free = dict(scheme.through).get(name) or exit_of(scheme, name)
    edges = float(scheme.content.real.min()), float(scheme.content.real.max())
    if free:
        # a shaft through others is longer than they are
        over = 0.0 if not scheme.through or name in dict(scheme.through) else 0.6 * EXIT * STEP * scheme.unit
        low, high = (low, edges[1] - over) if free > 0 else (edges[0] + over, high)
    for side in (1, -1) if layer else (0,):
        y = axis + side * radius
        board.line([complex(low, y), complex(high, y)], SLEEVES if layer else SHAFT, level=ON_SHAFT)
    if free:
        end = high if free > 0 else low
        if name in scheme.held:
            half = HELD * board.mu
            hatched(board, complex(end, axis - half), complex(end, axis + half), complex(free))
            return End((complex(end, axis + half), complex(end, axis - half)), free)
        at = end - free * 0.3 * EXIT * STEP * scheme.unit
        _bearing(board, at, axis, radius)
    return End((complex(high if free >= 0 else low, axis + radius),), free)


def _name(board: Board, name: str, end: End, part: float) -> None:
    """The name of a member at the end of its shaft."""
    board.labels.put(
        name,
        board.paper(end.anchors),
        height=part * 2.4,
        gaps=(1.2, 2.2, 3.6),
        prefer=complex(end.side or 1, 1),
    )


def _bearing(board: Board, at: float, axis: float, radius: float) -> None:
    """Hatched lines on both sides of a shaft."""
    half, away = BEARING[0] * board.mu / 2, radius + BEARING[1] * board.mu
    for side in (1, -1):
        y = axis + side * away
        hatched(board, complex(at - half, y), complex(at + half, y), side * 1j)


def _carrier(board: Board, scheme: Scheme, name: str) -> None:
    """The arms from the axis of a carrier to those of all that it bears."""
    at, axis = scheme.place(scheme.arms[name]), scheme.height(name)
    for member in scheme.network.members:
        if scheme.network.bearer(member) != name:
            continue
        own = scheme.height(member)
        if not scheme.network.tilted(member):
            board.line([complex(at, axis), complex(at, own)], CARRIER, level=ON_CARRIER)
            continue
        wheel = next(wheel for wheel in scheme.wheels if wheel.member == member)
        middle, over = scheme.place(scheme.span(wheel)[0]), own + 4 * board.mu
        bent = [complex(at, axis), complex(at, over), complex(middle, over), complex(middle, own)]
        board.line(bent, CARRIER, level=ON_CARRIER)


def _beyond(scheme: Scheme, wheel: Wheel) -> float:
    """How far [m] a name stands off a wheel beside which the web of a ring goes down: on the other side of the web."""
    if wheel.ring:
        return 0.0
    webs = [web_of(scheme, ring) for ring in scheme.wheels if ring.ring and ring.member != FRAME]
    apart = [max(start - web, web - end) for web in webs for start, end in (scheme.along(wheel),)]
    return max((each for each in apart if 0 < each < STEP / 2 * scheme.unit), default=0.0)


def _label(board: Board, scheme: Scheme, part: float) -> None:
    """Numbers of teeth at the wheels."""
    called = {}
    for mesh, names in zip(scheme.network.meshes, wheel_names(scheme.network), strict=True):
        called[mesh.first, mesh.first_teeth], called[mesh.second, mesh.second_teeth] = names
    for wheel in scheme.wheels:
        start, end = scheme.along(wheel)
        axis, size = scheme.height(wheel.member), wheel.radius
        if wheel.ring:
            size += RIM * scheme.unit / 2
        parts = (1.0, -1.0) if wheel.ring else (0.6, -0.6, 0.9, -0.9, 0.3, -0.3)
        anchors = [complex(s, axis + share * size) for share in parts for s in (end, start)]
        if wheel.tilt and scheme.network.tilted(wheel.member):
            anchors = [complex(s, axis) for s in (end, start)]
        text = f"$z_{{{called[wheel.member, wheel.teeth]}}}$ = {wheel.teeth}"
        colour = COLOURS[scheme.span(wheel)[0] % len(COLOURS)]
        over = _beyond(scheme, wheel) / board.mu
        gaps = tuple(over + gap for gap in (1.0, 1.8, 3.0, 4.6)[over > 0 :])
        board.labels.put(text, board.paper(anchors), height=part * 2.3, gaps=gaps, colour=colour)
