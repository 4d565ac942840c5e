"""The sheet of an engine: hodographs and sizes of its force and couple, as it is and with weights."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.fourier import TURN, Magnitude, Series
from tmmcalc.machine.balance.engines import EngineBalance
from tmmcalc.machine.balance.enginetask import Engine
from tmmcalc.machine.pictures.shaking import Path, Polar, Sizes, shaking_sheet
from tmmcalc.machine.pictures.words import speed_words
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_count
from tmmcalc.report.numbers import NOISE, number

SAMPLES = 1441  # of a turn
HEADING = 12.0  # room of the heading [mm]


class Kind(NamedTuple):
    """Force or couple."""

    symbol: str
    unit: str
    scale: int  # index of its scale
    of: Callable[[EngineBalance], tuple[Series, Magnitude]]


FORCE = Kind("F", "N", 0, lambda state: (state.force, state.force_size))
COUPLE = Kind("C", "N*m", 1, lambda state: (state.couple, state.couple_size))


def engine_sheet(drawing: Drawing, box: Box, result: Engine) -> None:
    """Draw a sheet."""
    balance = result.balance
    count = tr_count(result.cylinders, "cylinder", "cylinders")
    values = {"count": count, "speed": speed_words(balance.speed), "place": minus(number(1e3 * balance.reference))}
    title = tr(
        "Shaking force $F$ and couple $C$ of an engine: {count}, {speed}\ncouple about the plane $z$ = {place} mm",
        **values,
    )
    drawing.add(Words(complex(box.middle.real, box.top), title, 3.0, 1j))
    draw_engine(drawing, box.inset(0, 0, 0, HEADING), result)


def draw_engine(drawing: Drawing, box: Box, result: Engine, *, across: bool = True) -> None:
    """Hodographs and sizes of force and couple, those that there are; beside each other or one under another."""
    views = [_view(result, kind) for kind in (FORCE, COUPLE)]
    seen = [view for view in views if any(view[1].levels)] or views[:1]
    polars, sizes = [polar for polar, _ in seen], [each for _, each in seen]
    shaking_sheet(drawing, box, polars, sizes, (1.5, 1.0)[: len(seen)], across=across)


def _view(result: Engine, kind: Kind) -> tuple[Polar, Sizes]:
    """The hodograph of force or couple, and its size over a turn."""
    psi = np.linspace(0.0, TURN, SAMPLES)
    paths, lines, levels = [], [], []
    for k, (label, state) in enumerate(_states(result)):
        series, size = kind.of(state)
        values = series.at(psi) * (size.largest > NOISE * state.scales[kind.scale])
        pen = CURVES[k]
        paths.append(Path(label, values, np.empty(0, np.complex128), pen))
        mark = ((size.at, size.largest),) if values.any() else ()
        lines.append(Line(label, np.abs(values), np.empty(0), pen, mark))
        levels.append(size.rms if values.any() else 0.0)
    names = f"{kind.symbol}_x", f"{kind.symbol}_y"
    along = tr("angle of the shaft, °")
    graph = Graph(f"|{kind.symbol}|", kind.unit, True, psi, np.empty(0), tuple(lines), abscissa=along)
    heading = tr("Hodograph of the force") if kind is FORCE else tr("Hodograph of the couple")
    return Polar(heading, names, kind.unit, tuple(paths)), Sizes(graph, tuple(levels))


def _states(result: Engine) -> list[tuple[str, EngineBalance]]:
    """The engine as it is, and with weights where there are any that do something."""
    found = [(tr("as it is"), result.balance)]
    for label, state in (
        (tr("weights on the crankshaft"), result.with_crankshaft),
        (tr("balance shafts"), result.with_shafts),
    ):
        before = found[-1][1]
        changes = (
            abs(one.rms - other.rms) > NOISE * scale
            for one, other, scale in (
                (before.force_size, state.force_size, state.scales[0]),
                (before.couple_size, state.couple_size, state.scales[1]),
            )
        )
        if any(changes):
            found.append((label, state))
    return found
