"""The tables of a train in motion: its members, and its meshes by torque, by power and by frequency.

Wheels of a mesh are 1 and 2 in the order in which it names them, c is the member that keeps their axes apart.
"""

from __future__ import annotations

import math
from typing import Any

from tmmcalc.gears.gearing import Gearing
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.power import PowerFlow

Columns = dict[str, list[Any]]


def member_columns(result: Gearing) -> Columns:
    """Speeds of all members, absolute and against their own carriers, the ratio of the input to each, torques, powers.

    Where a member stands the ratio is blank.
    """
    motion, network = result.motion, result.task.network
    ratios = [result.ratio_to(name) for name in motion.members]
    columns: Columns = {
        "member": list(motion.members),
        "n[rpm]": _rpm(motion.speeds),
        "n_rel[rpm]": _rpm(motion.relative),
    }
    if any(ratio is not None for ratio in ratios):
        columns["i"] = ["" if ratio is None else float(ratio) for ratio in ratios]
    if result.flow is not None:
        columns |= {"torque[N*m]": result.flow.torques.tolist(), "power[W]": result.flow.powers.tolist()}
    columns |= {
        "omega[rad/s]": motion.speeds.tolist(),
        "omega_rel[rad/s]": motion.relative.tolist(),
        "count": [network.count(name) for name in motion.members],
        "carrier": [network.bearer(name) for name in motion.members],
    }
    if "i" in columns:
        columns["i exact"] = ["" if ratio is None else str(ratio) for ratio in ratios]
    return columns


def torque_columns(result: Gearing, flow: PowerFlow) -> Columns:
    """Torques that each mesh puts on its wheels and its carrier, and on those of the most loaded planet."""
    meshes = result.task.network.meshes
    return {
        **_named(result),
        "eta": [mesh.efficiency for mesh in meshes],
        **_split("T_{}[N*m]", ("1", "2", "c"), flow.mesh_torques),
        **_split("T_{}_planet[N*m]", ("1", "2"), flow.branch_torques),
    }


def power_columns(result: Gearing, flow: PowerFlow) -> Columns:
    """Rolling power of each mesh, its loss, and the powers that it gives to wheels and carrier in the frame."""
    return {
        **_named(result),
        "P_roll[W]": flow.rolling.tolist(),
        "loss[W]": flow.losses.tolist(),
        **_split("P_{}[W]", ("1", "2", "c"), flow.mesh_powers),
    }


def frequency_columns(result: Gearing) -> Columns:
    """Frequencies of teeth in mesh, of turns in the carrier, of a damaged tooth, of the same two teeth."""
    found = result.frequencies
    return {
        **_named(result, carrier=False),
        "f_mesh[Hz]": found.mesh.tolist(),
        **_split("turns_{}[Hz]", ("1", "2"), found.turns),
        **_split("tooth_{}[Hz]", ("1", "2"), found.passes),
        "pair[Hz]": found.hunting.tolist(),
        "gcd": found.common.tolist(),
    }


def _rpm(speeds: Values) -> list[float]:
    return [float(speed) / (math.pi / 30) for speed in speeds]


def _named(result: Gearing, carrier: bool = True) -> Columns:
    network = result.task.network
    named: Columns = {"mesh": [str(mesh) for mesh in network.meshes]}
    return named | {"c": list(network.carriers)} if carrier else named


def _split(header: str, names: tuple[str, ...], values: Values) -> Columns:
    return {header.format(name): values[:, k].tolist() for k, name in enumerate(names)}
