"""A whole turn of the crank, followed from position 1 by prediction to the second order and Newton's method.

The group has up to six assemblies at one angle of the crank, so nothing but the way from the dwell tells which one is
meant. A linkage is refused if Newton's method fails, if its determinant changes its sign (a singular position: the
crank stops, or assemblies meet), if it does not come back after a turn, or if S is not zero again in positions 2 and 3.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import Flags, Linkages, only_first
from tmmcalc.linkage.synthesis.dwell.motion import Unknowns, closed, foretold, rates

TURN = 2 * np.pi
STEPS = 180  # of a turn
FINER = 8
SAME = 1e-7  # differences of the unknowns after a turn, and of S from zero, that are rounding
JUMP = 0.2  # of Newton's correction to a foretold place: beyond it another assembly was met [rad, parts of l_OB]
REASONS = (
    "crank does not turn fully",
    "singular position within the turn",
    "another assembly after a turn",
    "output not at dwell in positions 2 and 3",
)


class Turn(NamedTuple):
    """The motion of k linkages at n angles of the crank from position 1 on, and which of m candidates they are."""

    linkages: Linkages  # (k,)
    phi: Real  # (n,) from 0 to a turn [rad], counter-clockwise from position 1
    state: Unknowns  # each (n, k)
    which: Flags  # (k,) indices among the candidates
    faults: dict[str, Flags]  # (m,) by reason


def whole_turn(linkages: Linkages, steps: int = STEPS) -> Turn:
    """Follow m linkages over a turn; those that do not make it are left out, each with its reason."""
    m = linkages.phi0.size
    phi = np.linspace(0.0, TURN, steps + 1)
    step = TURN / steps
    faults = {reason: np.zeros(m, bool) for reason in REASONS}
    which = np.arange(m)
    state, det = rates(linkages, linkages.phi0, linkages.theta0, np.zeros(m))
    sign = np.sign(det)
    history = [np.array(state)]
    running = linkages
    for k in range(1, steps + 1):
        guess = foretold(state, step)
        theta, s, done = closed(running, running.phi0 + phi[k], *guess)
        done &= (np.abs(theta - guess[0]) < JUMP) & (np.abs(s - guess[1]) < JUMP)
        state, det = rates(running, running.phi0 + phi[k], theta, s)
        regular = np.sign(det) == sign
        faults[REASONS[0]][which[~done]] = True
        faults[REASONS[1]][which[done & ~regular]] = True
        keep = done & regular
        if not keep.all():
            which, sign, running = which[keep], sign[keep], running.rows(keep)
            state = Unknowns(*(part[keep] for part in state))
            history = [rows[:, keep] for rows in history]
        history.append(np.array(state))
        if not which.size:
            break
    found = Unknowns(*np.moveaxis(np.array(history), 1, 0))
    return _checked(Turn(running, phi, found, which, faults))


def patient_turn(linkages: Linkages, steps: int = STEPS) -> Turn:
    """The turn of one linkage, with finer steps where it fails: it may only pass close to a singular position."""
    turn = whole_turn(linkages, steps)
    return turn if turn.which.size else whole_turn(linkages, FINER * steps)


def _checked(turn: Turn) -> Turn:
    """Leave out the linkages that end elsewhere, or are not at dwell in positions 2 and 3."""
    if not turn.which.size:
        return turn
    state, phi = turn.state, turn.phi
    back = np.abs(np.sin((state.theta[-1] - state.theta[0]) / 2)) < SAME
    back &= np.abs(state.s[-1] - state.s[0]) < SAME
    rests = np.ones(turn.which.size, bool)
    for at in turn.linkages.turns[1:]:
        rests &= np.abs(place(turn, at).s) < SAME
    found = only_first({REASONS[2]: ~back, REASONS[3]: ~rests})
    for reason, flags in found.items():
        turn.faults[reason][turn.which[flags]] = True
    keep = back & rests
    rows = Unknowns(*(part[:, keep] for part in state))
    return Turn(turn.linkages.rows(keep), phi, rows, turn.which[keep], turn.faults)


def place(turn: Turn, at: Real) -> Unknowns:
    """The states (k,) at angles ``at`` (k,) from position 1, one of each linkage."""
    step = turn.phi[1]
    row = np.rint(np.mod(at, TURN) / step).astype(int)
    near = Unknowns(*(part[row, np.arange(len(row))] for part in turn.state))
    return _settled(turn.linkages, turn.linkages.phi0 + at, near, np.mod(at, TURN) - row * step)


def along(turn: Turn, at: Real) -> Unknowns:
    """The states (n,) at angles ``at`` (n,) from position 1, of a turn of one linkage."""
    step = turn.phi[1]
    row = np.rint(np.mod(at, TURN) / step).astype(int)
    near = Unknowns(*(part[row, 0] for part in turn.state))
    return _settled(turn.linkages, turn.linkages.phi0 + at, near, np.mod(at, TURN) - row * step)


def _settled(linkages: Linkages, phi: Real, near: Unknowns, step: Real) -> Unknowns:
    theta, s, _ = closed(linkages, phi, *foretold(near, step))
    return rates(linkages, phi, theta, s)[0]
