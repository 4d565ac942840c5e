"""From ``[transloader]`` to the crane, its loads and its parts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.extras.loadcases import LOADS

if TYPE_CHECKING:
    from tmmcalc.extras.room import ExtraTables
    from tmmcalc.extras.tables.transloader import TransloaderPartTable
    from tmmcalc.extras.transloader import Part, TransloaderTask


def to_transloader(spec: ExtraTables) -> TransloaderTask:
    """The transloader of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.transloader import Start, TransloaderTask, Way, Wind

    table = spec.transloader
    if table is None:
        raise UsageError("the spec has no [transloader]", remedy="add [transloader] with capacity")
    trolley, hoist, start, known = table.trolley, table.hoist, table.inertia, table.loads
    winds = (("wind", table.wind), ("equivalent_wind", table.equivalent_wind), ("hurricane", table.hurricane))
    given = {} if known is None else {name: getattr(known, name) for name in LOADS}
    return TransloaderTask(
        capacity=table.capacity,
        mass=table.mass,
        gravity=table.gravity,
        span=table.span,
        deflection=table.deflection,
        trolley=None if trolley is None else Way(trolley.path, trolley.acceleration, trolley.speed),
        hoist=None if hoist is None else Way(hoist.height, hoist.acceleration, hoist.speed),
        lowering=None if hoist is None else hoist.lowering,
        bridge_speed=table.bridge_speed,
        inertia=None if start is None else Start(tuple(start.weights), start.speed, start.time),
        winds=tuple(
            (name, Wind(wind.pressure, wind.area, wind.height, wind.shape, wind.overload, wind.dynamic))
            for name, wind in winds
            if wind is not None
        ),
        loads=tuple((name, value) for name, value in given.items() if value is not None),
        parts=tuple(map(_part, table.parts)),
        factors=table.factors,
        blanks=table.blanks,
    )


def _part(table: TransloaderPartTable) -> Part:
    from tmmcalc.extras.transloader import Part

    ratios = ((name, getattr(table.influence, name)) for name in LOADS)
    return Part(
        name=table.name,
        area=table.area,
        strength=table.strength,
        influence=tuple((name, ratio) for name, ratio in ratios if ratio),
        endurance=table.endurance,
        mechanism=table.mechanism,
        duty=table.duty,
        making=table.making,
        importance=None if table.importance is None else tuple(table.importance),
    )
