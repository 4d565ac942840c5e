"""The sheet of an engine: hodographs and sizes of its force and couple, as it is and with weights."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from matplotlib.figure import SubFigure

from tmmcalc.core.numerics.fourier import TURN, Magnitude, Series
from tmmcalc.machine.balance.engines import EngineBalance
from tmmcalc.machine.balance.enginetask import Engine
from tmmcalc.machine.pictures.shaking import Path, Polar, Sizes, shaking_sheet
from tmmcalc.report.drawing.curves import Diagram, Line
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import NOISE

SAMPLES = 1441  # of a turn


class Kind(NamedTuple):
    """Force or couple."""

    name: str
    symbol: str
    unit: str
    scale: int  # index of its scale
    of: Callable[[EngineBalance], tuple[Series, Magnitude]]


FORCE = Kind("force", "F", "N", 0, lambda state: (state.force, state.force_size))
COUPLE = Kind("couple", "C", "N*m", 1, lambda state: (state.couple, state.couple_size))


def engine_sheet(sheet: SubFigure, result: Engine) -> Callable[[], None]:
    """Lay a sheet out; what is returned draws when the layout is settled."""
    balance = result.balance
    speed = f"{signed(balance.speed)} rad/s ({signed(balance.speed * 30 / math.pi)} rpm)"
    count = f"{result.cylinders} cylinder{'s' if result.cylinders > 1 else ''}"
    plane = f"couple about the plane $z$ = {signed(1e3 * balance.reference)} mm"
    sheet.suptitle(f"Shaking force $F$ and couple $C$ of an engine of {count} at {speed}\n{plane}", fontsize=10)
    views = [_view(result, kind) for kind in (FORCE, COUPLE)]
    seen = [view for view in views if any(view[1].levels)] or views[:1]
    return shaking_sheet(sheet, [polar for polar, _ in seen], [diagram for _, diagram in seen], "angle of the shaft, °")


def _view(result: Engine, kind: Kind) -> tuple[Polar, Sizes]:
    """The hodograph of force or couple, and its size over a turn."""
    psi = np.linspace(0.0, TURN, SAMPLES)
    paths, lines, levels = [], [], []
    for k, (label, state) in enumerate(_states(result)):
        series, size = kind.of(state)
        values = series.at(psi) * (size.largest > NOISE * state.scales[kind.scale])
        style = CURVES[k]
        paths.append(Path(label, values, np.empty(0, np.complex128), style))
        mark = ((size.at, size.largest),) if values.any() else ()
        lines.append(Line(label, np.abs(values), np.empty(0), style, mark))
        levels.append(size.rms if values.any() else 0.0)
    names = f"{kind.symbol}_x", f"{kind.symbol}_y"
    diagram = Diagram(f"|{kind.symbol}|", kind.unit, True, psi, np.empty(0), tuple(lines))
    return Polar(f"Hodograph of the {kind.name}", names, kind.unit, tuple(paths)), Sizes(diagram, tuple(levels))


def _states(result: Engine) -> list[tuple[str, EngineBalance]]:
    """The engine as it is, and with weights where there are any that do something."""
    found = [("as it is", result.balance)]
    for label, state in (("weights on the crankshaft", result.with_crankshaft), ("balance shafts", result.with_shafts)):
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
