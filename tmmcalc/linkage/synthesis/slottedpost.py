"""What the two slotted links share: the mechanism of their sizes, its simulation, and the checks of it."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.records import record
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.synthesis.builders import slotted_link
from tmmcalc.linkage.synthesis.designs import scene_of
from tmmcalc.linkage.synthesis.results import Check
from tmmcalc.linkage.synthesis.simulation import Simulation, Tilt, check, simulate, tilts
from tmmcalc.linkage.synthesis.task import RotatingTask, SlottedTask, SynthesisTask

ROD = 4  # the connecting rod among the links

Lengths = tuple[float, float, float, float, float]  # crank, line of centres, arm, rod, guide [m]


@record
class Checked:
    """A slotted link that was simulated, and its rod's pressure angles on the working and on the idle stroke."""

    mechanism: Mechanism
    simulation: Simulation
    both: tuple[Tilt, Tilt]
    pressure: float  # the largest of all [rad]


def checked(task: SynthesisTask, lengths: Lengths) -> Checked:
    """Simulate the slotted link of these lengths."""
    asked: SlottedTask | RotatingTask = task.asked
    scene = scene_of(task, asked.stroke, asked.time_ratio, Output("E", resistance="positive"))
    mechanism = slotted_link(*lengths, scene)
    found = simulate(mechanism)
    both = tilts(found, ROD, 1 + 0j)
    return Checked(mechanism, found, both, max(tilt.largest for tilt in both))


def checks(asked: SlottedTask | RotatingTask, found: Checked) -> Iterator[Check]:
    """Stroke, time ratio and pressure angles of the simulation against what was asked."""
    working, idle = found.both
    yield check("S", found.simulation.stroke, "m", asked.stroke)
    yield check("K", found.simulation.time_ratio, "-", asked.time_ratio)
    yield check("nu_max", found.pressure, "rad", asked.pressure)
    yield check("largest pressure angle working", working.largest, "rad")
    yield check("largest pressure angle idle", idle.largest, "rad")
