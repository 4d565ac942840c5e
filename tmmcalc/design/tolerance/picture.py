"""Pictures of a study of tolerances: histograms of the results, the band of a column over the positions of a turn."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.tolerance.sampling import QUANTILES, enough
from tmmcalc.design.tolerance.sources import Values
from tmmcalc.design.tolerance.study import Tolerated
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, named
from tmmcalc.report.drawing.lettering import plain
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.pens import CURVES, MIDDLE, THIN, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import percent

BARS = 40
MOST = 4  # histograms on a sheet
FILL = "#cfe3f2"
WORST = Pen("WORST_CASE", 0.35, (2.5, 1.3), "#d55e00")
LINEAR = Pen("LINEAR", 0.35, colour="#009e73")
MEDIAN = 0.5
PENS = dict(zip(QUANTILES, (WORST, CURVES[0], LINEAR, CURVES[0], WORST), strict=True))
AIR = 0.04  # beside the outermost place, of the span


def tolerance_drawing(result: Tolerated, name: str) -> Drawing:
    """Sheets of up to four histograms, then one of the band if there is one; ``name`` is that of the spec."""
    shown = [at for at in range(len(result.worst)) if result.statistics[at] is not None]
    banded = bool(result.band)
    count = max(math.ceil(len(shown) / MOST) + banded, 1)
    drawing, boxes = sheets(count)
    heading = tr("{name}: tolerances", name=plain(name))
    boxes = [headed(drawing, box, heading) for box in boxes]
    for place, at in enumerate(shown):
        sheet, number = divmod(place, MOST)
        here = min(MOST, len(shown) - sheet * MOST)
        _histogram(drawing, _part(boxes[sheet], number, here), result, at)
    if banded:
        _band(drawing, boxes[-1].inset(22, 14, 4, 8), result)
    return drawing


def _part(box: Box, number: int, of: int) -> Box:
    """One of up to four parts of a sheet, with room for numbers."""
    across, down = (1 if of == 1 else 2), (1 if of <= 2 else 2)
    wide, high = box.width / across, box.height / down
    row, column = divmod(number, across)
    top = box.top - row * high
    left = box.left + column * wide
    return Box(left, top - high, left + wide, top).inset(20, 14, 4, 14)


def _histogram(drawing: Drawing, box: Box, result: Tolerated, at: int) -> None:
    """Density of the samples, the linear model over it, nominal value and worst cases as lines across."""
    values = result.values[:, at]
    values = values[np.isfinite(values)]
    worst, nominal = result.worst[at], float(result.nominal[at])
    ends = [] if worst.how == "none" else [worst.least, worst.largest]
    low, high = min([values.min(), nominal, *ends]), max([values.max(), nominal, *ends])
    air = AIR * (high - low) or abs(nominal) * 1e-6 or 1.0
    density, edges = np.histogram(values, BARS, density=values.min() < values.max())
    mean, sigma = float(result.linear.mean[at]), float(result.linear.sigma[at])
    x = np.linspace(low - air, high + air, 401)
    curve = np.zeros_like(x)
    if sigma > 0:
        curve = np.exp(-(((x - mean) / sigma) ** 2) / 2) / (sigma * math.sqrt(2 * math.pi))
    top = 1.08 * max(float(density.max()), float(curve.max()))
    along, up = Axis(named(result.names[at]), low - air, high + air), Axis(tr("density of samples"), 0.0, top)
    field = Diagram(drawing, box, along, up)
    for height, left, right in zip(density, edges, edges[1:], strict=False):
        corners = field.paper([complex(left, 0), complex(right, 0), complex(right, height), complex(left, height)])
        drawing.add(Area(corners, FILL, THIN), level=0)
    if sigma > 0:
        field.curve(x + 1j * curve, LINEAR)
    field.vertical(nominal, MIDDLE)
    for end in ends:
        field.vertical(end, WORST)
    field.key([(tr("nominal"), MIDDLE), (tr("linear model"), LINEAR), (tr("worst case"), WORST)])


def band(result: Tolerated) -> dict[float, Values]:
    """How far the quantiles that there are samples enough for are from the nominal column (n,), at its positions."""
    columns = [*result.band]
    values = result.values[:, columns]
    some = QUANTILES[enough(int(np.isfinite(values).sum(axis=0).min()))]
    apart = np.nanquantile(values, some, axis=0) - result.nominal[columns]
    return dict(zip(some, apart, strict=True))


def _band(drawing: Drawing, box: Box, result: Tolerated) -> None:
    """Quantiles of the samples as far as they are from the nominal course, each beside its counterpart."""
    apart = band(result)
    header, unit = key_and_unit(result.names[result.band[0]])
    name = tr("{name}: apart from nominal", name=plain(header.rpartition("@")[0]))
    rows = np.array([*apart.values()])
    low, high = float(rows.min()), float(rows.max())
    air = AIR * (high - low) or 1.0
    along = Axis(tr("number of the position"), 0.0, max(len(result.band) - 1.0, 1.0), whole=True)
    upward = Axis(f"{name}, {tr_unit(unit)}" if unit else name, low - air, high + air)
    field = Diagram(drawing, box, along, upward)
    for q, row in apart.items():
        field.curve(np.arange(len(row)) + 1j * row, PENS[q])
    pairs = [q for q in apart if q < MEDIAN]
    names = [(f"{percent(q)}, {percent(1 - q)}", PENS[q]) for q in pairs]
    field.key([*names, (tr("median"), PENS[MEDIAN])])
