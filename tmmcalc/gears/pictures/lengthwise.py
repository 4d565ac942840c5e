"""Where the parts of a train stand along its axis: planes of meshing, ends of shafts, carrier.

Widths that are not known are drawn alike, as a part of the height of the train. The carrier stands right of the wheels,
or on the left around the input shaft where the last wheel leaves no other way.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.endview import RIM
from tmmcalc.gears.pictures.placed import PlacedTrain, Wheel

WIDTH = 0.09  # of wheels whose width is not known, in parts of the height of the train
CLEAR = 0.06  # between wheels of neighbouring planes, in parts of the height
OVERHANG = 0.19  # of shafts, in parts of the height
ROOM = 2.4  # least overhang, in distances of planes: the carrier stands there


class Frame(NamedTuple):
    """Places along the axis."""

    planes: tuple[tuple[float, float], ...]  # of meshing, from and to
    left: float  # ends of the shafts
    right: float
    clear: float  # between planes


def frame_of(train: PlacedTrain) -> Frame:
    """Planes by their widths, known or assumed, from zero on."""
    height = train.height
    widths = train.widths or (WIDTH * height,) * train.scheme.stages
    clear = max(CLEAR * height, 0.4 * max(widths))
    planes, start = [], 0.0
    for plane in range(train.planes):
        width = widths[min(plane, len(widths) - 1)]
        planes.append((start, start + width))
        start += width + clear
    over = max(OVERHANG * height, ROOM * clear)
    # a carrier on the left needs room around the input shaft
    left = over * (1.6 if train.scheme.carrier == "left" else 1.0)
    return Frame(tuple(planes), -left, start - clear + over, clear)


def extent(train: PlacedTrain) -> Plane:
    """Corners of all that the side view shows: along the axis, and across it."""
    frame, across = frame_of(train), [0.0]
    for wheel in train.wheels:
        rim = RIM * wheel.module if wheel.internal else 0.0
        for axis in shown(train, wheel):
            across += [axis - wheel.outer - rim, axis + wheel.outer + rim]
    return np.array([complex(s, r) for s in (frame.left, frame.right) for r in (min(across), max(across))])


def free_places(train: PlacedTrain, wheel: Wheel) -> list[tuple[float, float]]:
    """Places beside a wheel where no other wheel of its plane is near, on both sides of it."""
    span, axis, size = span_of(frame_of(train), wheel), shown(train, wheel)[0], wheel.rolling
    if not train.scheme.branched:
        return [(s, axis + part * size) for part in (0.0, 0.5, -0.5) for s in span]
    if wheel.internal:
        return [(s, -wheel.reference - RIM * wheel.module / 2) for s in span]
    rows = (axis + 0.6 * size, axis - 0.6 * size, axis + size) if wheel.planet else (-0.6 * size, -size)
    return [(s, r) for r in rows for s in span]


def carrier_at(train: PlacedTrain) -> float:
    """Where along the axis the arms of the carrier are."""
    frame = frame_of(train)
    if train.scheme.carrier == "right":
        return frame.planes[-1][1] + 0.9 * frame.clear
    return frame.planes[0][0] - 0.9 * frame.clear


def sleeve_end(train: PlacedTrain) -> float:
    """Where the sleeve of a carrier on the left ends, when it leads out."""
    left, at = frame_of(train).left, carrier_at(train)
    return left + 0.5 * (at - left)


def shown(train: PlacedTrain, wheel: Wheel) -> tuple[float, ...]:
    """Where across the axis a wheel is drawn."""
    if not train.scheme.branched:
        return (wheel.axes[0].real,)
    if not wheel.planet:
        return (0.0,)
    orbit = abs(wheel.axes[0])
    return (orbit, -orbit) if train.planets % 2 == 0 else (orbit,)


def span_of(frame: Frame, wheel: Wheel) -> tuple[float, float]:
    """From where to where along the axis a wheel reaches."""
    return frame.planes[wheel.planes[0]][0], frame.planes[wheel.planes[1]][1]
