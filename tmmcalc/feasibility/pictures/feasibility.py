"""The picture of the feasibility stage: the margin of every constraint as a bar, the region where it holds, the rule.

Margins are parts of the limits; a bar beyond the scale ends in an arrow. A constraint that fails without harm to the
rule is grey.
"""

from __future__ import annotations

import textwrap

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.feasibility.facts.feasibility import limits_in_words, measured
from tmmcalc.feasibility.judge import Feasibility, Verdict
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import INK, THIN

HOLDS, FAILS, IDLE = "#009e73", "#d55e00", "#9a9a9a"
REGION = "#e3f2ec"
LEAST, MOST = 10.0, 100.0  # [%] half the scale, at least and at most
LEAST_ROWS = 5  # that a sheet is divided into
TWO_LINES = 20  # rows up to which a quantity and its limits stand in two lines
INSIDE = 0.75  # part of the scale beyond which the figure of a bar stands in it
WRAP = 110  # characters of a line of the rule


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return feasibility_figure(order.results["feasibility"])


def feasibility_figure(result: Feasibility) -> Figure:
    """One sheet: a bar a constraint in the order of the spec, the rule above."""
    figure, (sheet,) = blank(1)
    state = "feasible" if result.feasible else f"not feasible: {', '.join(result.failing)}"
    of = f" of solution {result.chosen} of {len(result.candidates)}" if result.candidates else ""
    sheet.suptitle("\n".join([f"Constraints{of}: {state}", *textwrap.wrap(f"rule: {result.rule}", WRAP)]), fontsize=10)
    axes = sheet.subplots()
    margins = [100 * verdict.margin for verdict in result.verdicts]
    scale = min(max(LEAST, *(1.1 * abs(margin) for margin in margins)), MOST)
    axes.axvspan(0, scale, color=REGION, zorder=0)
    axes.axvline(0, color=INK, linewidth=1.0, zorder=4)
    for row, verdict in enumerate(result.verdicts):
        _bar(axes, row, verdict, scale, verdict.name in result.failing)
    _frame(axes, result, scale)
    settle(figure)
    return figure


def _bar(axes: Axes, row: int, verdict: Verdict, scale: float, at_fault: bool) -> None:
    """The margin, its figure at the end; what fails is hatched, so that a grey print tells it too."""
    margin = 100 * verdict.margin
    end = min(max(margin, -scale), scale)
    colour = FAILS if at_fault else HOLDS if verdict.holds else IDLE
    hatch = None if verdict.holds else "///"
    axes.barh(row, end, height=0.42, color=colour, zorder=3, hatch=hatch, edgecolor="white", linewidth=0)
    if end != margin:
        axes.plot(
            [0.985 * end], [row], marker=">" if end > 0 else "<", color=INK, markersize=6, clip_on=False, zorder=5
        )
    side = 1 if verdict.margin >= 0 else -1
    inwards = -side if abs(end) > INSIDE * scale else side
    axes.annotate(
        f"{margin:+.3g} %" if abs(margin) < 100 else f"{margin:+.0f} %",
        (end, row),
        xytext=(12 * inwards, 0),
        textcoords="offset points",
        ha="left" if inwards > 0 else "right",
        va="center",
        bbox={"boxstyle": "round,pad=0.2", "facecolor": "white", "edgecolor": "none"} if inwards != side else None,
        zorder=6,
    )


def _frame(axes: Axes, result: Feasibility, scale: float) -> None:
    """Names on the left, quantities with their limits on the right."""
    verdicts = result.verdicts
    rows, bottom = range(len(verdicts)), max(len(verdicts), LEAST_ROWS) - 0.4
    between = "\n" if len(verdicts) <= TWO_LINES else "; "
    words = [f"{measured(verdict)}{between}{' and '.join(limits_in_words(verdict))}" for verdict in verdicts]
    axes.set_yticks(rows, [verdict.name for verdict in verdicts], fontsize=9)
    right = axes.twinx()
    right.set_yticks(rows, words)
    for side in (axes, right):
        side.set_ylim(bottom, -0.6)
        side.tick_params(axis="y", length=0)
    axes.set_xlim(-scale, scale)
    axes.set_xlabel("margin to the nearer limit, % of it")
    axes.text(0.99, 0.015, "holds", transform=axes.transAxes, ha="right", va="bottom", color=HOLDS)
    axes.text(0.01, 0.015, "fails", transform=axes.transAxes, ha="left", va="bottom", color=FAILS)
    axes.grid(axis="x", color=THIN, linewidth=0.3, alpha=0.6)
