"""Which positions a scheme shows, and which of them with main lines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.pictures.bodies import LinkOutline, bodies
from tmmcalc.linkage.pictures.cycle import LinkageMotion, along, closed, motion_at
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics

DRAWN = 24  # positions drawn by default
NEAR = 8  # a clearer position is looked for within this part of the positions
APART = 0.05  # pins closer than this part of the mechanism's reach cover each other
BESIDE = 0.02  # and so do a pin and a link that it does not belong to
WHOLE = (1 / 4, 3 / 4)  # of the motion, where it has no strokes


def chosen(
    cycle: LinkageMotion, result: Kinematics, positions: Sequence[int] | None, marked: Sequence[int] = ()
) -> list[int]:
    """Positions to draw, the highlighted one first: the first of those ``marked``, which have plans.

    By default that is the middle of the working stroke of the first output, else a quarter of the way, or the
    nearest position beside it in which no pin covers another or stands on a link that it does not belong to.
    """
    if positions:
        return list(dict.fromkeys(positions))
    main = marked[0] if marked else _clear(cycle, result, _telling(result, closed(cycle.chain)))
    count = len(result.x)
    others = range(count) if count <= DRAWN + 1 else np.linspace(0, count - 1, DRAWN + 1).astype(int).tolist()
    return [main, *(k for k in others if k != main)]


def at_parts(chain: Chain, result: Kinematics, working: Sequence[float], idle: Sequence[float] = ()) -> list[int]:
    """The positions nearest to these parts of the working and of the idle stroke of the first output."""
    return list(dict.fromkeys(np.argmin(from_parts(chain, result, working, idle), axis=1).tolist()))


def from_parts(chain: Chain, result: Kinematics, working: Sequence[float], idle: Sequence[float] = ()) -> np.ndarray:
    """How far (k, n) every position is from these parts of the strokes, [rad or m]."""
    first = result.summaries[0] if result.summaries else None
    if first is None or first.working_angle is None or first.idle_angle is None:
        places = float(result.phi[-1]) * np.array(WHOLE)
    else:
        angles = [part * first.working_angle for part in working]
        angles += [first.working_angle + part * first.idle_angle for part in idle]
        start = along(result, first.dead_centres[0].x, closed(chain))
        places = start + math.copysign(1.0, result.speed) * np.array(angles)
    apart = np.abs(result.phi - places[:, None])
    if result.turns:
        apart = np.abs(np.angle(np.exp(1j * apart)))
    return apart


def _telling(result: Kinematics, full: bool) -> int:
    """The position nearest to the middle of the working stroke of the first output, else to a quarter of the way."""
    phi = result.phi
    first = result.summaries[0] if result.summaries else None
    if first is not None and first.working_angle is not None:
        start = along(result, first.dead_centres[0].x, full)
        target = start + math.copysign(first.working_angle / 2, result.speed)
        return int(np.argmax(np.cos(phi - target)))
    return int(np.argmin(np.abs(phi - phi[np.argmax(np.abs(phi))] / 4)))


def _clear(cycle: LinkageMotion, result: Kinematics, position: int) -> int:
    """The nearest clear position, not far off; else the same position."""
    motion = motion_at(cycle.chain, result.x)
    clear = _clearances(motion, cycle)
    near = sorted(range(len(result.x)), key=lambda k: abs(k - position))[: 1 + 2 * len(result.x) // NEAR]
    return next((k for k in near if clear[k]), position)


def _clearances(motion: LinkageMotion, cycle: LinkageMotion) -> np.ndarray:
    """Which positions (n,) are clear."""
    mechanism = motion.chain.mechanism
    pins = [pin for pin in find_pins(mechanism) if pin.joints]
    places = {pin: motion.place(*next(iter(pin.at.items()))) for pin in pins}
    everything = np.array(list(places.values()))
    reach = float(np.max(np.abs(everything - everything.mean())))
    clear = np.ones(motion.x.shape, bool)
    for one, other in combinations(pins, 2):
        clear &= np.abs(places[one] - places[other]) > APART * reach
    for body in bodies(mechanism, tuple(find_pins(mechanism)), cycle, 0.0):
        for pin in pins:
            if _apart(mechanism, pin, body):
                clear &= _distances(motion, body, places[pin]) > BESIDE * reach
    return clear


def _apart(mechanism: Mechanism, pin: Pin, body: LinkOutline) -> bool:
    """Whether a pin neither belongs to a link nor slides on it."""
    own = set(pin.at) - {FRAME}
    slides = any(
        joint.kind == "prismatic" and body.link in joint.links and own & set(joint.links) for joint in mechanism.joints
    )
    return body.link not in pin.at and not slides


def _distances(motion: LinkageMotion, body: LinkOutline, place: np.ndarray) -> np.ndarray:
    """Distances (n,) of a point from the lines of a link."""
    least = np.full(motion.x.shape, np.inf)
    for a, b in (
        tuple(motion.place(body.link, p) for p in segment) for segment in body.segments if segment[0] != segment[1]
    ):
        t = np.clip(((place - a) / (b - a)).real, 0.0, 1.0)
        least = np.minimum(least, np.abs(a + t * (b - a) - place))
    return least


def check_positions(count: int, positions: Sequence[int]) -> None:
    """Raise `UsageError` for the index of a position that is not among ``count``."""
    for k in positions:
        if not 0 <= k < count:
            raise UsageError(f"there is no position {k}", where="plot", remedy=f"indices: 0 to {count - 1}")
