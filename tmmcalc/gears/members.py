"""The tables of a train in motion: its members, and its meshes by torque, by power and by frequency.

Wheels of a mesh are 1 and 2 in the order in which it names them, c is the member that keeps their axes apart.
"""

from __future__ import annotations

from typing import Any

from tmmcalc.core.quantity import Quantity, components, headed
from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.network.power import PowerFlow

Columns = dict[str, list[Any]]

RATIO = Quantity("i", "speed of the input over that of the member")
COUNT = Quantity("count", "how many members of this name there are, planets or layshafts")


def member_columns(result: Gearing, people: bool = False) -> Columns:
    """Speeds of all members, absolute and against their own carriers, the ratio of the input to each, torques, powers.

    Where a member stands the ratio is blank. For people the speeds are in rpm.
    """
    motion, network = result.motion, result.task.network
    ratios = [result.ratio_to(name) for name in motion.members]
    columns: Columns = {
        "member": list(motion.members),
        **_listed(headed(motion, *(("turns", "relative_turns") if people else ("speeds", "relative")))),
    }
    if any(ratio is not None for ratio in ratios):
        columns[RATIO.key] = ["" if ratio is None else float(ratio) for ratio in ratios]
    if result.flow is not None:
        columns |= _listed(headed(result.flow, "torques", "powers"))
    columns |= {
        COUNT.key: [network.count(name) for name in motion.members],
        "carrier": [network.bearer(name) for name in motion.members],
    }
    if RATIO.key in columns:
        columns["i exact"] = ["" if ratio is None else str(ratio) for ratio in ratios]
    return columns


def torque_columns(result: Gearing, flow: PowerFlow) -> Columns:
    """Torques that each mesh puts on its wheels and its carrier, and on those of the most loaded planet."""
    meshes = result.task.network.meshes
    return {
        **_named(result),
        "eta": [mesh.efficiency for mesh in meshes],
        **_listed(components(flow, "mesh_torques", member="12c")),
        **_listed(components(flow, "branch_torques", member="12")),
    }


def power_columns(result: Gearing, flow: PowerFlow) -> Columns:
    """Rolling power of each mesh, its loss, and the powers that it gives to wheels and carrier in the frame."""
    return {
        **_named(result),
        **_listed(headed(flow, "rolling", "losses")),
        **_listed(components(flow, "mesh_powers", member="12c")),
    }


def frequency_columns(result: Gearing) -> Columns:
    """Frequencies of teeth in mesh, of turns in the carrier, of a damaged tooth, of the same two teeth."""
    found = result.frequencies
    return {
        **_named(result, carrier=False),
        **_listed(headed(found, "mesh")),
        **_listed(components(found, "turns", wheel="12")),
        **_listed(components(found, "passes", wheel="12")),
        **_listed(headed(found, "hunting", "common")),
    }


def _named(result: Gearing, carrier: bool = True) -> Columns:
    network = result.task.network
    named: Columns = {"mesh": [str(mesh) for mesh in network.meshes]}
    return named | {"c": list(network.carriers)} if carrier else named


def _listed(columns: dict[str, Any]) -> Columns:
    return {header: column.tolist() for header, column in columns.items()}
