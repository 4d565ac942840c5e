"""Frequencies at which the teeth of a moving train meet.

A pair of wheels meets tooth by tooth at z |w - wc| / 2 pi, counted in the carrier of the mesh. A given tooth of a
central wheel is met by each of the K planets; a given pair of teeth meets again after the least common multiple of
both tooth numbers, the longer the better for even wear (hunting tooth).
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, Values
from tmmcalc.gears.network.model import Network
from tmmcalc.gears.network.speeds import Motion

ROUNDED = 5 * EPS / 2  # of a speed, 2 pi, their quotient, teeth and their multiple


@record
class MeshFrequencies:
    """Frequencies of the m meshes and n members of a train [Hz]."""

    mesh: Values = quantity("f_mesh[Hz]", "frequency of teeth in mesh")  # (m,)
    turns: Values = quantity("turns_{wheel}[Hz]", "turns of the wheel in the carrier")  # (m, 2)
    passes: Values = quantity(  # (m, 2)
        "tooth_{wheel}[Hz]", "meetings of one tooth with all partners: frequency of a damaged tooth"
    )
    hunting: Values = quantity("pair[Hz]", "meetings of the same two teeth")  # (m,)
    recurrence: Integers  # (m, 2) turns of each wheel between them
    common: Integers = quantity(  # (m,)
        "gcd", "greatest common divisor of the tooth numbers; 1: every tooth meets every other"
    )
    shafts: Values  # (n,) turns of the members in the frame; of a tilted planet in its carrier


def mesh_frequencies(network: Network, motion: Motion) -> MeshFrequencies:
    """Frequencies of a train in motion [Hz]."""
    teeth = np.array([[m.first_teeth, m.second_teeth] for m in network.meshes], dtype=np.int64).reshape(-1, 2)
    common = np.gcd(teeth[:, 0], teeth[:, 1])
    multiple = teeth[:, 0] // common * teeth[:, 1]
    turns = np.abs(motion.rolling) / (2 * math.pi)
    mesh = teeth[:, 0] * turns[:, 0]
    return MeshFrequencies(
        mesh,
        turns,
        turns * _partners(network),
        mesh / multiple,
        multiple[:, None] // teeth,
        common,
        np.abs(motion.speeds) / (2 * math.pi),
    )


def _partners(network: Network) -> Integers:
    """Wheels (m, 2) that each one meets in a mesh: a sun all planets, a planet one sun."""
    counts = [[network.count(m.first), network.count(m.second)] for m in network.meshes]
    own = np.array(counts, dtype=np.int64).reshape(-1, 2)
    return np.maximum(own[:, ::-1] // own, 1)
