"""The sheets of a choice: inertia against mass with the size as colour, all pairs of criteria, front and winner."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import SubFigure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator, NullFormatter

from tmmcalc.gears.criteria.choice import front
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.pictures.words import CRITERIA, axis_name, teeth_text
from tmmcalc.gears.selection.results import Pool, Selection
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import INK, MARK
from tmmcalc.report.numbers import number

MANY = 3000  # more points than this are drawn as an image
NAMED = 25  # members of the front that are numbered, evenly chosen
BEYOND = 2.0  # times the largest values of the front: heavier trains are left out of the picture
WIDE = 30.0  # a larger relation of the largest to the least value takes a logarithmic axis
MARKERS = ("o", "^", "s", "D", "v", "P", "X", "<", ">")  # of variants
COLOURS = "viridis_r"
EDGE_ROOM = 0.06  # beyond the values on both sides, in parts of their range
SEEN = 1.03  # room about the values on a logarithmic axis
FRONT: dict[str, Any] = {
    "color": MARK,
    "marker": "o",
    "linestyle": "",
    "markersize": 8.0,
    "markerfacecolor": "none",
    "markeredgewidth": 1.0,
    "zorder": 6,
}
WINNER: dict[str, Any] = {
    "color": INK,
    "marker": "*",
    "linestyle": "",
    "markersize": 14,
    "markerfacecolor": "none",
    "markeredgewidth": 1.2,
    "zorder": 8,
}
EDGE: dict[str, Any] = {"color": MARK, "linewidth": 0.9, "linestyle": (0, (6, 2)), "zorder": 3}
CLOUD: dict[str, Any] = {"color": "#8aa6bd", "marker": ".", "linestyle": "", "markersize": 3.2, "zorder": 3}


def pareto_sheet(sheet: SubFigure, result: Selection, place: int, heading: str) -> Callable[[], None]:
    """Inertia against mass; ``place`` is the row that is marked. What is returned draws the texts."""
    pool = result.pool
    sheet.suptitle(heading, fontsize=10)
    axes = sheet.subplots()
    x, y = pool.mass, pool.inertia
    near = _near(result, place)
    colours = _draw_trains(axes, result, near)
    axes.plot(*_staircase(pool), **EDGE)
    axes.plot(x[result.front], y[result.front], **FRONT)
    axes.plot(x[place], y[place], **WINNER)
    for axis, values in (("x", x), ("y", y)):
        _scale(axes, axis, values[near])
    axes.set_xlabel(axis_name("mass"))
    axes.set_ylabel(axis_name("inertia"))
    bar = sheet.colorbar(colours, ax=axes, pad=0.015, aspect=40)
    bar.set_label(axis_name("size"))
    bar.outline.set_linewidth(0.5)
    _legend(axes, result, place)
    if not near.all():
        text = f"{np.count_nonzero(~near)} heavier or more inert trains lie beyond the picture"
        axes.text(0.995, 0.985, text, transform=axes.transAxes, ha="right", va="top", size=7.5)

    def finish() -> None:
        _label(axes, result, place, near)

    return finish


def _near(result: Selection, place: int) -> np.ndarray:
    """Trains (n,) that are not far heavier or more inert than the front and the train that is drawn."""
    pool, shown = result.pool, [*result.front.tolist(), place]
    limits = [BEYOND * float(values[shown].max()) for values in (pool.mass, pool.inertia)]
    return np.asarray((pool.mass <= limits[0]) & (pool.inertia <= limits[1]))


def _draw_trains(axes: Axes, result: Selection, near: np.ndarray) -> ScalarMappable:
    """The trains in the colour of their size, every variant with its own marker; returns the scale of colours."""
    pool = result.pool
    size = CRITERIA["size"][1] * pool.size
    norm = Normalize(float(size[near].min()), float(size[near].max()))
    for k in range(len(result.variants)):
        own = near & (pool.variant == k)
        look: dict[str, Any] = {"marker": MARKERS[k % len(MARKERS)], "s": 22, "linewidths": 0, "zorder": 4}
        look |= {"c": size[own], "cmap": COLOURS, "norm": norm, "rasterized": np.count_nonzero(near) > MANY}
        axes.scatter(pool.mass[own], pool.inertia[own], **look)
    return ScalarMappable(norm, COLOURS)


def pairs_sheet(sheet: SubFigure, result: Selection, place: int) -> Callable[[], None]:
    """Every objective against every other one, below the diagonal."""
    keys, pool = result.objectives, result.pool
    sheet.suptitle("All pairs of criteria: front of all together in rings, the train drawn as a star", fontsize=10)
    count = len(keys) - 1
    grid = sheet.subplots(count, count, squeeze=False, sharex="col", sharey="row")
    for row, second in enumerate(keys[1:]):
        for column, first in enumerate(keys[:-1]):
            axes = grid[row, column]
            if column > row:
                axes.set_axis_off()
                continue
            x, y = (CRITERIA[key][1] * getattr(pool, key) for key in (first, second))
            axes.plot(x, y, rasterized=len(x) > MANY, **CLOUD)
            axes.plot(x[result.front], y[result.front], **{**FRONT, "markersize": 4.5, "markeredgewidth": 0.7})
            axes.plot(x[place], y[place], **{**WINNER, "markersize": 10})
            axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
            axes.tick_params(length=2.5)
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_locator(MaxNLocator(4))
                axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 5)))
            if row == count - 1:
                axes.set_xlabel(_short(first))
            if column == 0:
                axes.set_ylabel(_short(second))
    return lambda: None


def _short(key: str) -> str:
    """A criterion as it is called on a narrow diagram, with an arrow to what is better."""
    _, _, unit = CRITERIA[key]
    better = "\N{RIGHTWARDS ARROW}" if OBJECTIVES[key].largest else "\N{LEFTWARDS ARROW}"
    name = key.replace("_", " ")
    return f"{name}, {unit} {better}" if unit else f"{name} {better}"


def _staircase(pool: Pool) -> tuple[np.ndarray, np.ndarray]:
    """The border of what is reached in mass and inertia alone."""
    edge = front(pool, ("mass", "inertia"))
    order = edge[np.argsort(pool.mass[edge], kind="stable")]
    x, y = np.repeat(pool.mass[order], 2)[1:], np.repeat(pool.inertia[order], 2)[:-1]
    return x, y


def _scale(axes: Axes, axis: str, values: np.ndarray) -> None:
    low, high = float(values.min()), float(values.max())
    own = axes.xaxis if axis == "x" else axes.yaxis
    if low > 0 and high > WIDE * low:
        (axes.set_xscale if axis == "x" else axes.set_yscale)("log")
        own.set_minor_formatter(NullFormatter())
        (axes.set_xlim if axis == "x" else axes.set_ylim)(low / SEEN**3, high * SEEN**3)
    else:
        edge = EDGE_ROOM * ((high - low) or abs(high) or 1.0)
        (axes.set_xlim if axis == "x" else axes.set_ylim)(low - edge, high + edge)
        own.set_major_locator(MaxNLocator(9))
    own.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.tick_params(length=2.5)


def _legend(axes: Axes, result: Selection, place: int) -> None:
    handles = [
        Line2D(
            [],
            [],
            color="#4c7a8f",
            linestyle="",
            marker=MARKERS[k % len(MARKERS)],
            markersize=4.5,
            label=f"{variant.title}: {len(variant.sets)}",
        )
        for k, variant in enumerate(result.variants)
        if len(variant.sets)
    ]
    said = ", ".join(key.replace("_", " ") for key in result.objectives)
    handles.append(Line2D([], [], label=f"front in {said}: {len(result.front)}, numbered by rows", **FRONT))
    handles.append(Line2D([], [], label="border in mass and inertia", **EDGE))
    chosen = "chosen" if place == result.winner.place else "drawn"
    handles.append(Line2D([], [], label=f"row {place + 1}, {chosen}", **WINNER))
    axes.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, columnspacing=1.4, handlelength=2
    )


def _label(axes: Axes, result: Selection, place: int, near: np.ndarray) -> None:
    """The train that is drawn by its teeth, some members of the front by their rows, from 1."""
    pool, labels = result.pool, Labels(axes)
    cloud = (pool.mass + 1j * pool.inertia)[near]
    for at in cloud[:: max(1, len(cloud) // MANY)].tolist():
        labels.avoid([at], 1.0)
    for row in result.front.tolist():
        labels.avoid([complex(pool.mass[row], pool.inertia[row])], 3.0)
    at = complex(pool.mass[place], pool.inertia[place])
    sets = result.variants[int(pool.variant[place])].sets
    text = f"{sets.layout} {teeth_text(sets.teeth[int(pool.row[place])].tolist())}"
    size = f"$D$ = {number(1e3 * float(pool.size[place]), 4)} mm"
    labels.put(f"{text}, {size}", [at], size=8, gaps=(3.0, 4.2, 6.0, 8.0))
    others = [row for row in result.front.tolist() if row != place]
    chosen = others[:: max(1, -(-len(others) // NAMED))]
    for row in chosen:
        spot = complex(pool.mass[row], pool.inertia[row])
        labels.put(str(row + 1), [spot], size=6.5, gaps=(2.0, 3.0, 4.4), color=MARK)
