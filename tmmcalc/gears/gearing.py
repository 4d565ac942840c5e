"""A train that is written out: its speeds, ratios, torques, power flow and efficiency from what is known of it.

What is not said is inferred where only one answer is left: the driver is the member of known speed other than zero,
the driven one carries the load or is the only shaft without a speed. Without a load one unit of torque, 1 N*m, drives.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from math import copysign

import numpy as np

from tmmcalc.errors import NoSolutionError, UsageError
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.network.basic import BasicTrain, basic_train
from tmmcalc.gears.network.builder import network_of
from tmmcalc.gears.network.efficiency import efficiency
from tmmcalc.gears.network.frequencies import ROUNDED, MeshFrequencies, mesh_frequencies
from tmmcalc.gears.network.model import FRAME, WHERE, Network
from tmmcalc.gears.network.power import PowerFlow, power_in_motion
from tmmcalc.gears.network.speeds import Motion, ratio, solve_speeds
from tmmcalc.gears.network.types import efficiency as efficiency_of_type
from tmmcalc.numerics.extended import EPS
from tmmcalc.records import record

Amounts = dict[str, float]  # by member


@record
class GearingTask:
    """A train and what is known of its motion and load; outside torques are positive along positive speeds."""

    network: Network
    speeds: Amounts  # [rad/s], 0: held
    torques: Amounts = field(default_factory=dict)  # [N*m] from outside
    loads: Amounts = field(default_factory=dict)  # [N*m] against the motion
    powers: Amounts = field(default_factory=dict)  # [W] put in from outside
    locked: tuple[tuple[str, str], ...] = ()
    input: str | None = None
    outputs: tuple[str, ...] = ()
    shafts: tuple[str, ...] = ()  # that stand out of the gear box; empty: any that turns in the frame
    layout: str | None = None  # key
    teeth: tuple[int, ...] = ()  # of the layout's wheels
    planets: int = 1
    remarks: tuple[str, ...] = ()  # what was taken for want of data


@record
class Way:
    """One member drives another one, the held ones held."""

    driver: str
    output: str
    ratio: Fraction  # w_driver/w_output
    efficiency: float  # [-]; zero or negative: self-locking
    self_locking: bool
    potential: float  # largest rolling power of a mesh to the power put in [-]
    formula: float | None  # efficiency by the closed formula (textbook, table 4.6), where the train is of its kind
    error: float  # of the efficiency, relative to it or to 1, whichever is larger


@record
class Gearing:
    """A train in motion."""

    task: GearingTask
    motion: Motion
    input: str | None
    outputs: tuple[str, ...]
    turning: tuple[str, ...]  # members of given speed other than zero
    ways: tuple[Way, ...]  # forwards and backwards; empty without one driver and one output
    basic: BasicTrain | None  # the two central wheels and the carrier, if these are the train
    flow: PowerFlow | None  # None: torques are not known, or the train locks itself
    assumed: bool  # the torque on the input is 1 N*m for want of a known one
    locking: str  # why the load cannot be moved; empty if it can
    frequencies: MeshFrequencies
    assembly: Fraction | None  # of a layout with several planets: whole if they fit in equally spaced (4.25), (4.26)

    @property
    def error(self) -> dict[str, float]:
        """Relative errors of speeds, frequencies, torques, powers and efficiencies; ratios are exact."""
        found = {"speeds": EPS / 2, "frequencies": ROUNDED}
        etas = [way.error for way in self.ways]
        if self.flow is not None:
            found |= {"torques": self.flow.error.torques, "powers": self.flow.error.powers}
            etas.append(self.flow.error.efficiency)
        return found | ({"efficiency": max(etas)} if etas else {})

    def ratio_to(self, member: str) -> Fraction | None:
        """Exact ratio w_input/w_member; None where it stands, or the input is not the only one that sets speeds."""
        if self.input is None or len(self.turning) != 1:
            return None
        column = self.motion.driven.index(self.turning[0])
        place = self.task.network.place
        first, last = (self.motion.transfer[place[name]][column] for name in (self.input, member))
        return first / last if last else None


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
        remarks.append(f"no speed is known: {driver} turns at 1 rad/s")
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


def solve_gearing(task: GearingTask) -> Gearing:
    """Speeds, ratios, torques, powers and efficiency of a train.

    Raises `UsageError` where speeds or torques are undetermined or contradict each other, `NoSolutionError` where
    the train cannot turn.
    """
    network = task.network
    motion = solve_speeds(network, task.speeds, task.locked)
    driver, outputs = ends(task)
    turning = tuple(name for name in motion.driven if task.speeds[name])
    ways = _ways(task, motion, driver, outputs) if len(turning) == 1 else ()
    held = tuple(name for name in motion.driven if not task.speeds[name])
    basic = basic_train(network, held) if ways and not task.locked else None
    flow, assumed, locking = _flow(task, motion, driver, outputs, ways)
    return Gearing(
        task,
        motion,
        driver,
        outputs,
        turning,
        tuple(_with_formula(way, basic) for way in ways),
        basic,
        flow,
        assumed,
        locking,
        mesh_frequencies(network, motion),
        _assembly(task),
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


def _ways(task: GearingTask, motion: Motion, driver: str | None, outputs: tuple[str, ...]) -> tuple[Way, ...]:
    """Both directions of the power, where there is one driver and one output, and both turn."""
    if driver is None or len(outputs) != 1 or not (motion.speed(driver) and motion.speed(outputs[0])):
        return ()
    held = [name for name, speed in task.speeds.items() if not speed]
    ways = []
    for first, last in ((driver, outputs[0]), (outputs[0], driver)):
        found = efficiency(task.network, first, last, held, task.locked)
        exact = ratio(task.network, first, last, held, task.locked)
        ways.append(
            Way(
                first,
                last,
                exact,
                found.efficiency,
                found.self_locking,
                found.potential,
                None,
                found.flow.error.efficiency,
            )
        )
    return tuple(ways)


def _with_formula(way: Way, basic: BasicTrain | None) -> Way:
    if basic is None:
        return way
    named = {basic.first: "1", basic.carrier: "H"}
    if {way.driver, way.output} != {*named}:
        return way
    by_formula = efficiency_of_type(float(basic.ratio), basic.efficiency, "1" if way.driver == basic.first else "H")
    return replace(way, formula=float(by_formula))


def _flow(
    task: GearingTask, motion: Motion, driver: str | None, outputs: tuple[str, ...], ways: tuple[Way, ...]
) -> tuple[PowerFlow | None, bool, str]:
    """Torques and powers, whether the torque is assumed, and what locks the train."""
    torques = _torques(task, motion)
    sought = (*outputs, *(() if driver is None else (driver,)))
    assumed = not torques
    if assumed:
        if driver is None or not outputs or not motion.speed(driver):
            return None, False, ""
        torques = {driver: copysign(1.0, motion.speed(driver))}
    try:
        return power_in_motion(task.network, motion, torques, sought, task.locked), assumed, ""
    except UsageError:
        if not assumed:
            raise
        return None, False, ""  # one unit of torque does not tell how several ends share it
    except NoSolutionError as error:
        if not (ways and ways[0].self_locking):
            raise
        return None, False, error.message


def _torques(task: GearingTask, motion: Motion) -> Amounts:
    """All known outside torques [N*m]; raises `UsageError` for a load or power of a member that stands."""
    torques = dict(task.torques)
    for name, load in task.loads.items():
        torques[name] = -copysign(load, _speed(task, motion, name, "load")) if load else 0.0
    for name, power in task.powers.items():
        torques[name] = power / _speed(task, motion, name, "power") if power else 0.0
    return torques


def _speed(task: GearingTask, motion: Motion, name: str, what: str) -> float:
    speed = motion.speed(task.network.known(name))
    if speed:
        return speed
    raise UsageError(
        f"a {what} is known of {name!r}, which stands",
        where=WHERE,
        value=0.0,
        remedy=f"give its torque, or the {what} of a member that turns",
    )


def _assembly(task: GearingTask) -> Fraction | None:
    from tmmcalc.gears.search.measures import assembly_number

    if task.layout is None or task.planets < 2:
        return None
    count = len(task.teeth)
    sets = ToothSets(task.layout, np.array([task.teeth]), np.ones((1, 1), np.int64), np.zeros((1, count)), task.planets)
    if not sets.scheme.branched:
        return None
    return Fraction(float(assembly_number(sets)[0])).limit_denominator(10**6)
