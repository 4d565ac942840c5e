"""Efficiency of a train by the losses of its meshes, for either direction of the power.

The driver turns and drives with unit torque; equilibrium with losses gives the torque of the output. Its power may
come out positive: then no load at all can be moved, both ends put power in and -P_out/P_in is zero or negative. This
is self-locking, with the number that the closed formulas give (textbook, table 4.6).
"""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.network.model import WHERE, Network
from tmmcalc.gears.network.power import PowerFlow, power_in_motion
from tmmcalc.gears.network.speeds import Locks, solve_speeds


@record
class DriveEfficiency:
    """Efficiency of a train with one driver and one output, at unit speed and torque of the driver."""

    driver: str
    output: str
    efficiency: float  # [-]; zero or negative: self-locking
    self_locking: bool
    potential: float  # largest rolling power of a mesh to the power put in [-]
    flow: PowerFlow


def efficiency(
    network: Network, driver: str, output: str, fixed: str | Sequence[str] = (), locked: Locks = ()
) -> DriveEfficiency:
    """Efficiency from driver to output with members fixed.

    Raises `NoSolutionError` if the output stands, and what `solve_speeds` and `power_in_motion` raise.

    >>> from tmmcalc.gears.network.builder import network_of
    >>> train = network_of("AIbar", (18, 48, 114), efficiency=0.97)
    >>> round(efficiency(train.network, "1", "H", fixed="3").efficiency, 6)
    0.948959
    """
    held = (fixed,) if isinstance(fixed, str) else tuple(fixed)
    motion = solve_speeds(network, {**dict.fromkeys(held, 0.0), driver: 1.0}, locked)
    if motion.speed(network.known(output)) == 0:
        raise NoSolutionError(
            f"the output {output!r} stands while {driver!r} turns",
            where=WHERE,
            value=0.0,
            remedy="its ratio is zero: change the tooth numbers, or take another output",
        )
    flow = power_in_motion(network, motion, {driver: 1.0}, (output,), locked)
    value = -flow.power(output) / flow.power(driver) + 0.0
    potential = float(abs(flow.rolling).max(initial=0.0)) / flow.power(driver)
    return DriveEfficiency(driver, output, value, value <= 0, potential, flow)
