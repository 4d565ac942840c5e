"""From the tables of the small calculators to what is asked of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.bearing import BearingTask
    from tmmcalc.extras.contact import ContactTask
    from tmmcalc.extras.falling_ball import BallTask
    from tmmcalc.extras.reliability import ReliabilityTask
    from tmmcalc.extras.room import ExtraTables
    from tmmcalc.extras.tie_down import TieDownTask

Given = TypeVar("Given")


def to_contact(spec: ExtraTables) -> ContactTask:
    """The contact of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.contact import ContactTask, GapTable
    from tmmcalc.extras.hertz import composite_modulus

    table = _given(spec.contact, "contact", "load and radii")
    given = table.table
    (first, second), (nu, other) = table.young, table.poisson
    return ContactTask(
        load=table.load,
        modulus=composite_modulus((first, second), (nu, other)) if table.modulus is None else table.modulus,
        radii=None if table.radii is None else (table.radii[0], table.radii[-1]),
        formula=table.gap or "",
        table=None if given is None else GapTable(tuple(given.x), tuple(given.y), tuple(map(tuple, given.h))),
        cells=table.cells,
        size=table.size,
    )


def to_reliability(spec: ExtraTables) -> ReliabilityTask:
    """The product of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.reliability import LifeTest, ReliabilityTask, load_range

    table = _given(spec.reliability, "reliability", "load, rate, and strength with decay or a test")
    low, high = table.load if table.load is not None else load_range(tuple(table.readings or ()))
    test = None
    if table.items is not None and table.least_life is not None and table.mean_life is not None:
        test = LifeTest(table.items, table.least_life, table.mean_life)
    return ReliabilityTask(
        low=max(low, 0.0),
        high=high,
        rate=table.rate,
        strength=table.strength,
        decay=table.decay,
        test=test,
        times=tuple(table.times),
        until=table.until,
        rows=table.rows,
    )


def to_tie_down(spec: ExtraTables) -> TieDownTask:
    """The load of the spec and its ties; raises `UsageError` if it has none."""
    from tmmcalc.extras.tie_down import Support, Thread, TieDownTask

    table = _given(spec.tie_down, "tie_down", "weight, factor, elevation and friction")
    thread, held = table.thread, table.support
    return TieDownTask(
        weight=table.weight,
        factor=table.factor,
        elevation=table.elevation,
        plan=table.plan_angle,
        friction=table.friction,
        preload=table.preload or 0.0,
        thread=None
        if thread is None
        else Thread(thread.moment, thread.diameter, thread.lead_angle, thread.friction_angle),
        support=None
        if held is None
        else Support(held.weight, held.friction, held.base, held.arm, held.cradle_arm, held.diameter),
    )


def to_ball(spec: ExtraTables) -> BallTask:
    """The ball of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.falling_ball import BallTask

    table = _given(spec.falling_ball, "falling_ball", "radius, drag and decay")
    relative = table.relative_speed
    return BallTask(
        radius=table.radius,
        drag=table.drag,
        decay=table.decay,
        gravity=table.gravity,
        sign=1 if table.reaction == "accelerating" else -1,
        relative=None if isinstance(relative, str) else relative,
        initial=table.initial_speed,
        times=tuple(table.times),
        duration=table.duration,
        rows=table.rows,
    )


def to_bearing(spec: ExtraTables) -> BearingTask:
    """The bearing of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.bearing import BearingTask

    table = _given(spec.bearing, "bearing", "speed, inner, outer, roller and count")
    omega = table.speed
    if omega is None:
        omega = 2 * (table.wheel_speed or 0.0) / (table.wheel_diameter or 1.0)
    return BearingTask(
        omega=omega,
        inner=table.inner,
        outer=table.outer,
        roller=table.roller,
        count=table.count,
        angle=table.contact_angle,
        peak=tuple(table.peak or ()),
        rms=tuple(table.rms or ()),
    )


def _given(table: Given | None, name: str, keys: str) -> Given:
    """The table; raises `UsageError` with its needed keys if the spec has none."""
    if table is None:
        raise UsageError(f"the spec has no [{name}]", remedy=f"add [{name}] with {keys}")
    return table
