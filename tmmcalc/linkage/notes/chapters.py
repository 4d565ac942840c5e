"""The chapters of the note on a linkage, a stage each."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.notes.forces import forces_blocks
from tmmcalc.linkage.notes.kinematics import kinematics_blocks
from tmmcalc.linkage.notes.structure import structure_blocks
from tmmcalc.linkage.notes.told import Told, told_of
from tmmcalc.linkage.pictures.cycle import along, closed
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.manuscript import Block


def structure(order: Order) -> Iterator[Block]:
    """Links, pairs, mobility, groups."""
    return structure_blocks(_mechanism(order), order.results["structure"])


def kinematics(order: Order) -> Iterator[Block]:
    """Positions, velocities and accelerations at the chosen positions."""
    return kinematics_blocks(_told(order))


def forces(order: Order) -> Iterator[Block]:
    """Reactions and the drive at the chosen positions."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading

    return forces_blocks(_told(order), to_loading(order.spec), order.results["forces"])


def _mechanism(order: Order) -> Mechanism:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return to_linkage(order.spec.linkage)


def _told(order: Order) -> Told:
    mechanism, result = _mechanism(order), order.results["kinematics"]
    asked = order.rows(POSITIONS, result.labels)
    return told_of(mechanism, result, asked or by_default(mechanism, result))


def by_default(mechanism: Mechanism, result: Kinematics) -> list[int]:
    """One position of the working stroke of the first output and one of the idle stroke, in the middle of each."""
    first: Any = result.summaries[0] if result.summaries else None
    last = float(result.phi[-1])
    if first is None or first.working_angle is None or first.idle_angle is None:
        places = np.array([last / 4, 3 * last / 4])
    else:
        sense = np.sign(result.speed)
        start = along(result, first.dead_centres[0].x, closed(chain_of(mechanism, result)))
        middle = start + sense * first.working_angle / 2
        places = np.array([middle, start + sense * (first.working_angle + first.idle_angle / 2)])
    apart = np.abs(result.phi - places[:, None])
    if result.turns:
        apart = np.abs(np.angle(np.exp(1j * apart)))
    return list(dict.fromkeys(np.argmin(apart, axis=1).tolist()))
