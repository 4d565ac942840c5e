"""From the table ``[train]`` to the tasks of synthesis: one for each layout and number of planets."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.kinds import kinds_of, turns_back
from tmmcalc.gears.model import Demands, Interval, Limits, TrainTask
from tmmcalc.gears.nominal import SPEEDS, with_nominal
from tmmcalc.gears.radial import RadialShape, angle_ratios
from tmmcalc.gears.scheme import Layout, layout_of
from tmmcalc.gears.strength.series import eighths
from tmmcalc.gears.trains import Request

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.tables.train import ConstraintsTable, TrainTable

UNKNOWN = Fraction(2)  # stands in for a ratio that speeds of the machine give
RANGE = (Fraction(1), Fraction(5, 2))  # of the ratio m2/m1 of standard modules
TOLERANCE = {"unfolded3": Fraction(2, 100)}
USUAL_TOLERANCE = Fraction(1, 100)
STAGE_RATIO, BAND = Fraction(6), Fraction(5, 100)  # of unfolded trains
SLIGHT = Fraction(5, 6)  # of the least number of teeth without undercut: some is harmless down to it


def to_train(spec: GearTables) -> tuple[Request, ...]:
    """What is asked, layout by layout; empty if the spec has no train."""
    table = spec.train
    if table is None:
        return ()
    return tuple(
        _request(table, layout, planets)
        for layout in map(layout_of, table.layout)
        for planets in _planets(table, layout)
    )


def _planets(table: TrainTable, layout: Layout) -> list[int]:
    if not layout.branched:
        return [1]
    return table.planets or [layout.usual_planets]


def _request(table: TrainTable, layout: Layout, planets: int) -> Request:
    kind = table.ratio_kind or kinds_of(layout)[0]
    nominal = _nominal(table, layout)
    tolerance = TOLERANCE.get(layout.key, USUAL_TOLERANCE) if table.tolerance is None else table.tolerance
    least = _no_undercut(table)
    task = TrainTask(
        layout=layout.key,
        nominal=UNKNOWN,
        ratio=Interval(UNKNOWN, UNKNOWN),
        proportions=_proportions(table, layout),
        planets=planets,
        limits=_limits(table),
        demands=_demands(table.constraints, layout, least if _keeps_undercut(table, least) else None),
        pressure_angle=table.pressure_angle,
        addendum=table.addendum,
        module=table.modules[0] if table.modules is not None else table.module,
        teeth=None if table.teeth is None else tuple(table.teeth),
    )
    request = Request(
        task=task,
        kind=kind,
        nominal=UNKNOWN,
        admitted=task.ratio,
        relative=table.tolerance_kind == "relative",
        tolerance=tolerance,
        method=table.method,
        keep=table.keep,
        remarks=tuple(_remarks(table, task, least)),
        radial=_radial(table, layout),
    )
    return request if nominal is None else with_nominal(request, nominal)


def _radial(table: TrainTable, layout: Layout) -> RadialShape | None:
    """Parameters of pairs of planets; t1 and t2 given, or of the mesh angles."""
    given = table.radial
    if given is None or not layout.paired:
        return None
    if given.mesh_angles is None:
        return RadialShape(given.y, given.t1, given.t2, given.assembly_number)
    first, between, last = given.mesh_angles
    angles = (first, between, last)
    return RadialShape(given.y, *angle_ratios(angles), given.assembly_number, angles)


def _nominal(table: TrainTable, layout: Layout) -> Fraction | None:
    """The ratio of its kind; that of speeds of fixed axes without its sign; None: speeds of the machine give it."""
    if table.ratio is not None:
        return table.ratio
    if table.input_speed is None or table.output_speed is None:
        return None
    ratio = Fraction(table.input_speed / table.output_speed).limit_denominator(SPEEDS)
    return -ratio if not layout.planetary and turns_back(layout) else ratio


def _proportions(table: TrainTable, layout: Layout) -> tuple[tuple[int, ...], ...]:
    """Modules of the stages to one another in lowest terms, the smaller m2/m1 first."""
    if not layout.branched:
        return ((),)
    if layout.stages == 1:
        return ((1,),)
    return tuple((ratio.denominator, ratio.numerator) for ratio in sorted(set(_module_ratios(table))))


def _module_ratios(table: TrainTable) -> Iterator[Fraction]:
    """Ratios m2/m1: given, of given modules, or all that standard modules have."""
    if table.module_ratios is not None:
        yield from (second / first for first, second in table.module_ratios)
    elif table.modules is not None:
        first, second = (Fraction(repr(module)) for module in table.modules)  # as written: "3.5 mm" is 0.0035
        yield second / first
    else:
        low, high = table.module_ratio_range or RANGE
        yield from (ratio for ratio in _standard_ratios() if low <= ratio <= high)


@cache
def _standard_ratios() -> frozenset[Fraction]:
    """The ratios that standard modules have to one another."""
    series = eighths()
    return frozenset(Fraction(b, a) for a in series for b in series)


def _limits(table: TrainTable) -> Limits:
    usual = Limits()
    given = {
        "least": table.z_min,
        "largest": table.z_max,
        "largest_pinion": table.z_pinion_max,
        "least_ring": table.ring_min,
        "largest_ring": table.ring_max,
        "largest_sum": table.sum_max,
    }
    return Limits(**{name: getattr(usual, name) if teeth is None else teeth for name, teeth in given.items()})


def _no_undercut(table: TrainTable) -> int:
    """Least number of teeth that the rack does not undercut, 2 h_a/sin^2(alpha); 17 for 17.1, as in the textbook."""
    return math.floor(2 * float(table.addendum) / math.sin(table.pressure_angle) ** 2)


def _keeps_undercut(table: TrainTable, least: int) -> bool:
    asked = table.constraints.undercut
    return asked if asked is not None else table.z_min is None or table.z_min >= least


def _demands(table: ConstraintsTable, layout: Layout, undercut: int | None) -> Demands:
    unfolded = not layout.branched
    angle = _given(table.mesh_angle_max, layout.raised) if layout.branched else None
    distances = _given(table.centre_distance, None)
    return Demands(
        largest_angle=angle,
        assembly=table.assembly,
        gap=_given(table.adjacency_gap, None),
        ring_difference=_given(table.ring_difference, None),
        undercut=undercut,
        stage_ratio=_given(table.stage_ratio_max, STAGE_RATIO if unfolded else None),
        diameter_band=_given(table.diameter_band, BAND if unfolded else None),
        equal_pinions=table.equal_pinions,
        coprime=table.coprime,
        centre_distance=None if distances is None else (distances[0], distances[1]),
        envelope=_given(table.envelope, None),
    )


def _given(value: Any, usual: Any) -> Any:
    """The value that a key gives; None where it says false; what is usual where it is absent."""
    if value is False:
        return None
    return usual if value is None else value


def _remarks(table: TrainTable, task: TrainTask, least: int) -> Iterator[str]:
    """What is unusual about the task."""
    if table.z_min is not None and not task.demands.undercut and table.z_min < least:
        slight = table.z_min >= math.ceil(SLIGHT * least)
        degree = "slight undercut" if slight else "undercut"
        yield Phrase(
            "{cut}: z_min = {z_min}, without a profile shift wheels of {least} teeth are free of it",
            cut=degree,
            z_min=table.z_min,
            least=least,
        )
