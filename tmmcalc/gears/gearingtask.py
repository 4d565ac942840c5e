"""What is known of a train that is written out, and what drives it.

What is not said is inferred where only one answer is left: the driver is the member of known speed other than zero,
the driven one carries the load or is the only shaft without a speed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.network.builder import network_of
from tmmcalc.gears.network.model import FRAME, Network

Amounts = dict[str, float]  # by member


@record
class GearingTask:
    """A train and what is known of its motion and load; outside torques are positive along positive speeds."""

    network: Network
    speeds: Amounts = quantity("known_speeds[rad/s]", "known speeds of members, 0: held")
    torques: Amounts = field(default_factory=dict)  # [N*m] from outside
    loads: Amounts = field(default_factory=dict)  # [N*m] against the motion
    powers: Amounts = field(default_factory=dict)  # [W] put in from outside
    locked: tuple[tuple[str, str], ...] = quantity("locked", "pairs of members that turn as one", default=())
    input: str | None = None
    outputs: tuple[str, ...] = ()
    shafts: tuple[str, ...] = ()  # that stand out of the gear box; empty: any that turns in the frame
    layout: str | None = quantity("layout", "key of the layout", default=None)
    teeth: tuple[int, ...] = ()  # of the layout's wheels
    planets: int = quantity("planets", "number of planets", symbol="K", default=1)
    remarks: tuple[str, ...] = ()  # what was taken for want of data


def layout_task(
    layout: str,
    teeth: Sequence[int],
    planets: int = 1,
    speeds: Mapping[str, float] | None = None,
    *,
    efficiency: float | Sequence[float] = 1.0,
    sharing: float = 1.0,
) -> GearingTask:
    """The train of a layout; a held wheel and a driver at 1 rad/s are added where ``speeds`` [rad/s] lack them.

    Raises `UsageError` for a wrong number of teeth.

    >>> task = layout_task("AIbar", (18, 48, 114), 3, {"H": 10.0})
    >>> task.speeds, task.shafts
    ({'3': 0.0, 'H': 10.0}, ('1', 'H', '3'))
    """
    train = network_of(layout, teeth, planets, efficiency, sharing)
    known, remarks = dict(speeds or {}), []
    free = 2 if train.fixed else 1
    if len(known) < free and not any(name in known for name in train.fixed):
        known = {**dict.fromkeys(train.fixed, 0.0), **known}
    if len(known) < free:
        driver = train.driver if train.driver not in known else train.output
        known[driver] = 1.0
        remarks.append(Phrase("no speed is known: {driver} turns at 1 rad/s", driver=driver))
    outputs = (train.output,) if train.output not in known and train.driver in known else ()
    shafts = (train.driver, train.output, *train.fixed)
    return GearingTask(
        train.network,
        known,
        outputs=outputs,
        shafts=shafts,
        layout=layout,
        teeth=tuple(int(z) for z in teeth),
        planets=planets,
        remarks=tuple(remarks),
    )


def ends(task: GearingTask) -> tuple[str | None, tuple[str, ...]]:
    """The member that drives, and those that are driven, as said or inferred; None and () where it is open."""
    known, moving = task.speeds, [name for name, speed in task.speeds.items() if speed]
    shafts = task.shafts or tuple(name for name in task.network.members if _is_shaft(task.network, name))
    outputs = task.outputs or tuple(dict.fromkeys(_loaded(task)))
    free = [name for name in shafts if name not in known and name != task.input]
    if not outputs and len(free) == 1 and len(moving) == 1:
        outputs = (free[0],)
    if task.input is not None:
        return task.input, outputs
    drivers = [name for name in moving if name not in outputs] or [name for name in free if name not in outputs]
    return drivers[0] if len(drivers) == 1 else None, outputs


def _loaded(task: GearingTask) -> Iterator[str]:
    """Members from which power is taken, and those of known torque without a known speed."""
    yield from task.loads
    yield from (name for name, power in task.powers.items() if power < 0)
    yield from (name for name in (*task.torques, *task.powers) if name not in task.speeds)


def _is_shaft(network: Network, name: str) -> bool:
    return network.bearer(name) == FRAME and network.count(name) == 1
