"""The tables of motions in time: events, the rows of a motion nearest to equal times, all rows of all motions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.columns import Column, select
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, quantities, table
from tmmcalc.machine.transient.columns import timed_columns
from tmmcalc.machine.transient.results import Event
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.positions import more

SHOWN = 24  # equal steps of time, at whose rows a motion is shown
ROUNDING = 1e-9  # of a turn: an angle so near to a whole turn is one

TURNS = Quantity("turns", "whole turns of the crank")
ANGLE, _ = quantities(Event)["angle"].shown("deg")


def within(radians: float) -> float:
    """An angle within the turn, from 0 to less than 360 [deg]; 0 within rounding of a whole turn.

    >>> within(2 * math.pi + 2e-15), within(-2e-15), round(within(math.pi / 6), 9)
    (0.0, 0.0, 30.0)
    """
    degrees, near = math.degrees(radians) % 360.0, 360.0 * ROUNDING
    return degrees if near < degrees < 360.0 - near else 0.0


def events_view(events: Sequence[Event]) -> View | None:
    """One row an event: time, whole turns and angle within the turn, speed, what happened."""
    if not events:
        return None
    angles = [event.angle for event in events]
    columns: dict[str, list[Any]] = {
        **table(events, Event, "time"),
        TURNS.key: [math.floor(math.degrees(a) / 360.0 + ROUNDING) for a in angles],
        ANGLE: [within(a) for a in angles],
        **table(events, Event, "speed", "message"),
    }
    fastest = max(abs(event.speed) for event in events)
    return View(list(columns), list(columns.values()), [0.0, 0.0, 0.0, fastest, 0.0])


def course(motion: TimedMotion, patterns: Sequence[str], where: str) -> Document:
    """The rows of a motion nearest to equal times."""
    rows = equal_times(motion.t)
    available = timed_columns(motion)
    chosen = select(available, patterns, "motion") if patterns else _first(motion, available)
    values = [column.make() for column in chosen]
    view = View(
        [column.header for column in chosen],
        [v[rows].tolist() for v in values],
        [float(np.abs(v).max()) for v in values],
    )
    facts = (Fact("rows", _shown(len(rows), len(motion.t), where)), *_legend_facts(motion))
    told = more(where, "t,omega*,M_*")
    return Document(f"course of {motion.name}", facts, table=view, wide=not patterns, more=told)


def _shown(count: int, total: int, where: str) -> str:
    """Which rows a short table has, and where the others are."""
    if count == total:
        return f"all {total}"
    return f"{count} of {total}, near equal times; all: {where or '--format csv, or --csv for a file'}"


def _legend_facts(motion: TimedMotion) -> Iterator[Fact]:
    """What stands in the table."""
    if len(motion.masses) > 1:
        yield Fact("masses", ", ".join(f"{k} {name}" for k, name in enumerate(motion.masses, 1)))
        yield Fact("moments", "M_load on the crank, others on their own shafts; positive ones drive")
    else:
        yield Fact("moments", "M_motor on the crank, as M_load; positive ones drive")


def equal_times(t: Values) -> list[int]:
    """Indices of the rows nearest to equal times, each once; the first and the last are among them."""
    wanted = np.linspace(t[0], t[-1], SHOWN + 1)
    after = np.clip(np.searchsorted(t, wanted), 1, max(len(t) - 1, 1))
    if len(t) == 1:
        return [0]
    near = np.where(wanted - t[after - 1] < t[after] - wanted, after - 1, after)
    return sorted(set(near.tolist()))


def _first(motion: TimedMotion, available: list[Column]) -> list[Column]:
    """Time, the crank, the moments; then what a reader looks at later."""
    crank = len(motion.masses) if len(motion.masses) > 1 else ""
    mark = f"_{crank}" if crank else ""
    leading = ["t", f"theta{mark}", f"omega{mark}", "omega_1", "M_motor", "M_load"]
    shafts = [f"M_{k + 1}_{k + 2}" for k in range(len(motion.masses) - 1)]
    order = {name: k for k, name in enumerate([*leading[:4], *shafts, *leading[4:]])}
    return sorted(available, key=lambda column: order.get(column.name, len(order)))


def whole_table(result: TimedMotions, patterns: Sequence[str]) -> View:
    """All rows of all motions, one after the other; the masses of the drive are the same in all."""
    every = [timed_columns(motion) for motion in result.motions]
    chosen = [select(available, patterns, "motion") for available in every] if patterns else every
    names = [motion.name for motion in result.motions for _ in range(len(motion.t))]
    same = list(zip(*chosen, strict=True))
    values = [np.concatenate([column.make() for column in each]).tolist() for each in same]
    return View(["motion", *(each[0].header for each in same)], [names, *values])
