"""Which positions of a linkage are worked out: those that are asked for, or one of each stroke that tells most.

A position tells little where what is shown is nothing: where a link stands along an axis or in line with another one,
where a pair is at rest, so that its friction jumps, where no load acts. So the position nearest to the middle of the
stroke is taken in which nothing of it is so; where the loads act in neither of both, the first gives place to that in
which they do most.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.forces.wrench import sliding
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.pictures.choice import from_parts
from tmmcalc.linkage.pictures.cycle import motion_at
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.report.drawing.order import POSITIONS, Order

MIDDLES = ((1 / 2,), (1 / 2,))  # parts of the working and of the idle stroke
IDLE = 1e-9  # of the largest power of the loads: where they have less they do not act
NEXT = 1e-3  # of its largest, or a sine: what is less is next to nothing
EQUAL = 1e-6  # [rad or m] distances that differ less are equal


def rows_shown(order: Order, chain: Chain, result: Kinematics) -> list[int]:
    """Rows of the kinematics that are asked for, or one of each stroke."""
    return order.rows(POSITIONS, result.labels) or _by_default(order, chain, result)


def _by_default(order: Order, chain: Chain, result: Kinematics) -> list[int]:
    """One row of each stroke."""
    clear, power = _clear_rows(chain, result), _power(order, chain, result)
    most = float(np.max(power))
    candidates = np.flatnonzero(clear) if clear.any() else np.arange(len(clear))
    rows = []
    for apart in from_parts(chain, result, *MIDDLES)[:, candidates]:
        nearest = np.flatnonzero(apart <= np.min(apart) + EQUAL)
        rows.append(int(candidates[nearest[np.argmax(power[candidates[nearest]])]]))
    if most > 0.0 and not np.any(power[rows] > IDLE * most):
        loaded = candidates if np.any(power[candidates] > IDLE * most) else np.arange(len(clear))
        rows[0] = int(loaded[np.argmax(power[loaded])])
    return list(dict.fromkeys(rows))


def _clear_rows(chain: Chain, result: Kinematics) -> np.ndarray:
    """Which rows (n,) have no link along an axis or in line with its neighbour, and no pair at rest."""
    configuration = motion_at(chain, result.x).configuration
    found = np.ones(len(result.x), bool)
    trace = result.trace
    turning = {link: k for k, link in enumerate(trace.link_ids) if np.any(trace.dangle[k])}
    for k in turning.values():
        found &= np.abs(np.sin(2 * trace.angle[k])) > NEXT
    for joint in chain.mechanism.joints:
        rate = np.abs(np.broadcast_to(sliding(joint, configuration)[0], result.x.shape))
        found &= (rate > NEXT * np.max(rate)) | (np.max(rate) == 0.0)
        low, high = joint.links
        if joint.kind == "revolute" and low in turning and high in turning:
            between = trace.angle[turning[low]] - trace.angle[turning[high]]
            found &= (np.abs(np.sin(between)) > NEXT) | (np.ptp(between) < NEXT)
    return found


def _power(order: Order, chain: Chain, result: Kinematics) -> Real:
    """What the technological loads do in every row (n,)."""
    loading = to_loading(order.spec)
    if not loading.loads:
        return np.zeros(len(result.x))
    scene = compile_scene(chain.mechanism, loading, result)
    theta, labels = scene.travel.rows(result)
    own = [labels.index(label) for label in result.labels]
    return scene.loaded(scene.place(theta[own], scene.travel.sides(theta[own])))
