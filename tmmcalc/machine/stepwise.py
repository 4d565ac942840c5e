"""The textbook's recurrence step by step (3.57): every term at every position, turn by turn, loaded and idle.

    w_i^2 = (kept_i + gained_i) / divisor_i
    kept_i = (J_(i-1) - B dphi) w_(i-1)^2     gained_i = (M_(i-1) + M_i + 2 A) dphi     divisor_i = J_i + B dphi

Its data are those of the motion: A and B of the motor's parabola, moments and inertias at the positions.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, partial

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.recurrence import Nodes, factors, march, multiplier, on_nodes, periodic, turns
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.textbook import NodalRegime, Turn

MOMENT = Quantity("step_M[N*m]", "reduced moment of the loads at the node, the larger one at a jump", source="(3.57)")
INERTIA = Quantity("step_J[kg*m^2]", "all inertia at the node, the constant one with that of the links")
KEPT = Quantity("step_kept[J]", "(J_(i-1) - B dphi) omega_(i-1)^2: what is kept of the node before", source="(3.57)")
GAINED = Quantity("step_gained[J]", "(M_(i-1) + M_i + 2 A) dphi: what moments add on the step", source="(3.57)")
DIVISOR = Quantity("step_divisor[kg*m^2]", "J_i + B dphi: what their sum is divided by", source="(3.57)")
SQUARE = Quantity("step_omega2[rad^2/s^2]", "square of the speed at the node", symbol=r"\omega^2", source="(3.57)")
FACTOR = Quantity("step_factor[-]", "what a deviation of omega^2 is multiplied by on the step")
TURN = Quantity("omega_turn_{turn}[rad/s]", "speed by the recurrence, turn {turn} from the rated one", source="(3.58)")
IDLE = Quantity("omega_idle_textbook[rad/s]", "speed by the recurrence without technological loads", source="(3.57)")
IDLE_TURN = Quantity(
    "omega_idle_turn_{turn}[rad/s]",
    "the same without technological loads, in turn {turn} from the rated speed",
    source="(3.58)",
)


@record
class Recurrence:
    """The numbers of the recurrence that are the same at every step, and what comes of it."""

    step: float = quantity("dphi[rad]", "step of the positions", symbol=r"\Delta\varphi")
    damping: float = quantity("B_dphi[kg*m^2]", "B of the parabola times the step", source="(3.57)")
    driving: float = quantity("A_dphi_twice[J]", "twice A of the parabola times the step", source="(3.57)")
    start: float = quantity("omega_0[rad/s]", "speed at position 0 that comes back after a cycle", source="(3.58)")
    multiplier: float = quantity("multiplier", "factor of a deviation of omega_0^2 after a cycle")
    delta: float = quantity("delta_textbook", "coefficient of speed fluctuation over the nodes")


class Run:
    """The recurrence over one cycle: its nodes, the periodic speeds, the turns from the rated speed."""

    def __init__(self, nodes: Nodes, regime: NodalRegime, history: tuple[Turn, ...]) -> None:
        self.nodes, self.regime, self.history = nodes, regime, history

    @cached_property
    def squares(self) -> Values:
        """omega^2 (n + 1,)."""
        return self.regime.omega**2

    @property
    def kept(self) -> Values:
        """(J_(i-1) - B dphi) omega_(i-1)^2 of every node (n + 1,), NaN for the first."""
        nodes = self.nodes
        return np.append(np.nan, (nodes.inertia[:-1] - nodes.b * nodes.step) * self.squares[:-1])

    @property
    def gained(self) -> Values:
        """(M_(i-1) + M_i + 2 A) dphi of every node (n + 1,), NaN for the first."""
        nodes = self.nodes
        return np.append(np.nan, (nodes.moment[:-1] + nodes.moment[1:] + 2 * nodes.a) * nodes.step)

    @property
    def divisor(self) -> Values:
        """J_i + B dphi of every node (n + 1,), NaN for the first."""
        return np.append(np.nan, self.nodes.inertia[1:] + self.nodes.b * self.nodes.step)

    def turn(self, k: int) -> Values:
        """Speeds (n + 1,) of turn k of the iteration, from 0."""
        return march(self.nodes, self.history[k].first).omega

    def told(self) -> Recurrence:
        """What is the same at every step, and what comes of it."""
        nodes = self.nodes
        double = 2 * nodes.a * nodes.step
        start, rest = float(self.regime.omega[0]), (multiplier(nodes), self.regime.delta)
        return Recurrence(nodes.step, nodes.b * nodes.step, double, start, *rest)


def run_of(motion: Motion, reduction: Reduction) -> Run | None:
    """The recurrence of a motion; None where the textbook's is not done."""
    book = motion.textbook
    if book is None:
        return None
    return Run(_nodes(motion, reduction.cycle), book.regime, book.turns)


def idle_run_of(motion: Motion, reduction: Reduction) -> Run | None:
    """The same without technological loads, from the same rated speed; None where there is no such run."""
    if motion.textbook is None or reduction.idle is None:
        return None
    nodes, history = _nodes(motion, reduction.idle), motion.textbook.turns
    try:
        return Run(nodes, periodic(nodes), turns(nodes, history[0].first) if history else ())
    except (NoSolutionError, AccuracyError):
        return None


def _nodes(motion: Motion, cycle: Cycle) -> Nodes:
    assert motion.textbook is not None
    return on_nodes(cycle, motion.inertia.total, motion.textbook.a, motion.textbook.b, len(motion.phi) - 1)


def stepwise_columns(motion: Motion, reduction: Reduction) -> Iterator[Column]:
    """The terms at every position, then the turns of the iteration, then the idle run; none without the recurrence."""
    run = run_of(motion, reduction)
    if run is None:
        return
    yield column(MOMENT, lambda: run.nodes.moment)
    yield column(INERTIA, lambda: run.nodes.inertia)
    yield column(KEPT, lambda: run.kept)
    yield column(GAINED, lambda: run.gained)
    yield column(DIVISOR, lambda: run.divisor)
    yield column(SQUARE, lambda: run.squares)
    yield column(FACTOR, lambda: np.append(np.nan, factors(run.nodes)))
    yield from _turn_columns(TURN, run)
    idle = idle_run_of(motion, reduction)
    if idle is not None:
        yield column(IDLE, lambda: idle.regime.omega)
        yield from _turn_columns(IDLE_TURN, idle)


def _turn_columns(told: Quantity, run: Run) -> Iterator[Column]:
    for k in range(len(run.history)):
        yield column(told.of(turn=k + 1), partial(run.turn, k))
