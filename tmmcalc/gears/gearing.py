"""A train that is written out: its speeds, ratios, torques, power flow and efficiency from what is known of it.

Without a load one unit of torque, 1 N*m, drives.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import copysign

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.gearingtask import Amounts, GearingTask, ends
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.network.basic import BasicTrain, basic_train
from tmmcalc.gears.network.efficiency import efficiency
from tmmcalc.gears.network.frequencies import ROUNDED, MeshFrequencies, mesh_frequencies
from tmmcalc.gears.network.model import WHERE
from tmmcalc.gears.network.power import PowerFlow, power_in_motion
from tmmcalc.gears.network.speeds import Motion, ratio, solve_speeds
from tmmcalc.gears.network.types import efficiency as efficiency_of_type


@record
class Drive:
    """One member drives another one, the held ones held."""

    driver: str
    output: str
    ratio: Fraction  # w_driver/w_output
    efficiency: float = quantity("eta_{way}", "efficiency, {way}; zero or negative: self-locking")
    self_locking: bool = quantity("self_locking_{way}", "whether no load can be moved this way: {way}")
    potential: float = quantity("rolling_{way}", "largest rolling power of a mesh to the power put in, {way}")
    formula: float | None = quantity(  # None: the train is of another kind
        "eta_formula_{way}", "efficiency by the closed formula, {way}", source="table 4.6"
    )
    error: float  # of the efficiency, relative to it or to 1, whichever is larger


@record
class Gearing:
    """A train in motion."""

    task: GearingTask
    motion: Motion
    input: str | None
    outputs: tuple[str, ...]
    turning: tuple[str, ...]  # members of given speed other than zero
    ways: tuple[Drive, ...]  # forwards and backwards; empty without one driver and one output
    basic: BasicTrain | None  # the two central wheels and the carrier, if these are the train
    flow: PowerFlow | None  # None: torques are not known, or the train locks itself
    assumed: bool = quantity("torque_is_assumed", "the torque on the input is 1 N*m for want of a known one")
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


def _ways(task: GearingTask, motion: Motion, driver: str | None, outputs: tuple[str, ...]) -> tuple[Drive, ...]:
    """Both directions of the power, where there is one driver and one output, and both turn."""
    if driver is None or len(outputs) != 1 or not (motion.speed(driver) and motion.speed(outputs[0])):
        return ()
    held = [name for name, speed in task.speeds.items() if not speed]
    ways = []
    for first, last in ((driver, outputs[0]), (outputs[0], driver)):
        found = efficiency(task.network, first, last, held, task.locked)
        exact = ratio(task.network, first, last, held, task.locked)
        ways.append(
            Drive(
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


def _with_formula(way: Drive, basic: BasicTrain | None) -> Drive:
    if basic is None:
        return way
    named = {basic.first: "1", basic.carrier: "H"}
    if {way.driver, way.output} != {*named}:
        return way
    by_formula = efficiency_of_type(float(basic.ratio), basic.efficiency, "1" if way.driver == basic.first else "H")
    return replace(way, formula=float(by_formula))


def _flow(
    task: GearingTask, motion: Motion, driver: str | None, outputs: tuple[str, ...], ways: tuple[Drive, ...]
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
