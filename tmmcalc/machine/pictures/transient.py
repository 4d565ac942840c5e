"""The picture of the transient stage: speeds and moments over the time, a sheet a motion, with its events marked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.facts.transient import ENDS
from tmmcalc.machine.transient.results import Event
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions
from tmmcalc.report.drawing.curves import frame, mark, suited
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, MARK
from tmmcalc.report.numbers import number

LISTED = 8  # events whose names are written out
TAIL = 0.5  # of the time at its end that is magnified
SWING = 0.2  # of the range of the speed: a tail that swings by more needs no magnifying
SMALL = 0.02  # of the height of a panel: a curve that goes no deeper below zero is cut there
LATE = 0.95  # of the time: an event after it is numbered on its left
ROOM = 0.15  # of the range of a magnified tail, below and above it
EVENT: dict[str, Any] = {"color": MARK, "linewidth": 0.7, "linestyle": (0, (4, 3)), "zorder": 2}


@record
class Curve:
    """One curve over the time (S,), in SI."""

    label: str
    values: Values
    style: dict[str, Any]
    marked: bool = False  # its largest value is named


@record
class Panel:
    """Curves of one quantity over the time."""

    symbol: str
    unit: str
    t: Values
    curves: tuple[Curve, ...]
    tail: bool = False  # the axis shows the end of the first curve alone

    def draw(self, axes: Axes) -> None:
        """Curves and legend; texts follow by `label`, when the layout is settled."""
        factor, unit = self._scale
        for k, curve in enumerate(self.curves):
            axes.plot(self.t, curve.values * factor, linewidth=1.3, zorder=6 - k, **curve.style)
        span = self.t if len(self.t) > 1 else np.array([0.0, 1.0])
        frame(axes, f"${self.symbol}$, {unit}", span, False, 0)
        if self.tail:
            low, high = _range(self.curves[0].values[self.t >= (1 - TAIL) * self.t[-1]] * factor)
            axes.set_ylim(low - ROOM * (high - low), high + ROOM * (high - low))
        elif min(float(np.min(curve.values)) for curve in self.curves) * factor >= -SMALL * axes.get_ylim()[1]:
            axes.set_ylim(bottom=0.0)
        handles = [Line2D([], [], label=curve.label, linewidth=1.3, **curve.style) for curve in self.curves]
        place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 4}
        axes.legend(handles=handles, handlelength=3, columnspacing=1.2, borderaxespad=0.3, **place)

    @property
    def _scale(self) -> tuple[float, str]:
        return suited(max(float(np.max(np.abs(curve.values))) for curve in self.curves), self.unit)

    def label(self, axes: Axes) -> None:
        """Name the largest values."""
        factor, _ = self._scale
        labels = Labels(axes)
        for curve in self.curves:
            labels.avoid(self.t + 1j * curve.values * factor, 0.7)
        for curve in self.curves:
            k = int(np.argmax(np.abs(curve.values)))
            if curve.marked and curve.values[k]:
                mark(axes, labels, complex(self.t[k], curve.values[k] * factor), curve.style)


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return transient_figure(order.results["transient"])


def transient_figure(result: TimedMotions) -> Figure:
    """One sheet a motion."""
    figure, sheets = blank(len(result.motions))
    drawn = [_sheet(sheet, motion) for sheet, motion in zip(sheets, result.motions, strict=True)]
    settle(figure)
    for places, panels in drawn:
        for axes, panel in zip(places, panels, strict=True):
            panel.label(axes)
    return figure


def _sheet(sheet: SubFigure, motion: TimedMotion) -> tuple[list[Axes], list[Panel]]:
    """Speeds, the tail of the speed if it is flat, moments; events across them all."""
    sheet.suptitle(_heading(motion), fontsize=10)
    panels = [_speeds(motion), *_tail(motion), _moments(motion), *_shafts(motion)]
    places = sheet.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0].tolist()
    for axes, panel in zip(places, panels, strict=True):
        panel.draw(axes)
        for event in motion.events:
            axes.axvline(event.time, **EVENT)
    places[-1].tick_params(labelbottom=True)
    places[-1].set_xlabel("$t$, s")
    _name_events(places[0], motion.events)
    return places, panels


def _heading(motion: TimedMotion) -> str:
    first = (
        f"{motion.name}: from {signed(float(motion.omega[-1, 0]), 5)} to {signed(float(motion.omega[-1, -1]), 5)} rad/s"
    )
    return f"{first} in {number(float(motion.t[-1]), 5)} s; {ENDS[motion.end]}\n{_events(motion.events)}"


def _events(events: Sequence[Event]) -> str:
    """What happened, by the numbers that stand at the marks."""
    named = [f"{k}: {event.message}" for k, event in enumerate(events[:LISTED], 1)]
    lines = [";  ".join(named[k : k + 3]) for k in range(0, len(named), 3)]
    return "\n".join(lines) + (" ..." if len(events) > LISTED else "")


def _name_events(axes: Axes, events: Sequence[Event]) -> None:
    """Numbers of the events in the uppermost panel; those of one instant stand together."""
    together: dict[float, list[str]] = {}
    for k, event in enumerate(events, 1):
        together.setdefault(event.time, []).append(str(k))
    end = axes.get_xlim()[1]
    for time, numbers in together.items():
        late = time > LATE * end
        style: dict[str, Any] = {"fontsize": 6.5, "ha": "right" if late else "left", "va": "top", "color": MARK}
        halo = [withStroke(linewidth=1.6, foreground="white")]
        text = f"{', '.join(numbers)} " if late else f" {', '.join(numbers)}"
        axes.text(time, 0.98, text, transform=axes.get_xaxis_transform(), path_effects=halo, zorder=20, **style)


def _speeds(motion: TimedMotion) -> Panel:
    """Speed of the crank, and of all other masses over their ratios to it."""
    crank = len(motion.masses) - 1
    order = [crank, *range(crank)]
    curves = [
        Curve(_speed_name(motion, k), motion.omega[k] / motion.ratios[k], CURVES[i % len(CURVES)], k == crank)
        for i, k in enumerate(order)
    ]
    return Panel("\\omega", "rad/s", motion.t, tuple(curves))


def _speed_name(motion: TimedMotion, k: int) -> str:
    ratio = motion.ratios[k]
    return motion.masses[k] if ratio == 1 else f"{motion.masses[k]}, over {number(ratio, 5)}"


def _tail(motion: TimedMotion) -> list[Panel]:
    """The speed of the crank magnified, if it swings little at the end but for more than nothing."""
    speed = motion.omega[-1]
    low, high = _range(speed)
    least, most = _range(speed[motion.t >= (1 - TAIL) * motion.t[-1]])
    if not 0 < most - least < SWING * (high - low):
        return []
    return [Panel("\\omega", "rad/s", motion.t, (Curve("crank, magnified", speed, CURVES[0]),), tail=True)]


def _range(values: Values) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))


def _moments(motion: TimedMotion) -> Panel:
    """Moments of motor and load on the crank's shaft."""
    motor = motion.motor_moment * motion.ratios[0]
    curves = [Curve("motor $M_\\mathrm{d}$, reduced to the crank", motor, CURVES[0], True)] if motor.any() else []
    curves.append(Curve("load $M_\\mathrm{load}$", motion.load_moment, CURVES[1], True))
    return Panel("M", "N*m", motion.t, tuple(curves))


def _shafts(motion: TimedMotion) -> list[Panel]:
    """Moments of the shafts, each on its own."""
    curves = [
        Curve(
            f"$M_{{{k + 1},{k + 2}}}$: {a} to {b}, on its own shaft",
            motion.shaft_moment[k],
            CURVES[k % len(CURVES)],
            True,
        )
        for k, (a, b) in enumerate(zip(motion.masses[:-1], motion.masses[1:], strict=True))
    ]
    return [Panel("M", "N*m", motion.t, tuple(curves))] if curves else []
