"""Which planetary types suit a required ratio (textbook 4.4.1, 4.4.2).

Types AI and AI-bar (i_1H > 1) have a larger ratio than their inverted train and suit power drives; so does
2A-(AA-bar), of external wheels alone. AA with
i_1H < -1 has larger losses and is taken where internal wheels cannot be cut. With |i_1H| < 1 and the carrier driving,
AA and II reach any ratio with poor efficiency, for kinematic drives alone.
"""

from __future__ import annotations

import math

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.network import types
from tmmcalc.gears.network.types import WHERE, Driver

LARGEST_AII = 500.0  # ratio up to which the textbook commends type AII


@record
class Proposal:
    """A planetary type for a required ratio, and whether it suits."""

    layout: str
    driver: Driver
    output: str
    i_1h: float | None  # None: type AII, whose ratio does not follow from U
    tooth_ratio: float | None  # U
    efficiency: float | None  # [-]; zero or negative: self-locking
    self_locking: bool
    admissible: bool
    remark: str  # why it suits or does not


def proposals(
    required: float, power: bool = True, internal: bool = True, eta0: float = 0.95, planets: int = 3
) -> tuple[Proposal, ...]:
    """All types that give a required ratio w_in/w_out with its sign, the admissible ones of best efficiency first.

    ``power``: a power drive, or a kinematic one; ``internal``: internal wheels can be cut; ``eta0``: efficiency of an
    inverted train of two meshes [-]. Raises `UsageError` unless the ratio is finite and not zero.

    >>> [(p.layout, p.driver) for p in proposals(-7.15, internal=False) if p.admissible]
    [('AA', '1')]
    """
    if not (math.isfinite(required) and required):
        raise UsageError(f"the required ratio is {required:g}", where=WHERE, remedy="finite and not zero")
    drivers: tuple[Driver, Driver] = ("1", "H")
    of_ratio = sorted((scheme for scheme in LAYOUTS.values() if scheme.sign), key=lambda scheme: -scheme.sign)
    simple = [
        _simple(scheme.key, driver, i, power, internal, eta0, planets)
        for scheme in of_ratio
        for driver in drivers
        if float(types.tooth_ratio(scheme.key, i := required if driver == "1" else 1 / required)) > 0
    ]
    found = simple + ([_three_central(internal)] if 1 < abs(required) <= LARGEST_AII else [])
    return tuple(sorted(found, key=lambda p: (not p.admissible, p.efficiency is None, -(p.efficiency or 0.0))))


def _simple(layout: str, driver: Driver, i: float, power: bool, internal: bool, eta0: float, planets: int) -> Proposal:
    u, inverted = float(types.tooth_ratio(layout, i)), eta0 ** (len(LAYOUTS[layout].meshes) / 2)
    eta = float(types.efficiency(i, inverted, driver))
    locks = bool(types.self_locking(i, inverted, driver))
    fault = _fault(layout, i, u, locks, power, internal, planets)
    output = "H" if driver == "1" else "1"
    remark = fault or _merit(i)
    return Proposal(layout, driver, output, i, u, eta, locks, not fault, remark)


def _fault(layout: str, i: float, u: float, locks: bool, power: bool, internal: bool, planets: int) -> str:
    """Why a type does not suit; empty if it does."""
    if locks:
        return "locks itself"
    if LAYOUTS[layout].rings and not internal:
        return "needs internal wheels"
    if LAYOUTS[layout].stages == 1 and (fault := _single_planet_fault(u, planets)):
        return fault
    if not power or i > 1:
        return ""
    if -1 <= i < 1:
        return f"i_1H = {i:.4g} lies between -1 and 1: for kinematic drives alone"
    if LAYOUTS[layout].rings:
        return "losses above those of the inverted train"
    return "losses above those of the inverted train: only where internal wheels cannot be cut" if internal else ""


def _single_planet_fault(u: float, planets: int) -> str:
    """What forbids U, of both central wheels, to single planets about a sun (4.24), (4.33)."""
    if u <= 1:
        return f"U = {u:.4g} is not above 1"
    s = math.sin(math.pi / planets) if planets > 2 else 1.0
    largest = (1 + s) / (1 - s) if planets > 2 else math.inf
    return f"{planets} planets stand side by side up to U = {largest:.4g}, not {u:.4g}" if u >= largest else ""


def _merit(i: float) -> str:
    if i > 1:
        return "suits power drives"
    return "kinematic drive" if i >= -1 else "losses above those of the inverted train"


def _three_central(internal: bool) -> Proposal:
    remark = "efficiency by its tooth numbers; 0.8 to 0.9 by the textbook" if internal else "needs internal wheels"
    layout = next(layout for layout in LAYOUTS.values() if layout.three_centrals)
    return Proposal(layout.key, "1", layout.output, None, None, None, False, internal, remark)
