"""Equations of motion of the reduced chain, and the layout of the state.

With n groups of masses on the crank's shaft (textbook (3.61), (3.62) for n = 1)

    J_i dw_i/dt = T_(i-1) - T_i,   T_i = c_i phi_i + k_i (w_i - w_(i+1)),   dphi_i/dt = w_i - w_(i+1)
    (J_n + J(theta)) dw_n/dt = T_(n-1) + M(theta, w_n) - w_n^2/2 dJ/dtheta
    tau_e dM_d/dt = M_static(w_1) - M_d

where T_0 is the driving moment M_d; brakes take their moment from any of them. The state holds the crank angle, the
twists of the shafts (angles of the masses would lose their difference to rounding), the speeds, with lag M_d, and
last the works of motor, load, brake and dampers: their sum is the change of energy, which checks the solution.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from tmmcalc.machine.transient.model import Reduced
from tmmcalc.machine.transient.reading import Stretch, reader
from tmmcalc.machine.transient.steps import Derivative, State

Curve = Callable[[float], float]
WORKS = 4


class Layout(NamedTuple):
    """Where the parts of the state stand: theta, n - 1 twists, n speeds, the motor moment with lag, four works."""

    groups: int
    lag: bool

    @property
    def speed(self) -> int:
        """Index of the speed of the first group, that of the motor."""
        return self.groups

    @property
    def crank(self) -> int:
        """Index of the speed of the crank."""
        return 2 * self.groups - 1

    @property
    def works(self) -> int:
        """Index of the first work, and number of unknowns before it."""
        return 2 * self.groups + self.lag

    @property
    def size(self) -> int:
        """Number of all components."""
        return self.works + WORKS


class System(NamedTuple):
    """The reduced drive with its motor and brake, all on the crank's shaft."""

    chain: Reduced
    moment: Curve | None  # static moment of the motor at a speed of its group [N*m]; None: no motor
    slope: Curve | None  # and its derivative [N*m*s]
    time_constant: float  # [s]
    brake: int  # the group with the brake
    grip: float  # its constant moment [N*m]
    drag: float  # its viscous part [N*m*s/rad]

    @property
    def layout(self) -> Layout:
        """Layout of the state."""
        return Layout(len(self.chain.inertia), self.time_constant > 0 and self.moment is not None)


class Regime(NamedTuple):
    """What is in force while no event changes it."""

    motor: bool  # the motor is on
    braked: bool  # the brake acts
    slip: float  # direction of motion that the constant braking moment opposes: 1, -1; 0 at rest
    held: frozenset[int]  # groups at rest that are held there
    factor: float  # load factor
    stretch: int  # in which the crank turns
    base: float  # whole turns to take off the crank angle [rad]


def derivative(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    """The right-hand side f(t, y) of one regime, on plain floats."""
    build = _one_mass if len(system.chain.inertia) == 1 else _several
    return build(system, regime, stretch)


def _one_mass(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    read = reader(stretch, regime.base)
    constant = system.chain.inertia[0]
    curve = system.moment if regime.motor else None
    lag, tau = system.layout.lag, system.time_constant
    grip, drag = (regime.slip * system.grip, system.drag) if regime.braked else (0.0, 0.0)
    held = bool(regime.held)

    def f(_: float, y: State) -> State:
        w = y[1]
        inertia, slope, load = read(y[0], w)
        drive = 0.0 if curve is None else y[2] if lag else curve(w)
        brake = grip + drag * w
        a = 0.0 if held else (drive + load - brake - 0.5 * slope * w * w) / (constant + inertia)
        if lag:
            rise = 0.0 if curve is None else (curve(w) - drive) / tau
            return w, a, rise, drive * w, load * w, -brake * w, 0.0
        return w, a, drive * w, load * w, -brake * w, 0.0

    return f


def _several(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    read = reader(stretch, regime.base)
    chain, held = system.chain, regime.held
    curve = system.moment if regime.motor else None
    lag, tau = system.layout.lag, system.time_constant
    n = len(chain.inertia)
    stiffness, damping, own = chain.stiffness, chain.damping, chain.inertia
    grip, drag = (regime.slip * system.grip, system.drag) if regime.braked else (0.0, 0.0)
    braked, shafts = system.brake, range(n - 1)

    def f(_: float, y: State) -> State:
        w = y[n : 2 * n]
        inertia, slope, load = read(y[0], w[-1])
        drive = 0.0 if curve is None else y[2 * n] if lag else curve(w[0])
        brake = grip + drag * w[braked]
        slides = [w[i] - w[i + 1] for i in shafts]
        drags = [k * s for k, s in zip(damping, slides, strict=True)]
        twists = [c * y[i + 1] + d for i, (c, d) in enumerate(zip(stiffness, drags, strict=True))]
        net = [a - b for a, b in zip([drive, *twists], [*twists, 0.0], strict=True)]
        net[braked] -= brake
        net[-1] += load - 0.5 * slope * w[-1] * w[-1]
        rates = [a / b for a, b in zip(net, own, strict=False)]
        rates[-1] = net[-1] / (own[-1] + inertia)
        for i in held:
            rates[i] = 0.0
        if lag:
            rates.append(0.0 if curve is None else (curve(w[0]) - drive) / tau)
        lost = -sum(d * s for d, s in zip(drags, slides, strict=True))
        return [w[-1], *slides, *rates, drive * w[0], load * w[-1], -brake * w[braked], lost]

    return f


def surplus(system: System, regime: Regime, stretch: Stretch, group: int) -> Callable[[State], float]:
    """The moment [N*m] on a ``group`` at rest from everything but what holds it."""
    free = derivative(system, regime._replace(slip=0.0, held=frozenset()), stretch)
    read, at = reader(stretch, regime.base), system.layout.speed + group
    own, last = system.chain.inertia[group], group == len(system.chain.inertia) - 1

    def net(y: State) -> float:
        return free(0.0, y)[at] * (own + (read(y[0], 0.0)[0] if last else 0.0))

    return net
